//! A tree with its root on top: leaves at equal distances, each gray node above the middle of its sons.

use std::fmt::Write;

use super::Shade;
use crate::num::real;
use crate::text::Short;

/// Pixels between levels, between leaves, and the widest tree's width: beyond that leaves move closer.
const LEVEL: f64 = 56.0;
const LEAF: f64 = 16.0;
const WIDTH_MAX: f64 = 1600.0;
const NODE: f64 = 6.0;

/// A node: how deep, how far right in leaves, whose son.
struct Place {
    level: usize,
    across: f64,
    father: Option<usize>,
}

fn leaves(nodes: &[Shade]) -> f64 {
    real(nodes.iter().filter(|&&shade| shade != Shade::Gray).count().max(1))
}

/// Pixels for a leaf.
fn pitch(nodes: &[Shade]) -> f64 {
    LEAF.min(WIDTH_MAX / leaves(nodes))
}

/// Places of nodes in depth-first order; nodes after the tree's end are left out.
fn places(arity: usize, nodes: &[Shade]) -> Vec<Place> {
    let mut places: Vec<Place> = Vec::new();
    let mut pending = vec![(0, None)];
    let mut next = 0.0;
    for &shade in nodes {
        let Some((level, father)) = pending.pop() else { break };
        let across = if shade == Shade::Gray { 0.0 } else { next };
        if shade == Shade::Gray {
            pending.extend((0..arity).map(|_| (level + 1, Some(places.len()))));
        } else {
            next += 1.0;
        }
        places.push(Place { level, across, father });
    }
    // Sons come after their father: in the middle of the first and the last.
    let mut spans = vec![[f64::INFINITY, f64::NEG_INFINITY]; places.len()];
    for at in (0..places.len()).rev() {
        if spans[at][0] <= spans[at][1] {
            places[at].across = f64::midpoint(spans[at][0], spans[at][1]);
        }
        if let Some(father) = places[at].father {
            let across = places[at].across;
            spans[father] = [spans[father][0].min(across), spans[father][1].max(across)];
        }
    }
    places
}

pub(super) fn size(arity: usize, nodes: &[Shade]) -> [f64; 2] {
    let deepest = places(arity, nodes).iter().map(|place| place.level).max().unwrap_or(0);
    [pitch(nodes) * leaves(nodes) + 2.0 * NODE, LEVEL * real(deepest) + 2.0 * NODE]
}

pub(super) fn write(out: &mut String, arity: usize, nodes: &[Shade]) {
    let places = places(arity, nodes);
    let pitch = pitch(nodes);
    let radius = NODE.min(0.45 * pitch);
    let at = |place: &Place| {
        [NODE + pitch * (place.across + 0.5), NODE + LEVEL * real(place.level)].map(Short)
    };
    out.push_str("<path fill=\"none\" stroke=\"#8a97a5\" stroke-width=\"0.8\" d=\"");
    for place in &places {
        if let Some(father) = place.father {
            let ([x, y], [to_x, to_y]) = (at(&places[father]), at(place));
            let _ = write!(out, "M{x} {y}L{to_x} {to_y}");
        }
    }
    out.push_str("\"/>");
    for (place, shade) in places.iter().zip(nodes) {
        let ([x, y], fill) = (at(place), shade.fill());
        let _ = match shade {
            Shade::Gray => write!(
                out,
                "<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\" fill=\"{fill}\" stroke=\"#26303a\" stroke-width=\"0.6\"/>",
                Short(radius)
            ),
            Shade::White | Shade::Black => write!(
                out,
                "<rect x=\"{}\" y=\"{}\" width=\"{2}\" height=\"{2}\" fill=\"{fill}\" stroke=\"#26303a\" \
                 stroke-width=\"0.6\"/>",
                Short(x.0 - radius),
                Short(y.0 - radius),
                Short(2.0 * radius)
            ),
        };
    }
}
