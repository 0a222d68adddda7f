//! Which chains a determinant is made of.

use std::fs;

use eliminant_generator::algebra::{PRIMES, PrimeField, Random};
use eliminant_generator::generate::{GenerateError, plan};
use eliminant_generator::plan::{ActionRow, BasisId, Chains, PivotId};
use eliminant_generator::problem::Problem;
use eliminant_generator::template::RootMethod;
use eliminant_generator::template::file::TemplateFile;

const FIELD: PrimeField = PrimeField::new(PRIMES[0]);

/// An action matrix whose basis falls into chains of these lengths, one after another, with random
/// numbers in the last row of each.
fn action(lengths: &[usize]) -> (Vec<ActionRow>, Vec<Vec<u32>>) {
    let (size, mut random) = (lengths.iter().sum::<usize>(), Random::new(1));
    let (mut rows, mut values) = (Vec::new(), Vec::new());
    for &length in lengths {
        for place in 1..=length {
            let next = rows.len() + 1;
            rows.push(if place < length {
                ActionRow::Unit(BasisId(next as u16))
            } else {
                ActionRow::Solved(PivotId(0))
            });
            let number = |column: usize| match place < length {
                true => u32::from(column == next),
                false => FIELD.from_integer(random.below(1 << 30) as i64),
            };
            values.push((0..size).map(number).collect());
        }
    }
    (rows, values)
}

fn chains(lengths: &[usize]) -> Option<Chains> {
    let (rows, values) = action(lengths);
    Chains::of(&rows, FIELD, &values)
}

/// The lengths of the chains that stay, and the number of eliminated ones.
fn shape(chains: Option<Chains>) -> Option<(Vec<usize>, usize)> {
    chains.map(|chains| (chains.lengths, chains.eliminated))
}

#[test]
fn short_chains_eliminate_chains_of_one_monomial() {
    assert_eq!(shape(chains(&[3, 1, 2, 1, 2, 1])), Some((vec![2, 2, 3], 3)));
    assert_eq!(shape(chains(&[4, 1, 2, 3])), Some((vec![2, 3, 4], 1)));
    assert_eq!(shape(chains(&[2, 1, 1])), Some((vec![2, 1], 1)), "one longer chain for two");
    assert_eq!(shape(chains(&[7])), Some((vec![7], 0)));
    let found = chains(&[3, 1, 2]).unwrap();
    assert_eq!(found.order, [4, 5, 0, 1, 2, 3].map(BasisId), "the longer chain that is used, the other, the head");
}

/// A row eliminates a chain only if it holds its monomial, and two rows two chains if they are
/// independent.
#[test]
fn dependent_rows_eliminate_less() {
    let (rows, mut values) = action(&[2, 2, 1, 1]);
    let eliminated = |values: &[Vec<u32>]| Chains::of(&rows, FIELD, values).map(|chains| chains.eliminated);
    assert_eq!(eliminated(&values), Some(2));
    // The ends of the longer chains are 1 and 3, the heads 4 and 5.
    (values[3][4], values[3][5]) = (values[1][4], values[1][5]);
    assert_eq!(eliminated(&values), Some(1));
    for end in [1, 3] {
        (values[end][4], values[end][5]) = (0, 0);
    }
    assert_eq!(eliminated(&values), Some(0));
}

#[test]
fn many_chains_and_high_degrees_are_left_to_the_eigenvalues() {
    assert!(chains(&[2; 6]).is_some() && chains(&[2; 7]).is_none());
    assert!(chains(&[9, 9]).is_some() && chains(&[9, 10]).is_none());
    assert!(chains(&[1; 6]).is_some() && chains(&[1; 7]).is_none());
}

/// A template file that asks for what its basis cannot give is refused with what to write instead.
#[test]
fn a_basis_that_is_not_for_a_determinant_is_refused() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../templates");
    let text = |extension: &str| {
        fs::read_to_string(format!("{folder}/pose_6pt_rolling_shutter.{extension}")).expect("a committed file")
    };
    let problem = Problem::parse("problem.rs", &text("rs")).expect("a problem");
    let mut file = TemplateFile::parse(&text("template.toml"), &problem.unknowns).expect("a template file");
    assert!(plan(&problem, &file).is_ok());
    file.roots = RootMethod::Determinant;
    let error = plan(&problem, &file).expect_err("20 chains");
    assert!(matches!(error, GenerateError::Chains) && error.is_stale_template(), "{error}");
    assert!(error.to_string().contains("expected `roots = \"eigenvalues\"`"), "{error}");
}
