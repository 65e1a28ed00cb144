//! A tetrahedral mesh in orthographic projection: its boundary shaded, the edges inside as faint wires.
//!
//! **Invariant.** Boundary facets are painted from back to front by the depth of their centroids, which is right for
//! facets of similar size and good enough for others.

use crate::frame::Frame;
use crate::num::{at, byte};
use crate::text::{Escaped, Short};
use std::fmt::Write;

/// What to draw: coordinates and indices into them.
#[derive(Clone, Copy, Debug, Default)]
pub struct Solid<'a> {
    /// Vertices; z points up.
    pub points: &'a [[f64; 3]],
    /// Tetrahedra. A facet of only one of them is boundary.
    pub tets: &'a [[u32; 4]],
    /// Facets drawn as boundary besides, for surfaces without tetrahedra.
    pub facets: &'a [[u32; 3]],
    /// What a screen reader or a hovering mouse says.
    pub title: &'a str,
}

/// Rows of the rotation to right, up, and towards the eye: 35 degrees or so around z, then 20 down.
const VIEW: [[f64; 3]; 3] = [[0.8, 0.6, 0.0], [-0.210, 0.280, 0.9368], [0.5621, -0.7494, 0.350]];
const LIGHT: [f64; 3] = [0.25, 0.55, 0.80];
const SIZE: f64 = 640.0;
const MARGIN: f64 = 16.0;
/// Wires inside are left out beyond this many: they would only be a grey cloud.
const WIRES_MAX: usize = 6_000;

