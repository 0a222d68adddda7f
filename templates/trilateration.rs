/// A point at given distances from three known points: 2 solutions, mirror images in the plane of
/// the three.
///
/// Thomas & Ros, "Revisiting trilateration for robot localization", IEEE Transactions on Robotics
/// 21(1), 2005.
///
/// `centres` holds the known points, one a row; `distances` the distances from them, in the same
/// unit.
fn trilateration(centres: [[f64; 3]; 3], distances: [f64; 3]) -> (x, y, z) {
    for i in 0..3 {
        let sight = centres[i] - [x, y, z];
        dot(sight, sight) - distances[i].pow(2) == 0;
    }
}

/// A receiver among three senders.
#[scene]
fn scene(centres: [[f64; 3]; 3], place: [f64; 3]) -> (Data, Solution) {
    let [x, y, z] = place;
    let distances = [norm(centres[0] - place), norm(centres[1] - place), norm(centres[2] - place)];
    (Data { centres, distances }, Solution { x, y, z })
}
