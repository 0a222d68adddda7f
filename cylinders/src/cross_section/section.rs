//! Step 3: the cross-section. Every method from tangent lines to a conic implements one trait, so
//! that all can be exchanged and compared.
//!
//! The tangents `l = (a, b, c)` of a conic are the zeros of its *dual conic*, scaled here so that
//! `d6 = -1`:
//!
//! ```text
//!   l^T C* l = 0        [ d1 d2 d3 ]
//!                  C* = [ d2 d4 d5 ],    centre (-d3, -d5),    M = [ d1 + d3^2    d2 + d3 d5 ]
//!                       [ d3 d5 -1 ]                               [ d2 + d3 d5   d4 + d5^2  ]
//! ```
//!
//! With a unit normal `n` and the distance `h` of the centre from the line,
//! `l^T C* l = n^T M n - h^2`. So `M` is `r^2 I` for a circle, positive definite for an ellipse
//! (eigenvalues: the squared semi-axes), indefinite for a hyperbola.

use nalgebra::{Matrix2, Matrix3, Point2};
use thiserror::Error;

use super::circle::{Circle, CircleError};
use super::rectify::TangentLine;

/// Largest accepted deviation of the length of a normal from one: the rounding of single precision
/// input, with a margin.
const UNIT: f64 = 1e-6;

/// A tangent line of the cross-section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionLine {
    /// The line, its normal of unit length.
    pub line: TangentLine,
    /// Weight of the squared residual of the line, zero or positive. Only ratios matter. Methods
    /// that fit exactly do not use it.
    pub weight: f64,
    /// Index of the view in which the line was seen: the method of Navab pairs the lines of a view.
    pub view: usize,
}

/// What kind of conic a section is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SectionShape {
    /// A circle by construction.
    Circle(Circle),
    /// A real ellipse: `M` is positive definite.
    Ellipse {
        /// Semi-axes, descending, world units.
        semi_axes: [f64; 2],
    },
    /// A hyperbola: `M` is indefinite.
    Hyperbola,
    /// A conic without real points: `M` is negative definite.
    Imaginary,
    /// A line segment or a point: `M` is singular up to rounding.
    Degenerate,
}

/// A conic found from tangent lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// Dual conic `C*`, symmetric, scaled so that `d6 = -1`; world units.
    pub dual_conic: Matrix3<f64>,
    /// What kind of conic it is.
    pub shape: SectionShape,
    /// Weighted mean of `(l^T C* l)^2` over the lines, for a circle of `(r^2 - h^2)^2`; fourth
    /// power of the world unit.
    pub cost: f64,
}

/// Why there is no section.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum SectionError {
    /// Fewer lines than the method needs.
    #[error("{lines} line(s) of positive weight given; this method needs at least {least}")]
    TooFewLines {
        /// Number of lines of positive weight.
        lines: usize,
        /// Least number of lines of the method.
        least: usize,
    },
    /// More lines than the method can use.
    #[error("{lines} lines given; this method takes exactly {most}")]
    TooManyLines {
        /// Number of lines.
        lines: usize,
        /// Number of lines that the method takes.
        most: usize,
    },
    /// A coordinate of a line is NaN or infinite, or its normal is not of unit length.
    #[error("line {line} has a coordinate that is not finite, or a normal that is not of unit length")]
    BadLine {
        /// Index of the line.
        line: usize,
    },
    /// A weight is negative, NaN or infinite.
    #[error("the weight of line {line} is negative or not finite")]
    BadWeight {
        /// Index of the line.
        line: usize,
    },
    /// A view with more than two lines, for a method that pairs the lines of a view.
    #[error("view {view} has {lines} lines; this method takes the two silhouettes of each view")]
    NotAPair {
        /// The view.
        view: usize,
        /// Number of its lines.
        lines: usize,
    },
    /// Fewer than two views with two lines of positive weight, for a method that pairs the lines of
    /// a view.
    #[error("{pairs} view(s) with two lines given; this method needs at least two")]
    TooFewPairs {
        /// Number of views with two lines.
        pairs: usize,
    },
    /// More than one conic fits the lines exactly, for example if lines are repeated.
    #[error("more than one conic touches all lines: too few of them are distinct")]
    NotUnique,
    /// The centre of the conic is at infinity: a parabola.
    #[error("the conic found is a parabola: its centre is at infinity")]
    CentreAtInfinity,
    /// A singular value decomposition that did not converge.
    #[error("the singular values of the lines could not be computed")]
    NoDecomposition,
    /// The lines determine no circle.
    #[error(transparent)]
    Circle(#[from] CircleError),
}

