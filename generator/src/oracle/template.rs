//! The template at 237 bits: the same plan as the solver's, and the points of all eigenpairs.

use eliminant::Complex;
use eliminant::emitted::least_squares;
use f256::f256;

use super::number::{Wide, WideComplex, square_root};
use super::spectrum::{WidePair, eigenpairs};
use super::system::{System, WidePoint};
use crate::plan::interpret::{self, Eliminated};
use crate::plan::{Extraction, KnownMonomial, Plan, Term};
use crate::presolve::exchange::Image;

/// The points of all eigenpairs, those of eigenpairs that belong to no solution among them. Empty
/// if the template is singular.
pub(super) fn points(plan: &Plan, system: &System<'_>) -> Vec<WidePoint> {
    let Some(eliminated) = interpret::eliminate(plan, Wide, system.coefficients()) else { return Vec::new() };
    let mut points = Vec::new();
    for pair in eigenpairs(&eliminated.action) {
        let Some(point) = unknowns(plan, system, &eliminated, &pair) else { continue };
        let image =
            |&(of, is_negated): &Image| if is_negated { -point[usize::from(of)] } else { point[usize::from(of)] };
        points.extend(plan.images.iter().map(|map| map.iter().map(image).collect::<WidePoint>()));
        points.push(point);
    }
    points
}

/// The point at which all unknowns are 0 but those that presolve eliminated.
pub(super) fn origin(plan: &Plan, system: &System<'_>) -> WidePoint {
    recovered(plan, system, vec![Complex::new(f256::ZERO, f256::ZERO); plan.unknowns.len()])
}

/// The unknowns of an eigenpair; `None` if they cannot be read.
fn unknowns(
    plan: &Plan,
    system: &System<'_>,
    eliminated: &Eliminated<f256>,
    (value, vector): &WidePair,
) -> Option<WidePoint> {
    let zero = Complex::new(f256::ZERO, f256::ZERO);
    let known = |monomial: KnownMonomial| match monomial {
        KnownMonomial::Basis(b) => vector[usize::from(b.0)],
        KnownMonomial::Image(b) => *value * vector[usize::from(b.0)],
        KnownMonomial::Read(at) => {
            eliminated.read[usize::from(at)].iter().zip(vector).fold(zero, |sum, (&factor, v)| sum + v.scale(factor))
        }
    };
    let mut x = vec![zero; plan.unknowns.len()];
    // Square roots come first.
    for extraction in &plan.extractions {
        let ratio = ratio(extraction, known)?;
        x[extraction.unknown] = match extraction.is_square() {
            true => square_root(ratio),
            false => extraction.others().fold(ratio, |ratio, (other, exponent)| match exponent {
                1 => ratio / x[other],
                _ => ratio * x[other],
            }),
        };
    }
    let x = recovered(plan, system, x);
    x.iter().all(|x| x.re.is_finite() && x.im.is_finite()).then_some(x)
}

/// The point with the unknowns that presolve eliminated, which follow from the others.
fn recovered(plan: &Plan, system: &System<'_>, mut x: WidePoint) -> WidePoint {
    let zero = Complex::new(f256::ZERO, f256::ZERO);
    let sum = |terms: &[Term], x: &WidePoint| {
        let term = |term: &Term| {
            let factors = term.exponents.iter().zip(x).flat_map(|(&e, &x)| (0..e).map(move |_| x));
            let coefficient = Complex::new(system.coefficients()[usize::from(term.coefficient.0)], f256::ZERO);
            factors.fold(coefficient, |product, x| product * x)
        };
        terms.iter().map(term).fold(zero, |sum, term| sum + term)
    };
    if let Some(block) = &plan.linear {
        let mut rows: WidePoint = block.rows.iter().flatten().map(|entry| sum(entry, &x)).collect();
        let mut linear = vec![zero; block.unknowns.len()];
        least_squares(&mut rows, &mut linear);
        block.unknowns.iter().zip(linear).for_each(|(&unknown, value)| x[unknown] = value);
    }
    for recovery in &plan.recoveries {
        x[recovery.unknown] = sum(&recovery.terms, &x);
    }
    x
}

/// sum of conj(m_k) (s m_k) / sum of |m_k|^2; `None` if all m_k vanish.
fn ratio(extraction: &Extraction, known: impl Fn(KnownMonomial) -> WideComplex) -> Option<WideComplex> {
    let (mut above, mut below) = (Complex::new(f256::ZERO, f256::ZERO), f256::ZERO);
    for &(from, to) in &extraction.pairs {
        let (from, to) = (known(from), known(to));
        above += from.conj() * to;
        below += from.norm_sqr();
    }
    (below != f256::ZERO).then(|| above.unscale(below))
}
