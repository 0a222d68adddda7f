//! Whether a problem has finitely many solutions for general data, and how many.

use std::sync::atomic::{AtomicBool, Ordering};

use crate::algebra::Random;
use crate::algebra::{
    GroebnerBasis, GroebnerError, Limits, Monomial, MonomialOrder, PRIMES, Polynomial, PrimeField, QuotientRing,
    count_points, saturate, zero_sets,
};
use crate::presolve::symmetry::Symmetry;
use crate::presolve::{Presolve, ReducedProblem, presolve};
use crate::problem::diagnostic::{Diagnostic, Diagnostics};
use crate::problem::draw::Draw;
use crate::problem::instance::Instance;
use crate::problem::{Problem, SolutionField, Statement};

/// The numbers of solutions of a problem with general data.
#[derive(Clone, Debug)]
pub struct SolutionCount {
    /// Number of complex solutions, counted with multiplicity.
    pub solutions: usize,
    /// Number of different complex solutions. If there are more than [`MOST_TOLD_APART`], all are
    /// taken to be different.
    pub different: usize,
    /// The sets of unknowns that are 0 together at some solution, while the others are not: no more
    /// than [`MOST_ZERO_SETS`], and none if solutions are not told apart.
    pub zero_sets: Vec<Vec<usize>>,
    /// Whether different solutions share values of every unknown, beyond what changes of sign and
    /// the origin bring about. If not, the values of some unknown tell all solutions apart.
    pub shares_values: bool,
    /// The multiplicity of the origin, where all unknowns are 0; 0 if it is no solution. It is
    /// known without computing.
    pub at_origin: usize,
    /// Size of the reduced grevlex Gröbner basis.
    pub basis_elements: usize,
}

impl SolutionCount {
    /// A lower bound on the columns of an elimination template of the problem.
    ///
    /// The basis B holds a monomial for each solution that is to be computed, up to the changes of
    /// sign and the exchanges that the problem allows. And no finite set of monomials holds all its
    /// products aB with an action monomial a: there is a column outside of B.
    pub fn least_columns(&self, problem: &Problem) -> usize {
        let forms = Presolve::all(problem.unknowns.len()).into_iter().map(|how| presolve(problem, how));
        self.least_columns_of(&forms.collect::<Vec<_>>())
    }

    /// As [`SolutionCount::least_columns`]; `None` where the flag is set.
    pub(crate) fn least_columns_until(&self, problem: &Problem, is_over: Option<&AtomicBool>) -> Option<usize> {
        let goes_on = || !is_over.is_some_and(|is_over| is_over.load(Ordering::Relaxed));
        let forms = Presolve::all(problem.unknowns.len()).into_iter();
        let forms: Option<Vec<ReducedProblem>> = forms.map(|how| goes_on().then(|| presolve(problem, how))).collect();
        Some(self.least_columns_of(&forms?))
    }

    fn least_columns_of(&self, forms: &[ReducedProblem]) -> usize {
        let at_a_point = self.solutions - self.different + 1;
        // Presolve may leave a problem of which the origin is a solution, which is known, too.
        let known = match forms.iter().any(|form| form.problem.has_origin()) {
            true => self.at_origin.max(at_a_point),
            false => self.at_origin,
        };
        let order = forms.iter().map(|form| form.symmetry.order()).max().unwrap_or(1);
        (self.solutions - known).div_ceil(order) + 1
    }
}

/// The instances at which solutions are counted: (prime, seed).
const COUNTS: [(u32, u64); 2] = [(PRIMES[0], 1), (PRIMES[1], 2)];
/// A problem with more solutions than this is taken for a mistake.
const MAX_SOLUTIONS: usize = 5_000;
/// At most this many solutions are told apart: the time grows with the cube of their number.
pub const MOST_TOLD_APART: usize = 400;
/// More sets of unknowns that vanish together than this are not looked at.
pub const MOST_ZERO_SETS: usize = 64;

/// Counts the solutions over two primes.
///
/// # Errors
/// There is no solution, there are infinitely many (the message has the dimension), the count
/// differs between the primes, or a limit is reached.
pub fn check(problem: &Problem) -> Result<SolutionCount, Diagnostics> {
    check_until(problem, &AtomicBool::new(false))
}

