//! How many solutions a template gives, counted over Z_p without a Gröbner basis.
//!
//! Each solution z gives an eigenpair of the action matrix T. The eigenvalue is the value a(z) of
//! the action monomial, and the eigenvector holds the values of the basis monomials. Other
//! eigenpairs belong to no solution; an emitted solver finds out by the equations. The same is done
//! here exactly, for all eigenpairs at once:
//!
//! 1. [`Eigenpair`] gives polynomials v(t) that are the eigenvector at each eigenvalue t with one
//!    eigenvector. s(t) is the polynomial whose roots are these eigenvalues, each once.
//! 2. An unknown x is the ratio v_(xm)(t) / v_m(t) modulo s, a division by extended Euclid. Where
//!    v_m has a factor in common with s, x is read from another pair at its roots. s is then split,
//!    and each part is treated by itself (the D5 principle: Della Dora, Dicrescenzo, Duval, "About
//!    a new method for computing in algebraic number fields", EUROCAL 1985).
//! 3. Unknowns that presolve eliminated follow; those of a linear block by least squares, where its
//!    normal equations have one solution. All equations as stated are evaluated modulo s. The
//!    greatest common divisor of s and their values has the solutions for roots; those where a
//!    factor that must not vanish does are divided out.
//! 4. Where signs can be changed some unknowns are square roots x of residues X(t). Values are then
//!    sums of residues times products of roots (`super::residues`). A root t stands for a
//!    solution for each choice of the signs of the x that are not 0.
//! 5. The origin of the unknowns that presolve kept needs no eigenpair if it is a solution. It is
//!    counted once, and divided out where an eigenpair gives it.
//!
//! An eigenvalue with several eigenvectors may belong to as many solutions, which share a value of
//! a. These are not looked into: they make the number uncertain, as do eigenpairs from which an
//! unknown cannot be read.

use std::fmt;

use super::interpret::Eliminated;
use super::residues::{Element, Residues};
use super::system_table::SystemTable;
use super::{Extraction, KnownMonomial, Plan, PlannedBlock, Term};
use crate::algebra::{DenseMatrix, Eigenpair, Monomial, PrimeField, Random, Univariate};

/// Bounds on the number of different solutions. They are equal unless an eigenvalue has several
/// eigenvectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SolutionBounds {
    /// The solutions that are certain.
    pub least: usize,
    /// These and all that are possible.
    pub most: usize,
}

impl fmt::Display for SolutionBounds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.is_exact() {
            true => write!(f, "{}", self.least),
            false => write!(f, "{} to {}", self.least, self.most),
        }
    }
}

impl SolutionBounds {
    /// Whether the number is known.
    pub fn is_exact(self) -> bool {
        self.least == self.most
    }

    /// Whether a number of solutions is possible.
    pub fn allows(self, solutions: usize) -> bool {
        (self.least..=self.most).contains(&solutions)
    }
}

/// The seed of the random vector and of the random combination of the equations; any constant does.
const SEED: u64 = 0x636f_756e_7465_6421;

/// Counts the solutions that a plan gives on an instance over Z_p, of which the values of the
/// coefficients and the result of the elimination are given. `action` is the action monomial.
///
/// Random choices can make it wrong with a probability of about |B| / p, below 10^-6.
pub fn count_solutions(
    plan: &Plan,
    action: &Monomial,
    field: PrimeField,
    coefficients: &[u32],
    eliminated: &Eliminated<u32>,
) -> SolutionBounds {
    let matrix = DenseMatrix::from_rows(field, plan.elimination.basis, &eliminated.action);
    let eigenpair = Eigenpair::of(&matrix, &mut Random::new(SEED));
    let counter = Counter { plan, action, field, coefficients, eliminated, eigenpair };
    counter.count()
}

/// What all steps of the count read.
struct Counter<'a> {
    plan: &'a Plan,
    action: &'a Monomial,
    field: PrimeField,
    coefficients: &'a [u32],
    eliminated: &'a Eliminated<u32>,
    eigenpair: Eigenpair,
}

