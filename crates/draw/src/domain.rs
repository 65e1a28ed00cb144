//! Domain trees on one sheet: the cells of a square, the tree above them, cubes of space, codes.
//!
//! All coordinates are of the unit square or cube, y and z upwards; what is not finite is drawn at 0.

mod cubes;
mod hierarchy;

use std::fmt::Write;

use crate::num::real;
use crate::text::{Escaped, Short};

/// White, black or gray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shade {
    /// Outside.
    White,
    /// Inside.
    Black,
    /// Cut.
    Gray,
}

impl Shade {
    fn fill(self) -> &'static str {
        match self {
            Self::White => "#ffffff",
            Self::Black => "#26303a",
            Self::Gray => "#b4bcc6",
        }
    }
}

/// A rectangle.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Its lower left corner.
    pub lower: [f64; 2],
    /// Its upper right corner.
    pub upper: [f64; 2],
    /// Its colour.
    pub shade: Shade,
    /// What is written in it.
    pub label: String,
}

/// A cube.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cube {
    /// Its lower corner.
    pub lower: [f64; 3],
    /// Its side.
    pub side: f64,
}

/// One of the pictures of a sheet.
#[derive(Clone, Debug, PartialEq)]
pub enum Panel {
    /// Cells of the square and what was cut into them.
    Blocks {
        /// The cells.
        blocks: Vec<Block>,
        /// Segments over them.
        outline: Vec<[[f64; 2]; 2]>,
    },
    /// A tree from its depth-first code: gray nodes are followed by their sons.
    Hierarchy {
        /// How many sons a gray node has.
        arity: usize,
        /// The nodes.
        nodes: Vec<Shade>,
    },
    /// Cubes, from back to front: as x and z grow, and y falls.
    Cubes(Vec<Cube>),
    /// Lines of text.
    Text(String),
}

/// Pictures in rows, each under its caption.
///
/// ```
/// use delone_draw::{DomainSheet, Panel, Shade};
///
/// let nodes = vec![Shade::Gray, Shade::Black, Shade::White, Shade::White, Shade::White];
/// let tree = Panel::Hierarchy { arity: 4, nodes };
/// let sheet = DomainSheet { title: "A quarter".into(), rows: vec![vec![("its tree".into(), tree)]] };
/// assert_eq!(sheet.svg().matches("<circle").count(), 1);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DomainSheet {
    /// The heading.
    pub title: String,
    /// The rows, from the top.
    pub rows: Vec<Vec<(String, Panel)>>,
}

/// The side of a square panel in pixels.
const SIDE: f64 = 384.0;
const GAP: f64 = 28.0;
const HEAD: f64 = 48.0;
const CAPTION: f64 = 26.0;
/// Symbols in a line of text, lines of it, and pixels for each.
const SYMBOLS: usize = 128;
const LINES_MAX: usize = 16;
const SYMBOL: f64 = 6.6;
const LINE: f64 = 16.0;

impl DomainSheet {
    /// The sheet as one `<svg>` element.
    #[must_use]
    pub fn svg(&self) -> String {
        let width_of = |row: &Vec<(String, Panel)>| {
            row.iter().map(|(_, panel)| panel.size()[0] + GAP).sum::<f64>() + GAP
        };
        let height_of = |row: &Vec<(String, Panel)>| {
            row.iter().map(|(_, panel)| panel.size()[1]).fold(0.0, f64::max) + CAPTION + GAP
        };
        let width = self.rows.iter().map(width_of).fold(2.0 * GAP, f64::max);
        let height = HEAD + self.rows.iter().map(height_of).sum::<f64>();
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" \
             role=\"img\" font-family=\"sans-serif\"><title>{2}</title>\
             <rect class=\"paper\" width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\
             <text x=\"{GAP}\" y=\"32\" font-size=\"18\" fill=\"#26303a\">{2}</text>",
            Short(width),
            Short(height),
            Escaped(&self.title)
        );
        let mut y = HEAD;
        for row in &self.rows {
            let mut x = GAP;
            for (caption, panel) in row {
                // Writing to a String cannot fail.
                let _ = write!(
                    out,
                    "<g transform=\"translate({} {})\"><text class=\"caption\" y=\"16\" font-size=\"14\" \
                     fill=\"#26303a\">{}</text><g transform=\"translate(0 {CAPTION})\">",
                    Short(x),
                    Short(y),
                    Escaped(caption)
                );
                panel.write(&mut out);
                out.push_str("</g></g>");
                x += panel.size()[0] + GAP;
            }
            y += height_of(row);
        }
        out.push_str("</svg>\n");
        out
    }
}

