//! The intersection of two conics as a solver instance, with sizes of either kind.

use std::marker::PhantomData;

use eliminant::emitted::{
    ActionRow, Arithmetic, BasisVector, Block, BlockMemory, ChainTable, ChainedBasis, Dynamic, Entry, Fixed,
    HiddenVariableSolver, Matrix, Point, Product, Real, Size, Sizes, SizesOf, SolverInstance, Square, Tables, Vector,
    action_matrix, fill, filled_matrix, monomial_values, polish, solved_rows,
};
use eliminant::{Scalar, SolveError};

use super::conics::{MONOMIALS, terms};

/// Constant sizes or run-time sizes.
pub(crate) trait Family {
    type Of<const N: usize>: Size + 'static;
    fn of<const N: usize>() -> Self::Of<N>;
    /// Eliminates a block of N rows.
    fn eliminate<R: Real, V: Vector<R>, const N: usize>(
        block: &Block<'_>,
        right: &mut [V],
        coefficients: &[f64],
    ) -> Result<(), SolveError>;
}

/// Constant sizes, as in emitted solvers.
pub(crate) struct Constant;

impl Family for Constant {
    type Of<const N: usize> = Fixed<N>;
    fn of<const N: usize>() -> Fixed<N> {
        Fixed
    }
    fn eliminate<R: Real, V: Vector<R>, const N: usize>(
        block: &Block<'_>,
        right: &mut [V],
        coefficients: &[f64],
    ) -> Result<(), SolveError> {
        block.eliminate::<R, f64, V, N>(right, coefficients)
    }
}

/// Run-time sizes, as in interpreted plans.
pub(crate) struct RunTime;

impl Family for RunTime {
    type Of<const N: usize> = Dynamic;
    fn of<const N: usize>() -> Dynamic {
        Dynamic(N)
    }
    fn eliminate<R: Real, V: Vector<R>, const N: usize>(
        block: &Block<'_>,
        right: &mut [V],
        coefficients: &[f64],
    ) -> Result<(), SolveError> {
        let (matrix, row_scale, smallest) = (&mut vec![R::ZERO; N * N], &mut vec![0.0; N], &mut vec![0.0; N]);
        block.eliminate_in::<R, f64, V>(BlockMemory { matrix, row_scale, smallest }, right, coefficients)
    }
}

/// Two conics f1, f2 with the coefficients of 1, x, y, x^2, x y, y^2 each. Action x; basis 1, x, y,
/// x y.
///
/// ```text
///          x^2 y^2 | x^3 y^3 x y^2 x^2 y | 1 x y x y
///   f1      *   *  |                     | * * *  *
///   f2      *   *  |                     | * * *  *
///   x f1    *      |  *        *     *   |   *    *
///   x f2    *      |  *        *     *   |   *    *
///   y f1        *  |      *    *     *   |     *  *
///   y f2        *  |      *    *     *   |     *  *
/// ```
pub(crate) struct TwoConics<F: Family> {
    pub(crate) coefficients: [f64; 12],
    /// Whether x y^2 is read, too. Without it the monomials do not determine y on the space of all
    /// solutions.
    pub(crate) reads_all: bool,
    /// How often the action matrix was computed.
    pub(crate) calls: usize,
    chain: <F::Of<6> as Size>::Vector<Product>,
    ends: <F::Of<2> as Size>::Vector<u32>,
    /// y^2 and x y^2 as combinations of the basis.
    read: Matrix<F::Of<2>, F::Of<4>, f64>,
}

const BLOCKS: [Block<'static>; 2] = [
    Block { number: 0, first: 0, needed: 2, diagonal: &[(0, 0, 3), (0, 1, 5), (1, 0, 9), (1, 1, 11)], coupling: &[] },
    Block {
        number: 1,
        first: 2,
        needed: 2,
        diagonal: &[
            (0, 0, 3),
            (0, 2, 5),
            (0, 3, 4),
            (1, 0, 9),
            (1, 2, 11),
            (1, 3, 10),
            (2, 1, 5),
            (2, 2, 4),
            (2, 3, 3),
            (3, 1, 11),
            (3, 2, 10),
            (3, 3, 9),
        ],
        coupling: &[(0, 0, 1), (1, 0, 7), (2, 1, 2), (3, 1, 8)],
    },
];

/// The columns of the basis.
const RIGHT: [Entry; 16] = [
    (0, 0, 0),
    (0, 1, 1),
    (0, 2, 2),
    (0, 3, 4),
    (1, 0, 6),
    (1, 1, 7),
    (1, 2, 8),
    (1, 3, 10),
    (2, 1, 0),
    (2, 3, 2),
    (3, 1, 6),
    (3, 3, 8),
    (4, 2, 0),
    (4, 3, 1),
    (5, 2, 6),
    (5, 3, 7),
];

impl<F: Family> TwoConics<F> {
    pub(crate) fn new(coefficients: [f64; 12]) -> Self {
        let mut chain = F::of::<6>().filled(MONOMIALS[0]);
        chain.as_mut().copy_from_slice(&MONOMIALS);
        let mut ends = F::of::<2>().filled(0);
        ends.as_mut().copy_from_slice(&[6, 12]);
        let read = filled_matrix(F::of::<2>(), F::of::<4>(), 0.0);
        TwoConics { coefficients, reads_all: true, calls: 0, chain, ends, read }
    }
}

