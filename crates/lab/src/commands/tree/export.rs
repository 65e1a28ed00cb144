//! `delone tree polygons` and `delone tree mesh`: a quadtree as segments, and as triangles.

use delone_formats::Document;
use delone_trees::{Frame, Joined, OrthTree};
use serde_json::json;

use super::boundary::{Boundary, Grown, read};
use super::numbers::tell;
use crate::cli::{Export, Part};
use crate::failure::Failure;
use crate::output;

fn plane(arguments: &Export) -> Result<(OrthTree<2>, Frame<2>), Failure> {
    output::check_paths([arguments.output.as_path()])?;
    output::format_to_write(&arguments.output)?;
    let document = read(&arguments.source, arguments.voice.quiet)?;
    match Boundary::of(&document, arguments.inside)?.tree(arguments.depth, arguments.rule)? {
        Grown::Plane(tree, frame) => Ok((tree, frame)),
        Grown::Space(..) => Err(Failure::input("this is for the plane, and the input is in space")),
    }
}

fn write(arguments: &Export, document: &Document) -> Result<(), Failure> {
    for lost in output::document(&arguments.output, document)? {
        eprintln!("note: {lost}");
    }
    Ok(())
}

pub(super) fn polygons(arguments: &Export) -> Result<(), Failure> {
    let (tree, frame) = plane(arguments)?;
    let complex = tree.boundary_complex(&frame, Joined::ByFacets);
    let rings = tree.boundary(Joined::ByFacets).len();
    let edges = if complex.dimension() == Some(1) { complex.cells(1) } else { &[] };
    let document = Document {
        points: complex.vertices().as_flattened().to_vec(),
        segments: edges.iter().map(|ends| [ends[0], ends[1]]).collect(),
        ..Document::new(2)
    };
    write(arguments, &document)?;
    let object = json!({
        "schema": "delone.tree-polygons/1",
        "rings": rings,
        "corners": complex.vertices().len(),
        "components": tree.components(Joined::ByFacets).count,
        "euler": tree.euler(Joined::ByFacets),
    });
    tell(&object, arguments.voice.json);
    Ok(())
}

pub(super) fn mesh(arguments: &Export) -> Result<(), Failure> {
    let (tree, frame) = plane(arguments)?;
    let leaves = tree.leaves().balanced(Joined::ByFacets);
    let mesh = leaves.triangles(&frame).map_err(Failure::input)?;
    let is_kept = |inside: bool| inside || arguments.part == Part::All;
    let kept = mesh.triangles.iter().zip(&mesh.inside).filter(|(_, inside)| is_kept(**inside));
    let (points, triangles) = used(&mesh.points, kept.map(|(corners, _)| *corners).collect());
    let object = json!({
        "schema": "delone.tree-mesh/1",
        "leaves": tree.counts().leaves(),
        "balanced_leaves": leaves.len(),
        "vertices": points.len(),
        "triangles": triangles.len(),
    });
    let document =
        Document { points: points.as_flattened().to_vec(), triangles, ..Document::new(2) };
    write(arguments, &document)?;
    tell(&object, arguments.voice.json);
    Ok(())
}

/// The points that triangles use, and the triangles on them.
fn used(points: &[[f64; 2]], mut triangles: Vec<[u32; 3]>) -> (Vec<[f64; 2]>, Vec<[u32; 3]>) {
    let mut vertices: Vec<u32> = triangles.as_flattened().to_vec();
    vertices.sort_unstable();
    vertices.dedup();
    for corner in triangles.as_flattened_mut() {
        let place = vertices.binary_search(corner).expect("all are there");
        *corner = u32::try_from(place).expect("a vertex index fits 32 bits");
    }
    (vertices.iter().map(|&v| points[v as usize]).collect(), triangles)
}
