//! Calls with arbitrary pointers, lengths and numbers: no crash, no write beyond a buffer, codes
//! that the header lists, and the solutions of the Rust functions.

mod common;

use common::{Buffer, Case, Room, cases};
use eliminant_capi_runtime::Code;
use proptest::prelude::*;
use proptest::test_runner::{RngSeed, TestRunner};

/// What a test writes into room before a call.
const UNTOUCHED: f64 = 12345.678;
/// Numbers of room around what a call may touch.
const MARGIN: usize = 8;
const UNTOUCHED_COUNT: usize = 77;
const UNTOUCHED_CODE: i32 = -77;
/// The most numbers of a result up to which a solver counts as small.
const SMALL: usize = 100;

/// How a caller passes a pointer and a length.
#[derive(Clone, Copy, Debug)]
enum Fault {
    None,
    Null,
    Misaligned,
    /// Another length than the right one.
    Length(usize),
}

fn faults() -> impl Strategy<Value = Fault> {
    prop_oneof![
        20 => Just(Fault::None),
        1 => Just(Fault::Null),
        1 => Just(Fault::Misaligned),
        1 => prop_oneof![0..300usize, Just(usize::MAX), Just(usize::MAX / 8), any::<usize>()].prop_map(Fault::Length),
    ]
}

/// Mostly numbers of usual size, sometimes any bytes.
fn numbers() -> impl Strategy<Value = f64> {
    prop_oneof![
        60 => -2.0..2.0,
        4 => (-3..4).prop_map(f64::from),
        1 => any::<u64>().prop_map(f64::from_bits),
        1 => prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(1e300), Just(1e-300), Just(-0.0)],
    ]
}

/// All that a caller chooses.
#[derive(Clone, Debug)]
struct Call {
    instances: usize,
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

/// The most instances of a batch: more than a piece of a small solver has.
fn most_instances(case: &Case) -> usize {
    if is_small(case) { 70 } else { 2 }
}

fn calls(case: &Case) -> impl Strategy<Value = Call> + use<> {
    let lists = case.data.len();
    let numbers_of_instance: usize = case.data.iter().map(|(length, _)| length).sum();
    (0..=most_instances(case)).prop_flat_map(move |instances| {
        let numbers = prop::collection::vec(numbers(), numbers_of_instance * instances.max(1));
        let faults_of_data = prop::collection::vec(faults(), lists);
        (numbers, faults_of_data, faults(), faults(), faults()).prop_map(
            move |(numbers, faults, of_solutions, of_counts, of_codes)| Call {
                instances,
                numbers,
                faults,
                of_solutions,
                of_counts,
                of_codes,
            },
        )
    })
}

/// The pointer with its fault.
fn pointer<T>(right: *mut T, fault: Fault) -> *mut T {
    match fault {
        Fault::Null => std::ptr::null_mut(),
        Fault::Misaligned => right.cast::<u8>().wrapping_add(1).cast(),
        Fault::None | Fault::Length(_) => right,
    }
}

fn length(right: usize, fault: Fault) -> usize {
    if let Fault::Length(length) = fault { length } else { right }
}

/// The lists of data for so many instances, with their faults.
fn buffers(case: &Case, call: &Call, instances: usize) -> Vec<Buffer> {
    let mut rest = &call.numbers[..];
    let lists = case.data.iter().zip(&call.faults).map(|(&(of_instance, _), &fault)| {
        let (list, after) = rest.split_at(of_instance * instances);
        rest = after;
        Buffer { pointer: pointer(list.as_ptr().cast_mut(), fault), length: length(list.len(), fault) }
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

/// Equal bits; a NaN is any NaN.
fn same(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan())
}

/// One instance.
fn check_solve(case: &Case, call: &Call) -> Result<(), TestCaseError> {
    let faults_of_lists = call.faults.iter().zip(case.data).filter(|(_, (_, is_number))| !is_number);
    let is_faulty = |fault: &Fault, right: usize| match fault {
        Fault::None => false,
        Fault::Length(length) => *length != right,
        Fault::Null | Fault::Misaligned => right > 0,
    };
    let faulty_data = faults_of_lists.clone().any(|(fault, (right, _))| is_faulty(fault, *right));
    // Numbers are by value: the faults of their lists are none.
    let mut sound = call.clone();
    for (fault, (_, is_number)) in sound.faults.iter_mut().zip(case.data) {
        *fault = if *is_number { Fault::None } else { *fault };
    }
    let data = buffers(case, &sound, 1);
    // A capacity above the true one would be a lie of the caller, so that no length is above it.
    let capacity = length(case.most, call.of_solutions).min(case.most);
    let mut solutions = vec![UNTOUCHED; case.most * case.row + MARGIN];
    let mut count = UNTOUCHED_COUNT;
    let room = Room {
        solutions: pointer(solutions.as_mut_ptr(), call.of_solutions),
        length: capacity,
        counts: pointer(&raw mut count, call.of_counts),
        codes: std::ptr::null_mut(),
    };
    let code = (case.solve)(&data, room);
    prop_assert!(is_code(code), "{code}");
    let bad_room = capacity > 0 && matches!(call.of_solutions, Fault::Null | Fault::Misaligned);
    let bad_count = matches!(call.of_counts, Fault::Null | Fault::Misaligned);
    let wrong = faulty_data || bad_room || bad_count;
    if wrong {
        prop_assert!((1..=3).contains(&code), "{code}");
        prop_assert!(solutions.iter().all(|&number| number == UNTOUCHED));
        prop_assert_eq!(count, if bad_count { UNTOUCHED_COUNT } else { 0 });
        return Ok(());
    }
    match (case.in_rust)(&of_instance(case, &sound, 0, 1)) {
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
            solutions: pointer(room.solutions.as_mut_ptr(), call.of_solutions),
            length: length(numbers, call.of_solutions).min(numbers),
            counts: pointer(room.counts.as_mut_ptr(), call.of_counts),
            codes: pointer(room.codes.as_mut_ptr(), call.of_codes),
        },
    );
    prop_assert!((0..=4).contains(&code), "{code}");
    prop_assert!(room.solutions[numbers..].iter().all(|&number| number == UNTOUCHED));
    prop_assert!(room.counts[instances..].iter().all(|&count| count == UNTOUCHED_COUNT));
    prop_assert!(room.codes[instances..].iter().all(|&code| code == UNTOUCHED_CODE));
    let is_bad = |fault: &Fault| matches!(fault, Fault::Null | Fault::Misaligned);
    let faulty_room = [&call.of_solutions, &call.of_counts, &call.of_codes].into_iter().any(is_bad);
    let faulty_lists = call.faults.iter().zip(case.data).any(|(fault, (length, _))| match fault {
        Fault::Length(given) => *given != length * instances,
        fault => is_bad(fault) && instances > 0,
    });
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
    for case in cases {
        let calls_of_case = if is_small(&case) { 400 } else { 8 };
        let rng_seed = RngSeed::Fixed(1);
        let config = ProptestConfig { cases: calls_of_case, rng_seed, failure_persistence: None, ..Default::default() };
        let outcome = TestRunner::new(config).run(&calls(&case), |call| check(&case, &call));
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
