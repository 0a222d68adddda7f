//! The rule of the choice, on candidates that are made up.

use super::rule::{BLOCK, at_least, is_rejected};
use super::*;
use crate::search::monitor::Unmonitored;

/// A candidate: operations, each of a nanosecond, rows, log10 of all its residuals, and the period
/// of instances that lack a solution (0: none does).
type Made = (usize, usize, f64, usize);

fn measure_made(made: &[Made], at: usize, instances: Range<usize>) -> Stability {
    let (_, _, residual, every) = made[at];
    let incomplete = if every == 0 { 0 } else { instances.clone().filter(|k| k % every == every - 1).count() };
    let trials = instances.len();
    Stability { residuals_log10: vec![residual; trials], trials, incomplete, ..Stability::default() }
}

/// The candidate that is chosen with its verdict, and the trials of each candidate.
fn decide(preference: Preference, monitor: &dyn Monitor, made: &[Made]) -> (Option<(usize, Verdict)>, Vec<usize>) {
    decide_by(preference, monitor, made, &|at, instances| measure_made(made, at, instances))
}

fn decide_by(
    preference: Preference,
    monitor: &dyn Monitor,
    made: &[Made],
    measure: &dyn Fn(usize, Range<usize>) -> Stability,
) -> (Option<(usize, Verdict)>, Vec<usize>) {
    let cost = |&(operations, rows, ..): &Made| Cost {
        nanoseconds: operations,
        second_attempt: 15 * operations,
        operations,
        rows,
        basis: 1,
    };
    let costs: Vec<Cost> = made.iter().map(cost).collect();
    let measuring = Measuring { trials: 300, confirm: 10_000, seed: 1 };
    let (entries, known) = (Vec::new(), |_| None);
    let mut tournament = Tournament { costs: &costs, preference, measuring, known: &known, measure, monitor, entries };
    let chosen = tournament.accept().or_else(|| tournament.least_bad());
    let trials = tournament.entries.iter().map(|entry| entry.stability.trials).collect();
    (chosen.map(|at| (at, tournament.entries[at].verdict)), trials)
}

fn chosen(preference: Preference, made: &[Made]) -> Option<(usize, Verdict)> {
    decide(preference, &Unmonitored, made).0
}

use Preference::{Size, Speed, Stability as Stable};
use Verdict::{Accepted, Rejected, Screened};

#[test]
fn the_first_acceptable_candidate_wins() {
    assert_eq!(chosen(Speed, &[(100, 9, -13.0, 0), (200, 8, -16.0, 0)]), Some((0, Accepted)));
    assert_eq!(chosen(Speed, &[(100, 9, -11.0, 0), (200, 8, -15.0, 0)]), Some((1, Accepted)));
    assert_eq!(chosen(Size, &[(200, 8, -13.0, 0), (100, 9, -16.0, 0)]), Some((0, Accepted)));
    assert_eq!(chosen(Speed, &[]), None);
}

#[test]
fn of_those_as_fast_the_one_with_fewest_rows_wins() {
    let made = |operations| [(100, 9, -15.0, 0), (104, 7, -15.0, 0), (operations, 5, -15.0, 0)];
    assert_eq!(decide(Speed, &Unmonitored, &made(110)), (Some((2, Accepted)), vec![300, 300, 10_000]));
    assert_eq!(decide(Speed, &Unmonitored, &made(111)), (Some((1, Accepted)), vec![300, 10_000, 300]));
    assert_eq!(chosen(Stable, &made(105)), Some((0, Accepted)));
    // It lacks solutions, and is no faster.
    let made = [(100, 9, -15.0, 0), (104, 7, -15.0, 3000)];
    assert_eq!(chosen(Speed, &made), Some((0, Accepted)));
}

#[test]
fn fewest_rows_win_whatever_they_cost() {
    let made = [(100_000, 7, -15.0, 0), (100, 8, -15.0, 0)];
    assert_eq!(chosen(Size, &made), Some((0, Accepted)));
}

