//! Over Z_p nothing is rounded: every plan is compared with normal forms modulo the ideal of its
//! problem, for equality.

use std::cell::Cell;

use eliminant_generator::algebra::{DenseMatrix, GroebnerBasis, Monomial, PRIMES, Polynomial, PrimeField};
use eliminant_generator::check::ideal;
use eliminant_generator::expression::ExpressionId;
use eliminant_generator::generate::Planned;
use eliminant_generator::plan::interpret;
use eliminant_generator::plan::{KnownMonomial, PivotId, Term};
use eliminant_generator::presolve::exchange::Image;
use eliminant_generator::problem::Problem;
use eliminant_generator::problem::instance::Instance;
use eliminant_generator::template::EliminationTemplate;
use eliminant_tests::cases;

/// Not those of the search, which are the first two.
const FRESH_PRIMES: std::ops::Range<usize> = 2..5;
const SEEDS: std::ops::Range<u64> = 100..102;

/// One problem at one prime and seed.
struct Setting {
    name: String,
    template: EliminationTemplate,
    solutions: usize,
    /// How many of them the template gives: all but the origin.
    computed: usize,
    planned: Planned,
    field: PrimeField,
    inputs: Vec<u32>,
    /// Values of the plan's coefficients.
    coefficients: Vec<u32>,
    /// The problem as stated.
    original: Instance,
    ideal: GroebnerBasis,
    /// The presolved problem.
    reduced: Instance,
    reduced_ideal: GroebnerBasis,
}

/// The problem with given data.
fn instance(problem: &Problem, field: PrimeField, inputs: &[u32]) -> Instance {
    let values = problem.graph.evaluate(field, inputs).expect("no divisor vanishes");
    let image = |p: &Polynomial<_>| p.map(|c: &ExpressionId| Some(values[c.index()]));
    Instance {
        field,
        inputs: inputs.to_vec(),
        equations: problem.polynomials().map(image).collect(),
        nonzero: problem.nonzero.iter().map(|factor| image(&factor.polynomial)).collect(),
    }
}

fn for_each_setting(check: impl Fn(&Setting)) {
    let mut settings = 0;
    for case in cases() {
        let (problem, file, planned) = (case.problem(), case.template(), case.planned());
        let unknowns = problem.unknowns.len();
        for prime in &PRIMES[FRESH_PRIMES] {
            for seed in SEEDS {
                let field = PrimeField::new(*prime);
                let reduced = Instance::draw(&planned.reduced.problem, field, seed).expect("an instance");
                let original = instance(&problem, field, &reduced.inputs);
                check(&Setting {
                    name: format!("{} modulo {prime}, seed {seed}", case.name),
                    template: file.template.clone(),
                    solutions: file.solutions,
                    computed: file.solutions - usize::from(planned.plan.has_origin),
                    coefficients: interpret::coefficients(&planned.plan, field, &reduced.inputs).expect("coefficients"),
                    planned: planned.clone(),
                    field,
                    inputs: reduced.inputs.clone(),
                    ideal: ideal(&original, unknowns).expect("a Gröbner basis"),
                    original,
                    reduced_ideal: ideal(&reduced, unknowns).expect("a Gröbner basis"),
                    reduced,
                });
                settings += 1;
            }
        }
    }
    assert_eq!(settings, cases().len() * FRESH_PRIMES.len() * (SEEDS.end - SEEDS.start) as usize);
}

/// (m+, m-) with m = m+ / m- and no negative exponent.
fn numerator_and_denominator(m: &Monomial) -> (Monomial, Monomial) {
    let part = |sign: i8| Monomial::from_exponents(&m.exponents().map(|e| (sign * e).max(0)));
    (part(1), part(-1))
}

/// The least monomial that clears the denominators of all the given ones.
fn common_denominator<'a>(monomials: impl IntoIterator<Item = &'a Monomial>) -> Monomial {
    monomials.into_iter().fold(Monomial::ONE, |common, m| common.lcm(&numerator_and_denominator(m).1))
}

fn monomial(m: Monomial) -> Polynomial<u32> {
    Polynomial::from_terms(vec![(m, 1)])
}

