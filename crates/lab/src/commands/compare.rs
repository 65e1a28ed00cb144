//! `delone compare`, the main job: every applicable algorithm on each input, judged, counted, timed.

mod page;
mod scaling;
mod suite;
mod table;
mod tables;

use std::path::{Path, PathBuf};
use std::time::Instant;

use delone_check::Verdict;
use delone_delaunay::Options;
use delone_formats::Document;
use delone_probe::Counts;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde_json::{Value, json};

use crate::cli;
use crate::engine::{self, Sizes, Triangulation};
use crate::failure::Failure;
use crate::pictures::Drawing;
use crate::progress::Progress;
use crate::result::{check_value, counts, input};
use crate::subject::Subject;
use crate::{input as files, output};

/// One algorithm on one input.
struct Row {
    algorithm: &'static str,
    fingerprint: String,
    /// The median of the runs.
    seconds: f64,
    runs: usize,
    check_seconds: f64,
    counts: Counts,
    sizes: Sizes,
    verdict: Verdict,
}

/// All algorithms on one input.
struct Entry {
    subject: Subject,
    rows: Vec<Row>,
    drawing: Drawing,
}

/// An input that was not run, and why.
struct Refused {
    name: String,
    reason: String,
}

/// Everything that was compared.
struct Comparison {
    entries: Vec<Entry>,
    refused: Vec<Refused>,
}

impl Entry {
    fn agrees(&self) -> bool {
        self.rows.windows(2).all(|pair| pair[0].fingerprint == pair[1].fingerprint)
    }

    fn is_proved(&self) -> bool {
        self.rows.iter().all(|row| row.verdict.ok)
    }
}

impl Comparison {
    fn agrees(&self) -> bool {
        self.entries.iter().all(Entry::agrees)
    }

    fn is_proved(&self) -> bool {
        self.entries.iter().all(Entry::is_proved)
    }
}

pub(crate) fn compare(arguments: &cli::Compare) -> Result<(), Failure> {
    let files = arguments.html.iter().chain(&arguments.csv).chain(&arguments.latex);
    output::check_paths(files.map(PathBuf::as_path))?;
    let known = engine::all_names();
    if let Some(stranger) = arguments.only.iter().find(|name| !known.contains(&name.as_str())) {
        let known = known.join(", ");
        return Err(Failure::Input(format!(
            "no algorithm is called {stranger}: there are {known}"
        )));
    }
    if !arguments.scaling.is_empty() {
        return scaling::scaling(arguments);
    }
    let (subjects, refused) = subjects(arguments)?;
    if !refused.is_empty() && !arguments.keep_going {
        let reasons: Vec<&str> = refused.iter().map(|refused| refused.reason.as_str()).collect();
        return Err(Failure::Input(format!(
            "{}\n{} of the inputs refused, nothing done: --keep-going reports them and goes on",
            reasons.join("\n"),
            refused.len()
        )));
    }
    let bar = bar(subjects.len(), arguments.voice.quiet);
    let mut comparison = Comparison { entries: Vec::new(), refused };
    for subject in subjects {
        bar.set_message(subject.name().to_owned());
        comparison.entries.push(entry(subject, &arguments.only));
        bar.inc(1);
    }
    bar.finish_and_clear();
    if let Some(path) = &arguments.html {
        output::text(path, &page::page(&comparison))?;
    }
    if let Some(path) = &arguments.csv {
        output::text(path, &tables::csv(&comparison))?;
    }
    if let Some(path) = &arguments.latex {
        output::text(path, &tables::latex(&comparison))?;
    }
    if arguments.voice.json {
        println!("{}", json(&comparison));
    } else {
        table::print(&comparison);
        if let Some(path) = &arguments.html {
            println!("report: {} ({})", path.display(), output::size(path));
        }
    }
    if comparison.agrees() && comparison.is_proved() {
        Ok(())
    } else {
        Err(Failure::Difference(None))
    }
}

/// The inputs, validated; and those that are refused.
fn subjects(arguments: &cli::Compare) -> Result<(Vec<Subject>, Vec<Refused>), Failure> {
    if arguments.inputs.is_empty() {
        return Ok((suite::suite(arguments.n, arguments.seed)?, Vec::new()));
    }
    let (mut subjects, mut refused) = (Vec::new(), Vec::new());
    for path in files::files(&arguments.inputs)? {
        match files::read_all(&path, None) {
            Err(failure) => refused.push(refusal(&path.to_string_lossy(), &failure)),
            Ok(documents) => {
                for document in documents {
                    admit(&path, document, arguments.crossings, &mut subjects, &mut refused);
                }
            }
        }
    }
    Ok((subjects, refused))
}

