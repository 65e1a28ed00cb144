//! Shards as processes of this program.

use std::process::{Child, Command, Stdio};

use crate::cli;
use crate::failure::Failure;
use crate::watch;

/// Runs `count` processes, a shard of the arguments' campaign each, and waits for all.
pub(crate) fn run(arguments: &cli::Fuzz, targets: &[&str], count: u64) -> Result<(), Failure> {
    let program = std::env::current_exe().map_err(Failure::input)?;
    let mut children: Vec<(u64, Child)> = Vec::new();
    for part in 0..count {
        let mut command = Command::new(&program);
        command
            .arg("fuzz")
            .args(targets)
            .arg("--quiet")
            .arg("--shard")
            .arg(format!("{part}/{count}"));
        command.arg("--seed").arg(arguments.seed.to_string());
        let state = arguments.state.as_deref().expect("the command line demands it");
        command.arg("--state").arg(state).arg("--output").arg(&arguments.output);
        command.args(arguments.cases.map(|cases| format!("--cases={cases}")));
        command.args(arguments.seconds.map(|seconds| format!("--seconds={seconds}")));
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
    if broken.is_empty() {
        return Ok(());
    }
    let told = broken.join(", ");
    if watch::is_interrupted() { Err(Failure::Limit(told)) } else { Err(Failure::Input(told)) }
}

fn pass_on(command: &mut Command, program: &cli::Program) {
    if let Some(text) = &program.program {
        command.arg("--program").arg(text).arg(format!("--timeout={}", program.timeout));
        command.arg(format!("--out-ending={}", program.out_ending));
        command.args(program.in_ending.as_ref().map(|ending| format!("--in-ending={ending}")));
        command.args(program.accept_refusal.then_some("--accept-refusal"));
    }
}
