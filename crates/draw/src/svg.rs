//! A planar triangulation as SVG.
//!
//! Colours and strokes are presentation attributes, so the file looks right in any viewer; every group has a class too, by
//! which a report's style sheet recolours it for a dark scheme.

mod exploded;
mod layers;
mod layout;
mod panels;

use crate::frame::Frame;
use crate::text::{Escaped, Short};
pub use exploded::Exploded;
use layers::Layers;
pub(crate) use layout::Layout;
pub use panels::panels;
use std::fmt::Write;
use std::io;

/// What to draw: coordinates and indices into them. All but `points` may be empty.
#[derive(Clone, Copy, Debug, Default)]
pub struct Picture<'a> {
    /// Vertices; y points up.
    pub points: &'a [[f64; 2]],
    /// Triangles, drawn as their edges and, with `classes`, filled.
    pub triangles: &'a [[u32; 3]],
    /// Constraints, drawn strong and dark blue.
    pub segments: &'a [[u32; 2]],
    /// Edges to point at, in red, over everything.
    pub highlights: &'a [[u32; 2]],
    /// Vertices to point at, in red.
    pub marked: &'a [u32],
    /// The number written at each vertex, if not its index.
    pub names: &'a [u32],
    /// One class for each triangle: 0 is left empty, others take turns in a palette of eight.
    pub classes: &'a [u32],
    /// Polygons by their corners, such as the regions of Voronoi's diagram, drawn as outlines. The picture is as large as they
    /// ask for; one with a corner that is not finite is left out.
    pub regions: &'a [Vec<[f64; 2]>],
    /// Arcs of circles.
    pub arcs: &'a [Arc],
}

/// The shorter arc of a circle from one point to another, to the left of the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// Indices of its ends.
    pub ends: [u32; 2],
    /// The circle's radius, at least half the distance of the ends.
    pub radius: f64,
}

/// How to draw it.
#[derive(Clone, Debug)]
pub struct Style {
    /// Length of the longer side in pixels; numbers may enlarge it.
    pub size: f64,
    /// Whether vertices and triangles carry their indices.
    pub numbered: bool,
    /// Whether edges carry their indices too, in the order of their ends.
    pub edges_numbered: bool,
    /// Which vertices get a dot.
    pub dots: Dots,
    /// Whether the axes share a scale.
    pub aspect: Aspect,
    /// Whether the circumcircles are drawn, of triangles for which doubles can say where.
    pub circumcircles: bool,
    /// What a screen reader or a hovering mouse says.
    pub title: String,
}

impl Default for Style {
    fn default() -> Self {
        Self {
            size: 800.0,
            numbered: false,
            edges_numbered: false,
            dots: Dots::Few,
            aspect: Aspect::Auto,
            circumcircles: false,
            title: String::new(),
        }
    }
}

/// Which vertices get a dot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dots {
    /// All of them up to 2,000, and all of them if there are no edges.
    Few,
    /// All.
    All,
    /// None but marked ones.
    None,
}

/// Whether the axes share a scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aspect {
    /// Equal, unless one side is over fifty times the other: then stretched, with a remark.
    Auto,
    /// One scale for both.
    Equal,
    /// Each axis fills its side.
    Stretched,
}

impl Picture<'_> {
    /// The picture as one `<svg>` element.
    #[must_use]
    pub fn svg(&self, style: &Style) -> String {
        let layout = Layout::of(self, style);
        let layers = Layers::new(self, style, &layout);
        let mut out = String::new();
        let [width, height] = layout.size.map(Short);
        // Writing to a String cannot fail.
        let _ = write!(
            out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
             width=\"{width}\" height=\"{height}\" role=\"img\" font-family=\"sans-serif\">"
        );
        if !style.title.is_empty() {
            let _ = write!(out, "<title>{}</title>", Escaped(&style.title));
        }
        let _ = write!(out, "<desc>{}</desc>", Escaped(&self.description(&layout)));
        let _ = write!(
            out,
            "<rect class=\"paper\" width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>"
        );
        layers.write(&mut out);
        out.push_str("</svg>\n");
        out
    }

    /// [`Picture::svg`] into a file or the like.
    ///
    /// # Errors
    /// If writing fails.
    pub fn write_svg(&self, style: &Style, out: &mut impl io::Write) -> io::Result<()> {
        out.write_all(self.svg(style).as_bytes())
    }

    /// All edges of triangles, once each, smaller index first, in order.
    pub(crate) fn edges(&self) -> Vec<[u32; 2]> {
        let sides = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]];
        let mut edges: Vec<[u32; 2]> =
            self.triangles.iter().flat_map(sides).map(|[a, b]| [a.min(b), a.max(b)]).collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    pub(crate) fn frame(&self) -> Frame<2> {
        let corners = self.regions.iter().flatten();
        Frame::around(self.points.iter().chain(corners))
    }

    fn description(&self, layout: &Layout) -> String {
        let mut text = format!(
            "{} vertices, {} triangles, {} segments",
            self.points.len(),
            self.triangles.len(),
            self.segments.len()
        );
        if layout.stretched {
            text.push_str("; axes stretched to be seen");
        }
        let lost = self.left_out(layout);
        if lost > 0 {
            let _ = write!(text, "; {lost} elements left out: index out of range or not finite");
        }
        text
    }

    fn left_out(&self, layout: &Layout) -> usize {
        let bad = |corners: &[u32]| corners.iter().any(|&v| layout.place(v).is_none());
        layout.places.iter().filter(|p| p.is_none()).count()
            + self.triangles.iter().filter(|t| bad(*t)).count()
            + self.segments.iter().chain(self.highlights).filter(|s| bad(*s)).count()
            + self.marked.iter().filter(|&&v| bad(&[v])).count()
            + self.regions.iter().filter(|region| layout.polygon(region).is_none()).count()
    }
}

#[cfg(test)]
mod tests;
