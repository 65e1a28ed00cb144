//! Where each vertex comes to lie on the screen, and how thick things are.

use super::{Aspect, Picture, Style};
use crate::frame::Frame;
use crate::num::{at, real};

const MARGIN: f64 = 14.0;
/// A side is at least this long, so that collinear sites have a picture.
const SIDE_MIN: f64 = 40.0;
/// Median edge that leaves room for a number, and the largest picture that numbers may ask for.
const NUMBERED_EDGE: f64 = 46.0;
const NUMBERED_SIZE_MAX: f64 = 8_000.0;

#[derive(Debug)]
pub(crate) struct Layout {
    /// Width and height of the picture.
    pub(crate) size: [f64; 2],
    /// The screen position of each vertex, y down; None if it has none.
    pub(crate) places: Vec<Option<[f64; 2]>>,
    /// Whether the axes have scales of their own.
    pub(crate) stretched: bool,
    /// Median length on the screen of the edges, or the mean distance of sites if there are none.
    pub(crate) edge: f64,
    frame: Frame<2>,
    /// Pixels that each axis takes.
    lengths: [f64; 2],
}

impl Layout {
    pub(crate) fn of(picture: &Picture<'_>, style: &Style) -> Self {
        let size = if style.size.is_finite() { style.size.clamp(60.0, 20_000.0) } else { 800.0 };
        let first = Self::sized(picture, style, size);
        if !(style.numbered || style.edges_numbered) || first.edge >= NUMBERED_EDGE {
            return first;
        }
        let grown = size * NUMBERED_EDGE / first.edge.max(1e-3);
        Self::sized(picture, style, grown.min(NUMBERED_SIZE_MAX).max(size))
    }

    fn sized(picture: &Picture<'_>, style: &Style, size: f64) -> Self {
        let frame = picture.frame();
        let [wide, high] = frame.proportions;
        let flat = wide.min(high) < 0.02 && frame.is_spread(0) && frame.is_spread(1);
        let stretched = match style.aspect {
            Aspect::Auto => flat,
            Aspect::Equal => false,
            Aspect::Stretched => true,
        };
        let inner = size - 2.0 * MARGIN;
        // Pixels that each axis takes, and the side of the picture that holds it in its middle.
        let lengths = if stretched { [inner, 0.62 * inner] } else { [inner * wide, inner * high] };
        let sides = lengths.map(|length| length.max(SIDE_MIN) + 2.0 * MARGIN);
        let mut layout =
            Self { size: sides, places: Vec::new(), stretched, edge: 0.0, frame, lengths };
        layout.places = picture.points.iter().map(|&p| layout.screen(p)).collect();
        layout.edge = typical_edge(picture, &layout.places, lengths);
        layout
    }

    /// Where a point comes to lie on the screen.
    fn screen(&self, p: [f64; 2]) -> Option<[f64; 2]> {
        let ([x, y], [wide, high]) = (self.frame.unit(p)?, self.lengths);
        Some([self.size[0] / 2.0 + (x - 0.5) * wide, self.size[1] / 2.0 - (y - 0.5) * high])
    }

    /// The same for all corners of a polygon.
    pub(crate) fn polygon(&self, corners: &[[f64; 2]]) -> Option<Vec<[f64; 2]>> {
        corners.iter().map(|&p| self.screen(p)).collect()
    }

    /// Pixels that each axis takes, in the middle of the picture.
    pub(crate) const fn lengths(&self) -> [f64; 2] {
        self.lengths
    }

    pub(crate) fn place(&self, v: u32) -> Option<[f64; 2]> {
        at(&self.places, v).flatten()
    }

    /// Thin edges, thinner the closer they are.
    pub(crate) fn thin(&self) -> f64 {
        (self.edge / 24.0).clamp(0.25, 1.0)
    }

    pub(crate) fn dot(&self) -> f64 {
        (self.edge / 12.0).clamp(0.6, 3.0)
    }

    pub(crate) fn font(&self) -> f64 {
        (self.edge / 4.0).clamp(8.0, 15.0)
    }
}

fn typical_edge(picture: &Picture<'_>, places: &[Option<[f64; 2]>], sides: [f64; 2]) -> f64 {
    let between = |s: [u32; 2]| {
        let [p, q] = s.map(|v| at(places, v).flatten());
        let ([a, b], [c, d]) = (p?, q?);
        Some(((c - a) * (c - a) + (d - b) * (d - b)).sqrt())
    };
    let sides_of = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]];
    let mut lengths: Vec<f64> =
        picture.triangles.iter().flat_map(sides_of).filter_map(between).collect();
    if lengths.is_empty() {
        lengths = picture.segments.iter().filter_map(|&s| between(s)).collect();
    }
    let spread = (sides[0].max(1.0) * sides[1].max(1.0) / real(places.len().max(1))).sqrt();
    if lengths.is_empty() {
        return spread;
    }
    let middle = lengths.len() / 2;
    let (_, &mut median, _) = lengths.select_nth_unstable_by(middle, f64::total_cmp);
    // A few long segments among many sites say nothing of the room that there is.
    if picture.triangles.is_empty() { median.min(spread) } else { median }
}
