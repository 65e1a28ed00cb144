//! Shards as processes of this program.

use std::process::{Child, Command, Stdio};

use delone_laws::fuzz::{Shard, Target};

use super::{label, state};
use crate::cli;
use crate::failure::Failure;
use crate::progress::spinner;
use crate::watch;

/// Runs `count` processes, a shard of the arguments' campaign each, and waits for all. If time was the limit, some shards have
/// come further than others: these are then brought level, so that together they are what one process would have run.
pub(crate) fn run(arguments: &cli::Fuzz, targets: &[Target], count: u64) -> Result<(), Failure> {
    let names: Vec<&str> = targets.iter().map(|target| target.name).collect();
    let state = arguments.state.as_deref().expect("the command line demands it");
    let cases = arguments.cases.map(|cases| format!("--cases={cases}"));
    let seconds = arguments.seconds.map(|seconds| format!("--seconds={seconds}"));
    at_once(arguments, &names, count, &[cases, seconds].into_iter().flatten().collect::<Vec<_>>())?;
    for target in targets.iter().filter(|_| arguments.seconds.is_some()) {
        let label = label(target, arguments);
        let shard = |part| Shard::of(part, count).expect("part < count");
        let executions = |part| {
            let path = state::path(state, &label, arguments.seed, shard(part));
            Ok(state::load(&path)?.tally.executions)
        };
        let all = (0..count).map(executions).collect::<Result<Vec<u64>, Failure>>()?;
        let most = all.iter().copied().max().unwrap_or(0);
        if all.iter().any(|&executions| executions < most) {
            let level = format!("--cases={}", most.saturating_mul(count));
            at_once(arguments, &[target.name], count, &[level])?;
        }
    }
    Ok(())
}

/// Runs all shards with a budget.
fn at_once(
    arguments: &cli::Fuzz,
    targets: &[&str],
    count: u64,
    budget: &[String],
) -> Result<(), Failure> {
    let program = std::env::current_exe().map_err(Failure::input)?;
    let bar = spinner(arguments.voice.quiet);
    bar.set_message(format!("{count} shards of {}", targets.join(", ")));
    let mut children: Vec<(u64, Child)> = Vec::new();
    for part in 0..count {
        let mut command = Command::new(&program);
        command.arg("fuzz").args(targets).arg("--quiet").args(budget);
        command.arg("--shard").arg(format!("{part}/{count}"));
        command.arg("--seed").arg(arguments.seed.to_string());
        let state = arguments.state.as_deref().expect("the command line demands it");
        command.arg("--state").arg(state).arg("--output").arg(&arguments.output);
        if let Some(folder) = &arguments.corpus {
            command.arg("--corpus").arg(folder);
        }
        pass_on(&mut command, &arguments.program);
        command.stdin(Stdio::null()).stdout(Stdio::null());
        children.push((part, command.spawn().map_err(Failure::input)?));
    }
    let mut broken = Vec::new();
    for (part, child) in &mut children {
        // An interruption reaches the children, too; they save what they have and end.
        match child.wait().map_err(Failure::input)?.code() {
            Some(0 | 1) => {}
            status => broken.push(format!("shard {part} ended with {status:?}")),
        }
    }
    bar.finish_and_clear();
    if broken.is_empty() && !watch::is_interrupted() {
        return Ok(());
    }
    let told = broken.join(", ");
    if watch::is_interrupted() {
        let why = "interrupted; each shard has saved what it has, and the same command goes on";
        return Err(Failure::Limit(format!("{why} {told}").trim_end().to_owned()));
    }
    Err(Failure::Input(told))
}

fn pass_on(command: &mut Command, program: &cli::Program) {
    if let Some(text) = &program.program {
        command.arg("--program").arg(text).arg(format!("--timeout={}", program.timeout));
        command.arg(format!("--out-ending={}", program.out_ending));
        command.args(program.in_ending.as_ref().map(|ending| format!("--in-ending={ending}")));
        command.args(program.accept_refusal.then_some("--accept-refusal"));
    }
}
