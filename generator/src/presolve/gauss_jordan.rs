//! Solves the equations for as many of their monomials as there are equations, at run time.
//!
//! ```text
//!                leads    others                          leads    others
//!   equations  [   A    |    B    ]     ->    equations [   I    |  A^-1 B  ]
//! ```
//!
//! A template finds the same combinations of equations with constant coefficients, but needs a row
//! and a pivot for each multiple of a lead that it eliminates. Which monomials lead decides how
//! large it becomes: with the highest ones by degree in all unknowns but a hidden one, equations
//! have chains of few monomials over the hidden one (three quadrics, solved for x^2, x y and y^2:
//! Kukelova, Heller, Fitzgibbon, "Efficient intersection of three quadrics", CVPR 2016).
//!
//! A is singular for some data although the problem is not. The template then has no coefficients,
//! and the solutions are followed from data nearby.

use crate::algebra::{Monomial, PrimeField};
use crate::expression::derivation::DerivationKind;
use crate::expression::{ExpressionGraph, ExpressionId, FINGERPRINT_FIELDS, SymbolicPolynomial};
use crate::problem::Problem;

/// Larger systems are left to the template.
const MOST_EQUATIONS: usize = 64;
const MOST_MONOMIALS: usize = 512;

/// Solves the linear equations for as many unknowns as there are equations. Returns false, and
/// changes nothing, where there are none to be combined.
pub(super) fn solve_linear_equations(problem: &mut Problem) -> bool {
    let linear: Vec<usize> =
        problem.polynomials().enumerate().filter(|(_, p)| p.degree() == 1).map(|(at, _)| at).collect();
    solve(problem, &linear, None)
}

/// Solves the equations for their highest monomials: by degree in all unknowns but the hidden one,
/// then by total degree. Equations that share no lead with others stay as they are: their scale
/// does not matter. Returns false, and changes nothing, where nothing can be eliminated.
pub(super) fn solve_for_leads(problem: &mut Problem, hidden: Option<usize>) -> bool {
    let all: Vec<usize> = (0..problem.equations.len()).collect();
    solve(problem, &all, hidden)
}

/// Solves these equations for their highest monomials.
fn solve(problem: &mut Problem, equations: &[usize], hidden: Option<usize>) -> bool {
    let of = |at: &usize| &problem.equations[*at].polynomial;
    let mut monomials: Vec<Monomial> = equations.iter().flat_map(|at| of(at).monomials()).collect();
    monomials.sort_by_key(|m| std::cmp::Reverse(rank(m, hidden)));
    monomials.dedup();
    if equations.len() > MOST_EQUATIONS || monomials.len() > MOST_MONOMIALS {
        return false;
    }
    let Some(leads) = leads(problem, equations, &monomials) else { return false };
    let groups = groups(problem, &leads);
    let solved: Option<Vec<Vec<SymbolicPolynomial>>> =
        groups.iter().map(|group| solved(problem, group, &monomials)).collect();
    let (Some(solved), true) = (solved, groups.iter().any(|group| group.len() > 1)) else { return false };
    for (group, polynomials) in groups.iter().zip(solved) {
        for (&(equation, _), polynomial) in group.iter().zip(polynomials) {
            problem.equations[equation].polynomial = polynomial;
        }
    }
    // Equations that depend on others go.
    let mut at = 0..;
    let is_kept = |at: usize| !equations.contains(&at) || leads.iter().any(|&(equation, _)| equation == at);
    problem.equations.retain(|_| at.next().is_some_and(is_kept));
    true
}

/// The order of monomials.
fn rank(m: &Monomial, hidden: Option<usize>) -> (i32, i32, Monomial) {
    let of_hidden = hidden.map_or(0, |unknown| i32::from(m.exponent(unknown)));
    (m.degree() - of_hidden, m.degree(), *m)
}

/// An equation and the monomial that it is solved for.
type Lead = (usize, Monomial);

/// Elimination with the values at a random point: the monomials that lead, highest first, each with
/// the equation that is its pivot there. Equations that depend on others lead nothing.
fn leads(problem: &Problem, equations: &[usize], monomials: &[Monomial]) -> Option<Vec<Lead>> {
    let f: PrimeField = FINGERPRINT_FIELDS[0];
    let value = |p: &SymbolicPolynomial, m: &Monomial| {
        p.coefficient(m).map_or(0, |&coefficient| problem.graph.fingerprint(coefficient)[0])
    };
    let row = |at: usize| monomials.iter().map(|m| value(&problem.equations[at].polynomial, m)).collect();
    let mut rows: Vec<(usize, Vec<u32>)> = equations.iter().map(|&at| (at, row(at))).collect();
    let mut leads = Vec::new();
    for (column, &monomial) in monomials.iter().enumerate() {
        let Some(pivot) = rows.iter().position(|(_, row)| row[column] != 0) else { continue };
        let (equation, of_pivot) = rows.remove(pivot);
        let inverse = f.inverse(of_pivot[column])?;
        for (_, row) in &mut rows {
            let factor = f.mul(row[column], inverse);
            if factor != 0 {
                let pairs = row.iter_mut().zip(&of_pivot).skip(column);
                pairs.for_each(|(entry, &of)| *entry = f.sub(*entry, f.mul(factor, of)));
            }
        }
        leads.push((equation, monomial));
    }
    Some(leads)
}

