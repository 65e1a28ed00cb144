//! `delone draw`: a picture of an input and its triangulation.

use delone_delaunay::Options;
use delone_draw::Style;

use crate::cli;
use crate::engine::{self, Triangulation};
use crate::failure::Failure;
use crate::pictures::Drawing;
use crate::result::describe;
use crate::subject::Subject;
use crate::{input, output};

pub(crate) fn draw(arguments: &cli::Draw) -> Result<(), Failure> {
    if !(arguments.size.is_finite() && arguments.size >= 16.0) {
        return Err(Failure::input(format!("--size {}: give 16 pixels or more", arguments.size)));
    }
    output::check_paths(arguments.output.as_deref())?;
    let mut document = input::read(&arguments.source.input, arguments.source.format.as_deref())?;
    input::take_weights(&mut document, arguments.weights.file.as_deref())?;
    if arguments.voronoi && document.dimension != 2 {
        return Err(Failure::input("--voronoi is for the plane, and the input is in space"));
    }
    let points = arguments.voronoi.then(|| document.clone());
    let has_cells = !(document.triangles.is_empty() && document.tets.is_empty());
    // A picture of the input alone is wanted most when the input is refused: it needs no validation.
    let (subject, triangulation) = if arguments.bare || has_cells {
        (Subject::unchecked(document), None)
    } else {
        let subject = Subject::new(document)?;
        let triangulation = triangulated(&subject)?;
        (subject, Some(triangulation))
    };
    let mut drawing = Drawing::of(&subject, triangulation.as_ref());
    if let Some(points) = points {
        let sites = Subject::points(points)?; // whatever else is drawn
        drawing.add_regions(&sites, &triangulated(&sites)?);
    }
    let style = Style {
        size: arguments.size,
        numbered: arguments.numbered,
        circumcircles: arguments.circumcircles,
        title: describe(&subject),
        ..Style::default()
    };
    let svg = drawing.svg(&style);
    match &arguments.output {
        Some(path) => output::text(path, &svg),
        None => output::print_bytes(svg.as_bytes()),
    }
}

fn triangulated(subject: &Subject) -> Result<Triangulation, Failure> {
    let name = engine::choose(subject, None)?;
    Ok(engine::run(subject, name, &Options::default(), None).triangulation)
}
