//! Every solver works in threads with little stack, second attempts included, and workspaces change
//! no solution.
//!
//! In a debug build solvers need more stack, so the first test also runs with solvers that are not
//! optimised: `cargo test --profile unoptimised -p eliminant-tests --test small_threads -- all`.

use eliminant::{SecondAttempts, Workspace};
use eliminant_tests::cases;
use eliminant_tests::stack::{CALLS, Call, Instances, SUFFICIENT_STACK};
use eliminant_tests::statistics::distance;
use rayon::prelude::*;

/// The part of solvers for which data with a second attempt are found. Those without have small
/// templates, and the same arrays for the second attempt as others of their size.
const TWICE: f64 = 0.6;

/// Points that are closer are one solution, found twice.
const SAME_SOLUTION: f64 = 1e-9;

#[test]
fn all_solvers_work_in_small_threads() {
    let cases = cases();
    let twice = cases.par_iter().map(|case| {
        let instances = Instances::of(case);
        let count = |call| instances.run(*case, call, SUFFICIENT_STACK).expect("the thread starts");
        let [real, complex, real_in, complex_in] = CALLS.map(count);
        assert!(complex > 0, "{}: random data have complex solutions", case.name);
        assert_eq!([real, complex], [real_in, complex_in], "{}", case.name);
        println!("{}: {} {}", case.name, instances.real_twice.is_some(), instances.complex_twice.is_some());
        usize::from(instances.complex_twice.is_some())
    });
    let twice: usize = twice.sum();
    assert!(twice as f64 >= TWICE * cases.len() as f64, "only {twice} solvers made a second attempt");
}

/// A workspace changes nothing but second attempts, whatever was solved in it before.
#[test]
fn workspaces_give_the_same_solutions() {
    let mut shared = Workspace::new();
    let mut fewer = 0;
    for case in cases() {
        let instances = Instances::of(&case);
        let operations = case.second_attempt_operations;
        let with = |second_attempts| Workspace::new().with_second_attempts(second_attempts);
        for data in instances.for_call(Call::Complex) {
            let expected = (case.solve_complex)(data);
            for _ in 0..2 {
                assert_eq!((case.solve_complex_in)(&mut shared, data), expected, "{}", case.name);
                assert_eq!((case.solve_in)(&mut shared, data), (case.solve)(data), "{}", case.name);
            }
            let count = |found: &Result<Vec<_>, _>| found.as_ref().map_or(0, Vec::len);
            // A bound forbids what has none: to follow solutions to data at which a template is
            // singular, or at which solutions have no eigenpair. These come last. One that is
            // already known may be more precise.
            let enough = (case.solve_complex_in)(&mut with(SecondAttempts::AtMost(operations)), data);
            let is_forbidden = match (&enough, &expected) {
                (Ok(enough), Ok(expected)) if enough.len() < expected.len() => {
                    enough.iter().zip(expected).all(|(a, b)| distance(a, b) <= SAME_SOLUTION)
                }
                (Ok(_), _) => enough == expected,
                (Err(_), _) => true,
            };
            assert!(is_forbidden, "{}: {enough:?}", case.name);
            let never = (case.solve_complex_in)(&mut with(SecondAttempts::Never), data);
            let too_few = &mut with(SecondAttempts::AtMost(operations - 1));
            assert_eq!((case.solve_complex_in)(too_few, data), never, "{}", case.name);
            assert!(count(&never) <= count(&expected), "{}: more without a second attempt", case.name);
            fewer += usize::from(count(&never) < count(&expected));
        }
    }
    assert!(fewer > 0, "no second attempt found a solution");
}
