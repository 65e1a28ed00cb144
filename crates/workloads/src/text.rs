//! Texts as drawings: a few glyphs in outlines, drawn for a class exercise on alpha shapes, and a stroke font for all of ASCII.
//!
//! An outline is one SVG path in units of a thousandth of a line's height, y down, the baseline at 750: closed rings of lines and cubic
//! Bezier curves, to be filled by the even-odd rule. Strokes are open chains in the same units.

mod strokes;

use std::fmt::{self, Write as _};

/// A character that is not drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoGlyph {
    /// Which.
    pub character: char,
    /// Those that are.
    pub known: &'static str,
}

impl fmt::Display for NoGlyph {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?} is not drawn: only {}", self.character, self.known)
    }
}

impl std::error::Error for NoGlyph {}

/// How the lines of a text stand.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Layout {
    /// Where shorter lines are.
    pub align: Align,
    /// Degrees by which all is turned, counter-clockwise.
    pub angle: f64,
    /// What is put between characters, in thousandths of a line's height.
    pub spacing: u32,
}

/// Where shorter lines are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Align {
    /// On the left.
    #[default]
    Left,
    /// In the middle.
    Centre,
    /// On the right.
    Right,
}

/// The path and the width of a character.
fn outline(character: char) -> Result<(&'static str, u32), NoGlyph> {
    Ok(match character {
        ' ' => ("", 300),
        '"' => ("M60 50H130V300H60ZM210 50H280V300H210Z", 340),
        'L' => ("M80 750H500V660H180V50H80Z", 560),
        'a' => (
            "M470 260V750H380V690C340 740 290 760 240 760C120 760 50 650 50 505C50 360 120 250 240 250\
             C290 250 340 270 380 320V260ZM260 335C180 335 140 410 140 505C140 600 180 675 260 675\
             C340 675 372 600 372 505C372 410 340 335 260 335Z",
            540,
        ),
        'r' => ("M70 750H160V470C160 370 220 330 350 340V250C260 240 190 270 160 330V260H70Z", 400),
        other => return Err(NoGlyph { character: other, known: "\" L a r and the blank" }),
    })
}

/// The outlines of a text, as an SVG drawing.
///
/// # Errors
/// If there is no outline of a character.
///
/// ```
/// use delone_workloads::{Layout, outlines};
/// assert!(outlines("\"Lar\"", &Layout::default()).unwrap().starts_with("<svg"));
/// assert!(outlines("x", &Layout::default()).is_err());
/// ```
pub fn outlines(text: &str, layout: &Layout) -> Result<String, NoGlyph> {
    let glyph = |character| outline(character).map(|(path, width)| (path.to_owned(), width));
    drawing(text, layout, "fill-rule=\"evenodd\"", glyph)
}

/// Columns and rows of the stroke font are so many thousandths of a line's height.
const STEP: u32 = 100;

/// A text in single strokes, as an SVG drawing of open chains.
///
/// # Errors
/// If a character is not printable ASCII.
///
/// ```
/// use delone_workloads::{Layout, strokes};
/// assert!(strokes("V + E = F", &Layout::default()).unwrap().contains("M0 150L200 750L400 150"));
/// ```
pub fn strokes(text: &str, layout: &Layout) -> Result<String, NoGlyph> {
    let glyph = |character| {
        let known = "the printable characters of ASCII are";
        let chains = strokes::chains(character).ok_or(NoGlyph { character, known })?;
        let mut path = String::new();
        for chain in chains {
            for (place, [column, row]) in chain.into_iter().enumerate() {
                let command = if place == 0 { 'M' } else { 'L' };
                let (x, y) = (column * STEP, 950 - row * STEP);
                write!(path, "{command}{x} {y}").expect("a string takes everything");
            }
        }
        Ok((path, 6 * STEP))
    };
    let style = "fill=\"none\" stroke=\"black\" stroke-width=\"40\" stroke-linecap=\"round\"";
    drawing(text, layout, style, glyph)
}

/// The glyphs of all lines, each line a thousand high.
fn drawing(
    text: &str,
    layout: &Layout,
    style: &str,
    glyph: impl Fn(char) -> Result<(String, u32), NoGlyph>,
) -> Result<String, NoGlyph> {
    let mut lines: Vec<(Vec<(String, u32)>, u32)> = Vec::new();
    for line in text.split('\n') {
        let (mut glyphs, mut width) = (Vec::new(), 0);
        for character in line.chars() {
            let (path, advance) = glyph(character)?;
            glyphs.push((path, width));
            width += advance + layout.spacing;
        }
        lines.push((glyphs, width.saturating_sub(layout.spacing)));
    }
    let width = lines.iter().map(|(_, width)| *width).max().unwrap_or(0);
    let mut paths = String::new();
    for ((glyphs, own), y) in lines.iter().zip((0u32..).step_by(1000)) {
        let shift = match layout.align {
            Align::Left => 0,
            Align::Centre => (width - own) / 2,
            Align::Right => width - own,
        };
        for (path, x) in glyphs.iter().filter(|(path, _)| !path.is_empty()) {
            let x = x + shift;
            writeln!(paths, "<path transform=\"translate({x} {y})\" d=\"{path}\"/>")
                .expect("a string takes everything");
        }
    }
    let height = 1000.0 * lines.len() as f64;
    Ok(framed(&paths, [f64::from(width), height], layout.angle, style))
}

/// Paths in a picture that holds them when they are turned.
fn framed(paths: &str, [width, height]: [f64; 2], angle: f64, style: &str) -> String {
    let head = "<svg xmlns=\"http://www.w3.org/2000/svg\"";
    if angle == 0.0 {
        return format!("{head} viewBox=\"0 0 {width} {height}\" {style}>\n{paths}</svg>\n");
    }
    let (sine, cosine) = angle.to_radians().sin_cos();
    let corners = [[0.0, 0.0], [width, 0.0], [0.0, height], [width, height]];
    let turned = corners.map(|[x, y]| [x * cosine + y * sine, y * cosine - x * sine]);
    let least = |axis: usize| turned.iter().map(|p| p[axis]).fold(f64::INFINITY, f64::min);
    let most = |axis: usize| turned.iter().map(|p| p[axis]).fold(f64::NEG_INFINITY, f64::max);
    let [x, y] = [least(0), least(1)];
    let [w, h] = [most(0) - x, most(1) - y];
    format!(
        "{head} viewBox=\"{x} {y} {w} {h}\" {style}>\n<g transform=\"rotate({})\">\n{paths}</g>\n</svg>\n",
        -angle
    )
}

#[cfg(test)]
mod tests;
