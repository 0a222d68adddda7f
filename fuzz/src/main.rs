//! Runs many mutated inputs of one target.
//!
//! ```text
//! cargo run --release -p eliminant-fuzz -- problem --executions 1000000
//! ```

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use std::{fs, thread};

use clap::Parser;
use eliminant_fuzz::campaign::{Campaign, Timed};
use eliminant_fuzz::corpus;
use eliminant_fuzz::target::Target;
use eliminant_fuzz::targets::targets;

/// Run many mutated inputs of one target: no panic, nothing slow, no wrong solution
#[derive(Parser)]
struct Arguments {
    /// The target; all of them are listed if there is none
    target: Option<String>,
    /// How many inputs are run
    #[arg(long, value_name = "N", default_value_t = 1_000_000)]
    executions: u64,
    /// No new input is begun after so many seconds
    #[arg(long, value_name = "SECONDS")]
    seconds: Option<u64>,
    /// Seed of the inputs
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// Folders of further inputs to start from; may be given several times
    #[arg(long, value_name = "FOLDER")]
    from: Vec<PathBuf>,
    /// Write the inputs with faults, and the slowest ones, to this folder
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    /// Write the shortest inputs that show most of what was seen to the committed corpus, at most
    /// so many
    #[arg(long, value_name = "N")]
    update_corpus: Option<usize>,
}

/// An input that takes so many times the bound does not end.
const NEVER: u32 = 60;

/// The input that is run now, and since when.
type Running = Arc<Mutex<Option<(Instant, Vec<u8>)>>>;

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let arguments = Arguments::parse();
    let all = targets();
    let Some(name) = &arguments.target else {
        all.iter().for_each(|target| println!("{:16} {}", target.name, target.what));
        return Ok(ExitCode::SUCCESS);
    };
    let target =
        all.iter().find(|target| target.name == *name).ok_or_else(|| format!("there is no target `{name}`"))?;
    let mut inputs = corpus::read(&corpus::folder(target)).unwrap_or_default();
    for folder in &arguments.from {
        inputs.extend(corpus::read(folder)?);
    }
    // A panic is a fault that is reported at the end.
    std::panic::set_hook(Box::new(|_| {}));
    let running = watch(target, arguments.out.clone());
    let start = Instant::now();
    let mut campaign = Campaign::new(target, &inputs, arguments.seed);
    let is_time_left = || arguments.seconds.is_none_or(|seconds| start.elapsed() < Duration::from_secs(seconds));
    while campaign.executions < arguments.executions && is_time_left() {
        let input = campaign.next_input();
        if let Ok(mut running) = running.lock() {
            *running = Some((Instant::now(), input.clone()));
        }
        campaign.execute(input);
    }
    if let Ok(mut running) = running.lock() {
        *running = None;
    }
    report(target, &campaign, start.elapsed(), arguments.out.as_deref())?;
    if let Some(most) = arguments.update_corpus {
        corpus::replace(target, &corpus::reduce(target, &campaign.pool, most))?;
    }
    Ok(if campaign.faults.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Ends the process at an input that does not end.
fn watch(target: &Target, out: Option<PathBuf>) -> Running {
    let running = Running::default();
    let (watched, limit, name) = (Arc::clone(&running), NEVER * target.bound, target.name);
    thread::spawn(move || {
        loop {
            thread::sleep(Duration::from_secs(1));
            let Ok(running) = watched.lock() else { return };
            if let Some((since, input)) = &*running
                && since.elapsed() > limit
            {
                eprintln!("{name}: an input of {} bytes runs for more than {limit:?}", input.len());
                let _ = save(out.as_deref(), "endless", input);
                std::process::exit(2);
            }
        }
    });
    running
}

fn report(target: &Target, campaign: &Campaign<'_>, time: Duration, out: Option<&Path>) -> Result<(), Box<dyn Error>> {
    let show = |timed: &Timed| format!("{:.1} ms", 1e3 * timed.time.as_secs_f64());
    println!(
        "{}: {} executions in {:.0} s, {} accepted, {} kinds of behaviour from {} inputs; slowest {}, slowest accepted {}",
        target.name,
        campaign.executions,
        time.as_secs_f64(),
        campaign.accepted,
        campaign.kinds(),
        campaign.pool.len(),
        show(&campaign.slowest),
        show(&campaign.slowest_accepted),
    );
    save(out, "slowest", &campaign.slowest.input)?;
    save(out, "slowest_accepted", &campaign.slowest_accepted.input)?;
    for (number, fault) in campaign.faults.iter().enumerate() {
        println!("fault {number}: {}", fault.reason);
        save(out, &format!("fault_{number}"), &fault.input)?;
    }
    Ok(())
}

fn save(out: Option<&Path>, name: &str, input: &[u8]) -> std::io::Result<()> {
    let Some(folder) = out else { return Ok(()) };
    fs::create_dir_all(folder)?;
    fs::write(folder.join(name), input)
}
