//! `delone draw`: a picture of an input and its triangulation.

use std::path::Path;

use delone_conforming::Missing;
use delone_delaunay::Options;
use delone_draw::{Exploded, Picture, Style, panels};
use delone_formats::Document;
use delone_mesh::Mesh;

use crate::cli;
use crate::engine::{self, Triangulation};
use crate::failure::Failure;
use crate::pictures::{Drawing, edges};
use crate::result::describe;
use crate::subject::{Body, Subject};
use crate::{input, judge, output};

/// The most vertices of a conforming triangulation in a panel.
const PANEL_VERTICES_MAX: usize = 200_000;

pub(crate) fn draw(arguments: &cli::Draw) -> Result<(), Failure> {
    if !(arguments.size.is_finite() && arguments.size >= 16.0) {
        return Err(Failure::input(format!("--size {}: give 16 pixels or more", arguments.size)));
    }
    output::check_paths(arguments.output.as_deref())?;
    let mut document = input::read(&arguments.source.input, arguments.source.format.as_deref())?;
    input::take_weights(&mut document, arguments.weights.file.as_deref())?;
    if arguments.panels {
        return write(arguments, &figure(document, arguments)?);
    }
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
        edges_numbered: arguments.edges,
        circumcircles: arguments.circumcircles,
        title: describe(&subject),
        ..Style::default()
    };
    let svg = match arguments.explode.filter(|_| !drawing.is_space()) {
        Some(factor) if factor.is_finite() => {
            Exploded::new(&drawing.plane(), factor).picture().svg(&style)
        }
        Some(factor) => return Err(Failure::input(format!("--explode {factor}: give a number"))),
        None => drawing.svg(&style),
    };
    write(arguments, &svg)
}

fn write(arguments: &cli::Draw, svg: &str) -> Result<(), Failure> {
    match &arguments.output {
        Some(path) => output::text(path, svg),
        None => output::print_bytes(svg.as_bytes()),
    }
}

/// The input, its Delaunay, its conforming and its constrained Delaunay triangulation, side by side.
fn figure(document: Document, arguments: &cli::Draw) -> Result<String, Failure> {
    let subject = Subject::graph(document)?;
    let Body::Graph(pslg) = &subject.body else { unreachable!("a graph was asked for") };
    let free = delone_delaunay::delaunay(pslg.sites(), &Options::default(), &mut ());
    let cdt = delone_cdt::cavity(pslg, &Options::default(), &mut ());
    let options = delone_conforming::ConformOptions {
        limits: delone_conforming::Limits { vertices_max: PANEL_VERTICES_MAX },
        ..delone_conforming::ConformOptions::default()
    };
    let conforming = delone_conforming::conform(pslg, &Missing, &options, &mut ());
    let points = pslg.sites().points();
    let steiner: Vec<u32> = (0u32..).take(conforming.kernel().len()).skip(points.len()).collect();
    let third = triangles(conforming.mesh());
    let triangles = [free.mesh(), cdt.mesh()].map(triangles);
    let [delaunay, constrained] =
        [&triangles[0], &triangles[1]].map(|triangles| edges(triangles.iter()));
    let missing: Vec<[u32; 2]> = without(pslg.subsegments(), &delaunay);
    let forced: Vec<[u32; 2]> = without(&constrained, &delaunay);
    let bare = Picture { points, segments: pslg.subsegments(), ..Picture::default() };
    // A panel has no room for folders.
    let name = Path::new(subject.name()).file_name().unwrap_or_default().display();
    let style = |title: String| Style {
        size: arguments.size / 2.0,
        numbered: arguments.numbered,
        edges_numbered: arguments.edges,
        circumcircles: arguments.circumcircles,
        title,
        ..Style::default()
    };
    Ok(panels(&[
        (bare, style(format!("{name}: {} segments", pslg.segments().len()))),
        (
            Picture { segments: &[], triangles: &triangles[0], highlights: &missing, ..bare },
            style(format!(
                "Delaunay: {} of {} subsegments missing",
                missing.len(),
                pslg.subsegments().len()
            )),
        ),
        (
            Picture {
                points: conforming.positions(),
                triangles: &third,
                segments: conforming.constrained_edges(),
                marked: &steiner,
                ..Picture::default()
            },
            style(match conforming.is_complete() {
                true => format!("conforming Delaunay: {} Steiner points", steiner.len()),
                false => format!("not conforming yet: more than {} Steiner points", steiner.len()),
            }),
        ),
        (
            Picture { triangles: &triangles[1], highlights: &forced, ..bare },
            style(format!("constrained Delaunay: {} edges not Delaunay", forced.len())),
        ),
    ]))
}

fn triangles(mesh: &Mesh<2>) -> Vec<[u32; 3]> {
    if mesh.dimension() == Some(2) {
        judge::solid_ids(mesh).as_chunks::<3>().0.to_vec()
    } else {
        Vec::new()
    }
}

fn without(edges: &[[u32; 2]], known: &[[u32; 2]]) -> Vec<[u32; 2]> {
    edges.iter().copied().filter(|edge| known.binary_search(edge).is_err()).collect()
}

fn triangulated(subject: &Subject) -> Result<Triangulation, Failure> {
    let name = engine::choose(subject, None)?;
    Ok(engine::run(subject, name, &Options::default(), None).triangulation)
}
