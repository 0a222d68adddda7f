//! Random data of a problem over Z_p, and the polynomials they give.

use super::Problem;
use super::data::DataParameter;
use super::draw::{MAX_REDRAWS, draw_inputs, redraw};
use crate::algebra::{Polynomial, PrimeField, Random};
use crate::expression::derivation::DerivationKind;
use crate::expression::{ExpressionGraph, ExpressionId, FINGERPRINT_FIELDS, NoValue, SymbolicPolynomial};

/// The seed of the fingerprint points; any constant does.
const FINGERPRINT_SEED: u64 = 0x656c_696d_696e_616e;

/// The two points at which expressions are told apart, see [`crate::expression::ExpressionGraph`].
pub fn fingerprint_points(data: &[DataParameter]) -> [Vec<u32>; 2] {
    let mut random = Random::new(FINGERPRINT_SEED);
    FINGERPRINT_FIELDS.map(|field| draw_inputs(data, field, &mut random))
}

/// Draws data over Z_p, and the values of all nodes, so that all square roots exist there: where
/// one does not, some of what it depends on is drawn again, as long as the roots before it exist.
/// `None` if that does not end.
fn draw_with_roots(problem: &Problem, f: PrimeField, random: &mut Random) -> Option<(Vec<u32>, Vec<u32>)> {
    let mut inputs = draw_inputs(&problem.data, f, random);
    let (mut next, mut missing) = (inputs.clone(), 0);
    for _ in 0..=MAX_REDRAWS * problem.graph.derivations().len() {
        match problem.graph.try_evaluate(f, &next) {
            Ok(values) => return Some((next, values)),
            Err(NoValue::Derivation(number)) if number >= missing => (inputs, missing) = (next, number),
            Err(NoValue::Derivation(_)) => {}
            Err(_) => return None,
        }
        next = inputs.clone();
        let operands = &problem.graph.derivations()[missing].operands;
        let which = redrawn(&problem.graph, missing, operands, random);
        redraw(&problem.data, (f, random), &mut next, &which);
    }
    None
}

/// Which of the given inputs are drawn again where the derivation of this number, of these
/// operands, has no value: those that it depends on and no square root before it does. If there are
/// none, one of all that it depends on.
pub(super) fn redrawn(
    graph: &ExpressionGraph,
    number: usize,
    operands: &[ExpressionId],
    random: &mut Random,
) -> Vec<bool> {
    let given = graph.derivations().first().map_or(graph.input_count(), |first| first.first_input);
    let mut own = graph.given_inputs_of(operands, given);
    let roots = graph.derivations()[..number].iter().filter(|before| before.kind == DerivationKind::SquareRoot);
    let before: Vec<ExpressionId> = roots.flat_map(|root| root.operands.iter().copied()).collect();
    let fixed = graph.given_inputs_of(&before, given);
    if own.iter().zip(&fixed).any(|(&own, &fixed)| own && !fixed) {
        own.iter_mut().zip(fixed).for_each(|(own, fixed)| *own &= !fixed);
        return own;
    }
    let all: Vec<usize> = (0..given).filter(|&input| own[input]).collect();
    let chosen = all.get(random.below(all.len().max(1) as u64) as usize).copied();
    (0..given).map(|input| Some(input) == chosen).collect()
}

/// A problem with random data over Z_p.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Instance {
    /// The field.
    pub field: PrimeField,
    /// The values of the inputs.
    pub inputs: Vec<u32>,
    /// The equations.
    pub equations: Vec<Polynomial<u32>>,
    /// The polynomials that must not vanish.
    pub nonzero: Vec<Polynomial<u32>>,
}

impl Instance {
    /// Draws one. The support equals that of the problem: an instance on which a coefficient that
    /// depends on the data vanishes is drawn again; `None` if that never ends (for tiny domains
    /// such as `#[integer]` data it may).
    pub fn draw(problem: &Problem, field: PrimeField, seed: u64) -> Option<Self> {
        let mut random = Random::new(seed);
        (0..MAX_REDRAWS).find_map(|_| {
            let (inputs, values) = draw_with_roots(problem, field, &mut random)?;
            let image = |polynomial: &SymbolicPolynomial| {
                let image = polynomial.map(|c| Some(values[c.index()]).filter(|&value| value != 0));
                (image.terms().len() == polynomial.terms().len()).then_some(image)
            };
            Some(Self {
                field,
                equations: problem.polynomials().map(image).collect::<Option<_>>()?,
                nonzero: problem.nonzero.iter().map(|factor| image(&factor.polynomial)).collect::<Option<_>>()?,
                inputs,
            })
        })
    }
}