/// The monomial that a pivot of the elimination stands for.
fn pivot_monomial(s: &Setting, pivot: PivotId) -> Monomial {
    let column = s.planned.plan.elimination.pivot_columns[usize::from(pivot.0)];
    s.template.excess.iter().chain(&s.template.reducible).copied().nth(column).expect("a column")
}

/// The terms of a plan as a polynomial.
fn polynomial(terms: &[Term], field: PrimeField, coefficients: &[u32]) -> Polynomial<u32> {
    let term = |t: &Term| {
        let exponents: Vec<i8> = t.exponents.iter().map(|&e| e as i8).collect();
        (Monomial::from_exponents(&exponents), coefficients[usize::from(t.coefficient.0)])
    };
    Polynomial::collect(field, terms.iter().map(term))
}

/// With a = n / d and c clearing the denominators of B: c n b = sum over j of T[b][j] c d b_j
/// modulo the ideal, for every b in B.
#[test]
fn the_action_matrix_of_the_plan_equals_normal_forms() {
    for_each_setting(|s| {
        let action = interpret::eliminate(&s.planned.plan, s.field, &s.coefficients).expect("an action matrix").action;
        let basis = &s.template.basis;
        let signs = 1 + s.planned.plan.images.len();
        assert_eq!((action.len(), basis.len() * signs >= s.computed), (basis.len(), true), "{}", s.name);
        let (n, d) = numerator_and_denominator(&s.template.action);
        let c = common_denominator(basis);
        for (b, row) in basis.iter().zip(&action) {
            let left = monomial(c.times(&n).times(b));
            let right = Polynomial::collect(s.field, basis.iter().zip(row).map(|(b, &t)| (c.times(&d).times(b), t)));
            let normal_form = |p| s.reduced_ideal.normal_form(p).expect("a normal form");
            assert_eq!(normal_form(&left), normal_form(&right), "{}: row {b:?}", s.name);
            assert_eq!(row.len(), basis.len(), "{}", s.name);
        }
    });
}

/// Monomials that unknowns are read from are the combinations of B that the rows say they are.
#[test]
fn the_rows_that_unknowns_are_read_from_equal_normal_forms() {
    let rows = Cell::new(0);
    for_each_setting(|s| {
        let read = interpret::eliminate(&s.planned.plan, s.field, &s.coefficients).expect("an action matrix").read;
        for (&pivot, row) in s.planned.plan.read.iter().zip(&read) {
            let left = pivot_monomial(s, pivot);
            let all: Vec<Monomial> = s.template.basis.iter().copied().chain([left]).collect();
            let c = common_denominator(&all);
            let right = s.template.basis.iter().zip(row).map(|(b, &t)| (c.times(b), t));
            let normal_form = |p| s.reduced_ideal.normal_form(p).expect("a normal form");
            let right = Polynomial::collect(s.field, right);
            assert_eq!(normal_form(&monomial(c.times(&left))), normal_form(&right), "{}: {left:?}", s.name);
            rows.set(rows.get() + 1);
        }
    });
    assert!(rows.get() > 0, "some problem has such a row");
}

