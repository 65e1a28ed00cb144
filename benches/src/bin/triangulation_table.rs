//! The table of triangulations: contestants take turns, round by round; medians in nanoseconds a site, and a verdict.
//!
//! ```sh
//! cargo run --release -p delone-benches --bin triangulation_table -- \
//!     [--workloads uniform,grid] [--sizes 10000,1000000] [--rounds 3] [--threads 2] [--judge-max 200000] [--segments 200000]
//! ```
//! Of a workload's segments the first `--segments` are taken. A workload's kind decides who takes part: the plane, the plane with segments, or space. Contestants are judged where
//! there are at most `--judge-max` sites; `x` marks a wrong triangulation, `-` a refusal.
#![expect(clippy::print_stdout, reason = "it prints a table")]

use delone::workloads::{Points, generate};
use delone_benches::triangulations::{Contestant, Peers, Task, accepted, plane, space};

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let list = |name: &str, default: &str| -> Vec<String> {
        let given = words.iter().skip_while(|word| *word != name).nth(1);
        given.map_or(default, |text| text).split(',').map(str::to_owned).collect()
    };
    let number =
        |name: &str, default: &str| -> usize { list(name, default)[0].parse().expect("a number") };
    let peers = Peers::start();
    let (rounds, judge_max) = (number("--rounds", "3"), number("--judge-max", "200000"));
    for workload in list("--workloads", "uniform,gauss,clusters,grid,circle") {
        for size in list("--sizes", "10000,100000,1000000") {
            let input =
                generate(&workload, size.parse().expect("a number"), 1).expect("a workload");
            let mut segments = input.segments;
            segments.truncate(number("--segments", "4294967295"));
            let row = match input.points {
                Points::Plane(points) => {
                    let who = plane(&peers, !segments.is_empty(), number("--threads", "2"));
                    row(Task { points, segments }, who, rounds, judge_max)
                }
                Points::Space(points) => {
                    row(Task { points, segments }, space(&peers), rounds, judge_max)
                }
            };
            println!("| {workload} {row}");
        }
    }
}

/// Runs all contestants of a task.
fn row<const D: usize>(
    task: Task<D>,
    mut contestants: Vec<Contestant<'_, D>>,
    rounds: usize,
    judge_max: usize,
) -> String {
    let mut seconds = vec![Vec::new(); contestants.len()];
    let mut verdicts = vec![""; contestants.len()];
    for round in 0..rounds {
        for (i, contestant) in contestants.iter_mut().enumerate() {
            let run = (contestant.run)(&task);
            seconds[i].push(run.seconds);
            if round == 0 {
                verdicts[i] = match run.cells {
                    None => " -",
                    Some(cells) if task.points.len() <= judge_max && !accepted(&task, &cells) => {
                        " x"
                    }
                    Some(_) => "",
                };
            }
        }
    }
    #[expect(clippy::cast_precision_loss, reason = "sizes are small numbers")]
    let sites = task.points.len() as f64;
    let medians: Vec<f64> = seconds.iter_mut().map(|times| median(times) * 1e9 / sites).collect();
    let mut text = format!("| {} |", task.points.len());
    for (i, contestant) in contestants.iter().enumerate() {
        text += &format!(" {}: {:.0}{} |", contestant.name, medians[i], verdicts[i]);
    }
    let right = |&i: &usize| !contestants[i].ours && verdicts[i].is_empty();
    let peer = (0..medians.len()).filter(right).map(|i| medians[i]).fold(f64::INFINITY, f64::min);
    text + &format!(" best right peer / first of ours: {:.2} |", peer / medians[0])
}

fn median(times: &mut [f64]) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
