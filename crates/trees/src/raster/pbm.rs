//! Plain PBM (`P1`): 1 is black, the first row is the uppermost.

use super::Raster;
use crate::CodeFault;

impl Raster<2> {
    /// The picture as plain PBM.
    #[must_use]
    pub fn to_pbm(&self) -> String {
        let side = 1usize << self.depth;
        let mut text = format!("P1\n{side} {side}\n");
        for row in self.inside.chunks(side).rev() {
            text.extend(row.iter().map(|&inside| if inside { '1' } else { '0' }));
            text.push('\n');
        }
        text
    }

    /// The raster of a plain PBM of any size, in the lower left corner of the smallest square of side `2^m` that holds it.
    ///
    /// # Errors
    /// At what is no plain PBM, or if it is too large.
    pub fn from_pbm(text: &str) -> Result<Self, CodeFault> {
        let content: String = text.lines().map(|l| l.split('#').next().unwrap_or("")).fold(
            String::new(),
            |mut all, line| {
                all.push_str(line);
                all.push('\n');
                all
            },
        );
        let rest = content.trim_start().strip_prefix("P1").ok_or(CodeFault::Symbol { at: 0 })?;
        let (width, rest) = number(rest).ok_or(CodeFault::Symbol { at: 1 })?;
        let (height, rest) = number(rest).ok_or(CodeFault::Symbol { at: 2 })?;
        let side = width.max(height).max(1).next_power_of_two();
        let mut raster = Self::white(levels(side))?;
        let mut pixels = rest.chars().filter(|symbol| !symbol.is_whitespace());
        for y in (0..height).rev() {
            for x in 0..width {
                let at = (height - 1 - y) * width + x;
                raster.inside[y * side + x] = match pixels.next() {
                    Some('0') => false,
                    Some('1') => true,
                    Some(_) => return Err(CodeFault::Symbol { at }),
                    None => return Err(CodeFault::Truncated { at }),
                };
            }
        }
        Ok(raster)
    }
}

/// The depth of a raster of this side, a power of two.
fn levels(side: usize) -> u8 {
    u8::try_from(side.trailing_zeros()).expect("words have fewer bits")
}

/// A number of up to `2^14` at the beginning of a text, and the rest.
fn number(text: &str) -> Option<(usize, &str)> {
    let text = text.trim_start();
    let end = text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
    let value: u32 = text[..end].parse().ok().filter(|&value| value <= 1 << 14)?;
    Some((value as usize, &text[end..]))
}
