//! The comparison as a table on the terminal.

use super::Comparison;
use crate::result::{grouped, seconds};

pub(super) fn print(comparison: &Comparison) {
    let width = comparison.entries.iter().map(|entry| entry.subject.name().chars().count()).max();
    let width = width.unwrap_or(0).clamp(16, 48);
    // A column more, if any of them adds points.
    let adds = comparison.adds();
    let steiner = |text: String| if adds { format!(" {text:>9}") } else { String::new() };
    println!(
        "{:width$} {:>9} {:>9}  {:14}{} {:>9} {:>10} {:>10}  verdict",
        "input",
        "sites",
        "segments",
        "algorithm",
        steiner("steiner".to_owned()),
        "cells",
        "build",
        "judge"
    );
    for entry in &comparison.entries {
        let name = shortened(entry.subject.name(), width);
        for row in &entry.rows {
            let word = row.word();
            let added = row.added.as_ref().map_or("-".to_owned(), |a| grouped(a.points as u64));
            println!(
                "{name:width$} {:>9} {:>9}  {:14}{} {:>9} {:>10} {:>10}  {}",
                grouped(entry.subject.site_count() as u64),
                grouped(entry.subject.document.segments.len() as u64),
                row.algorithm,
                steiner(added),
                grouped(row.sizes.cells as u64),
                seconds(row.seconds),
                seconds(row.check_seconds),
                if row.is_refuted() { word.to_uppercase() } else { word },
            );
            let faults = row.verdict.iter().flat_map(|verdict| &verdict.faults);
            faults.for_each(|fault| println!("    fault: {fault}"));
        }
        if entry.rows.is_empty() {
            println!("{name:width$} none of the algorithms asked for takes this input");
        }
        entry.differences().iter().for_each(|difference| println!("    {difference}"));
    }
    refused(comparison);
    let all = comparison.rows().count();
    let proved = comparison.rows().filter(|row| row.verdict.as_ref().is_some_and(|v| v.ok));
    let stopped = match comparison.rows().filter(|row| row.is_stopped()).count() {
        0 => String::new(),
        count => format!("{count} stopped by a limit, "),
    };
    println!(
        "{} inputs, {all} results, {} proved, {stopped}{} refused, {}",
        comparison.entries.len(),
        proved.count(),
        comparison.refused.len(),
        comparison.summary()
    );
}

/// Two lines of each reason.
fn refused(comparison: &Comparison) {
    for refused in &comparison.refused {
        let lines: Vec<&str> = refused.reason.lines().collect();
        let more = if lines.len() > 2 {
            format!(" (and {} lines more)", lines.len() - 2)
        } else {
            String::new()
        };
        println!("refused: {}{more}", lines[..lines.len().min(2)].join(" "));
    }
}

/// A name cut in the middle.
fn shortened(name: &str, width: usize) -> String {
    let count = name.chars().count();
    if count <= width {
        return name.to_owned();
    }
    let tail: String = name.chars().skip(count - (width - 2)).collect();
    format!("..{tail}")
}
