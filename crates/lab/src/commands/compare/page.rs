//! The comparison as one self-contained page: a table of all results, then a picture of each input.

use delone_draw::{Anchor, Cell, Report, Style, Table, Tone};

use super::{Comparison, Entry, Row};
use crate::result::{describe, grouped};

/// Pictures of more cells than this are left out: the page is to be opened by a browser.
const PICTURE_CELLS_MAX: usize = 60_000;

pub(super) fn page(comparison: &Comparison) -> String {
    let mut report = Report::new("delone compare");
    let results = comparison.entries.iter().map(|entry| entry.rows.len()).sum::<usize>();
    report.lead(&format!(
        "{} inputs, {} results. Each was judged in exact arithmetic by code that shares nothing with the algorithms.",
        grouped(comparison.entries.len() as u64),
        grouped(results as u64),
    ));
    verdict(&mut report, comparison);
    report.heading("Results", &Anchor::new("results"));
    report.paragraph(
        "Build is the median of five runs (of one, if it takes over 0.2 s), without counting; judge is the time of the \
         proof. A click on a column's head sorts by it; a click on an input goes to its picture.",
    );
    report.table(&results_table(comparison));
    refused(&mut report, comparison);
    for (number, entry) in comparison.entries.iter().enumerate() {
        section(&mut report, entry, number);
    }
    report.finish()
}

fn verdict(report: &mut Report, comparison: &Comparison) {
    let stopped = comparison.rows().filter(|row| row.is_stopped()).count();
    if !comparison.is_refuted() && comparison.agrees() {
        let every = if stopped == 0 { "Every result" } else { "Every result that is complete" };
        report.notice(Tone::Ok, &format!("{every} is proved: {}.", comparison.summary()));
    }
    if stopped > 0 {
        let stopped = grouped(stopped as u64);
        report.notice(Tone::Warn, &format!("Results of methods stopped by a limit: {stopped}."));
    }
    for entry in &comparison.entries {
        for difference in entry.differences() {
            report.notice(Tone::Fault, &format!("{}: {difference}.", entry.subject.name()));
        }
    }
    for entry in comparison.entries.iter().filter(|entry| entry.is_refuted()) {
        report.notice(Tone::Fault, &format!("{}: a result is not proved.", entry.subject.name()));
    }
}

fn anchor(number: usize, entry: &Entry) -> Anchor {
    Anchor::new(&format!("input-{number}-{}", entry.subject.name()))
}

/// Its column of Steiner points is there if a method with these was run.
const STEINER: &str = "steiner";

fn results_table(comparison: &Comparison) -> Table {
    let adds = comparison.adds();
    let heads = [
        "input",
        "sites",
        "segments",
        "algorithm",
        "verdict",
        STEINER,
        "cells",
        "build ms",
        "us / site",
        "judge ms",
        "orientations",
        "in-spheres",
        "ties",
    ];
    let mut table = Table::new(heads.into_iter().filter(|&head| adds || head != STEINER));
    for (number, entry) in comparison.entries.iter().enumerate() {
        if entry.rows.len() > 1 {
            table.group();
        }
        for row in &entry.rows {
            let sites = entry.subject.site_count();
            let (added, ties) = (row.added.as_ref(), row.verdict.as_ref().map(|v| v.ties));
            let count = |count: Option<usize>| {
                count.map_or(Cell::text(""), |count| Cell::count(count as u64))
            };
            let mut cells = vec![
                Cell::link(entry.subject.name(), &anchor(number, entry)),
                Cell::count(sites as u64),
                Cell::count(entry.subject.document.segments.len() as u64),
                Cell::text(row.algorithm),
                verdict_cell(row),
            ];
            cells.extend(adds.then(|| count(added.map(|added| added.points))));
            cells.extend([
                Cell::count(row.sizes.cells as u64),
                Cell::real(row.seconds * 1e3, 3),
                Cell::real(row.seconds * 1e6 / sites.max(1) as f64, 3),
                Cell::real(row.check_seconds * 1e3, 3),
                Cell::count(row.counts.orients),
                Cell::count(row.counts.in_spheres),
                count(ties),
            ]);
            table.row(cells);
        }
    }
    table
}

fn verdict_cell(row: &Row) -> Cell {
    let word = Cell::text(&row.word());
    let word = if row.is_stopped() { word.tone(Tone::Warn) } else { word.ok() };
    match &row.verdict {
        None => word,
        Some(verdict) if verdict.ok => word.hover(&verdict.proved.join("; ")),
        Some(verdict) => {
            let faults: Vec<String> = verdict.faults.iter().map(ToString::to_string).collect();
            word.fault().hover(&faults.join("\n"))
        }
    }
}

fn refused(report: &mut Report, comparison: &Comparison) {
    if comparison.refused.is_empty() {
        return;
    }
    report.heading("Refused inputs", &Anchor::new("refused"));
    report.paragraph("These were not run. Each is listed with every violation.");
    for refused in &comparison.refused {
        report.details(&refused.name, |report| report.code(&refused.reason));
    }
}

fn section(report: &mut Report, entry: &Entry, number: usize) {
    let name = entry.subject.name();
    report.heading(name, &anchor(number, entry));
    report.paragraph(&describe(&entry.subject));
    if entry.rows.iter().any(|row| row.sizes.cells > PICTURE_CELLS_MAX) {
        report.paragraph(&format!(
            "No picture: over {} cells. `delone draw` draws it.",
            grouped(PICTURE_CELLS_MAX as u64)
        ));
    } else {
        pictures(report, entry);
    }
    for row in &entry.rows {
        report.details(&format!("{}: counts, proof", row.algorithm), |report| details(report, row));
    }
}

/// What all agree on with layers to switch; what each method makes, Steiner points in red, side by side.
fn pictures(report: &mut Report, entry: &Entry) {
    let (name, title) = (entry.subject.name(), describe(&entry.subject));
    let style = |size: f64, title: String| Style { size, title, ..Style::default() };
    match &entry.drawing {
        Some(drawing) if drawing.is_space() => {
            report.svg(&drawing.svg(&style(720.0, title)), name);
        }
        Some(drawing) => report.scene(&drawing.scene(), &style(720.0, title), name),
        None => {}
    }
    if !entry.own.is_empty() {
        report.columns(|report| {
            for (caption, drawing) in &entry.own {
                report.picture(&drawing.plane(), &style(480.0, caption.clone()), caption);
            }
        });
    }
}

fn details(report: &mut Report, row: &Row) {
    let mut table = Table::new(["count", "number"]);
    for (name, count) in row.counts.named().into_iter().filter(|&(_, count)| count > 0) {
        table.row([Cell::text(&name.replace('_', " ")), Cell::count(count)]);
    }
    report.table(&table);
    let verdict = row.verdict.as_ref().map_or(row.word(), ToString::to_string);
    report.code(&format!("fingerprint {}\n{verdict}", row.fingerprint));
}
