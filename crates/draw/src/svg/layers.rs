//! The layers of a picture, from the fills below to the numbers on top.

use super::{Arc, Dots, Layout, Picture, Style};
use crate::text::Short;
use std::fmt::Write;

/// Fills of classes 1, 2, ..: pale enough for edges and numbers to be read on them.
pub(crate) const PALETTE: [&str; 8] =
    ["#cfe3f5", "#fbe3c0", "#d5ecd0", "#f6d3d3", "#e2d8f0", "#ece3d8", "#f8d9ea", "#d3eeee"];

/// Writes a picture's layers.
pub(super) struct Layers<'a> {
    picture: &'a Picture<'a>,
    style: &'a Style,
    layout: &'a Layout,
}

impl<'a> Layers<'a> {
    pub(super) fn new(picture: &'a Picture<'a>, style: &'a Style, layout: &'a Layout) -> Self {
        Self { picture, style, layout }
    }

    pub(super) fn write(&self, out: &mut String) {
        self.fills(out);
        let thin = self.layout.thin();
        self.regions(out, (1.4 * thin).max(0.5));
        if self.style.circumcircles {
            self.circumcircles(out);
        }
        let (edges, layout) = (self.picture.edges(), self.layout);
        lines(out, layout, &edges, "edge", "#98a2ad", thin);
        let strong = (2.2 * thin).max(0.8);
        lines(out, layout, self.picture.segments, "segment", "#123a7a", strong);
        lines(out, layout, self.picture.highlights, "highlight", "#d3222a", 1.3 * strong);
        self.arcs(out, strong);
        self.dots(out);
        if self.style.edges_numbered {
            self.edge_numbers(out, &edges);
        }
        if self.style.numbered {
            self.numbers(out);
        }
    }

    fn corners(&self, triangle: [u32; 3]) -> Option<[[f64; 2]; 3]> {
        let [a, b, c] = triangle.map(|v| self.layout.place(v));
        Some([a?, b?, c?])
    }

    fn fills(&self, out: &mut String) {
        let mut by_turn = vec![String::new(); PALETTE.len()];
        for (&triangle, &class) in self.picture.triangles.iter().zip(self.picture.classes) {
            let turn = class.checked_sub(1).and_then(|c| usize::try_from(c).ok());
            if let (Some(turn), Some([a, b, c])) = (turn, self.corners(triangle)) {
                let d = &mut by_turn[turn % PALETTE.len()];
                let _ =
                    write!(d, "M{} {}L{} {}", Short(a[0]), Short(a[1]), Short(b[0]), Short(b[1]));
                let _ = write!(d, "L{} {}Z", Short(c[0]), Short(c[1]));
            }
        }
        for (turn, d) in by_turn.iter().enumerate().filter(|(_, d)| !d.is_empty()) {
            let colour = PALETTE[turn];
            let _ = write!(out, "<path class=\"fill fill{turn}\" fill=\"{colour}\" d=\"{d}\"/>");
        }
    }

    fn regions(&self, out: &mut String, width: f64) {
        let mut d = String::new();
        for region in self.picture.regions {
            let Some(corners) = self.layout.polygon(region) else { continue };
            for (i, &[x, y]) in corners.iter().enumerate() {
                let _ = write!(d, "{}{} {}", if i == 0 { 'M' } else { 'L' }, Short(x), Short(y));
            }
            d.push('Z');
        }
        if d.is_empty() {
            return;
        }
        let _ = write!(
            out,
            "<path class=\"region\" fill=\"none\" stroke=\"#b8642b\" stroke-width=\"{}\" \
             stroke-linejoin=\"round\" d=\"{d}\"/>",
            Short(width)
        );
    }

