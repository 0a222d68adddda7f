//! A plan that contradicts itself is refused. Each check of [`Plan::check`] meets the committed
//! plans with one change that breaks just that; without the change all of them are accepted.

use std::fs;
use std::sync::OnceLock;

use eliminant_generator::generate::plan;
use eliminant_generator::plan::program::{Operation, ValueId};
use eliminant_generator::plan::system_table::SystemTable;
use eliminant_generator::plan::value_layout::ValueLayout;
use eliminant_generator::plan::{ActionRow, BasisId, Block, CoefficientId, KnownMonomial, PivotId, Plan};
use eliminant_generator::problem::Problem;
use eliminant_generator::template::file::TemplateFile;

const TEMPLATES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../templates");
/// With coupled blocks, pivots that are not needed, sums of products, changes of signs, the origin,
/// eliminated unknowns, a linear block, and unknowns that are read from an image or from pivots of
/// their own.
const NAMES: [&str; 10] = [
    "circle_least_squares_dual",
    "pose_3pt_depths",
    "pose_5pt_refraction",
    "pose_5tdoa_two_receivers",
    "pose_6pt_rolling_shutter",
    "relpose_4pt_angle",
    "relpose_7pt_angle_focal_centre",
    "stitching_3pt_radial_focal",
    "tensor_eigenvectors",
    "two_conics",
];

fn committed_plans() -> &'static [Plan] {
    static PLANS: OnceLock<Vec<Plan>> = OnceLock::new();
    PLANS.get_or_init(|| NAMES.iter().map(|name| planned(name)).collect())
}

fn planned(name: &str) -> Plan {
    let text = |extension| fs::read_to_string(format!("{TEMPLATES}/{name}.{extension}")).expect("a committed file");
    let problem = Problem::parse("problem.rs", &text("rs")).expect("a problem");
    let file = TemplateFile::parse(&text("template.toml"), &problem.unknowns).expect("a template file");
    plan(&problem, &file).expect("a plan").plan
}

/// A change of a plan; `None` if the plan has nothing that could be changed so.
type Change = fn(&mut Plan) -> Option<()>;

/// Every change leads to this message, and each of them applies to some plan.
fn assert_refused(message: &str, changes: &[Change]) {
    let plans = committed_plans();
    for plan in plans {
        assert_eq!(plan.check(), Ok(()), "{}", plan.name);
    }
    for (number, change) in changes.iter().enumerate() {
        let mut applied = 0;
        for plan in plans {
            let mut changed = plan.clone();
            if change(&mut changed).is_some() {
                let error = changed.check().expect_err("a contradiction");
                assert_eq!(error.0, message, "{}: change {number}", plan.name);
                applied += 1;
            }
        }
        assert!(applied > 0, "change {number} to `{message}` applies to no plan");
    }
}

/// A number that no coefficient has.
fn no_coefficient(plan: &Plan) -> CoefficientId {
    CoefficientId(plan.coefficients.len() as u16)
}

/// A basis position that is just too large.
fn no_basis(plan: &Plan) -> BasisId {
    BasisId(plan.elimination.basis as u16)
}

/// A block of which not all pivots are needed.
fn partly_needed(plan: &Plan) -> Option<&Block> {
    plan.elimination.blocks.iter().find(|block| block.needed < block.size)
}

/// The last pivot that its block does not solve for.
fn unsolved(plan: &Plan) -> Option<PivotId> {
    partly_needed(plan).map(|block| PivotId((block.first + block.size - block.needed - 1) as u16))
}

/// The position of the first coefficient of a sum of at least two, and the number of the sum.
fn sum_of_products(plan: &Plan) -> Option<(usize, usize)> {
    plan.program.operations.iter().enumerate().find_map(|(position, operation)| match *operation {
        Operation::Coefficient { sum, at: 0 } if plan.program.product_sums[sum as usize].length > 1 => {
            Some((position, sum as usize))
        }
        _ => None,
    })
}

/// The first position of an operation of a kind.
fn position(plan: &Plan, is_kind: impl Fn(&Operation) -> bool) -> Option<usize> {
    plan.program.operations.iter().position(is_kind)
}

