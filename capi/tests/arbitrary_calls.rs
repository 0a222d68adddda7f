//! Calls with arbitrary pointers, lengths and numbers: no crash, no write beyond a buffer, codes
//! that the header lists, and the solutions of the Rust functions.

mod common;

use common::faults::{Fault, MARGIN, UNTOUCHED, faults, numbers, same};
use common::{Buffer, Case, Measure, Room, cases};
use eliminant::SecondAttempts;
use eliminant_capi_runtime::Code;
use proptest::prelude::*;
use proptest::test_runner::{RngSeed, TestRunner};

const UNTOUCHED_COUNT: usize = 77;
const UNTOUCHED_CODE: i32 = -77;
/// The most numbers of a result up to which a solver counts as small.
const SMALL: usize = 100;

/// Up to so many solvers are tested in full, and each of more of them in part, so that all take
/// about as long.
const FULL: usize = 10;

/// All that a caller chooses.
#[derive(Clone, Debug)]
struct Call {
    instances: usize,
    /// The bound on second attempts.
    second_attempts: u64,
    /// Numbers, from which all lists are cut.
    numbers: Vec<f64>,
    faults: Vec<Fault>,
    of_solutions: Fault,
    of_counts: Fault,
    of_codes: Fault,
}

/// Large solvers take milliseconds, or seconds where their data are degenerate.
fn is_small(case: &Case) -> bool {
    case.most * case.row <= SMALL
}

/// The part of a number that each of so many solvers has.
fn share(number: usize, solvers: usize) -> usize {
    (number * FULL / solvers).clamp(number.min(2), number)
}

/// The most instances of a batch: more than a piece of a small solver has.
fn most_instances(case: &Case) -> usize {
    if is_small(case) { 70 } else { 2 }
}

fn second_attempts() -> impl Strategy<Value = u64> {
    prop_oneof![Just(0), Just(u64::MAX), 1..1_000_000_000u64]
}

fn calls(case: &Case, solvers: usize) -> impl Strategy<Value = Call> + use<> {
    let lists = case.data.len();
    let numbers_of_instance: usize = case.data.iter().map(|(length, _)| length).sum();
    (0..=share(most_instances(case), solvers)).prop_flat_map(move |instances| {
        let numbers = prop::collection::vec(numbers(), numbers_of_instance * instances.max(1));
        let faults_of_data = prop::collection::vec(faults(), lists);
        (second_attempts(), numbers, faults_of_data, faults(), faults(), faults()).prop_map(
            move |(second_attempts, numbers, faults, of_solutions, of_counts, of_codes)| Call {
                instances,
                second_attempts,
                numbers,
                faults,
                of_solutions,
                of_counts,
                of_codes,
            },
        )
    })
}

/// The lists of data for so many instances, with their faults.
fn buffers(case: &Case, call: &Call, instances: usize) -> Vec<Buffer> {
    let mut rest = &call.numbers[..];
    let lists = case.data.iter().zip(&call.faults).map(|(&(of_instance, _), &fault)| {
        let (list, after) = rest.split_at(of_instance * instances);
        rest = after;
        Buffer { pointer: fault.pointer(list.as_ptr().cast_mut()), length: fault.length(list.len()) }
    });
    lists.collect()
}

/// The lists without faults, each with the data of instance `at`.
fn of_instance(case: &Case, call: &Call, at: usize, instances: usize) -> Vec<Buffer> {
    let mut first = 0;
    let lists = case.data.iter().map(|&(length, _)| {
        let start = first + at * length;
        first += instances * length;
        Buffer { pointer: call.numbers[start..start + length].as_ptr(), length }
    });
    lists.collect()
}

fn is_code(number: i32) -> bool {
    Code::ALL.iter().any(|code| code.number() == number)
}

