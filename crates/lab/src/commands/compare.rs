//! `delone compare`, the main job: every applicable algorithm on each input, judged, counted, timed.

mod page;
mod row;
mod scaling;
mod suite;
mod table;
mod tables;

use std::path::{Path, PathBuf};

use delone_conforming::methods;
use delone_formats::Document;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde_json::{Value, json};

use crate::cli;
use crate::engine;
use crate::failure::Failure;
use crate::pictures::Drawing;
use crate::result::{check_value, counts, grouped, input};
use crate::subject::{Body, Subject};
use crate::{input as files, output};

use row::{Bounds, Row};

/// All algorithms on one input.
struct Entry {
    subject: Subject,
    rows: Vec<Row>,
    /// What algorithms that add no points agree on, or the input itself if nothing was run.
    drawing: Option<Drawing>,
    /// What each method with Steiner points makes of it, and the picture's caption.
    own: Vec<(String, Drawing)>,
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
    /// Where results differ that should be the same, in words.
    fn differences(&self) -> Vec<String> {
        let mut prints =
            self.rows.iter().filter(|row| row.added.is_none()).map(|row| &row.fingerprint);
        let first = prints.next();
        let disagree = prints.any(|print| Some(print) != first);
        let disagree = disagree.then(|| "the algorithms DISAGREE".to_owned());
        let unsteady = self.rows.iter().filter(|row| row.depends_on_order());
        let unsteady =
            unsteady.map(|row| format!("{} DEPENDS on the order of the input", row.algorithm));
        disagree.into_iter().chain(unsteady).collect()
    }

    fn is_refuted(&self) -> bool {
        self.rows.iter().any(Row::is_refuted)
    }
}

impl Comparison {
    fn agrees(&self) -> bool {
        self.entries.iter().all(|entry| entry.differences().is_empty())
    }

    fn is_refuted(&self) -> bool {
        self.entries.iter().any(Entry::is_refuted)
    }

    fn rows(&self) -> impl Iterator<Item = &Row> + Clone {
        self.entries.iter().flat_map(|entry| &entry.rows)
    }

    /// Whether some of the results have Steiner points.
    fn adds(&self) -> bool {
        self.rows().any(|row| row.added.is_some())
    }

    /// What was found on all inputs, in a few words.
    fn summary(&self) -> String {
        if !self.agrees() {
            return "results DIFFER that should be the same".to_owned();
        }
        let mut words = Vec::new();
        if self.rows().any(|row| row.added.is_none()) {
            words.push("all algorithms agree");
        }
        if self.rows().filter_map(|row| row.added.as_ref()).any(|a| a.ignores_order.is_some()) {
            words.push("no method with Steiner points depends on the order of the input");
        }
        if words.is_empty() { "nothing to compare".to_owned() } else { words.join(", ") }
    }
}

pub(crate) fn compare(arguments: &cli::Compare) -> Result<(), Failure> {
    let files = arguments.html.iter().chain(&arguments.csv).chain(&arguments.latex);
    output::check_paths(files.map(PathBuf::as_path))?;
    let only = asked(&arguments.only)?;
    let bounds = Bounds::new(arguments.bounds)?;
    if !arguments.scaling.is_empty() {
        return scaling::scaling(arguments, &only);
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
        comparison.entries.push(entry(subject, &only, bounds));
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
    if comparison.agrees() && !comparison.is_refuted() {
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

/// The names asked for, `conforming` being those of all methods with Steiner points.
fn asked(only: &[String]) -> Result<Vec<&'static str>, Failure> {
    let methods = methods().into_iter().map(|method| method.name);
    let known: Vec<&'static str> = engine::all_names().into_iter().chain(methods.clone()).collect();
    let mut asked = Vec::new();
    for name in only {
        match known.iter().find(|known| *known == name) {
            Some(known) => asked.push(*known),
            None if name == "conforming" => asked.extend(methods.clone()),
            None => {
                return Err(Failure::Input(format!(
                    "no algorithm is called {name}: there are {}; and conforming, for those with Steiner points",
                    known.join(", ")
                )));
            }
        }
    }
    Ok(asked)
}

/// Every algorithm that adds no points, or those asked for; methods with Steiner points if they are.
fn entry(subject: Subject, only: &[&str], bounds: Bounds) -> Entry {
    let (mut rows, mut drawing, mut own) = (Vec::new(), None, Vec::new());
    for name in engine::names(&subject) {
        if only.is_empty() || only.contains(&name) {
            let (row, picture) = row::of_algorithm(&subject, name);
            rows.push(row);
            drawing.get_or_insert(picture);
        }
    }
    let is_graph = matches!(subject.body, Body::Graph(_));
    for method in methods().iter().filter(|method| is_graph && only.contains(&method.name)) {
        let (row, picture) = row::of_method(&subject, method, bounds);
        let added = row.added.as_ref().map_or(0, |added| added.points);
        let more = if row.is_stopped() { " by then" } else { "" };
        let caption = format!("{}: {} Steiner points{more}", method.name, grouped(added as u64));
        rows.push(row);
        own.push((caption, picture));
    }
    if rows.is_empty() {
        drawing = Some(Drawing::of(&subject, None));
    }
    Entry { subject, rows, drawing, own }
}

fn result(subject: &Subject, row: &Row) -> Value {
    let mut object = json!({
        "input": input(subject),
        "algorithm": row.algorithm,
        "fingerprint": row.fingerprint,
        "vertices": row.sizes.vertices,
        "cells": row.sizes.cells,
        "hull_facets": row.sizes.hull_facets,
        "seconds": { "build": row.seconds, "runs": row.runs, "check": row.check_seconds },
        "counts": counts(&row.counts),
        "check": row.verdict.as_ref().map(check_value),
    });
    if let Some(added) = &row.added {
        object["steiner"] = json!(added.points);
        object["complete"] = json!(added.is_complete);
        object["ignores_order"] = json!(added.ignores_order);
    }
    object
}

fn json(comparison: &Comparison) -> Value {
    let mut results = Vec::new();
    for entry in &comparison.entries {
        results.extend(entry.rows.iter().map(|row| result(&entry.subject, row)));
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
        "proved": comparison.rows().all(|row| row.verdict.as_ref().is_some_and(|verdict| verdict.ok)),
    })
}
