//! Work that takes minutes returns soon after it is interrupted, whatever it does at that time.
#![cfg(feature = "search")]

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use eliminant_generator::check::{SolutionCount, check, check_until};
use eliminant_generator::problem::Problem;
use eliminant_generator::search::choose::{Measuring, choose};
use eliminant_generator::search::monitor::{Monitor, Stage};
use eliminant_generator::search::preference::Preference;
use eliminant_generator::search::{SearchError, SearchOptions, candidates, traced_candidates};

/// Steps take well under a second each. The machine may be busy.
const SOON: Duration = Duration::from_secs(5);

/// Held by the test that runs. Each works on all cores: beside each other they would measure how
/// cores are divided.
static CORES: Mutex<()> = Mutex::new(());

fn alone() -> MutexGuard<'static, ()> {
    // A test that failed leaves the cores to the next one.
    CORES.lock().unwrap_or_else(PoisonError::into_inner)
}

fn read(name: &str, text: &str) -> Problem {
    Problem::parse(name, text).unwrap_or_else(|messages| panic!("{}", messages.render()))
}

/// Three dense equations of this degree in three unknowns, with a factor that must not vanish.
fn dense(degree: usize) -> Problem {
    let power = |(name, power): (&str, usize)| (power > 0).then(|| format!("{name}.pow({power})"));
    let mut monomials = vec!["1".to_owned()];
    for i in 0..=degree {
        for j in 0..=degree - i {
            for k in 0..=degree - i - j {
                let factors: Vec<String> = [("x", i), ("y", j), ("z", k)].into_iter().filter_map(power).collect();
                monomials.extend((!factors.is_empty()).then(|| factors.join(" * ")));
            }
        }
    }
    let (terms, list) = (monomials.len(), monomials.join(", "));
    read(
        "dense.rs",
        &format!(
            "fn dense(c: [[f64; {terms}]; 3]) -> (x, y, z) {{
                for f in c {{ dot(f, [{list}]) == 0; }}
                x + 2 * y + 3 * z + 1 != 0;
            }}"
        ),
    )
}

/// Does work and sets the flag after some time. Returns the result and how long it took from then
/// on; `None` if it had come to its end.
fn interrupted<T: Send>(after: Duration, work: impl FnOnce(&AtomicBool) -> T + Send) -> Option<(T, Duration)> {
    let flag = AtomicBool::new(false);
    thread::scope(|scope| {
        let work = scope.spawn(|| (work(&flag), Instant::now()));
        let start = Instant::now();
        while start.elapsed() < after {
            if work.is_finished() {
                return None;
            }
            thread::sleep(Duration::from_millis(5));
        }
        flag.store(true, Ordering::SeqCst);
        let set = Instant::now();
        let (result, end) = work.join().unwrap();
        println!("interrupted after {after:?}: returned in {:?}", end.saturating_duration_since(set));
        Some((result, end.saturating_duration_since(set)))
    })
}

/// Moments of long work, in seconds since its begin.
fn moments(seconds: &[f64]) -> impl Iterator<Item = Duration> {
    seconds.iter().map(|&seconds| Duration::from_secs_f64(seconds))
}

#[test]
fn the_count_of_solutions_is_interrupted_at_any_time() {
    let _cores = alone();
    // 1,000 solutions: F4 takes seconds, and so does the change of order behind the saturation.
    let problem = dense(10);
    let mut interruptions = 0;
    for after in moments(&[0.01, 0.3, 1.0, 2.0, 4.0, 8.0]) {
        let Some((result, took)) = interrupted(after, |flag| check_until(&problem, flag)) else { break };
        assert!(took < SOON, "interrupted after {after:?}, returned {took:?} later");
        if let Err(messages) = result {
            assert!(messages.render().contains("interrupted before the solutions were counted"));
            interruptions += 1;
        }
    }
    assert!(interruptions >= 3, "{interruptions}");
}

/// A monitor that only the flag ends.
struct Until<'a>(&'a AtomicBool);

impl Monitor for Until<'_> {
    fn say(&self, _: &str) {}

    fn is_over(&self, _: Stage) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    fn interruption(&self) -> Option<&AtomicBool> {
        Some(self.0)
    }
}

/// A problem for which nothing is found within minutes.
fn slowest() -> (Problem, SolutionCount) {
    let problem = read("slow.rs", include_str!("../../templates/relpose_7pt_focal_radial.rs"));
    let count = check(&problem).unwrap_or_else(|messages| panic!("{}", messages.render()));
    (problem, count)
}

#[test]
fn growing_and_reducing_are_interrupted_at_any_time() {
    let _cores = alone();
    let (problem, count) = slowest();
    for (max_columns, seconds) in [(600, [0.01, 1.5, 6.0]), (3000, [0.5, 1.0, 4.0])] {
        let options = SearchOptions { max_columns, ..SearchOptions::default() };
        for after in moments(&seconds) {
            let search = |flag: &AtomicBool| candidates(&problem, &count, &options, &Until(flag));
            let (result, took) = interrupted(after, search).unwrap();
            assert!(took < SOON, "interrupted after {after:?}, returned {took:?} later");
            match result {
                Err(SearchError::NotFound { is_over, .. }) => assert!(is_over),
                Err(error) => panic!("{error}"),
                Ok(found) => {
                    assert!(found.is_cut);
                    assert!(found.candidates.iter().all(|candidate| candidate.plan.check().is_ok()));
                }
            }
        }
    }
}

#[test]
fn the_trace_of_a_basis_is_interrupted_at_any_time() {
    let _cores = alone();
    let (problem, count) = slowest();
    let mut interruptions = 0;
    for after in moments(&[0.01, 1.0, 5.0]) {
        let search = |flag: &AtomicBool| traced_candidates(&problem, &count, &SearchOptions::default(), &Until(flag));
        let Some((result, took)) = interrupted(after, search) else { break };
        assert!(took < SOON, "interrupted after {after:?}, returned {took:?} later");
        assert!(!matches!(result, Err(SearchError::NotFound { is_over: false, .. })));
        interruptions += 1;
    }
    assert!(interruptions >= 2, "{interruptions}");
}

#[test]
fn an_interrupted_choice_counts_what_was_measured() {
    let _cores = alone();
    let problem = read("two_conics.rs", include_str!("../../templates/two_conics.rs"));
    let count = check(&problem).unwrap();
    let never = AtomicBool::new(false);
    let found = candidates(&problem, &count, &SearchOptions::default(), &Until(&never)).unwrap();
    let measuring = Measuring { trials: 1_000_000, confirm: 100_000_000, seed: 1 };
    let chosen = |flag: &AtomicBool| choose(&found.candidates, Preference::Speed, measuring, &|_| None, &Until(flag));
    // Nothing is measured where the flag is set before.
    let choice = chosen(&AtomicBool::new(true)).unwrap();
    assert_eq!((choice.measured.len(), choice.measured[0].stability.trials, choice.is_cut), (1, 0, true));
    let (choice, took) = interrupted(Duration::from_millis(100), chosen).expect("100,000,000 instances take longer");
    assert!(took < SOON, "{took:?}");
    let choice = choice.unwrap();
    let stability = &choice.measured[choice.chosen].stability;
    assert!(choice.is_cut && stability.trials > 0 && stability.found <= stability.expected, "{stability:?}");
}
