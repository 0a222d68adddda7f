/// Where a sound came from, and when: at most 2 solutions.
///
/// Three microphones hear a sound. All is in a plane; `microphones` are their positions, `arrivals`
/// the times at which they hear it, in the unit in which sound travels a unit of length. The
/// unknowns are the position (x, y) and the time of the sound, which is before all arrivals.
fn sound_source(microphones: [[f64; 2]; 3], arrivals: [f64; 3]) -> (x, y, time) {
    for k in 0..3 {
        let [dx, dy] = [x - microphones[k][0], y - microphones[k][1]];
        dx * dx + dy * dy == (arrivals[k] - time).pow(2);
        arrivals[k] > time;
    }
    let distances = [arrivals[0] - time, arrivals[1] - time, arrivals[2] - time];
    Source { position: [x, y], distances: distances }
}
