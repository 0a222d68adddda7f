//! The equations of a problem as stated, at 237 bits, and Newton's method on them.

use eliminant::Complex;
use f256::f256;

use super::number::{Wide, WideComplex, modulus, rounded, widened};
use crate::expression::arithmetic::Float64;
use crate::plan::{Plan, Term, interpret};

/// A point with a complex value for each unknown.
pub(super) type WidePoint = Vec<WideComplex>;

/// Steps of Newton's method at most. Two reach 60 digits from a point with 15 correct ones.
const STEPS: usize = 24;
/// A step this short, relative to the point, is the last one, and shows that the method converges
/// to a simple solution: the next one would have the square of its length.
const CONVERGED: f64 = 1e-28;
/// The relative residual of a solution. It is not 0 if there are more equations than unknowns and
/// the data satisfy a condition up to their rounding only, such as that of a rotation.
const EXACT: f64 = 1e-13;
/// A point so much smaller than the largest solutions is the origin, up to the rounding of data.
const ORIGIN: f64 = 1e-14;
/// A factor that must not vanish does if it is this small beside its terms.
const VANISHING: f64 = 1e-20;

/// The polynomials of a problem with the coefficients of an instance.
pub(super) struct System<'a> {
    plan: &'a Plan,
    coefficients: Vec<f256>,
    /// The norm of the largest solutions, about.
    size: f64,
}

/// A point after Newton's method.
pub(super) struct Refined {
    /// The point.
    pub(super) point: WidePoint,
    /// The length of the last step, relative to the point.
    last_step: f64,
    /// The relative residual.
    residual: f64,
}

impl Refined {
    /// Whether the method converges to a simple solution.
    pub(super) fn is_solution(&self) -> bool {
        self.last_step <= CONVERGED && self.residual <= EXACT
    }
}

impl<'a> System<'a> {
    /// The equations for these data, with solutions of norms of about `size` and less; `None` if a
    /// divisor vanishes or data are not finite.
    pub(super) fn new(plan: &'a Plan, data: &[f64], size: f64) -> Option<Self> {
        // Derived data are as a solver has them, rounded.
        let data = interpret::all_inputs(plan, Float64, data)?;
        let inputs: Vec<f256> = data.iter().map(|&x| f256::from(x)).collect();
        Some(Self { plan, coefficients: interpret::coefficients(plan, Wide, &inputs)?, size })
    }

    /// The coefficients.
    pub(super) fn coefficients(&self) -> &[f256] {
        &self.coefficients
    }

    /// The relative residual of a point: max over the equations of |f| / sum of the moduli of its
    /// terms.
    pub(super) fn residual(&self, x: &[Complex<f64>]) -> f64 {
        let x: WidePoint = x.iter().copied().map(widened).collect();
        self.residual_of(&x)
    }

    fn residual_of(&self, x: &[WideComplex]) -> f64 {
        let powers = Powers::of(self.plan, x);
        self.plan.equations.iter().map(|terms| self.relative_value(terms, &powers)).fold(0.0, f64::max)
    }

    /// Whether no factor that must not vanish does.
    pub(super) fn is_admissible(&self, x: &[WideComplex]) -> bool {
        let powers = Powers::of(self.plan, x);
        self.plan.nonzero.iter().all(|terms| self.relative_value(terms, &powers) > VANISHING)
    }

    /// Whether a real point satisfies the inequalities of the problem.
    pub(super) fn is_wanted(&self, x: &[WideComplex]) -> bool {
        let powers = Powers::of(self.plan, x);
        self.plan.positive.iter().all(|terms| {
            let sum = terms.iter().fold(zero(), |sum, term| sum + self.value(term, &powers, None));
            rounded(sum.re) > 0.0
        })
    }

    /// |f| / sum of the moduli of the terms; 0 where all terms vanish, infinite where it is no
    /// number.
    fn relative_value(&self, terms: &[Term], powers: &Powers) -> f64 {
        let (mut sum, mut scale) = (zero(), 0.0);
        for term in terms {
            let value = self.value(term, powers, None);
            sum += value;
            scale += modulus(value);
        }
        match modulus(sum) / scale {
            _ if scale == 0.0 => 0.0,
            relative if relative.is_nan() => f64::INFINITY,
            relative => relative,
        }
    }

    /// A term, or its derivative by an unknown.
    fn value(&self, term: &Term, powers: &Powers, by: Option<usize>) -> WideComplex {
        let mut factor = self.coefficients[usize::from(term.coefficient.0)];
        let mut product: Option<WideComplex> = None;
        for (unknown, &exponent) in term.exponents.iter().enumerate() {
            let exponent = usize::from(exponent);
            let lowered = match by == Some(unknown) {
                true if exponent == 0 => return zero(),
                true if exponent == 1 => 0,
                true => {
                    factor *= f256::from(exponent as u64);
                    exponent - 1
                }
                false => exponent,
            };
            if lowered > 0 {
                let power = powers.0[unknown][lowered];
                product = Some(product.map_or(power, |product| product * power));
            }
        }
        product.map_or(Complex::new(factor, f256::ZERO), |product| product.scale(factor))
    }