/// Some of the eigenpairs, the roots of a modulus, with the unknowns that are read so far.
#[derive(Clone)]
struct Branch {
    residues: Residues,
    /// One for each unknown.
    unknowns: Vec<Element>,
}

impl Branch {
    /// The same on some of the roots of the modulus.
    fn restricted_to(&self, modulus: Univariate) -> Self {
        let field = self.residues.field;
        let squares = self.residues.squares.iter().map(|(x, square)| (*x, square.modulo(field, &modulus)));
        let residues = Residues { field, squares: squares.collect(), modulus };
        Self { unknowns: self.unknowns.iter().map(|element| residues.reduced(element)).collect(), residues }
    }

    /// Whether there are no eigenpairs in it.
    fn is_empty(&self) -> bool {
        self.residues.modulus.degree() == 0
    }

    /// How many solutions a root of the modulus stands for.
    fn signs(&self) -> usize {
        1 << self.residues.squares.len()
    }
}

impl Counter<'_> {
    fn count(&self) -> SolutionBounds {
        let (modulus, shared) = self.split_by_eigenvectors();
        let orbit = 1 + self.plan.images.len();
        let origin = usize::from(self.plan.has_origin);
        let mut count = SolutionBounds { least: origin, most: origin + orbit * shared };
        let residues = Residues { field: self.field, modulus, squares: Vec::new() };
        let mut branches = vec![Branch { residues, unknowns: vec![Element::default(); self.plan.unknowns.len()] }];
        // An unknown that no extraction and no recovery gives does not occur: the plan is checked
        // for that.
        for extraction in &self.plan.extractions {
            let mut read = Vec::new();
            for branch in branches {
                let unread = self.read(branch, extraction, &mut read);
                count.most += orbit * unread;
            }
            branches = read;
        }
        for branch in branches {
            let mut branch = self.with_block(branch);
            // A linear form may stand in the place of an unknown until that is recovered.
            let action = self.action_parts(&branch);
            self.recover(&mut branch);
            let solutions = self.solutions(&branch, action);
            count.least += solutions.least;
            count.most += solutions.most;
        }
        count
    }

    /// The polynomial of the eigenvalues with one eigenvector, and how many eigenvectors the others
    /// have at most.
    fn split_by_eigenvectors(&self) -> (Univariate, usize) {
        let field = self.field;
        let all = self.eigenpair.minimal().squarefree_part(field);
        let others = self.eigenpair.others();
        let single = others.iter().fold(all.clone(), |single, other| single.over(field, &single.gcd(field, other)));
        let mut shared = all.over(field, &single);
        if self.action.exponents().iter().all(|&e| e <= 0) {
            // The reciprocal of a product of unknowns is not 0 at any solution.
            shared = shared.over(field, &shared.gcd(field, &Univariate::t()));
        }
        let further: usize = others.iter().map(|other| shared.gcd(field, other).degree()).sum();
        (single, shared.degree() + further)
    }

    /// Reads an unknown from the first pair that can be divided, on each part of a branch. Returns
    /// at how many roots there is no such pair.
    fn read(&self, mut branch: Branch, extraction: &Extraction, read: &mut Vec<Branch>) -> usize {
        for &(from, to) in &extraction.pairs {
            if branch.is_empty() {
                break;
            }
            let (denominator, numerator) = (self.value(&branch, from), self.value(&branch, to));
            let zeros = denominator.gcd(self.field, &branch.residues.modulus);
            let readable = branch.restricted_to(branch.residues.modulus.over(self.field, &zeros));
            let modulus = &readable.residues.modulus;
            if let Some(inverse) = denominator.inverse_modulo(self.field, modulus)
                && !readable.is_empty()
            {
                let ratio = numerator.times(self.field, &inverse).modulo(self.field, modulus);
                self.assign(readable, extraction, &ratio, read);
            }
            branch = branch.restricted_to(zeros);
        }
        branch.residues.modulus.degree()
    }

    /// The value of a monomial modulo the modulus of a branch.
    fn value(&self, branch: &Branch, monomial: KnownMonomial) -> Univariate {
        let value = match monomial {
            KnownMonomial::Basis(b) => self.eigenpair.entry(usize::from(b.0)),
            KnownMonomial::Image(b) => self.eigenpair.entry(usize::from(b.0)).times(self.field, &Univariate::t()),
            KnownMonomial::Read(at) => self.eigenpair.combination(&self.eliminated.read[usize::from(at)]),
        };
        value.modulo(self.field, &branch.residues.modulus)
    }

    /// Sets the unknown of an extraction from its ratio.
    fn assign(&self, branch: Branch, extraction: &Extraction, ratio: &Univariate, read: &mut Vec<Branch>) {
        if extraction.is_square() {
            self.assign_root(&branch, extraction.unknown, ratio, read);
            return;
        }
        // The ratio is the unknown times roots or their reciprocals.
        let mut branch = branch;
        let mut value = branch.residues.element(ratio);
        for (root, exponent) in extraction.others() {
            let factor = match exponent {
                // A root that is 0 has no reciprocal; then the monomials of the pair vanish, and no
                // ratio is there.
                1 => branch.residues.inverse_root(root).unwrap_or_default(),
                _ => branch.unknowns[root].clone(),
            };
            value = branch.residues.product(&value, &factor);
        }
        branch.unknowns[extraction.unknown] = value;
        read.push(branch);
    }

    /// Sets an unknown to the square root of a ratio. Where the ratio is 0 the unknown is 0 and has
    /// one sign only.
    fn assign_root(&self, branch: &Branch, unknown: usize, ratio: &Univariate, read: &mut Vec<Branch>) {
        let zeros = ratio.gcd(self.field, &branch.residues.modulus);
        let mut other = branch.restricted_to(branch.residues.modulus.over(self.field, &zeros));
        let square = ratio.modulo(self.field, &other.residues.modulus);
        other.residues.squares.push((unknown, square));
        other.unknowns[unknown] = other.residues.root(unknown);
        let zero = branch.restricted_to(zeros);
        read.extend([other, zero].into_iter().filter(|part| !part.is_empty()));
    }

    /// The part of a branch where the linear block determines its unknowns, with these. Elsewhere
    /// are no solutions: none or infinitely many belong to a singular block.
    fn with_block(&self, mut branch: Branch) -> Branch {
        let Some(block) = &self.plan.linear else { return branch };
        let (n, minus_one) = (block.unknowns.len(), self.field.neg(1));
        let mut rows = self.normal_equations(&branch, block);
        for pivot in 0..n {
            let (norm, conjugates) = branch.residues.norm(&rows[pivot][pivot]);
            let zeros = norm.gcd(self.field, &branch.residues.modulus);
            branch = branch.restricted_to(branch.residues.modulus.over(self.field, &zeros));
            let residues = &branch.residues;
            rows.iter_mut().flatten().for_each(|entry| *entry = residues.reduced(entry));
            let Some(inverse) = norm.inverse_modulo(self.field, &residues.modulus) else { return branch };
            let inverse = residues.product(&residues.element(&inverse), &residues.reduced(&conjugates));
            let mut of_pivot = std::mem::take(&mut rows[pivot]);
            of_pivot.iter_mut().for_each(|entry| *entry = residues.product(entry, &inverse));
            for row in rows.iter_mut().filter(|row| !row.is_empty()) {
                let factor = row[pivot].clone();
                for (entry, of_pivot) in row.iter_mut().zip(&of_pivot) {
                    residues.add_multiple(entry, minus_one, &residues.product(&factor, of_pivot));
                }
            }
            rows[pivot] = of_pivot;
        }
        for (&unknown, row) in block.unknowns.iter().zip(&rows) {
            branch.unknowns[unknown] = Element::default();
            branch.residues.add_multiple(&mut branch.unknowns[unknown], minus_one, &row[n]);
        }
        branch
    }

    /// \[A^T A | A^T b\] of a linear block.
    fn normal_equations(&self, branch: &Branch, block: &PlannedBlock) -> Vec<Vec<Element>> {
        let n = block.unknowns.len();
        let entries: Vec<Vec<Term>> = block.rows.iter().flatten().cloned().collect();
        let entries = self.evaluate(branch, &entries);
        let mut normal = vec![vec![Element::default(); n + 1]; n];
        for row in entries.chunks(n + 1) {
            for (i, j) in (0..n).flat_map(|i| (0..=n).map(move |j| (i, j))) {
                branch.residues.add_multiple(&mut normal[i][j], 1, &branch.residues.product(&row[i], &row[j]));
            }
        }
        normal
    }

    /// The other unknowns that presolve eliminated.
    fn recover(&self, branch: &mut Branch) {
        for recovery in &self.plan.recoveries {
            let values = self.evaluate(branch, std::slice::from_ref(&recovery.terms));
            branch.unknowns[recovery.unknown] = values.into_iter().next().unwrap_or_default();
        }
    }

    /// The solutions among the eigenpairs of a branch of which all unknowns are known, with the
    /// numerator and denominator of the action monomial.
    fn solutions(&self, branch: &Branch, (mut difference, denominator): (Element, Element)) -> SolutionBounds {
        let field = self.field;
        let residues = &branch.residues;
        let mut random = Random::new(SEED);
        let mut sum = Element::default();
        for value in self.evaluate(branch, &self.plan.equations) {
            // A combination with random factors vanishes where all equations do.
            residues.add_multiple(&mut sum, random.below(u64::from(field.modulus())) as u32, &value);
        }
        let mut solutions = residues.zeros(&sum);
        for factor in self.evaluate(branch, &self.plan.nonzero) {
            let excluded = solutions.gcd(field, &residues.zeros(&factor));
            solutions = solutions.over(field, &excluded);
        }
        if self.plan.has_origin {
            let kept = self.plan.extractions.iter().map(|extraction| &branch.unknowns[extraction.unknown]);
            let origin = kept.fold(solutions.clone(), |origin, unknown| {
                unknown.residues().fold(origin, |origin, residue| origin.gcd(field, residue))
            });
            solutions = solutions.over(field, &origin);
        }
        // An eigenvector of no solution may give a solution all the same: that of another
        // eigenvalue.
        let product = residues.product(&denominator, &residues.element(&Univariate::t()));
        residues.add_multiple(&mut difference, field.neg(1), &product);
        let own = solutions.gcd(field, &residues.zeros(&difference));
        let undefined = own.gcd(field, &residues.zeros(&denominator));
        let certain = own.degree() - undefined.degree();
        SolutionBounds { least: branch.signs() * certain, most: branch.signs() * solutions.degree() }
    }

    /// Numerator and denominator of the action monomial.
    fn action_parts(&self, branch: &Branch) -> (Element, Element) {
        let residues = &branch.residues;
        let power = |sign: i8| {
            let one = residues.element(&Univariate::constant(1));
            branch.unknowns.iter().enumerate().fold(one, |product, (at, x)| {
                let exponent = (sign * self.action.exponent(at)).max(0);
                (0..exponent).fold(product, |product, _| residues.product(&product, x))
            })
        };
        (power(1), power(-1))
    }

    /// The values of polynomials in the unknowns.
    fn evaluate(&self, branch: &Branch, polynomials: &[Vec<Term>]) -> Vec<Element> {
        let residues = &branch.residues;
        let table = SystemTable::of(polynomials, branch.unknowns.len());
        let mut monomials = vec![residues.element(&Univariate::constant(1))];
        for &(parent, unknown) in table.chain.iter().skip(1) {
            let product = residues.product(&monomials[usize::from(parent)], &branch.unknowns[usize::from(unknown)]);
            monomials.push(product);
        }
        let mut first = 0;
        let mut value = |&end: &u32| {
            let terms = &table.terms[std::mem::replace(&mut first, end as usize)..end as usize];
            let mut sum = Element::default();
            for &(coefficient, monomial) in terms {
                let c = self.coefficients[usize::from(coefficient)];
                residues.add_multiple(&mut sum, c, &monomials[usize::from(monomial)]);
            }
            sum
        };
        table.ends.iter().map(&mut value).collect()
    }
}
