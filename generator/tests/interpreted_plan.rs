//! The tables of a plan, which the run-time library executes, give the same action matrix as the
//! plan that is interpreted step by step: bit by bit, and both refuse the same data. This needs no
//! compiled solver.
#![cfg(feature = "search")]

use std::fs;

use eliminant::emitted::SolverInstance as _;
use eliminant_generator::algebra::Random;
use eliminant_generator::expression::arithmetic::Float64;
use eliminant_generator::generate::plan;
use eliminant_generator::plan::{Plan, interpret};
use eliminant_generator::problem::Problem;
use eliminant_generator::search::measuring::interpreted::InterpretedSolver;
use eliminant_generator::template::file::TemplateFile;

/// With sums of products, coupled blocks, constant rows, constant pivots of others, and a long
/// program.
const NAMES: [&str; 7] = [
    "pose_4pt_upright_error_bound",
    "pose_5tdoa_two_receivers",
    "pose_npt_direct_least_squares",
    "relpose_5pt",
    "relpose_6pt_focal",
    "tensor_eigenvectors",
    "three_quadrics",
];

fn planned(name: &str) -> Plan {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../templates");
    let text = |extension| fs::read_to_string(format!("{folder}/{name}.{extension}")).expect("a committed file");
    let problem = Problem::parse("problem.rs", &text("rs")).expect("a problem");
    let file = TemplateFile::parse(&text("template.toml"), &problem.unknowns).expect("a template file");
    plan(&problem, &file).expect("a plan").plan
}

/// Data of a family: random, over ever wider ranges, small integers, and with one number that is
/// not finite.
fn draw(plan: &Plan, family: u64, random: &mut Random) -> Vec<f64> {
    let mut number = || match family {
        0 => random.symmetric_unit(),
        1 => random.symmetric_unit() * 10f64.powf(10.0 * random.symmetric_unit()),
        2 => random.symmetric_unit() * 10f64.powf(150.0 * random.symmetric_unit()),
        _ => (2.0 * random.symmetric_unit()).round(),
    };
    let mut data: Vec<f64> = (0..plan.given()).map(|_| number()).collect();
    if family == 4 {
        let at = random.below(data.len() as u64) as usize;
        data[at] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY][random.below(3) as usize];
    }
    data
}

#[test]
fn tables_and_steps_give_the_same_bits() {
    let bits = |matrix: Vec<Vec<f64>>| matrix.concat().into_iter().map(f64::to_bits).collect::<Vec<_>>();
    let mut solved = [0; 5];
    for plan in NAMES.map(planned) {
        // The steps know no units.
        let plan = Plan { scalings: Vec::new(), ..plan };
        let solver = InterpretedSolver::of(&plan);
        let mut random = Random::new(9);
        for k in 0..100 {
            let data = draw(&plan, k % 5, &mut random);
            let coefficients = interpret::coefficients(&plan, Float64, &data);
            let stepwise = coefficients.and_then(|c| interpret::eliminate(&plan, Float64, &c));
            let by_tables = solver.instance(&data).and_then(|mut instance| instance.action_matrix::<f64>());
            let found = stepwise.map(|eliminated| bits(eliminated.action));
            assert_eq!(found, by_tables.ok().map(bits), "{} for {data:?}", plan.name);
            solved[(k % 5) as usize] += usize::from(found.is_some());
        }
    }
    // 140 data of each family.
    let [random, wide, wider, integers, not_finite] = solved;
    assert!(random == 140 && wide > 70 && wider < 140 && (1..140).contains(&integers) && not_finite == 0, "{solved:?}");
}