#[test]
fn what_screening_cannot_see_confirmation_does() {
    // One in 400 lacks a solution: none of the first 300.
    let (decision, trials) = decide(Speed, &Unmonitored, &[(100, 9, -15.0, 400), (200, 9, -15.0, 0)]);
    assert_eq!(decision, Some((1, Accepted)));
    assert!((301..10_000).contains(&trials[0]), "{trials:?}");
    assert_eq!(trials[1], 10_000);
}

#[test]
fn large_candidates_are_measured_on_fewer_instances() {
    let trials = |operations| decide(Speed, &Unmonitored, &[(operations, 9, -15.0, 0), (operations, 9, -15.0, 1)]).1;
    assert_eq!(trials(1_000_000), [10_000, BLOCK]);
    assert_eq!(trials(4_000_000), [2500, BLOCK]);
    assert_eq!(trials(100_000_000), [INCOMPLETE_ONE_IN, BLOCK]);
    assert_eq!(trials(1_000_000_000), [INCOMPLETE_ONE_IN, 10]);
    assert_eq!(trials(10_000_000_000), [100, 1]);
}

#[test]
fn few_large_candidates_are_confirmed() {
    // One in 400 lacks a solution, which rejects at about 800 instances.
    let made: Vec<Made> = (0..SCREENED_AT_MOST).map(|k| (20_000_000 + k, 9, -15.0, 400)).collect();
    let (decision, trials) = decide(Speed, &Unmonitored, &made);
    assert!(matches!(decision, Some((_, Rejected | Screened))));
    assert_eq!(trials.len(), SCREENED);
    let confirmed = trials.iter().filter(|&&trials| trials > 300).count();
    assert!((4..8).contains(&confirmed), "{trials:?}");
}

#[test]
fn a_hopeless_candidate_costs_one_block() {
    let (_, trials) = decide(Speed, &Unmonitored, &[(100, 9, -15.0, 3), (200, 9, -15.0, 0)]);
    assert_eq!(trials, [BLOCK, 10_000]);
}

#[test]
fn one_failure_rejects() {
    let failed = Stability { trials: 10_000, failures: 1, ..Stability::default() };
    assert!(is_rejected(&failed, 10_000));
    let bad = Stability { trials: 10_000, incomplete: 11, ..Stability::default() };
    assert!(is_rejected(&bad, 10_000));
    assert!(!is_rejected(&Stability { incomplete: 10, ..bad }, 10_000));
}

#[test]
fn among_similar_costs_the_most_complete_wins() {
    let made = |second, rows| [(100, 9, -15.0, 2000), (second, rows, -13.0, 0), (second + 1, rows, -16.0, 0)];
    assert_eq!(chosen(Speed, &made(105, 20)), Some((1, Accepted)));
    assert_eq!(chosen(Speed, &made(111, 20)), Some((0, Accepted)));
    assert_eq!(chosen(Size, &made(900, 9)), Some((1, Accepted)));
    assert_eq!(chosen(Size, &made(105, 10)), Some((0, Accepted)));
}

#[test]
fn second_attempts_take_time() {
    let made = [(100, 9, -15.0, 0), (130, 9, -15.0, 0), (170, 9, -15.0, 0)];
    let chosen_where = |repeated: [usize; 3]| {
        let measure = |at: usize, instances: Range<usize>| {
            let repeated = instances.len() * repeated[at] / 100;
            Stability { repeated, ..measure_made(&made, at, instances) }
        };
        decide_by(Speed, &Unmonitored, &made, &measure).0
    };
    assert_eq!(chosen_where([1, 0, 0]), Some((0, Accepted)));
    assert_eq!(chosen_where([3, 0, 0]), Some((1, Accepted)));
    assert_eq!(chosen_where([5, 3, 0]), Some((2, Accepted)));
}

/// Scenes are like the data of users: where there are any, random instances say nothing.
#[test]
fn second_attempts_on_scenes_decide() {
    let made = [(100, 9, -15.0, 0), (130, 9, -15.0, 0)];
    let chosen_where = |on_scenes: [usize; 2]| {
        let measure = |at: usize, instances: Range<usize>| Stability {
            repeated: instances.len() / 20,
            scenes: instances.len(),
            scenes_repeated: instances.len() * on_scenes[at] / 100,
            ..measure_made(&made, at, instances)
        };
        decide_by(Speed, &Unmonitored, &made, &measure).0
    };
    assert_eq!(chosen_where([1, 0]), Some((0, Accepted)));
    assert_eq!(chosen_where([3, 0]), Some((1, Accepted)));
    assert_eq!(chosen_where([3, 3]), Some((0, Accepted)));
}

