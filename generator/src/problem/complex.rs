//! Complex numbers: polynomials that hold the imaginary unit i.
//!
//! A complex number of data or of unknowns is two real ones, x + y i. While a problem is read, i is
//! one more unknown, the last one that monomials have room for, of degree 0 or 1: each product is
//! taken part by part, with i^2 = -1. What is stated is real: a complex equation is two equations,
//! of its real and of its imaginary part, and a complex factor z that must not vanish is z times
//! its conjugate. So a conjugate is a value like any other, and whatever follows after the reading
//! knows real numbers only.

use syn::{Expr, ExprCall, ExprField, Member};

use super::Span;
use super::interpret::Interpreter;
use super::scope::{Outcome, Reported};
use super::syntax::place;
use super::value::{Algebra, Checked, IMAGINARY_UNIT, Value, describe};
use crate::algebra::{Monomial, Polynomial};
use crate::expression::{SignedProduct, SymbolicPolynomial};
use crate::problem::diagnostic::Diagnostic;

impl Algebra {
    /// Whether a polynomial holds i.
    pub(super) fn is_complex(&self, p: &SymbolicPolynomial) -> bool {
        self.has_imaginary_unit && p.monomials().any(|m| m.exponent(IMAGINARY_UNIT) != 0)
    }

    /// Whether an element of a value holds i.
    pub(super) fn is_complex_value(&self, value: &Value) -> bool {
        value.elements().iter().any(|p| self.is_complex(p))
    }

    /// The real and the imaginary part.
    pub(super) fn parts(&self, p: &SymbolicPolynomial) -> [SymbolicPolynomial; 2] {
        if !self.is_complex(p) {
            return [p.clone(), Polynomial::ZERO];
        }
        [0, 1].map(|power| {
            let of_part = p.terms().iter().filter(|(m, _)| m.exponent(IMAGINARY_UNIT) == power);
            Polynomial::from_terms(of_part.map(|&(m, c)| (without_unit(m), c)).collect())
        })
    }

    /// re + im i.
    pub(super) fn join([re, im]: [&SymbolicPolynomial; 2]) -> SymbolicPolynomial {
        let unit = Monomial::unknown(IMAGINARY_UNIT);
        let of_im = im.terms().iter().filter_map(|&(m, c)| Some((m.checked_mul(&unit)?, c)));
        Polynomial::from_terms(re.terms().iter().copied().chain(of_im).collect())
    }

    /// The complex conjugate.
    pub(super) fn conjugate(&mut self, p: &SymbolicPolynomial) -> SymbolicPolynomial {
        let [re, im] = self.parts(p);
        Self::join([&re, &self.graph.polynomial_neg(&im)])
    }

    /// p times its conjugate, which is real.
    pub(super) fn square_of_modulus(&mut self, p: &SymbolicPolynomial) -> Checked<SymbolicPolynomial> {
        let [re, im] = self.parts(p);
        self.sum_of_products(&[(false, &re, &re), (false, &im, &im)])
    }

    /// A sum of products of complex numbers: of (a + b i) (c + d i), ac - bd and ad + bc.
    pub(super) fn complex_sum_of_products(&mut self, products: &[SignedProduct<'_>]) -> Checked<SymbolicPolynomial> {
        let factors: Vec<_> =
            products.iter().map(|&(negative, p, q)| (negative, self.parts(p), self.parts(q))).collect();
        let mut sums = [Polynomial::ZERO, Polynomial::ZERO];
        for (part, sum) in sums.iter_mut().enumerate() {
            let pairs = factors.iter().flat_map(|(negative, p, q)| match part {
                0 => [(*negative, &p[0], &q[0]), (!negative, &p[1], &q[1])],
                _ => [(*negative, &p[0], &q[1]), (*negative, &p[1], &q[0])],
            });
            let pairs: Vec<_> = pairs.filter(|(_, p, q)| !p.is_zero() && !q.is_zero()).collect();
            *sum = self.sum_of_products(&pairs)?;
        }
        Ok(Self::join([&sums[0], &sums[1]]))
    }
}

/// A monomial without i.
fn without_unit(monomial: Monomial) -> Monomial {
    Monomial::from_exponents(&monomial.exponents()[..IMAGINARY_UNIT])
}

impl Interpreter<'_> {
    /// Makes room for i; fails where all places of a monomial are taken.
    pub(super) fn enter_complex_numbers(&mut self, at: Span) -> Outcome<()> {
        if self.unknowns.len() > IMAGINARY_UNIT {
            let diagnostic = Diagnostic::new("there is no room for complex numbers", at);
            let label = format!("at most {IMAGINARY_UNIT} unknowns are allowed with them");
            return Err(self.report(diagnostic.label(label)));
        }
        self.algebra.has_imaginary_unit = true;
        Ok(())
    }

