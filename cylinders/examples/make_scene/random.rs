//! Seeded random numbers.

pub(crate) use eliminant_cylinders::random::Random;
