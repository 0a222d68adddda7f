//! Measures the stack that solves take: a table of the smallest thread in which each function of
//! each solver works, found by bisection with a process for each size.
//!
//! ```sh
//! cargo run --release -p eliminant-tests --bin stack
//! cargo run --profile unoptimised -p eliminant-tests --bin stack
//! ```

use std::error::Error;
use std::process::{Command, Stdio};

use clap::Parser;
use eliminant_tests::cases;
use eliminant_tests::stack::{CALLS, Call, Instances};

/// The smallest stack that is tried, and the precision, in KiB: smaller threads do not start
/// everywhere.
const STEP: usize = 4;
/// The largest stack that is tried, in KiB.
const MOST: usize = 16 * 1024;

/// The stack that solves take, second attempts included.
#[derive(Parser)]
struct Arguments {
    /// Solvers whose names contain this; all without it.
    #[arg(default_value = "")]
    name: String,
    /// Calls one function of the solver of this name in a thread with so many KiB: what the
    /// measurement runs again and again.
    #[arg(long, hide = true, num_args = 2, value_names = ["FUNCTION", "KIB"])]
    run: Option<Vec<usize>>,
    /// The data of that call, as numbers by their bits.
    #[arg(long, hide = true, value_delimiter = ',')]
    data: Vec<String>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::parse();
    if let Some([function, kibibytes]) = arguments.run.as_deref() {
        let case = cases().into_iter().find(|case| case.name == arguments.name).ok_or("no solver has this name")?;
        let call = *CALLS.get(*function).ok_or("no such function")?;
        let instances = read(&arguments.data)?;
        instances.run(case, call, kibibytes * 1024)?;
        return Ok(());
    }
    println!("{:<46} {:>7} {:>9} {:>7} {:>10} KiB", "solver", "solve", "_complex", "_in", "_complex_in");
    for case in cases().into_iter().filter(|case| case.name.contains(&arguments.name)) {
        let instances = Instances::of(&case);
        let mut needed = [0; CALLS.len()];
        for (function, needed) in needed.iter_mut().enumerate() {
            *needed = smallest(case.name, function, &instances)?;
        }
        let mark = |found: bool| if found { "" } else { " -" };
        let [real, complex, real_in, complex_in] = needed;
        println!(
            "{:<46} {real:>7} {complex:>9} {real_in:>7} {complex_in:>10}{}{}",
            case.name,
            mark(instances.real_twice.is_some()),
            mark(instances.complex_twice.is_some())
        );
    }
    Ok(())
}

/// The smallest stack in KiB, in steps of [`STEP`].
fn smallest(name: &str, function: usize, instances: &Instances) -> Result<usize, Box<dyn Error>> {
    let (mut too_small, mut enough) = (0, MOST / STEP);
    while enough - too_small > 1 {
        let middle = (too_small + enough) / 2;
        match works(name, function, middle * STEP, instances)? {
            true => enough = middle,
            false => too_small = middle,
        }
    }
    Ok(enough * STEP)
}

/// Whether a process survives the call.
fn works(name: &str, function: usize, kibibytes: usize, instances: &Instances) -> Result<bool, Box<dyn Error>> {
    let status = Command::new(std::env::current_exe()?)
        .args([name, "--run", &function.to_string(), &kibibytes.to_string()])
        .args(["--data", &written(CALLS[function], instances)])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()?;
    Ok(status.success())
}

/// The data of a call: instances separated by `,`, numbers by `:`.
fn written(call: Call, instances: &Instances) -> String {
    let numbers = |data: &Vec<f64>| data.iter().map(|x| x.to_bits().to_string()).collect::<Vec<_>>().join(":");
    instances.for_call(call).map(numbers).collect::<Vec<_>>().join(",")
}

fn read(texts: &[String]) -> Result<Instances, Box<dyn Error>> {
    let numbers = |text: &String| -> Result<Vec<f64>, Box<dyn Error>> {
        let bits = text.split(':').filter(|bits| !bits.is_empty());
        bits.map(|bits| Ok(f64::from_bits(bits.parse()?))).collect()
    };
    let mut lists = texts.iter().map(numbers).collect::<Result<Vec<_>, _>>()?.into_iter();
    let random = lists.next().unwrap_or_default();
    let twice = lists.next();
    Ok(Instances { random, real_twice: twice.clone(), complex_twice: twice })
}
