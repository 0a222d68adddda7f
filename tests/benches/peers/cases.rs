//! What is compared: the instances, our side, and which peer has the same task.

use std::hint::black_box;
use std::time::Instant;

use eliminant_generator::algebra::Random;

use crate::ours::{Instance, absolute_pose, circles, generalized, quadrics, relative_pose};
use crate::scenes::{self, Scene};

/// How many numbers of a solution are compared together.
#[derive(Clone, Copy)]
pub(crate) enum Part {
    /// By their relative error.
    Plain(usize),
    /// Up to a common factor.
    Projective(usize),
}

impl Part {
    fn length(self) -> usize {
        match self {
            Self::Plain(length) | Self::Projective(length) => length,
        }
    }
}

/// One row of the table.
pub(crate) struct Case {
    /// What the table calls it.
    pub(crate) title: &'static str,
    /// The name by which drivers know the task.
    pub(crate) name: &'static str,
    /// Which driver: `poselib` or `circles`.
    pub(crate) driver: &'static str,
    /// What a solution consists of.
    pub(crate) parts: &'static [Part],
    /// Draws an instance.
    pub(crate) draw: fn(&mut Random) -> Scene,
    /// Our side, with these instances.
    pub(crate) ours: fn(&[Scene]) -> Box<dyn Side>,
    /// How the two sides differ in what they do.
    pub(crate) note: &'static str,
}

/// One side with its instances.
pub(crate) trait Side {
    /// Nanoseconds for all of `count` instances from `first` on.
    fn time(&mut self, first: usize, count: usize) -> f64;
    /// All solutions of an instance, one after the other.
    fn solutions(&mut self, index: usize) -> Vec<f64>;
}

struct Ours<I> {
    instances: Vec<I>,
    found: Vec<f64>,
}

impl<I: Instance> Side for Ours<I> {
    fn time(&mut self, first: usize, count: usize) -> f64 {
        let start = Instant::now();
        for instance in &self.instances[first..first + count] {
            self.found.clear();
            black_box(instance).solve(&mut self.found);
            black_box(&self.found);
        }
        start.elapsed().as_secs_f64() * 1e9
    }

    fn solutions(&mut self, index: usize) -> Vec<f64> {
        self.found.clear();
        self.instances[index].solve(&mut self.found);
        self.found.clone()
    }
}

fn ours<I: Instance + 'static>(scenes: &[Scene]) -> Box<dyn Side> {
    let instances: Vec<I> = scenes.iter().map(|scene| I::load(&scene.data)).collect();
    Box::new(Ours { instances, found: Vec::with_capacity(1024) })
}

impl Case {
    /// The error of the solution that is nearest to the truth; infinite if there is none.
    pub(crate) fn error(&self, solutions: &[f64], truth: &[f64]) -> f64 {
        let length = self.parts.iter().map(|part| part.length()).sum();
        solutions.chunks_exact(length).map(|solution| self.error_of(solution, truth)).fold(f64::INFINITY, f64::min)
    }

    fn error_of(&self, solution: &[f64], truth: &[f64]) -> f64 {
        let mut at = 0;
        let error = |part: &Part| {
            let range = at..at + part.length();
            at = range.end;
            let (solution, truth) = (&solution[range.clone()], &truth[range]);
            match part {
                Part::Plain(_) => eliminant_tests::ground_truth::relative_error(solution, truth),
                Part::Projective(_) => eliminant_tests::ground_truth::projective_error(solution, truth),
            }
        };
        // A value that is not a number is no solution.
        let errors: Vec<f64> = self.parts.iter().map(error).collect();
        if errors.iter().any(|error| error.is_nan()) {
            return f64::INFINITY;
        }
        errors.into_iter().fold(0.0, f64::max)
    }
}

const POSE: &[Part] = &[Part::Plain(9), Part::Plain(3)];
const POSE_AND_SCALAR: &[Part] = &[Part::Plain(9), Part::Plain(3), Part::Plain(1)];
const CIRCLE: &[Part] = &[Part::Plain(3)];

/// All rows, in the order of the table.
pub(crate) fn cases() -> Vec<Case> {
    vec![
        Case {
            title: "circle, least squares, 20 lines",
            name: "circle_least_squares",
            driver: "circles",
            parts: CIRCLE,
            draw: scenes::twenty_tangents,
            ours: ours::<circles::LeastSquares>,
            note: "ours moves the origin to the lines, theirs takes them as they are; ours without the cost",
        },
        Case {
            title: "circle, least squares, 20 normalised lines",
            name: "circle_least_squares",
            driver: "circles",
            parts: CIRCLE,
            draw: scenes::twenty_normalised_tangents,
            ours: ours::<circles::LeastSquares>,
            note: "both get the lines with their nearest point as the origin, and scaled",
        },
        Case {
            title: "circle, minimal, 3 lines",
            name: "circle_minimal",
            driver: "circles",
            parts: CIRCLE,
            draw: scenes::three_tangents,
            ours: ours::<circles::Minimal>,
            note: "",
        },
        Case {
            title: "circle, closed form, through its trait",
            name: "circle_minimal",
            driver: "circles",
            parts: CIRCLE,
            draw: scenes::three_tangents,
            ours: ours::<circles::ClosedFormTrait>,
            note: "ours validates lines and computes conic and cost; theirs is the minimal solver",
        },
        Case {
            title: "five-point, points to E",
            name: "relpose_5pt",
            driver: "poselib",
            parts: &[Part::Projective(9)],
            draw: scenes::five_points,
            ours: ours::<relative_pose::FivePoint>,
            note: "",
        },
        Case {
            title: "six-point shared focal, points to poses",
            name: "relpose_6pt_focal",
            driver: "poselib",
            parts: POSE_AND_SCALAR,
            draw: scenes::six_points_focal,
            ours: ours::<relative_pose::SixPointFocal>,
            note: "",
        },
        Case {
            title: "3.5-point focal, points to poses",
            name: "pose_35pt_focal",
            driver: "poselib",
            parts: POSE_AND_SCALAR,
            draw: scenes::four_points_focal,
            ours: ours::<absolute_pose::ThreeAndAHalfPoint>,
            note: "",
        },
        Case {
            title: "shared radial distortion, points to F",
            name: "fundamental_8pt_radial",
            driver: "poselib",
            parts: &[Part::Projective(9), Part::Plain(1)],
            draw: scenes::nine_points_radial,
            ours: ours::<relative_pose::RadialEightPoint>,
            note: "kFk takes nine points and no determinant, ours the minimal eight",
        },
        Case {
            title: "generalised six-point, rays to poses",
            name: "relpose_6pt_generalized",
            driver: "poselib",
            parts: POSE,
            draw: scenes::six_points_generalized,
            ours: ours::<generalized::SixPoint>,
            note: "ours without a check of depths",
        },
        Case {
            title: "generalised pose and scale, points to poses",
            name: "pose_4pt_generalized_scale",
            driver: "poselib",
            parts: POSE_AND_SCALAR,
            draw: scenes::four_points_scale,
            ours: ours::<generalized::PoseScale>,
            note: "both return the solution that fits the eighth equation best",
        },
        Case {
            title: "three quadrics (re3q3)",
            name: "three_quadrics",
            driver: "poselib",
            parts: &[Part::Plain(3)],
            draw: scenes::quadrics,
            ours: ours::<quadrics::ThreeQuadrics>,
            note: "",
        },
        Case {
            title: "P3P, points to poses",
            name: "pose_3pt",
            driver: "poselib",
            parts: POSE,
            draw: scenes::three_points,
            ours: ours::<absolute_pose::ThreePoint>,
            note: "",
        },
    ]
}
