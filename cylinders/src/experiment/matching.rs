//! `matching`: cylinders among unlabelled lines; success of the search against clutter, noise,
//! missing silhouettes and the number of directions.

use super::error::ExperimentError;
use super::instances::seeded_instances;
use super::options::Options;
use super::outcome::Outcome;
use super::quantile::Sorted;
use super::table::Table;
use crate::matching::THRESHOLD_PIXELS;
use crate::picture::{Axis, Plot, Series};
use crate::simulation::{ParallelScene, ParallelSetup};
use crate::{
    Cylinder, MatchOptions, View, ViewError, match_cylinders, match_directions, match_directions_with,
    match_with_wider_bound,
};

const RUNS: usize = 100;

/// Outlier rates, at the noise of the set-up; noise in pixels, at the outlier rate of the set-up.
const OUTLIER_RATES: [f64; 6] = [0.86, 0.89, 0.90, 0.91, 0.92, 0.94];
const NOISE: [f64; 6] = [0.25, 0.5, 1.0, 1.5, 2.0, 3.0];

/// Parts of the visible silhouettes that are detected, and numbers of directions, at the outlier
/// rate and the noise of the set-up.
const DETECTION: [f64; 5] = [0.9, 0.8, 0.7, 0.6, 0.5];
const DIRECTIONS: [usize; 3] = [1, 2, 4];

/// A cylinder is found if axis and radius are off by less than this part of the radius.
const FOUND: f64 = 0.1;

const SETUP: &str = "Seven parallel cylinders of similar radius in twelve images. Silhouettes that another cylinder \
hides are not seen, and nine of ten visible silhouettes are detected. The ends of lines are \
moved by normal noise (pixels). Clutter along the direction is added up to the outlier rate: \
the mean over the cylinders of the part of all lines that are not its silhouettes. Pairs of \
every image are tried, and lines within the bound match, whatever the noise. A chosen bound is \
doubled in scenes whose lines fill it, if more speaks for what is found then; its mean is \
shown. Told: the information given to the search. If the direction is not given, it is estimated from all \
lines; if the number of cylinders is not given, the search takes all cylinders that are \
unlikely to be chance. Cylinders of several directions take turns in them; the directions are 25 \
degrees or more apart, and each has its part of the clutter.\n\
Found: axis (in the middle of the scene) and radius are off by less than a tenth of the \
radius. All: part of the runs in which all seven cylinders are found. False: mean number of \
other cylinders. Wrong matches: part of the lines of found cylinders that are not their \
silhouettes.";

/// A kind of scene, and what the search is told.
#[derive(Clone, Copy, Debug)]
struct Row {
    setup: ParallelSetup,
    directions: usize,
    told: Told,
    /// Whether the largest distance between a line and its silhouette is the default, or chosen.
    is_chosen: bool,
}

/// The information that the search gets besides the lines.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
enum Told {
    Nothing,
    Number,
    NumberAndDirection,
}

impl Told {
    const ALL: [Self; 3] = [Self::Nothing, Self::Number, Self::NumberAndDirection];

    fn name(self) -> &'static str {
        match self {
            Self::Nothing => "nothing",
            Self::Number => "number",
            Self::NumberAndDirection => "number, direction",
        }
    }
}

/// What was found in one scene.
#[derive(Clone, Copy, Debug)]
struct Score {
    lines: usize,
    /// Largest distance between a line and its silhouette, pixels.
    bound: f64,
    outlier_rate: f64,
    found: usize,
    spurious: usize,
    matches: usize,
    wrong: usize,
}

/// The columns of all tables.
const COLUMNS: [&str; 12] = [
    "told",
    "noise / pixels",
    "bound / pixels",
    "detected",
    "directions",
    "lines",
    "outlier rate",
    "cylinders",
    "found (mean)",
    "all",
    "false (mean)",
    "wrong matches",
];

