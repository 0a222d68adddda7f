//! Measures how exactly every cross-section solver recovers the circle of noise-free random scenes,
//! and how long it takes.
//!
//! ```text
//! cargo run --release -p eliminant-cylinders --example section_accuracy -- [SCENES]
//! ```

#[path = "cross_section.rs"]
mod cross_section;
#[path = "../make_scene/random.rs"]
mod random;

use std::hint::black_box;
use std::time::Instant;

use cross_section::{cross_section, relative_error, three_of_three};
use eliminant_cylinders::{
    Circle, ClosedForm, LeastSquares, LinearConic, Minimal, Navab, SectionLine, SectionSolver, minimal_circles,
    tangent_circles,
};
use random::Random;

/// Views of the scenes for methods that take any number of lines, each with two lines.
const VIEWS: usize = 10;

fn main() {
    let scenes = std::env::args().nth(1).and_then(|count| count.parse().ok()).unwrap_or(100_000);
    println!("relative error of the nearest circle returned, {scenes} noise-free scenes");
    println!(
        "{:15}{:>6}{:>10}{:>10}{:>10}{:>10}{:>10}{:>8}{:>11}",
        "method", "lines", "50 %", "90 %", "99 %", "99.9 %", "worst", "> 1e-6", "us/solve"
    );
    let mut random = Random::new(1);
    let three: Vec<_> = (0..scenes).map(|_| three_of_three(&mut random)).collect();
    let many: Vec<_> = (0..scenes).map(|_| cross_section(VIEWS, 0.0, &mut random)).collect();
    for solver in [&ClosedForm as &dyn SectionSolver, &Minimal] {
        row(solver, &three);
    }
    for solver in [&LeastSquares as &dyn SectionSolver, &LinearConic, &Navab] {
        row(solver, &many);
    }
    let lines: Vec<_> = three.iter().map(|(_, lines)| [0, 1, 2].map(|index: usize| lines[index].line)).collect();
    println!("\nthe circles alone, without the trait");
    for (name, solve) in [("tangent_circles", tangent_circles as fn(&_) -> _), ("minimal_circles", minimal_circles)] {
        let start = Instant::now();
        for lines in &lines {
            let _ = black_box(solve(black_box(lines)));
        }
        println!("{name}  {:9.3} us", start.elapsed().as_secs_f64() * 1e6 / scenes as f64);
    }
}

/// One line of the table.
fn row(solver: &dyn SectionSolver, scenes: &[(Circle, Vec<SectionLine>)]) {
    let start = Instant::now();
    let found: Vec<_> = scenes.iter().map(|(_, lines)| solver.solve(lines)).collect();
    let time = start.elapsed().as_secs_f64() * 1e6 / scenes.len() as f64;
    let mut errors: Vec<f64> = Vec::with_capacity(scenes.len());
    for (found, (truth, _)) in found.iter().zip(scenes) {
        let circles = found.iter().flatten().filter_map(|section| section.circle());
        errors.push(circles.map(|circle| relative_error(&circle, truth)).fold(f64::INFINITY, f64::min));
    }
    errors.sort_by(f64::total_cmp);
    let missed = errors.iter().filter(|&&error| error > 1e-6).count();
    let last = errors.len().saturating_sub(1);
    let quantiles = [0.5, 0.9, 0.99, 0.999, 1.0].map(|part| errors.get((last as f64 * part) as usize));
    print!("{:15}{:6}", solver.name(), scenes.first().map_or(0, |(_, lines)| lines.len()));
    for error in quantiles.into_iter().flatten() {
        print!("{error:10.1e}");
    }
    println!("{missed:8}{time:11.2}");
}
