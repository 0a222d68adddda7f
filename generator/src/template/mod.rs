//! Elimination templates: the multiples of the equations to stack, and the monomials to eliminate.
//!
//! ```text
//!                     excess E   reducible R = aB \ B   basis B
//!                   +----------+----------------------+---------+
//! shift m1 * f1     |          |                      |         |
//! shift m2 * f1     |       M_ER (square, invertible) |   M_B   |     rows = |E| + |R|
//! ...               |          |                      |         |
//!                   +----------+----------------------+---------+
//! ```
//!
//! After elimination every monomial of E and R is a combination of B: (E; R) = -M_ER^-1 M_B B. The
//! rows of R, and unit rows for those a b that are in B themselves, are the matrix of
//! multiplication by the action monomial a: T B = a B at every solution.

pub mod file;
pub mod shift_matrix;
pub mod verify;

use crate::algebra::{Monomial, Polynomial};

/// The polynomial `multiplier * equation`: one row of a template.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Shift {
    /// Index of the equation in the presolved problem.
    pub equation: usize,
    /// The monomial by which the equation is multiplied.
    pub multiplier: Monomial,
}

impl Shift {
    /// The monomials of the row, in the order of the equation's terms.
    pub fn monomials<'a, C>(&self, equations: &'a [Polynomial<C>]) -> impl Iterator<Item = Monomial> + use<'a, C> {
        let multiplier = self.multiplier;
        equations[self.equation].monomials().map(move |m| m.times(&multiplier))
    }
}

/// An elimination template, drawn at the top of this module.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct EliminationTemplate {
    /// The rows; there are |E| + |R|.
    pub shifts: Vec<Shift>,
    /// The action monomial a; it may be a Laurent monomial such as 1/x.
    pub action: Monomial,
    /// The excess columns E.
    pub excess: Vec<Monomial>,
    /// The reducible columns R = aB \ B, and monomials that are expressed in B only so that an
    /// unknown can be read from them.
    pub reducible: Vec<Monomial>,
    /// The basis columns B. At each solution up to sign changes their values are an eigenvector;
    /// there may be more eigenvectors than solutions.
    pub basis: Vec<Monomial>,
}

impl EliminationTemplate {
    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.shifts.len()
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.excess.len() + self.reducible.len() + self.basis.len()
    }

    /// The reducible monomials that are no product of the action monomial and a basis monomial:
    /// unknowns are read from them.
    pub fn extra(&self) -> Vec<Monomial> {
        let is_image = |m: &Monomial| self.basis.contains(&m.over(&self.action));
        self.reducible.iter().filter(|m| !is_image(m)).copied().collect()
    }

    /// The template times a monomial, such that the least exponent of each unknown in its rows and
    /// columns is 0. `equations` are those that are shifted.
    ///
    /// Templates that differ by a monomial are the same, except at solutions where it vanishes.
    #[must_use]
    pub fn in_lowest_terms<C>(mut self, equations: &[Polynomial<C>]) -> Self {
        let of_rows = |shift: &Shift| {
            let multiplier = shift.multiplier;
            equations[shift.equation].monomials().map(move |m| m.times(&multiplier))
        };
        let columns = [&self.excess, &self.reducible, &self.basis].into_iter().flatten().copied();
        let least = self.shifts.iter().flat_map(of_rows).chain(columns).reduce(|a, b| a.gcd(&b));
        let least = least.unwrap_or(Monomial::ONE);
        let columns = [&mut self.excess, &mut self.reducible, &mut self.basis].into_iter().flatten();
        let multipliers = self.shifts.iter_mut().map(|shift| &mut shift.multiplier);
        columns.chain(multipliers).for_each(|monomial| *monomial = monomial.over(&least));
        self
    }
}

/// How the real roots are found. Complex roots are always eigenvalues.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RootMethod {
    /// QR iteration on the Hessenberg form.
    Eigenvalues,
    /// Real roots of the determinant of a matrix of polynomials in the action monomial, one row and
    /// column per chain of the basis.
    Determinant,
}

impl RootMethod {
    /// The name in template files and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Eigenvalues => "eigenvalues",
            Self::Determinant => "determinant",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lowest_terms_are_the_same_for_all_multiples() {
        let monomial = |x, y| Monomial::from_exponents(&[x, y]);
        // x^2 + y + 1 = 0 times y and x y, with action x.
        let equations = [Polynomial::from_terms(vec![(monomial(2, 0), 1), (monomial(0, 1), 1), (Monomial::ONE, 1)])];
        let times = |factor: Monomial| {
            let all = |list: &[Monomial]| list.iter().map(|m| m.times(&factor)).collect::<Vec<Monomial>>();
            let shift = |m: Monomial| Shift { equation: 0, multiplier: m.times(&factor) };
            EliminationTemplate {
                shifts: vec![shift(monomial(0, 1)), shift(monomial(1, 1))],
                action: monomial(1, 0),
                excess: all(&[monomial(3, 1)]),
                reducible: all(&[monomial(2, 1)]),
                basis: all(&[monomial(1, 2), monomial(1, 1), monomial(0, 2), monomial(0, 1)]),
            }
        };
        let lowest = times(monomial(0, -1));
        for factor in [monomial(0, 0), monomial(3, 2), monomial(-2, -5), monomial(0, -1)] {
            assert_eq!(times(factor).in_lowest_terms(&equations), lowest);
        }
    }
}
