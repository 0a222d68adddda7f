//! The formulations of a problem: what presolve leaves, with or without the use of sign changes.

use super::error::SearchError;
use super::monitor::{Monitor, is_set};
use super::options::SearchOptions;
use super::preference::BURDEN_OF_PRESOLVE;
use super::solving_set::Requirements;
use crate::algebra::{Monomial, PRIMES, PrimeField};
use crate::check::{SolutionCount, count_elsewhere_on};
use crate::expression::ExpressionId;
use crate::plan::straight_line::{planned_derivations, straight_line_program};
use crate::presolve::symmetry::{Reading, Symmetry};
use crate::presolve::{Presolve, ReducedProblem, presolve};
use crate::problem::Problem;
use crate::problem::instance::Instance;

/// The field in which templates are searched.
pub(crate) const SEARCH_FIELD: PrimeField = PrimeField::new(PRIMES[0]);
/// Candidates must also hold at this prime, which was not used to find them: a coefficient or a
/// pivot that vanishes modulo one prime by chance does not vanish modulo the other.
pub(crate) const CHECK_FIELD: PrimeField = PrimeField::new(PRIMES[1]);

/// Bounds on |B| that are tried, in percent of the number of solutions. A larger B takes fewer
/// rows, but the eigenvalue problem grows with the cube of |B|.
const BASIS_PERCENT: [usize; 6] = [100, 115, 130, 150, 175, 200];

/// One way to state the problem for the search, with an instance to search on and one to check on.
pub(crate) struct Formulation {
    pub(crate) presolve: Presolve,
    /// The sign changes that templates make use of.
    pub(crate) symmetry: Symmetry,
    /// The ways to read the unknowns then.
    pub(crate) readings: Vec<Vec<Reading>>,
    /// The action monomials to try.
    pub(crate) actions: Vec<Monomial>,
    pub(crate) reduced: ReducedProblem,
    pub(crate) instance: Instance,
    pub(crate) check: Instance,
    /// The number of solutions that are to be computed, with their multiplicity: all but the origin
    /// of the unknowns that were kept, which is known if it is one.
    pub(crate) solutions: usize,
    /// The sets of unknowns that were kept that are 0 together at a solution that is computed.
    pub(crate) zero_sets: Vec<Vec<usize>>,
    /// Largest |B| that is wanted; the solutions may need more.
    max_basis: Option<usize>,
}

/// What tells the formulations of a problem apart: the presolve, and whether sign changes are used.
pub(crate) type FormulationKey = (Presolve, bool);

impl Formulation {
    pub(crate) fn key(&self) -> FormulationKey {
        (self.presolve, self.symmetry.is_none())
    }

    /// What templates must satisfy.
    pub(crate) fn requirements(&self, max_basis: usize) -> Requirements<'_> {
        Requirements { readings: &self.readings, solutions: self.orbits(), max_basis, zero_sets: &self.zero_sets }
    }

    /// Whether the origin of the unknowns that were kept is a solution.
    fn has_origin(&self) -> bool {
        self.reduced.problem.has_origin()
    }

    /// The different [`BASIS_PERCENT`] of the number of solutions up to sign, increasing, up to the
    /// largest that is wanted.
    pub(crate) fn basis_limits(&self) -> Vec<usize> {
        let orbits = self.orbits();
        let mut limits: Vec<usize> = BASIS_PERCENT.iter().map(|percent| (orbits * percent).div_ceil(100)).collect();
        if let Some(most) = self.max_basis {
            limits.retain(|&limit| limit < most);
            limits.push(most.max(orbits));
        }
        limits.dedup();
        limits
    }

    /// Number of solutions up to sign: one eigenvalue gives all solutions of an orbit.
    fn orbits(&self) -> usize {
        self.solutions.div_ceil(self.symmetry.order())
    }
}

