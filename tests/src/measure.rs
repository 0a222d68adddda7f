//! What an emitted solver does on random instances and on scenes, judged by the plan's equations
//! and not by the emitted code.

use std::collections::BTreeSet;

use eliminant::Complex;
use eliminant_generator::algebra::Random;
use eliminant_generator::expression::arithmetic::Float64;
use eliminant_generator::plan::interpret;
use eliminant_generator::plan::{Plan, Term};
use eliminant_generator::problem::draw::draw_inputs;
use eliminant_generator::search::measuring::interpreted::InterpretedSolver;
use rayon::prelude::*;

use crate::families::{DataSource, Family};
use crate::ground_truth::{FOUND, Maker, makers};
use crate::statistics::{distance, log10, most_frequent, worst};
use crate::{Case, Returned};

/// Points closer than this are one solution.
pub const SAME: f64 = 1e-8;

/// max over the equations of |f| / sum of the moduli of its terms; 0/0, where all terms vanish,
/// counts as 0.
pub fn residual(plan: &Plan, coefficients: &[f64], x: &[Complex<f64>]) -> f64 {
    let relative = |terms: &Vec<Term>| {
        let values = terms.iter().map(|term| {
            let powers = term.exponents.iter().zip(x).map(|(&e, x)| x.powu(u32::from(e)));
            powers.fold(Complex::from(coefficients[usize::from(term.coefficient.0)]), |product, power| product * power)
        });
        let (value, scale) = values.fold((Complex::<f64>::ZERO, 0.0), |(sum, scale), v| (sum + v, scale + v.norm()));
        if scale == 0.0 { 0.0 } else { value.norm() / scale }
    };
    worst(plan.equations.iter().map(relative))
}

/// Operations that solving all instances of one problem may take, without the polish, where they
/// are measured.
pub const WORK_OF_MEASURING: u64 = 20_000_000_000;
/// The same where they are tested: two cores run all tests in less than twenty minutes.
pub const WORK_OF_TESTING: u64 = 2_000_000_000;
/// A solve that takes more operations counts as so many: even the largest templates are solved on
/// some hundred instances.
const MOST_OF_ONE_SOLVE: u64 = 40_000_000;
/// Problems with at most so many solutions are solved on all instances whatever that takes.
const FEW_SOLUTIONS: usize = 30;

/// How many of the instances that a claim is made for are solved: all of a problem with at most 30
/// solutions, as many of the others as `work` operations allow.
pub fn affordable(plan: &Plan, wanted: u64, work: u64) -> u64 {
    match plan.solutions {
        ..=FEW_SOLUTIONS => wanted,
        _ => wanted.min(work / (plan.operations().total() as u64).clamp(1, MOST_OF_ONE_SOLVE)),
    }
}

/// Whether no two of the points are the same.
pub fn are_distinct(points: &[Vec<Complex<f64>>]) -> bool {
    points.iter().enumerate().all(|(i, x)| points[..i].iter().all(|y| distance(x, y) > SAME))
}

/// What a solver returns on many instances.
pub struct Measurement {
    /// log10 of the relative residual of every complex solution found.
    pub residuals_log10: Vec<f64>,
    /// The number of complex solutions that an instance has: of random data that of the plan; of
    /// scenes, which may be special data, the number that is found most often.
    pub solutions: usize,
    /// Instances on which another number of solutions is found, or one is returned twice, or the
    /// solver returned an error.
    pub failures: usize,
    /// Instances.
    pub instances: usize,
}

/// Solves `instances` instances of a family of data, instance k from the seed `first_seed` + k.
pub fn measure(case: &Case, plan: &Plan, family: Family, instances: u64, first_seed: u64) -> Measurement {
    let (source, has_units) = (DataSource::new(case), plan.vectors_with_units().next().is_some());
    // The number of solutions, if they are distinct, and the log10 of their residuals.
    let solve = |k| -> (Option<usize>, Vec<f64>) {
        let data = source.draw(family, first_seed + k);
        let Ok(returned) = (case.returned_complex)(&data) else { return (None, Vec::new()) };
        let Some(coefficients) = interpret::coefficients(plan, Float64, &data) else { return (None, Vec::new()) };
        // Coordinates in the chart do not keep the digits of elements that have other units.
        let residual_of = |solution: &Returned<Complex<f64>>| match has_units {
            true => solution.residual,
            false => residual(plan, &coefficients, &solution.unknowns),
        };
        let residuals = returned.iter().map(|solution| log10(residual_of(solution))).collect();
        let found: Vec<_> = returned.into_iter().map(|solution| solution.unknowns).collect();
        (are_distinct(&found).then_some(found.len()), residuals)
    };
    let (counts, residuals): (Vec<Option<usize>>, Vec<Vec<f64>>) = (0..instances).into_par_iter().map(solve).unzip();
    let solutions = match family {
        Family::Scene => most_frequent(counts.iter().flatten().copied()).unwrap_or(plan.solutions),
        _ => plan.solutions,
    };
    let failures = counts.iter().filter(|&&count| count != Some(solutions)).count();
    Measurement { residuals_log10: residuals.concat(), solutions, failures, instances: instances as usize }
}

