//! Lists of polished solutions without duplicates.
mod support;

use std::cell::RefCell;

use eliminant::Complex;
use eliminant::emitted::{Candidate, Fixed, Size, push_distinct};
use support::conics::{TWO, polish};

/// A point of the plane and its relative residual.
type Solution = ([f64; 2], f64);

fn candidate((unknowns, residual): Solution) -> Candidate<f64, Fixed<2>> {
    Candidate { unknowns, residual }
}

/// At most MAX solutions.
struct Found<const MAX: usize>(<Fixed<MAX> as Size>::List<Candidate<f64, Fixed<2>>>);

impl<const MAX: usize> Found<MAX> {
    fn new() -> Self {
        Self(Fixed.list())
    }

    /// Adds a solution; halfway between close ones the residual is 1, so that only equal ones are
    /// one.
    fn push(&mut self, solution: Solution) -> bool {
        self.push_with(solution, |_, _| 1.0)
    }

    fn push_with(&mut self, solution: Solution, polish: impl Fn(&mut [f64; 2], usize) -> f64) -> bool {
        push_distinct(&mut self.0, candidate(solution), polish)
    }

    fn all(&self) -> Vec<Solution> {
        self.0.iter().map(|known| (known.unknowns, known.residual)).collect()
    }
}

#[test]
fn duplicates_keep_the_better_one() {
    let mut found = Found::<3>::new();
    assert!(found.push(([1.0, 1e6], 1e-12)));
    assert!(!found.push(([1.0 + 1e-12, 1e6], 1e-15)));
    assert!(!found.push(([1.0 - 1e-12, 1e6], 1e-13)));
    assert_eq!(found.all(), [([1.0 + 1e-12, 1e6], 1e-15)]);
    // They differ in the small unknown only, and are different all the same.
    assert!(found.push(([-1.0, 1e6], 1e-15)));
    // The first unknown is noise instead of zero.
    assert!(found.push(([1e-17, 1.0], 1e-15)));
    assert!(!found.push(([-3e-16, 1.0], 1e-16)));
    // There is no room: the solution with the largest residual goes, the last of several.
    assert!(!found.push(([5.0, 5.0], 1e-15)), "it is not better");
    assert_eq!(found.all().len(), 3);
    assert!(found.push(([5.0, 5.0], 0.0)));
    assert_eq!(found.all(), [([1.0 + 1e-12, 1e6], 1e-15), ([5.0, 5.0], 0.0), ([-3e-16, 1.0], 1e-16)]);
}

#[test]
fn of_equally_good_duplicates_the_first_stays() {
    let mut found = Found::<2>::new();
    assert!(found.push(([1.0, 2.0], 1e-15)));
    assert!(!found.push(([1.0 + 1e-12, 2.0], 1e-15)));
    assert_eq!(found.all(), [([1.0, 2.0], 1e-15)]);
}

#[test]
fn the_worst_of_all_goes_wherever_it_is() {
    for worst in 0..3 {
        let mut found = Found::<3>::new();
        let residual = |at| if at == worst { 1e-11 } else { 1e-14 };
        (0..3).for_each(|at| assert!(found.push(([at as f64, 1.0], residual(at)))));
        assert!(!found.push(([7.0, 7.0], 1e-11)) && !found.push(([7.0, 7.0], 1e-10)), "neither is better");
        assert!(found.push(([7.0, 7.0], 1e-12)));
        let expected: Vec<Solution> =
            (0..3).map(|at| if at == worst { ([7.0, 7.0], 1e-12) } else { ([at as f64, 1.0], 1e-14) }).collect();
        assert_eq!(found.all(), expected);
    }
    assert!(!Found::<0>::new().push(([1.0, 1.0], 0.0)), "there is no room at all");
}

/// Two solutions are the same if every unknown agrees to 1e-8 of the larger value, or to 1e-13 of
/// the largest unknown.
#[test]
fn every_unknown_must_agree_to_its_own_size() {
    let same = |x: [f64; 2], y: [f64; 2]| {
        let (x, y) = (candidate((x, 0.0)), candidate((y, 0.0)));
        assert_eq!(x.same(&y), y.same(&x), "it is symmetric");
        x.same(&y)
    };
    assert!(same([3.0, -4.0], [3.0, -4.0]) && same([0.0; 2], [0.0; 2]));
    for (distance, equal) in [(0.9e-8, true), (1.1e-8, false), (-0.9e-8, true), (-1.1e-8, false)] {
        for size in [1e-3, 1.0, 1e3] {
            assert_eq!(same([size, size], [size * (1.0 + distance), size]), equal, "{distance} of {size}");
            assert_eq!(same([size, size], [size, size * (1.0 + distance)]), equal, "{distance} of {size}");
        }
    }
    for (distance, equal) in [(0.9e-13, true), (1.1e-13, false)] {
        for size in [1e-3, 1.0, 1e3] {
            assert_eq!(same([0.0, size], [distance * size, size]), equal, "{distance} of {size}");
        }
    }
    assert!(!same([2.0, 1.0], [-2.0, 1.0]) && !same([1.0, 2.0], [0.5, 2.0]));
    let complex = |im: f64| Candidate::<_, Fixed<1>> { unknowns: [Complex { re: 1.0, im }], residual: 0.0 };
    assert!(complex(1e-3).same(&complex(1e-3 + 1e-9)) && !complex(1e-3).same(&complex(-1e-3)));
}