/// What is divided by has no zero in common with the problem (else solutions would be lost), and B
/// spans the quotient ring, so that every solution gives an eigenvector; or the part of it whose
/// monomials change their signs as those of B do.
#[test]
fn no_solution_is_lost_by_the_action_or_the_basis() {
    for_each_setting(|s| {
        let c = common_denominator(&s.template.basis);
        let divisor = c.times(&numerator_and_denominator(&s.template.action).1);
        let mut with_divisor = s.reduced.clone();
        with_divisor.equations.push(monomial(divisor));
        if s.planned.plan.has_origin {
            // All but the origin: a linear form vanishes there, and in general nowhere else.
            let form = (0u32..).zip(&s.planned.reduced.kept).map(|(at, &x)| (Monomial::unknown(x), 7 * at + 3));
            with_divisor.nonzero.push(Polynomial::collect(s.field, form));
        }
        let common = ideal(&with_divisor, s.planned.plan.unknowns.len()).expect("a Gröbner basis");
        assert!(common.is_unit(), "{}: some solution has {divisor:?} = 0", s.name);

        let forms: Vec<Polynomial<u32>> = s
            .template
            .basis
            .iter()
            .map(|b| s.reduced_ideal.normal_form(&monomial(c.times(b))).expect("a normal form"))
            .collect();
        let mut standard: Vec<Monomial> = forms.iter().flat_map(|form| form.monomials()).collect();
        standard.sort_unstable();
        standard.dedup();
        let rows: Vec<Vec<u32>> = forms
            .iter()
            .map(|form| standard.iter().map(|m| form.coefficient(m).copied().unwrap_or(0)).collect())
            .collect();
        let mut matrix = DenseMatrix::from_rows(s.field, standard.len(), &rows);
        let up_to_sign = s.computed / (1 + s.planned.plan.images.len());
        assert_eq!(matrix.reduce_to_echelon().len(), up_to_sign, "{}: rank of the basis", s.name);
    });
}

/// Presolving neither loses nor adds solutions.
#[test]
fn the_number_of_solutions_is_that_of_the_template() {
    for_each_setting(|s| {
        let unknowns = s.planned.plan.unknowns.len();
        let count = |ideal: &GroebnerBasis| ideal.quotient_basis(unknowns, 1000).map(|basis| basis.len());
        assert_eq!(count(&s.ideal), Some(s.solutions), "{}", s.name);
        // The eliminated unknowns are free in the reduced ideal: fixed, they count once.
        let mut fixed = s.reduced.clone();
        fixed.equations.extend(s.planned.reduced.eliminated().map(|unknown| monomial(Monomial::unknown(unknown))));
        assert_eq!(count(&ideal(&fixed, unknowns).expect("a Gröbner basis")), Some(s.solutions), "{} reduced", s.name);
    });
}

/// unknown - value lies in the ideal of the problem as stated, by the symbolic recovery and by the
/// plan's.
#[test]
fn eliminated_unknowns_are_recovered() {
    for_each_setting(|s| {
        let reduced = &s.planned.reduced;
        let values = reduced.problem.graph.evaluate(s.field, &s.inputs).expect("no divisor vanishes");
        let symbolic = reduced.recoveries.iter().map(|r| (r.unknown, r.value.map(|c| Some(values[c.index()]))));
        let planned = s.planned.plan.recoveries.iter();
        let planned = planned.map(|r| (r.unknown, polynomial(&r.terms, s.field, &s.coefficients)));
        let recoveries: Vec<(usize, Polynomial<u32>)> = symbolic.chain(planned).collect();
        let linear = reduced.linear.as_ref().map_or(0, |block| block.unknowns.len());
        let eliminated = s.planned.plan.unknowns.len() - reduced.kept.len() - linear;
        assert_eq!(recoveries.len(), 2 * eliminated, "{}", s.name);
        for (unknown, value) in recoveries {
            let minus = Polynomial::collect(s.field, [(Monomial::unknown(unknown), s.field.neg(1))]);
            let difference = value.plus(s.field, &minus);
            let remainder = s.ideal.normal_form(&difference).expect("a normal form");
            assert!(remainder.is_zero(), "{}: unknown {unknown} leaves {remainder:?}", s.name);
        }
    });
}

