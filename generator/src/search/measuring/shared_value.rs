//! Solutions that share a value of the action monomial, in the interpreted solver: what the run-time library does, in
//! complex arithmetic. Its `shared_value` says how and why.

use nalgebra::{Complex, DMatrix, DVector};

use super::SchurForm;
use crate::plan::{Extraction, KnownMonomial};

/// Eigenvalues this close, relative to their modulus, may be one.
const NEAR: f64 = 1e-3;
/// Eigenvalues this close, relative to the norm of the matrix, may be one.
const NEAR_TO_NORM: f64 = 1e-10;
/// The shift's distance from a cluster, relative to the distance of the next eigenvalue.
const SHIFT: f64 = 1e-3;
/// Rounds of inverse iteration.
const ROUNDS: usize = 6;
/// Singular values below this, relative to the largest, are rounding errors.
const RANK: f64 = 1e-5;

type Matrix = DMatrix<Complex<f64>>;
type Eigenpair = (Complex<f64>, DVector<Complex<f64>>);

/// Eigenpairs of solutions whose eigenvalues are nearly equal, told apart by the unknowns that are read. `read` gives
/// further monomials as combinations of the basis.
pub(super) fn eigenpairs(
    action: &Matrix,
    read: &Matrix,
    extractions: &[Extraction],
    values: &DVector<Complex<f64>>,
) -> Vec<Eigenpair> {
    let clusters = clusters(values, action.norm());
    clusters.iter().filter_map(|cluster| separate(action, read, extractions, values, cluster)).flatten().collect()
}

/// Groups of at least two eigenvalues, by their positions.
fn clusters(values: &DVector<Complex<f64>>, norm: f64) -> Vec<Vec<usize>> {
    let mut clusters: Vec<Vec<usize>> = Vec::new();
    for (at, value) in values.iter().enumerate() {
        let near = |&other: &usize| {
            let size = value.norm().max(values[other].norm());
            (value - values[other]).norm() <= NEAR * size + NEAR_TO_NORM * norm
        };
        let (joined, apart): (Vec<_>, Vec<_>) = clusters.into_iter().partition(|cluster| cluster.iter().any(near));
        clusters = apart;
        clusters.push(joined.into_iter().flatten().chain([at]).collect());
    }
    clusters.retain(|cluster| cluster.len() > 1);
    clusters
}

fn separate(
    action: &Matrix,
    read: &Matrix,
    extractions: &[Extraction],
    values: &DVector<Complex<f64>>,
    cluster: &[usize],
) -> Option<Vec<Eigenpair>> {
    let basis = invariant_subspace(action, values, cluster)?;
    let (image, read) = (action * &basis, read * &basis);
    let row = |monomial: &KnownMonomial| match monomial {
        KnownMonomial::Basis(b) => basis.row(usize::from(b.0)).into_owned(),
        KnownMonomial::Image(b) => image.row(usize::from(b.0)).into_owned(),
        KnownMonomial::Read(at) => read.row(usize::from(*at)).into_owned(),
    };
    let mut combination = Matrix::zeros(cluster.len(), cluster.len());
    let mut weight = 1.0;
    for extraction in extractions {
        let rows =
            |monomials: Vec<&KnownMonomial>| Matrix::from_rows(&monomials.into_iter().map(row).collect::<Vec<_>>());
        let (m, xm) = extraction.pairs.iter().map(|(m, xm)| (m, xm)).unzip();
        let svd = rows(m).svd(true, true);
        if svd.rank(RANK * svd.singular_values.max()) < cluster.len() {
            continue;
        }
        let matrix = svd.solve(&rows(xm), 0.0).ok()?;
        combination += &matrix * Complex::from(weight / matrix.norm().max(f64::MIN_POSITIVE));
        weight *= 0.786_151_377_757_423_3;
    }
    let schur = SchurForm::new(&combination)?;
    let lifted = |&value: &Complex<f64>| {
        let vector = &basis * schur.vector(value)?;
        let quotient = vector.dotc(&(action * &vector)) / vector.norm_squared();
        Some((quotient, vector))
    };
    Some(schur.values().iter().filter_map(lifted).collect())
}

/// An orthonormal basis by block inverse iteration.
fn invariant_subspace(action: &Matrix, values: &DVector<Complex<f64>>, cluster: &[usize]) -> Option<Matrix> {
    let centre = cluster.iter().map(|&at| values[at]).sum::<Complex<f64>>() / cluster.len() as f64;
    let distance = |at: usize| (values[at] - centre).norm();
    let radius = cluster.iter().map(|&at| distance(at)).fold(0.0, f64::max);
    let gap = (0..values.len()).filter(|at| !cluster.contains(at)).map(distance).fold(action.norm(), f64::min);
    let n = action.nrows();
    let shift = centre + Complex::new(0.0, (SHIFT * gap).max(2.0 * radius).max(f64::MIN_POSITIVE));
    let lu = (action - Matrix::from_diagonal_element(n, n, shift)).lu();
    let start = |i: usize, j: usize| Complex::from((1.0 + (i * i + 3 * i * j + 7 * j) as f64).sqrt().fract() - 0.5);
    let mut basis = Matrix::from_fn(n, cluster.len(), start);
    for _ in 0..ROUNDS {
        basis = lu.solve(&basis)?.qr().q();
    }
    basis.iter().all(|x| x.re.is_finite() && x.im.is_finite()).then_some(basis)
}
