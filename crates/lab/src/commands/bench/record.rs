//! Records: a row for each time that something was built, as CSV.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use super::turn::root;
use crate::failure::Failure;

/// A row.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Record {
    pub(super) definition: String,
    pub(super) input: String,
    pub(super) sites: usize,
    pub(super) segments: usize,
    pub(super) engine: String,
    pub(super) version: String,
    pub(super) round: u32,
    /// Seconds of a construction; of a table, nanoseconds of a call. None if it is not to be timed.
    pub(super) time: Option<f64>,
    /// `ok`, or why there is no time.
    pub(super) verdict: String,
    pub(super) fingerprint: String,
    /// `name=number` of what was counted, between blanks.
    pub(super) counts: String,
}

const HEAD: &str = "definition,input,sites,segments,engine,version,round,time,verdict,fingerprint,counts,commit,cpu";

/// All rows, with the commit and the processor.
pub(super) fn csv(records: &[Record]) -> String {
    let (commit, cpu) = (commit(), cpu());
    let mut text = format!("{HEAD}\n");
    for r in records {
        let time = r.time.map_or_else(String::new, |time| format!("{time:e}"));
        let texts = [&r.definition, &r.input, &r.engine, &r.version, &r.verdict];
        let [definition, input, engine, version, verdict] = texts.map(|text| cell(text));
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "{definition},{input},{},{},{engine},{version},{},{time},{verdict},{},{},{commit},{}",
            r.sites,
            r.segments,
            r.round,
            r.fingerprint,
            cell(&r.counts),
            cell(&cpu)
        );
    }
    text
}

/// A text that stays one cell.
fn cell(text: &str) -> String {
    let plain = text.replace(['\n', '\r'], " ");
    if plain.contains([',', '"']) { format!("\"{}\"", plain.replace('"', "\"\"")) } else { plain }
}

/// The cells of a line.
fn cells(line: &str) -> Vec<String> {
    let (mut cells, mut cell, mut quoted) = (Vec::new(), String::new(), false);
    let mut chars = line.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '"' if quoted && chars.peek() == Some(&'"') => {
                cell.push('"');
                chars.next();
            }
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(std::mem::take(&mut cell)),
            _ => cell.push(c),
        }
    }
    cells.push(cell);
    cells
}

/// Reads what [`csv`] wrote.
pub(super) fn read(path: &Path) -> Result<Vec<Record>, Failure> {
    let refuse = |why: String| Failure::input(format!("{}: {why}", path.display()));
    let text = std::fs::read_to_string(path).map_err(|error| refuse(error.to_string()))?;
    let mut lines = text.lines();
    if lines.next() != Some(HEAD) {
        return Err(refuse("this is no record of `delone bench`".to_owned()));
    }
    let row = |(number, line): (usize, &str)| {
        record(&cells(line))
            .ok_or_else(|| refuse(format!("line {}: no row of a record", number + 2)))
    };
    lines.enumerate().map(row).collect()
}

fn record(cells: &[String]) -> Option<Record> {
    let [
        definition,
        input,
        sites,
        segments,
        engine,
        version,
        round,
        time,
        verdict,
        print,
        counts,
        ..,
    ] = cells
    else {
        return None;
    };
    Some(Record {
        definition: definition.clone(),
        input: input.clone(),
        sites: sites.parse().ok()?,
        segments: segments.parse().ok()?,
        engine: engine.clone(),
        version: version.clone(),
        round: round.parse().ok()?,
        time: if time.is_empty() { None } else { Some(time.parse().ok()?) },
        verdict: verdict.clone(),
        fingerprint: print.clone(),
        counts: counts.clone(),
    })
}

/// The commit of the working tree, with a plus if it was changed since; empty if there is none.
fn commit() -> String {
    let git = |words: &[&str]| {
        let output = Command::new("git").arg("-C").arg(root()).args(words).output().ok()?;
        output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
    };
    let Some(head) = git(&["rev-parse", "--short=12", "HEAD"]) else { return String::new() };
    let changed = git(&["status", "--porcelain"]).is_some_and(|text| !text.is_empty());
    if changed { format!("{head}+") } else { head }
}

fn cpu() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = text.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    name.map_or_else(String::new, |(_, name)| name.trim().to_owned())
}

#[cfg(test)]
mod tests;
