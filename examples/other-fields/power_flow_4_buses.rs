/// The voltages of an electric grid of four buses, in power flow: 20 solutions.
///
/// Li, Sauer and Yorke, "Numerical solution of a class of deficient polynomial systems", SIAM
/// Journal on Numerical Analysis, 1987: C(2n - 2, n - 1) for n buses. Bus 0 is the slack bus with
/// voltage 1; the others have given power.
///
/// `admittances` is the matrix of the currents that voltages cause, `powers` are those injected at
/// the buses 1 to 3, active power and reactive power as real and imaginary part.
fn power_flow_4_buses(admittances: [[Complex<f64>; 4]; 4], powers: [Complex<f64>; 3]) -> (voltages: [Complex<f64>; 3]) {
    let all = concat(complex(1, 0), voltages);
    for bus in 1..4 {
        let current = dot(admittances[bus], all);
        all[bus] * conj(current) == powers[bus - 1];
    }
}
