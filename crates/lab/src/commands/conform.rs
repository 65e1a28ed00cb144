//! `delone conform`: read, validate, add Steiner points, judge, write, tell.

use std::time::Instant;

use delone_check::Promise;
use delone_conforming::{ConformOptions, Limits, Method, methods};
use delone_draw::Style;

use super::triangulate::{page, tell, written};
use crate::cli;
use crate::failure::Failure;
use crate::pictures::Drawing;
use crate::progress::Progress;
use crate::result::{Outcome, Seconds, describe};
use crate::subject::Subject;
use crate::watch::{self, Watch};
use crate::{input, output, steiner};

pub(crate) fn conform(arguments: &cli::Conform) -> Result<(), Failure> {
    let limit = watch::limit(arguments.limits.time_limit)?;
    let report = &arguments.report;
    let start = Instant::now();
    let document = input::read(&arguments.source.input, arguments.source.format.as_deref())?;
    let subject = Subject::graph(document)?;
    let pslg = steiner::graph(&subject);
    for path in &report.outputs {
        output::format_to_write(path)?;
    }
    output::check_paths(written(report))?;
    let mut seconds = Seconds { read: start.elapsed().as_secs_f64(), ..Seconds::default() };
    let method = method(arguments.method.name());
    let limits = Limits { vertices_max: arguments.limits.vertices_max.unwrap_or(usize::MAX) };
    let options = ConformOptions { limits, ..ConformOptions::default() };
    let mut progress = Progress::new(method.name, report.voice.quiet);
    let clock = Instant::now();
    let listener = report.counts.then_some(&mut progress);
    let conforming = (method.run)(pslg, &options, &mut Watch::start(listener, limit));
    seconds.build = clock.elapsed().as_secs_f64();
    progress.finish();
    let result = steiner::Result { subject: &subject, pslg, conforming: &conforming, inside: None };
    let promise = if method.empties_disks { Promise::EmptyDisks } else { Promise::Conforming };
    let clock = Instant::now();
    let verdict = report.check.then(|| result.verdict(promise));
    seconds.check = report.check.then(|| clock.elapsed().as_secs_f64());
    let mut outcome = Outcome {
        schema: "delone.conform/1",
        subject: &subject,
        algorithm: method.name,
        kernel: "constructed",
        fingerprint: conforming.fingerprint().to_string(),
        sizes: result.sizes(),
        seconds,
        counts: report.counts.then_some(progress.counts),
        verdict,
        extra: result.keys(),
        notes: subject.document.notes.clone(),
    };
    write_and_tell(report, &result, &mut outcome)
}

/// Writes what was asked for, says what there is, and whether it is all.
pub(super) fn write_and_tell(
    report: &cli::Report,
    result: &steiner::Result<'_>,
    outcome: &mut Outcome<'_>,
) -> Result<(), Failure> {
    let clock = Instant::now();
    let document = result.document();
    for path in &report.outputs {
        let lost = output::document(path, &document)?;
        let lost = lost.into_iter().map(|lost| format!("{}: {lost}", path.display()));
        outcome.notes.extend(lost);
    }
    let drawing = Drawing::of_document(&document);
    let style = Style { title: describe(outcome.subject), ..Style::default() };
    if let Some(path) = &report.svg {
        output::text(path, &drawing.svg(&style))?;
    }
    if let Some(path) = &report.html {
        output::text(path, &page(outcome, &drawing, &style))?;
    }
    tell(report, outcome, clock.elapsed().as_secs_f64())?;
    if result.conforming.is_complete() {
        return Ok(());
    }
    Err(Failure::Limit(format!(
        "{}: a limit was reached with {} vertices; the result is a valid triangulation, but not all that was asked for",
        outcome.subject.name(),
        outcome.sizes.vertices
    )))
}

/// The method of this name.
fn method(name: &str) -> Method {
    methods().into_iter().find(|method| method.name == name).expect("the command line has these")
}
