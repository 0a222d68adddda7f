//! What a solver must state so that its instances can be computed side by side.

use crate::elimination::lu::Eliminated;
use crate::elimination::quotients::Quotients;
use crate::elimination::template::ActionRow;
use crate::error::SolveError;
use crate::number::{Arithmetic, Over};
use crate::size::{Element, Fixed, Matrix, Size};
use crate::solution::inequality::Inequality;
use crate::solution::symmetries::Symmetries;
use crate::solution::system::Monomials;
use crate::solver_instance::{HiddenVariableSolver, Point, Points, SizesOf, SolverInstance};

/// The sizes that instances side by side need besides [`SizesOf`].
#[derive(Clone, Copy, Debug)]
pub struct BatchSizes<I, C, T, R, E, K> {
    /// The number of all data.
    pub inputs: I,
    /// The number of coefficients.
    pub coefficients: C,
    /// The number of rows of the template.
    pub rows: T,
    /// The number of monomials that unknowns are read from besides.
    pub read: R,
    /// The number of equations.
    pub equations: E,
    /// The number of monomials of the equations.
    pub products: K,
}

impl<const I: usize, const C: usize, const T: usize, const R: usize, const E: usize, const K: usize>
    BatchSizes<Fixed<I>, Fixed<C>, Fixed<T>, Fixed<R>, Fixed<E>, Fixed<K>>
{
    /// All sizes, known to the compiler.
    pub const FIXED: Self =
        BatchSizes { inputs: Fixed, coefficients: Fixed, rows: Fixed, read: Fixed, equations: Fixed, products: Fixed };
}

/// The sizes of a solver.
pub type BatchSizesOf<I> = BatchSizes<
    <I as BatchSolver>::Inputs,
    <I as BatchSolver>::Coefficients,
    <I as BatchSolver>::Rows,
    <I as BatchSolver>::Read,
    <I as BatchSolver>::Equations,
    <I as BatchSolver>::Products,
>;

/// A solver whose instances can be computed side by side: with a determinant of at most three
/// chains, equations that are stored as a matrix, and no factor that must not vanish.
pub trait BatchSolver: HiddenVariableSolver + Sized {
    /// The number of all data.
    type Inputs: Size;
    /// The number of coefficients.
    type Coefficients: Size;
    /// The number of rows of the template.
    type Rows: Size;
    /// The number of monomials that unknowns are read from besides.
    type Read: Size;
    /// The number of equations.
    type Equations: Size;
    /// The number of monomials of the equations.
    type Products: Size;
    /// The monomials of the equations.
    type Monomials: Monomials<Self::Unknowns, Self::Products>;

    /// Where the rows of the action matrix come from.
    const ACTION: &'static [ActionRow];
    /// The pivots that unknowns are read from besides.
    const READ: &'static [u16];
    /// For each unknown, the positions of (m, x m) among the monomial values.
    const RATIOS: &'static [&'static [(u16, u16)]];
    /// The exponents of the action monomial; none if it is not one of the unknowns.
    const ACTION_MONOMIAL: &'static [i8];
    /// How unknowns follow from their ratios if the template determines them only up to signs
    /// and exchanges.
    const SYMMETRIES: Option<Symmetries<'static>>;
    /// What solutions must satisfy.
    const POSITIVE: &'static [Inequality<'static>] = &[];
    /// As [`SolverInstance::has_origin`].
    const HAS_ORIGIN: bool = false;
    /// Coefficients by which [`SolverInstance::has_large_quotients`] is known.
    const QUOTIENTS: Quotients<'static> = Quotients::NONE;

    /// All sizes.
    fn all_sizes() -> (SizesOf<Self>, BatchSizesOf<Self>);

    /// How the basis falls into chains.
    fn all_chains() -> Self::Chains;

    /// The monomials of the equations.
    fn monomials() -> Self::Monomials;

    /// The coefficients, from all data. `one` is 1.
    fn coefficients<T: Arithmetic>(
        one: T,
        data: &<Self::Inputs as Size>::Vector<T>,
    ) -> <Self::Coefficients as Size>::Vector<T>;

    /// The equations as a matrix.
    fn equations<T>(
        coefficients: &<Self::Coefficients as Size>::Vector<T>,
    ) -> &Matrix<Self::Products, Self::Equations, T>
    where
        T: Element;

    /// The basis columns of the solved template. `zero` is 0.
    ///
    /// # Errors
    /// As [`SolverInstance::action_matrix`].
    fn eliminated<T: Eliminated + Over<T>>(
        zero: T,
        coefficients: &<Self::Coefficients as Size>::Vector<T>,
    ) -> Result<Matrix<Self::Rows, Self::Basis, T>, SolveError>;

    /// Computes the unknowns that follow from those that were read.
    fn recovered<T: Arithmetic + Over<T>>(
        coefficients: &<Self::Coefficients as Size>::Vector<T>,
        unknowns: &mut <Self::Unknowns as Size>::Vector<T>,
    );
}

/// What a batch asks of the emitted solver: the data of an instance as a list, the solutions of an
/// instance by itself, and the result for a list of points.
pub trait BatchData<I: SolverInstance> {
    /// A list of solutions, or an error.
    type Result;
    /// All data of an instance, one parameter after another, and the exponents of the powers of two
    /// by which its unknowns are scaled with them. The lists may be longer.
    fn inputs(&self, write: &mut [f64], exponents: &mut [i16]);
    /// Solves one instance.
    fn solve(&self) -> Self::Result;
    /// The solutions for these points, which are scaled by powers of two.
    fn result(points: &Points<I, f64>, exponents: &Point<I, i16>) -> Self::Result;
}
