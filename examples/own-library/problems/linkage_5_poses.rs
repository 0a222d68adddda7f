/// Synthesis of a planar linkage: a bar from a joint of the frame to a joint of a body that passes
/// through five poses, so that the distance of the joints is the same in all of them. There are 4
/// such bars, not all of them real.
///
/// Burmester, "Lehrbuch der Kinematik", 1888; complex numbers as in Sandor and Erdman, "Advanced
/// Mechanism Design", 1984.
///
/// In pose k a point z of the body is at `turns[k]` z + `shifts[k]`; in the first pose at z.
fn linkage_5_poses(
    #[unit] turns: [Complex<f64>; 4],
    shifts: [Complex<f64>; 4],
) -> (on_body: Complex<f64>, on_frame: Complex<f64>) {
    let first = on_body - on_frame;
    for k in 0..4 {
        let bar = turns[k] * on_body + shifts[k] - on_frame;
        bar * conj(bar) == first * conj(first);
    }
    Bar { length: sqrt(first * conj(first)), direction: first / sqrt(first * conj(first)) }
}
