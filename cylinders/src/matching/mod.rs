//! Matching without correspondences: unlabelled lines of several images to all cylinders of one
//! direction or of several, and their silhouettes (Gummeson & Oskarsson, "Robust and Accurate
//! Cylinder Triangulation", the experiment on unknown matches).
//!
//! ```text
//!   lines --> without those of edges that are fixed in space
//!   two lines, of one image or of near ones, + one line of another image
//!     --> circle in front of the cameras --> support: lines of all images near its silhouettes,
//!         at two thresholds at which lines are sparse
//!     --> best circles, fitted at growing thresholds --> false alarms, over all scales of noise
//!     --> the circle that is the least likely by chance; its lines are taken away --> next one
//! ```
//!
//! The search draws no random numbers. It tries all pairs of lines of each image, or those of every
//! second, third, ... image if there are many. One model is scored in time linear in the number of
//! lines `N`. All models of one pair are bounded together in `O(N)` (`pair`), so that only few of
//! them need to be scored.

/// Flat bands, which are no cylinders.
mod band;
/// The bound on the distance between lines and silhouettes, where it is not given.
mod bound;
/// Cylinders along a direction that is only supposed.
mod candidate;
/// Support by chance, and the support that chance does not reach.
mod chance;
/// Candidates of the directions of the axes.
mod directions;
/// Edges in space, which are no silhouettes.
mod edges;
/// Why nothing can be matched.
mod error;
/// The cylinders that were found.
mod found;
/// How much a circle stands out from chance.
mod judge;
/// A circle with its matches, and its cylinder.
mod model;
/// Which silhouettes of a circle others hide.
mod occlusion;
/// Options of the search for cylinders.
mod options;
/// Pairs of silhouettes of one image: all circles that they and another line determine, and the
/// best of them.
mod pair;
/// Cameras and lines in the cross-section; the lines near the silhouettes of a circle.
mod plan;
/// The likelihood ratio of a circle and random lines, and how often chance reaches it.
mod ratio;
/// The cylinders refined on their matches.
mod refined;
/// Extraction of cylinders one after the other, the least likely by chance first.
mod search;
/// A part of the lines of some views.
pub(crate) mod selection;
/// Cylinders of several directions.
mod several;

pub use bound::match_with_wider_bound;
pub use candidate::match_candidate_with;
pub use directions::candidate_directions;
pub use error::MatchError;
pub use found::{MatchedCylinder, Matching};
#[cfg(feature = "command")]
pub(crate) use options::THRESHOLD_PIXELS;
pub use options::{MatchOptions, References};
pub use refined::{RefinedMatch, refined_matches};
pub(crate) use search::MOST_FALSE_ALARMS;
pub use search::{Progress, match_cylinders, match_cylinders_with};
pub use several::{match_directions, match_directions_with};