/// Close solutions that are not the same: what happens depends on the residual halfway, here 1e-12
/// at most.
#[test]
fn close_solutions_are_one_if_the_residual_halfway_shows_it() {
    let (one, other) = ([1.0, 2.0], [1.0 + 1e-4, 2.0 - 2e-4]);
    // The residuals of both, the one halfway, and whether that makes them one solution.
    let cases = [
        ([1e-15, 1e-15], 1e-12, true),
        ([1e-15, 1e-15], 1.01e-12, false),
        ([2e-12, 1e-15], 2e-12, true),
        ([1e-15, 2e-12], 2e-12, true),
        ([2e-12, 1e-15], 2.1e-12, false),
        ([1e-15, 2e-12], 2.1e-12, false),
    ];
    for (residuals, halfway, is_one) in cases {
        // Whether the polish from halfway gives the best point.
        for improved in [true, false] {
            let at = RefCell::new(Vec::new());
            let polish = |x: &mut [f64; 2], steps: usize| {
                at.borrow_mut().push((*x, steps > 0));
                if steps == 0 {
                    return halfway;
                }
                *x = [1.5, 1.5];
                if improved { 1e-16 } else { 1e-15 }
            };
            let mut found = Found::<2>::new();
            found.push((one, residuals[0]));
            assert_eq!(found.push_with((other, residuals[1]), polish), !is_one, "{residuals:?}, {halfway}");
            let expected = match (is_one, improved) {
                (false, _) => vec![(one, residuals[0]), (other, residuals[1])],
                (true, true) => vec![([1.5, 1.5], 1e-16)],
                (true, false) if residuals[1] < residuals[0] => vec![(other, residuals[1])],
                (true, false) => vec![(one, residuals[0])],
            };
            assert_eq!(found.all(), expected, "{residuals:?}, {halfway}");
            let middle = [0.5 * (one[0] + other[0]), 0.5 * (one[1] + other[1])];
            let calls = if is_one { vec![(middle, false), (middle, true)] } else { vec![(middle, false)] };
            assert_eq!(at.take(), calls);
        }
    }
}

/// Solutions further apart than a thousandth are not compared, and same ones need no residual.
#[test]
fn only_close_solutions_are_evaluated_halfway() {
    let evaluated = |other: [f64; 2]| {
        let count = RefCell::new(0);
        let mut found = Found::<2>::new();
        found.push(([1.0, 2.0], 1e-15));
        let new = found.push_with((other, 1e-15), |_, _| {
            *count.borrow_mut() += 1;
            1.0
        });
        (new, count.take())
    };
    assert_eq!(evaluated([1.0 + 0.9e-3, 2.0]), (true, 1));
    assert_eq!(evaluated([1.0 + 1.1e-3, 2.0]), (true, 0));
    assert_eq!(evaluated([1.0, 2.0 - 1.8e-3]), (true, 1));
    assert_eq!(evaluated([1.0 + 1e-9, 2.0]), (false, 0));
}

/// x^2 = e and y = 1: two solutions, or one for e = 0.
#[test]
fn close_solutions_are_one_where_the_equations_cannot_tell() {
    let distance = 1e-5;
    for (e, count) in [(0.0, 1), (distance * distance, 2)] {
        // x^2 + y - 1 - e = 0 and y - 1 = 0.
        let coefficients = [-1.0 - e, 0.0, 1.0, 1.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0];
        let system = TWO.bind(&coefficients);
        let mut found = Found::<4>::new();
        for x in [distance, -0.7 * distance, -distance] {
            let mut unknowns = [x, 1.0];
            let residual = polish(&mut unknowns, &system, 8);
            found.push_with((unknowns, residual), |x, steps| polish(x, &system, steps));
        }
        let all = found.all();
        assert_eq!(all.len(), count, "{all:?}");
        assert!(all.iter().all(|([x, _], _)| (x.abs() - e.sqrt()).abs() < 1e-7), "{all:?}");
    }
}
