//! How the basis falls into chains under multiplication by the action monomial.
//!
//! ```text
//!   m_1 -> a m_1 -> a^2 m_1 -> (solved row)      3 entries: 2 unit rows of the action matrix,
//!   m_2 -> a m_2 -> (solved row)                            1 row with numbers
//!   m_3 -> (solved row)
//! ```
//!
//! The real eigenvalues are the roots of the determinant of a matrix of polynomials with one row
//! and one column per chain: see `runtime/src/spectrum/hidden_variable.rs`. Chains of one monomial
//! are eliminated before, as many as there are longer ones.

use super::{ActionRow, BasisId, Chains, Plan};
use crate::algebra::{Echelon, PrimeField};

/// The determinant is expanded into minors, two to the number of chains. With more chains the QR
/// iteration is faster.
const MOST_CHAINS: usize = 6;

/// A polynomial of higher degree has lost too many digits: at degree 24, nine of 10,000 scenes of
/// `pose_5tdoa_two_receivers` lost their known solution, at degree 20 one of `relpose_4pt_angle`.
const HIGHEST_DEGREE: usize = 18;

impl Plan {
    /// The chains over which a determinant gives the real solutions, found from the action matrix
    /// of an instance over Z_p; `None` if there are too many, or if some eigenvalues belong to no
    /// solution, or to one that is known beforehand.
    pub fn determinant_chains(&self, field: PrimeField, action: &[Vec<u32>]) -> Option<Chains> {
        let most = self.elimination.basis * (1 + self.flips.len());
        if most == self.solutions && !self.has_origin { Chains::of(&self.action, field, action) } else { None }
    }
}

impl Chains {
    /// The chains of an action matrix that has these rows and, on an instance over Z_p, these
    /// values; `None` if there are too many for a determinant.
    ///
    /// The row of a longer chain eliminates a chain of one monomial if the constants of such rows
    /// are independent. Short chains are tried first: the degrees of the columns are then as equal
    /// as they can be, and products of polynomials short.
    pub fn of(action: &[ActionRow], field: PrimeField, values: &[Vec<u32>]) -> Option<Self> {
        if action.len() > HIGHEST_DEGREE {
            return None;
        }
        let (single, longer): (Vec<_>, Vec<_>) = chains(action).into_iter().partition(|chain| chain.len() == 1);
        let mut independent = Echelon::new(field, single.len());
        let mut eliminates = |chain: &Vec<usize>| -> Option<usize> {
            let row = &values[*chain.last()?];
            independent.insert_dense(&single.iter().map(|chain| row[chain[0]]).collect::<Vec<u32>>())
        };
        let heads: Vec<Option<usize>> = longer.iter().map(&mut eliminates).collect();
        let (users, others): (Vec<_>, Vec<_>) = longer.iter().zip(&heads).partition(|(_, head)| head.is_some());
        let rest = single.iter().enumerate().filter(|(at, _)| !heads.contains(&Some(*at)));
        let kept = users.iter().chain(&others).map(|(chain, _)| *chain).chain(rest.map(|(_, chain)| chain));
        let kept: Vec<&Vec<usize>> = kept.collect();
        let eliminated = heads.iter().flatten().flat_map(|&at| &single[at]);
        let order = kept.iter().flat_map(|chain| chain.iter()).chain(eliminated);
        let order = order.map(|&b| BasisId(b as u16)).collect();
        let lengths = kept.iter().map(|chain| chain.len()).collect();
        (kept.len() <= MOST_CHAINS).then_some(Self { order, lengths, eliminated: users.len() })
    }
}

/// All chains, short ones first.
fn chains(action: &[ActionRow]) -> Vec<Vec<usize>> {
    let next = |at: usize| match action[at] {
        ActionRow::Unit(b) => Some(usize::from(b.0)),
        ActionRow::Solved(_) => None,
    };
    let mut is_image = vec![false; action.len()];
    (0..action.len()).filter_map(next).for_each(|b| is_image[b] = true);
    let chain = |head: usize| std::iter::successors(Some(head), |&at| next(at)).collect();
    let mut chains: Vec<Vec<usize>> = (0..action.len()).filter(|&b| !is_image[b]).map(chain).collect();
    chains.sort_by_key(Vec::len);
    chains
}
