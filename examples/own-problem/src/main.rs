//! Where am I? A receiver whose position is known, four satellites, and the solver that the build
//! script made.

eliminant::include_solver!("gps");

use std::process::ExitCode;

/// Kilometres; Earth-fixed axes.
const SATELLITES: [[f64; 3]; 4] = [
    [15_600.0, 7_540.0, 20_140.0],
    [18_760.0, 2_750.0, 18_610.0],
    [17_610.0, 14_630.0, 13_480.0],
    [19_170.0, -610.0, 18_390.0],
];
/// A place on the ground, 6367 km from the centre of the Earth.
const RECEIVER: [f64; 3] = [3_498.0, 820.0, 5_256.0];
/// A clock that is 100 microseconds fast.
const OFFSET: f64 = 299_792.458 * 1e-4;
/// The pseudoranges below are rounded to some 1e-12 km; geometry makes that up to a hundred times
/// larger.
const TOLERANCE: f64 = 1e-9;

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

fn main() -> ExitCode {
    let pseudoranges = SATELLITES.map(|satellite| distance(satellite, RECEIVER) + OFFSET);
    let solutions = match gps::solve(&SATELLITES, &pseudoranges) {
        Ok(solutions) => solutions,
        Err(error) => {
            eprintln!("error: {error}");
            return ExitCode::FAILURE;
        }
    };
    println!(
        "{:>12} {:>12} {:>12} {:>12} {:>12} {:>12}",
        "x/km", "y/km", "z/km", "offset/km", "altitude/km", "error/km"
    );
    let mut is_found = false;
    for gps::Solution { x, y, z, offset } in solutions {
        let position = [x, y, z];
        let error = distance(position, RECEIVER).max((offset - OFFSET).abs());
        let altitude = distance(position, [0.0; 3]) - distance(RECEIVER, [0.0; 3]);
        println!("{x:12.3} {y:12.3} {z:12.3} {offset:12.6} {altitude:12.3} {error:12.1e}");
        is_found |= error < TOLERANCE;
    }
    if !is_found {
        eprintln!("error: the receiver is at {RECEIVER:?}, which is none of these");
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}
