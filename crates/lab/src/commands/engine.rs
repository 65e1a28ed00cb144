//! `delone engine`: one of our algorithms, as a benchmark runs it beside its peers.

use std::time::Instant;

use delone_cdt::FromPoints;
use delone_delaunay::{KernelKind, Options};
use delone_formats::Document;
use delone_probe::Counts;

use crate::cli;
use crate::engine::{self, Triangulation};
use crate::failure::Failure;
use crate::subject::{Body, Lists, Subject, lists, refusal};
use crate::{input, output};

/// Builds as often as asked, from points to triangulation, and prints what each took; then once more, counting.
pub(crate) fn engine(arguments: &cli::Engine) -> Result<(), Failure> {
    output::check_paths([arguments.output.as_path()])?;
    let document = input::read(&arguments.input, None)?;
    let (options, asked) = (engine::options(&arguments.run), arguments.run.algorithm.as_deref());
    let task = match arguments.task.as_str() {
        "delaunay" => Task::Delaunay,
        "cdt" => Task::constrained(&document, asked, &options)?,
        other => return Err(Failure::input(format!("no task is called {other}: delaunay, cdt"))),
    };
    let timed = || {
        let copy = document.clone();
        let start = Instant::now();
        let built = task.carry_out(copy, asked, &options)?;
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

/// What is to be built.
enum Task {
    Delaunay,
    /// A CDT by way of a noded graph.
    Constrained,
    /// A CDT by an algorithm that nodes segments as it goes.
    FromPoints(FromPoints, Lists),
}

impl Task {
    /// By the short way from points and segments, if the algorithm has one: that of the adaptive kernel.
    fn constrained(
        document: &Document,
        asked: Option<&str>,
        options: &Options,
    ) -> Result<Self, Failure> {
        let rows = delone_cdt::algorithms();
        let row = asked.map_or(rows.first(), |asked| rows.iter().find(|row| row.name == asked));
        let is_adaptive = options.kernel == KernelKind::Adaptive;
        match row.and_then(|row| row.from_points).filter(|_| is_adaptive) {
            Some(from_points) => Ok(Self::FromPoints(from_points, lists(document)?)),
            None => Ok(Self::Constrained),
        }
    }

    fn carry_out(
        &self,
        document: Document,
        asked: Option<&str>,
        options: &Options,
    ) -> Result<(Subject, Triangulation), Failure> {
        let subject = match self {
            Self::Delaunay => Subject::points_in_parallel(document, options.threads)?,
            Self::Constrained => Subject::graph(document)?,
            Self::FromPoints(from_points, (points, segments)) => {
                let built = from_points(points, segments);
                let (pslg, cdt) = built.map_err(|error| refusal(&document, &error.to_string()))?;
                let subject = Subject { body: Body::Graph(pslg), document };
                return Ok((subject, Triangulation::Constrained(cdt)));
            }
        };
        let name = engine::choose(&subject, asked)?;
        let built = engine::run(&subject, name, options, None);
        Ok((subject, built.triangulation))
    }
}