#[test]
fn values_are_written_before_they_are_read() {
    assert_refused(
        "a value is read before it is written",
        &[
            |p| {
                let input = Operation::Input(p.inputs() as u32);
                let at = position(p, |operation| matches!(operation, Operation::Input(_)))?;
                p.program.operations[at] = input;
                Some(())
            },
            |p| {
                let at = position(p, |operation| matches!(operation, Operation::Multiply(..)))?;
                let Operation::Multiply(a, _) = p.program.operations[at] else { unreachable!() };
                p.program.operations[at] = Operation::Multiply(a, ValueId(at as u32));
                Some(())
            },
            |p| {
                let at = position(p, |operation| matches!(operation, Operation::Negate(_)))?;
                p.program.operations[at] = Operation::Negate(ValueId(at as u32));
                Some(())
            },
        ],
    );
}

#[test]
fn the_coefficients_of_a_sum_of_products_stay_together() {
    assert_refused(
        "a value is read before it is written",
        &[
            // The sum reads its own coefficient.
            |p| {
                let (position, sum) = sum_of_products(p)?;
                p.program.product_sums[sum].products[0].left[0] = ValueId(position as u32);
                Some(())
            },
            |p| {
                let (position, sum) = sum_of_products(p)?;
                p.program.product_sums[sum].products.last_mut()?.right[0] = ValueId(position as u32);
                Some(())
            },
            // A place beyond the sum, and a product without a place.
            |p| {
                let (_, number) = sum_of_products(p)?;
                let sum = &mut p.program.product_sums[number];
                sum.products[0].places[0] = sum.length as u32;
                Some(())
            },
            |p| {
                let (_, number) = sum_of_products(p)?;
                p.program.product_sums[number].products[0].places.pop().map(|_| ())
            },
            // Coefficients in another order, twice, of no sum, and one without those before it.
            |p| {
                let (position, _) = sum_of_products(p)?;
                p.program.operations.swap(position, position + 1);
                Some(())
            },
            |p| {
                let (position, _) = sum_of_products(p)?;
                p.program.operations[position + 1] = p.program.operations[position];
                Some(())
            },
            |p| {
                let (position, _) = sum_of_products(p)?;
                let sum = p.program.product_sums.len() as u32;
                p.program.operations[position] = Operation::Coefficient { sum, at: 0 };
                Some(())
            },
            |p| {
                let constant = position(p, |operation| matches!(operation, Operation::Constant(_)))?;
                p.program.operations[constant] = Operation::Coefficient { sum: 0, at: 1 };
                Some(())
            },
        ],
    );
}

#[test]
fn coefficients_have_values() {
    assert_refused(
        "a coefficient has no value",
        &[|p| {
            p.coefficients[0] = ValueId(p.program.operations.len() as u32);
            Some(())
        }],
    );
}

#[test]
fn blocks_tile_the_rows() {
    assert_refused(
        "the blocks do not tile the rows",
        &[
            |p| p.elimination.blocks.pop().map(|_| ()),
            |p| {
                p.elimination.rows += 1;
                Some(())
            },
            |p| {
                let block = p.elimination.blocks.last_mut()?;
                block.first += 1;
                Some(())
            },
            |p| {
                let block = p.elimination.blocks.first_mut()?;
                block.needed = block.size + 1;
                Some(())
            },
            |p| {
                let empty = Block { first: 0, size: 0, needed: 0, diagonal: Vec::new(), coupling: Vec::new() };
                p.elimination.blocks.insert(0, empty);
                Some(())
            },
        ],
    );
}

#[test]
fn entries_of_blocks_are_inside() {
    assert_refused(
        "the blocks do not tile the rows",
        &[
            |p| {
                let block = p.elimination.blocks.last_mut()?;
                block.diagonal[0].row = block.size as u16;
                Some(())
            },
            |p| {
                let block = p.elimination.blocks.last_mut()?;
                block.diagonal[0].column = block.size as u16;
                Some(())
            },
            |p| {
                let coefficient = no_coefficient(p);
                p.elimination.blocks.last_mut()?.diagonal[0].coefficient = coefficient;
                Some(())
            },
            |p| {
                let block = p.elimination.blocks.iter_mut().find(|block| !block.coupling.is_empty())?;
                block.coupling[0].row = block.size as u16;
                Some(())
            },
            |p| {
                let block = p.elimination.blocks.iter_mut().find(|block| !block.coupling.is_empty())?;
                block.coupling[0].column = block.first as u16;
                Some(())
            },
            |p| {
                let coefficient = no_coefficient(p);
                let block = p.elimination.blocks.iter_mut().find(|block| !block.coupling.is_empty())?;
                block.coupling[0].coefficient = coefficient;
                Some(())
            },
        ],
    );
}

