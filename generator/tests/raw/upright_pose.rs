/// A camera whose vertical is known, from two points, stated with the nine entries of a rotation:
/// 2 solutions.
fn upright_pose(
    rays: [[f64; 3]; 2],
    points: [[f64; 3]; 2],
    #[unit] up: [f64; 3],
) -> (r: [[f64; 3]; 3], t: [f64; 3]) {
    r * r.t() == identity(3);
    det(r) == 1;
    r * up == [0, 0, 1];
    for k in 0..2 {
        cross(rays[k], r * points[k] + t) == 0;
    }
}
