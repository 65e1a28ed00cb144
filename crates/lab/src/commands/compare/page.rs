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
    if comparison.is_proved() && comparison.agrees() {
        report.notice(Tone::Ok, "Every result is proved, and on each input all algorithms agree.");
    }
    for entry in comparison.entries.iter().filter(|entry| !entry.agrees()) {
        report.notice(Tone::Fault, &format!("{}: the algorithms disagree.", entry.subject.name()));
    }
    for entry in comparison.entries.iter().filter(|entry| !entry.is_proved()) {
        report.notice(Tone::Fault, &format!("{}: a result is not proved.", entry.subject.name()));
    }
}

fn anchor(number: usize, entry: &Entry) -> Anchor {
    Anchor::new(&format!("input-{number}-{}", entry.subject.name()))
}

fn results_table(comparison: &Comparison) -> Table {
    let mut table = Table::new([
        "input",
        "sites",
        "segments",
        "algorithm",
        "verdict",
        "cells",
        "build ms",
        "us / site",
        "judge ms",
        "orientations",
        "in-spheres",
        "ties",
    ]);
    for (number, entry) in comparison.entries.iter().enumerate() {
        if entry.rows.len() > 1 {
            table.group();
        }
        for row in &entry.rows {
            let sites = entry.subject.site_count();
            table.row([
                Cell::link(entry.subject.name(), &anchor(number, entry)),
                Cell::count(sites as u64),
                Cell::count(entry.subject.document.segments.len() as u64),
                Cell::text(row.algorithm),
                verdict_cell(row),
                Cell::count(row.sizes.cells as u64),
                Cell::real(row.seconds * 1e3, 3),
                Cell::real(row.seconds * 1e6 / sites.max(1) as f64, 3),
                Cell::real(row.check_seconds * 1e3, 3),
                Cell::count(row.counts.orients),
                Cell::count(row.counts.in_spheres),
                Cell::count(row.verdict.ties as u64),
            ]);
        }
    }
    table
}

fn verdict_cell(row: &Row) -> Cell {
    if row.verdict.ok {
        Cell::text(row.verdict.level.name()).ok().hover(&row.verdict.proved.join("; "))
    } else {
        let faults: Vec<String> = row.verdict.faults.iter().map(ToString::to_string).collect();
        Cell::text("not proved").fault().hover(&faults.join("\n"))
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
    let style = Style { size: 720.0, title: describe(&entry.subject), ..Style::default() };
    if entry.rows.iter().any(|row| row.sizes.cells > PICTURE_CELLS_MAX) {
        report.paragraph(&format!(
            "No picture: over {} cells. `delone draw` draws it.",
            grouped(PICTURE_CELLS_MAX as u64)
        ));
    } else if entry.drawing.is_space() {
        report.svg(&entry.drawing.svg(&style), name);
    } else {
        report.scene(&entry.drawing.scene(), &style, name);
    }
    for row in &entry.rows {
        report.details(&format!("{}: counts, proof", row.algorithm), |report| details(report, row));
    }
}

fn details(report: &mut Report, row: &Row) {
    let mut table = Table::new(["count", "number"]);
    for (name, count) in row.counts.named().into_iter().filter(|&(_, count)| count > 0) {
        table.row([Cell::text(&name.replace('_', " ")), Cell::count(count)]);
    }
    report.table(&table);
    report.code(&format!("fingerprint {}\n{}", row.fingerprint, row.verdict));
}
