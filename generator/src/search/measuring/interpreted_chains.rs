//! The chains of a plan for the runtime's kernels, without compiling them: the operations of
//! emitted code in the same order, by loops over tables.

use eliminant::emitted::{self, Arithmetic, ChainTable, Dynamic};

use crate::plan::Chains;
use crate::plan::chains::{ChainPlace, Minor};

/// The chains of a basis, in the runtime's form.
#[derive(Clone, Debug)]
pub struct InterpretedChains {
    basis: usize,
    ends: Vec<u16>,
    leading: Vec<u16>,
    degrees: Vec<u16>,
    heads: Vec<u16>,
    columns: Vec<(usize, usize)>,
    sources: Vec<Option<usize>>,
    minors: Vec<Minor>,
    places: Vec<ChainPlace>,
}

/// No chains.
pub(super) static NONE: InterpretedChains = InterpretedChains {
    basis: 0,
    ends: Vec::new(),
    leading: Vec::new(),
    degrees: Vec::new(),
    heads: Vec::new(),
    columns: Vec::new(),
    sources: Vec::new(),
    minors: Vec::new(),
    places: Vec::new(),
};

impl InterpretedChains {
    pub(super) fn of(chains: &Chains) -> Self {
        let short = |list: Vec<usize>| list.into_iter().map(|number| number as u16).collect();
        Self {
            basis: chains.order.len(),
            ends: short(chains.ends()),
            leading: short(chains.leading()),
            degrees: short(chains.degrees()),
            heads: short(chains.heads()),
            columns: chains.columns(),
            sources: chains.sources(),
            minors: chains.minors(),
            places: chains.places(),
        }
    }

    fn entry<'r, T>(&self, row: &'r [T], column: usize) -> &'r [T] {
        let (first, degree) = self.columns[column];
        &row[first..=first + degree]
    }
}

impl emitted::ChainedBasis for &InterpretedChains {
    type Basis = Dynamic;
    type Count = Dynamic;
    type Width = Dynamic;
    type Coefficients = Dynamic;

    fn sizes(&self) -> (Dynamic, Dynamic, Dynamic, Dynamic) {
        (Dynamic(self.basis), Dynamic(self.columns.len()), Dynamic(self.sources.len()), Dynamic(self.basis + 1))
    }

    fn table(&self) -> ChainTable<'_> {
        ChainTable { ends: &self.ends, leading: &self.leading, degrees: &self.degrees, heads: &self.heads }
    }

    fn polynomials<T: Arithmetic>(&self, row: &Vec<T>) -> Vec<T> {
        let zero = row[0].constant(0.0);
        self.sources.iter().map(|source| source.map_or(zero, |b| -row[b])).collect()
    }

    fn determinant<T: Arithmetic>(&self, rows: &Vec<Vec<T>>) -> Vec<T> {
        let zero = rows[0][0].constant(0.0);
        let mut known = vec![Vec::new(); 1 << self.columns.len()];
        for &minor in &self.minors {
            let entry = |column: usize| self.entry(&rows[minor.row()], column);
            if minor.row() == 0 {
                known[minor.0] = minor.columns().flat_map(entry).copied().collect();
                continue;
            }
            let mut sum = vec![zero; minor.columns().map(|column| self.columns[column].1).sum::<usize>() + 1];
            for (is_negative, column, others) in minor.products() {
                for (shift, &factor) in entry(column).iter().enumerate() {
                    for (sum, &value) in sum[shift..].iter_mut().zip(&known[others.0]) {
                        *sum += if is_negative { -(factor * value) } else { factor * value };
                    }
                }
            }
            known[minor.0] = sum;
        }
        known.pop().unwrap_or_default()
    }

    fn row_at<T: Arithmetic>(&self, row: &Vec<T>, x: T) -> Vec<T> {
        let value = |column| self.entry(row, column).iter().rev().fold(x.constant(0.0), |sum, &c| sum * x + c);
        (0..self.columns.len()).map(value).collect()
    }

    fn vector<T: Arithmetic>(&self, x: T, heads: &Vec<T>, eliminated: &Vec<T>) -> Vec<T> {
        // A product of x with itself, one factor after another.
        let power = |power: usize| (1..power).fold(x, |product, _| product * x);
        let value = |place: &ChainPlace| match *place {
            ChainPlace::Kept { chain, power: 0 } => heads[chain],
            ChainPlace::Kept { chain, power: exponent } => heads[chain] * power(exponent),
            ChainPlace::Eliminated(number) => eliminated[number],
        };
        self.places.iter().map(value).collect()
    }
}
