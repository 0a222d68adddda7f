//! Two images of a scene to the pose of one camera relative to the other.
//!
//! [`estimate()`] takes pixels of corresponding points and the intrinsics of both cameras. The loop
//! is that of the crate `inlier`; the solver in it is Eliminant's `relpose_5pt_rays`. Its parts:
//!
//! ```text
//!   five pairs ──► solver ──► score, points in front ──► local optimisation ──► end?
//!     of rays       (minimal)    (Sampson, truncated)       (least squares)
//! ```
//!
//! The pose of the loop is then refined for the noise that its inliers show.

pub mod estimate;
pub mod input;
pub mod noise;
pub mod pose;
pub mod refine;
pub mod samples;
pub mod scene;
pub mod score;

pub use estimate::{Estimate, EstimateError, Options, estimate};
pub use input::{Camera, Pair};
pub use pose::Pose;
