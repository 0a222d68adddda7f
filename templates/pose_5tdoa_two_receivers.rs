/// Pose of two receivers close to each other from the time differences with which they hear five
/// senders: 24 solutions.
///
/// Burgess, Kuang, Åström, "Pose estimation from minimal dual-receiver configurations", ICPR 2012.
/// Published as `tdoa_pose_5pt`.
///
/// `senders` are positions, `differences` the differences of the ranges of each to the two
/// receivers, and `distance` is that of the receivers. They are at C, one from the other in the
/// direction n = (u, v, w). Divided by `distance`, the difference of the ranges of a sender U is
/// the cosine c of an angle: (n U - t)^2 = c^2 |n|^2 |U - C|^2 with t = n C. Five such equations
/// are linear in |n|^2 |C|^2 and |n|^2 C, and otherwise have the terms u u, u v, u w, v v, v w, w
/// w, t u, t v, t w and t t. They are solved for the former, and a fifth linear combination has
/// none of them. C follows from n and t, which are `plane`: n X = t passes through the receivers,
/// across their line. t is in units of the length of all positions.
fn pose_5tdoa_two_receivers(senders: [[f64; 3]; 5], differences: [f64; 5], distance: f64) -> (
    #[projective] plane: [f64; 4],
) {
    let unit = norm(senders);
    let mut leading = [[0; 4]; 5];
    let mut others = [[0; 10]; 5];
    for k in 0..5 {
        let [x, y, z] = senders[k] / unit;
        let square = (differences[k] / distance).pow(2);
        let far = square * (x * x + y * y + z * z);
        leading[k] = [square, -2 * square * x, -2 * square * y, -2 * square * z];
        others[k] = [
            x * x - far, 2 * x * y, 2 * x * z, y * y - far, 2 * y * z, z * z - far, -2 * x, -2 * y, -2 * z, 1,
        ];
    }
    // Across the columns: with it as a fifth column the solution is that of least squares, and what
    // that leaves over.
    let across = null_space(leading.t())[0];
    let mut columns = [[0; 5]; 5];
    for k in 0..5 {
        let row = leading[k];
        columns[k] = [row[0], row[1], row[2], row[3], across[k]];
    }
    let solved = solve(columns, others);
    let [u, v, w, t] = plane;
    let n = [u, v, w];
    let right = solved * [u * u, u * v, u * w, v * v, v * w, w * w, t * u, t * v, t * w, t * t];
    let centre = [right[1], right[2], right[3]];
    right[4] == 0;
    t * dot(n, n) - dot(n, centre) == 0;
    dot(n, n) * right[0] - dot(centre, centre) == 0;
    ReceiverPair { direction: n, centre: unit * centre / dot(n, n) }
}

/// Senders and receivers in a cube. The line of the receivers is known up to scale only.
#[scene]
fn scene(senders: [[f64; 3]; 5], centre: [f64; 3], line: [f64; 3]) -> (Data, ReceiverPair) {
    let mut differences = [0; 5];
    for k in 0..5 {
        differences[k] = dot(line, normalise(senders[k] - centre));
    }
    (Data { senders, differences, distance: norm(line) }, ReceiverPair { centre })
}
