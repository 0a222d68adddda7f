//! A problem whose solutions no unknown tells apart.

/// Replicator dynamics: any of three shares is 0, or none is, so that solutions share the values of
/// every unknown.
pub(crate) const SHARES: &str = "/// Rest points of three shares.
fn shares(a: [[f64; 3]; 3]) -> (x, y, z) {
    let f = a * [x, y, z];
    let mean = dot([x, y, z], f);
    x * (f[0] - mean) == 0;
    y * (f[1] - mean) == 0;
    x + y + z == 1;
}
";
