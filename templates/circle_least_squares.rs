/// Circle tangent to n lines in the least-squares sense: the stationary points of the constrained
/// dual conic, 9 solutions.
///
/// Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation", eq. (23)-(26): the
/// Lagrangian as printed.
///
/// `gram` is the mean over all lines l = (a, b, c) of r r^T with r = (a^2, ab, ac, b^2, bc, c^2).
/// The dual conic is [d1 d2 d3; d2 d4 d5; d3 d5 -1]: a circle with centre (-d3, -d5) and squared
/// radius d1 + d3^2 = d4 + d5^2, which is negative at some stationary points. The cost is the mean
/// of (l^T D l)^2.
fn circle_least_squares(#[mean(of_line)] #[symmetric] gram: [[f64; 6]; 6]) -> (d1, d2, d3, d4, d5, lambda1, lambda2) {
    let d6 = -1;
    let d = [d1, 2 * d2, 2 * d3, d4, 2 * d5, d6];
    let cost = dot(d, gram * d);
    let lagrangian = cost
        + lambda1 * (d3 * d5 - d2 * d6)
        + lambda2 * (d5 * d5 - d3 * d3 + d1 * d6 - d4 * d6);
    gradient(lagrangian) == 0;
    Circle { centre: [-d3, -d5], squared_radius: d1 + d3 * d3, cost: cost }
}

/// What a line a x + b y + c = 0 gives.
fn of_line(line: [f64; 3]) -> [[f64; 6]; 6] {
    let [a, b, c] = line;
    let r = [a * a, a * b, a * c, b * b, b * c, c * c];
    [r[0] * r, r[1] * r, r[2] * r, r[3] * r, r[4] * r, r[5] * r]
}

/// Ten tangents of a circle.
#[scene]
fn scene(#[unit] normals: [[f64; 2]; 10], place: [f64; 2], size: f64) -> (Data, Circle) {
    let radius = 3 / 2 + size;
    let mut gram = [[0; 6]; 6];
    for normal in normals {
        let line = concat(normal, -dot(normal, place) - radius);
        gram += of_line(line) / 10;
    }
    (Data { gram }, Circle { centre: place, squared_radius: radius * radius, cost: 0 })
}
