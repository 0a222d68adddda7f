//! Problems of other fields than computer vision, in `examples/other-fields/`: the number of
//! solutions is the published one.

use std::fs;
use std::path::Path;

use eliminant_generator::check::check;
use eliminant_generator::problem::Problem;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/other-fields");

/// The problems and their numbers of complex solutions, as their comments say with the source.
const PUBLISHED: [(&str, usize); 15] = [
    ("combustion", 16),
    ("cyclic_5", 70),
    ("cyclohexane", 16),
    ("economy_6", 16),
    ("game_3_players", 2),
    ("game_4_players", 9),
    ("heart_dipole", 4),
    ("neurons_3", 21),
    ("oscillators_4", 20),
    ("planar_platform", 6),
    ("power_flow_3_buses", 6),
    ("power_flow_4_buses", 20),
    ("quadrature_3_nodes", 6),
    ("robot_arm", 16),
    ("species_3", 8),
];

#[test]
fn numbers_of_solutions_are_the_published_ones() {
    for (name, solutions) in PUBLISHED {
        let path = Path::new(FOLDER).join(name).with_extension("rs");
        let text = fs::read_to_string(&path).expect("a problem file");
        let problem = Problem::parse(name, &text).unwrap_or_else(|messages| panic!("{}", messages.render()));
        let count = check(&problem).unwrap_or_else(|messages| panic!("{}", messages.render()));
        assert_eq!((problem.name.as_str(), count.solutions), (name, solutions));
        let prose: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("///")).collect();
        let prose = prose.join(" ").split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(prose.contains(&format!("{solutions} solutions")), "{name}: {prose}");
    }
}

#[test]
fn no_problem_is_left_out() {
    let entries = fs::read_dir(FOLDER).expect("the folder");
    let names = entries.map(|entry| entry.expect("an entry").file_name().into_string().expect("a name"));
    let mut problems: Vec<String> = names.filter_map(|name| name.strip_suffix(".rs").map(str::to_owned)).collect();
    problems.sort();
    assert_eq!(problems, PUBLISHED.map(|(name, _)| name));
}