/// Like [`check`]. It ends within a second where another thread sets the flag: the algebra of a
/// problem may take minutes.
///
/// # Errors
/// As [`check`], or it was interrupted.
pub fn check_until(problem: &Problem, is_over: &AtomicBool) -> Result<SolutionCount, Diagnostics> {
    let mut counts = Vec::new();
    for (prime, seed) in COUNTS {
        let count = count(problem, PrimeField::new(prime), seed, is_over);
        counts.push(count.map_err(|message| fail(problem, message))?);
    }
    let both = |of: fn(&SolutionCount) -> usize| [of(&counts[0]), of(&counts[1])];
    for [a, b] in [both(|count| count.solutions), both(|count| count.different), both(|count| count.at_origin)] {
        if a != b {
            let [p, q] = [COUNTS[0].0, COUNTS[1].0];
            let message = Diagnostic::new("the number of solutions is not stable", problem.span.clone())
                .label(format!("{a} solutions modulo {p}, {b} modulo {q}"))
                .hint("data that are drawn from few values (`#[integer]`) may be special in one draw and general in another")
                .hint("a constant of the problem may be divisible by one of the primes");
            return Err(fail(problem, message));
        }
    }
    Ok(counts.swap_remove(0))
}

fn fail(problem: &Problem, message: Diagnostic) -> Diagnostics {
    Diagnostics { source_file: problem.source.clone(), messages: vec![message] }
}

/// Counts the solutions of one instance.
fn count(problem: &Problem, field: PrimeField, seed: u64, is_over: &AtomicBool) -> Result<SolutionCount, Diagnostic> {
    let at = || problem.span.clone();
    let instance = Instance::draw(problem, field, seed).ok_or_else(|| {
        Diagnostic::new("no random instance has the support of the problem", at())
            .label("some coefficient is zero, or some divisor, for nearly all data")
            .hint("data that are drawn from few values (`#[integer]`) may cancel; state the coefficient as a constant instead")
    })?;
    let unknowns = problem.unknowns.len();
    let too_large = |error: GroebnerError| too_large(problem, &error);
    let basis = ideal_until(&instance, unknowns, Some(is_over)).map_err(too_large)?;
    match basis.dimension(unknowns) {
        None => return Err(no_solution(problem)),
        Some(0) => {}
        Some(dimension) => return Err(infinitely_many(problem, &instance, dimension, is_over)),
    }
    let solutions = basis.quotient_basis(unknowns, MAX_SOLUTIONS).ok_or_else(|| {
        Diagnostic::new(format!("more than {MAX_SOLUTIONS} solutions"), at())
            .hint("no elimination template of use has so many; look for a formulation of lower degree")
    })?;
    let solutions = solutions.len();
    let points = Points::of(&basis, problem, seed, is_over).map_err(too_large)?;
    let different = points.as_ref().map_or(solutions, |points| points.different);
    let at_origin = match problem.has_origin() {
        true => solutions.saturating_sub(count_elsewhere(&instance, unknowns, seed, Some(is_over)).map_err(too_large)?),
        false => 0,
    };
    if at_origin == solutions {
        return Err(Diagnostic::new("all unknowns 0 is the only solution for general data", at())
            .label("every term of every equation holds an unknown")
            .hint("unknowns that can be scaled together need an equation that fixes the scale, such as `x == 1;`"));
    }
    Ok(SolutionCount {
        solutions,
        different,
        shares_values: points.as_ref().is_some_and(|points| points.share_values),
        zero_sets: points.map_or(Vec::new(), |points| points.zero_sets),
        at_origin,
        basis_elements: basis.elements().len(),
    })
}

/// The message where the algebra does not come to its end.
fn too_large(problem: &Problem, error: &GroebnerError) -> Diagnostic {
    if *error == GroebnerError::Ended {
        return Diagnostic::new("interrupted before the solutions were counted", problem.span.clone());
    }
    let title = format!("the algebra of the problem is too large: {error}");
    Diagnostic::new(title, problem.span.clone()).hint(
        "fewer unknowns or lower degrees help: eliminate what can be eliminated by hand, or divide a common factor out",
    )
}

