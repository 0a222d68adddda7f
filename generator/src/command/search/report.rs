//! What `eliminant search` prints.

use std::fmt;

use serde::Serialize;

use super::outcome::Outcome;
use super::shard::ShardFile;
use crate::command::report::{Summary, counted, one_decimal, seconds, table};
use crate::command::watch::End;
use crate::problem::Problem;
use crate::search::Found;
use crate::search::choose::{Choice, INCOMPLETE_ONE_IN, Measured, Verdict, expected_nanoseconds};
use crate::search::pareto::front;
use crate::search::preference::Preference;

/// The object of `--json`: the summary of the chosen template as `eliminant inspect` prints it, and
/// what follows.
#[derive(Serialize)]
pub(super) struct SearchReport {
    #[serde(flatten)]
    summary: Summary,
    prefer: Preference,
    /// Number of different templates that were found.
    found_templates: usize,
    /// Index of the chosen template among the candidates.
    chosen: usize,
    /// Indices of the candidates on the Pareto front, those of least predicted time first.
    front: Vec<usize>,
    /// The candidates that were measured, in the order of the preference.
    candidates: Vec<Row>,
    /// What ended the search early and what was left out; `null` if nothing did.
    cut: Option<Cut>,
    /// What a user must know about the result.
    warnings: Vec<String>,
    /// Where the template was written.
    file: String,
    seconds: f64,
}

/// What a search that ended early left out.
#[derive(Serialize)]
pub(super) struct Cut {
    /// `budget`, `interrupt`, or `shards` if shards of it ended early.
    by: &'static str,
    /// Number of strategies.
    strategies: usize,
    /// Number of these that were not tried. The last ones that were tried may have been cut short.
    untried: usize,
    /// Number of templates that were found but not planned.
    unplanned: usize,
    /// Number of different templates that were not measured.
    unmeasured: usize,
}

impl Cut {
    pub(super) fn new(end: End, found: &Found, choice: &Choice) -> Self {
        let by = end.name();
        let Found { strategies, untried, unplanned, .. } = *found;
        Self { by, strategies, untried, unplanned, unmeasured: choice.unmeasured }
    }
}

impl fmt::Display for Cut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { strategies, untried, unplanned, unmeasured, .. } = self;
        let end = match self.by {
            "budget" => "the budget",
            "shards" => "the end of shards",
            _ => "Ctrl-C",
        };
        write!(f, "{end} ended the search: {untried} of {strategies} strategies not tried, ")?;
        write!(
            f,
            "{} not planned, {unmeasured} not measured; another run may give another result",
            counted(*unplanned, "template")
        )
    }
}

/// What a shard of a search reports.
#[derive(Serialize)]
pub(super) struct ShardReport {
    shard: String,
    /// Number of different templates that were found.
    found_templates: usize,
    /// Number of strategies of this shard.
    strategies: usize,
    /// Number of these that the budget or Ctrl-C left out.
    untried: usize,
    file: String,
    seconds: f64,
}

impl ShardReport {
    pub(super) fn new(shard: &ShardFile, file: String, seconds: f64) -> Self {
        let (strategies, untried) = (shard.strategies, shard.untried);
        Self { shard: shard.shard.clone(), found_templates: shard.found, strategies, untried, file, seconds }
    }
}

impl fmt::Display for ShardReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { shard, strategies, untried, .. } = self;
        let found = counted(self.found_templates, "template");
        writeln!(f, "shard {shard}: {found} found by {strategies} strategies, {untried} of them not tried")?;
        writeln!(f, "wrote {} in {}", self.file, seconds(self.seconds))
    }
}

/// A candidate that was measured.
#[derive(Serialize)]
struct Row {
    rows: usize,
    columns: usize,
    basis: usize,
    action: String,
    presolve: String,
    growth: String,
    operations: usize,
    /// Predicted nanoseconds of a solve, second attempts included; 1.25 times as many where
    /// equations are solved at run time.
    nanoseconds: f64,
    #[serde(skip)]
    is_presolved_at_run_time: bool,
    trials: usize,
    /// log10 of the relative residual.
    median: Option<f64>,
    p99: Option<f64>,
    /// Number of instances that took a second attempt.
    repeated: usize,
    /// Number of scenes that took one; `null` if the problem has no scene that says what solves it.
    scenes_repeated: Option<usize>,
    incomplete: usize,
    failures: usize,
    /// `accepted`, `screened` (neither accepted nor rejected) or `rejected`.
    verdict: &'static str,
    /// Whether it is on the Pareto front of the predicted time, rows, 99 %
    /// quantile (to one decimal) and portion of unsolved instances.
    pareto: bool,
}

