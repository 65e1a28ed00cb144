//! `delone delaunay` and `delone cdt`: read, validate, build, judge, write, tell.

use std::path::Path;
use std::time::{Duration, Instant};

use delone_delaunay::Stopped;
use delone_draw::{Anchor, Report, Style, Tone};
use delone_probe::Probe;

use crate::cli;
use crate::engine::{self, Built, Triangulation};
use crate::failure::Failure;
use crate::pictures::Drawing;
use crate::progress::Progress;
use crate::result::{Outcome, Seconds, describe};
use crate::subject::Subject;
use crate::watch::{self, Watch};
use crate::{input, output};

pub(crate) fn delaunay(arguments: &cli::Triangulate) -> Result<(), Failure> {
    let limit = watch::limit(arguments.time_limit)?;
    let start = Instant::now();
    let mut document = input::read(&arguments.source.input, arguments.source.format.as_deref())?;
    input::take_weights(&mut document, arguments.weights.file.as_deref())?;
    let subject = Subject::points(document)?;
    if arguments.voronoi && subject.document.dimension != 2 {
        return Err(Failure::input("--voronoi is for the plane, and the input is in space"));
    }
    let read = start.elapsed().as_secs_f64();
    let ask = Ask {
        schema: "delone.delaunay/1",
        run: &arguments.run,
        report: &arguments.report,
        limit,
        voronoi: arguments.voronoi,
    };
    triangulate(&ask, &subject, read)
}

pub(crate) fn cdt(arguments: &cli::Cdt) -> Result<(), Failure> {
    let cli::Crossings::Reject = arguments.crossings;
    let start = Instant::now();
    let document = input::read(&arguments.source.input, arguments.source.format.as_deref())?;
    let subject = Subject::graph(document)?;
    let read = start.elapsed().as_secs_f64();
    let ask = Ask {
        schema: "delone.cdt/1",
        run: &arguments.run,
        report: &arguments.report,
        limit: None,
        voronoi: false,
    };
    triangulate(&ask, &subject, read)
}

/// What is asked for, whatever the command.
struct Ask<'a> {
    schema: &'static str,
    run: &'a cli::Run,
    report: &'a cli::Report,
    limit: Option<Duration>,
    voronoi: bool,
}

/// The algorithm to run: under a time limit, one that can be stopped.
fn choose(subject: &Subject, ask: &Ask<'_>) -> Result<&'static str, Failure> {
    let asked = ask.run.algorithm.as_deref();
    if ask.limit.is_none() {
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
    ask: &Ask<'_>,
    subject: &Subject,
    algorithm: &'static str,
    progress: &mut Progress,
) -> Result<Built, Failure> {
    // Counting and showing progress cost time: what is timed runs without, unless the run is long.
    let is_long = subject.site_count() > 1_000_000;
    let listens = ask.report.counts || is_long;
    let options = engine::options(ask.run);
    let progress = listens.then_some(progress);
    let is_watched = is_long || ask.limit.is_some();
    if !is_watched || !engine::stoppable(subject).contains(&algorithm) {
        let probe = progress.map(|progress| progress as &mut dyn Probe);
        return Ok(engine::run(subject, algorithm, &options, probe));
    }
    let mut watch = Watch::start(progress, ask.limit);
    engine::run_unless_stopped(subject, algorithm, &options, &mut watch)
        .map_err(|Stopped| Failure::Limit(format!("{}: {watch}", subject.name())))
}

fn triangulate(ask: &Ask<'_>, subject: &Subject, read: f64) -> Result<(), Failure> {
    let Ask { schema, run, report, .. } = *ask;
    let algorithm = choose(subject, ask)?;
    for path in &report.outputs {
        output::format_to_write(path)?;
    }
    output::check_paths(written(report))?;
    let mut progress = Progress::new(algorithm, report.voice.quiet);
    let built = build(ask, subject, algorithm, &mut progress);
    progress.finish();
    let built = built?;
    let mut seconds = Seconds { read, build: built.seconds, ..Seconds::default() };
    let triangulation = built.triangulation;
    let clock = Instant::now();
    let verdict = report.check.then(|| triangulation.verdict(subject));
    seconds.check = report.check.then(|| clock.elapsed().as_secs_f64());
    let mut outcome = Outcome {
        schema,
        subject,
        algorithm,
        kernel: match run.kernel {
            cli::Kernel::Adaptive => "adaptive",
            cli::Kernel::Exact => "exact",
        },
        fingerprint: triangulation.fingerprint(subject).to_string(),
        sizes: triangulation.sizes(subject),
        seconds,
        counts: report.counts.then_some(progress.counts),
        verdict,
        extra: triangulation.extra(subject),
        notes: subject.document.notes.clone(),
    };
    let clock = Instant::now();
    write_results(ask, &triangulation, &mut outcome)?;
    tell(report, &mut outcome, clock.elapsed().as_secs_f64())
}

fn written(report: &cli::Report) -> impl Iterator<Item = &Path> {
    let files = report.outputs.iter().chain(&report.svg).chain(&report.html);
    files.map(std::path::PathBuf::as_path)
}

fn write_results(
    ask: &Ask<'_>,
    triangulation: &Triangulation,
    outcome: &mut Outcome<'_>,
) -> Result<(), Failure> {
    let (subject, report) = (outcome.subject, ask.report);
    if !report.outputs.is_empty() {
        let document = triangulation.document(subject);
        for path in &report.outputs {
            let lost = output::document(path, &document)?;
            outcome
                .notes
                .extend(lost.into_iter().map(|lost| format!("{}: {lost}", path.display())));
        }
    }
    if report.svg.is_some() || report.html.is_some() {
        let mut drawing = Drawing::of(subject, Some(triangulation));
        if ask.voronoi {
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
fn page(outcome: &Outcome<'_>, drawing: &Drawing, style: &Style) -> String {
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
    } else {
        page.picture(&drawing.plane(), style, &describe(outcome.subject));
    }
    page.code(&outcome.text());
    page.finish()
}

fn tell(report: &cli::Report, outcome: &mut Outcome<'_>, write: f64) -> Result<(), Failure> {
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
