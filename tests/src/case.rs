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

/// `case!(name, Solution, (array, scalar: f64), (x, y))`; `()` for a problem without data.
macro_rules! case {
    ($name:ident, $solution:ident, ($($data:ident $(: $scalar:ty)?),*), ($($unknown:ident),*)) => {
        Case {
            name: stringify!($name),
            solve: |flat| {
                let mut _values = flat.iter().copied();
                $(let $data = FromFlat::take(&mut _values);)*
                let found = solvers::$name::solve($(argument!($data $(: $scalar)?)),*)?;
                Ok(found.iter().map(|s| vec![$(s.$unknown),*]).collect())
            },
            solve_complex: |flat| {
                let mut _values = flat.iter().copied();
                $(let $data = FromFlat::take(&mut _values);)*
                let found = solvers::$name::solve_complex($(argument!($data $(: $scalar)?)),*)?;
                Ok(found.iter().map(|s| vec![$(s.$unknown),*]).collect())
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
                let mut unknowns = point.iter().copied();
                $(let $unknown = unknowns.next().unwrap_or_default();)*
                solvers::$name::relative_residual($(argument!($data $(: $scalar)?),)* &solvers::$name::$solution { $($unknown),* })
            },
        }
    };
}

/// All emitted solvers. A test checks that none of `templates/` is missing.
pub fn cases() -> Vec<Case> {
    vec![
        case!(calibration_6_receivers_4_senders, Calibration6Receivers4Senders, (linear), (v, w, x, y, z)),
        case!(circle_least_squares, CircleLeastSquares, (gram), (d1, d2, d3, d4, d5, lambda1, lambda2)),
        case!(circle_least_squares_dual, CircleLeastSquaresDual, (gram), (d3, d4, d5)),
        case!(circle_minimal, CircleMinimal, (d_alpha, d_beta, d_gamma), (a, b)),
        case!(fundamental_8pt_radial, Fundamental8ptRadial, (affine), (radial, f_13, f_23)),
        case!(fundamental_8pt_radial_one_side, Fundamental8ptRadialOneSide, (affine), (f_32, radial)),
        case!(fundamental_9pt_two_radials, Fundamental9ptTwoRadials, (affine), (s, f_31, f_32, f_23)),
        case!(katsura_5, Katsura5, (), (t, u, v, x, y, z)),
        case!(orbit_5_lines_of_sight, Orbit5LinesOfSight, (sights), (a, b, p, q, r, square)),
        case!(
            platform_forward_kinematics,
            PlatformForwardKinematics,
            (sums, differences, shift, excess: f64, square: f64),
            (a, b, c)
        ),
        case!(pose_35pt_focal, Pose35ptFocal, (points, horizontal, vertical), (x, y)),
        case!(pose_3pt_depths, Pose3ptDepths, (cosines, squares), (a, b, c)),
        case!(pose_3pt_upright_error_bound, Pose3ptUprightErrorBound, (points, cones), (u, v, w, y, z)),
        case!(pose_4pt_focal_radial, Pose4ptFocalRadial, (row1, row2, row3), (w, radial, y, z)),
        case!(pose_4pt_focal_radial_cut, Pose4ptFocalRadialCut, (upper, lower), (radial, x, y, z)),
        case!(pose_4pt_generalized_scale, Pose4ptGeneralizedScale, (basis), (v, w, x, y, z)),
        case!(pose_4pt_upright_error_bound, Pose4ptUprightErrorBound, (points, cones), (u, v, w, y, z)),
        case!(pose_5pt_refraction, Pose5ptRefraction, (affine), (x, y, z)),
        case!(pose_5tdoa_two_receivers, Pose5tdoaTwoReceivers, (quadric, linear), (u, v, t)),
        case!(pose_6pt_rolling_shutter, Pose6ptRollingShutter, (image, points, position, velocity), (u, v, w, x, y, z)),
        case!(pose_npt_direct_least_squares, PoseNptDirectLeastSquares, (linear, quadratic, cubic, quartic), (x, y, z)),
        case!(pose_npt_least_squares_cayley, PoseNptLeastSquaresCayley, (cost), (x, y, z)),
        case!(pose_npt_least_squares_quaternion, PoseNptLeastSquaresQuaternion, (rows), (w, y, z)),
        case!(pose_npt_weak_perspective, PoseNptWeakPerspective, (spread, image), (w, square, y, z)),
        case!(relpose_3pt_angle_zero_screw, Relpose3ptAngleZeroScrew, (first, second, half_angle), (u, v, w)),
        case!(relpose_4pt_angle, Relpose4ptAngle, (first, second, half_angle), (u, v, w)),
        case!(relpose_5pt, Relpose5pt, (basis), (x, y, z)),
        case!(relpose_5pt_generalized_angle, Relpose5ptGeneralizedAngle, (first, second, half_angle), (u, v, w)),
        case!(
            relpose_5pt_semi_generalized_focal,
            Relpose5ptSemiGeneralizedFocal,
            (images, directions, centres),
            (x, y, c, s, depth)
        ),
        case!(relpose_6pt_focal, Relpose6ptFocal, (basis), (x, y, w)),
        case!(relpose_6pt_focal_one_side, Relpose6ptFocalOneSide, (basis), (x, y, w)),
        case!(relpose_6pt_generalized, Relpose6ptGeneralized, (first, second), (x, y, z)),
        case!(relpose_6pt_radial, Relpose6ptRadial, (affine, affine_e31), (e_13, e_32, e_23, radial)),
        case!(relpose_7pt_angle_focal_centre, Relpose7ptAngleFocalCentre, (left, right, half_angle), (x, y, z)),
        case!(relpose_7pt_focal_radial, Relpose7ptFocalRadial, (affine, affine_f31), (w, f_32, f_13, f_23, radial)),
        case!(relpose_7pt_focal_radial_one_side, Relpose7ptFocalRadialOneSide, (affine), (w, f_31, f_32, radial)),
        case!(
            relpose_7pt_focal_radial_one_side_eliminated,
            Relpose7ptFocalRadialOneSideEliminated,
            (affine),
            (f_13, f_23, radial)
        ),
        case!(relpose_7pt_generalized_scale, Relpose7ptGeneralizedScale, (first, second), (x, y, z)),
        case!(stitching_3pt_radial_focal, Stitching3ptRadialFocal, (first, second), (radial, w)),
        case!(tensor_eigenvectors, TensorEigenvectors, (a), (x, y, z)),
        case!(triangulation_3view, Triangulation3view, (first, second, third), (x, y, z)),
        case!(
            triangulation_3view_relaxed,
            Triangulation3viewRelaxed,
            (first, second, image),
            (x1, x2, x3, x4, x5, x6, x7, x8)
        ),
        case!(trilateration, Trilateration, (centres, distances), (x, y, z)),
        case!(two_conics, TwoConics, (p, q), (x, y)),
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
