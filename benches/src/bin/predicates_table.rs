//! The table of the predicates: contestants of a cell take turns, round by round; medians, and the
//! second quickest round and the upper quartile. CGAL runs after them, alone: its branches are learnt.
//!
//! Arguments: the number of rounds (default 21), a part of a cell's name (default all), such as `in_circle N`.

use std::time::Instant;

use delone_benches::predicates::{Cgal, Input, Predicate, contestants, tuples};

const CALLS: usize = 4000;

#[expect(clippy::print_stdout, clippy::disallowed_methods, reason = "a program that times")]
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
            let contestants = contestants(predicate, &tuples);
            let mut nanoseconds = vec![Vec::new(); contestants.len()];
            let mut tallies = vec![[0, 0]; contestants.len()];
            for _ in 0..rounds {
                for (i, contestant) in contestants.iter().enumerate() {
                    let start = Instant::now();
                    tallies[i] = (contestant.run)();
                    nanoseconds[i].push(start.elapsed().as_secs_f64() * 1e9);
                }
            }
            let mut row = format!("| {cell}");
            for (i, times) in nanoseconds.iter_mut().enumerate() {
                times.sort_by(f64::total_cmp);
                #[expect(clippy::cast_precision_loss, reason = "4000")]
                let per_call = |time: f64| time / CALLS as f64;
                let [low, median, high] = [1, times.len() / 2, times.len() - times.len() / 4 - 1]
                    .map(|at| per_call(times[at]));
                let wrong = if tallies[i] == tallies[1] { "" } else { " (x)" };
                row += &format!(
                    " | {}: {median:.1} ({low:.1}..{high:.1}){wrong}",
                    contestants[i].name
                );
            }
            let peer = cgal.as_ref().and_then(|cgal| cgal.run(predicate, &tuples, rounds));
            if let Some(([low, median], tally)) = peer {
                let wrong = if tally == tallies[1] { "" } else { " (x)" };
                row += &format!(" | CGAL: {median:.1} ({low:.1}..){wrong}");
            }
            println!("{row} |");
        }
    }
}
