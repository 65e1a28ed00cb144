//! One target, case after case, until a budget is used up.

use std::path::Path;
use std::time::{Duration, Instant};

use delone_laws::fuzz::{Subject, Target};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::program::Program;
use super::state::{self, Timed};
use crate::failure::Failure;
use crate::watch;

/// When to stop.
#[derive(Clone, Copy)]
pub(crate) struct Budget {
    pub(crate) seconds: Option<Duration>,
    pub(crate) cases: Option<u64>,
    /// At the first failure.
    pub(crate) first: bool,
}

/// Between two times that the tally is saved.
const SAVED_EVERY: Duration = Duration::from_secs(5);

/// Runs cases until the budget is used up or the user interrupts; saves the tally on the way and at the end if there is a
/// folder for it.
pub(crate) fn run(
    target: &Target,
    timed: &mut Timed,
    budget: Budget,
    program: &mut Option<Program>,
    state: Option<&Path>,
    quiet: bool,
) -> Result<(), Failure> {
    let (start, mut saved) = (Instant::now(), Instant::now());
    let before = timed.seconds;
    let share = budget.cases.map(|cases| timed.tally.shard.share(cases));
    let bar = bar(target.name, share, quiet);
    while share.is_none_or(|share| timed.tally.executions < share)
        && budget.seconds.is_none_or(|limit| start.elapsed() < limit)
        && (!budget.first || timed.tally.findings.is_empty())
        && !watch::is_interrupted()
    {
        let tally = &mut timed.tally;
        let input = target.case(tally.seed, tally.next());
        match program {
            Some(program) => tally.step_with(&input, program),
            None => tally.step_with(&input, &mut &*target),
        }
        bar.set_position(tally.executions);
        timed.seconds = before + start.elapsed().as_secs_f64();
        if saved.elapsed() > SAVED_EVERY {
            bar.set_message(format!("{}: {} failures", target.name, timed.tally.findings.len()));
            state.map_or(Ok(()), |folder| state::save(folder, timed))?;
            saved = Instant::now();
        }
    }
    bar.finish_and_clear();
    state.map_or(Ok(()), |folder| state::save(folder, timed))
}

fn bar(name: &str, cases: Option<u64>, quiet: bool) -> ProgressBar {
    let target =
        if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr_with_hz(5) };
    let bar = ProgressBar::with_draw_target(cases, target);
    let style = match cases {
        Some(_) => "{msg} {wide_bar} {human_pos}/{human_len}, {per_sec}, {eta} left",
        None => "{msg} {spinner} {human_pos} cases, {per_sec}",
    };
    bar.set_style(ProgressStyle::with_template(style).expect("the template is well formed"));
    bar.set_message(name.to_owned());
    bar
}

/// Cases within which the canary must fail.
const CANARY_MAX: u64 = 500;

/// The case that kills the canary.
pub(crate) fn canary(seed: u64) -> Result<u64, Failure> {
    let targets = delone_laws::fuzz::targets();
    let canary = targets.iter().find(|target| target.is_canary()).expect("there is a canary");
    (0..CANARY_MAX).find(|&k| (&mut &*canary).try_on(&canary.case(seed, k)).is_err()).ok_or_else(
        || {
            Failure::Difference(Some(format!(
                "the canary lives after {CANARY_MAX} cases: this fuzzer is blind, and nothing was run"
            )))
        },
    )
}