/// How far the solutions of scenes are from the known ones.
pub struct ForwardErrors {
    /// log10 of the error of the known solution that is found worst, of every scene. A known
    /// solution that is missing has an infinite error.
    pub errors_log10: Vec<f64>,
    /// Scenes whose known solutions are all found, each to [`FOUND`].
    pub recovered: usize,
}

/// Solves `instances` scenes, scene k from the seed `first_seed` + k.
pub fn measure_forward(case: &Case, instances: u64, first_seed: u64) -> ForwardErrors {
    let makers: Vec<Maker> = makers().into_iter().filter(|maker| maker.name == case.name).collect();
    let error = |k| worst(makers.iter().map(|maker| maker.worst_error(case, &mut Random::new(first_seed + k))));
    let errors: Vec<f64> = (0..instances).into_par_iter().map(error).collect();
    let recovered = errors.iter().filter(|&&error| error <= FOUND).count();
    ForwardErrors { errors_log10: errors.into_iter().map(log10).collect(), recovered }
}

/// An instance counts as failed before the polish if the error of one of its points is larger, as
/// in the published figures.
const FAILED: f64 = 1e-3;

/// What the eigenpairs give before the polish, by the formula of the statistics that are shipped
/// with the solvers of Martyushev, Bhayani and Pajdla. With the equations C m(x) = 0, where m(x)
/// are all monomials of the system, a point has the error
///
/// e(x) = |C m(x)| / |m(x)|, both norms Euclidean,
///
/// and an instance the norm of the smallest errors, as many as there are solutions. Points with
/// larger errors belong to no solution, because |B| may exceed the number of solutions.
pub struct Unpolished {
    /// log10 of the error of every instance on which some point was read off.
    pub errors_log10: Vec<f64>,
    /// Instances on which one of these points has an error above 1e-3, or no point was read off.
    pub failures: usize,
    /// Instances.
    pub instances: usize,
}

/// Reads the points of `instances` instances off the eigenpairs, instance k drawn as in
/// [`measure`]. The plan is interpreted: the emitted solver computes the same bits, but returns
/// polished solutions only.
pub fn measure_unpolished(plan: &Plan, instances: u64, first_seed: u64) -> Unpolished {
    let solver = InterpretedSolver::of(plan);
    let monomials = monomials(plan);
    let errors = |k| -> Option<Vec<f64>> {
        let data = draw_inputs(&plan.data, Float64, &mut Random::new(first_seed + k));
        let coefficients = interpret::coefficients(plan, Float64, &data)?;
        let points = solver.instance(&data).and_then(|mut instance| instance.unpolished_points()).ok()?;
        let mut errors: Vec<f64> = points.iter().map(|x| published_error(plan, &monomials, &coefficients, x)).collect();
        errors.sort_by(f64::total_cmp);
        // A solution that is known beforehand has no eigenpair.
        errors.truncate(plan.solutions - usize::from(plan.has_origin));
        (!errors.is_empty()).then_some(errors)
    };
    let solved: Vec<Option<Vec<f64>>> = (0..instances).into_par_iter().map(errors).collect();
    let is_failed =
        |errors: &Option<Vec<f64>>| errors.as_ref().is_none_or(|errors| !errors.iter().all(|&e| e <= FAILED));
    let norm = |errors: &Vec<f64>| errors.iter().map(|e| e * e).sum::<f64>().sqrt();
    Unpolished {
        failures: solved.iter().filter(|errors| is_failed(errors)).count(),
        errors_log10: solved.iter().flatten().map(|errors| log10(norm(errors))).collect(),
        instances: instances as usize,
    }
}

/// All monomials of the equations, each once.
fn monomials(plan: &Plan) -> Vec<&[u8]> {
    let all = plan.equations.iter().flatten().map(|term| term.exponents.as_slice());
    all.collect::<BTreeSet<_>>().into_iter().collect()
}

/// |C m(x)| / |m(x)|.
fn published_error(plan: &Plan, monomials: &[&[u8]], coefficients: &[f64], x: &[Complex<f64>]) -> f64 {
    let power =
        |exponents: &[u8]| -> Complex<f64> { exponents.iter().zip(x).map(|(&e, x)| x.powu(u32::from(e))).product() };
    let norm =
        |values: &mut dyn Iterator<Item = Complex<f64>>| values.map(|value| value.norm_sqr()).sum::<f64>().sqrt();
    let value = |terms: &Vec<Term>| -> Complex<f64> {
        terms.iter().map(|term| power(&term.exponents) * coefficients[usize::from(term.coefficient.0)]).sum()
    };
    norm(&mut plan.equations.iter().map(value)) / norm(&mut monomials.iter().map(|exponents| power(exponents)))
}
