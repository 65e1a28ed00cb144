//! The boundary that an input gives: segments of the plane, or faces of space.

use delone_formats::Document;
use delone_trees::{Frame, LeafRule, OrthTree, Rule, Shape, Solid};

use crate::cli::{Inside, Leaves, Source};
use crate::failure::Failure;
use crate::input;

/// What is inside of it can be asked.
pub(super) enum Boundary {
    Plane(Shape),
    Space(Solid),
}

/// A tree of either dimension in its frame.
pub(super) enum Grown {
    Plane(OrthTree<2>, Frame<2>),
    Space(OrthTree<3>, Frame<3>),
}

/// Evaluates `$answer` with the tree and the frame of either dimension.
macro_rules! with_tree {
    ($grown:expr, $tree:ident, $frame:ident => $answer:expr) => {
        match $grown {
            Grown::Plane($tree, $frame) => $answer,
            Grown::Space($tree, $frame) => $answer,
        }
    };
}
pub(super) use with_tree;

impl Boundary {
    pub(super) fn of(document: &Document, inside: Inside) -> Result<Self, Failure> {
        let rule = rule(inside);
        if document.dimension == 3 {
            let faces = faces(document);
            refuse_empty(document, faces.len(), "faces")?;
            let points = document.points_3d().map_err(Failure::input)?;
            return Ok(Self::Space(Solid::new(points, &faces, rule).map_err(Failure::input)?));
        }
        let segments = segments(document);
        refuse_empty(document, segments.len(), "segments")?;
        let points = document.points_2d().map_err(Failure::input)?;
        Ok(Self::Plane(Shape::new(points, &segments, rule).map_err(Failure::input)?))
    }

    pub(super) fn tree(&self, depth: u8, leaves: Leaves) -> Result<Grown, Failure> {
        let rule = rule_of_leaves(leaves);
        match self {
            Self::Plane(shape) => {
                let frame = shape.frame(depth).map_err(Failure::input)?;
                let tree = rule
                    .map_or_else(|| shape.tree_by_area(&frame), |rule| shape.tree(&frame, rule));
                Ok(Grown::Plane(tree, frame))
            }
            Self::Space(solid) => {
                let frame = solid.frame(depth).map_err(Failure::input)?;
                let rule = rule.ok_or_else(|| Failure::input("--rule area is for the plane"))?;
                Ok(Grown::Space(solid.tree(&frame, rule), frame))
            }
        }
    }
}

fn refuse_empty(document: &Document, count: usize, what: &str) -> Result<(), Failure> {
    if count > 0 {
        return Ok(());
    }
    let name = &document.name;
    Err(Failure::input(format!(
        "{name}: there are no {what}, so nothing is inside: give a boundary"
    )))
}

/// Reads a document; its notes are said unless quiet.
pub(super) fn read(source: &Source, quiet: bool) -> Result<Document, Failure> {
    let document = input::read(&source.input, source.format.as_deref())?;
    if !quiet {
        document.notes.iter().for_each(|note| eprintln!("note: {note}"));
    }
    Ok(document)
}

pub(super) fn segments(document: &Document) -> Vec<[usize; 2]> {
    document.segments.iter().map(|ends| ends.map(|end| end as usize)).collect()
}

/// Triangles, and polygons as fans: a plane polygon's fan covers what is inside it once, under either rule.
fn faces(document: &Document) -> Vec<[usize; 3]> {
    let fan = |ring: &Vec<u32>| -> Vec<[usize; 3]> {
        let Some((&first, rest)) = ring.split_first() else { return Vec::new() };
        rest.windows(2).map(|side| [first, side[0], side[1]].map(|v| v as usize)).collect()
    };
    let triangles = document.triangles.iter().map(|corners| corners.map(|v| v as usize));
    triangles.chain(document.polygons.iter().flat_map(fan)).collect()
}

fn rule(inside: Inside) -> Rule {
    match inside {
        Inside::EvenOdd => Rule::EvenOdd,
        Inside::Nonzero => Rule::NonZero,
    }
}

/// None for the rule of area.
fn rule_of_leaves(rule: Leaves) -> Option<LeafRule> {
    match rule {
        Leaves::Inner => Some(LeafRule::Inner),
        Leaves::Outer => Some(LeafRule::Outer),
        Leaves::Centre => Some(LeafRule::Centre),
        Leaves::Area => None,
    }
}