    /// Values of the equations and their derivatives, each row divided by the sum of the moduli of
    /// its terms: the last entry of a row is minus the value.
    fn rows(&self, x: &[WideComplex]) -> Vec<Vec<WideComplex>> {
        let powers = Powers::of(self.plan, x);
        let row = |terms: &Vec<Term>| {
            let mut row = vec![zero(); x.len() + 1];
            let mut scale = 0.0;
            for term in terms {
                let value = self.value(term, &powers, None);
                row[x.len()] -= value;
                scale += modulus(value);
                for (unknown, _) in term.exponents.iter().enumerate().filter(|&(_, &exponent)| exponent > 0) {
                    row[unknown] += self.value(term, &powers, Some(unknown));
                }
            }
            if scale > 0.0 && scale.is_finite() {
                let inverse = f256::ONE / f256::from(scale);
                row.iter_mut().for_each(|entry| *entry = entry.scale(inverse));
            }
            row
        };
        self.plan.equations.iter().map(row).collect()
    }

    /// Newton's method from a point; with more equations than unknowns that of Gauss and Newton.
    pub(super) fn refined(&self, start: &[WideComplex]) -> Refined {
        let mut point = start.to_vec();
        let mut last_step = f64::INFINITY;
        for _ in 0..STEPS {
            let Some(step) = least_squares(self.rows(&point), point.len()) else { break };
            point.iter_mut().zip(&step).for_each(|(x, step)| *x += step);
            last_step = self.relative(norm(&step), &point);
            if !(last_step > CONVERGED && last_step.is_finite()) {
                break;
            }
        }
        let residual = self.residual_of(&point);
        // Where an unknown is 0, all terms of an equation may vanish, and what is left of the
        // unknown is all that its relative residual shows.
        let smallest = CONVERGED * norm(&point);
        let without_noise: WidePoint = point.iter().map(|&x| if norm(&[x]) <= smallest { zero() } else { x }).collect();
        let other = self.residual_of(&without_noise);
        match residual > EXACT && other < residual {
            true => Refined { point: without_noise, last_step, residual: other },
            false => Refined { point, last_step, residual },
        }
    }

    /// How far two points are apart, relative to the second.
    pub(super) fn distance(&self, x: &[WideComplex], y: &[WideComplex]) -> f64 {
        let difference: WidePoint = x.iter().zip(y).map(|(a, b)| a - b).collect();
        self.relative(norm(&difference), y)
    }

    /// A length relative to that of a point. A solution at the origin has no length, and is known
    /// as well as the others: to a part of theirs.
    pub(super) fn relative(&self, length: f64, point: &[WideComplex]) -> f64 {
        let own = norm(point);
        let size = if own > ORIGIN * self.size { own } else { self.size };
        if size > 0.0 { length / size } else { length }
    }
}

/// The powers of all unknowns, up to the largest that a polynomial has.
struct Powers(Vec<Vec<WideComplex>>);

impl Powers {
    fn of(plan: &Plan, x: &[WideComplex]) -> Self {
        let polynomials = plan.equations.iter().chain(&plan.nonzero).chain(&plan.positive);
        let exponents = || polynomials.clone().flatten().map(|term| &term.exponents);
        let largest = |unknown: usize| exponents().filter_map(|e| e.get(unknown)).max().copied().unwrap_or(0);
        let powers = |(unknown, &x): (usize, &WideComplex)| {
            let next = |power: &WideComplex| Some(*power * x);
            let one = Complex::new(f256::ONE, f256::ZERO);
            std::iter::successors(Some(one), next).take(usize::from(largest(unknown)) + 1).collect()
        };
        Self(x.iter().enumerate().map(powers).collect())
    }
}

fn zero() -> WideComplex {
    Complex::new(f256::ZERO, f256::ZERO)
}

/// The solution of A x = b in the sense of least squares, of rows (A, b); `None` if A has not full
/// rank. Square systems are solved as they are; others by the normal equations, which cost half of
/// the 71 digits at worst.
fn least_squares(rows: Vec<Vec<WideComplex>>, unknowns: usize) -> Option<WidePoint> {
    let square = match rows.len() == unknowns {
        true => rows,
        false => {
            let entry = |i: usize, j: usize| rows.iter().fold(zero(), |sum, row| sum + row[i].conj() * row[j]);
            (0..unknowns).map(|i| (0..=unknowns).map(|j| entry(i, j)).collect()).collect()
        }
    };
    solved(square)
}

/// Gaussian elimination with partial pivoting.
fn solved(mut rows: Vec<Vec<WideComplex>>) -> Option<WidePoint> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| modulus(rows[i][k]).total_cmp(&modulus(rows[j][k])))?;
        rows.swap(k, pivot);
        let size = modulus(rows[k][k]);
        if !(size > 0.0 && size.is_finite()) {
            return None;
        }
        let inverse = Complex::new(f256::ONE, f256::ZERO) / rows[k][k];
        let (above, below) = rows.split_at_mut(k + 1);
        for row in below {
            let factor = row[k] * inverse;
            (k + 1..=n).for_each(|j| row[j] -= factor * above[k][j]);
        }
    }
    let mut x = vec![zero(); n];
    for k in (0..n).rev() {
        let sum = (k + 1..n).fold(rows[k][n], |sum, j| sum - rows[k][j] * x[j]);
        x[k] = sum / rows[k][k];
    }
    Some(x)
}

/// The Euclidean norm of a point, rounded.
pub(super) fn norm(x: &[WideComplex]) -> f64 {
    rounded(x.iter().fold(f256::ZERO, |sum, z| sum + z.norm_sqr()).sqrt())
}
