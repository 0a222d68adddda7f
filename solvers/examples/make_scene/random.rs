//! Seeded random numbers.

pub(crate) use eliminant_solvers::cylinder::random::Random;
