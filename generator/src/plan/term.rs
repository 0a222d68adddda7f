//! Terms of polynomials in the unknowns.

/// Position in the array of coefficients that the tables refer to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CoefficientId(pub u16);

/// A term of a polynomial in the unknowns: coefficient and exponent of each unknown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Term {
    /// The coefficient.
    pub coefficient: CoefficientId,
    /// One exponent per unknown, not negative.
    pub exponents: Vec<u8>,
}
