//! Monomials interned as small integers.

use super::order::OrderKey;
use super::{GroebnerError, MonomialOrder};
use crate::algebra::{MAX_UNKNOWNS, Monomial};

/// A monomial of a [`MonomialTable`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct MonomialId(u32);

impl MonomialId {
    /// The index into arrays that hold one value per monomial.
    #[inline]
    pub(super) fn index(self) -> usize {
        self.0 as usize
    }
}

/// A hash of the exponents that is additive: hash(a b) = hash(a) + hash(b).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct MonomialHash(u64);

/// All monomials met so far, each stored once: a hash table with open addressing.
pub(super) struct MonomialTable {
    order: MonomialOrder,
    monomials: Vec<Monomial>,
    hashes: Vec<MonomialHash>,
    keys: Vec<OrderKey>,
    /// A power of two of slots, at most half of them occupied by an id.
    slots: Vec<u32>,
}

const FREE: u32 = u32::MAX;

/// One odd constant per unknown, from the SplitMix64 sequence.
const FACTORS: [u64; MAX_UNKNOWNS] = {
    let mut factors = [0; MAX_UNKNOWNS];
    let mut i = 0;
    while i < MAX_UNKNOWNS {
        let mut z = (i as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        factors[i] = (z ^ (z >> 31)) | 1;
        i += 1;
    }
    factors
};

impl MonomialTable {
    /// An empty table.
    pub(super) fn new(order: MonomialOrder) -> Self {
        Self { order, monomials: Vec::new(), hashes: Vec::new(), keys: Vec::new(), slots: vec![FREE; 1 << 10] }
    }

    /// The number of monomials.
    pub(super) fn len(&self) -> usize {
        self.monomials.len()
    }

    /// The monomial with this id.
    #[inline]
    pub(super) fn monomial(&self, id: MonomialId) -> &Monomial {
        &self.monomials[id.index()]
    }

    /// The place in the order of the monomial with this id.
    #[inline]
    pub(super) fn key(&self, id: MonomialId) -> OrderKey {
        self.keys[id.index()]
    }

    /// The hash of a monomial.
    pub(super) fn hash(monomial: &Monomial) -> MonomialHash {
        let terms = monomial.exponents().iter().zip(FACTORS).map(|(&e, factor)| (e as u64).wrapping_mul(factor));
        MonomialHash(terms.fold(0, u64::wrapping_add))
    }

    /// The id of a monomial without negative exponents.
    pub(super) fn intern(&mut self, monomial: Monomial) -> Result<MonomialId, GroebnerError> {
        self.find_or_insert(monomial, Self::hash(&monomial))
    }

    /// The id of `multiplier`, whose hash is given, times the monomial `id`.
    #[inline]
    pub(super) fn intern_product(
        &mut self,
        multiplier: &Monomial,
        hash: MonomialHash,
        id: MonomialId,
    ) -> Result<MonomialId, GroebnerError> {
        let sum = MonomialHash(hash.0.wrapping_add(self.hashes[id.index()].0));
        let product = multiplier.times(self.monomial(id));
        self.find_or_insert(product, sum)
    }

    #[inline]
    fn find_or_insert(&mut self, monomial: Monomial, hash: MonomialHash) -> Result<MonomialId, GroebnerError> {
        let mut slot = self.first_slot(hash);
        loop {
            let id = self.slots[slot];
            if id == FREE {
                return self.insert(monomial, hash, slot);
            }
            if self.monomials[id as usize] == monomial {
                return Ok(MonomialId(id));
            }
            slot = (slot + 1) & (self.slots.len() - 1);
        }
    }

    fn insert(&mut self, monomial: Monomial, hash: MonomialHash, slot: usize) -> Result<MonomialId, GroebnerError> {
        // A product that wrapped around has a negative exponent: it is not in the table, and ends
        // here.
        if !monomial.is_polynomial() {
            return Err(GroebnerError::ExponentOutOfRange);
        }
        let id = self.monomials.len() as u32;
        self.slots[slot] = id;
        self.monomials.push(monomial);
        self.hashes.push(hash);
        self.keys.push(self.order.key(&monomial));
        if 2 * self.monomials.len() > self.slots.len() {
            self.grow();
        }
        Ok(MonomialId(id))
    }

    fn grow(&mut self) {
        self.slots = vec![FREE; 2 * self.slots.len()];
        for id in 0..self.hashes.len() {
            let mut slot = self.first_slot(self.hashes[id]);
            while self.slots[slot] != FREE {
                slot = (slot + 1) & (self.slots.len() - 1);
            }
            self.slots[slot] = id as u32;
        }
    }

    /// The high bits of the hash, which depend on all exponents.
    #[inline]
    fn first_slot(&self, hash: MonomialHash) -> usize {
        (hash.0 >> (64 - self.slots.len().trailing_zeros())) as usize
    }
}
