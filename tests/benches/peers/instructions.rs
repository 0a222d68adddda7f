//! Instructions of one solve, counted by Valgrind: they do not depend on the load of the machine.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::{array, fs};

use crate::cases::Case;
use crate::peer::Driver;
use crate::stages::{self, Counts};

/// Solves so many instances, and twice as many: the difference has no start and no end in it.
pub(crate) const INSTANCES: usize = 100;

/// What one solve of a side executes.
#[derive(Clone, Copy)]
pub(crate) struct Executed {
    /// Instructions.
    pub(crate) instructions: f64,
    /// Operations on floating-point numbers, or on registers that hold some: arithmetic,
    /// comparisons, bits, but no loads and stores.
    pub(crate) operations: f64,
    /// The instructions by stages: those of ours.
    pub(crate) stages: Option<Counts>,
}

/// One solve of ours, on the first of the instances with this seed.
pub(crate) fn of_ours(case: &Case, seed: u64) -> Option<Executed> {
    let program = std::env::current_exe().ok()?;
    executed(&|tool: &[&str], solves: usize| {
        let (seed, solves) = (seed.to_string(), solves.to_string());
        report(tool, &program, &["--seed", &seed, "--solve-row", case.title, "--solves", &solves], "")
    })
}

/// One solve of a driver, on the first instances of the file; `None` where Valgrind does not know
/// its instructions, which it does not if they are of AVX-512.
pub(crate) fn of_driver(driver: &Driver, case: &Case, file: &Path) -> Option<Executed> {
    let executed = executed(&|tool: &[&str], solves: usize| {
        report(tool, &driver.program, &[case.name, file.to_str()?], &format!("time 0 {solves}\n"))
    })?;
    Some(Executed { stages: None, ..executed })
}

fn executed(run: &dyn Fn(&[&str], usize) -> Option<String>) -> Option<Executed> {
    let per_solve = |count: &dyn Fn(usize) -> Option<f64>| -> Option<f64> {
        Some((count(2 * INSTANCES)? - count(INSTANCES)?) / INSTANCES as f64)
    };
    let profile = Path::new(env!("CARGO_TARGET_TMPDIR")).join("callgrind.out");
    let profiled = |solves: usize| {
        run(&["--tool=callgrind", &format!("--callgrind-out-file={}", profile.display())], solves)?;
        Some(stages::counts(&fs::read_to_string(&profile).ok()?))
    };
    let (one, two) = (profiled(INSTANCES)?, profiled(2 * INSTANCES)?);
    let stages: Counts = array::from_fn(|at| (two[at] - one[at]) / INSTANCES as f64);
    let operations = per_solve(&|solves| {
        let text = run(&["--tool=lackey", "--basic-counts=no", "--detailed-counts=yes"], solves)?;
        Some(["F32", "F64", "V128", "V256"].iter().filter_map(|kind| last_of_row(&text, kind)).sum())
    })?;
    Some(Executed { instructions: stages.iter().sum(), operations, stages: Some(stages) })
}

/// The last number of the row of this kind: loads, stores, operations.
fn last_of_row(text: &str, kind: &str) -> Option<f64> {
    let row = text.lines().find(|line| line.split_whitespace().nth(1) == Some(kind))?;
    row.split_whitespace().last()?.replace(',', "").parse().ok()
}

/// What Valgrind reports of a run.
fn report(tool: &[&str], program: &Path, arguments: &[&str], input: &str) -> Option<String> {
    let mut child = Command::new("valgrind")
        .args(tool)
        .arg(program)
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .ok()?;
    child.stdin.take()?.write_all(input.as_bytes()).ok()?;
    let output = child.wait_with_output().ok().filter(|output| output.status.success())?;
    Some(String::from_utf8_lossy(&output.stderr).into_owned())
}