#[test]
fn rows_have_shifts_and_pivot_columns() {
    assert_refused(
        "a row has no shift or no pivot column",
        &[|p| p.elimination.row_shifts.pop().map(|_| ()), |p| p.elimination.pivot_columns.pop().map(|_| ())],
    );
}

#[test]
fn only_solved_pivots_are_read() {
    assert_refused(
        "a block reads a pivot that is not solved",
        &[|p| {
            let pivot = unsolved(p)?.0;
            let later = |block: &&mut Block| block.first > usize::from(pivot) && !block.coupling.is_empty();
            p.elimination.blocks.iter_mut().find(later)?.coupling[0].column = pivot;
            Some(())
        }],
    );
    assert_refused(
        "a row of the action matrix is out of range",
        &[
            |p| p.action.pop().map(|_| ()),
            |p| {
                p.action[0] = ActionRow::Unit(no_basis(p));
                Some(())
            },
            |p| {
                p.action[0] = ActionRow::Solved(unsolved(p)?);
                Some(())
            },
            |p| {
                p.action[0] = ActionRow::Solved(PivotId(p.elimination.rows as u16));
                Some(())
            },
        ],
    );
}

#[test]
fn basis_entries_are_inside() {
    assert_refused(
        "a basis entry is out of range",
        &[
            |p| {
                p.elimination.right[0].row = p.elimination.rows as u16;
                Some(())
            },
            |p| {
                p.elimination.right[0].column = p.elimination.basis as u16;
                Some(())
            },
            |p| {
                p.elimination.right[0].coefficient = no_coefficient(p);
                Some(())
            },
        ],
    );
}

#[test]
fn unknowns_are_read_from_known_monomials() {
    assert_refused(
        "an unknown is read from a monomial that is not known",
        &[
            |p| {
                p.read.push(unsolved(p)?);
                Some(())
            },
            |p| {
                p.extractions[0].pairs[0].0 = KnownMonomial::Basis(no_basis(p));
                Some(())
            },
            |p| {
                p.extractions[0].pairs[0].1 = KnownMonomial::Basis(no_basis(p));
                Some(())
            },
            |p| {
                p.extractions[0].pairs[0].1 = KnownMonomial::Image(no_basis(p));
                Some(())
            },
            |p| {
                p.extractions[0].pairs[0].1 = KnownMonomial::Read(p.read.len() as u16);
                Some(())
            },
        ],
    );
}

#[test]
fn steps_hold_the_unknown_and_known_square_roots() {
    assert_refused(
        "an unknown is read with one that is not known",
        &[
            |p| {
                let x = &mut p.extractions[0];
                x.step[x.unknown] = 3;
                Some(())
            },
            |p| {
                let x = &mut p.extractions[0];
                x.step[x.unknown] = 0;
                Some(())
            },
            |p| p.extractions.first_mut().map(|x| x.step.push(0)),
            // Another unknown that is read later, and one to the second power.
            |p| {
                let later = p.extractions.get(1)?.unknown;
                p.extractions[0].step[later] = 1;
                Some(())
            },
            |p| {
                let known = p.extractions[0].unknown;
                p.extractions.get_mut(1)?.step[known] = 2;
                Some(())
            },
            // Without pairs a square root is not known when it is needed.
            |p| {
                let needed = p.extractions.iter().find_map(|x| x.others().next())?.0;
                p.extractions.iter_mut().find(|x| x.unknown == needed)?.pairs.clear();
                Some(())
            },
        ],
    );
}

#[test]
fn symmetries_are_of_all_unknowns() {
    assert_refused(
        "a symmetry has another number of unknowns",
        &[
            |p| p.images.first_mut()?.pop().map(|_| ()),
            |p| {
                p.images.first_mut()?.push((0, false));
                Some(())
            },
            |p| {
                let width = p.unknowns.len() as u8;
                p.images.first_mut()?.first_mut().map(|(of, _)| *of = width)
            },
        ],
    );
}

