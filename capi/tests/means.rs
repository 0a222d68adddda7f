//! Means over arbitrary measurements with arbitrary pointers and lengths: no crash, no write beyond
//! the mean, none where a list does not fit, and the means of the Rust functions.

mod common;

use common::faults::{Fault, MARGIN, UNTOUCHED, faults, numbers, same};
use common::{Buffer, MeanCase, mean_cases};
use eliminant_capi_runtime::Code;
use proptest::prelude::*;
use proptest::test_runner::{RngSeed, TestRunner};

const MOST_MEASUREMENTS: usize = 20;

/// All that a caller chooses.
#[derive(Clone, Debug)]
struct Call {
    measurements: usize,
    /// How many measurements the caller says there are.
    of_measurements: Fault,
    lists: Vec<Vec<f64>>,
    faults: Vec<Fault>,
    of_mean: Fault,
}

fn calls(case: &MeanCase) -> impl Strategy<Value = Call> + use<> {
    let data = case.data;
    (0..=MOST_MEASUREMENTS).prop_flat_map(move |measurements| {
        let lists: Vec<_> = data.iter().map(|length| prop::collection::vec(numbers(), length * measurements)).collect();
        let faults_of_lists = prop::collection::vec(faults(), data.len());
        (faults(), lists, faults_of_lists, faults()).prop_map(move |(of_measurements, lists, faults, of_mean)| Call {
            measurements,
            of_measurements,
            lists,
            faults,
            of_mean,
        })
    })
}

fn check(case: &MeanCase, call: &Call) -> Result<(), TestCaseError> {
    let with_faults = |(list, fault): (&Vec<f64>, &Fault)| Buffer {
        pointer: fault.pointer(list.as_ptr().cast_mut()),
        length: fault.length(list.len()),
    };
    let lists: Vec<Buffer> = call.lists.iter().zip(&call.faults).map(with_faults).collect();
    // A count has no pointer.
    let measurements = call.of_measurements.length(call.measurements);
    let mut room = vec![UNTOUCHED; case.mean + MARGIN];
    let mean = Buffer { pointer: call.of_mean.pointer(room.as_mut_ptr()), length: call.of_mean.length(case.mean) };
    let code = (case.in_c)(measurements, &lists, mean);
    let is_faulty = |(list, (fault, length)): (&Buffer, (&Fault, &usize))| {
        length.checked_mul(measurements) != Some(list.length) || fault.is_of_pointer() && list.length > 0
    };
    let faulty_list = lists.iter().zip(call.faults.iter().zip(case.data)).any(is_faulty);
    if faulty_list || call.of_mean.is_fault(case.mean) {
        let codes = [Code::NullPointer, Code::MisalignedPointer, Code::WrongLength].map(Code::number);
        prop_assert!(codes.contains(&code), "{code}");
        prop_assert!(room.iter().all(|&number| number == UNTOUCHED));
        return Ok(());
    }
    prop_assert_eq!(code, Code::Ok.number());
    let expected = (case.in_rust)(measurements, &lists);
    prop_assert!(same(&room[..case.mean], &expected), "{:?} {:?}", room, expected);
    prop_assert!(room[case.mean..].iter().all(|&number| number == UNTOUCHED));
    prop_assert!(measurements > 0 || expected.iter().all(|number| number.is_nan()));
    Ok(())
}

#[test]
fn arbitrary_calls_of_means() {
    let cases = mean_cases();
    assert!(!cases.is_empty(), "enable a problem with means: `--features pose_npt_direct_least_squares`");
    for case in cases {
        let config = ProptestConfig {
            cases: 1000,
            rng_seed: RngSeed::Fixed(1),
            failure_persistence: None,
            ..Default::default()
        };
        let outcome = TestRunner::new(config).run(&calls(&case), |call| check(&case, &call));
        outcome.unwrap_or_else(|error| panic!("{}: {error}", case.name));
    }
}
