//! Left and right of a cylinder's axis.

use std::fmt;

use serde::Serialize;

/// A side of the axis as a camera sees it that looks at the axis from where it stands, the
/// direction `w` pointing up. So the left silhouettes of all cameras around a cylinder touch it in
/// the same sense of rotation, however the cameras are rolled.
#[derive(Clone, Copy, Debug, Eq, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Side {
    /// Left of the axis.
    Left,
    /// Right of the axis.
    Right,
}

impl fmt::Display for Side {
    fn fmt(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        text.write_str(match self {
            Self::Left => "left",
            Self::Right => "right",
        })
    }
}