#[test]
fn the_cheapest_is_confirmed_first_where_second_attempts_turn_out_to_be_many() {
    // Screening sees no second attempt of the first candidate, whose rows are fewest. Of the
    // others, those with fewer rows have second attempts, too.
    let made = [(100, 7, -15.0, 0), (108, 7, -15.0, 0), (109, 7, -15.0, 0), (104, 9, -15.0, 0)];
    let measure = |at: usize, instances: Range<usize>| {
        let is_late = instances.start >= 300 && at != 3;
        Stability { repeated: usize::from(is_late) * instances.len() / 20, ..measure_made(&made, at, instances) }
    };
    let (chosen, trials) = decide_by(Speed, &Unmonitored, &made, &measure);
    assert_eq!((chosen, trials), (Some((3, Accepted)), vec![10_000, 10_000, 300, 10_000]));
}

#[test]
fn stability_takes_the_most_precise_within_its_cost() {
    let made = [(100, 9, -13.0, 0), (150, 9, -15.0, 0), (190, 9, -14.0, 0), (250, 9, -16.0, 0)];
    assert_eq!(chosen(Stable, &made), Some((1, Accepted)));
    assert_eq!(decide(Stable, &Unmonitored, &made).1.len(), 3, "the last is too expensive to be measured");
}

#[test]
fn where_all_residuals_are_large_close_to_the_best_will_do() {
    assert_eq!(chosen(Speed, &[(100, 9, -8.0, 0), (200, 9, -9.5, 0), (300, 9, -10.0, 0)]), Some((1, Accepted)));
}

#[test]
fn further_candidates_are_screened_where_the_first_are_rejected() {
    let mut made: Vec<Made> = (0..SCREENED).map(|k| (100 + k, 9, -15.0, 10)).collect();
    made.extend([(900, 9, -15.0, 0), (901, 9, -15.0, 0)]);
    assert_eq!(chosen(Speed, &made), Some((SCREENED, Accepted)));
    made = (0..SCREENED).map(|k| (100 + k, 9, -15.0, 400)).collect();
    made.extend([(900, 9, -15.0, 0), (901, 9, -15.0, 0)]);
    assert_eq!(chosen(Speed, &made), Some((SCREENED, Accepted)));
}

#[test]
fn without_an_acceptable_candidate_the_most_complete_wins_then_the_most_precise() {
    let made = [(100, 9, -15.0, 3), (200, 9, -14.0, 10), (300, 9, -15.0, 10)];
    assert_eq!(chosen(Speed, &made), Some((2, Rejected)));
}

/// A monitor that ends the search after this number of questions.
struct Impatient(std::sync::atomic::AtomicUsize, usize);

impl Monitor for Impatient {
    fn say(&self, _: &str) {}

    fn is_over(&self, _: Stage) -> bool {
        self.0.fetch_add(1, std::sync::atomic::Ordering::Relaxed) >= self.1
    }
}

#[test]
fn where_the_time_is_over_the_first_finalist_so_far_is_chosen() {
    let made = [(100, 9, -11.0, 0), (200, 9, -15.0, 0), (300, 9, -15.0, 0)];
    let over_after = |questions| decide(Speed, &Impatient(0.into(), questions), &made);
    assert_eq!(over_after(0), (Some((0, Screened)), vec![BLOCK]));
    assert_eq!(over_after(5), (Some((1, Screened)), vec![300, 300]));
    let (decision, trials) = over_after(40);
    assert_eq!(decision, Some((1, Screened)));
    assert!((301..10_000).contains(&trials[1]), "{trials:?}");
}

#[test]
fn poisson_tails() {
    assert!((at_least(1, 1.0) - (1.0 - (-1.0_f64).exp())).abs() < 1e-15);
    assert!((at_least(3, 0.3) - 0.003_599_493).abs() < 1e-8);
    assert_eq!(at_least(0, 5.0), 1.0);
}
