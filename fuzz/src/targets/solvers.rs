//! Solvers on arbitrary numbers.

use std::time::Duration;

use eliminant::emitted::MAX_RESIDUAL;
use eliminant::{Solutions, SolveError};
use eliminant_solvers::{circle_minimal, pose_35pt_focal, relpose_5pt, trilateration, two_conics};

use crate::mutate::Kind;
use crate::outcome::Outcome;
use crate::target::Target;

pub(super) fn targets() -> Vec<Target> {
    let of = |name, what, longest: usize, run| Target {
        name,
        what,
        kind: Kind::Numbers,
        longest: 8 * longest,
        bound: Duration::from_secs(1),
        run,
    };
    vec![
        of("circle_minimal", "`solve` and `solve_complex` of circle_minimal", 18, circle_minimal),
        of("pose_35pt_focal", "`solve` and `solve_complex` of pose_35pt_focal", 19, pose_35pt_focal),
        of("relpose_5pt", "`solve` and `solve_complex` of relpose_5pt", 36, relpose_5pt),
        of("trilateration", "`solve` and `solve_complex` of trilateration", 12, trilateration),
        of("two_conics", "`solve` and `solve_complex` of two_conics", 12, two_conics),
    ]
}

/// The next numbers of an input; what is missing is 0.
fn numbers<const N: usize>(input: &mut &[u8]) -> [f64; N] {
    std::array::from_fn(|_| {
        let (number, rest) = input.split_at(input.len().min(8));
        *input = rest;
        f64::from_le_bytes(number.try_into().unwrap_or_default())
    })
}

/// The next rows of numbers.
fn rows<const N: usize, const M: usize>(input: &mut &[u8]) -> [[f64; N]; M] {
    std::array::from_fn(|_| numbers(input))
}

/// What must hold of the result of a solver: the numbers of each solution, and its residual.
fn check<S, const N: usize>(
    result: Result<Solutions<S, N>, SolveError>,
    outcome: &mut Outcome,
    describe: impl Fn(&S) -> (bool, Result<f64, SolveError>, String),
) {
    match result {
        Ok(solutions) => {
            outcome.accepted |= !solutions.is_empty();
            outcome.see(["none", "a", "b", "c", "d", "e", "f", "g", "h", "i", "j"][solutions.len().min(10)]);
            for solution in solutions.iter() {
                let (is_finite, residual, text) = describe(solution);
                outcome.demand(is_finite, || format!("not finite: {text}"));
                let is_small = residual.as_ref().is_ok_and(|&residual| residual <= MAX_RESIDUAL);
                outcome.demand(is_small, || format!("residual: {residual:?} of {text}"));
                let digits = residual.map_or(0, |residual| -residual.max(1e-20).log10() as usize);
                outcome.see(&format!("residual {}", "|".repeat(digits / 2)));
            }
        }
        Err(error) => outcome.see(&error.to_string()),
    }
}

/// Both ways to solve.
macro_rules! solve {
    ($problem:ident, $input:ident, $($data:ident),+) => {{
        let mut outcome = Outcome::default();
        let data_are_finite = $input.chunks(8).all(|bytes| {
            f64::from_le_bytes(bytes.try_into().unwrap_or_default()).is_finite()
        });
        let real = $problem::solve($(&$data),+);
        let refused = matches!(real, Err(SolveError::NonFiniteInput));
        outcome.demand(!(refused && data_are_finite), || "finite data are refused as not finite".into());
        check(real, &mut outcome, |solution| {
            let is_finite = solution.to_array().iter().all(|x| x.is_finite());
            (is_finite, $problem::relative_residual($(&$data),+, solution), format!("{solution:?}"))
        });
        outcome.see("complex");
        let mut complex = Outcome::default();
        check($problem::solve_complex($(&$data),+), &mut complex, |solution| {
            let is_finite = solution.to_array().iter().all(|x| x.re.is_finite() && x.im.is_finite());
            (is_finite, $problem::relative_residual($(&$data),+, solution), format!("{solution:?}"))
        });
        outcome.kinds.extend(complex.kinds.iter().map(|kind| kind.rotate_left(1)));
        outcome.accepted |= complex.accepted;
        outcome.fault = outcome.fault.or(complex.fault);
        outcome
    }};
}

fn circle_minimal(input: &[u8]) -> Outcome {
    let mut rest = input;
    let [alpha, beta, gamma] = rows::<6, 3>(&mut rest);
    solve!(circle_minimal, input, alpha, beta, gamma)
}

fn pose_35pt_focal(input: &[u8]) -> Outcome {
    let mut rest = input;
    let points = rows::<3, 4>(&mut rest);
    let (horizontal, vertical) = (numbers::<4>(&mut rest), numbers::<3>(&mut rest));
    solve!(pose_35pt_focal, input, points, horizontal, vertical)
}

fn relpose_5pt(input: &[u8]) -> Outcome {
    let mut rest = input;
    let basis: [[[f64; 3]; 3]; 4] = std::array::from_fn(|_| rows(&mut rest));
    solve!(relpose_5pt, input, basis)
}

fn trilateration(input: &[u8]) -> Outcome {
    let mut rest = input;
    let (centres, distances) = (rows::<3, 3>(&mut rest), numbers::<3>(&mut rest));
    solve!(trilateration, input, centres, distances)
}

fn two_conics(input: &[u8]) -> Outcome {
    let mut rest = input;
    let [p, q] = rows::<6, 2>(&mut rest);
    solve!(two_conics, input, p, q)
}