fn admit(
    path: &Path,
    document: Document,
    crossings: cli::Crossings,
    subjects: &mut Vec<Subject>,
    refused: &mut Vec<Refused>,
) {
    let name =
        if document.name.is_empty() { path.display().to_string() } else { document.name.clone() };
    let repair = match crossings {
        cli::Crossings::Reject => None,
        cli::Crossings::Split => Some(Subject::crossed as fn(Document) -> _),
        cli::Crossings::Snap => Some(Subject::snapped as fn(Document) -> _),
    };
    let repair = repair.filter(|_| document.dimension == 2 && !document.segments.is_empty());
    let copy = repair.map(|repair| (repair, document.clone()));
    let admitted = Subject::new(document);
    match admitted.or_else(|failure| copy.map_or(Err(failure), |(repair, copy)| repair(copy))) {
        Ok(subject) => subjects.push(subject),
        Err(failure) => refused.push(refusal(&name, &failure)),
    }
}

fn refusal(name: &str, failure: &Failure) -> Refused {
    Refused { name: name.to_owned(), reason: failure.to_string() }
}

fn bar(count: usize, quiet: bool) -> ProgressBar {
    let target =
        if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr_with_hz(5) };
    let style = ProgressStyle::with_template("{pos}/{len} {wide_msg} {eta}");
    ProgressBar::with_draw_target(Some(count as u64), target)
        .with_style(style.expect("the template is well formed"))
}

fn entry(subject: Subject, only: &[String]) -> Entry {
    let names = engine::names(&subject);
    let chosen: Vec<&'static str> = names
        .iter()
        .filter(|name| only.is_empty() || only.iter().any(|asked| asked == *name))
        .copied()
        .collect();
    let mut drawing = None;
    let mut rows = Vec::new();
    for name in chosen {
        let (row, triangulation) = row(&subject, name);
        rows.push(row);
        drawing.get_or_insert_with(|| Drawing::of(&subject, Some(&triangulation)));
    }
    let drawing = drawing.unwrap_or_else(|| Drawing::of(&subject, None));
    Entry { subject, rows, drawing }
}

/// Runs longer than this are not repeated.
const REPEAT_BELOW_SECONDS: f64 = 0.2;
const RUNS: usize = 5;

fn row(subject: &Subject, name: &'static str) -> (Row, Triangulation) {
    let options = Options::default();
    let built = engine::run(subject, name, &options, None);
    let mut seconds = vec![built.seconds];
    while seconds.len() < RUNS && seconds[0] < REPEAT_BELOW_SECONDS {
        seconds.push(engine::run(subject, name, &options, None).seconds);
    }
    seconds.sort_by(f64::total_cmp);
    let mut progress = Progress::new(name, true);
    engine::run(subject, name, &options, Some(&mut progress));
    let clock = Instant::now();
    let verdict = built.triangulation.verdict(subject);
    let row = Row {
        algorithm: name,
        fingerprint: built.triangulation.fingerprint(subject).to_string(),
        seconds: seconds[seconds.len() / 2],
        runs: seconds.len(),
        check_seconds: clock.elapsed().as_secs_f64(),
        counts: progress.counts,
        sizes: built.triangulation.sizes(subject),
        verdict,
    };
    (row, built.triangulation)
}

fn json(comparison: &Comparison) -> Value {
    let mut results = Vec::new();
    for entry in &comparison.entries {
        for row in &entry.rows {
            results.push(json!({
                "input": input(&entry.subject),
                "algorithm": row.algorithm,
                "fingerprint": row.fingerprint,
                "vertices": row.sizes.vertices,
                "cells": row.sizes.cells,
                "hull_facets": row.sizes.hull_facets,
                "seconds": { "build": row.seconds, "runs": row.runs, "check": row.check_seconds },
                "counts": counts(&row.counts),
                "check": check_value(&row.verdict),
            }));
        }
    }
    let refused: Vec<Value> = comparison
        .refused
        .iter()
        .map(|refused| json!({ "input": refused.name, "reason": refused.reason }))
        .collect();
    json!({
        "schema": "delone.compare/1",
        "results": results,
        "refused": refused,
        "agree": comparison.agrees(),
        "proved": comparison.is_proved(),
    })
}
