//! `delone gen`: workloads, by name and seed.

use delone_draw::{Anchor, Report, Style};
use delone_formats::Format;
use delone_workloads::{Workload, all, find};
use serde_json::json;

use crate::cli;
use crate::failure::Failure;
use crate::output;
use crate::pictures::Drawing;
use crate::progress::Busy;
use crate::subject::{Subject, document_of};

pub(crate) fn generate(arguments: &cli::Generate) -> Result<(), Failure> {
    output::check_paths(
        arguments.output.iter().chain(&arguments.html).map(std::path::PathBuf::as_path),
    )?;
    let Some(name) = arguments.name.as_deref().filter(|_| !arguments.list) else {
        return list(arguments);
    };
    let workload = find(name).map_err(Failure::input)?;
    let busy = Busy::new(arguments.voice.quiet, "generating");
    let document = document_of(name, &workload.generate(arguments.n, arguments.seed));
    if let Some(path) = &arguments.output {
        busy.at("writing");
        let lost = output::document(path, &document)?;
        drop(busy);
        lost.iter().filter(|_| !arguments.voice.quiet).for_each(|lost| eprintln!("note: {lost}"));
        return Ok(());
    }
    drop(busy);
    if arguments.voice.json {
        return output::print(&document, Format::Lar);
    }
    // The formats of standard output are those that reading from a pipe tells apart.
    output::print(&document, if document.segments.is_empty() { Format::Node } else { Format::Poly })
}

fn list(arguments: &cli::Generate) -> Result<(), Failure> {
    if let Some(path) = &arguments.html {
        output::text(path, &gallery(arguments.n, arguments.seed))?;
    }
    if arguments.voice.json {
        let rows: Vec<_> = all().iter().map(row).collect();
        println!("{}", json!({ "schema": "delone.workloads/1", "workloads": rows }));
        return Ok(());
    }
    let mut text = String::new();
    for workload in all() {
        text.push_str(&format!(
            "{:20} {:9} {}\n",
            workload.name,
            workload.kind().name(),
            workload.about
        ));
    }
    output::print_bytes(text.as_bytes())
}

fn row(workload: &Workload) -> serde_json::Value {
    json!({
        "name": workload.name,
        "kind": workload.kind().name(),
        "about": workload.about,
        "rounds": workload.rounds,
        "crosses": workload.crosses(),
    })
}

/// A page with a picture of each workload.
fn gallery(n: usize, seed: u64) -> String {
    let mut report = Report::new("Workloads");
    report.lead(&format!("Every generator, about {n} sites, seed {seed}."));
    for workload in all() {
        report.heading(workload.name, &Anchor::new(workload.name));
        report.paragraph(&format!("{}. Sites for n: {}.", workload.about, workload.rounds));
        let input = workload.generate(n, seed);
        let subject = Subject::unchecked(document_of(workload.name, &input));
        let drawing = Drawing::of(&subject, None);
        let style = Style { size: 480.0, title: workload.name.to_owned(), ..Style::default() };
        if drawing.is_space() {
            report.svg(&drawing.svg(&style), workload.name);
        } else {
            report.picture(&drawing.plane(), &style, workload.name);
        }
    }
    report.finish()
}
