//! Where the instructions of one solve of ours go, by the functions that Valgrind sees. Functions
//! that the compiler moved into others count there.

use std::collections::BTreeMap;

/// A stage of a solve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stage {
    /// From the data to the coefficients: derived data, units, charts.
    Data,
    /// Fill and elimination of the template.
    Elimination,
    /// The determinant, its real roots and null vectors, and the unknowns from a vector.
    Roots,
    /// Residuals and Newton's method on the original equations.
    Polish,
    /// Eigenvalues and their vectors, where a template has no determinant or it is in doubt.
    Eigenvalues,
    /// Telling solutions apart, results, memory, the loop over instances.
    Rest,
}

/// All stages, in the order of a solve, with their heads in the table.
pub(crate) const STAGES: [(Stage, &str); 6] = [
    (Stage::Data, "data"),
    (Stage::Elimination, "elimination"),
    (Stage::Roots, "roots"),
    (Stage::Polish, "polish"),
    (Stage::Eigenvalues, "eigenvalues"),
    (Stage::Rest, "rest"),
];

/// Parts of the names of functions. The first that fits counts.
const NAMES: [(&str, Stage); 24] = [
    ("::polish", Stage::Polish),
    ("::refine::", Stage::Polish),
    ("least_squares", Stage::Polish),
    ("::action_matrix", Stage::Elimination),
    ("eliminant::elimination::lu", Stage::Elimination),
    ("eliminant::elimination::template", Stage::Elimination),
    ("EigenpairSource", Stage::Roots),
    ("::extract::", Stage::Roots),
    ("::hidden_variable::", Stage::Roots),
    ("::real_roots::", Stage::Roots),
    ("::closed_form::", Stage::Roots),
    ("::root_count::", Stage::Roots),
    ("::determinant::", Stage::Roots),
    ("add_product", Stage::Roots),
    ("subtract_product", Stage::Roots),
    ("eliminant::spectrum", Stage::Eigenvalues),
    ("eliminant::driver", Stage::Eigenvalues),
    ("double_double", Stage::Eigenvalues),
    ("eliminant::elimination", Stage::Data),
    ("eliminant::derived", Stage::Data),
    ("eliminant::scaling", Stage::Data),
    ("::move_to", Stage::Data),
    ("::derived", Stage::Data),
    ("::coefficients", Stage::Data),
];

fn stage_of(function: &str) -> Stage {
    NAMES.iter().find(|(part, _)| function.contains(part)).map_or(Stage::Rest, |&(_, stage)| stage)
}

/// Instructions of each stage.
pub(crate) type Counts = [f64; STAGES.len()];

/// The instructions of each stage in a file that callgrind wrote: those of its functions
/// themselves, without what they call.
pub(crate) fn counts(profile: &str) -> Counts {
    let (mut names, mut own) = (BTreeMap::new(), BTreeMap::<&str, f64>::new());
    let (mut function, mut is_of_call) = ("", false);
    for line in profile.lines() {
        // A name is written once: `fn=(3) name`, later `fn=(3)`. `cfn` is the function of a call.
        if let Some((key, rest)) = line.split_once("fn=") {
            let (number, name) = rest.split_once(' ').unwrap_or((rest, ""));
            if !name.is_empty() {
                names.insert(number, name);
            }
            if key.is_empty() {
                function = number;
            }
        } else if line.starts_with("calls=") {
            // The next line has the instructions of the call.
            is_of_call = true;
        } else if line.starts_with(|first: char| first.is_ascii_digit() || "+-*".contains(first)) {
            let count: f64 = line.split(' ').nth(1).and_then(|count| count.parse().ok()).unwrap_or(0.0);
            if !std::mem::take(&mut is_of_call) {
                *own.entry(function).or_default() += count;
            }
        }
    }
    let mut counts = Counts::default();
    for (function, count) in own {
        let stage = stage_of(names.get(function).copied().unwrap_or_default());
        let at = STAGES.iter().position(|&(known, _)| known == stage).unwrap_or(STAGES.len() - 1);
        counts[at] += count;
    }
    counts
}