#[test]
fn the_basis_is_large_enough_for_the_solutions() {
    let most = |p: &Plan| p.elimination.basis * (1 + p.images.len()) + usize::from(p.has_origin);
    for mut plan in committed_plans().iter().cloned() {
        plan.solutions = most(&plan);
        assert_eq!(plan.check(), Ok(()), "{}", plan.name);
        plan.solutions += 1;
        let error = plan.check().expect_err("one solution too many");
        assert_eq!(error.0, "the basis is smaller than the number of solutions", "{}", plan.name);
    }
}

#[test]
fn the_matrix_of_the_equations_comes_first() {
    assert_refused(
        "the matrix of the equations is not where it should be",
        &[
            // A zero of the matrix becomes another coefficient.
            |p| {
                let table = SystemTable::of(&p.equations, p.unknowns.len());
                let zero = table.matrix().iter().position(Option::is_none).filter(|_| table.is_dense())?;
                p.coefficients[zero] = *p.coefficients.iter().find(|id| **id != p.coefficients[zero])?;
                Some(())
            },
        ],
    );
}

#[test]
fn terms_read_known_unknowns_and_coefficients() {
    assert_refused(
        "a term reads something unknown",
        &[
            |p| {
                p.recoveries.first_mut()?.terms[0].coefficient = CoefficientId(p.coefficients.len() as u16);
                Some(())
            },
            |p| {
                p.recoveries.first_mut()?.terms[0].exponents.push(0);
                Some(())
            },
            // An unknown by itself.
            |p| {
                let recovery = p.recoveries.first_mut()?;
                recovery.terms[0].exponents[recovery.unknown] = 1;
                Some(())
            },
            |p| {
                p.equations[0][0].coefficient = no_coefficient(p);
                Some(())
            },
            |p| p.equations.last_mut()?.last_mut()?.exponents.pop().map(|_| ()),
            |p| {
                p.nonzero.first_mut()?.first_mut()?.coefficient = CoefficientId(p.coefficients.len() as u16);
                Some(())
            },
        ],
    );
}

#[test]
fn every_unknown_is_recovered() {
    assert_refused(
        "an unknown is never recovered",
        &[
            |p| p.recoveries.pop().map(|_| ()),
            |p| {
                let is_read_alone = p.recovered().next().is_none() && p.images.is_empty();
                p.extractions.last_mut().filter(|_| is_read_alone)?.pairs.clear();
                Some(())
            },
        ],
    );
}

/// The values that unknowns are read from stand one after another: basis, image, read pivots.
#[test]
fn values_that_unknowns_are_read_from_have_positions_of_their_own() {
    let (mut with_image, mut without_image) = (0, 0);
    // No committed plan reads from the image: a pair of each is changed to do so. Two pivots are
    // read besides.
    let reading_image = committed_plans().iter().cloned().map(|mut plan| {
        plan.extractions[0].pairs[0].1 = KnownMonomial::Image(BasisId(0));
        let is_solved = |row: &ActionRow| if let ActionRow::Solved(pivot) = *row { Some(pivot) } else { None };
        plan.read.extend(plan.action.iter().find_map(is_solved).into_iter().flat_map(|pivot| [pivot; 2]));
        assert_eq!(plan.check(), Ok(()), "{}", plan.name);
        plan
    });
    for plan in &committed_plans().iter().cloned().chain(reading_image).collect::<Vec<_>>() {
        let layout = ValueLayout::of(plan);
        let basis = || (0..plan.elimination.basis as u16).map(BasisId);
        let read_from: Vec<KnownMonomial> =
            plan.extractions.iter().flat_map(|x| &x.pairs).flat_map(|&(m, xm)| [m, xm]).collect();
        let has_image = read_from.iter().any(|monomial| matches!(monomial, KnownMonomial::Image(_)));
        let images = basis().map(KnownMonomial::Image).filter(|_| has_image);
        let read = (0..plan.read.len() as u16).map(KnownMonomial::Read);
        let all: Vec<KnownMonomial> = basis().map(KnownMonomial::Basis).chain(images).chain(read).collect();
        let positions: Vec<usize> = all.iter().map(|&monomial| layout.position(monomial).into()).collect();
        assert_eq!(positions, (0..layout.len()).collect::<Vec<_>>(), "{}", plan.name);
        assert!(!layout.is_empty() && read_from.iter().all(|monomial| all.contains(monomial)), "{}", plan.name);
        for x in &plan.extractions {
            let pairs =
                layout.ratios(plan, x.unknown).into_iter().map(|(m, xm)| (all[usize::from(m)], all[usize::from(xm)]));
            assert_eq!(pairs.collect::<Vec<_>>(), x.pairs, "{}", plan.name);
        }
        *(if has_image { &mut with_image } else { &mut without_image }) += 1;
    }
    assert!(with_image > 0 && without_image > 0, "{with_image} with an image, {without_image} without");
}

