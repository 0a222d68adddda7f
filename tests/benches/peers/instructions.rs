//! Instructions of one solve, counted by Valgrind: they do not depend on the load of the machine.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::cases::Case;
use crate::peer::Driver;

/// Solves so many instances, and twice as many: the difference has no start and no end in it.
pub(crate) const INSTANCES: usize = 100;

/// Instructions of one solve of ours, on the first of the instances with this seed.
pub(crate) fn of_ours(case: &Case, seed: u64) -> Option<f64> {
    let program = std::env::current_exe().ok()?;
    let count = |solves: usize| {
        let (seed, solves) = (seed.to_string(), solves.to_string());
        count(&program, &["--seed", &seed, "--solve-row", case.title, "--solves", &solves], "")
    };
    per_solve(count)
}

/// Instructions of one solve of a driver, on the first instances of the file; `None` where Valgrind
/// does not know its instructions, which it does not if they are of AVX-512.
pub(crate) fn of_driver(driver: &Driver, case: &Case, file: &Path) -> Option<f64> {
    per_solve(|solves| count(&driver.program, &[case.name, file.to_str()?], &format!("time 0 {solves}\n")))
}

fn per_solve(count: impl Fn(usize) -> Option<f64>) -> Option<f64> {
    Some((count(2 * INSTANCES)? - count(INSTANCES)?) / INSTANCES as f64)
}

/// All instructions that a program executes.
fn count(program: &Path, arguments: &[&str], input: &str) -> Option<f64> {
    let mut child = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .ok()?;
    child.stdin.take()?.write_all(input.as_bytes()).ok()?;
    let output = child.wait_with_output().ok().filter(|output| output.status.success())?;
    let text = String::from_utf8_lossy(&output.stderr);
    let line = text.lines().find(|line| line.contains("Collected :"))?;
    line.rsplit(':').next()?.trim().parse().ok()
}
