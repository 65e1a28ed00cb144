//! `delone engine`: one of our algorithms, as a benchmark runs it beside its peers.

use std::time::Instant;

use delone_delaunay::{KernelKind, Options};
use delone_formats::Document;
use delone_probe::Counts;

use crate::cli;
use crate::engine::{self, Triangulation};
use crate::failure::Failure;
use crate::subject::Subject;
use crate::{input, output};

/// Builds as often as asked, from points to triangulation, and prints what each took; then once more, counting.
pub(crate) fn engine(arguments: &cli::Engine) -> Result<(), Failure> {
    output::check_paths([arguments.output.as_path()])?;
    let document = input::read(&arguments.input, None)?;
    let make: Build = match arguments.task.as_str() {
        "delaunay" => |document, asked, options| run(Subject::points(document)?, asked, options),
        "cdt" => constrained,
        other => return Err(Failure::input(format!("no task is called {other}: delaunay, cdt"))),
    };
    let (options, asked) = (engine::options(&arguments.run), arguments.run.algorithm.as_deref());
    let timed = || {
        let copy = document.clone();
        let start = Instant::now();
        let built = make(copy, asked, &options)?;
        println!("seconds {:e}", start.elapsed().as_secs_f64());
        Ok(built)
    };
    for _ in 1..arguments.times {
        timed()?;
    }
    let (subject, triangulation) = timed()?;
    let (name, mut counts) = (engine::choose(&subject, asked)?, Counts::default());
    engine::run(&subject, name, &options, Some(&mut counts));
    for (name, count) in counts.named().into_iter().filter(|&(_, count)| count > 0) {
        println!("count {name} {count}");
    }
    println!("fingerprint {}", triangulation.fingerprint(&subject));
    println!("version {}", env!("CARGO_PKG_VERSION"));
    output::document(&arguments.output, &triangulation.document(&subject)).map(|_| ())
}

/// From a document, by the algorithm asked for.
type Build = fn(Document, Option<&str>, &Options) -> Result<(Subject, Triangulation), Failure>;

/// By the algorithm's short way from points and segments, if it has one: that of the adaptive kernel.
fn constrained(
    document: Document,
    asked: Option<&str>,
    options: &Options,
) -> Result<(Subject, Triangulation), Failure> {
    let rows = delone_cdt::algorithms();
    let row = asked.map_or(rows.first(), |asked| rows.iter().find(|row| row.name == asked));
    match row.and_then(|row| row.from_points).filter(|_| options.kernel == KernelKind::Adaptive) {
        Some(from_points) => Subject::constrained(document, from_points)
            .map(|(subject, cdt)| (subject, Triangulation::Constrained(cdt))),
        None => run(Subject::graph(document)?, asked, options),
    }
}

fn run(
    subject: Subject,
    asked: Option<&str>,
    options: &Options,
) -> Result<(Subject, Triangulation), Failure> {
    let name = engine::choose(&subject, asked)?;
    let built = engine::run(&subject, name, options, None);
    Ok((subject, built.triangulation))
}
