//! The table of the predicates: contestants of a cell take turns, round by round; medians, and the
//! second quickest round and the upper quartile. CGAL runs after them, alone: its branches are learnt.
//!
//! So does our kernel once more, for a fair comparison with it (*kernel alone*).
//!
//! `predicates_table [ROUNDS] [PART]`: the number of rounds (default 21), a part of a cell's name (default all), such as `in_circle N`.
//! Constructed points are in the cells `constructed plane` and `constructed space`.
//!
//! `predicates_table --instructions [PART]`: instead of times, the instructions of a call, by valgrind's callgrind.

use std::process::ExitCode;
use std::time::Instant;

use delone_benches::predicates::{
    Cgal, Contestant, Input, Predicate, constructions, contestants, instructions_of, repeat, tuples,
};

const CALLS: usize = 4000;
const CALLS_CONSTRUCTED: usize = 1000;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.split_first() {
        Some((first, rest)) if first == "--repeat" => match repeat(rest) {
            Some(()) => ExitCode::SUCCESS,
            None => ExitCode::FAILURE,
        },
        Some((first, rest)) if first == "--instructions" => {
            count_all(rest.first().map_or("", String::as_str));
            ExitCode::SUCCESS
        }
        _ => {
            let rounds = arguments.first().and_then(|text| text.parse().ok()).unwrap_or(21);
            time_all(rounds, arguments.get(1).map_or("", String::as_str));
            ExitCode::SUCCESS
        }
    }
}

/// The cells whose names contain `part`.
fn cells(part: &str) -> impl Iterator<Item = (String, Predicate, Input)> {
    let all = Predicate::ALL.into_iter().flat_map(|predicate| Input::ALL.map(|i| (predicate, i)));
    all.map(|(predicate, input)| {
        (format!("{} {}", predicate.name(), input.name()), predicate, input)
    })
    .filter(move |(cell, ..)| cell.contains(part))
}

#[expect(clippy::print_stdout, reason = "a program that prints a table")]
fn count_all(part: &str) {
    for (cell, predicate, input) in cells(part) {
        let mut row = format!("| {cell}");
        for Contestant { name, .. } in contestants(predicate, &tuples(predicate, input, 1)) {
            match instructions_of(predicate, input, name) {
                Some(count) => row += &format!(" | {name}: {count}"),
                None => row += &format!(" | {name}: -"),
            }
        }
        println!("{row} |");
    }
}

#[expect(clippy::print_stdout, reason = "a program that prints a table")]
fn time_all(rounds: usize, part: &str) {
    let cgal = Cgal::build();
    for (cell, predicate, input) in cells(part) {
        let tuples = tuples(predicate, input, CALLS);
        let contestants = contestants(predicate, &tuples);
        let timed = in_turns(&contestants, rounds, CALLS);
        let right = timed[1].tally;
        let mut row = format!("| {cell}");
        let mut add = |name: &str, [low, median, high]: [f64; 3], tally| {
            let wrong = if tally == right { "" } else { " (x)" };
            row += &format!(" | {name}: {median:.1} ({low:.1}..{high:.1}){wrong}");
        };
        for Timed { name, times, tally } in &timed {
            add(name, *times, *tally);
        }
        if let Some((times, tally)) =
            cgal.as_ref().and_then(|cgal| cgal.run(predicate, &tuples, rounds))
        {
            add("CGAL", times, tally);
        }
        for Timed { times, tally, .. } in in_turns(&contestants[..1], rounds, CALLS) {
            add("kernel alone", times, tally);
        }
        println!("{row} |");
    }
    for (name, contestants) in constructions(CALLS_CONSTRUCTED) {
        if !format!("constructed {name}").contains(part) {
            continue;
        }
        for Timed { name, times: [low, median, high], .. } in
            in_turns(&contestants, rounds, CALLS_CONSTRUCTED)
        {
            println!("| {name} | {median:.1} ({low:.1}..{high:.1}) |");
        }
    }
}

/// What a contestant took.
struct Timed {
    name: &'static str,
    /// Nanoseconds a call: the second quickest round, the median, the upper quartile.
    times: [f64; 3],
    tally: [usize; 2],
}

/// All contestants, round by round.
#[expect(clippy::disallowed_methods, reason = "a program that times")]
fn in_turns(contestants: &[Contestant], rounds: usize, calls: usize) -> Vec<Timed> {
    let mut nanoseconds = vec![Vec::new(); contestants.len()];
    let mut tallies = vec![[0, 0]; contestants.len()];
    for _ in 0..rounds {
        for (i, contestant) in contestants.iter().enumerate() {
            let start = Instant::now();
            tallies[i] = (contestant.run)();
            nanoseconds[i].push(start.elapsed().as_secs_f64() * 1e9);
        }
    }
    let timed = contestants.iter().zip(&mut nanoseconds).zip(tallies);
    timed
        .map(|((contestant, times), tally)| {
            times.sort_by(f64::total_cmp);
            #[expect(clippy::cast_precision_loss, reason = "a few thousand")]
            let per_call = |time: f64| time / calls as f64;
            let places = [1, times.len() / 2, times.len() - times.len() / 4 - 1];
            Timed { name: contestant.name, times: places.map(|at| per_call(times[at])), tally }
        })
        .collect()
}
