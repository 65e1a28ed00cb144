//! The comparison as a table on the terminal.

use super::Comparison;
use crate::result::{grouped, seconds};

pub(super) fn print(comparison: &Comparison) {
    let width = comparison.entries.iter().map(|entry| entry.subject.name().chars().count()).max();
    let width = width.unwrap_or(0).clamp(16, 48);
    println!(
        "{:width$} {:>9} {:>9}  {:14} {:>9} {:>10} {:>10}  verdict",
        "input", "sites", "segments", "algorithm", "cells", "build", "judge"
    );
    for entry in &comparison.entries {
        for row in &entry.rows {
            println!(
                "{:width$} {:>9} {:>9}  {:14} {:>9} {:>10} {:>10}  {}",
                shortened(entry.subject.name(), width),
                grouped(entry.subject.site_count() as u64),
                grouped(entry.subject.document.segments.len() as u64),
                row.algorithm,
                grouped(row.sizes.cells as u64),
                seconds(row.seconds),
                seconds(row.check_seconds),
                if row.verdict.ok { row.verdict.level.name() } else { "NOT PROVED" },
            );
            row.verdict.faults.iter().for_each(|fault| println!("    fault: {fault}"));
        }
        if !entry.agrees() {
            println!("    the algorithms DISAGREE");
        }
    }
    for refused in &comparison.refused {
        let lines: Vec<&str> = refused.reason.lines().collect();
        let more = if lines.len() > 2 {
            format!(" (and {} lines more)", lines.len() - 2)
        } else {
            String::new()
        };
        println!("refused: {}{more}", lines[..lines.len().min(2)].join(" "));
    }
    let proved: usize = comparison
        .entries
        .iter()
        .flat_map(|entry| &entry.rows)
        .filter(|row| row.verdict.ok)
        .count();
    let all: usize = comparison.entries.iter().map(|entry| entry.rows.len()).sum();
    println!(
        "{} inputs, {all} results, {proved} proved, {} refused, {}",
        comparison.entries.len(),
        comparison.refused.len(),
        if comparison.agrees() { "all algorithms agree" } else { "the algorithms DISAGREE" }
    );
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
