//! Names in the emitted code that differ from those of the problem.
//!
//! The problem names the module, the parameters of its functions and the fields of the solution,
//! all in lower case. Items of the module are in upper case or are called by path, so that only
//! local names of functions with these parameters could collide.

use std::collections::BTreeSet;

use proc_macro2::Ident;
use quote::format_ident;

use crate::problem::DataParameter;

/// The names that are taken in a function whose parameters are the data.
#[derive(Clone, Debug)]
pub(super) struct Names {
    taken: BTreeSet<String>,
}

impl Names {
    /// With the parameters only.
    pub(super) fn of(data: &[DataParameter]) -> Self {
        Self { taken: data.iter().map(|parameter| parameter.name.clone()).collect() }
    }

    /// Takes names that are declared already.
    pub(super) fn reserve(&mut self, names: &[Ident]) {
        self.taken.extend(names.iter().map(Ident::to_string));
    }

    /// Takes the first of `name`, `name_2`, `name_3`, .. that is free.
    pub(super) fn take(&mut self, name: &str) -> Ident {
        let numbered = (2_usize..).map(|number| format!("{name}_{number}"));
        let mut candidates = std::iter::once(name.to_owned()).chain(numbered);
        let free = candidates.find(|candidate| !self.taken.contains(candidate)).unwrap_or_default();
        self.taken.insert(free.clone());
        format_ident!("{free}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_taken_once() {
        let parameter = |name: &str| DataParameter::example(name, &[], false);
        let mut names = Names::of(&[parameter("solution"), parameter("solution_2")]);
        assert_eq!(names.take("solution"), "solution_3");
        assert_eq!(names.take("solution"), "solution_4");
        assert_eq!(names.take("given"), "given");
        assert_eq!(names.take("given"), "given_2");
    }
}