impl Panel {
    fn size(&self) -> [f64; 2] {
        match self {
            Self::Blocks { .. } | Self::Cubes(_) => [SIDE, SIDE],
            Self::Hierarchy { arity, nodes } => hierarchy::size(*arity, nodes),
            Self::Text(text) => {
                let lines = lines(text);
                let widest = lines.iter().map(|line| line.chars().count()).max().unwrap_or(0);
                [SYMBOL * real(widest), LINE * real(lines.len())]
            }
        }
    }

    fn write(&self, out: &mut String) {
        match self {
            Self::Blocks { blocks, outline } => {
                blocks.iter().for_each(|block| block.write(out));
                write_outline(out, outline);
            }
            Self::Hierarchy { arity, nodes } => hierarchy::write(out, *arity, nodes),
            Self::Cubes(cubes) => cubes::write(out, cubes),
            Self::Text(text) => {
                for (line, y) in lines(text).iter().zip(1..) {
                    let _ = write!(
                        out,
                        "<text y=\"{}\" font-family=\"monospace\" font-size=\"11\" fill=\"#26303a\">{}</text>",
                        Short(LINE * f64::from(y)),
                        Escaped(line)
                    );
                }
            }
        }
    }
}

/// A text broken into lines; where it is cut off, it says so.
fn lines(text: &str) -> Vec<String> {
    let symbols: Vec<char> = text.chars().collect();
    let mut lines: Vec<String> =
        symbols.chunks(SYMBOLS).take(LINES_MAX).map(|line| line.iter().collect()).collect();
    let shown = SYMBOLS * LINES_MAX;
    if symbols.len() > shown {
        lines.push(format!(".. and {} more", symbols.len() - shown));
    }
    lines
}

/// A point of the square in pixels.
fn place([x, y]: [f64; 2]) -> [Short; 2] {
    [Short(SIDE * x), Short(SIDE * (1.0 - y))]
}

impl Block {
    fn write(&self, out: &mut String) {
        let [left, top] = place([self.lower[0], self.upper[1]]);
        let [width, height] = [0, 1].map(|axis| SIDE * (self.upper[axis] - self.lower[axis]));
        let _ = write!(
            out,
            "<rect x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\" fill=\"{}\" stroke=\"#8a97a5\" \
             stroke-width=\"0.6\"/>",
            Short(width),
            Short(height),
            self.shade.fill()
        );
        if !self.label.is_empty() {
            let middle = [0, 1].map(|axis| (self.lower[axis] + self.upper[axis]) / 2.0);
            let [x, y] = place(middle);
            let _ = write!(
                out,
                "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\" text-anchor=\"middle\" \
                 dominant-baseline=\"central\" fill=\"#d55e00\">{}</text>",
                Short((height / 2.0).min(28.0)),
                Escaped(&self.label)
            );
        }
    }
}

fn write_outline(out: &mut String, outline: &[[[f64; 2]; 2]]) {
    if outline.is_empty() {
        return;
    }
    out.push_str(
        "<path class=\"segment\" fill=\"none\" stroke=\"#d55e00\" stroke-width=\"1.4\" d=\"",
    );
    for [a, b] in outline {
        let ([x, y], [to_x, to_y]) = (place(*a), place(*b));
        let _ = write!(out, "M{x} {y}L{to_x} {to_y}");
    }
    out.push_str("\"/>");
}

#[cfg(test)]
mod tests;
