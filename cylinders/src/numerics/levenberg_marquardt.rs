//! Levenberg-Marquardt for nonlinear least squares on a manifold of a few dimensions, whose number
//! the compiler may know or not.
//!
//! A step `d` from the state `x` solves `(H + lambda D) d = -g` with the normal matrix
//! `H = J^T W J`, its diagonal `D` (Marquardt) and `g = J^T W e`. The damping `lambda` follows the
//! ratio of actual to predicted gain (Nielsen, "Damping parameter in Marquardt's method", 1999).

use nalgebra::allocator::Allocator;
use nalgebra::{DefaultAllocator, Dim, OMatrix, OVector};

/// Initial damping, relative to the diagonal of the normal matrix.
const DAMPING: f64 = 1e-4;

/// The optimum is reached if the predicted gain, relative to the cost, is at most this.
const GAIN: f64 = 1e-15;

/// The optimum is reached if the largest entry of a step is at most this: rounding, for parameters
/// of order one.
const STEP: f64 = 1e-15;

/// A least squares problem over `D` local parameters of order one.
pub(crate) trait LeastSquares<D: Dim>
where
    DefaultAllocator: Allocator<D> + Allocator<D, D>,
{
    /// A point of the manifold.
    type State: Clone;
    /// Why a point has no cost.
    type Error;

    /// Whether the next step may be taken: not if the work is interrupted.
    ///
    /// # Errors
    /// That with which the iteration ends.
    fn check(&self) -> Result<(), Self::Error> {
        Ok(())
    }

    /// Cost and its quadratic model about a point.
    ///
    /// # Errors
    /// Fails if the cost is not defined; a step to such a point is shortened.
    fn linearise(&self, state: &Self::State) -> Result<Linearised<D>, Self::Error>;

    /// The point that a step in the local parameters reaches.
    fn moved(&self, state: &Self::State, step: &OVector<f64, D>) -> Self::State;
}

/// `cost(d) = cost + 2 g^T d + d^T H d`.
#[derive(Clone, Debug)]
pub(crate) struct Linearised<D: Dim>
where
    DefaultAllocator: Allocator<D> + Allocator<D, D>,
{
    pub(crate) cost: f64,
    /// Half of the gradient, `g = J^T W e`.
    pub(crate) gradient: OVector<f64, D>,
    /// `H = J^T W J`.
    pub(crate) normal_matrix: OMatrix<f64, D, D>,
}

/// The state in which the iteration ended.
#[derive(Clone, Debug)]
pub(crate) struct Optimum<S> {
    pub(crate) state: S,
    /// Number of steps tried.
    pub(crate) iterations: usize,
    /// Whether the gain or the step fell below rounding, before the limit.
    pub(crate) converged: bool,
}

/// Minimises from a starting point in at most `limit` trial steps. The cost of the result is at
/// most that of the start.
///
/// # Errors
/// Fails if the cost of the start is not defined, if the cost decreases towards points at which it
/// is not defined, or if the problem does not allow a step.
pub(crate) fn minimise<P: LeastSquares<D>, D: Dim>(
    problem: &P,
    start: P::State,
    limit: usize,
) -> Result<Optimum<P::State>, P::Error>
where
    DefaultAllocator: Allocator<D> + Allocator<D, D>,
{
    let mut linearised = problem.linearise(&start)?;
    let mut state = start;
    let (mut damping, mut growth) = (DAMPING, 2.0);
    let mut blocked = None;
    for iterations in 0..limit {
        problem.check()?;
        let Linearised { cost, gradient, normal_matrix } = &linearised;
        let mut damped = normal_matrix.clone();
        for index in 0..gradient.len() {
            // A parameter without influence keeps its value.
            let entry = normal_matrix[(index, index)];
            damped[(index, index)] += damping * if entry > 0.0 { entry } else { 1.0 };
        }
        let step = damped.cholesky().map(|factor| -factor.solve(gradient));
        // Rounding may make a singular matrix indefinite; more damping repairs that.
        let Some(step) = step else {
            (damping, growth) = (damping * growth, growth * 2.0);
            continue;
        };
        let predicted = -2.0 * gradient.dot(&step) - (normal_matrix * &step).dot(&step);
        if step.amax() <= STEP || predicted <= GAIN * cost {
            return match blocked {
                Some(error) => Err(error),
                None => Ok(Optimum { state, iterations, converged: true }),
            };
        }
        let moved = problem.moved(&state, &step);
        let trial = problem.linearise(&moved);
        match trial {
            Ok(trial) if trial.cost < *cost => {
                let ratio = (cost - trial.cost) / predicted;
                damping *= (1.0 - (2.0 * ratio - 1.0).powi(3)).max(1.0 / 3.0);
                growth = 2.0;
                (state, linearised, blocked) = (moved, trial, None);
            }
            trial => {
                blocked = trial.err();
                (damping, growth) = (damping * growth, growth * 2.0);
            }
        }
    }
    match blocked {
        Some(error) => Err(error),
        None => Ok(Optimum { state, iterations: limit, converged: false }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix2, U2, Vector2};

    /// Rosenbrock's valley, `e = (10 (y - x^2), 1 - x)`, defined for `x < limit`.
    struct Rosenbrock {
        limit: f64,
    }

    impl LeastSquares<U2> for Rosenbrock {
        type State = Vector2<f64>;
        type Error = f64;

        fn linearise(&self, state: &Vector2<f64>) -> Result<Linearised<U2>, f64> {
            if state.x >= self.limit {
                return Err(state.x);
            }
            let residual = Vector2::new(10.0 * (state.y - state.x * state.x), 1.0 - state.x);
            let jacobian = Matrix2::new(-20.0 * state.x, 10.0, -1.0, 0.0);
            Ok(Linearised {
                cost: residual.norm_squared(),
                gradient: jacobian.tr_mul(&residual),
                normal_matrix: jacobian.tr_mul(&jacobian),
            })
        }

        fn moved(&self, state: &Vector2<f64>, step: &Vector2<f64>) -> Vector2<f64> {
            state + step
        }
    }

    #[test]
    fn a_curved_valley() {
        let optimum = minimise(&Rosenbrock { limit: 2.0 }, Vector2::new(-1.2, 1.0), 100).expect("a minimum");
        assert!(optimum.converged && optimum.iterations < 60, "{optimum:?}");
        assert!((optimum.state - Vector2::new(1.0, 1.0)).norm() < 1e-12, "{optimum:?}");
    }

    #[test]
    fn a_limit_on_the_steps() {
        let problem = Rosenbrock { limit: 2.0 };
        let optimum = minimise(&problem, Vector2::new(-1.2, 1.0), 10).expect("a state");
        assert!(!optimum.converged && optimum.iterations == 10);
        let cost = |state: &Vector2<f64>| problem.linearise(state).expect("a cost").cost;
        assert!(cost(&optimum.state) < cost(&Vector2::new(-1.2, 1.0)));
    }

    #[test]
    fn a_minimum_behind_the_border() {
        let error = minimise(&Rosenbrock { limit: 0.5 }, Vector2::new(-1.2, 1.0), 1000).expect_err("no minimum inside");
        assert!(error >= 0.5);
        assert!(minimise(&Rosenbrock { limit: -2.0 }, Vector2::new(-1.2, 1.0), 100).is_err(), "no cost at the start");
    }
}
