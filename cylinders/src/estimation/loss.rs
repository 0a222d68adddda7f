//! The influence of lines on the refinement.

use super::refine_error::RefineError;

/// The cost of a line as a function of the root mean square `d` of the distances of its two support
/// points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Loss {
    /// `d^2`.
    Quadratic,
    /// `d^2` up to `scale`, `2 scale d - scale^2` beyond it: the influence of a line is bounded.
    Huber {
        /// Scale of the loss, in the unit of the metric.
        scale: f64,
    },
    /// `scale^2 ln(1 + d^2 / scale^2)`: the influence of a line vanishes with its distance.
    Cauchy {
        /// Scale of the loss, in the unit of the metric.
        scale: f64,
    },
}

impl Loss {
    /// Loss `rho` and weight `rho'` of the squared distance `square`.
    pub(super) fn value_and_weight(self, square: f64) -> (f64, f64) {
        match self {
            Self::Quadratic => (square, 1.0),
            Self::Huber { scale } if square <= scale * scale => (square, 1.0),
            Self::Huber { scale } => (2.0 * scale * square.sqrt() - scale * scale, scale / square.sqrt()),
            Self::Cauchy { scale } => {
                let ratio = square / (scale * scale);
                (scale * scale * ratio.ln_1p(), 1.0 / (1.0 + ratio))
            }
        }
    }

    pub(super) fn check(self) -> Result<(), RefineError> {
        match self {
            Self::Huber { scale } | Self::Cauchy { scale } if !(scale > 0.0 && scale.is_finite()) => {
                Err(RefineError::LossScale { scale })
            }
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_are_the_derivatives_of_losses() {
        for loss in [Loss::Quadratic, Loss::Huber { scale: 1.5 }, Loss::Cauchy { scale: 1.5 }] {
            for square in [0.0, 0.1, 2.0, 2.5, 40.0] {
                let (value, weight) = loss.value_and_weight(square);
                let step = 1e-6;
                let ahead = loss.value_and_weight(square + step).0;
                assert!(((ahead - value) / step - weight).abs() < 1e-5, "{loss:?} at {square}");
            }
        }
    }
}
