//! The emitted solvers behind function pointers on flat data, with the problems and plans they came from.

use std::path::PathBuf;

use eliminant::{Complex, SolveError};
use eliminant_generator::generate::{Planned, plan};
use eliminant_generator::problem::Problem;
use eliminant_generator::template::file::TemplateFile;
use eliminant_solvers as solvers;

/// Solutions as lists of unknowns.
pub type Found<T> = Result<Vec<Vec<T>>, SolveError>;

/// The relative residual of a complex solution for given data.
pub type Residual = fn(&[f64], &[Complex<f64>]) -> Result<f64, SolveError>;

/// One emitted solver. Data are flat, parameters one after another, arrays row by row.
#[derive(Clone, Copy)]
pub struct Case {
    /// Name of the problem.
    pub name: &'static str,
    /// `solve`.
    pub solve: fn(&[f64]) -> Found<f64>,
    /// `solve_complex`.
    pub solve_complex: fn(&[f64]) -> Found<Complex<f64>>,
    /// `action_matrix`.
    pub action_matrix: fn(&[f64]) -> Found<f64>,
    /// `relative_residual` of a complex solution.
    pub residual: Residual,
}

/// Arrays of any depth from their flat values.
trait FromFlat {
    fn take(values: &mut impl Iterator<Item = f64>) -> Self;
}

impl FromFlat for f64 {
    fn take(values: &mut impl Iterator<Item = f64>) -> Self {
        values.next().unwrap_or(f64::NAN)
    }
}

impl<T: FromFlat, const N: usize> FromFlat for [T; N] {
    fn take(values: &mut impl Iterator<Item = f64>) -> Self {
        std::array::from_fn(|_| T::take(values))
    }
}

/// Solvers take arrays by reference and scalars by value.
macro_rules! argument {
    ($data:ident) => {
        &$data
    };
    ($data:ident: $scalar:ty) => {
        $data
    };
}

/// `case!(name, (array, scalar: f64))`; `()` for a problem without data.
macro_rules! case {
    ($name:ident, ($($data:ident $(: $scalar:ty)?),*)) => {
        Case {
            name: stringify!($name),
            solve: |flat| {
                let mut _values = flat.iter().copied();
                $(let $data = FromFlat::take(&mut _values);)*
                let found = solvers::$name::solve($(argument!($data $(: $scalar)?)),*)?;
                Ok(found.iter().map(|s| s.to_array().to_vec()).collect())
            },
            solve_complex: |flat| {
                let mut _values = flat.iter().copied();
                $(let $data = FromFlat::take(&mut _values);)*
                let found = solvers::$name::solve_complex($(argument!($data $(: $scalar)?)),*)?;
                Ok(found.iter().map(|s| s.to_array().to_vec()).collect())
            },
            action_matrix: |flat| {
                let mut _values = flat.iter().copied();
                $(let $data = FromFlat::take(&mut _values);)*
                let action = solvers::$name::action_matrix($(argument!($data $(: $scalar)?)),*)?;
                Ok(action.iter().map(|row| row.to_vec()).collect())
            },
            residual: |flat, point| {
                let mut _values = flat.iter().copied();
                $(let $data = FromFlat::take(&mut _values);)*
                let mut unknowns = [Complex::default(); solvers::$name::UNKNOWNS.len()];
                unknowns.iter_mut().zip(point).for_each(|(unknown, &value)| *unknown = value);
                solvers::$name::relative_residual($(argument!($data $(: $scalar)?),)* &unknowns.into())
            },
        }
    };
}

/// All emitted solvers. A test checks that none of `templates/` is missing.
pub fn cases() -> Vec<Case> {
    vec![
        case!(calibration_6_receivers_4_senders, (linear)),
        case!(circle_least_squares, (gram)),
        case!(circle_least_squares_dual, (gram)),
        case!(circle_minimal, (d_alpha, d_beta, d_gamma)),
        case!(fundamental_8pt_radial, (affine)),
        case!(fundamental_8pt_radial_one_side, (affine)),
        case!(fundamental_9pt_two_radials, (affine)),
        case!(katsura_5, ()),
        case!(orbit_5_lines_of_sight, (sights)),
        case!(platform_forward_kinematics, (sums, differences, shift, excess: f64, square: f64)),
        case!(pose_35pt_focal, (points, horizontal, vertical)),
        case!(pose_3pt_depths, (cosines, squares)),
        case!(pose_3pt_upright_error_bound, (points, cones)),
        case!(pose_4pt_focal_radial, (row1, row2, row3)),
        case!(pose_4pt_focal_radial_cut, (upper, lower)),
        case!(pose_4pt_generalized_scale, (basis)),
        case!(pose_4pt_upright_error_bound, (points, cones)),
        case!(pose_5pt_refraction, (affine)),
        case!(pose_5tdoa_two_receivers, (quadric, linear)),
        case!(pose_6pt_rolling_shutter, (image, points, position, velocity)),
        case!(pose_npt_direct_least_squares, (linear, quadratic, cubic, quartic)),
        case!(pose_npt_least_squares_cayley, (cost)),
        case!(pose_npt_least_squares_quaternion, (rows)),
        case!(pose_npt_weak_perspective, (spread, image)),
        case!(relpose_3pt_angle_zero_screw, (first, second, half_angle)),
        case!(relpose_4pt_angle, (first, second, half_angle)),
        case!(relpose_5pt, (basis)),
        case!(relpose_5pt_generalized_angle, (first, second, half_angle)),
        case!(relpose_5pt_semi_generalized_focal, (images, directions, centres)),
        case!(relpose_6pt_focal, (basis)),
        case!(relpose_6pt_focal_one_side, (basis)),
        case!(relpose_6pt_generalized, (first, second)),
        case!(relpose_6pt_radial, (affine, affine_e31)),
        case!(relpose_7pt_angle_focal_centre, (left, right, half_angle)),
        case!(relpose_7pt_focal_radial, (affine, affine_f31)),
        case!(relpose_7pt_focal_radial_one_side, (affine)),
        case!(relpose_7pt_focal_radial_one_side_eliminated, (affine)),
        case!(relpose_7pt_generalized_scale, (first, second)),
        case!(stitching_3pt_radial_focal, (first, second)),
        case!(tensor_eigenvectors, (a)),
        case!(triangulation_3view, (first, second, third)),
        case!(triangulation_3view_relaxed, (first, second, image)),
        case!(trilateration, (centres, distances)),
        case!(two_conics, (p, q)),
    ]
}

/// The folder with problems and templates.
pub fn templates_folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../templates")
}

impl Case {
    /// The problem.
    ///
    /// # Panics
    /// Where the committed file cannot be read: this is for tests.
    pub fn problem(&self) -> Problem {
        let path = templates_folder().join(format!("{}.rs", self.name));
        let text = std::fs::read_to_string(&path).expect("the problem file is committed");
        Problem::parse(&path.display().to_string(), &text).unwrap_or_else(|messages| panic!("{}", messages.render()))
    }

    /// The template file.
    ///
    /// # Panics
    /// As [`Case::problem`].
    pub fn template(&self) -> TemplateFile {
        let path = templates_folder().join(format!("{}.template.toml", self.name));
        let text = std::fs::read_to_string(&path).expect("the template file is committed");
        TemplateFile::parse(&text, &self.problem().unknowns).unwrap_or_else(|error| panic!("{error}"))
    }

    /// The plan that the solver was emitted from.
    ///
    /// # Panics
    /// As [`Case::problem`].
    pub fn planned(&self) -> Planned {
        plan(&self.problem(), &self.template()).unwrap_or_else(|error| panic!("{error}"))
    }
}
