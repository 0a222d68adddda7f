//! What the names of a problem stand for.

use std::collections::BTreeMap;

use super::Span;
use super::value::Value;

/// A message about this has been recorded: whatever depends on it stays silent.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reported;

/// A result whose failure has been recorded already.
pub(super) type Outcome<T> = Result<T, Reported>;

/// What declared a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// The return type: an unknown.
    Unknown,
    /// A parameter of the problem: data.
    Data,
    /// A `const` item.
    Constant,
    /// `let`, a loop variable, a parameter of a helper; `true` after `let mut`.
    Local(bool),
}

/// A name in scope.
#[derive(Clone, Debug)]
pub(super) struct Binding {
    /// Its value, unless computing it failed.
    pub(super) value: Outcome<Value>,
    /// What declared it.
    pub(super) kind: Kind,
    /// Where.
    pub(super) span: Span,
}

/// Nested scopes; inner names hide outer ones.
#[derive(Debug, Default)]
pub(super) struct Scopes {
    constants: BTreeMap<String, Binding>,
    blocks: Vec<BTreeMap<String, Binding>>,
}

impl Scopes {
    /// Enters a block.
    pub(super) fn enter(&mut self) {
        self.blocks.push(BTreeMap::new());
    }

    /// Leaves the innermost block.
    pub(super) fn leave(&mut self) {
        self.blocks.pop();
    }

    /// Enters a function, whose body sees constants only; returns what [`Scopes::leave_function`]
    /// needs.
    pub(super) fn enter_function(&mut self) -> Vec<BTreeMap<String, Binding>> {
        std::mem::replace(&mut self.blocks, vec![BTreeMap::new()])
    }

    /// Returns to the caller.
    pub(super) fn leave_function(&mut self, caller: Vec<BTreeMap<String, Binding>>) {
        self.blocks = caller;
    }

    /// Declares a name in the innermost block; outside all blocks, a constant.
    pub(super) fn declare(&mut self, name: String, binding: Binding) {
        self.blocks.last_mut().unwrap_or(&mut self.constants).insert(name, binding);
    }

    /// What a name stands for.
    pub(super) fn get(&self, name: &str) -> Option<&Binding> {
        self.blocks.iter().rev().chain([&self.constants]).find_map(|block| block.get(name))
    }

    /// What a name stands for, to be changed.
    pub(super) fn get_mut(&mut self, name: &str) -> Option<&mut Binding> {
        self.blocks.iter_mut().rev().chain([&mut self.constants]).find_map(|block| block.get_mut(name))
    }

    /// All names in scope.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.blocks.iter().chain([&self.constants]).flat_map(|block| block.keys().map(String::as_str))
    }
}
