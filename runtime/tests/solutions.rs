//! The list of solutions that users see.

use eliminant::{Complex, IntoIter, Solutions, SolveError};

/// A full list of three.
fn three() -> Solutions<u32, 3> {
    let mut solutions = Solutions::new();
    [7, 8, 9].into_iter().for_each(|solution| assert!(solutions.push(solution)));
    solutions
}

#[test]
fn solutions_behave_like_a_slice_and_never_overflow() {
    let mut solutions = Solutions::<u32, 2>::new();
    assert!(solutions.is_empty() && solutions == Solutions::default());
    assert!(solutions.push(7) && solutions.push(8) && !solutions.push(9));
    assert_eq!(solutions.len(), 2);
    assert_eq!(solutions[1], 8);
    assert_eq!((&solutions).into_iter().sum::<u32>(), 15);
    assert_eq!(solutions.clone().into_iter().collect::<Vec<_>>(), [7, 8]);
    assert_eq!(format!("{solutions:?}"), "Solutions([7, 8])");
    solutions[0] = 6;
    solutions.reverse();
    assert_eq!(solutions.to_vec(), [8, 6]);
    assert!(!Solutions::<u32, 0>::new().push(1));
}

#[test]
fn images_come_in_the_order_of_the_solutions() {
    assert_eq!(three().map(|solution| solution > 7).to_vec(), [false, true, true]);
    assert_eq!(three().filter_map(|solution| (solution != 8).then_some(2 * solution)).to_vec(), [14, 18]);
    assert!(three().filter_map(|_| None::<u32>).is_empty());
}

#[test]
fn solutions_are_taken_from_both_ends() {
    let mut rest: IntoIter<u32, 3> = three().into_iter();
    assert_eq!((rest.len(), rest.size_hint()), (3, (3, Some(3))));
    assert_eq!((rest.next(), rest.next_back(), rest.len()), (Some(7), Some(9), 1));
    assert_eq!((rest.clone().next(), rest.next_back(), rest.next(), rest.next_back()), (Some(8), Some(8), None, None));
    assert_eq!(rest.size_hint(), (0, Some(0)));
    assert_eq!(three().into_iter().rev().collect::<Vec<_>>(), [9, 8, 7]);
}

/// `num_complex` has no norm without a square root, which the features `std` and `libm` give it.
#[test]
fn complex_solutions_have_a_norm() {
    let mut solutions = Solutions::<[Complex<f64>; 1], 1>::new();
    solutions.push([Complex { re: 3.0, im: -4.0 }]);
    assert_eq!(solutions[0][0].norm(), 5.0);
}

#[test]
fn solutions_are_a_sequence_in_json() {
    let mut points = Solutions::<[f64; 2], 3>::new();
    assert_eq!(serde_json::to_string(&points).unwrap(), "[]");
    points.push([0.1, -2.5]);
    points.push([1024.0, 2.0]);
    let text = serde_json::to_string(&points).unwrap();
    assert_eq!(text, "[[0.1,-2.5],[1024.0,2.0]]");
    assert_eq!(serde_json::from_str::<Solutions<[f64; 2], 3>>(&text).unwrap(), points);
    assert_eq!(serde_json::from_str::<Solutions<[f64; 2], 2>>(&text).unwrap().to_vec(), points.to_vec());

    let error = serde_json::from_str::<Solutions<[f64; 2], 1>>(&text).unwrap_err().to_string();
    assert!(error.starts_with("invalid length 2, expected at most 1 solutions"), "{error}");
    assert!(serde_json::from_str::<Solutions<u32, 3>>("7").unwrap_err().to_string().contains("at most 3 solutions"));
    assert!(serde_json::from_str::<Solutions<u32, 3>>("[1, true]").is_err());
}

#[test]
fn errors_say_what_happened() {
    let texts = [
        (SolveError::NonFiniteInput, "the data hold an infinite value or a NaN"),
        (SolveError::Degenerate { block: 4 }, "degenerate data: diagonal block 4 of the template lost rank"),
        (SolveError::Overflow, "a number computed from the data is not finite: a division by zero or an overflow"),
        (SolveError::TooLarge, "the problem needs larger arrays than are set aside"),
        (SolveError::NoConvergence, "the eigenvalue iteration reached its limit"),
    ];
    for (error, text) in texts {
        let error: Box<dyn std::error::Error> = Box::new(error);
        assert_eq!(error.to_string(), text);
    }
}
