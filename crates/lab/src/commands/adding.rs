//! What the commands that add Steiner points have in common: how they begin, and how they end.

use std::time::{Duration, Instant};

use delone_check::Verdict;
use delone_draw::Style;
use delone_sites::Pslg;
use serde_json::{Map, Value};

use super::triangulate::{page, tell, written};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::result::{Outcome, Seconds, describe};
use crate::subject::Subject;
use crate::watch::{self, Watch};
use crate::{cli, input, output, steiner};

/// A command under way.
pub(super) struct Adding<'a> {
    arguments: &'a cli::Adding,
    pub(super) subject: Subject,
    limit: Option<Duration>,
    seconds: Seconds,
    progress: Progress,
    algorithm: &'static str,
}

/// What a command has to say that is its own.
pub(super) struct Own {
    pub(super) schema: &'static str,
    pub(super) keys: Map<String, Value>,
}

impl<'a> Adding<'a> {
    /// Reads and validates, and looks whether what is asked for can be written.
    pub(super) fn begin(
        arguments: &'a cli::Adding,
        algorithm: &'static str,
    ) -> Result<Self, Failure> {
        let limit = watch::limit(arguments.limits.time_limit)?;
        let start = Instant::now();
        let source = &arguments.source;
        let document = input::read(&source.input, source.format.as_deref())?;
        let subject = match arguments.crossings {
            cli::Rounding::Reject => Subject::graph(document)?,
            cli::Rounding::Snap => Subject::snapped(document)?,
        };
        for path in &arguments.report.outputs {
            output::format_to_write(path)?;
        }
        output::check_paths(written(&arguments.report))?;
        let seconds = Seconds { read: start.elapsed().as_secs_f64(), ..Seconds::default() };
        let progress = Progress::new(algorithm, arguments.report.voice.quiet);
        Ok(Self { arguments, subject, limit, seconds, progress, algorithm })
    }

    pub(super) fn pslg(&self) -> &Pslg {
        steiner::graph(&self.subject)
    }

    /// The most vertices.
    pub(super) fn vertices_max(&self) -> usize {
        self.arguments.limits.vertices_max.unwrap_or(usize::MAX)
    }

    /// Runs an algorithm by the clock.
    pub(super) fn build<T>(&mut self, run: impl FnOnce(&Subject, &mut Watch<'_>) -> T) -> T {
        let clock = Instant::now();
        let listener = self.arguments.report.counts.then_some(&mut self.progress);
        let result = run(&self.subject, &mut Watch::start(listener, self.limit));
        self.seconds.build = clock.elapsed().as_secs_f64();
        self.progress.finish();
        result
    }

    /// Judges if asked to, writes what was asked for, says what there is, and whether it is all.
    pub(super) fn end(
        &self,
        result: &steiner::Result<'_>,
        own: Own,
        judge: impl FnOnce() -> Verdict,
    ) -> Result<(), Failure> {
        let (report, mut seconds) = (&self.arguments.report, self.seconds);
        let clock = Instant::now();
        let verdict = report.check.then(judge);
        seconds.check = report.check.then(|| clock.elapsed().as_secs_f64());
        let mut extra = result.keys();
        extra.extend(own.keys);
        let mut outcome = Outcome {
            schema: own.schema,
            subject: &self.subject,
            algorithm: self.algorithm,
            kernel: "constructed",
            fingerprint: result.conforming.fingerprint().to_string(),
            sizes: result.sizes(),
            seconds,
            counts: report.counts.then_some(self.progress.counts),
            verdict,
            extra,
            notes: self.subject.document.notes.clone(),
        };
        write(report, result, &mut outcome)?;
        if result.conforming.is_complete() {
            return Ok(());
        }
        Err(Failure::Limit(format!(
            "{}: a limit was reached with {} vertices; the result is a valid triangulation, but not all that was asked for",
            self.subject.name(),
            outcome.sizes.vertices
        )))
    }
}

/// Writes what was asked for, and says what there is.
fn write(
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
    let drawing = result.drawing(&document);
    let style = Style { title: describe(outcome.subject), ..Style::default() };
    if let Some(path) = &report.svg {
        output::text(path, &drawing.svg(&style))?;
    }
    if let Some(path) = &report.html {
        output::text(path, &page(outcome, &drawing, &style))?;
    }
    tell(report, outcome, clock.elapsed().as_secs_f64())
}
