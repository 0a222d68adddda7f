/// The equilibria of three species that compete (Lotka and Volterra): 8 solutions, of which one has
/// no species left.
///
/// Takeuchi, "Global Dynamical Properties of Lotka-Volterra Systems", World Scientific 1996: each
/// species is absent or grows at rate 0.
///
/// `growth` are the rates without competition, `competition[i][j]` what species j costs species i.
fn species_3(growth: [f64; 3], competition: [[f64; 3]; 3]) -> (x: [f64; 3]) {
    let pressure = competition * x;
    for i in 0..3 {
        x[i] * (growth[i] - pressure[i]) == 0;
    }
}