pub(super) fn run(options: &Options) -> Result<Outcome, ExperimentError> {
    let runs = options.runs_or(RUNS);
    let paper = ParallelSetup::seven_in_twelve();
    let row = |setup| Row { setup, directions: 1, told: Told::Nothing, is_chosen: false };
    let told = Told::ALL.map(|told| Row { told, ..row(paper) });
    let by_rate = OUTLIER_RATES.map(|outlier_rate| row(ParallelSetup { outlier_rate, ..paper }));
    let by_noise = NOISE.map(|noise| row(ParallelSetup { noise, ..paper }));
    let with_chosen_bound = by_noise.map(|row| Row { is_chosen: true, ..row });
    let by_detection = DETECTION.map(|detection| row(ParallelSetup { detection, ..paper }));
    let by_directions = DIRECTIONS.map(|directions| Row { directions, ..row(paper) });
    let mut outcome = Outcome::new(SETUP, runs);
    let parts: [(_, &[Row]); 6] = [
        ("paper", &told),
        ("outlier_rate", &by_rate),
        ("noise", &by_noise),
        ("chosen_bound", &with_chosen_bound),
        ("detection", &by_detection),
        ("directions", &by_directions),
    ];
    for (name, rows) in parts {
        let mut table = Table::new(name, &COLUMNS);
        let mut points = [Vec::new(), Vec::new()];
        for row in rows {
            let setup = &row.setup;
            let scores = seeded_instances(options, runs, |seed| score(row, seed));
            let scores = scores.into_iter().collect::<Result<Vec<_>, ViewError>>()?;
            let mean = |of: fn(&Score) -> f64| Sorted::new(scores.iter().map(of)).mean();
            let all = scores.iter().filter(|score| score.found == setup.cylinders).count() as f64 / runs as f64;
            let [found, rate] = [mean(|score| score.found as f64), mean(|score| score.outlier_rate)];
            let [matches, wrong] = [mean(|score| score.matches as f64), mean(|score| score.wrong as f64)];
            let numbers = [found, all, mean(|score| score.spurious as f64), wrong / matches].map(Into::into);
            let lines = mean(|score| score.lines as f64);
            let of_row = [setup.noise, mean(|score| score.bound), setup.detection].map(Into::into);
            let of_scenes = [row.directions.into(), lines.into(), rate.into(), setup.cylinders.into()];
            let cells = [row.told.name().into()].into_iter().chain(of_row).chain(of_scenes);
            table.push(cells.chain(numbers));
            let x = match name {
                "noise" | "chosen_bound" => setup.noise,
                "detection" => setup.detection,
                _ => rate,
            };
            points[0].push([x, all]);
            points[1].push([x, found / setup.cylinders as f64]);
        }
        outcome.tables.push(table);
        if !matches!(name, "paper" | "directions") {
            let [all, each] = points;
            let series = [("all seven found", all), ("part of the seven found", each)];
            let label = match name {
                "noise" | "chosen_bound" => "noise of the end points / pixels",
                "detection" => "part of the visible silhouettes that are detected",
                _ => "mean outlier rate",
            };
            let plot = Plot {
                title: format!("seven cylinders in twelve images, {runs} runs"),
                x: Axis::linear(label),
                y: Axis::linear("part"),
                series: series.map(|(label, points)| Series { label: label.to_owned(), points, band: None }).into(),
            };
            outcome.draw(name, &plot)?;
        }
    }
    Ok(outcome)
}

fn score(row: &Row, seed: u64) -> Result<Score, ViewError> {
    let Row { setup, directions, told, is_chosen } = row;
    let scene = setup.scene_of_directions(*directions, seed)?;
    let lines: usize = scene.views.iter().map(|view| view.lines().len()).sum();
    let silhouettes = scene.truth.iter().flatten().flatten().count();
    let outlier_rate = 1.0 - silhouettes as f64 / (setup.cylinders * lines) as f64;
    let bound = THRESHOLD_PIXELS;
    let mut score = Score { lines, bound, outlier_rate, found: 0, spurious: 0, matches: 0, wrong: 0 };
    let options = MatchOptions { threshold: bound, ..MatchOptions::of(&scene.views) };
    let told_number = MatchOptions { count: Some(setup.cylinders), ..options };
    let found = match told {
        Told::Nothing if *is_chosen => {
            let search = |options: &MatchOptions| match_directions(&scene.views, options);
            match_with_wider_bound(&scene.views, &options, search).map(|(bound, matching)| {
                score.bound = bound;
                matching
            })
        }
        Told::Nothing => match_directions(&scene.views, &options),
        Told::Number => {
            let along = |views: &[View], direction: &_| match_cylinders(views, direction, &told_number);
            match_directions_with(&scene.views, 1, &options, along)
        }
        Told::NumberAndDirection => match_cylinders(&scene.views, &scene.direction, &told_number),
    };
    let mut seen = vec![false; scene.cylinders.len()];
    for found in found.iter().flat_map(|matching| &matching.cylinders) {
        let Some(index) = nearest(&found.cylinder, &scene).filter(|&index| !seen[index]) else {
            score.spurious += 1;
            continue;
        };
        seen[index] = true;
        score.found += 1;
        score.matches += found.matches.len();
        let right = |view: usize, line: usize| scene.truth[view][line].is_some_and(|(cylinder, _)| cylinder == index);
        score.wrong += found.matches.iter().filter(|line| !right(line.view, line.line)).count();
    }
    Ok(score)
}

/// Index of the true cylinder that this one matches.
fn nearest(found: &Cylinder, scene: &ParallelScene) -> Option<usize> {
    let error = |truth: &Cylinder| {
        let axis = found.distance(&truth.axis_at(truth.height(&scene.middle))) + found.radius;
        axis.max((found.radius - truth.radius).abs()) / truth.radius
    };
    scene.cylinders.iter().position(|truth| error(truth) < FOUND)
}
