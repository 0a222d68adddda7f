//! Where a circle meets a parabola, by a solver whose template the build script found.

eliminant::include_solver!("meet");

use std::error::Error;

/// Rounding, with room for the geometry.
const TOLERANCE: f64 = 1e-12;

fn main() -> Result<(), Box<dyn Error>> {
    // The circle about (0, 3) with radius sqrt(5) and the parabola y = x^2: y^2 - 5 y + 4 = 0, thus
    // y = 1 or 4.
    let solutions = meet::solve(&[0.0, 3.0, 5.0], &[1.0, 0.0, 0.0])?;
    for expected in [[1.0, 1.0], [-1.0, 1.0], [2.0, 4.0], [-2.0, 4.0]] {
        let is_it = |point: &[f64; 2]| (point[0] - expected[0]).hypot(point[1] - expected[1]) < TOLERANCE;
        let found = solutions.iter().map(|point| [point.x, point.y]).find(is_it);
        let [x, y] = found.ok_or_else(|| format!("{expected:?} is missing in {solutions:?}"))?;
        println!("x {x:9.6}, y {y:9.6}");
    }
    Ok(())
}
