//! The Pareto front: the points that no other point beats in every coordinate.

/// For each point, whether it is on the front: no other point is at most as large in every
/// coordinate and smaller in one. Of equal points only the first is on the front.
pub fn front<const N: usize>(points: &[[f64; N]]) -> Vec<bool> {
    let beats = |a: &[f64; N], b: &[f64; N], is_earlier: bool| {
        let not_worse = a.iter().zip(b).all(|(a, b)| a <= b);
        not_worse && (is_earlier || a.iter().zip(b).any(|(a, b)| a < b))
    };
    let is_beaten = |at: usize| (0..points.len()).any(|by| by != at && beats(&points[by], &points[at], by < at));
    (0..points.len()).map(|at| !is_beaten(at)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_beaten_in_every_respect_is_left_out() {
        let points = [[1.0, 5.0], [2.0, 2.0], [5.0, 1.0], [2.0, 3.0], [3.0, 2.0], [6.0, 6.0]];
        assert_eq!(front(&points), [true, true, true, false, false, false]);
    }

    #[test]
    fn of_equal_points_the_first_stays() {
        assert_eq!(front(&[[1.0], [1.0], [f64::INFINITY]]), [true, false, false]);
        assert_eq!(front(&[[f64::INFINITY], [f64::INFINITY]]), [true, false]);
        assert!(front::<2>(&[]).is_empty());
    }
}
