//! A growing complex of the plane with a slider: one self-contained HTML page, which also plays it as an animation.

use std::fmt::Write;

use crate::svg::{Layout, Picture, Style};
use crate::text::{Escaped, Short};

const SCRIPT: &str = include_str!("slider/slider.js");

/// A complex whose simplices come one rank after the other.
///
/// ```
/// use delone_draw::Slider;
/// let page = Slider {
///     title: "a triangle",
///     points: &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
///     edges: &[[0, 1], [0, 2], [1, 2]],
///     edge_ranks: &[1, 1, 2],
///     triangles: &[[0, 1, 2]],
///     triangle_ranks: &[2],
///     values: &["0".into(), "0.5".into(), "0.707".into()],
///     numbers: &["0, 0".into(), "3, 0".into(), "1, 0".into(), "1, 0".into()],
///     start: 2,
///     figures: &[],
/// };
/// assert!(page.html().contains("<canvas"));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Slider<'a> {
    /// The heading.
    pub title: &'a str,
    /// Vertices; y points up.
    pub points: &'a [[f64; 2]],
    /// Edges; one that names no point is not drawn.
    pub edges: &'a [[u32; 2]],
    /// The rank at which each is there.
    pub edge_ranks: &'a [u32],
    /// Triangles; one that names no point is not drawn.
    pub triangles: &'a [[u32; 3]],
    /// The rank at which each is there.
    pub triangle_ranks: &'a [u32],
    /// What to say of each rank: the radius.
    pub values: &'a [String],
    /// What to say of the complex of so many ranks, from none on.
    pub numbers: &'a [String],
    /// How many ranks are in at first.
    pub start: usize,
    /// Pictures to show below, as `<svg>` elements.
    pub figures: &'a [String],
}

impl Slider<'_> {
    /// The page. It is well-formed XML, too.
    #[must_use]
    pub fn html(&self) -> String {
        let picture = Picture { points: self.points, ..Picture::default() };
        let layout = Layout::of(&picture, &Style::default());
        let [width, height] = layout.size.map(Short);
        let (title, most) = (Escaped(self.title), self.values.len());
        let mut out = format!(
            "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
             <meta name=\"color-scheme\" content=\"light dark\"/>\n<title>{title}</title>\n\
             <style>body {{ font: 16px sans-serif; margin: 1em auto; max-width: 60em }} canvas {{ max-width: 100% }} \
             input {{ width: 100% }}</style>\n</head>\n<body>\n<h1>{title}</h1>\n\
             <canvas id=\"plate\" width=\"{width}\" height=\"{height}\" role=\"img\" aria-label=\"{title}\"></canvas>\n\
             <p><input id=\"cut\" type=\"range\" min=\"0\" max=\"{most}\" value=\"{}\" aria-label=\"rank\"/></p>\n\
             <p><button id=\"play\">play</button> <span id=\"said\"></span></p>\n{}<script>//<![CDATA[\n",
            self.start.min(most),
            self.figures.concat(),
        );
        let places = layout.places.iter().map(|place| {
            place.map_or("null".to_owned(), |[x, y]| format!("[{},{}]", Short(x), Short(y)))
        });
        list(&mut out, "points", places);
        let flat = |ids: &[u32], rank: &u32| {
            let ids: Vec<String> = ids.iter().chain([rank]).map(ToString::to_string).collect();
            format!("[{}]", ids.join(","))
        };
        list(&mut out, "edges", self.edges.iter().zip(self.edge_ranks).map(|(e, r)| flat(e, r)));
        let triangles = self.triangles.iter().zip(self.triangle_ranks);
        list(&mut out, "triangles", triangles.map(|(t, r)| flat(t, r)));
        list(&mut out, "values", self.values.iter().map(|text| quoted(text)));
        list(&mut out, "numbers", self.numbers.iter().map(|text| quoted(text)));
        let _ = write!(out, "{SCRIPT}//]]></script>\n</body>\n</html>\n");
        out
    }
}

/// A constant of the script. (Writing to a String cannot fail.)
fn list(out: &mut String, name: &str, items: impl Iterator<Item = String>) {
    let _ = writeln!(out, "const {name} = [{}];", items.collect::<Vec<_>>().join(","));
}

/// A text that ends neither its quotation marks nor the script.
fn quoted(text: &str) -> String {
    let plain = |c: &char| c.is_alphanumeric() || " .,:;+-/()=".contains(*c);
    format!("\"{}\"", text.chars().filter(plain).collect::<String>())
}

#[cfg(test)]
mod tests;