impl SearchReport {
    pub(super) fn new(problem: &Problem, outcome: &Outcome, file: String, seconds: f64) -> Self {
        let Outcome { settings, candidates: all, choice, end, .. } = outcome;
        let cut = end.map(|end| Cut::new(end, &all.found, choice));
        let chosen = &choice.measured[choice.chosen];
        let on_front = front(&choice.measured.iter().map(point).collect::<Vec<_>>());
        let candidates: Vec<Row> =
            choice.measured.iter().zip(on_front).map(|(m, pareto)| Row::new(m, problem, pareto)).collect();
        let mut front: Vec<usize> = (0..candidates.len()).filter(|&at| candidates[at].pareto).collect();
        front.sort_by(|&a, &b| candidates[a].nanoseconds.total_cmp(&candidates[b].nanoseconds));
        Self {
            summary: Summary::new(problem, &chosen.candidate.template, &chosen.candidate.plan),
            prefer: settings.options.prefer,
            found_templates: all.templates,
            chosen: choice.chosen,
            front,
            candidates,
            warnings: warnings(problem, choice, cut.as_ref()),
            cut,
            file,
            seconds,
        }
    }
}

/// What candidates are compared by for the Pareto front.
fn point(measured: &Measured) -> [f64; 4] {
    let (cost, stability) = (measured.candidate.cost(), &measured.stability);
    let p99 = stability.quantile(0.99).map_or(f64::INFINITY, |p99| (10.0 * p99).round());
    let unsolved = (stability.incomplete + stability.failures) as f64 / stability.trials.max(1) as f64;
    [expected_nanoseconds(&cost, stability).round(), cost.rows as f64, p99, unsolved]
}

fn warnings(problem: &Problem, choice: &Choice, cut: Option<&Cut>) -> Vec<String> {
    let chosen = &choice.measured[choice.chosen];
    let (stability, trials) = (&chosen.stability, counted(chosen.stability.trials, "instance"));
    let mut warnings = Vec::new();
    if chosen.verdict == Verdict::Rejected {
        warnings.push(format!(
            "no measured template is good enough: none that never fails lacks a solution on at most one instance in \
             {INCOMPLETE_ONE_IN}. Of {trials}, the chosen one lacks a solution on {} and fails on {}",
            stability.incomplete, stability.failures
        ));
        if 2 * stability.scenes_missed > stability.scenes {
            warnings.push(format!(
                "what the scene says is not found on {} of {} scenes: is it a solution? Most templates find most",
                stability.scenes_missed, stability.scenes
            ));
        }
    } else if chosen.verdict == Verdict::Screened {
        warnings.push(format!("the chosen template was measured on {trials} only"));
    }
    if let (true, Some(x)) = (problem.has_origin(), problem.unknowns.first()) {
        warnings.push(format!(
            "all unknowns 0 is one of the solutions, and is returned with the others. Exclude it with `{x} != 0;`"
        ));
    }
    warnings.extend(cut.map(Cut::to_string));
    warnings
}

impl Row {
    fn new(measured: &Measured, problem: &Problem, pareto: bool) -> Self {
        let (candidate, stability) = (&measured.candidate, &measured.stability);
        Self {
            rows: candidate.template.rows(),
            columns: candidate.template.columns(),
            basis: candidate.template.basis.len(),
            action: candidate.template.action.display(&problem.unknowns).to_string(),
            presolve: candidate.presolve.name(),
            growth: candidate.growth.to_string(),
            operations: candidate.plan.operations().total(),
            nanoseconds: expected_nanoseconds(&candidate.cost(), stability).round(),
            is_presolved_at_run_time: candidate.plan.is_presolved_at_run_time(),
            trials: stability.trials,
            median: stability.quantile(0.5),
            p99: stability.quantile(0.99),
            repeated: stability.repeated,
            scenes_repeated: (stability.scenes > 0).then_some(stability.scenes_repeated),
            incomplete: stability.incomplete,
            failures: stability.failures,
            verdict: measured.verdict.name(),
            pareto,
        }
    }

