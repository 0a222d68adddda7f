/// Pose of two receivers close to each other from the time differences with which they hear five
/// senders: 24 solutions.
///
/// Burgess, Kuang, Åström, "Pose estimation from minimal dual-receiver configurations", ICPR 2012.
/// Published as `tdoa_pose_5pt`.
///
/// The receivers are at C, one from the other in the direction n = (u, v, 1). Divided by their
/// distance, the difference of the ranges of a sender U is the cosine c of an angle: (n U - t)^2 =
/// c^2 |n|^2 |U - C|^2 with t = n C. Five such equations are linear in |n|^2 |C|^2 and |n|^2 C, and
/// otherwise have the terms u u, u v, u, v v, v, 1, t u, t v, t and t t. Solved for the former,
/// they have the coefficients `linear`; a fifth linear combination, `quadric`, has none of the
/// former. C follows from u, v and t.
fn pose_5tdoa_two_receivers(quadric: [f64; 10], linear: [[f64; 10]; 4]) -> (u, v, t) {
    let n = [u, v, 1];
    let terms = [u * u, u * v, u, v * v, v, 1, t * u, t * v, t, t * t];
    let right = linear * terms;
    let centre = [right[1], right[2], right[3]];
    dot(quadric, terms) == 0;
    t * dot(n, n) - dot(n, centre) == 0;
    dot(n, n) * right[0] - dot(centre, centre) == 0;
}