/// The leads in groups: those of equations that share leads, directly or by way of others.
fn groups(problem: &Problem, leads: &[Lead]) -> Vec<Vec<Lead>> {
    let mut groups: Vec<Vec<Lead>> = Vec::new();
    for &(equation, monomial) in leads {
        let shares = |group: &Vec<Lead>| {
            let has = |equation: usize, m: &Monomial| problem.equations[equation].polynomial.coefficient(m).is_some();
            group.iter().any(|(other, of_other)| has(*other, &monomial) || has(equation, of_other))
        };
        let (together, mut apart): (Vec<_>, Vec<_>) = groups.into_iter().partition(shares);
        let mut group: Vec<Lead> = together.into_iter().flatten().collect();
        group.push((equation, monomial));
        apart.push(group);
        groups = apart;
    }
    groups
}

/// The equations of a group, solved for their leads.
fn solved(problem: &mut Problem, group: &[Lead], monomials: &[Monomial]) -> Option<Vec<SymbolicPolynomial>> {
    let polynomials: Vec<SymbolicPolynomial> =
        group.iter().map(|&(equation, _)| problem.equations[equation].polynomial.clone()).collect();
    if group.len() == 1 {
        return Some(polynomials);
    }
    let is_lead = |m: &Monomial| group.iter().any(|(_, lead)| lead == m);
    let occurs = |m: &&Monomial| polynomials.iter().any(|p| p.coefficient(m).is_some());
    let others: Vec<Monomial> = monomials.iter().filter(|m| !is_lead(m)).filter(occurs).copied().collect();
    let entry = |p: &SymbolicPolynomial, m: &Monomial| p.coefficient(m).copied().unwrap_or(ExpressionGraph::ZERO);
    let of_leads = polynomials.iter().flat_map(|p| group.iter().map(move |(_, lead)| entry(p, lead)));
    let of_others = polynomials.iter().flat_map(|p| others.iter().map(move |m| entry(p, m)));
    let operands: Vec<ExpressionId> = of_leads.chain(of_others).collect();
    let kind = DerivationKind::Solve { size: group.len(), right: others.len() };
    let graph = &mut problem.graph;
    let results = if others.is_empty() { Vec::new() } else { graph.derive(kind, &operands)? };
    let row = |(at, &(_, lead)): (usize, &Lead)| {
        let coefficients = results.iter().skip(at * others.len()).copied();
        let terms = others.iter().copied().zip(coefficients).filter(|&(_, c)| !graph.is_zero(c));
        SymbolicPolynomial::from_terms(std::iter::once((lead, ExpressionGraph::ONE)).chain(terms).collect())
    };
    Some(group.iter().enumerate().map(row).collect())
}

#[cfg(test)]
mod tests {
    use crate::presolve::{Presolve, presolve};
    use crate::problem::Problem;

    const QUADRICS: &str = "fn quadrics(q: [[f64; 10]; 3]) -> (x, y, z) {
        q * [x * x, x * y, x * z, y * y, y * z, z * z, x, y, z, 1] == 0;
    }";

    fn leads(text: &str, how: Presolve) -> Vec<String> {
        let problem = Problem::parse("sample.rs", text).unwrap();
        let reduced = presolve(&problem, how).problem;
        let graph = &reduced.graph;
        let first = |p: &crate::expression::SymbolicPolynomial| {
            let lead = p.terms().iter().filter(|(_, c)| graph.as_constant(*c).is_some());
            let leads: Vec<String> = lead.map(|(m, _)| m.display(&reduced.unknowns).to_string()).collect();
            format!("{} of {}", leads.join(" "), p.terms().len())
        };
        reduced.polynomials().map(first).collect()
    }

    #[test]
    fn quadrics_are_solved_for_what_is_highest_beside_the_hidden_unknown() {
        assert_eq!(leads(QUADRICS, Presolve::Hiding(2)), ["x^2 of 8", "x*y of 8", "y^2 of 8"]);
        assert_eq!(leads(QUADRICS, Presolve::Hiding(0)), ["y^2 of 8", "y*z of 8", "z^2 of 8"]);
    }

    /// Linear equations are solved apart from the others, and give their unknowns.
    #[test]
    fn linear_equations_are_solved_first() {
        let text = "fn rays(a: [[f64; 4]; 2], b: [f64; 3]) -> (x, y, z) {
            a * [x, y, z, 1] == 0;
            x * x + b[0] * y * z + b[1] * z == b[2];
        }";
        let problem = Problem::parse("sample.rs", text).unwrap();
        let reduced = presolve(&problem, Presolve::Eliminated);
        assert_eq!((reduced.kept.len(), reduced.recoveries.len(), reduced.problem.equations.len()), (1, 2, 1));
        assert_eq!(reduced.problem.equations[0].polynomial.degree(), 2);
        assert_eq!(reduced.problem.graph.derivations().len(), 1);
    }

    /// Equations that share no lead with others, and those that depend on others.
    #[test]
    fn groups_are_solved_apart() {
        let text = "fn apart(a: [[f64; 3]; 2], b: [f64; 3]) -> (x, y, z, w) {
            a * [x * x, x * y, 1] == 0;
            b[0] * z.pow(3) == b[1] * z + b[2];
            a[0][0] * x * x + a[0][1] * x * y + a[0][2] + w.pow(3) == 1;
            2 * w.pow(3) == 2;
        }";
        let found = leads(text, Presolve::Solved);
        assert_eq!(found.len(), 4, "{found:?}");
        assert!(found.contains(&" of 3".to_owned()), "{found:?}");
    }
}