fn no_solution(problem: &Problem) -> Diagnostic {
    Diagnostic::new("the equations have no common solution for general data", problem.span.clone())
        .label(format!("{} equations in {} unknowns", problem.equations.len(), problem.unknowns.len()))
        .hint("an equation contradicts the others, or every solution is excluded by a `!= 0` statement")
        .hint("if there are more measurements than a solution needs, state fewer, or the least squares: `gradient(cost) == 0;`")
        .hint(
            "if the data satisfy a condition, state it: `#[symmetric]`, `#[rotation]`, `#[unit]`, `#[plucker]`, `#[integer]`, `#[rank(2)]`",
        )
}

/// A vector of unknowns, not given up to scale, in which every equation is homogeneous.
fn scaled_vector(problem: &Problem) -> Option<&SolutionField> {
    problem.fields.iter().find(|field| {
        let degree = |monomial: &Monomial| field.unknowns().map(|x| i32::from(monomial.exponent(x))).sum::<i32>();
        let is_homogeneous = |equation: &Statement| {
            let mut degrees = equation.polynomial.terms().iter().map(|(monomial, _)| degree(monomial));
            degrees.next().is_none_or(|first| degrees.all(|other| other == first))
        };
        field.shape.len() == 1 && !field.is_projective && problem.equations.iter().all(is_homogeneous)
    })
}

/// The message for a set of solutions of this dimension, with the statements that would leave
/// finitely many.
fn infinitely_many(problem: &Problem, instance: &Instance, dimension: usize, is_over: &AtomicBool) -> Diagnostic {
    let sets = excluding_unknowns(instance, &problem.unknowns, is_over);
    if is_over.load(Ordering::Relaxed) {
        return too_large(problem, &GroebnerError::Ended);
    }
    let title = format!("infinitely many solutions: a set of dimension {dimension}");
    let mut message = Diagnostic::new(title, problem.span.clone()).label(format!(
        "{} equations in {} unknowns",
        problem.equations.len(),
        problem.unknowns.len()
    ));
    for names in sets {
        let list = names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        let are = if names.len() == 1 { "is" } else { "are all" };
        let statements = names.iter().map(|name| format!("{name} != 0;")).collect::<Vec<_>>().join(" ");
        message = message.hint(format!("finitely many are left where {list} {are} not 0: add `{statements}`"));
    }
    if let Some(field) = scaled_vector(problem).filter(|_| dimension == 1) {
        let (name, length) = (&field.name, field.shape[0]);
        message = message.hint(format!(
            "every equation is homogeneous in `{name}`: if its length means nothing, state `#[projective] {name}: [f64; {length}]`"
        ));
    }
    let equations = if dimension == 1 { "equation is" } else { "equations are" };
    message
        .hint(format!("{dimension} more independent {equations} needed, or an unknown that can be fixed"))
        .hint("solutions that are not wanted, such as 0, are excluded by a statement `factor != 0;`")
}

/// The number of solutions of a presolved problem except the origin of the unknowns that were kept,
/// with their multiplicity. `instance` is one of the presolved problem.
///
/// # Errors
/// As [`ideal`], and [`GroebnerError::Ended`] where the flag is set.
#[cfg(feature = "search")]
pub(crate) fn count_elsewhere_on(
    instance: &Instance,
    kept: &[usize],
    unknowns: usize,
    seed: u64,
    is_over: Option<&AtomicBool>,
) -> Result<usize, GroebnerError> {
    let mut fixed = instance.clone();
    // The others do not occur.
    let others = (0..unknowns).filter(|x| !kept.contains(x));
    fixed.equations.extend(others.map(|x| Polynomial::from_terms(vec![(Monomial::unknown(x), 1)])));
    count_elsewhere(&fixed, unknowns, seed, is_over)
}

/// The number of solutions except the origin, with their multiplicity.
///
/// A random linear form vanishes at the origin and, with a probability near 1, at no other
/// solution. So the ideal is saturated by it.
fn count_elsewhere(
    instance: &Instance,
    unknowns: usize,
    seed: u64,
    is_over: Option<&AtomicBool>,
) -> Result<usize, GroebnerError> {
    let mut random = Random::new(seed);
    let form = (0..unknowns).map(|x| (Monomial::unknown(x), instance.field.draw(&mut random)));
    let mut elsewhere = instance.clone();
    elsewhere.nonzero.push(Polynomial::collect(instance.field, form));
    let basis = ideal_until(&elsewhere, unknowns, is_over)?;
    Ok(basis.quotient_basis(unknowns, MAX_SOLUTIONS).map_or(0, |basis| basis.len()))
}