/// The different formulations of a problem. `count` is what [`crate::check::check`] tells of it.
///
/// If signs can be changed there are two of each presolved form, because a template that uses the
/// sign changes loses the solutions that no sign change moves.
///
/// # Errors
/// No instance can be drawn, or the search is interrupted.
pub(crate) fn formulations(
    problem: &Problem,
    count: &SolutionCount,
    options: &SearchOptions,
    monitor: &dyn Monitor,
) -> Result<Vec<Formulation>, SearchError> {
    let mut formulations: Vec<Formulation> = Vec::new();
    let interruption = monitor.interruption();
    let kinds = Presolve::all(problem.unknowns.len()).into_iter();
    for kind in kinds.filter(|&kind| kind != Presolve::Separated || count.shares_values) {
        if is_set(interruption) {
            return Err(SearchError::interrupted(options));
        }
        let reduced = presolve(problem, kind);
        let known = formulations.iter().position(|known| is_same(&known.reduced, &reduced));
        if let Some(known) = known {
            if operations(&reduced) * BURDEN_OF_PRESOLVE >= operations(&formulations[known].reduced) {
                continue;
            }
            formulations.retain(|known| !is_same(&known.reduced, &reduced));
        }
        let draw = |field, seed| Instance::draw(&reduced.problem, field, seed).ok_or(SearchError::NoInstance);
        let (instance, check) = (draw(SEARCH_FIELD, options.seed)?, draw(CHECK_FIELD, options.seed.wrapping_add(1))?);
        let same_unknowns = formulations.iter().find(|other| other.has_origin() && other.reduced.kept == reduced.kept);
        let solutions = match (reduced.problem.has_origin(), same_unknowns) {
            (false, _) => count.solutions,
            (true, Some(other)) => other.solutions,
            (true, None) => {
                let all = problem.unknowns.len();
                let elsewhere = count_elsewhere_on(&instance, &reduced.kept, all, options.seed, interruption);
                elsewhere.unwrap_or(count.solutions - count.at_origin)
            }
        };
        let zero_sets = zero_sets(count, &reduced);
        let symmetry = reduced.symmetry.on(&reduced.kept);
        let symmetries = [Some(symmetry.clone()).filter(|symmetry| !symmetry.is_none()), Some(Symmetry::NONE)];
        for symmetry in symmetries.into_iter().flatten() {
            let readings = symmetry.readings(&reduced.kept);
            let actions = match reduced.separated {
                // The others do not tell the solutions apart.
                Some(form) => vec![Monomial::unknown(form)],
                None => actions(&symmetry, &reduced.kept),
            };
            let (reduced, instance, check) = (reduced.clone(), instance.clone(), check.clone());
            let zero_sets = zero_sets.clone();
            formulations.push(Formulation {
                presolve: kind,
                symmetry,
                readings,
                actions,
                reduced,
                instance,
                check,
                solutions,
                zero_sets,
                max_basis: options.max_basis,
            });
        }
    }
    match is_set(interruption) {
        true => Err(SearchError::interrupted(options)),
        false => Ok(formulations),
    }
}

/// The sets of unknowns that presolve kept that are 0 together at a solution. A linear form that
/// takes the place of an unknown is 0 at the origin only; where sums and differences are 0 is not
/// known.
fn zero_sets(count: &SolutionCount, reduced: &ReducedProblem) -> Vec<Vec<usize>> {
    let on_kept = |set: &Vec<usize>| -> Vec<usize> {
        set.iter().copied().filter(|unknown| reduced.kept.contains(unknown)).collect()
    };
    let mut sets: Vec<Vec<usize>> = count.zero_sets.iter().map(on_kept).collect();
    // The origin is known.
    sets.retain(|set| !(reduced.problem.has_origin() && *set == reduced.kept));
    let is_replaced =
        |x: usize| Some(x) == reduced.separated || reduced.pairs.iter().flatten().any(|&other| other == x);
    sets.iter_mut().filter(|set| **set != reduced.kept).for_each(|set| set.retain(|&x| !is_replaced(x)));
    sets.retain(|set| !set.is_empty());
    sets.sort_unstable();
    sets.dedup();
    sets
}

/// Operations that compute the coefficients of the equations.
fn operations(reduced: &ReducedProblem) -> f64 {
    let recoveries = reduced.recoveries.iter().map(|recovery| &recovery.value);
    let entries = reduced.linear.iter().flat_map(|block| block.rows.iter().flatten());
    let equations = reduced.problem.polynomials().chain(recoveries).chain(entries);
    let used: Vec<ExpressionId> = equations.flat_map(|p| p.terms()).map(|&(_, coefficient)| coefficient).collect();
    let derived = planned_derivations(&reduced.problem.graph, &used, &[]);
    let derived = derived.iter().filter(|derived| !derived.is_for_results);
    let of_derived = derived.map(|d| d.program.steps() + d.derivation.kind.operations()).sum::<usize>();
    (straight_line_program(&reduced.problem.graph, &used, 0).0.steps() + of_derived) as f64
}

/// Whether two reduced problems have the same unknowns and the same monomials in the same
/// equations. The search depends on nothing else, as coefficients are random.
fn is_same(a: &ReducedProblem, b: &ReducedProblem) -> bool {
    let monomials = |reduced: &ReducedProblem| -> Vec<Vec<Monomial>> {
        reduced.problem.polynomials().map(|polynomial| polynomial.monomials().collect()).collect()
    };
    (&a.kept, a.separated, &a.pairs) == (&b.kept, b.separated, &b.pairs) && monomials(a) == monomials(b)
}

/// The action monomials to try: each unknown and its reciprocal. If sign changes are used, an
/// action monomial must keep its sign, so that products and ratios of two unknowns that change
/// their signs together take the place of these unknowns.
fn actions(symmetry: &Symmetry, unknowns: &[usize]) -> Vec<Monomial> {
    let unknowns: Vec<Monomial> = unknowns.iter().map(|&unknown| Monomial::unknown(unknown)).collect();
    let (keep, change): (Vec<Monomial>, Vec<Monomial>) = unknowns.into_iter().partition(|x| symmetry.keeps(x));
    let pairs = (0..change.len()).flat_map(|i| (i..change.len()).map(move |j| (i, j)));
    let of_pairs = pairs.flat_map(|(i, j)| [change[i].times(&change[j]), change[i].over(&change[j])]);
    let all = keep.iter().copied().chain(of_pairs.filter(|m| *m != Monomial::ONE && symmetry.keeps(m)));
    all.flat_map(|m| [m, Monomial::ONE.over(&m)]).collect()
}
