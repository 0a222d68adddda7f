/// The voltages of an electric grid of three buses, in power flow: 6 solutions.
///
/// Tavora and Smith, "Equilibrium analysis of power systems", IEEE Transactions on Power Apparatus
/// and Systems, 1972: lossless grids of n buses have at most C(2n - 2, n - 1) solutions. Bus 0 is
/// the slack bus with voltage 1; buses 1 and 2 have a given magnitude and a given power.
///
/// `susceptance` are those of the lines 0-1, 0-2 and 1-2, `power` the injected powers and `square`
/// the squared magnitudes of the voltages e + i f.
fn power_flow_3_buses(susceptance: [f64; 3], power: [f64; 2], square: [f64; 2]) -> (e1, f1, e2, f2) {
    e1.pow(2) + f1.pow(2) == square[0];
    e2.pow(2) + f2.pow(2) == square[1];
    let exchanged = susceptance[2] * (f1 * e2 - e1 * f2);
    susceptance[0] * f1 + exchanged == power[0];
    susceptance[1] * f2 - exchanged == power[1];
}
