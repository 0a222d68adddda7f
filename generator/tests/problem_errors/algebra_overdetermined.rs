/// Three lines through a point would need data that satisfy a condition.
fn algebra_overdetermined(lines: [[f64; 3]; 3]) -> (x, y) {
    for line in lines {
        dot(line, [x, y, 1]) == 0;
    }
}
