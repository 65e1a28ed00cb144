//! `delone tree divide`: PR and PM quadtrees, their numbers and pictures.

use delone_draw::{DomainSheet, Panel, Shade};
use delone_trees::{Frame, Leaves, PmRule, PmTree, PrTree};
use serde_json::json;

use super::boundary::{read, segments};
use super::figures::{block, outline};
use super::numbers::tell;
use crate::cli::{By, Divide};
use crate::failure::Failure;
use crate::output;

/// The leaves, which of them are crowded, and how much the fullest holds.
struct Divided {
    leaves: Leaves<2>,
    crowded: usize,
    fullest: usize,
}

pub(super) fn divide(arguments: &Divide) -> Result<(), Failure> {
    output::check_paths(arguments.svg.as_deref())?;
    let document = read(&arguments.source, arguments.voice.quiet)?;
    let points = document.points_2d().map_err(Failure::input)?;
    let frame = Frame::around(points, arguments.depth).map_err(Failure::input)?;
    let segments = segments(&document);
    let pm = |rule| of_pm(&PmTree::new(points, &segments, &frame, rule));
    let divided = match arguments.by {
        By::Pr => {
            let tree = PrTree::new(points, &frame, arguments.capacity).map_err(Failure::input)?;
            Divided {
                leaves: tree.leaves().clone(),
                crowded: tree.crowded().count(),
                fullest: (0..tree.leaves().len()).map(|l| tree.sites(l).len()).max().unwrap_or(0),
            }
        }
        By::Pm1 => pm(PmRule::Pm1),
        By::Pm2 => pm(PmRule::Pm2),
        By::Pm3 => pm(PmRule::Pm3),
    };
    if let Some(path) = &arguments.svg {
        let blocks =
            divided.leaves.cells().map(|cell| block(cell, Shade::White, String::new())).collect();
        let panel = Panel::Blocks { blocks, outline: outline(&document, &frame) };
        let title = format!("{} leaves", divided.leaves.len());
        let caption = format!("{} points, {} segments", points.len(), segments.len());
        let sheet = DomainSheet { title, rows: vec![vec![(caption, panel)]] };
        output::text(path, &sheet.svg())?;
    }
    let object = json!({
        "schema": "delone.tree-divide/1",
        "points": points.len(),
        "segments": segments.len(),
        "leaves": divided.leaves.len(),
        "depth": divided.leaves.cells().map(|cell| cell.level()).max(),
        "crowded": divided.crowded,
        "fullest": divided.fullest,
    });
    tell(&object, arguments.voice.json);
    Ok(())
}

fn of_pm(tree: &PmTree) -> Divided {
    let held = |leaf: usize| tree.vertices(leaf).len().max(tree.edges(leaf).len());
    Divided {
        leaves: tree.leaves().clone(),
        crowded: tree.crowded().len(),
        fullest: (0..tree.leaves().len()).map(held).max().unwrap_or(0),
    }
}
