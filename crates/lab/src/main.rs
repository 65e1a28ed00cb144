//! The program `delone`: a laboratory for robust triangulation on the command line.
//!
//! `cli` says what can be asked, `commands` holds one file for each command, the rest is shared by them: `input` reads,
//! `subject` validates, `judge` asks the judge, `result` is what a command says in JSON and in words, `failure` is how it
//! ends.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a program for the terminal")]

mod cli;
mod commands;
mod engine;
mod failure;
mod fill;
mod input;
mod judge;
mod output;
mod pictures;
mod pipe;
mod progress;
mod result;
mod sampling;
mod steiner;
mod subject;
mod watch;

use std::process::ExitCode;

use clap::Parser;

use crate::failure::Failure;

fn main() -> ExitCode {
    pipe::end_quietly_when_closed();
    watch::guard();
    let arguments = match cli::Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            let _ = error.print(); // nowhere is left to say that this failed
            return ExitCode::from(if error.use_stderr() { 2 } else { 0 });
        }
    };
    match commands::run(&arguments.command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            if !matches!(failure, Failure::Difference(None)) {
                eprintln!("{failure}");
            }
            ExitCode::from(failure.status())
        }
    }
}