/// One instance.
fn check_solve(case: &Case, call: &Call) -> Result<(), TestCaseError> {
    // Numbers are by value: the faults of their lists are none.
    let mut sound = call.clone();
    for (fault, (_, is_number)) in sound.faults.iter_mut().zip(case.data) {
        *fault = if *is_number { Fault::None } else { *fault };
    }
    check_rows(case, &sound, case.solve, case.in_rust)?;
    let second_attempts = match call.second_attempts {
        0 => SecondAttempts::Never,
        u64::MAX => SecondAttempts::Always,
        operations => SecondAttempts::AtMost(operations),
    };
    check_rows(
        case,
        &sound,
        |data, room| (case.solve_with)(call.second_attempts, data, room),
        |data| (case.in_rust_with)(second_attempts, data),
    )?;
    prop_assert_eq!(case.operations.0, case.operations.1);
    // The first solution, or any numbers where there is none.
    let found = (case.in_rust)(&of_instance(case, &sound, 0, 1)).unwrap_or_default();
    let any = sound.numbers.iter().chain(&[0.5]).cycle();
    let solution: Vec<f64> = found.iter().chain(any).copied().take(case.row).collect();
    case.measures.iter().try_for_each(|measure| check_measure(case, &sound, &solution, measure))
}

/// Whether a list of the data of one instance does not fit.
fn has_faulty_data(case: &Case, call: &Call) -> bool {
    call.faults.iter().zip(case.data).any(|(fault, (length, _))| fault.is_fault(*length))
}

/// What a function writes for one instance.
fn check_rows(
    case: &Case,
    call: &Call,
    solve: impl Fn(&[Buffer], Room) -> i32,
    in_rust: impl Fn(&[Buffer]) -> Result<Vec<f64>, Code>,
) -> Result<(), TestCaseError> {
    // A capacity above the true one would be a lie of the caller, so that no length is above it.
    let capacity = call.of_solutions.length(case.most).min(case.most);
    let mut solutions = vec![UNTOUCHED; case.most * case.row + MARGIN];
    let mut count = UNTOUCHED_COUNT;
    let room = Room {
        solutions: call.of_solutions.pointer(solutions.as_mut_ptr()),
        length: capacity,
        counts: call.of_counts.pointer(&raw mut count),
        codes: std::ptr::null_mut(),
    };
    let code = solve(&buffers(case, call, 1), room);
    prop_assert!(is_code(code), "{code}");
    let bad_room = capacity > 0 && call.of_solutions.is_of_pointer();
    let bad_count = call.of_counts.is_of_pointer();
    if has_faulty_data(case, call) || bad_room || bad_count {
        prop_assert!((1..=3).contains(&code), "{code}");
        prop_assert!(solutions.iter().all(|&number| number == UNTOUCHED));
        prop_assert_eq!(count, if bad_count { UNTOUCHED_COUNT } else { 0 });
        return Ok(());
    }
    match in_rust(&of_instance(case, call, 0, 1)) {
        Ok(rows) => {
            let written = rows.len().min(capacity * case.row);
            let expected = if written < rows.len() { Code::ShortBuffer } else { Code::Ok };
            prop_assert_eq!(code, expected.number());
            prop_assert_eq!(count, rows.len() / case.row);
            prop_assert!(same(&solutions[..written], &rows[..written]), "{:?} {:?}", solutions, rows);
            prop_assert!(solutions[written..].iter().all(|&number| number == UNTOUCHED));
        }
        Err(expected) => prop_assert_eq!((code, count), (expected.number(), 0)),
    }
    Ok(())
}

/// What measures a solution.
fn check_measure(case: &Case, call: &Call, solution: &[f64], measure: &Measure) -> Result<(), TestCaseError> {
    let pointer = solution.as_ptr();
    let given =
        Buffer { pointer: call.of_solutions.pointer(pointer.cast_mut()), length: call.of_solutions.length(case.row) };
    let mut number = UNTOUCHED;
    let code = (measure.in_c)(&buffers(case, call, 1), given, call.of_counts.pointer(&raw mut number));
    let bad_solution = call.of_solutions.is_fault(case.row);
    if has_faulty_data(case, call) || bad_solution || call.of_counts.is_of_pointer() {
        prop_assert!((1..=3).contains(&code), "{code}");
        prop_assert!(number == UNTOUCHED);
        return Ok(());
    }
    match (measure.in_rust)(&of_instance(case, call, 0, 1), Buffer { pointer, length: case.row }) {
        Ok(expected) => {
            prop_assert_eq!(code, Code::Ok.number());
            prop_assert!(same(&[number], &[expected]), "{} {}", number, expected);
        }
        Err(expected) => prop_assert_eq!((code, number), (expected.number(), UNTOUCHED)),
    }
    Ok(())
}

