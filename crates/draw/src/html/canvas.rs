//! Large pictures: coordinates and indices as base64 of little-endian arrays, drawn by `report.js`.

use super::base64::encode;
use crate::num::{at, single};
use crate::svg::{Layout, Picture, Style};
use crate::text::Escaped;
use std::fmt::Write;

/// Opens a figure with its canvas and data; the caller adds the caption and closes it.
pub(super) fn write(
    out: &mut String,
    number: usize,
    picture: &Picture<'_>,
    edges: &[[u32; 2]],
    style: &Style,
) {
    let layout =
        Layout::of(picture, &Style { numbered: false, edges_numbered: false, ..style.clone() });
    let [width, height] = layout.size;
    // Writing to a String cannot fail.
    let _ = write!(
        out,
        "<figure><div class=\"plate\"><canvas class=\"mesh\" id=\"mesh{number}\" tabindex=\"0\" role=\"img\" \
         aria-label=\"{}\" data-width=\"{width:.0}\" data-height=\"{height:.0}\"></canvas>\
         <div class=\"hint\">drag to move, wheel to zoom, double click to reset</div></div>",
        Escaped(if style.title.is_empty() { "mesh" } else { &style.title })
    );
    // Vertices without a place sit at the origin; edges to them were filtered out.
    let places = layout.places.iter().map(|p| p.unwrap_or([0.0, 0.0]));
    data(out, "points", places.flatten().flat_map(|x| single(x).to_le_bytes()));
    pairs(out, "edges", &layout, edges);
    pairs(out, "segments", &layout, picture.segments);
    pairs(out, "highlights", &layout, picture.highlights);
    if !picture.classes.is_empty() {
        triangles(out, &layout, picture);
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

fn pairs(out: &mut String, name: &str, layout: &Layout, edges: &[[u32; 2]]) {
    let good = edges.iter().filter(|s| s.iter().all(|&v| layout.place(v).is_some()));
    data(out, name, good.flatten().flat_map(|v| v.to_le_bytes()));
}

/// Filled triangles as quadruples: turn in the palette, then the corners.
fn triangles(out: &mut String, layout: &Layout, picture: &Picture<'_>) {
    let filled = picture.triangles.iter().zip(0_u32..).filter_map(|(corners, i)| {
        let turn = at(picture.classes, i)?.checked_sub(1)? % 8;
        let there = corners.iter().all(|&v| layout.place(v).is_some());
        there.then(|| [turn, corners[0], corners[1], corners[2]])
    });
    data(out, "fills", filled.flatten().flat_map(u32::to_le_bytes));
}
