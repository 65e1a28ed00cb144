//! `delone engine`: one of our algorithms, as a benchmark runs it beside its peers.

use std::time::Instant;

use delone_formats::Document;
use delone_probe::Counts;

use crate::cli;
use crate::engine;
use crate::failure::Failure;
use crate::subject::Subject;
use crate::{input, output};

/// Builds as often as asked, from points to triangulation, and prints what each took; then once more, counting.
pub(crate) fn engine(arguments: &cli::Engine) -> Result<(), Failure> {
    output::check_paths([arguments.output.as_path()])?;
    let document = input::read(&arguments.input, None)?;
    let make: fn(Document) -> Result<Subject, Failure> = match arguments.task.as_str() {
        "delaunay" => Subject::points,
        "cdt" => Subject::graph,
        other => return Err(Failure::input(format!("no task is called {other}: delaunay, cdt"))),
    };
    let options = engine::options(&arguments.run);
    let asked = arguments.run.algorithm.as_deref();
    for _ in 0..arguments.times {
        let copy = document.clone();
        let start = Instant::now();
        let subject = make(copy)?;
        let name = engine::choose(&subject, asked)?;
        let built = engine::run(&subject, name, &options, None);
        println!("seconds {:e}", start.elapsed().as_secs_f64());
        drop(built);
    }
    let subject = make(document)?;
    let (name, mut counts) = (engine::choose(&subject, asked)?, Counts::default());
    let built = engine::run(&subject, name, &options, Some(&mut counts));
    for (name, count) in counts.named().into_iter().filter(|&(_, count)| count > 0) {
        println!("count {name} {count}");
    }
    println!("fingerprint {}", built.triangulation.fingerprint(&subject));
    println!("version {}", env!("CARGO_PKG_VERSION"));
    output::document(&arguments.output, &built.triangulation.document(&subject)).map(|_| ())
}
