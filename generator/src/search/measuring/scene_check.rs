//! Whether what a scene states solves the equations, which needs no template.

use super::results::coordinates;
use super::seed_of;
use crate::algebra::Random;
use crate::expression::SymbolicPolynomial;
use crate::expression::arithmetic::Float64;
use crate::problem::Problem;
use crate::problem::scene::{DrawnScene, Scene};

/// A relative residual at most this is that of a solution: data of a scene are rounded, and may
/// enlarge the rounding.
const SOLVED: f64 = 1e-9;

/// What a number of scenes show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SceneCheck {
    /// The scenes that could be drawn.
    pub drawn: usize,
    /// Those whose solution solves all equations, with what must be positive positive; `None` if
    /// the scene states no solution.
    pub solved: Option<usize>,
}

impl SceneCheck {
    /// Draws so many scenes.
    pub fn of(problem: &Problem, scene: &Scene, count: usize, seed: u64) -> Self {
        let draw = |k: usize| scene.draw(&mut Random::new(seed_of(seed, k)));
        let drawn: Vec<DrawnScene> = (0..count).filter_map(draw).collect();
        let solved = scene.states_solution().then(|| drawn.iter().filter(|scene| is_solved(problem, scene)).count());
        Self { drawn: drawn.len(), solved }
    }
}

/// Whether the solution that a scene states solves the problem for its data.
fn is_solved(problem: &Problem, scene: &DrawnScene) -> bool {
    let Some(solution) = &scene.solution else { return false };
    let Some(values) = problem.graph.evaluate(Float64, &scene.data) else { return false };
    let x = coordinates(&problem.fields, solution);
    // The value of a polynomial, and the sum of the moduli of its terms.
    let at = |polynomial: &SymbolicPolynomial| {
        let terms = polynomial.terms().iter().map(|(monomial, coefficient)| {
            let powers = monomial.exponents().iter().zip(&x).map(|(&exponent, x)| x.powi(exponent.into()));
            values[coefficient.index()] * powers.product::<f64>()
        });
        terms.fold((0.0, 0.0), |(sum, size), term| (sum + term, size + term.abs()))
    };
    let vanishes = |polynomial: &SymbolicPolynomial| {
        let (sum, size) = at(polynomial);
        sum.abs() <= SOLVED * size
    };
    problem.polynomials().all(vanishes)
        && !problem.nonzero.iter().any(|factor| vanishes(&factor.polynomial))
        && problem.positive.iter().all(|statement| at(&statement.polynomial).0 > 0.0)
}