impl Solid<'_> {
    /// The picture as one `<svg>` element.
    #[must_use]
    pub fn svg(&self) -> String {
        let places = self.places();
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {SIZE} {SIZE}\" width=\"{SIZE}\" \
             height=\"{SIZE}\" role=\"img\"><title>{}</title><desc>{} vertices, {} tetrahedra</desc>\
             <rect class=\"paper\" width=\"{SIZE}\" height=\"{SIZE}\" fill=\"#ffffff\"/>",
            Escaped(self.title),
            self.points.len(),
            self.tets.len()
        );
        let boundary = self.boundary();
        self.shade(&mut out, &places, &boundary);
        self.wires(&mut out, &places);
        if boundary.is_empty() {
            dots(&mut out, &places);
        }
        out.push_str("</svg>\n");
        out
    }

    /// Right, down, towards the eye, in pixels: turned inside the unit cube, then fitted to the picture.
    fn places(&self) -> Vec<Option<[f64; 3]>> {
        let frame = Frame::around(self.points);
        let turn = |p: [f64; 3]| {
            let p: [f64; 3] = std::array::from_fn(|i| (p[i] - 0.5) * frame.proportions[i]);
            let [right, up, depth] = VIEW.map(|row| dot(row, p));
            [right, -up, depth]
        };
        let turned: Vec<_> = self.points.iter().map(|&p| frame.unit(p).map(turn)).collect();
        let span = |i: usize| {
            let along = || turned.iter().flatten().map(|p| p[i]);
            (along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max))
        };
        let ((left, right), (top, bottom)) = (span(0), span(1));
        let extent = (right - left).max(bottom - top);
        let scale = (SIZE - 2.0 * MARGIN) / if extent > 0.0 { extent } else { 1.0 };
        let fit = |[x, y, depth]: [f64; 3]| {
            let [x, y] = [x - (left + right) / 2.0, y - (top + bottom) / 2.0];
            [SIZE / 2.0 + scale * x, SIZE / 2.0 + scale * y, scale * depth]
        };
        turned.into_iter().map(|p| p.map(fit)).collect()
    }

    /// Facets of one tetrahedron only, and those given, in order.
    fn boundary(&self) -> Vec<[u32; 3]> {
        let sides = |&[a, b, c, d]: &[u32; 4]| [[a, b, c], [a, b, d], [a, c, d], [b, c, d]];
        let mut all: Vec<[u32; 3]> = self.tets.iter().flat_map(sides).map(sorted).collect();
        all.sort_unstable();
        let mut once: Vec<[u32; 3]> =
            all.chunk_by(|a, b| a == b).filter(|run| run.len() == 1).map(|run| run[0]).collect();
        once.extend(self.facets.iter().copied().map(sorted));
        once.sort_unstable();
        once.dedup();
        once
    }

    fn shade(&self, out: &mut String, places: &[Option<[f64; 3]>], boundary: &[[u32; 3]]) {
        let solid = |facet: &[u32; 3]| {
            let [a, b, c] = facet.map(|v| at(places, v).flatten());
            Some([a?, b?, c?])
        };
        let mut facets: Vec<[[f64; 3]; 3]> = boundary.iter().filter_map(solid).collect();
        let depth = |f: &[[f64; 3]; 3]| f[0][2] + f[1][2] + f[2][2];
        facets.sort_by(|f, g| depth(f).total_cmp(&depth(g)));
        out.push_str("<g class=\"facet\" stroke=\"#3c5878\" stroke-width=\"0.6\" stroke-linejoin=\"round\" fill-opacity=\"0.86\">");
        for facet in &facets {
            let bright = brightness(facet);
            let [red, green, blue] =
                [0.35, 0.5, 0.68].map(|base| byte(base + (0.98 - base) * bright));
            let [a, b, c] = facet;
            let _ = write!(
                out,
                "<path fill=\"#{red:02x}{green:02x}{blue:02x}\" d=\"M{} {}L{} {}L{} {}Z\"/>",
                Short(a[0]),
                Short(a[1]),
                Short(b[0]),
                Short(b[1]),
                Short(c[0]),
                Short(c[1])
            );
        }
        out.push_str("</g>");
    }

    fn wires(&self, out: &mut String, places: &[Option<[f64; 3]>]) {
        let sides = |&[a, b, c, d]: &[u32; 4]| [[a, b], [a, c], [a, d], [b, c], [b, d], [c, d]];
        let mut edges: Vec<[u32; 2]> =
            self.tets.iter().flat_map(sides).map(|[a, b]| [a.min(b), a.max(b)]).collect();
        edges.sort_unstable();
        edges.dedup();
        if edges.len() > WIRES_MAX {
            return;
        }
        out.push_str("<path class=\"wire\" fill=\"none\" stroke=\"#123a7a\" stroke-width=\"0.5\" stroke-opacity=\"0.22\" d=\"");
        for edge in edges {
            if let [Some(p), Some(q)] = edge.map(|v| at(places, v).flatten()) {
                let _ =
                    write!(out, "M{} {}L{} {}", Short(p[0]), Short(p[1]), Short(q[0]), Short(q[1]));
            }
        }
        out.push_str("\"/>");
    }
}

fn dots(out: &mut String, places: &[Option<[f64; 3]>]) {
    out.push_str("<path class=\"site\" fill=\"none\" stroke=\"#26303a\" stroke-width=\"2.4\" stroke-linecap=\"round\" d=\"");
    for [x, y, _] in places.iter().flatten() {
        let _ = write!(out, "M{} {}h0", Short(*x), Short(*y));
    }
    out.push_str("\"/>");
}

/// Lambert's cosine of the side that faces the eye, 0 to 1; 0 for a facet seen edge-on.
fn brightness(&[a, b, c]: &[[f64; 3]; 3]) -> f64 {
    let from_a = |p: [f64; 3]| [p[0] - a[0], a[1] - p[1], p[2] - a[2]];
    let ([u, v, w], [x, y, z]) = (from_a(b), from_a(c));
    let normal = [v * z - w * y, w * x - u * z, u * y - v * x];
    let length = dot(normal, normal).sqrt();
    let facing = if normal[2] < 0.0 { -1.0 } else { 1.0 };
    if length > 0.0 { (facing * dot(normal, LIGHT) / length).clamp(0.0, 1.0) } else { 0.0 }
}

fn dot(p: [f64; 3], q: [f64; 3]) -> f64 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}

fn sorted(mut facet: [u32; 3]) -> [u32; 3] {
    facet.sort_unstable();
    facet
}

#[cfg(test)]
mod tests;
