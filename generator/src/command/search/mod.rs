//! `eliminant search`: finds, measures and chooses a template, and writes it beside the problem.

mod arguments;
mod outcome;
mod provenance;
mod repeat;
mod report;
mod settings;
mod shard;

use std::path::Path;

use super::error::CommandError;
use super::files::{read_named_problem, template_path, write};
use super::report::Output;
use super::watch::Watch;
use crate::check::check_until;
use crate::search::candidates;
use crate::search::monitor::Monitor;
use crate::search::shard::Shard;
pub(super) use arguments::Arguments;
use outcome::{Outcome, Task, conclude, search};
use report::{SearchReport, ShardReport};
use settings::Settings;
use shard::{ShardFile, merge};

pub(super) fn run(arguments: &Arguments) -> Result<Output, CommandError> {
    let Some(path) = &arguments.file else { return Ok(repeat::run(&arguments.check)) };
    let problem = read_named_problem(path)?;
    let watch = Watch::new(arguments.budget);
    let task = Task { path, problem: &problem, watch: &watch };
    if let Some(shard) = arguments.shard {
        return hand_over(task, arguments.settings(), shard, arguments.out.as_deref());
    }
    let outcome = match arguments.merge.as_slice() {
        [] => search(task, arguments.settings())?,
        files => {
            let (settings, candidates) = merge(path, &problem, files)?;
            conclude(task, settings, candidates)?
        }
    };
    let out = arguments.out.clone().unwrap_or_else(|| template_path(path));
    finish(task, &outcome, &out)
}

/// Writes the chosen template.
fn finish(task: Task<'_>, outcome: &Outcome, out: &Path) -> Result<Output, CommandError> {
    let text = outcome.file.to_text(&task.problem.unknowns);
    task.watch.conclude(|| write(out, &text))?;
    task.watch.finish();
    Ok(Output::of(&SearchReport::new(task.problem, outcome, out.display().to_string(), task.watch.seconds())))
}

/// Screens what a shard found and writes it for the merge. A shard that finds nothing says so in
/// its file.
fn hand_over(task: Task<'_>, settings: Settings, shard: Shard, out: Option<&Path>) -> Result<Output, CommandError> {
    let Task { path, problem, watch } = task;
    watch.say("counting solutions");
    let found = candidates(problem, &check_until(problem, watch.ctrl_c())?, &settings.options, watch);
    let file = ShardFile::new(task, &settings, found)?;
    let name = format!("{}.shard-{}-of-{}.json", problem.name, shard.number(), shard.of());
    let out = out.map_or_else(|| path.with_file_name(name), Path::to_owned);
    let text = file.to_text();
    watch.conclude(|| write(&out, &text))?;
    watch.finish();
    Ok(Output::of(&ShardReport::new(&file, out.display().to_string(), watch.seconds())))
}
