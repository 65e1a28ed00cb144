//! Instructions of a call, counted by valgrind's callgrind: they do not depend on what else the machine does.
//!
//! A program runs itself under callgrind twice, with all calls done once and three times; half of the difference is
//! what they take, without making the input. CGAL cannot be counted: valgrind has no directed rounding.

use std::hint::black_box;
use std::process::Command;

use super::{Input, Predicate, contestants, tuples};

/// Calls of a contestant that is counted.
const CALLS: usize = 500;

/// The instructions of a call of a contestant; `None` without valgrind. The running program must answer to the arguments
/// `--repeat PREDICATE INPUT CONTESTANT TIMES` by [`repeat`].
#[must_use]
pub fn instructions_of(predicate: Predicate, input: Input, contestant: &str) -> Option<u64> {
    let program = std::env::current_exe().ok()?;
    let collected = |times: &str| -> Option<u64> {
        let mut command = Command::new("valgrind");
        command.args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]).arg(&program);
        command.args(["--repeat", predicate.name(), input.name(), contestant, times]);
        let report = String::from_utf8(command.output().ok()?.stderr).ok()?;
        let (_, count) = report.rsplit_once("Collected :")?;
        count.split_whitespace().next()?.parse().ok()
    };
    Some((collected("3")? - collected("1")?) / (2 * CALLS as u64))
}

/// Does the calls of a contestant so many times, as [`instructions_of`] asks for. `None` if there is no such contestant.
#[must_use]
pub fn repeat(arguments: &[String]) -> Option<()> {
    let [predicate, input, name, times] = arguments else { return None };
    let predicate = Predicate::ALL.into_iter().find(|each| each.name() == predicate)?;
    let input = Input::ALL.into_iter().find(|each| each.name() == input)?;
    let contestants = contestants(predicate, &tuples(predicate, input, CALLS));
    let contestant = contestants.iter().find(|contestant| contestant.name == name)?;
    for _ in 0..times.parse().ok()? {
        black_box((contestant.run)());
    }
    Some(())
}
