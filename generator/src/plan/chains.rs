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
    /// solution, or to one that is known beforehand. The rest of a quotient ring without the
    /// origin has an action like any other: its determinant gives all solutions but that one.
    pub fn determinant_chains(&self, field: PrimeField, action: &[Vec<u32>]) -> Option<Chains> {
        if self.has_spurious_values() { None } else { Chains::of(&self.action, field, action) }
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

/// The shape of M(x). A row of it is the polynomials of all columns one after another.
impl Chains {
    /// The degree of each column: the length of its chain, and one more if its row eliminates
    /// another.
    pub fn degrees(&self) -> Vec<usize> {
        let lengths = self.lengths.iter().enumerate();
        lengths.map(|(j, length)| length + usize::from(j < self.eliminated)).collect()
    }

    /// Where the polynomial of each column starts in a row, and its degree.
    pub fn columns(&self) -> Vec<(usize, usize)> {
        let column = |first: &mut usize, degree: usize| {
            *first += degree + 1;
            Some((*first - degree - 1, degree))
        };
        self.degrees().into_iter().scan(0, column).collect()
    }

    /// The number of coefficients of a row.
    pub fn width(&self) -> usize {
        self.degrees().iter().map(|degree| degree + 1).sum()
    }

    /// For each chain that stays, the position in the basis of its last monomial.
    pub fn ends(&self) -> Vec<usize> {
        let end = |end: &mut usize, length: &usize| {
            *end += length;
            Some(usize::from(self.order[*end - 1].0))
        };
        self.lengths.iter().scan(0, end).collect()
    }

    /// For each chain that stays, where x^length stands in its own column.
    pub fn leading(&self) -> Vec<usize> {
        self.columns().into_iter().zip(&self.lengths).map(|((first, _), length)| first + length).collect()
    }

    /// The positions in the basis of the eliminated monomials.
    pub fn heads(&self) -> Vec<usize> {
        self.order[self.order.len() - self.eliminated..].iter().map(|b| usize::from(b.0)).collect()
    }

    /// For each coefficient of a row, the basis monomial that it comes from; `None` if it is zero
    /// before others are eliminated.
    pub fn sources(&self) -> Vec<Option<usize>> {
        let mut order = self.order.iter().map(|b| usize::from(b.0));
        let mut sources = Vec::with_capacity(self.width());
        for (&length, degree) in self.lengths.iter().zip(self.degrees()) {
            sources.extend(order.by_ref().take(length).map(Some));
            sources.extend((length..=degree).map(|_| None));
        }
        sources
    }

    /// For each basis monomial, the chain that stays and the power of x, or the number of the
    /// eliminated monomial.
    pub fn places(&self) -> Vec<ChainPlace> {
        let kept = self.lengths.iter().enumerate();
        let kept = kept.flat_map(|(chain, &length)| (0..length).map(move |power| ChainPlace::Kept { chain, power }));
        let places = kept.chain((0..self.eliminated).map(ChainPlace::Eliminated));
        let mut of_basis: Vec<(BasisId, ChainPlace)> = self.order.iter().copied().zip(places).collect();
        of_basis.sort_unstable_by_key(|(b, _)| *b);
        of_basis.into_iter().map(|(_, place)| place).collect()
    }

    /// All minors of the first rows of M(x), as sets of columns, in an order in which each needs
    /// earlier ones only: it is expanded along its last row. Bit j stands for column j.
    pub fn minors(&self) -> Vec<Minor> {
        let mut sets: Vec<usize> = (1..1 << self.lengths.len()).collect();
        sets.sort_by_key(|set| (set.count_ones(), *set));
        sets.into_iter().map(Minor).collect()
    }
}

/// Where the value of a basis monomial comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChainPlace {
    /// The head of this chain times this power of x.
    Kept {
        /// The chain.
        chain: usize,
        /// The power.
        power: usize,
    },
    /// The eliminated monomial of this number.
    Eliminated(usize),
}

/// A minor of the first rows of M(x): the set of its columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Minor(pub usize);

impl Minor {
    /// Its columns.
    pub fn columns(self) -> impl Iterator<Item = usize> {
        (0..usize::BITS as usize).filter(move |column| self.0 >> column & 1 == 1)
    }

    /// The number of its last row.
    pub fn row(self) -> usize {
        self.columns().count() - 1
    }

    /// The expansion along the last row: whether the product is subtracted, the column of the
    /// entry, and the minor that it is multiplied by.
    pub fn products(self) -> impl Iterator<Item = (bool, usize, Minor)> {
        let row = self.row();
        let products = self.columns().enumerate();
        products.map(move |(place, column)| (!(row + place).is_multiple_of(2), column, Minor(self.0 & !(1 << column))))
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
