/// The poses of a planar platform on three legs of given lengths: 6 solutions.
///
/// Merlet, "Direct kinematics of planar parallel manipulators", ICRA 1996.
///
/// `base` are the feet of the legs, `joint` where they meet the platform, in its own frame.
fn planar_platform(base: [[f64; 2]; 3], joint: [[f64; 2]; 3], length: [f64; 3]) -> (x, y, s, c) {
    s.pow(2) + c.pow(2) == 1;
    let turn = [[c, -s], [s, c]];
    for i in 0..3 {
        let leg = [x, y] + turn * joint[i] - base[i];
        dot(leg, leg) == length[i].pow(2);
    }
}
