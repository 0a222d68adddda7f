//! Means over measurements.
#![cfg(feature = "pose_npt_direct_least_squares")]

use eliminant_c::functions::pose_npt_direct_least_squares::eliminant_pose_npt_direct_least_squares_mean_of_point as c;
use eliminant_c::pose_npt_direct_least_squares::mean_of_point;
use eliminant_capi_runtime::Code;

const RAYS: [[f64; 3]; 3] = [[0.1, 0.2, 1.0], [-0.3, 0.1, 1.0], [0.2, -0.4, 1.0]];
const POINTS: [[f64; 3]; 3] = [[1.0, 2.0, 3.0], [-1.0, 0.5, 2.0], [0.3, 0.7, -1.0]];

/// The code of a call with lists of these lengths, and what was written.
fn call(measurements: usize, [rays, points, mean]: [usize; 3]) -> (i32, [[f64; 10]; 6]) {
    let mut room = [[7.0; 10]; 6];
    let (first, second) = (RAYS.as_flattened().as_ptr(), POINTS.as_flattened().as_ptr());
    // SAFETY: the lists are as long as the lengths that are right, and no other is read or written.
    let code = unsafe { c(measurements, first, rays, second, points, room.as_flattened_mut().as_mut_ptr(), mean) };
    (code, room)
}

#[test]
fn a_mean_is_that_of_rust() {
    assert_eq!(call(3, [9, 9, 60]), (0, mean_of_point(RAYS.iter().zip(&POINTS))));
    assert_eq!(call(1, [3, 3, 60]), (0, mean_of_point([(RAYS[0], POINTS[0])])));
    let (code, of_none) = call(0, [0, 0, 60]);
    assert!(code == 0 && of_none.as_flattened().iter().all(|number| number.is_nan()));
}

#[test]
fn nothing_is_written_where_a_list_does_not_fit() {
    for (measurements, lengths) in [(3, [9, 6, 60]), (3, [6, 9, 60]), (2, [9, 9, 60]), (3, [9, 9, 59])] {
        assert_eq!(call(measurements, lengths), (Code::WrongLength.number(), [[7.0; 10]; 6]));
    }
    let mut room = [7.0; 60];
    let points = POINTS.as_flattened().as_ptr();
    // SAFETY: null is refused.
    let code = unsafe { c(3, std::ptr::null(), 9, points, 9, room.as_mut_ptr(), 60) };
    assert_eq!((code, room), (Code::NullPointer.number(), [7.0; 60]));
}