    fn cells_of_front(&self, is_chosen: bool) -> Vec<String> {
        vec![
            if is_chosen { "*" } else { " " }.to_owned(),
            format!("{} x {}", self.rows, self.columns),
            self.action.clone(),
            self.verdict.to_owned(),
            self.basis.to_string(),
            format!("{:.0}", self.nanoseconds),
            one_decimal(self.median),
            one_decimal(self.p99),
            self.trials.to_string(),
            (self.incomplete + self.failures).to_string(),
        ]
    }

    /// The way by which it was found, in words.
    fn way(&self) -> String {
        format!("presolve {}, {}", self.presolve, self.growth)
    }

    fn cells(&self, is_chosen: bool, way: usize) -> Vec<String> {
        vec![
            format!("{}{}", if is_chosen { "*" } else { " " }, if self.pareto { "+" } else { "" }),
            format!("{} x {}", self.rows, self.columns),
            self.action.clone(),
            format!("w{way}"),
            self.verdict.to_owned(),
            self.basis.to_string(),
            format!("{:.0}", self.nanoseconds),
            one_decimal(self.p99),
            self.trials.to_string(),
            self.scenes_repeated.unwrap_or(self.repeated).to_string(),
            self.incomplete.to_string(),
            self.failures.to_string(),
        ]
    }
}

const HEAD_OF_FRONT: [&str; 10] = ["", "size", "action", "verdict", "|B|", "ns", "median", "p99", "trials", "unsolved"];

const HEAD: [&str; 12] =
    ["", "size", "action", "way", "verdict", "|B|", "ns", "p99", "trials", "repeated", "incomplete", "failed"];

impl fmt::Display for SearchReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let is_on_front = self.front.contains(&self.chosen);
        let chosen = (!is_on_front).then_some(&self.chosen);
        let front: Vec<Vec<String>> = chosen
            .into_iter()
            .chain(&self.front)
            .map(|&at| self.candidates[at].cells_of_front(at == self.chosen))
            .collect();
        writeln!(f, "no measured template is better in predicted time, rows, p99 and unsolved instances than:")?;
        let chosen = if is_on_front { "(* chosen)" } else { "(* chosen, though one of them is better by a little)" };
        writeln!(f, "{}{chosen}\n", table(&HEAD_OF_FRONT, &front, 4))?;
        write!(f, "{}", self.summary)?;
        let mut ways: Vec<String> = Vec::new();
        for way in self.candidates.iter().map(Row::way) {
            if !ways.contains(&way) {
                ways.push(way);
            }
        }
        let way = |row: &Row| 1 + ways.iter().take_while(|&way| *way != row.way()).count();
        let rows: Vec<Vec<String>> =
            self.candidates.iter().enumerate().map(|(at, row)| row.cells(at == self.chosen, way(row))).collect();
        let found = counted(self.found_templates, "template");
        writeln!(f, "\n{found} found, {} measured in the order of {}:", rows.len(), self.prefer)?;
        write!(f, "{}", table(&HEAD, &rows, 5))?;
        for (at, way) in ways.iter().enumerate() {
            writeln!(f, "w{}  {way}", at + 1)?;
        }
        let any = |is_so: fn(&Row) -> bool, words| if self.candidates.iter().any(is_so) { words } else { "" };
        writeln!(
            f,
            "(* chosen; + on the Pareto front of predicted ns with second attempts, rows, p99 and unsolved\n instances; p99 of the log10 relative residual{}{})\n",
            any(|row| row.scenes_repeated.is_some(), ";\n repeated counts scenes, one beside every trial"),
            any(|row| row.is_presolved_at_run_time, ";\n ns count 1.25 times where equations are solved at run time"),
        )?;
        for warning in &self.warnings {
            writeln!(f, "warning: {warning}")?;
        }
        writeln!(f, "wrote {} in {}", self.file, seconds(self.seconds))
    }
}
