//! The trait that tells one solver from another.

use num_complex::Complex;

use crate::continuation::family::Family;
use crate::error::SolveError;
use crate::memory::Memory;
use crate::number::{Real, Scalar};
use crate::size::{Fixed, Size, Square};
use crate::solution::distinct::Candidate;
use crate::solution::symmetries::Symmetries;
use crate::spectrum::hidden_variable::ChainedBasis;

/// The sizes of a solver.
#[derive(Clone, Copy, Debug)]
pub struct Sizes<B, N, K, M> {
    /// |B|: the number of basis monomials, which is the order of the action matrix.
    pub basis: B,
    /// The number of unknowns.
    pub unknowns: N,
    /// The number of monomials whose values follow from an eigenpair.
    pub values: K,
    /// The number of complex solutions of general data. A solver returns no more.
    pub solutions: M,
}

impl<const B: usize, const N: usize, const K: usize, const M: usize> Sizes<Fixed<B>, Fixed<N>, Fixed<K>, Fixed<M>> {
    /// All sizes, known to the compiler.
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

/// A problem with data and a template. Emitted solvers implement this trait with constant sizes,
/// interpreted plans with sizes known at run time. The same kernels compute everything else.
pub trait SolverInstance {
    /// |B|.
    type Basis: Size;
    /// The number of unknowns.
    type Unknowns: Size + 'static;
    /// The number of monomials whose values follow from an eigenpair.
    type Values: Size;
    /// The number of solutions.
    type Solutions: Size;

    /// All sizes.
    fn sizes(&self) -> SizesOf<Self>
    where
        Self: Sized;

    /// For an unknown x: the positions of (m, x m) among the monomial values. The list is empty if
    /// [`SolverInstance::recover`] computes the unknown.
    fn ratios(&self, unknown: usize) -> &[(u16, u16)];

    /// Whether there is a solution for all data at which all unknowns are 0 but those that
    /// [`SolverInstance::recover`] computes. It is then known beforehand, and no eigenpair needs to
    /// belong to it.
    fn has_origin(&self) -> bool {
        false
    }

    /// Whether solutions at which some unknown vanishes have no eigenpair: the action monomial is
    /// divided by it, so that the eigenvalue is infinite, or all basis monomials are multiples of
    /// it, so that the eigenvector is zero.
    fn loses_zeros(&self) -> bool {
        false
    }

    /// Whether, at a solution at which some unknown vanishes, another one may be the ratio of
    /// zeros.
    fn misreads_zeros(&self) -> bool {
        false
    }

    /// Whether some quotients of data that only the template has are far larger than all
    /// coefficients of the equations: presolve divided by a number close to zero. Solutions may be
    /// lost with the digits.
    fn has_large_quotients(&self) -> bool {
        false
    }

    /// The value of the action monomial at a solution; `None` if it is not one of the unknowns.
    fn action_value<S: Scalar>(&self, _unknowns: &Point<Self, S>) -> Option<S> {
        None
    }

    /// How unknowns follow from their ratios if the template determines them only up to signs
    /// and exchanges.
    fn symmetries(&self) -> Option<Symmetries<'_>> {
        None
    }

    /// Whether [`SolverInstance::action_matrix`] computes the coefficients in the precision of `R`,
    /// too. If so, a template that is singular in `f64` is eliminated again at twice the precision.
    /// Exactly degenerate data are singular in both precisions. Data that are degenerate up to
    /// rounding are solved as they are given.
    fn has_precise_coefficients(&self) -> bool {
        false
    }

    /// Whether a second attempt may be made.
    #[inline]
    fn allows_second_attempt(&self) -> bool {
        true
    }

    /// The memory that the matrices of a second attempt come from; without it they are on the
    /// stack, and |B| is at most 24.
    #[inline]
    fn memory(&self) -> Option<&Memory> {
        None
    }

    /// The action matrix T, |B| rows: a b = T b at every solution, where b are the values of the
    /// basis and a is the value of the action monomial. The solver keeps what
    /// [`SolverInstance::monomial_values`] reads besides.
    ///
    /// # Errors
    /// [`SolveError::Degenerate`] if the template is singular up to rounding,
    /// [`SolveError::Overflow`] if a number is not finite.
    fn action_matrix<R: Real>(&mut self) -> Result<Square<Self::Basis, R>, SolveError>;

    /// The values of the monomials from which unknowns are read. They are linear in the vector of
    /// the eigenpair. The values of the image are value times vector, and only they depend on the
    /// value.
    fn monomial_values<S: Scalar>(&self, value: S, vector: &BasisVector<Self, S>) -> <Self::Values as Size>::Vector<S>;

    /// Computes the unknowns that follow from those that were read.
    fn recover<S: Scalar>(&self, unknowns: &mut Point<Self, S>);

    /// Polishes on the original equations by at most `steps` steps and returns the relative
    /// residual.
    fn polish<S: Scalar>(&self, unknowns: &mut Point<Self, S>, steps: usize) -> f64;

    /// A bound on the error of a solution, relative to its largest unknown; infinity if no solution
    /// is known to be near, or the solver has no coefficients of twice the precision.
    fn error_bound<S: Scalar>(&self, unknowns: &Point<Self, S>) -> f64 {
        let _ = unknowns;
        f64::INFINITY
    }

    /// The problem as a family over its data, if solutions may be followed from other data to those
    /// for which the template is singular. Without it, such data are an error.
    #[inline]
    fn family(&self) -> Option<Family<'_>> {
        None
    }

    /// Replaces the data by others of the same family.
    #[inline]
    fn move_to(&mut self, data: &[f64]) {
        let _ = data;
    }

    /// Whether no factor vanishes that was stated to be nonzero.
    fn is_admissible<S: Scalar>(&self, unknowns: &Point<Self, S>) -> bool;
}

/// A solver whose real eigenvalues are the roots of the determinant of a small matrix of
/// polynomials. No eigenvalue is spurious: each belongs to a solution, or to several that differ by
/// signs.
pub trait HiddenVariableSolver: SolverInstance {
    /// How the basis falls into chains.
    type Chains: ChainedBasis<Basis = Self::Basis>;

    /// The chains.
    fn chains(&self) -> Self::Chains;
}

/// A source of eigenvectors of the action matrix. For an eigenvalue that the source lists it
/// returns the value of the action monomial and an eigenvector.
pub(crate) trait EigenpairSource<B: Size> {
    /// The eigenpair of a real eigenvalue.
    fn real(&self, value: f64) -> (f64, B::Vector<f64>);
    /// The eigenpair of any eigenvalue.
    fn complex(&self, value: Complex<f64>) -> (Complex<f64>, B::Vector<Complex<f64>>);
}
