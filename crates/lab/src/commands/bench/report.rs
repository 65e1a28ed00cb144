//! What was measured, for people: text, a page with plots, tables for a paper.

use std::fmt::Write as _;

use delone_draw::{Anchor, Cell, Plot, Report, Series, Table};

use super::definition::{Definition, Task};
use super::numbers::{median, quantile};
use super::record::Record;

/// An engine on an input.
struct Row<'r> {
    first: &'r Record,
    times: Vec<f64>,
}

/// The rows of a definition, in the order of the turns.
fn rows<'r>(definition: &Definition, records: &'r [Record]) -> Vec<Row<'r>> {
    let mut rows: Vec<Row<'r>> = Vec::new();
    for record in records.iter().filter(|record| record.definition == definition.name) {
        match rows.iter_mut().find(|row| row.first.is_of(record)) {
            Some(row) => row.times.extend(record.time),
            None => rows.push(Row { first: record, times: record.time.into_iter().collect() }),
        }
    }
    rows
}

/// The rows on one input.
fn inputs<'a, 'r>(rows: &'a [Row<'r>]) -> impl Iterator<Item = &'a [Row<'r>]> {
    rows.chunk_by(|a, b| (&a.first.input, a.first.sites) == (&b.first.input, b.first.sites))
}

/// Nanoseconds a site; of a table, a call.
#[expect(clippy::cast_precision_loss, reason = "a rate for people")]
fn unit(row: &Row<'_>, task: Task) -> f64 {
    match task {
        Task::Table => median(&row.times),
        _ => median(&row.times) * 1e9 / row.first.sites.max(1) as f64,
    }
}

/// How far the quartiles are from the median, in parts of it.
fn spread(row: &Row<'_>) -> f64 {
    (quantile(&row.times, 0.75) - quantile(&row.times, 0.25)) / median(&row.times)
}

/// The quickest of the rows that are timed.
fn quickest(rows: &[Row<'_>]) -> f64 {
    rows.iter().map(|row| median(&row.times)).fold(f64::INFINITY, f64::min)
}

const fn what(task: Task) -> &'static str {
    match task {
        Task::Table => "ns / call",
        _ => "ns / site",
    }
}

pub(super) fn text(definitions: &[Definition], records: &[Record]) -> String {
    let mut text = String::new();
    for definition in definitions {
        let _ = writeln!(text, "{}: {}", definition.name, definition.analysis.trim());
        let all = rows(definition, records);
        for rows in inputs(&all) {
            let first = rows[0].first;
            let sizes = if first.sites > 0 {
                format!(", {} sites, {} segments", first.sites, first.segments)
            } else {
                String::new()
            };
            let _ = writeln!(text, "  {}{sizes}", first.input);
            let best = quickest(rows);
            for row in rows {
                let name = &row.first.engine;
                if row.times.is_empty() {
                    let _ = writeln!(text, "    {name:22} {}", row.first.verdict);
                    continue;
                }
                let _ = writeln!(
                    text,
                    "    {name:22} {:>9.1} {}  x {:.2}  +-{:.0} %  {}",
                    unit(row, definition.task),
                    what(definition.task),
                    median(&row.times) / best,
                    spread(row) * 50.0,
                    row.first.counts
                );
            }
        }
    }
    text
}

pub(super) fn page(definitions: &[Definition], records: &[Record]) -> String {
    let mut report = Report::new("delone bench");
    report.lead("Every engine in a process of its own, turn by turn, judged once before its times count. Our biases: benches/BIAS.md.");
    for definition in definitions {
        report.heading(&definition.name, &Anchor::new(&definition.name));
        report.paragraph(definition.analysis.trim());
        let all = rows(definition, records);
        let mut table = Table::new([
            "input",
            "sites",
            "segments",
            "engine",
            what(definition.task),
            "over the best",
            "spread %",
            "verdict",
            "counts",
        ]);
        for rows in inputs(&all) {
            table.group();
            let best = quickest(rows);
            for row in rows {
                let r = row.first;
                let timed =
                    |x: f64| if row.times.is_empty() { Cell::text("") } else { Cell::real(x, 3) };
                let verdict = Cell::text(&r.verdict);
                table.row([
                    Cell::text(&r.input),
                    Cell::count(r.sites as u64),
                    Cell::count(r.segments as u64),
                    Cell::text(&r.engine),
                    timed(unit(row, definition.task)),
                    timed(median(&row.times) / best),
                    timed(spread(row) * 100.0),
                    if r.verdict == "ok" { verdict.ok() } else { verdict.fault() },
                    Cell::text(&r.counts),
                ]);
            }
        }
        report.table(&table);
        report.columns(|report| plots(report, &all));
    }
    report.finish()
}

/// Seconds over sites, a plot for each input of more than one size; the legend has the fitted exponents.
#[expect(clippy::cast_precision_loss, reason = "an axis")]
fn plots(report: &mut Report, rows: &[Row<'_>]) {
    let mut names: Vec<&str> = rows.iter().map(|row| row.first.input.as_str()).collect();
    names.dedup();
    for name in names {
        let mut series: Vec<Series> = Vec::new();
        for row in rows.iter().filter(|row| row.first.input == name && !row.times.is_empty()) {
            let point = [row.first.sites as f64, median(&row.times)];
            match series.iter_mut().find(|series| series.name == row.first.engine) {
                Some(series) => series.points.push(point),
                None => series.push(Series { name: row.first.engine.clone(), points: vec![point] }),
            }
        }
        if series.iter().any(|series| series.points.len() > 1) {
            let (across, up) = ("sites".to_owned(), "seconds".to_owned());
            report.svg(&Plot { title: name.to_owned(), across, up, series }.svg(), name);
        }
    }
}

/// Tables with the rules of booktabs: inputs down, engines across.
pub(super) fn latex(definitions: &[Definition], records: &[Record]) -> String {
    let escape = |text: &str| text.replace('&', "\\&").replace('_', "\\_").replace('%', "\\%");
    let mut out = String::new();
    for definition in definitions {
        let all = rows(definition, records);
        let mut engines: Vec<&str> = Vec::new();
        for row in &all {
            if !engines.contains(&row.first.engine.as_str()) {
                engines.push(&row.first.engine);
            }
        }
        let heads: Vec<String> = engines.iter().map(|name| escape(name)).collect();
        let _ = writeln!(
            out,
            "% {}, {}\n\\begin{{tabular}}{{lr{}}}\n\\toprule\ninput & sites & {} \\\\\n\\midrule",
            definition.name,
            what(definition.task),
            "r".repeat(engines.len()),
            heads.join(" & ")
        );
        for rows in inputs(&all) {
            let cell = |engine: &&str| match rows.iter().find(|row| row.first.engine == **engine) {
                Some(row) if !row.times.is_empty() => format!("{:.1}", unit(row, definition.task)),
                Some(row) if row.first.verdict.to_lowercase().starts_with("wrong") => {
                    "wrong".to_owned()
                }
                _ => "--".to_owned(),
            };
            let cells: Vec<String> = engines.iter().map(cell).collect();
            let first = rows[0].first;
            let _ = writeln!(
                out,
                "{} & {} & {} \\\\",
                escape(&first.input),
                first.sites,
                cells.join(" & ")
            );
        }
        out.push_str("\\bottomrule\n\\end{tabular}\n\n");
    }
    out
}