#[test]
fn linear_blocks_have_no_fewer_rows_than_unknowns() {
    assert_refused(
        "a linear block has another shape",
        &[
            |plan| plan.linear.as_mut().and_then(|block| block.unknowns.pop()).map(drop),
            |plan| plan.linear.as_mut().and_then(|block| block.rows[1].pop()).map(drop),
            |plan| plan.linear.as_mut().map(|block| block.rows.truncate(block.unknowns.len() - 1)),
        ],
    );
    assert_refused(
        "a linear block has another unknown",
        &[|plan| plan.linear.as_mut().map(|block| block.unknowns[0] = plan.unknowns.len())],
    );
    assert_refused(
        "an unknown is never recovered",
        &[|plan| plan.linear.as_mut().map(|block| block.unknowns[0] = block.unknowns[1])],
    );
}

/// An unknown that an extraction reads has its step; one that is recovered has zeros.
#[test]
fn unknowns_that_are_not_read_have_no_step() {
    let mut recovered = 0;
    for plan in committed_plans() {
        let steps = plan.steps();
        assert_eq!(steps.len(), plan.unknowns.len(), "{}", plan.name);
        for x in &plan.extractions {
            assert_eq!(steps[x.unknown], x.step, "{}", plan.name);
        }
        for recovery in &plan.recoveries {
            assert_eq!(steps[recovery.unknown], vec![0; plan.unknowns.len()], "{}", plan.name);
            recovered += 1;
        }
    }
    assert!(recovered > 0);
}

/// Without constant rows the elimination has the size that the template file states.
#[test]
fn the_elimination_has_the_size_of_the_template() {
    for (name, size) in [("relpose_4pt_angle", "rows = 16\ncolumns = 36\n"), ("two_conics", "rows = 6\ncolumns = 10\n")]
    {
        let text = fs::read_to_string(format!("{TEMPLATES}/{name}.template.toml")).expect("a committed file");
        assert!(text.contains(size), "{name}");
        let elimination = planned(name).elimination;
        assert_eq!(format!("rows = {}\ncolumns = {}\n", elimination.rows, elimination.columns()), size, "{name}");
    }
}

#[test]
fn chains_follow_the_basis() {
    assert_refused(
        "the chains are not those of the basis",
        &[
            |plan| plan.chains.as_mut().map(|chains| chains.order[0] = chains.order[1]),
            |plan| plan.chains.as_mut().map(|chains| chains.order.swap(0, 1)),
            |plan| plan.chains.as_mut().map(|chains| chains.lengths[0] += 1),
            |plan| plan.chains.as_mut().map(|chains| chains.lengths[0] -= 1),
            |plan| {
                let chains = plan.chains.as_mut()?;
                chains.eliminated = chains.order.len();
                chains.lengths.clear();
                Some(())
            },
            |plan| plan.chains.as_mut().and_then(|chains| chains.order.pop()).map(drop),
        ],
    );
}

/// The chains of a plan are as many as a determinant can have, and they are ordered so that
/// eliminated ones have a longer chain each.
#[test]
fn chains_are_few() {
    let found = |name: &str| {
        let chains = planned(name).chains?;
        Some((chains.lengths, chains.eliminated))
    };
    assert_eq!(found("relpose_5pt"), Some((vec![2, 2, 3], 3)));
    assert_eq!(found("two_conics"), Some((vec![2, 1], 1)));
    assert_eq!(found("trilateration"), Some((vec![2], 0)));
    assert_eq!(found("pose_6pt_rolling_shutter"), None);
}