/// A method that finds the cross-section from tangent lines.
pub trait SectionSolver: Send + Sync {
    /// Short name for tables and command lines, such as `least-squares`.
    fn name(&self) -> &'static str;

    /// Least number of lines of positive weight.
    fn least_lines(&self) -> usize;

    /// All sections that the method finds, at least one. They are ordered by cost, or by radius if
    /// all fit exactly.
    ///
    /// # Errors
    /// [`SectionError`].
    fn solve(&self, lines: &[SectionLine]) -> Result<Vec<Section>, SectionError>;
}

impl Section {
    /// A circle and its cost on the lines.
    pub fn from_circle(circle: Circle, lines: &[SectionLine]) -> Self {
        let Point2 { coords: centre } = circle.centre;
        let square = circle.radius * circle.radius;
        let mut dual_conic = Matrix3::zeros();
        dual_conic
            .fixed_view_mut::<2, 2>(0, 0)
            .copy_from(&(Matrix2::identity() * square - centre * centre.transpose()));
        dual_conic.fixed_view_mut::<2, 1>(0, 2).copy_from(&-centre);
        dual_conic.fixed_view_mut::<1, 2>(2, 0).copy_from(&-centre.transpose());
        dual_conic[(2, 2)] = -1.0;
        // The product keeps the digits of r^2 - h^2 if the line nearly touches; l^T C* l would lose
        // them.
        let residual = |line: &TangentLine| {
            let distance = line.distance(&circle.centre).abs();
            (circle.radius - distance) * (circle.radius + distance)
        };
        Self { dual_conic, shape: SectionShape::Circle(circle), cost: weighted_mean_square(lines, residual) }
    }

    /// Centre of the conic, world units.
    pub fn centre(&self) -> Point2<f64> {
        Point2::new(-self.dual_conic[(0, 2)], -self.dual_conic[(1, 2)])
    }

    /// The circle. For an ellipse it is the circle nearest to its tangents: it has the same centre,
    /// and its squared radius is the mean of the squared semi-axes, which is the mean of `n^T M n`
    /// over all directions. `None` for the other shapes.
    pub fn circle(&self) -> Option<Circle> {
        match self.shape {
            SectionShape::Circle(circle) => Some(circle),
            SectionShape::Ellipse { semi_axes: [long, short] } => {
                Some(Circle { centre: self.centre(), radius: long.hypot(short) * std::f64::consts::FRAC_1_SQRT_2 })
            }
            SectionShape::Hyperbola | SectionShape::Imaginary | SectionShape::Degenerate => None,
        }
    }
}

/// Checks what every method requires: finite lines with normals of unit length and no negative
/// weights, at least `least` of them with a positive weight.
pub(crate) fn check_lines(lines: &[SectionLine], least: usize) -> Result<(), SectionError> {
    for (index, SectionLine { line, weight, .. }) in lines.iter().enumerate() {
        // False if a coordinate is NaN.
        let unit = (line.normal.norm() - 1.0).abs() <= UNIT;
        if !unit || !line.offset.is_finite() {
            return Err(SectionError::BadLine { line: index });
        }
        if !weight.is_finite() || *weight < 0.0 {
            return Err(SectionError::BadWeight { line: index });
        }
    }
    let used = lines.iter().filter(|line| line.weight > 0.0).count();
    if used < least {
        return Err(SectionError::TooFewLines { lines: used, least });
    }
    Ok(())
}

/// The three lines of a method that takes exactly three.
pub(crate) fn three_lines(lines: &[SectionLine]) -> Result<[TangentLine; 3], SectionError> {
    check_lines(lines, 3)?;
    match lines {
        [first, second, third] => Ok([first.line, second.line, third.line]),
        _ => Err(SectionError::TooManyLines { lines: lines.len(), most: 3 }),
    }
}

/// Weighted mean of the squares of a residual.
pub(crate) fn weighted_mean_square(lines: &[SectionLine], residual: impl Fn(&TangentLine) -> f64) -> f64 {
    let sum: f64 = lines.iter().map(|line| line.weight * residual(&line.line).powi(2)).sum();
    sum / lines.iter().map(|line| line.weight).sum::<f64>()
}
