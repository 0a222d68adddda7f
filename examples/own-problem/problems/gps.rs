/// Position and clock offset of a receiver from the signals of four satellites: 2 solutions.
///
/// Bancroft, "An algebraic solution of the GPS equations", IEEE Transactions on Aerospace and
/// Electronic Systems 21(1), 1985.
///
/// `satellites` holds the positions, one a row; `pseudoranges` the distances to them as measured,
/// all too long by the same `offset`, the receiver's clock error times the speed of light.
/// Everything is in one unit of length.
fn gps(satellites: [[f64; 3]; 4], pseudoranges: [f64; 4]) -> (x, y, z, offset) {
    let position = [x, y, z];
    let first = sphere(position, offset, satellites[0], pseudoranges[0]);
    first == 0;
    // The squares cancel in the differences. These are linear, so the generator eliminates three
    // unknowns by itself.
    for i in 1..4 {
        sphere(position, offset, satellites[i], pseudoranges[i]) - first == 0;
    }
}

/// Zero where the satellite is as far from the position as the corrected pseudorange says.
fn sphere(position: [f64; 3], offset: f64, satellite: [f64; 3], pseudorange: f64) -> f64 {
    let sight = satellite - position;
    dot(sight, sight) - (pseudorange - offset).pow(2)
}
