//! Results that several strategies of a search need: different ways to grow often come to the same
//! rows.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::{Mutex, PoisonError};

use super::formulation::FormulationKey;
use crate::algebra::Monomial;
use crate::template::{EliminationTemplate, Shift};

/// Templates that were computed before. The cache saves work and changes no result, because what it
/// holds depends on the key alone.
#[derive(Default)]
pub(crate) struct Cache {
    /// By formulation, shifts, action monomial and bound on |B|: what the shifts reduce to.
    pub(crate) reduced: CachedValues<(FormulationKey, Vec<Shift>, Monomial, usize), Option<EliminationTemplate>>,
    /// By formulation, template and bound on |B|: the improved template.
    pub(crate) improved: CachedValues<(FormulationKey, EliminationTemplate, usize), EliminationTemplate>,
}

/// Values of a function by its arguments.
pub(crate) struct CachedValues<K, V>(Mutex<HashMap<K, V>>);

impl<K, V> Default for CachedValues<K, V> {
    fn default() -> Self {
        Self(Mutex::new(HashMap::new()))
    }
}

impl<K: Eq + Hash, V: Clone> CachedValues<K, V> {
    /// The cached value of `key`, or else what `compute` returns. Two threads may compute the same
    /// value: no thread waits for another.
    pub(crate) fn get(&self, key: K, compute: impl FnOnce() -> V) -> V {
        let known = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let value = known().get(&key).cloned();
        value.unwrap_or_else(|| {
            let value = compute();
            known().insert(key, value.clone());
            value
        })
    }
}
