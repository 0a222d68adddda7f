//! The committed corpora, and a fixed run of mutated inputs from them: no panic, nothing endless,
//! no wrong solution.

use std::time::{Duration, Instant};

use eliminant_fuzz::campaign::{Campaign, run};
use eliminant_fuzz::corpus;
use eliminant_fuzz::mutate::Kind;
use eliminant_fuzz::target::Target;
use eliminant_fuzz::targets::targets;

/// Mutated inputs of each reader.
const TEXTS: u64 = 4000;
/// Mutated inputs of each solver: second attempts take milliseconds.
const DATA: u64 = 1000;
/// What this run may take beyond the bound of a target: other programs run, and without
/// optimisation all takes longer.
const SLACK: u32 = 20;
/// Most bytes of all inputs of a target.
const CORPUS_BYTES: usize = 64 << 10;

fn inputs(target: &Target) -> Vec<Vec<u8>> {
    corpus::read(&corpus::folder(target)).unwrap_or_else(|error| panic!("{}: {error}", target.name))
}

#[test]
fn every_input_of_the_corpora_is_run_without_a_fault() {
    for target in targets() {
        let (inputs, mut accepted) = (inputs(&target), 0);
        assert!(inputs.len() >= 8, "{}: {} inputs", target.name, inputs.len());
        let bytes: usize = inputs.iter().map(Vec::len).sum();
        assert!(bytes <= CORPUS_BYTES, "{}: {bytes} bytes", target.name);
        for input in &inputs {
            let start = Instant::now();
            let outcome = run(&target, input);
            let time = start.elapsed();
            let text = String::from_utf8_lossy(input);
            assert_eq!(outcome.fault, None, "{}: {text}", target.name);
            assert!(time < SLACK * target.bound, "{}: {time:?}: {text}", target.name);
            accepted += usize::from(outcome.accepted);
        }
        assert!(accepted > 0, "{}: no input is accepted", target.name);
    }
}

#[test]
fn mutated_inputs_are_run_without_a_fault() {
    for mut target in targets() {
        target.bound *= SLACK;
        let mut campaign = Campaign::new(&target, &inputs(&target), 1);
        let executions = if target.kind == Kind::Numbers { DATA } else { TEXTS };
        while campaign.executions < executions {
            let input = campaign.next_input();
            campaign.execute(input);
        }
        assert!(campaign.faults.is_empty(), "{}: {:?}", target.name, campaign.faults);
        println!("{}: {} kinds, slowest {:?}", target.name, campaign.kinds(), campaign.slowest.time);
    }
}

#[test]
fn a_panic_a_fault_and_a_slow_input_are_seen() {
    let target = |run| Target { name: "test", what: "", kind: Kind::Numbers, longest: 8, bound: Duration::ZERO, run };
    let reasons = |target: &Target| -> Vec<String> {
        let campaign = Campaign::new(target, &[vec![1]], 1);
        campaign.faults.into_iter().map(|fault| fault.reason).collect()
    };
    assert_eq!(reasons(&target(|_| panic!("oh"))), ["panic: oh"]);
    let late = reasons(&target(|_| Default::default()));
    assert!(late.len() == 1 && late[0].starts_with("more than 0ns"), "{late:?}");
}