/// Room of a batch, and what it was filled with.
struct BatchRoom {
    solutions: Vec<f64>,
    counts: Vec<usize>,
    codes: Vec<i32>,
}

/// Many instances. `lanes` compute in another order, so that solutions of batches are compared with
/// those of Rust by the tests of the solvers, to rounding, and here only without the feature.
fn check_batch(case: &Case, call: &Call) -> Result<(), TestCaseError> {
    let instances = call.instances;
    let numbers = instances * case.most * case.row;
    let mut room = BatchRoom {
        solutions: vec![UNTOUCHED; numbers + MARGIN],
        counts: vec![UNTOUCHED_COUNT; instances + MARGIN],
        codes: vec![UNTOUCHED_CODE; instances + MARGIN],
    };
    let data = buffers(case, call, instances);
    let code = (case.solve_batch)(
        instances,
        &data,
        Room {
            solutions: call.of_solutions.pointer(room.solutions.as_mut_ptr()),
            length: call.of_solutions.length(numbers).min(numbers),
            counts: call.of_counts.pointer(room.counts.as_mut_ptr()),
            codes: call.of_codes.pointer(room.codes.as_mut_ptr()),
        },
    );
    prop_assert!((0..=4).contains(&code), "{code}");
    prop_assert!(room.solutions[numbers..].iter().all(|&number| number == UNTOUCHED));
    prop_assert!(room.counts[instances..].iter().all(|&count| count == UNTOUCHED_COUNT));
    prop_assert!(room.codes[instances..].iter().all(|&code| code == UNTOUCHED_CODE));
    let faulty_room = [call.of_solutions, call.of_counts, call.of_codes].into_iter().any(Fault::is_of_pointer);
    let faulty_lists = call.faults.iter().zip(case.data).any(|(fault, (length, _))| fault.is_fault(length * instances));
    let short = matches!(call.of_solutions, Fault::Length(length) if length < numbers);
    if faulty_lists || short || faulty_room && instances > 0 {
        prop_assert!(code != Code::Ok.number());
        prop_assert!(room.solutions.iter().all(|&number| number == UNTOUCHED));
        prop_assert!(room.counts.iter().all(|&count| count == UNTOUCHED_COUNT));
        return Ok(());
    }
    prop_assert_eq!(code, Code::Ok.number());
    (0..instances).try_for_each(|at| check_of_batch(case, call, &room, at))
}

/// One instance of a batch.
fn check_of_batch(case: &Case, call: &Call, room: &BatchRoom, at: usize) -> Result<(), TestCaseError> {
    let rows = &room.solutions[at * case.most * case.row..][..case.most * case.row];
    let (count, code) = (room.counts[at], room.codes[at]);
    prop_assert!(is_code(code) && count <= case.most);
    prop_assert!(code == Code::Ok.number() || count == 0);
    let (found, padding) = rows.split_at(count * case.row);
    prop_assert!(padding.iter().all(|number| number.is_nan()));
    if cfg!(feature = "lanes") {
        return Ok(());
    }
    match (case.in_rust)(&of_instance(case, call, at, call.instances)) {
        Ok(rows) => prop_assert!(same(found, &rows), "{:?} {:?}", found, rows),
        Err(expected) => prop_assert_eq!(code, expected.number()),
    }
    Ok(())
}

fn run(check: fn(&Case, &Call) -> Result<(), TestCaseError>) {
    let cases = cases();
    assert!(!cases.is_empty(), "enable problems for this test: `--features trilateration,relpose_5pt_rays`");
    let solvers = cases.len();
    for case in cases {
        let calls_of_case = if is_small(&case) { share(400, solvers) } else { share(8, solvers) };
        let calls_of_case = u32::try_from(calls_of_case).expect("few");
        let rng_seed = RngSeed::Fixed(1);
        let config = ProptestConfig { cases: calls_of_case, rng_seed, failure_persistence: None, ..Default::default() };
        let outcome = TestRunner::new(config).run(&calls(&case, solvers), |call| check(&case, &call));
        outcome.unwrap_or_else(|error| panic!("{}: {error}", case.name));
    }
}

#[test]
fn arbitrary_calls_of_single_instances() {
    run(check_solve);
}

#[test]
fn arbitrary_calls_of_batches() {
    run(check_batch);
}
