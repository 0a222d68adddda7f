/// The joint angles of a robot arm for a given place of its hand: 16 solutions.
///
/// Morgan and Shapiro, "Box-bisection for solving second-degree systems and the problem of
/// clustering", ACM Transactions on Mathematical Software 1987: the test system `puma`, with data
/// in place of its constants. The unknowns are cosines and sines of four angles.
///
/// `place` holds the coefficients of x1 x3, x2 x3, x1, x2, x4 and 1 in two equations, `twist` and
/// `first` those of x1, x2 and 1.
fn robot_arm(place: [[f64; 6]; 2], twist: [f64; 2], first: [f64; 3]) -> (x: [f64; 8]) {
    for k in [0, 2, 4, 6] {
        x[k].pow(2) + x[k + 1].pow(2) == 1;
    }
    let hand = [x[0] * x[2], x[1] * x[2], x[0], x[1], x[3], 1];
    dot(place[0], hand) + x[6] == 0;
    dot(place[1], hand) - x[6] == 0;
    x[5] * x[7] + dot(twist, [x[0], x[1]]) == 0;
    dot(first, [x[0], x[1], 1]) == 0;
}
