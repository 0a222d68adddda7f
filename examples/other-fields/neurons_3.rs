/// The equilibria of a network of three neurons with inhibition: 21 solutions.
///
/// Noonburg, "A neural network modeled by an adaptive Lotka-Volterra system", SIAM Journal on
/// Applied Mathematics 1989; with one decay of 1.1 it is the test system `noon3`.
///
/// `decay` are the rates at which the neurons forget.
fn neurons_3(decay: [f64; 3]) -> (x: [f64; 3]) {
    for i in 0..3 {
        let others = dot(x, x) - x[i].pow(2);
        x[i] * others - decay[i] * x[i] + 1 == 0;
    }
}