/// What the solutions of an instance have in common.
struct Points {
    /// The number of different solutions.
    different: usize,
    /// See [`SolutionCount::shares_values`].
    share_values: bool,
    /// See [`SolutionCount::zero_sets`].
    zero_sets: Vec<Vec<usize>>,
}

impl Points {
    /// `None` if there are more than [`MOST_TOLD_APART`].
    ///
    /// # Errors
    /// [`GroebnerError::Ended`] where the flag is set.
    fn of(
        basis: &GroebnerBasis,
        problem: &Problem,
        seed: u64,
        is_over: &AtomicBool,
    ) -> Result<Option<Self>, GroebnerError> {
        let limits = Limits { max_quotient_dimension: MOST_TOLD_APART, is_over: Some(is_over), ..Limits::default() };
        let unknowns = problem.unknowns.len();
        let ring = match QuotientRing::new(basis, unknowns, &limits) {
            Err(GroebnerError::Ended) => return Err(GroebnerError::Ended),
            Err(_) => return Ok(None),
            Ok(ring) => ring,
        };
        let mut random = Random::new(seed);
        let form: Vec<u32> = (0..unknowns).map(|_| basis.field().draw(&mut random)).collect();
        let different = count_points(&ring, &form, &limits)?;
        let to_tell_apart = different - usize::from(problem.has_origin());
        let order = Symmetry::of_problem(problem).order();
        let mut share_values = true;
        for unknown in 0..unknowns {
            let form: Vec<u32> = (0..unknowns).map(|at| u32::from(at == unknown)).collect();
            if count_points(&ring, &form, &limits)? * order >= to_tell_apart {
                share_values = false;
                break;
            }
        }
        let zero_sets = zero_sets(&ring, MOST_ZERO_SETS, &limits)?.into_iter().collect();
        Ok(Some(Self { different, share_values, zero_sets }))
    }
}

/// The ideal of an instance, saturated by the factors that must not vanish.
///
/// # Errors
/// As [`saturate`].
pub fn ideal(instance: &Instance, unknowns: usize) -> Result<GroebnerBasis, GroebnerError> {
    ideal_until(instance, unknowns, None)
}

fn ideal_until(
    instance: &Instance,
    unknowns: usize,
    is_over: Option<&AtomicBool>,
) -> Result<GroebnerBasis, GroebnerError> {
    let limits = Limits { max_quotient_dimension: MAX_SOLUTIONS, is_over, ..Limits::default() };
    saturate(instance.field, (&instance.equations, &instance.nonzero), unknowns, &MonomialOrder::GrevLex, &limits)
}

/// Sets of unknowns such that finitely many solutions, at least one, are left where none of the set
/// is 0.
///
/// If single unknowns do, these are all sets of one. Otherwise it is one set of several of which
/// each is needed, or none.
fn excluding_unknowns<'a>(instance: &Instance, names: &'a [String], is_over: &AtomicBool) -> Vec<Vec<&'a str>> {
    let explain = |unknowns: &[usize]| {
        let mut trial = instance.clone();
        trial.nonzero.extend(unknowns.iter().map(|&x| Polynomial::from_terms(vec![(Monomial::unknown(x), 1)])));
        ideal_until(&trial, names.len(), Some(is_over)).is_ok_and(|basis| basis.dimension(names.len()) == Some(0))
    };
    let mut sets: Vec<Vec<usize>> = (0..names.len()).map(|x| vec![x]).filter(|set| explain(set)).collect();
    let mut all: Vec<usize> = (0..names.len()).collect();
    if sets.is_empty() && explain(&all) {
        for x in (0..names.len()).rev() {
            let without: Vec<usize> = all.iter().copied().filter(|&y| y != x).collect();
            if explain(&without) {
                all = without;
            }
        }
        sets.push(all);
    }
    sets.into_iter().map(|set| set.into_iter().map(|x| names[x].as_str()).collect()).collect()
}
