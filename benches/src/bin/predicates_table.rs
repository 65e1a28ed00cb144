//! The table of the predicates: contestants of a cell take turns, round by round; medians, and the
//! second quickest round and the upper quartile. CGAL runs after them, alone: its branches are learnt.
//!
//! Arguments: the number of rounds (default 21), a part of a cell's name (default all), such as `in_circle N`. Constructed points
//! are in the cells `constructed plane` and `constructed space`.

use std::time::Instant;

use delone_benches::predicates::{
    Cgal, Contestant, Input, Predicate, constructions, contestants, tuples,
};

const CALLS: usize = 4000;
const CALLS_CONSTRUCTED: usize = 1000;

#[expect(clippy::print_stdout, reason = "a program that prints a table")]
fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let rounds = arguments.first().and_then(|text| text.parse().ok()).unwrap_or(21);
    let part = arguments.get(1).map_or("", String::as_str);
    let cgal = Cgal::build();
    for predicate in Predicate::ALL {
        for input in Input::ALL {
            let cell = format!("{} {input:?}", predicate.name());
            if !cell.contains(part) {
                continue;
            }
            let tuples = tuples(predicate, input, CALLS);
            let timed = in_turns(&contestants(predicate, &tuples), rounds, CALLS);
            let right = timed[1].tally;
            let mut row = format!("| {cell}");
            for Timed { name, times: [low, median, high], tally } in timed {
                let wrong = if tally == right { "" } else { " (x)" };
                row += &format!(" | {name}: {median:.1} ({low:.1}..{high:.1}){wrong}");
            }
            let peer = cgal.as_ref().and_then(|cgal| cgal.run(predicate, &tuples, rounds));
            if let Some(([low, median], tally)) = peer {
                let wrong = if tally == right { "" } else { " (x)" };
                row += &format!(" | CGAL: {median:.1} ({low:.1}..){wrong}");
            }
            println!("{row} |");
        }
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
