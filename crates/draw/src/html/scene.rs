//! A triangulation to look into: layers to switch, and steps to go through, drawn by `scene.js`.
//!
//! Everything in a scene exists from one step until another, so that any step is drawn by looking once at each thing.

use super::base64::encode;
use crate::num::single;
use crate::svg::{Layout, Picture, Style};
use crate::text::Escaped;
use std::fmt::Write;

/// A thing of a scene, by its corners, with the step at which it appears and that at which it is gone again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Span<const N: usize> {
    /// Its corners.
    pub corners: [u32; N],
    /// The first step at which it is there.
    pub from: u32,
    /// The first step at which it is not there any more.
    pub until: u32,
}

impl<const N: usize> Span<N> {
    /// There at all steps.
    #[must_use]
    pub const fn always(corners: [u32; N]) -> Self {
        Self { corners, from: 0, until: u32::MAX }
    }
}

/// What happens at a step.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Step {
    /// One line.
    pub title: String,
    /// More lines: what was asked, and answered.
    pub detail: String,
    /// Vertices to point at.
    pub marked: Vec<u32>,
}

/// What is drawn, in layers. Indices out of range, and points that are not finite, are left out.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// Sites.
    pub points: Vec<[f64; 2]>,
    /// Triangles, with their edges and circumcircles.
    pub triangles: Vec<Span<3>>,
    /// Constraints.
    pub constraints: Vec<Span<2>>,
    /// Hull edges, counter-clockwise: a ghost triangle lies beyond each.
    pub ghosts: Vec<Span<2>>,
    /// Edges that are not Delaunay.
    pub forced: Vec<Span<2>>,
    /// Edges of no triangle.
    pub wires: Vec<Span<2>>,
    /// What happens; a scene that does not move has none.
    pub steps: Vec<Step>,
}

const LAYERS: [(&str, &str, bool); 6] = [
    ("sites", "sites", true),
    ("edges", "edges", true),
    ("constraints", "constraints", true),
    ("circles", "circumcircles", false),
    ("forced", "edges that are not Delaunay", true),
    ("ghosts", "ghosts", false),
];

impl Scene {
    /// Writes the figure but for its caption and end.
    pub(super) fn write(&self, out: &mut String, number: usize, style: &Style) {
        let picture = Picture { points: &self.points, ..Picture::default() };
        let layout = Layout::of(&picture, style);
        let ([width, height], [long, tall]) = (layout.size, layout.lengths());
        let title = if style.title.is_empty() { "triangulation" } else { &style.title };
        // Writing to a String cannot fail.
        let _ =
            write!(out, "<figure class=\"scene\" id=\"scene{number}\"><div class=\"controls\">");
        for (name, text, on) in LAYERS {
            let checked = if on { " checked=\"checked\"" } else { "" };
            let _ = write!(
                out,
                "<label><input type=\"checkbox\" data-layer=\"{name}\"{checked}/> {text}</label> "
            );
        }
        if !self.steps.is_empty() {
            self.write_steps(out);
        }
        let _ = write!(
            out,
            "</div><div class=\"plate\"><canvas tabindex=\"0\" role=\"img\" aria-label=\"{}\" data-width=\"{width:.0}\" \
             data-height=\"{height:.0}\" data-lengths=\"{long} {tall}\" data-box=\"{}\"></canvas>\
             <div class=\"hint\">drag to move, wheel to zoom, double click to reset</div></div>\
             <output class=\"state\"></output><pre class=\"detail\"></pre>",
            Escaped(title),
            self.window(),
        );
        let places = layout.places.iter().map(|p| p.unwrap_or([f64::NAN; 2]));
        data(out, "points", places.flatten().flat_map(|x| single(x).to_le_bytes()));
        self.spans(out, "triangles", &self.triangles, &layout);
        self.spans(out, "constraints", &self.constraints, &layout);
        self.spans(out, "ghosts", &self.ghosts, &layout);
        self.spans(out, "forced", &self.forced, &layout);
        self.spans(out, "wires", &self.wires, &layout);
        data(out, "steps", self.told().into_bytes().into_iter());
    }

    fn write_steps(&self, out: &mut String) {
        let last = self.steps.len() - 1;
        let _ = write!(
            out,
            "<span class=\"steps\"><button type=\"button\" data-go=\"first\">|&lt;</button>\
             <button type=\"button\" data-go=\"back\">&lt;</button>\
             <input type=\"range\" min=\"0\" max=\"{last}\" value=\"{last}\" aria-label=\"step\"/>\
             <button type=\"button\" data-go=\"next\">&gt;</button>\
             <button type=\"button\" data-go=\"play\">play</button></span>"
        );
    }

    /// The points' box: low and high of x, then of y.
    fn window(&self) -> String {
        let mut bounds = [f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY];
        for p in self.points.iter().filter(|p| p.iter().all(|x| x.is_finite())) {
            for axis in 0..2 {
                bounds[2 * axis] = bounds[2 * axis].min(p[axis]);
                bounds[2 * axis + 1] = bounds[2 * axis + 1].max(p[axis]);
            }
        }
        bounds.map(|x| if x.is_finite() { format!("{x:e}") } else { "0".to_owned() }).join(" ")
    }

    fn spans<const N: usize>(
        &self,
        out: &mut String,
        name: &str,
        spans: &[Span<N>],
        layout: &Layout,
    ) {
        let seen = |span: &&Span<N>| span.corners.iter().all(|&v| layout.place(v).is_some());
        let words = spans
            .iter()
            .filter(seen)
            .flat_map(|span| span.corners.into_iter().chain([span.from, span.until]));
        data(out, name, words.flat_map(u32::to_le_bytes));
    }

    /// Steps as lines: title, marked vertices, details, each ended by a control character that no text holds.
    fn told(&self) -> String {
        let plain = |text: &str| text.replace(|c: char| c.is_control() && c != '\n', " ");
        let step = |step: &Step| {
            let marked: Vec<String> = step.marked.iter().map(ToString::to_string).collect();
            [plain(&step.title), marked.join(" "), plain(&step.detail)].join("\u{1f}")
        };
        self.steps.iter().map(step).collect::<Vec<_>>().join("\u{1e}")
    }
}

fn data(out: &mut String, name: &str, bytes: impl Iterator<Item = u8>) {
    let bytes: Vec<u8> = bytes.collect();
    let text = encode(&bytes);
    let _ = write!(
        out,
        "<script type=\"application/octet-stream\" data-name=\"{name}\">{text}</script>"
    );
}
