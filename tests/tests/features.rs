//! The features of `eliminant-solvers` are the problems of `templates/`, and families of them.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::{env, fs};

use eliminant_tests::cases;

const UPDATE: &str = "UPDATE_GOLDEN=1 cargo test -p eliminant-tests --test features";
/// The marks between which the manifest lists the problems.
const MARKS: [&str; 2] = ["# problems:begin\n", "# problems:end\n"];
/// The features that turn no solver on: lanes, the heap, and where the square root comes from.
const NO_PROBLEMS: [&str; 5] = ["default", "lanes", "alloc", "std", "libm"];

fn manifest() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../solvers/Cargo.toml")
}

/// The features of the manifest, each with what it turns on.
fn features(text: &str) -> BTreeMap<String, Vec<String>> {
    #[derive(serde::Deserialize)]
    struct Manifest {
        features: BTreeMap<String, Vec<String>>,
    }
    toml::from_str::<Manifest>(text).expect("a manifest").features
}

fn names() -> Vec<&'static str> {
    cases().iter().map(|case| case.name).collect()
}

#[test]
fn each_problem_is_a_feature() {
    let path = manifest();
    let text = fs::read_to_string(&path).expect("a manifest");
    let (before, rest) = text.split_once(MARKS[0]).expect("the first mark");
    let (listed, after) = rest.split_once(MARKS[1]).expect("the second mark");
    let all: String = names().iter().map(|name| format!("    \"{name}\",\n")).collect();
    let each: String = names().iter().map(|name| format!("{name} = []\n")).collect();
    let wanted = format!("all = [\n{all}]\n{each}");
    if listed != wanted && env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&path, [before, MARKS[0], &wanted, MARKS[1], after].concat()).expect("written");
    } else {
        assert_eq!(listed, wanted, "solvers/Cargo.toml lists other problems than there are: {UPDATE}");
    }
}

#[test]
fn all_other_features_are_families_of_problems() {
    let features = features(&fs::read_to_string(manifest()).expect("a manifest"));
    assert_eq!(features["default"], ["std"], "no solver is on by default");
    let mut families = 0;
    for (feature, members) in &features {
        if NO_PROBLEMS.contains(&feature.as_str()) || names().contains(&feature.as_str()) {
            continue;
        }
        families += 1;
        assert!(members.len() > 1, "{feature}: a family of {members:?}");
        assert!(members.is_sorted(), "{feature}: {members:?} is not sorted");
        let unknown: Vec<_> = members.iter().filter(|member| !names().contains(&member.as_str())).collect();
        assert!(unknown.is_empty(), "{feature}: {unknown:?} are no problems");
        // The build script tells a problem from a family by its name.
        let variable = feature.replace('-', "_");
        assert!(!names().contains(&variable.as_str()), "{feature} is the name of a problem, too");
    }
    assert!(families > 5, "{families} families");
}

/// A name says what a problem is about; its families say the same.
#[test]
fn families_miss_no_problem_that_is_named_after_them() {
    let features = features(&fs::read_to_string(manifest()).expect("a manifest"));
    for (family, word) in [
        ("relative-pose", "relpose_"),
        ("relative-pose", "fundamental_"),
        ("circle", "circle_"),
        ("triangulation", "triangulation_"),
        ("radial-distortion", "radial"),
        ("focal-length", "focal"),
        ("generalized-camera", "generalized"),
        ("least-squares", "least_squares"),
    ] {
        let named: Vec<&str> = names().into_iter().filter(|name| name.contains(word)).collect();
        let missing: Vec<_> = named.iter().filter(|name| !features[family].iter().any(|m| m == *name)).collect();
        assert!(!named.is_empty() && missing.is_empty(), "{family} lacks {missing:?}");
    }
}
