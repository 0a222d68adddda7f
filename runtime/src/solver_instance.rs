//! What differs between solvers.

use num_complex::Complex;

use crate::error::SolveError;
use crate::number::{Real, Scalar};
use crate::size::{Fixed, Size, Square};
use crate::solution::distinct::Candidate;
use crate::solution::sign_changes::SignChanges;

/// The sizes of a solver.
#[derive(Clone, Copy, Debug)]
pub struct Sizes<B, N, K, M> {
    /// |B|: basis monomials, which are the rows of the action matrix.
    pub basis: B,
    /// Unknowns.
    pub unknowns: N,
    /// Monomials whose values follow from an eigenpair.
    pub values: K,
    /// Complex solutions of general data, which are all that a solver returns.
    pub solutions: M,
}

impl<const B: usize, const N: usize, const K: usize, const M: usize> Sizes<Fixed<B>, Fixed<N>, Fixed<K>, Fixed<M>> {
    /// Sizes that the compiler knows.
    pub const FIXED: Self = Sizes { basis: Fixed, unknowns: Fixed, values: Fixed, solutions: Fixed };
}

/// The sizes of a solver instance.
pub type SizesOf<I> = Sizes<
    <I as SolverInstance>::Basis,
    <I as SolverInstance>::Unknowns,
    <I as SolverInstance>::Values,
    <I as SolverInstance>::Solutions,
>;

/// A number for each basis monomial.
pub type BasisVector<I, S> = <<I as SolverInstance>::Basis as Size>::Vector<S>;

/// A number for each unknown.
pub type Point<I, S> = <<I as SolverInstance>::Unknowns as Size>::Vector<S>;

/// The solutions that a solver returns.
pub type Points<I, S> = <<I as SolverInstance>::Solutions as Size>::List<Point<I, S>>;

/// Polished solutions.
pub(crate) type Found<I, S> =
    <<I as SolverInstance>::Solutions as Size>::List<Candidate<S, <I as SolverInstance>::Unknowns>>;

/// A problem with data and a template. Emitted solvers implement it with constant sizes, interpreted plans with sizes
/// known at run time; all that is computed from it is computed by one kernel.
pub trait SolverInstance {
    /// |B|.
    type Basis: Size;
    /// Number of unknowns.
    type Unknowns: Size;
    /// Number of monomials whose values follow from an eigenpair.
    type Values: Size;
    /// Number of solutions.
    type Solutions: Size;

    /// All sizes.
    fn sizes(&self) -> SizesOf<Self>
    where
        Self: Sized;

    /// For an unknown x the positions of (m, x m) among the monomial values; empty if
    /// [`SolverInstance::recover`] gives the unknown.
    fn ratios(&self, unknown: usize) -> &[(u16, u16)];

    /// Whether all unknowns 0 is a solution, whatever the data. It is known, and the eigenpairs need not give it.
    fn has_origin(&self) -> bool {
        false
    }

    /// How unknowns follow from their ratios if the template tells them up to sign.
    fn sign_changes(&self) -> Option<SignChanges<'_>> {
        None
    }

    /// Whether [`SolverInstance::action_matrix`] computes the coefficients in its own precision, too. A template that
    /// is singular to `f64` is then eliminated at twice the precision: exactly degenerate data are singular to both,
    /// and of data that are so up to rounding the solutions as they are result.
    fn has_precise_coefficients(&self) -> bool {
        false
    }

    /// The action matrix, |B| rows: T with a b = T b at every solution, b being the values of the basis and a that of
    /// the action monomial. What [`SolverInstance::monomial_values`] reads besides is kept.
    ///
    /// # Errors
    /// [`SolveError::Degenerate`] if the template is singular up to rounding, [`SolveError::Overflow`] if a number is
    /// not finite.
    fn action_matrix<R: Real>(&mut self) -> Result<Square<Self::Basis, R>, SolveError>;

    /// The values of the monomials that unknowns are read from, from an eigenpair: linear in the vector; those of the
    /// image are value times vector, and only those depend on the value.
    fn monomial_values<S: Scalar>(&self, value: S, vector: &BasisVector<Self, S>) -> <Self::Values as Size>::Vector<S>;

    /// Fills in the unknowns that follow from those that were read.
    fn recover<S: Scalar>(&self, unknowns: &mut Point<Self, S>);

    /// Polishes on the original equations by at most `steps` steps and returns the relative residual.
    fn polish<S: Scalar>(&self, unknowns: &mut Point<Self, S>, steps: usize) -> f64;

    /// Whether no factor that was stated to be nonzero vanishes.
    fn is_admissible<S: Scalar>(&self, unknowns: &Point<Self, S>) -> bool;
}

/// Where eigenvectors of the action matrix come from: for an eigenvalue that the source lists, the value of the action
/// monomial and an eigenvector.
pub(crate) trait EigenpairSource<B: Size> {
    /// The eigenpair of a real eigenvalue.
    fn real(&self, value: f64) -> (f64, B::Vector<f64>);
    /// The eigenpair of any eigenvalue.
    fn complex(&self, value: Complex<f64>) -> (Complex<f64>, B::Vector<Complex<f64>>);
}
