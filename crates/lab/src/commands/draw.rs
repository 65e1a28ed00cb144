//! `delone draw`: a picture of an input and its triangulation.

use delone_delaunay::Options;
use delone_draw::Style;

use crate::cli;
use crate::engine;
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
    let document = input::read(&arguments.source.input, arguments.source.format.as_deref())?;
    let has_cells = !(document.triangles.is_empty() && document.tets.is_empty());
    // A picture of the input alone is wanted most when the input is refused: it needs no validation.
    let (subject, triangulation) = if arguments.bare || has_cells {
        (Subject::unchecked(document), None)
    } else {
        let subject = Subject::new(document)?;
        let name = engine::choose(&subject, None)?;
        let built = engine::run(&subject, name, &Options::default(), None);
        (subject, Some(built.triangulation))
    };
    let style = Style {
        size: arguments.size,
        numbered: arguments.numbered,
        circumcircles: arguments.circumcircles,
        title: describe(&subject),
        ..Style::default()
    };
    let svg = Drawing::of(&subject, triangulation.as_ref()).svg(&style);
    match &arguments.output {
        Some(path) => output::text(path, &svg),
        None => output::print_bytes(svg.as_bytes()),
    }
}