    /// `complex(re, im)`: re + im i, element by element.
    pub(super) fn complex(&mut self, call: &ExprCall, arguments: &[&Expr], [re, im]: [&Value; 2]) -> Outcome<Value> {
        self.enter_complex_numbers(place(call))?;
        for (argument, value) in arguments.iter().zip([re, im]) {
            self.real(argument, value)?;
        }
        if re.shape() != im.shape() {
            let diagnostic = Diagnostic::new("real and imaginary part have different shapes", place(call));
            let label = format!("{} and {}", describe(re.shape()), describe(im.shape()));
            return Err(self.report(diagnostic.label(label)));
        }
        self.charge(re.weight() + im.weight(), call)?;
        let elements = re.elements().iter().zip(im.elements()).map(|(re, im)| Algebra::join([re, im]));
        Ok(Value::array(re.shape().to_vec(), elements.collect()))
    }

    /// `conj(z)`, element by element.
    pub(super) fn conjugate(&mut self, call: &ExprCall, z: &Value) -> Outcome<Value> {
        self.charge(z.weight(), call)?;
        let elements = z.elements().iter().map(|element| self.algebra.conjugate(element)).collect();
        Ok(Value::array(z.shape().to_vec(), elements))
    }

    /// `z.re` and `z.im`, element by element.
    pub(super) fn part_of(&mut self, field: &ExprField) -> Outcome<Value> {
        let part = match &field.member {
            Member::Named(name) if name == "re" => 0,
            Member::Named(name) if name == "im" => 1,
            _ => return Err(Reported),
        };
        let z = self.evaluate(&field.base)?;
        self.charge(z.weight(), field)?;
        let elements = z.elements().iter().map(|element| {
            let parts = self.algebra.parts(element);
            parts.into_iter().nth(part).unwrap_or(Polynomial::ZERO)
        });
        Ok(Value::array(z.shape().to_vec(), elements.collect()))
    }

    /// Refuses what holds i where a real value is meant.
    pub(super) fn real(&mut self, at: &Expr, value: &Value) -> Outcome<()> {
        if !self.algebra.is_complex_value(value) {
            return Ok(());
        }
        let diagnostic = Diagnostic::new("expected a real value", place(at)).label("this is complex");
        Err(self.report(diagnostic.hint("its parts are `.re` and `.im`, the square of its modulus `z * conj(z)`")))
    }

    /// A quotient with a real divisor: both multiplied by the conjugate of the divisor.
    pub(super) fn with_real_divisor(&mut self, left: Value, right: Value, at: &Expr) -> Outcome<(Value, Value)> {
        let Some(divisor) = right.as_scalar().filter(|divisor| self.algebra.is_complex(divisor)) else {
            return Ok((left, right));
        };
        let conjugate = Value::scalar(self.algebra.conjugate(divisor));
        let numerator = self.algebra.multiply(&left, &conjugate);
        let square = self.algebra.square_of_modulus(divisor);
        Ok((self.check(numerator, at)?, Value::scalar(self.check(square, at)?)))
    }

    /// The elements of a value, real and imaginary parts one after another, and the shape of these:
    /// for complex elements the last dimension is 2.
    pub(super) fn real_elements(&self, value: &Value) -> (Vec<usize>, Vec<SymbolicPolynomial>, bool) {
        if !self.algebra.is_complex_value(value) {
            return (value.shape().to_vec(), value.elements().to_vec(), false);
        }
        let elements = value.elements().iter().flat_map(|element| self.algebra.parts(element)).collect();
        ([value.shape(), &[2]].concat(), elements, true)
    }
}

/// A complex number of data or of unknowns from its real and its imaginary part, which are the
/// elements one after another.
pub(super) fn joined(elements: &[SymbolicPolynomial]) -> Vec<SymbolicPolynomial> {
    elements.chunks_exact(2).map(|pair| Algebra::join([&pair[0], &pair[1]])).collect()
}
