//! Left and right of a cylinder's axis.

use std::fmt;

use serde::Serialize;

/// A side of the axis as seen from the camera centre, if the camera looks at the axis and the
/// direction `w` points up. The left silhouettes of all cameras around a cylinder therefore touch
/// it in the same sense of rotation, however the cameras are rolled.
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
