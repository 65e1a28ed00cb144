//! Texts in outlines: a few glyphs of our own, drawn for a class exercise on alpha shapes.
//!
//! A glyph is one SVG path in units of a thousandth of the letters' size, y down, the baseline at 750: closed rings of lines and cubic
//! Bezier curves, to be filled by the even-odd rule.

use std::fmt;

/// A character without an outline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoGlyph(pub char);

impl fmt::Display for NoGlyph {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "there is no outline of {:?}: only of \" L a r and the blank", self.0)
    }
}

impl std::error::Error for NoGlyph {}

/// The path and the width of a character.
fn glyph(character: char) -> Result<(&'static str, u32), NoGlyph> {
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
        other => return Err(NoGlyph(other)),
    })
}

/// The outlines of a text, as an SVG drawing.
///
/// # Errors
/// If there is no outline of a character.
///
/// ```
/// assert!(delone_workloads::outlines("\"Lar\"").unwrap().starts_with("<svg"));
/// assert!(delone_workloads::outlines("x").is_err());
/// ```
pub fn outlines(text: &str) -> Result<String, NoGlyph> {
    let (mut paths, mut width) = (String::new(), 0);
    for character in text.chars() {
        let (path, advance) = glyph(character)?;
        if !path.is_empty() {
            paths.push_str(&format!("<path transform=\"translate({width} 0)\" d=\"{path}\"/>\n"));
        }
        width += advance;
    }
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} 1000\" fill-rule=\"evenodd\">\n{paths}</svg>\n"
    ))
}
