//! What callers do wrong, and arbitrary numbers.

use proptest::prelude::*;

/// What a test writes into room before a call.
pub const UNTOUCHED: f64 = 12345.678;
/// Numbers of room around what a call may touch.
pub const MARGIN: usize = 8;

/// How a caller passes a pointer and a length.
#[derive(Clone, Copy, Debug)]
pub enum Fault {
    None,
    Null,
    Misaligned,
    /// Another length than the right one.
    Length(usize),
}

impl Fault {
    /// Whether pointers have it, wherever they point.
    pub fn is_of_pointer(self) -> bool {
        matches!(self, Fault::Null | Fault::Misaligned)
    }

    /// Whether it is one for a list of this length.
    pub fn is_fault(self, right: usize) -> bool {
        match self {
            Fault::Length(length) => length != right,
            other => other.is_of_pointer() && right > 0,
        }
    }

    /// The pointer with its fault.
    pub fn pointer<T>(self, right: *mut T) -> *mut T {
        match self {
            Fault::Null => std::ptr::null_mut(),
            Fault::Misaligned => right.cast::<u8>().wrapping_add(1).cast(),
            Fault::None | Fault::Length(_) => right,
        }
    }

    /// The length with its fault.
    pub fn length(self, right: usize) -> usize {
        if let Fault::Length(length) = self { length } else { right }
    }
}

pub fn faults() -> impl Strategy<Value = Fault> {
    prop_oneof![
        20 => Just(Fault::None),
        1 => Just(Fault::Null),
        1 => Just(Fault::Misaligned),
        1 => prop_oneof![0..300usize, Just(usize::MAX), Just(usize::MAX / 8), any::<usize>()].prop_map(Fault::Length),
    ]
}

/// Mostly numbers of usual size, sometimes any bytes.
pub fn numbers() -> impl Strategy<Value = f64> {
    prop_oneof![
        60 => -2.0..2.0,
        4 => (-3..4).prop_map(f64::from),
        1 => any::<u64>().prop_map(f64::from_bits),
        1 => prop_oneof![
            Just(f64::NAN),
            Just(f64::INFINITY),
            Just(f64::NEG_INFINITY),
            Just(1e300),
            Just(1e-300),
            Just(-0.0)
        ],
    ]
}

/// Equal bits; a NaN is any NaN.
pub fn same(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan())
}