/// The rows of A x + b = 0, from which unknowns follow together, lie in the ideal of the problem as
/// stated, those of presolve and those of the plan.
#[test]
fn linear_blocks_are_equations_of_the_problem() {
    let rows = Cell::new(0);
    for_each_setting(|s| {
        let (reduced, plan) = (&s.planned.reduced, &s.planned.plan);
        let values = reduced.problem.graph.evaluate(s.field, &s.inputs).expect("no divisor vanishes");
        let (Some(block), Some(planned)) = (&reduced.linear, &plan.linear) else {
            assert!(reduced.linear.is_none() && plan.linear.is_none(), "{}", s.name);
            return;
        };
        assert_eq!((&block.unknowns, block.rows.len()), (&planned.unknowns, planned.rows.len()), "{}", s.name);
        let factors = block.unknowns.iter().map(|&unknown| Monomial::unknown(unknown)).chain([Monomial::ONE]);
        let factors: Vec<Monomial> = factors.collect();
        let symbolic = |entry: &Polynomial<_>| entry.map(|c: &ExpressionId| Some(values[c.index()]));
        let of_plan = |entry: &Vec<Term>| polynomial(entry, s.field, &s.coefficients);
        let symbolic = block.rows.iter().map(|row| row.iter().map(symbolic).collect::<Vec<_>>());
        for row in symbolic.chain(planned.rows.iter().map(|row| row.iter().map(of_plan).collect())) {
            let products = row
                .iter()
                .zip(&factors)
                .flat_map(|(entry, x)| entry.terms().iter().map(move |&(m, c)| (m.times(x), c)));
            let remainder = s.ideal.normal_form(&Polynomial::collect(s.field, products)).expect("a normal form");
            assert!(remainder.is_zero(), "{}: a row leaves {remainder:?}", s.name);
            rows.set(rows.get() + 1);
        }
    });
    assert!(rows.get() > 0, "some problem has a linear block");
}

/// The equations and factors that the solver polishes and judges with are those of the problem.
#[test]
fn the_equations_of_the_plan_are_those_of_the_problem() {
    for_each_setting(|s| {
        let plan = &s.planned.plan;
        let planned = |all: &[Vec<Term>]| -> Vec<_> {
            all.iter().map(|terms| polynomial(terms, s.field, &s.coefficients)).collect()
        };
        assert_eq!(planned(&plan.equations), s.original.equations, "{}", s.name);
        assert_eq!(planned(&plan.nonzero), s.original.nonzero, "{}", s.name);
    });
}

/// Every kept unknown is read from pairs of monomials that do differ by the factor that the plan
/// says, and that factor decides the unknown up to the signs that the plan changes.
#[test]
fn unknowns_are_ratios_of_known_monomials() {
    for_each_setting(|s| {
        let known = |m: &KnownMonomial| match m {
            KnownMonomial::Basis(b) => s.template.basis[usize::from(b.0)],
            KnownMonomial::Image(b) => s.template.basis[usize::from(b.0)].times(&s.template.action),
            KnownMonomial::Read(at) => {
                let pivot = s.planned.plan.read[usize::from(*at)];
                pivot_monomial(s, pivot)
            }
        };
        let mut read: Vec<usize> = Vec::new();
        for extraction in &s.planned.plan.extractions {
            assert!(!extraction.pairs.is_empty(), "{}", s.name);
            for (m, xm) in &extraction.pairs {
                assert_eq!(known(xm), known(m).times(&Monomial::from_exponents(&extraction.step)), "{}", s.name);
            }
            let is_odd = |step: &[i8], images: &[Image]| {
                step.iter().zip(images).filter(|(e, (_, changes))| *changes && *e % 2 != 0).count() % 2 == 1
            };
            // In sums and differences an exchange changes other signs than its images say.
            assert!(s.planned.reduced.pairs.is_empty(), "{}: not told for exchanges", s.name);
            assert!(s.planned.plan.images.iter().all(|images| !is_odd(&extraction.step, images)), "{}", s.name);
            read.push(extraction.unknown);
        }
        read.sort_unstable();
        assert_eq!(read, s.planned.reduced.kept, "{}", s.name);
        // The factors change with every choice of signs but those of the plan.
        let kept = &s.planned.reduced.kept;
        let is_kept_by = |signs: usize, step: &[i8]| {
            kept.iter().enumerate().filter(|&(at, &unknown)| signs >> at & 1 == 1 && step[unknown] % 2 != 0).count() % 2
                == 0
        };
        let extractions = &s.planned.plan.extractions;
        let all_kept = |signs: &usize| extractions.iter().all(|extraction| is_kept_by(*signs, &extraction.step));
        assert_eq!((0..1usize << kept.len()).filter(all_kept).count(), 1 + s.planned.plan.images.len(), "{}", s.name);
    });
}
