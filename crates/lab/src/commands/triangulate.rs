//! `delone delaunay` and `delone cdt`: read, validate, build, judge, write, tell.

use std::path::Path;
use std::time::{Duration, Instant};

use delone_cdt::Domain;
use delone_delaunay::Stopped;
use delone_draw::{Anchor, Report, Style, Tone};
use delone_probe::Probe;
use serde_json::Map;

use crate::cli;
use crate::engine::{self, Built, Triangulation};
use crate::failure::Failure;
use crate::pictures::Drawing;
use crate::progress::Progress;
use crate::result::{Outcome, Seconds, describe};
use crate::subject::{Body, Subject};
use crate::watch::{self, Watch};
use crate::{fill, input, judge, output};

pub(crate) fn delaunay(arguments: &cli::Triangulate) -> Result<(), Failure> {
    let limit = watch::limit(arguments.time_limit)?;
    let start = Instant::now();
    let mut document = input::read(&arguments.source.input, arguments.source.format.as_deref())?;
    input::take_weights(&mut document, arguments.weights.file.as_deref())?;
    let subject = Subject::points_in_parallel(document, arguments.run.threads)?;
    if arguments.voronoi && subject.document.dimension != 2 {
        return Err(Failure::input("--voronoi is for the plane, and the input is in space"));
    }
    let read = start.elapsed().as_secs_f64();
    let job = Job {
        schema: "delone.delaunay/1",
        run: &arguments.run,
        report: &arguments.report,
        read,
        limit,
        voronoi: arguments.voronoi,
    };
    job.carry_out(&subject, |triangulation| Ok((triangulation.extra(&subject), None)))
}

pub(crate) fn cdt(arguments: &cli::Cdt) -> Result<(), Failure> {
    let start = Instant::now();
    let document = input::read(&arguments.source.input, arguments.source.format.as_deref())?;
    let subject = match arguments.crossings {
        cli::Crossings::Split => Subject::crossed(document)?,
        cli::Crossings::Snap => Subject::snapped(document)?,
        cli::Crossings::Reject if arguments.strict => Subject::strict(document)?,
        cli::Crossings::Reject => Subject::graph(document)?,
    };
    let read = start.elapsed().as_secs_f64();
    let job = Job {
        schema: "delone.cdt/1",
        run: &arguments.run,
        report: &arguments.report,
        read,
        limit: None,
        voronoi: false,
    };
    job.carry_out(&subject, |triangulation| {
        let mut extra = fill::crossing_keys(triangulation, &subject);
        let domain = fill::domain(triangulation, &subject, arguments.fill)?;
        let mut keys = fill::keys(&domain);
        if !arguments.report.voice.json {
            keys.retain(|key, _| !matches!(key.as_str(), "regions" | "edge_kinds"));
        }
        extra.extend(keys);
        Ok((extra, (arguments.fill != cli::Fill::None).then_some((domain, arguments.fill))))
    })
}

/// The keys that only one command has, and what is inside if not everything.
type Filled = (Map<String, serde_json::Value>, Option<(Domain, cli::Fill)>);

struct Job<'a> {
    schema: &'static str,
    run: &'a cli::Run,
    report: &'a cli::Report,
    /// Seconds.
    read: f64,
    limit: Option<Duration>,
    voronoi: bool,
}

