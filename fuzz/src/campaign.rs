//! One run of many mutated inputs.

use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use eliminant_generator::algebra::Random;

use crate::mutate::mutate;
use crate::outcome::{Outcome, hash};
use crate::target::Target;

/// An input and what it took.
#[derive(Clone, Debug, Default)]
pub struct Timed {
    /// How long.
    pub time: Duration,
    /// The input.
    pub input: Vec<u8>,
}

/// An input that must not be.
#[derive(Clone, Debug)]
pub struct Fault {
    /// The input.
    pub input: Vec<u8>,
    /// What is wrong.
    pub reason: String,
}

/// Inputs for one target, each from those before it.
pub struct Campaign<'t> {
    target: &'t Target,
    random: Random,
    /// Inputs that showed something new.
    pub pool: Vec<Vec<u8>>,
    seen: BTreeSet<u64>,
    /// How many inputs were run.
    pub executions: u64,
    /// How many of them were taken.
    pub accepted: u64,
    /// The input that took longest.
    pub slowest: Timed,
    /// The input that took longest of those that were taken.
    pub slowest_accepted: Timed,
    /// The first fault of each kind.
    pub faults: Vec<Fault>,
}

/// Runs an input; a panic is a fault.
pub fn run(target: &Target, input: &[u8]) -> Outcome {
    catch_unwind(AssertUnwindSafe(|| (target.run)(input))).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().map(String::as_str).or(panic.downcast_ref::<&str>().copied());
        Outcome { fault: Some(format!("panic: {}", text.unwrap_or("?"))), ..Outcome::default() }
    })
}

/// What two faults have in common that differ in numbers only.
fn kind(reason: &str) -> &str {
    reason.split(|c: char| c.is_ascii_digit()).next().unwrap_or_default()
}

impl<'t> Campaign<'t> {
    /// Runs the corpus, from which all inputs come.
    pub fn new(target: &'t Target, corpus: &[Vec<u8>], seed: u64) -> Self {
        let random = Random::new(seed ^ hash(target.name.bytes()));
        let mut campaign = Self {
            target,
            random,
            pool: Vec::new(),
            seen: BTreeSet::new(),
            executions: 0,
            accepted: 0,
            slowest: Timed::default(),
            slowest_accepted: Timed::default(),
            faults: Vec::new(),
        };
        for input in corpus {
            campaign.execute(input.clone());
        }
        campaign
    }

    /// The number of kinds of behaviour that were seen.
    pub fn kinds(&self) -> usize {
        self.seen.len()
    }

    /// Makes the next input. The choice does not depend on times: the same seed gives the same
    /// inputs.
    pub fn next_input(&mut self) -> Vec<u8> {
        let count = self.pool.len() as u64;
        if count == 0 {
            return mutate(self.target.kind, &[], &[], self.target.longest, &mut self.random);
        }
        // Every other input comes from the latest ones.
        let recent = self.random.below(2) * count.saturating_sub(32);
        let parent = recent + self.random.below(count - recent);
        let other = self.random.below(count);
        let [parent, other] = [parent, other].map(|at| &self.pool[at as usize]);
        mutate(self.target.kind, parent, other, self.target.longest, &mut self.random)
    }

    /// Runs an input and keeps it if it shows something new.
    pub fn execute(&mut self, input: Vec<u8>) {
        let start = Instant::now();
        let outcome = run(self.target, &input);
        let time = start.elapsed();
        self.executions += 1;
        self.accepted += u64::from(outcome.accepted);
        if time > self.slowest.time {
            self.slowest = Timed { time, input: input.clone() };
        }
        if outcome.accepted && time > self.slowest_accepted.time {
            self.slowest_accepted = Timed { time, input: input.clone() };
        }
        let late = (time > self.target.bound).then(|| format!("more than {:?}: {time:?}", self.target.bound));
        if let Some(reason) = outcome.fault.or(late) {
            if !self.faults.iter().any(|fault| kind(&fault.reason) == kind(&reason)) {
                self.faults.push(Fault { input, reason });
            }
            return;
        }
        let before = self.seen.len();
        self.seen.extend(outcome.kinds);
        if self.seen.len() > before && !outcome.expensive {
            self.pool.push(input);
        }
    }
}
