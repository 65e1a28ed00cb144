//! So many calls of the predicates against the oracle, on random and adversarial points.
//!
//! Arguments: the number of calls (default 1,000,000), a seed (default 1). Ends with 1 if a sign was wrong.

use delone_benches::adversary::{
    Tally, round, round_of_constructed, round_of_cross, round_of_metric, round_of_power,
};
use delone_benches::random::Random;

/// Rounds of one task.
const ROUNDS: usize = 10_000;

/// A name, a round, how rare it is.
type Task = (&'static str, fn(&mut Random, &mut Tally), usize);

/// What is soaked, and how often in comparison: the oracle is slow in many dimensions.
const TASKS: [Task; 15] = [
    ("plane", round::<2, 4>, 1),
    ("space", round::<3, 5>, 1),
    ("cross", round_of_cross, 1),
    ("line", round::<1, 3>, 10),
    ("4 axes", round::<4, 6>, 20),
    ("5 axes", round::<5, 7>, 200),
    ("7 axes", round::<7, 9>, 10_000),
    ("power 2", round_of_power::<2, 4>, 10),
    ("power 3", round_of_power::<3, 5>, 10),
    ("power 4", round_of_power::<4, 6>, 50),
    ("built 2", round_of_constructed::<2>, 10),
    ("built 3", round_of_constructed::<3>, 20),
    ("built 4", round_of_constructed::<4>, 100),
    ("metric 2", round_of_metric::<2>, 10),
    ("metric 3", round_of_metric::<3>, 20),
];

#[expect(clippy::print_stdout, reason = "a program that reports")]
fn main() -> std::process::ExitCode {
    let argument = |i: usize| std::env::args().nth(i).and_then(|text| text.parse().ok());
    let (calls, seed) = (argument(1).unwrap_or(1_000_000), argument(2).unwrap_or(1));
    let mut tallies = [Tally::default(); TASKS.len()];
    let mut random = Random::new(seed);
    while tallies.iter().map(|tally| tally.calls).sum::<u64>() < calls {
        for ((_, round, rarity), tally) in TASKS.iter().zip(&mut tallies) {
            (0..ROUNDS / rarity).for_each(|_| round(&mut random, tally));
        }
    }
    for ((name, ..), tally) in TASKS.iter().zip(&tallies) {
        let Tally { calls, zeros, wrong } = tally;
        println!("{name:8} {calls:12} calls, {zeros:11} degenerate determinants, {wrong} wrong");
    }
    let wrong: u64 = tallies.iter().map(|tally| tally.wrong).sum();
    std::process::ExitCode::from(u8::from(wrong > 0))
}