impl Job<'_> {
    fn carry_out(
        &self,
        subject: &Subject,
        filled: impl FnOnce(&Triangulation) -> Result<Filled, Failure>,
    ) -> Result<(), Failure> {
        let Self { schema, run, report, read, .. } = *self;
        let algorithm = self.choose(subject)?;
        for path in &report.outputs {
            output::format_to_write(path)?;
        }
        output::check_paths(written(report))?;
        let mut progress = Progress::new(algorithm, report.voice.quiet);
        let built = self.build(subject, algorithm, &mut progress);
        progress.finish();
        let built = built?;
        let mut seconds = Seconds { read, build: built.seconds, ..Seconds::default() };
        let triangulation = built.triangulation;
        let (extra, filled) = filled(&triangulation)?;
        let clock = Instant::now();
        let verdict = report.check.then(|| {
            let verdict = triangulation.verdict(subject);
            let of_fill = filled
                .as_ref()
                .and_then(|(domain, rule)| fill::verdict(&triangulation, subject, domain, *rule));
            of_fill.map_or(verdict.clone(), |of_fill| judge::with_fill(verdict, of_fill))
        });
        seconds.check = report.check.then(|| clock.elapsed().as_secs_f64());
        let mut outcome = Outcome {
            schema,
            subject,
            algorithm,
            kernel: match (&subject.body, run.kernel) {
                (Body::Crossed(_), _) => "constructed",
                (_, cli::Kernel::Adaptive) => "adaptive",
                (_, cli::Kernel::Exact) => "exact",
            },
            fingerprint: triangulation.fingerprint(subject).to_string(),
            sizes: triangulation.sizes(subject),
            seconds,
            counts: report.counts.then_some(progress.counts),
            verdict,
            extra,
            notes: subject.document.notes.clone(),
        };
        let clock = Instant::now();
        let domain = filled.as_ref().map(|(domain, _)| domain);
        write_results(self, &triangulation, domain, &mut outcome)?;
        tell(report, &mut outcome, clock.elapsed().as_secs_f64())
    }

    /// The algorithm to run: under a time limit, one that can be stopped.
    fn choose(&self, subject: &Subject) -> Result<&'static str, Failure> {
        let asked = self.run.algorithm.as_deref();
        if self.limit.is_none() {
            return engine::choose(subject, asked);
        }
        let stoppable = engine::stoppable(subject);
        let chosen = engine::choose(subject, asked.or(stoppable.first().copied()))?;
        if stoppable.contains(&chosen) {
            return Ok(chosen);
        }
        let those = stoppable.join(", ");
        Err(Failure::input(format!("--time-limit: {chosen} cannot be stopped, but {those} can")))
    }

    /// Runs the algorithm, and stops it where that is asked for and it can be stopped.
    fn build(
        &self,
        subject: &Subject,
        algorithm: &'static str,
        progress: &mut Progress,
    ) -> Result<Built, Failure> {
        // Counting and showing progress cost time: what is timed runs without, unless the run is long.
        let is_long = subject.site_count() > 1_000_000;
        let listens = self.report.counts || is_long;
        let options = engine::options(self.run);
        let progress = listens.then_some(progress);
        let is_watched = is_long || self.limit.is_some();
        if !is_watched || !engine::stoppable(subject).contains(&algorithm) {
            let probe = progress.map(|progress| progress as &mut dyn Probe);
            return Ok(engine::run(subject, algorithm, &options, probe));
        }
        let mut watch = Watch::start(progress, self.limit);
        engine::run_unless_stopped(subject, algorithm, &options, &mut watch)
            .map_err(|Stopped| Failure::Limit(format!("{}: {watch}", subject.name())))
    }
}

pub(super) fn written(report: &cli::Report) -> impl Iterator<Item = &Path> {
    let files = report.outputs.iter().chain(&report.svg).chain(&report.html);
    files.map(std::path::PathBuf::as_path)
}

fn write_results(
    job: &Job<'_>,
    triangulation: &Triangulation,
    domain: Option<&Domain>,
    outcome: &mut Outcome<'_>,
) -> Result<(), Failure> {
    let (subject, report) = (outcome.subject, job.report);
    let mut document = triangulation.document(subject);
    if let Some(domain) = domain {
        triangulation.keep_inside(domain, &mut document);
    }
    if !report.outputs.is_empty() {
        for path in &report.outputs {
            let lost = output::document(path, &document)?;
            outcome
                .notes
                .extend(lost.into_iter().map(|lost| format!("{}: {lost}", path.display())));
        }
    }
    if report.svg.is_some() || report.html.is_some() {
        let mut drawing = Drawing::of_document(&document);
        if job.voronoi {
            drawing.add_regions(subject, triangulation);
        }
        let style = Style { title: describe(subject), ..Style::default() };
        if let Some(path) = &report.svg {
            output::text(path, &drawing.svg(&style))?;
        }
        if let Some(path) = &report.html {
            output::text(path, &page(outcome, &drawing, &style))?;
        }
    }
    Ok(())
}

/// A report on one triangulation.
pub(super) fn page(outcome: &Outcome<'_>, drawing: &Drawing, style: &Style) -> String {
    let mut page = Report::new(outcome.subject.name());
    page.lead(&describe(outcome.subject));
    if let Some(verdict) = &outcome.verdict {
        let tone = if verdict.ok { Tone::Ok } else { Tone::Fault };
        let word = if verdict.ok { "Proved" } else { "Not proved" };
        page.notice(tone, &format!("{word}: {}, {} ties.", verdict.level, verdict.ties));
        page.details("What was proved, and how", |page| page.code(&verdict.to_string()));
    }
    page.heading("Triangulation", &Anchor::new("triangulation"));
    if drawing.is_space() {
        page.svg(&drawing.svg(style), &describe(outcome.subject));
    } else if drawing.plane().regions.is_empty() {
        page.scene(&drawing.scene(), style, &describe(outcome.subject));
    } else {
        page.picture(&drawing.plane(), style, &describe(outcome.subject));
    }
    page.code(&outcome.text());
    page.finish()
}

pub(super) fn tell(
    report: &cli::Report,
    outcome: &mut Outcome<'_>,
    write: f64,
) -> Result<(), Failure> {
    if written(report).next().is_some() {
        outcome.seconds.write = Some(write);
    }
    if report.voice.json {
        println!("{}", outcome.json());
    } else {
        print!("{}", outcome.text());
        for path in written(report) {
            println!("{:12} {} ({})", "written", path.display(), output::size(path));
        }
    }
    if !report.voice.quiet {
        outcome.notes.iter().for_each(|note| eprintln!("note: {note}"));
    }
    match &outcome.verdict {
        Some(verdict) if !verdict.ok => Err(Failure::Difference(None)),
        _ => Ok(()),
    }
}
