//! One turn of an engine: a process that is given a file, and what it prints and writes.
//!
//! On standard output it prints, in any order, `seconds S` for each time it built the triangulation, by its own clock and without
//! reading and writing; and if it likes `count NAME N`, `version TEXT`, `fingerprint HEX`. What else it prints is not read.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{Read, Seek};
use std::path::Path;
use std::process::{Command, ExitStatus, Stdio};
use std::time::Duration;

use delone_check::Options;
use delone_formats::Document;
use delone_laws::foreign::judged;
use delone_laws::fuzz::Input;
use wait_timeout::ChildExt;

use super::definition::{Engine, Task};
use crate::commands::check;
use crate::commands::fuzz::files;
use crate::failure::Failure;

/// What an engine said.
#[derive(Debug, Default)]
pub(super) struct Turn {
    pub(super) seconds: Vec<f64>,
    pub(super) counts: BTreeMap<String, u64>,
    pub(super) version: String,
    pub(super) fingerprint: String,
    /// Everything on standard output.
    pub(super) text: String,
}

/// Why an engine posts no time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Fault {
    /// It could not be started.
    Absent(String),
    /// It ended badly, or wrote nothing to be read.
    Refused(String),
    /// The judge, or the pinned answer, says that it is wrong.
    Wrong(String),
    /// It took longer than a turn may.
    Slow(String),
}

impl Fault {
    pub(super) fn word(&self) -> &'static str {
        match self {
            Self::Absent(_) => "absent",
            Self::Refused(_) => "refused",
            Self::Wrong(_) => "WRONG",
            Self::Slow(_) => "slow",
        }
    }

    pub(super) fn why(&self) -> &str {
        match self {
            Self::Absent(why) | Self::Refused(why) | Self::Wrong(why) | Self::Slow(why) => why,
        }
    }
}

/// Files of an input.
pub(super) struct Files<'f> {
    pub(super) given: &'f Path,
    pub(super) written: &'f Path,
}

/// Where things are.
pub(super) fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).unwrap_or(Path::new("."))
}

/// Runs an engine once.
pub(super) fn run(
    engine: &Engine,
    task: Task,
    files: &Files<'_>,
    times: u32,
    limit: Duration,
) -> Result<Turn, Fault> {
    let this = std::env::current_exe().map_err(|error| Fault::Absent(error.to_string()))?;
    let absent = || Fault::Absent(engine.build.clone());
    let words = shlex::split(&engine.command).filter(|words| !words.is_empty());
    let filled = |word: String| {
        word.replace("{self}", &this.to_string_lossy())
            .replace("{root}", &root().to_string_lossy())
            .replace("{task}", task.name())
            .replace("{in}", &files.given.to_string_lossy())
            .replace("{out}", &files.written.to_string_lossy())
            .replace("{times}", &times.to_string())
    };
    let words: Vec<String> = words.ok_or_else(absent)?.into_iter().map(filled).collect();
    let _ = std::fs::remove_file(files.written); // what an earlier one left is not this one's
    let mut command = Command::new(&words[0]);
    command.args(&words[1..]).stdin(Stdio::null());
    let (status, text, said) = ended(command, limit, absent)?;
    if !status.success() {
        let last = said.lines().rfind(|line| !line.trim().is_empty()).unwrap_or("").to_owned();
        return Err(Fault::Refused(format!("{status}: {last}")));
    }
    Ok(understood(text))
}

/// How a command ended, and what it printed; through files, so that no pipe is ever full.
fn ended(
    mut command: Command,
    limit: Duration,
    absent: impl Fn() -> Fault,
) -> Result<(ExitStatus, String, String), Fault> {
    let refused = |error: std::io::Error| Fault::Refused(error.to_string());
    let [mut out, mut error] =
        [tempfile::tempfile().map_err(refused)?, tempfile::tempfile().map_err(refused)?];
    command.stdout(out.try_clone().map_err(refused)?);
    command.stderr(error.try_clone().map_err(refused)?);
    let mut child = command.spawn().map_err(|_| absent())?;
    let Some(status) = child.wait_timeout(limit).map_err(refused)? else {
        // It may have ended in between, which is as well.
        let _ = child.kill();
        let _ = child.wait();
        return Err(Fault::Slow(format!("more than {} s", limit.as_secs_f64())));
    };
    if status.code().is_none() {
        // What ended it may be an interruption that this program is told of as well, in a moment.
        std::thread::sleep(Duration::from_millis(100));
    }
    let read = |file: &mut File| -> Result<String, Fault> {
        let mut bytes = Vec::new();
        file.rewind().and_then(|()| file.read_to_end(&mut bytes)).map_err(refused)?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    };
    Ok((status, read(&mut out)?, read(&mut error)?))
}

fn understood(text: String) -> Turn {
    let mut turn = Turn::default();
    for line in text.lines() {
        match line.split_whitespace().collect::<Vec<_>>()[..] {
            ["seconds", seconds] => turn.seconds.extend(seconds.parse::<f64>()),
            ["count", name, count] => {
                let _ = count.parse().map(|count| turn.counts.insert(name.to_owned(), count));
            }
            ["fingerprint", print] => print.clone_into(&mut turn.fingerprint),
            ["version", ..] => line[8..].clone_into(&mut turn.version),
            _ => {}
        }
    }
    Turn { text, ..turn }
}

/// Judges what an engine wrote. The answer of ours must be the pinned one, too.
pub(super) fn verdict(
    engine: &Engine,
    turn: &Turn,
    given: &Document,
    written: &Path,
    answer: &str,
) -> Result<(), Fault> {
    if engine.ours && !answer.is_empty() && turn.fingerprint != answer {
        let told = format!("fingerprint {}, and the answer is {answer}", turn.fingerprint);
        return Err(Fault::Wrong(told));
    }
    let unread = |failure: Failure| Fault::Refused(failure.to_string());
    let output = check::read_output(written, given).map_err(unread)?;
    let wrong = |text: String| Fault::Wrong(text);
    let outcome = match files::input(given).map_err(unread)? {
        Input::Plane(case) => {
            let points = output.points_2d().map_err(|error| wrong(error.to_string()))?;
            let names = check::names(&case.points, points, &output);
            let names = names.map_err(|failure| wrong(failure.to_string()))?;
            judged(&case, &named(output.triangles.as_flattened(), &names), &Options::foreign())
        }
        Input::Space(case) => {
            let points = output.points_3d().map_err(|error| wrong(error.to_string()))?;
            let names = check::names(&case.points, points, &output);
            let names = names.map_err(|failure| wrong(failure.to_string()))?;
            judged(&case, &named(output.tets.as_flattened(), &names), &Options::foreign())
        }
        Input::File(_) => unreachable!("a document has points"),
    };
    outcome.map_err(|broken| wrong(format!("{}: {}", broken.place, broken.message)))
}

fn named(ids: &[u32], names: &[u32]) -> Vec<u32> {
    ids.iter().map(|&id| names[id as usize]).collect()
}