    fn circumcircles(&self, out: &mut String) {
        out.push_str("<g class=\"circle\" fill=\"none\" stroke=\"#3f9d6b\" stroke-width=\"0.6\" opacity=\"0.7\">");
        let reach = 4.0 * self.layout.size[0].max(self.layout.size[1]);
        for &triangle in self.picture.triangles {
            // A circle drawn on stretched axes would be a lie: it is an ellipse there, and left out.
            let Some(corners) = self.corners(triangle).filter(|_| !self.layout.stretched) else {
                continue;
            };
            let ([x, y], r) = circumcircle(corners);
            if r < reach {
                let (x, y, r) = (Short(x), Short(y), Short(r));
                let _ = write!(out, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>");
            }
        }
        out.push_str("</g>");
    }

    /// Left out on stretched axes, as circles are ellipses there. The screen's length of a chord says how long a radius is.
    fn arcs(&self, out: &mut String, width: f64) {
        let mut d = String::new();
        for &Arc { ends, radius } in self.picture.arcs {
            let point = |v: u32| usize::try_from(v).ok().and_then(|v| self.picture.points.get(v));
            let ([Some(p), Some(q)], [Some(from), Some(to)]) =
                (ends.map(point), ends.map(|v| self.layout.place(v)))
            else {
                continue;
            };
            let chord = |p: [f64; 2], q: [f64; 2]| (q[0] - p[0]).hypot(q[1] - p[1]);
            let scaled = radius / chord(*p, *q) * chord(from, to);
            if self.layout.stretched || !scaled.is_finite() {
                continue;
            }
            let (r, [x, y], [u, v]) = (Short(scaled), from.map(Short), to.map(Short));
            let _ = write!(d, "M{x} {y}A{r} {r} 0 0 1 {u} {v}");
        }
        if !d.is_empty() {
            let _ = write!(
                out,
                "<path class=\"arc\" fill=\"none\" stroke=\"#b8642b\" stroke-width=\"{}\" d=\"{d}\"/>",
                Short(width)
            );
        }
    }

    fn dots(&self, out: &mut String) {
        let picture = self.picture;
        let bare = picture.triangles.is_empty() && picture.segments.is_empty();
        let all = match self.style.dots {
            Dots::Few => bare || picture.points.len() <= 2_000,
            Dots::All => true,
            Dots::None => false,
        };
        let r = self.layout.dot();
        if all {
            dots(out, self.layout.places.iter().flatten(), "site", "#26303a", r);
        }
        let marked: Vec<_> = picture.marked.iter().filter_map(|&v| self.layout.place(v)).collect();
        dots(out, marked.iter(), "marked", "#d3222a", 1.8 * r);
    }

    /// Numbers of edges at their middles, with a halo of paper.
    fn edge_numbers(&self, out: &mut String, edges: &[[u32; 2]]) {
        let size = 0.8 * self.layout.font();
        let _ = write!(
            out,
            "<g class=\"edgenumber\" font-size=\"{}\" fill=\"#2c7a4b\" stroke=\"#ffffff\" stroke-width=\"3\" \
             paint-order=\"stroke\" text-anchor=\"middle\">",
            Short(size)
        );
        for (i, &edge) in edges.iter().enumerate() {
            if let [Some(p), Some(q)] = edge.map(|v| self.layout.place(v)) {
                let (x, y) = (Short((p[0] + q[0]) / 2.0), Short((p[1] + q[1]) / 2.0 + 0.35 * size));
                let _ = write!(out, "<text x=\"{x}\" y=\"{y}\">{i}</text>");
            }
        }
        out.push_str("</g>");
    }

    /// Numbers of triangles at their centroids, of vertices up and right of them with a halo of paper.
    fn numbers(&self, out: &mut String) {
        let size = self.layout.font();
        let font = Short(0.85 * size);
        let _ = write!(
            out,
            "<g class=\"cellnumber\" font-size=\"{font}\" fill=\"#8a6d1f\" text-anchor=\"middle\">"
        );
        for (i, &triangle) in self.picture.triangles.iter().enumerate() {
            if let Some([a, b, c]) = self.corners(triangle) {
                let [x, y] = [(a[0] + b[0] + c[0]) / 3.0, (a[1] + b[1] + c[1]) / 3.0];
                let (x, y) = (Short(x), Short(y + 0.3 * size));
                let _ = write!(out, "<text x=\"{x}\" y=\"{y}\">{i}</text>");
            }
        }
        let _ = write!(
            out,
            "</g><g class=\"sitenumber\" font-size=\"{}\" font-weight=\"bold\" fill=\"#123a7a\" stroke=\"#ffffff\" \
             stroke-width=\"3\" paint-order=\"stroke\">",
            Short(size)
        );
        for (i, place) in self.layout.places.iter().enumerate() {
            if let Some([x, y]) = *place {
                // Left of the dot where the right edge of the picture is near.
                let near_edge = x + 3.0 * size > self.layout.size[0];
                let (step, anchor) =
                    if near_edge { (-4.0, " text-anchor=\"end\"") } else { (4.0, "") };
                let (x, y) = (Short(x + step), Short((y - 4.0).max(size)));
                let given = self.picture.names.get(i).and_then(|&name| usize::try_from(name).ok());
                let name = given.unwrap_or(i);
                let _ = write!(out, "<text x=\"{x}\" y=\"{y}\"{anchor}>{name}</text>");
            }
        }
        out.push_str("</g>");
    }
}

fn lines(
    out: &mut String,
    layout: &Layout,
    edges: &[[u32; 2]],
    class: &str,
    colour: &str,
    width: f64,
) {
    let mut d = String::new();
    for &edge in edges {
        if let [Some(p), Some(q)] = edge.map(|v| layout.place(v)) {
            let _ = write!(d, "M{} {}L{} {}", Short(p[0]), Short(p[1]), Short(q[0]), Short(q[1]));
        }
    }
    if !d.is_empty() {
        let width = Short(width);
        let _ = write!(
            out,
            "<path class=\"{class}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\" \
             stroke-linecap=\"round\" d=\"{d}\"/>"
        );
    }
}

/// Dots as strokes of length zero with round caps: one path for all.
fn dots<'p>(
    out: &mut String,
    places: impl Iterator<Item = &'p [f64; 2]>,
    class: &str,
    colour: &str,
    r: f64,
) {
    let mut d = String::new();
    for &[x, y] in places {
        let _ = write!(d, "M{} {}h0", Short(x), Short(y));
    }
    if !d.is_empty() {
        let width = Short(2.0 * r);
        let _ = write!(
            out,
            "<path class=\"{class}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\" \
             stroke-linecap=\"round\" d=\"{d}\"/>"
        );
    }
}

/// Centre and radius in doubles, on the screen; the radius is infinite or NaN where doubles cannot say.
fn circumcircle([a, b, c]: [[f64; 2]; 3]) -> ([f64; 2], f64) {
    let ([u, v], [s, t]) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let area = 2.0 * (u * t - v * s);
    let (p, q) = (u * u + v * v, s * s + t * t);
    let [x, y] = [(t * p - v * q) / area, (u * q - s * p) / area];
    ([a[0] + x, a[1] + y], (x * x + y * y).sqrt())
}