impl<F: Family> SolverInstance for TwoConics<F> {
    type Basis = F::Of<4>;
    type Unknowns = F::Of<2>;
    type Values = F::Of<10>;
    type Solutions = F::Of<4>;

    fn sizes(&self) -> SizesOf<Self> {
        Sizes { basis: F::of::<4>(), unknowns: F::of::<2>(), values: F::of::<10>(), solutions: F::of::<4>() }
    }

    /// Monomial values: 1, x, y, x y; the same times x; y^2, x y^2.
    fn ratios(&self, unknown: usize) -> &[(u16, u16)] {
        match (unknown, self.reads_all) {
            (0, _) => &[(0, 4), (1, 5), (2, 6), (3, 7)],
            (_, true) => &[(0, 2), (1, 3), (2, 8), (3, 9)],
            (_, false) => &[(0, 2), (1, 3), (2, 8)],
        }
    }

    fn has_precise_coefficients(&self) -> bool {
        true
    }

    fn action_matrix<R: Real>(&mut self) -> Result<Square<Self::Basis, R>, SolveError> {
        self.calls += 1;
        let mut right: [_; 6] = std::array::from_fn(|_| F::of::<4>().filled(R::ZERO));
        fill::<R, f64, _>(&mut right, &RIGHT, &self.coefficients);
        F::eliminate::<R, _, 2>(&BLOCKS[0], &mut right, &self.coefficients)?;
        F::eliminate::<R, _, 4>(&BLOCKS[1], &mut right, &self.coefficients)?;
        self.read = solved_rows((F::of::<2>(), F::of::<4>()), &[1, 4], &right);
        let rows = [ActionRow::Unit(1), ActionRow::Solved(0), ActionRow::Unit(3), ActionRow::Solved(5)];
        Ok(action_matrix(F::of::<4>(), &rows, &right))
    }

    fn monomial_values<S: Scalar>(&self, value: S, vector: &BasisVector<Self, S>) -> <Self::Values as Size>::Vector<S> {
        monomial_values(F::of::<10>(), (value, vector.as_ref()), true, self.read.as_ref())
    }

    fn recover<S: Scalar>(&self, _unknowns: &mut Point<Self, S>) {}

    fn polish<S: Scalar>(&self, unknowns: &mut Point<Self, S>, steps: usize) -> f64 {
        let sizes = (F::of::<2>(), F::of::<2>(), F::of::<6>());
        let tables = Tables { sizes, chain: &self.chain, ends: &self.ends, terms: &terms::<12>() };
        polish(unknowns, tables.polynomials(), &tables.bind(&self.coefficients), steps)
    }

    fn is_admissible<S: Scalar>(&self, _unknowns: &Point<Self, S>) -> bool {
        true
    }
}

impl<F: Family> HiddenVariableSolver for TwoConics<F> {
    type Chains = TwoChains<F>;

    fn chains(&self) -> TwoChains<F> {
        TwoChains(PhantomData)
    }
}

/// The chains 1, x and y, x y: M(x) is a matrix of quadratic polynomials.
pub(crate) struct TwoChains<F>(PhantomData<F>);

impl<F: Family> ChainedBasis for TwoChains<F> {
    type Basis = F::Of<4>;
    type Count = F::Of<2>;
    type Width = F::Of<6>;
    type Coefficients = F::Of<5>;

    fn sizes(&self) -> (F::Of<4>, F::Of<2>, F::Of<6>, F::Of<5>) {
        (F::of::<4>(), F::of::<2>(), F::of::<6>(), F::of::<5>())
    }

    fn table(&self) -> ChainTable<'_> {
        ChainTable { ends: &[1, 3], leading: &[2, 5], degrees: &[2, 2], heads: &[] }
    }

    fn polynomials<T: Arithmetic>(&self, row: &<F::Of<4> as Size>::Vector<T>) -> <F::Of<6> as Size>::Vector<T> {
        let mut polynomials = F::of::<6>().filled(row[0].constant(0.0));
        for (at, b) in [(0, 0), (1, 1), (3, 2), (4, 3)] {
            polynomials[at] = -row[b];
        }
        polynomials
    }

    fn determinant<T: Arithmetic>(&self, rows: &Matrix<F::Of<2>, F::Of<6>, T>) -> <F::Of<5> as Size>::Vector<T> {
        let mut sum = F::of::<5>().filled(rows[0][0].constant(0.0));
        for i in 0..3 {
            for j in 0..3 {
                sum[i + j] += rows[0][i] * rows[1][3 + j] - rows[0][3 + i] * rows[1][j];
            }
        }
        sum
    }

    fn row_at<T: Arithmetic>(&self, row: &<F::Of<6> as Size>::Vector<T>, x: T) -> <F::Of<2> as Size>::Vector<T> {
        let mut values = F::of::<2>().filled(x);
        for j in 0..2 {
            values[j] = row[3 * j] + x * (row[3 * j + 1] + x * row[3 * j + 2]);
        }
        values
    }

    fn vector<T: Arithmetic>(
        &self,
        x: T,
        heads: &<F::Of<2> as Size>::Vector<T>,
        _eliminated: &<F::Of<2> as Size>::Vector<T>,
    ) -> <F::Of<4> as Size>::Vector<T> {
        let mut vector = F::of::<4>().filled(heads[0]);
        vector[1] = heads[0] * x;
        vector[2] = heads[1];
        vector[3] = heads[1] * x;
        vector
    }
}
