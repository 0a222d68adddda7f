//! What becomes of the known solution of a scene, where its data have structure.

use eliminant_generator::algebra::Random;
use eliminant_generator::problem::Problem;
use rayon::prelude::*;

use crate::Case;
use crate::equations::Equations;
use crate::ground_truth::{FOUND, KnownInstance, Maker};
use crate::measure::affordable;
use crate::statistics::complex;

/// Scenes of each kind and problem, if they are affordable.
const SCENES: u64 = 1_000;
/// The same where all are known to be lost, or turn out to be undetermined: these take all attempts
/// of a solver.
pub const FEW_SCENES: u64 = 40;
/// Operations for the scenes of one kind and problem.
const WORK: u64 = 400_000_000;
/// The part of the scenes of which the true solution may be missing.
const LOST: f64 = 3e-3;
/// The smallest singular value of the scaled Jacobian at which a solution counts as isolated. For
/// some scenes solutions fill curves, such as focal lengths where optical axes are parallel.
const ISOLATED: f64 = 1e-8;
/// The exact solution of the rounded data may be so far from the truth.
const KNOWN: f64 = 1e-8;
/// Unknowns this large are infinite but for the rounding of data.
const INFINITE: f64 = 1e12;

/// How many scenes of each kind are solved of a problem.
pub fn scenes_of(case: &Case) -> u64 {
    affordable(&case.planned().plan, SCENES, WORK)
}

/// What became of the truth of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It was found.
    Found,
    /// It was not found, though it is an isolated solution, or it is infinite.
    Lost,
    /// It is not isolated, or not known to the digits that the claim is about.
    Undetermined,
}

impl Fate {
    /// Solves an instance of the problem.
    fn of(maker: &Maker, case: &Case, problem: &Problem, instance: &KnownInstance) -> Self {
        let found = (case.solve)(&instance.data).unwrap_or_default();
        let is_found =
            |truth: &&Vec<f64>| found.iter().any(|solution| (maker.error)(&instance.data, solution, truth) <= FOUND);
        let missing: Vec<&Vec<f64>> = instance.truths.iter().filter(|truth| !is_found(truth)).collect();
        if missing.is_empty() {
            return Self::Found;
        }
        if missing.iter().any(|truth| truth.iter().any(|x| !x.is_finite() || x.abs() > INFINITE)) {
            return Self::Lost;
        }
        let Some(equations) = Equations::new(problem, &instance.data) else { return Self::Undetermined };
        let is_determined = |truth: &&Vec<f64>| {
            let size = truth.iter().map(|x| x * x).sum::<f64>().sqrt();
            let exact = equations.refined(&complex(truth));
            exact.is_solution()
                && exact.moved <= KNOWN
                && equations.smallest_singular_value(&exact.point, &vec![size; truth.len()]) > ISOLATED
        };
        if missing.iter().any(is_determined) { Self::Lost } else { Self::Undetermined }
    }
}

/// The numbers of scenes of one kind with each fate.
#[derive(Clone, Copy, Debug)]
pub struct Fates {
    /// Those with [`Fate::Found`].
    pub found: usize,
    /// Those with [`Fate::Lost`].
    pub lost: usize,
    /// Those with [`Fate::Undetermined`].
    pub undetermined: usize,
}

impl Fates {
    /// Solves so many scenes, which are drawn with different seeds. If the truth of none of the
    /// first ones is determined, these tell of what kind they are.
    pub fn of(maker: &Maker, case: &Case, scenes: u64, draw: impl Fn(&mut Random) -> KnownInstance + Sync) -> Self {
        let problem = case.problem();
        let fate = |k| Fate::of(maker, case, &problem, &draw(&mut Random::new(31_000_000 + k)));
        let first = Self::count((0..scenes.min(FEW_SCENES)).into_par_iter().map(fate).collect());
        if first.undetermined == first.scenes() {
            return first;
        }
        let others = Self::count((FEW_SCENES..scenes).into_par_iter().map(fate).collect());
        Self {
            found: first.found + others.found,
            lost: first.lost + others.lost,
            undetermined: first.undetermined + others.undetermined,
        }
    }

    fn count(fates: Vec<Fate>) -> Self {
        let count = |wanted| fates.iter().filter(|fate| **fate == wanted).count();
        Self { found: count(Fate::Found), lost: count(Fate::Lost), undetermined: count(Fate::Undetermined) }
    }

    /// The number of scenes.
    pub fn scenes(self) -> usize {
        self.found + self.lost + self.undetermined
    }

    /// Whether more truths are lost than chance has it.
    pub fn loses(self) -> bool {
        self.loses_more_than(LOST)
    }

    /// Whether more than this part of the truths are lost.
    pub fn loses_more_than(self, part: f64) -> bool {
        self.lost as f64 > part * self.scenes() as f64
    }

    /// Whether the truth of most scenes is no isolated solution.
    pub fn is_degenerate(self) -> bool {
        2 * self.undetermined > self.scenes()
    }
}
