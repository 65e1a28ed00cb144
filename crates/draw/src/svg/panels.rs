//! Several pictures on one sheet, each with a caption.

use std::fmt::Write;

use super::{Picture, Style};
use crate::text::{Escaped, Short};

/// Space for a caption, and between panels.
const CAPTION: f64 = 26.0;

/// One `<svg>` with the pictures in rows of two, in order, each under its caption, which is the title of its style.
///
/// ```
/// use delone_draw::{Picture, Style, panels};
///
/// let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
/// let before = Picture { points: &points, segments: &[[0, 1]], ..Picture::default() };
/// let after = Picture { triangles: &[[0, 1, 2]], ..before };
/// let style = |title: &str| Style { title: title.to_owned(), size: 300.0, ..Style::default() };
/// let sheet = panels(&[(before, style("before")), (after, style("after"))]);
/// assert_eq!(sheet.matches("<svg").count(), 3);
/// ```
#[must_use]
pub fn panels(panels: &[(Picture<'_>, Style)]) -> String {
    let sizes: Vec<[f64; 2]> =
        panels.iter().map(|(picture, style)| super::Layout::of(picture, style).size).collect();
    let wide = sizes.iter().map(|size| size[0]).fold(0.0, f64::max);
    let high = sizes.iter().map(|size| size[1]).fold(0.0, f64::max) + CAPTION;
    let columns = panels.len().min(2);
    let [width, height] =
        [wide * crate::num::real(columns), high * crate::num::real(panels.len().div_ceil(2))]
            .map(Short);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
         height=\"{height}\" role=\"img\" font-family=\"sans-serif\">\
         <rect class=\"paper\" width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>"
    );
    for (place, ((picture, style), size)) in panels.iter().zip(&sizes).enumerate() {
        let left = wide * crate::num::real(place % 2);
        let top = high * crate::num::real(place / 2);
        let (x, y) = (Short(left + wide / 2.0), Short(top + 0.7 * CAPTION));
        // Writing to a String cannot fail.
        let _ = write!(
            out,
            "<text class=\"caption\" x=\"{x}\" y=\"{y}\" text-anchor=\"middle\" font-size=\"15\" fill=\"#26303a\">{}</text>",
            Escaped(&style.title)
        );
        let (x, y) = (Short(left + (wide - size[0]) / 2.0), Short(top + CAPTION));
        let inner = picture.svg(style);
        let inner = inner.trim_end().strip_prefix("<svg").unwrap_or_default();
        let _ = write!(out, "<svg x=\"{x}\" y=\"{y}\"{inner}");
    }
    out.push_str("</svg>\n");
    out
}
