//! The bound on the distance between lines and silhouettes, where it is not given.
//!
//! The bound is not the noise, which is estimated. But noise near the bound loses matches, and a
//! bound far above the noise lets chance in. So the bound is doubled where nothing is found, or
//! where the matches fill it, and the cylinders that chance gives less often count:
//!
//! ```text
//!   root mean square of (angle between match and silhouette / bound):
//!     0.33  normal noise of a third of the bound          0.58  even within the bound
//! ```

use super::error::MatchError;
use super::found::Matching;
use super::options::MatchOptions;
use super::plan::threshold;
use super::several::evidence;
use crate::observations::view::View;

/// A bound that is so many times the default is wide enough for lines drawn by hand.
const WIDER: f64 = 2.0;

/// Matches fill a bound if the root mean square of their distances from the silhouettes is at least
/// this part of it.
const FILLED: f64 = 0.25;

/// Cylinders by any search with these options, or with a bound that is twice as wide if that has
/// more evidence. Returns the bound, too.
///
/// # Errors
/// [`MatchError`], as the search gives it.
pub fn match_with_wider_bound(
    views: &[View],
    options: &MatchOptions,
    search: impl Fn(&MatchOptions) -> Result<Matching, MatchError>,
) -> Result<(f64, Matching), MatchError> {
    let first = search(options);
    let is_enough = match &first {
        Ok(matching) => !fills(matching, views, options),
        Err(error) => !matches!(error, MatchError::NoCylinder { .. }),
    };
    if is_enough {
        return first.map(|matching| (options.threshold, matching));
    }
    let wider = MatchOptions { threshold: WIDER * options.threshold, ..*options };
    match (first, search(&wider)) {
        (Ok(first), Ok(second)) if evidence(&second) <= evidence(&first) => Ok((options.threshold, first)),
        (_, Ok(second)) => Ok((wider.threshold, second)),
        (_, Err(error @ MatchError::Interrupted(_))) => Err(error),
        (first, Err(_)) => first.map(|matching| (options.threshold, matching)),
    }
}

/// Whether the matches fill the bound.
fn fills(matching: &Matching, views: &[View], options: &MatchOptions) -> bool {
    let parts = matching.cylinders.iter().flat_map(|found| {
        found.matches.iter().filter_map(|line| {
            let camera = views[line.view].camera();
            let angle = line.distance / found.cylinder.vector_to_axis(&camera.centre()).norm();
            Some(angle / threshold(line.view, camera, options).ok()?)
        })
    });
    let (count, sum) = parts.fold((0_usize, 0.0), |(count, sum), part| (count + 1, sum + part * part));
    sum >= FILLED * FILLED * count as f64
}
