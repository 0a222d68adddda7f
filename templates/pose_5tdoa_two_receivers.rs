/// Pose of two receivers close to each other from the time differences with which they hear five
/// senders: 24 solutions.
///
/// Burgess, Kuang, Åström, "Pose estimation from minimal dual-receiver configurations", ICPR 2012.
/// Published as `tdoa_pose_5pt`.
///
/// The receivers are at C, one from the other in the direction n = (u, v, w). Divided by their
/// distance, the difference of the ranges of a sender U is the cosine c of an angle: (n U - t)^2 =
/// c^2 |n|^2 |U - C|^2 with t = n C. Five such equations are linear in |n|^2 |C|^2 and |n|^2 C, and
/// otherwise have the terms u u, u v, u w, v v, v w, w w, t u, t v, t w and t t. Solved for the
/// former, they have the coefficients `linear`; a fifth linear combination, `quadric`, has none of
/// the former. C follows from n and t, which are `plane`: n X = t passes through the receivers,
/// across their line.
fn pose_5tdoa_two_receivers(quadric: [f64; 10], linear: [[f64; 10]; 4]) -> (#[projective] plane: [f64; 4]) {
    let [u, v, w, t] = plane;
    let n = [u, v, w];
    let terms = [u * u, u * v, u * w, v * v, v * w, w * w, t * u, t * v, t * w, t * t];
    let right = linear * terms;
    let centre = [right[1], right[2], right[3]];
    dot(quadric, terms) == 0;
    t * dot(n, n) - dot(n, centre) == 0;
    dot(n, n) * right[0] - dot(centre, centre) == 0;
}
