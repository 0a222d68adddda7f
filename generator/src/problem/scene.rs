//! Scenes: how data come about from numbers that are drawn, and what is known of their solution.
//!
//! ```text
//!   #[scene]
//!   fn scene(points: [[f64; 3]; 3], #[rotation] rotation: [[f64; 3]; 3]) -> (Data, Pose) {
//!       let translation = [0, 0, 4];
//!       ..
//!       (Data { rays, points }, Pose { rotation, translation })
//!   }
//! ```
//!
//! The parameters are drawn as random data of a problem are. Random coefficients are what a search
//! needs; a scene is what the measurements of a user look like. It is no part of what a problem
//! states: no template depends on it.

use super::data::DataParameter;
use super::draw::draw_inputs;
use crate::algebra::Random;
use crate::expression::arithmetic::Float64;
use crate::expression::{ExpressionGraph, ExpressionId};

/// Scenes that are drawn in vain, one after another, before there is none.
const MAX_DRAWS: usize = 1000;

/// How a scene is drawn.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The name of its function.
    pub name: String,
    /// What is drawn.
    pub drawn: Vec<DataParameter>,
    /// The expressions in it.
    pub(super) graph: ExpressionGraph,
    /// The data of the problem, one parameter after another.
    pub(super) data: Vec<ExpressionId>,
    /// What is known of a solution.
    pub(super) truth: Truth,
    /// What must be positive; if it is not, another scene is drawn.
    pub(super) positive: Vec<ExpressionId>,
}

/// Scenes are the same if they draw the same and compute the same from it, by value.
impl PartialEq for Scene {
    fn eq(&self, other: &Self) -> bool {
        let kind = |scene: &Self| std::mem::discriminant(&scene.truth);
        self.drawn == other.drawn && kind(self) == kind(other) && self.values() == other.values()
    }
}

impl Eq for Scene {}

/// What is known of one solution, the fields one after another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Truth {
    Nothing,
    /// The unknowns; all elements of a vector that is given up to scale.
    Solution(Vec<ExpressionId>),
    /// What the problem returns beside them, `None` for fields of which the scene says nothing.
    Results(Vec<Option<ExpressionId>>),
}

/// Data of a problem with what is known of their solution.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnScene {
    /// One parameter after another, arrays row by row.
    pub data: Vec<f64>,
    /// A solution: all its fields, if the scene says them.
    pub solution: Option<Vec<f64>>,
    /// What the problem returns for a solution: all fields, if the scene says some of them.
    pub results: Option<Vec<Option<f64>>>,
}

impl Scene {
    /// Whether it says what solves it, or what the problem returns for that.
    pub fn has_truth(&self) -> bool {
        self.truth != Truth::Nothing
    }

    /// Whether it says the values of all unknowns.
    pub fn states_solution(&self) -> bool {
        matches!(self.truth, Truth::Solution(_))
    }

    /// The values of all its expressions at two points.
    fn values(&self) -> Vec<[u32; 2]> {
        [&self.data[..], &self.known(), &self.positive].concat().iter().map(|&id| self.graph.fingerprint(id)).collect()
    }

    /// What is known of the solution.
    fn known(&self) -> Vec<ExpressionId> {
        match &self.truth {
            Truth::Nothing => Vec::new(),
            Truth::Solution(ids) => ids.clone(),
            Truth::Results(ids) => ids.iter().flatten().copied().collect(),
        }
    }

    /// A scene at random; `None` if its inequalities hold for none of a thousand, or its
    /// expressions have no value.
    pub fn draw(&self, random: &mut Random) -> Option<DrawnScene> {
        (0..MAX_DRAWS).find_map(|_| {
            let values = self.graph.try_evaluate(Float64, &draw_inputs(&self.drawn, Float64, random)).ok()?;
            let of = |ids: &[ExpressionId]| ids.iter().map(|id| values[id.index()]).collect::<Vec<f64>>();
            let (solution, results) = match &self.truth {
                Truth::Nothing => (None, None),
                Truth::Solution(ids) => (Some(of(ids)), None),
                Truth::Results(ids) => (None, Some(ids.iter().map(|id| Some(values[(*id)?.index()])).collect())),
            };
            let (known, positive) = (of(&self.known()), of(&self.positive));
            let scene = DrawnScene { data: of(&self.data), solution, results };
            let is_finite = scene.data.iter().chain(&known).all(|x| x.is_finite());
            (is_finite && positive.iter().all(|&x| x > 0.0)).then_some(scene)
        })
    }
}
