//! The positions of the values of monomials that unknowns are read from.

use super::{KnownMonomial, Plan};

/// The values that follow from an eigenpair (a, v), with R the rows of the read pivots:
///
/// ```text
///   [ v (basis) | a v (image, if an unknown is read from it) | R v (read) ]
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ValueLayout {
    /// |B|.
    pub basis: usize,
    /// Whether an unknown is read from the image of the basis.
    pub has_image: bool,
    /// The number of pivots that are read besides.
    pub read: usize,
}

impl ValueLayout {
    /// The layout of a plan.
    pub fn of(plan: &Plan) -> Self {
        let is_image = |monomial: &KnownMonomial| matches!(monomial, KnownMonomial::Image(_));
        let mut pairs = plan.extractions.iter().flat_map(|x| &x.pairs);
        let has_image = pairs.any(|(m, xm)| is_image(m) || is_image(xm));
        Self { basis: plan.elimination.basis, has_image, read: plan.read.len() }
    }

    /// The number of values.
    pub fn len(&self) -> usize {
        self.basis * (1 + usize::from(self.has_image)) + self.read
    }

    /// Whether there are no values. No plan has none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The position of a monomial's value.
    pub fn position(&self, monomial: KnownMonomial) -> u16 {
        let position = match monomial {
            KnownMonomial::Basis(b) => usize::from(b.0),
            KnownMonomial::Image(b) => self.basis + usize::from(b.0),
            KnownMonomial::Read(at) => self.basis * (1 + usize::from(self.has_image)) + usize::from(at),
        };
        position as u16
    }

    /// The pairs of positions of (m, s m) from which an unknown is read.
    pub fn ratios(&self, plan: &Plan, unknown: usize) -> Vec<(u16, u16)> {
        let extractions = plan.extractions.iter().filter(|x| x.unknown == unknown);
        extractions.flat_map(|x| &x.pairs).map(|&(m, xm)| (self.position(m), self.position(xm))).collect()
    }
}
