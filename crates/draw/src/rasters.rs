//! Fields of small squares, each of a class, side by side.
//!
//! A run of squares of one class in a row is one stroke, and all strokes of a class are one path.

use crate::num::real;
use crate::text::{Escaped, Short};
use std::fmt::Write;

/// One field.
#[derive(Clone, Debug, Default)]
pub struct Raster {
    /// What stands above it.
    pub caption: String,
    /// Squares in a row.
    pub width: usize,
    /// The class of each square, row by row, from the lowest up. One that is not known is left white.
    pub classes: Vec<u8>,
}

/// Fields in rows, with a legend.
#[derive(Clone, Debug, Default)]
pub struct Rasters {
    /// The heading.
    pub title: String,
    /// The name of each class, and its colour as in SVG.
    pub classes: Vec<(String, String)>,
    /// The fields.
    pub rows: Vec<Vec<Raster>>,
}

/// The width of a field in pixels.
const FIELD: f64 = 384.0;
const GAP: f64 = 24.0;
const HEAD: f64 = 72.0;
const CAPTION: f64 = 24.0;

impl Raster {
    fn height(&self) -> usize {
        self.classes.len().div_ceil(self.width.max(1))
    }

    /// The height on the screen.
    fn rise(&self) -> f64 {
        FIELD * real(self.height()) / real(self.width.max(1))
    }

    /// The strokes of one class, in squares.
    fn path(&self, class: u8) -> String {
        let mut path = String::new();
        for (up, row) in self.classes.chunks(self.width.max(1)).enumerate() {
            let mut from = 0;
            for run in row.chunk_by(|a, b| a == b) {
                if run[0] == class {
                    // Writing to a String cannot fail.
                    let _ = write!(path, "M{from} {up}.5h{}", run.len());
                }
                from += run.len();
            }
        }
        path
    }

    fn write(&self, out: &mut String, [x, y]: [f64; 2], colours: &[(String, String)]) {
        let _ = write!(
            out,
            "<text x=\"{}\" y=\"{}\" font-size=\"13\">{}</text>",
            Short(x),
            Short(y + CAPTION - 8.0),
            Escaped(&self.caption)
        );
        let scale = FIELD / real(self.width.max(1));
        let (bottom, rise) = (y + CAPTION + self.rise(), self.rise());
        let _ = write!(
            out,
            "<g transform=\"translate({} {}) scale({scale} -{scale})\" shape-rendering=\"crispEdges\" fill=\"none\">",
            Short(x),
            Short(bottom)
        );
        for (class, (_, colour)) in (0..=u8::MAX).zip(colours) {
            let path = self.path(class);
            if !path.is_empty() {
                let _ = write!(out, "<path stroke=\"{}\" d=\"{path}\"/>", Escaped(colour));
            }
        }
        let _ = write!(
            out,
            "</g><rect x=\"{}\" y=\"{}\" width=\"{FIELD}\" height=\"{}\" fill=\"none\" stroke=\"#888888\"/>",
            Short(x),
            Short(bottom - rise),
            Short(rise)
        );
    }
}

impl Rasters {
    /// The picture as one `<svg>` element.
    ///
    /// ```
    /// use delone_draw::{Raster, Rasters};
    /// let field = Raster { caption: "a step".into(), width: 2, classes: vec![0, 1, 1, 1] };
    /// let classes = vec![("below".into(), "#c00".into()), ("above".into(), "#00c".into())];
    /// let svg = Rasters { title: "Signs".into(), classes, rows: vec![vec![field]] }.svg();
    /// assert!(svg.contains("<path stroke=\"#00c\" d=\"M1 0.5h1M0 1.5h2\"/>"));
    /// ```
    #[must_use]
    pub fn svg(&self) -> String {
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0).max(1);
        let width = real(columns) * (FIELD + GAP) + GAP;
        let rise = |row: &Vec<Raster>| row.iter().map(Raster::rise).fold(0.0, f64::max);
        let height = HEAD + self.rows.iter().map(|row| rise(row) + CAPTION + GAP).sum::<f64>();
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" \
             role=\"img\" font-family=\"sans-serif\"><title>{2}</title>\
             <rect class=\"paper\" width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\
             <text x=\"{GAP}\" y=\"28\" font-size=\"18\">{2}</text>",
            Short(width),
            Short(height),
            Escaped(&self.title)
        );
        self.legend(&mut out);
        let mut y = HEAD;
        for row in &self.rows {
            for (column, raster) in row.iter().enumerate() {
                raster.write(&mut out, [GAP + real(column) * (FIELD + GAP), y], &self.classes);
            }
            y += rise(row) + CAPTION + GAP;
        }
        out.push_str("</svg>\n");
        out
    }

    fn legend(&self, out: &mut String) {
        let mut x = GAP;
        for (name, colour) in &self.classes {
            let _ = write!(
                out,
                "<rect x=\"{0}\" y=\"44\" width=\"14\" height=\"14\" fill=\"{1}\"/>\
                 <text x=\"{2}\" y=\"56\" font-size=\"13\">{3}</text>",
                Short(x),
                Escaped(colour),
                Short(x + 20.0),
                Escaped(name)
            );
            x += 48.0 + 8.0 * real(name.chars().count());
        }
    }
}
