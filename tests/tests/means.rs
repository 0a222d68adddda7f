//! Data that are means over measurements.

use eliminant::SolveError;
use eliminant_generator::algebra::Random;
use eliminant_solvers::{circle_least_squares, circle_least_squares_dual, pose_npt_least_squares_quaternion};
use eliminant_tests::ground_truth::{Circle, gram};

#[test]
fn the_mean_over_lines_is_their_gram_matrix() {
    let mut random = Random::new(81_000_000);
    for count in [1, 2, 7, 100] {
        let lines = Circle::draw(&mut random).tangents(&mut random, count);
        let coordinates: Vec<[f64; 3]> = lines.iter().map(|line| [line.normal.x, line.normal.y, line.offset]).collect();
        let mean = circle_least_squares::mean_of_line(&coordinates);
        let expected: Vec<f64> = gram(&lines).iter().map(|sum| sum / count as f64).collect();
        let error = mean.as_flattened().iter().zip(&expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        assert!(error <= 1e-14 * size, "{error} of {size}");
        assert_eq!(mean, circle_least_squares_dual::mean_of_line(coordinates));
    }
}

/// The cost d^T G d of a circle, d = (d1, 2 d2, 2 d3, d4, 2 d5, -1), and the sum of the moduli of
/// its terms.
fn cost_of(gram: &[[f64; 6]; 6], [x, y]: [f64; 2], squared_radius: f64) -> (f64, f64) {
    let d = [squared_radius - x * x, -2.0 * x * y, -2.0 * x, squared_radius - y * y, -2.0 * y, -1.0];
    let terms = (0..6).flat_map(|i| (0..6).map(move |j| d[i] * gram[i][j] * d[j]));
    terms.fold((0.0, 0.0), |(sum, moduli), term| (sum + term, moduli + term.abs()))
}

/// Every stationary point has the cost of its circle, and the circle that touches all lines is one,
/// with a cost of zero.
#[test]
fn circles_come_from_any_number_of_lines() {
    for count in [5, 20, 100] {
        let mut random = Random::new(82_000_000 + count as u64);
        let circle = Circle::draw(&mut random);
        let lines = circle.tangents(&mut random, count);
        let lines: Vec<[f64; 3]> = lines.iter().map(|line| [line.normal.x, line.normal.y, line.offset]).collect();
        let gram = circle_least_squares::mean_of_line(&lines);
        let check = |found: &[([f64; 2], f64, f64)]| {
            let mut touching = 0;
            for &(centre, squared_radius, cost) in found {
                let (expected, terms) = cost_of(&gram, centre, squared_radius);
                assert!((cost - expected).abs() < 1e-13 * terms, "{centre:?}: {cost}, expected {expected}");
                let off = (centre[0] - circle.centre.x).hypot(centre[1] - circle.centre.y);
                if off < 1e-9 && (squared_radius - circle.radius * circle.radius).abs() < 1e-9 {
                    assert!(cost.abs() < 1e-13 * terms, "{cost} of {terms}");
                    touching += 1;
                }
            }
            assert_eq!(touching, 1, "{circle:?}: {found:?}");
        };
        let found = circle_least_squares::solve_for_circle(&gram).unwrap();
        check(&found.iter().map(|it| (it.centre, it.squared_radius, it.cost)).collect::<Vec<_>>());
        let found = circle_least_squares_dual::solve_for_circle(&gram).unwrap();
        check(&found.iter().map(|it| (it.centre, it.squared_radius, it.cost)).collect::<Vec<_>>());
    }
}

#[test]
fn the_mean_of_nothing_is_refused() {
    let none = circle_least_squares::mean_of_line(std::iter::empty::<[f64; 3]>());
    assert_eq!(circle_least_squares::solve(&none).unwrap_err(), SolveError::NonFiniteInput);
    let none = pose_npt_least_squares_quaternion::mean_of_point(std::iter::empty::<([f64; 2], [f64; 3])>());
    assert!(none.iter().all(|number| number.is_nan()));
    assert_eq!(pose_npt_least_squares_quaternion::solve(&none).unwrap_err(), SolveError::NonFiniteInput);
}
