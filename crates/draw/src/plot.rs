//! Curves on logarithmic axes: how a cost grows.

use crate::num::real;
use crate::text::{Escaped, Short};
use std::fmt::Write;

/// One curve.
#[derive(Clone, Debug, Default)]
pub struct Series {
    /// Its name in the legend.
    pub name: String,
    /// Its points, from left to right. Those that are not positive and finite are left out.
    pub points: Vec<[f64; 2]>,
}

/// Curves over the same axes, both of them logarithmic.
#[derive(Clone, Debug, Default)]
pub struct Plot {
    /// The heading.
    pub title: String,
    /// What is counted to the right, and its unit.
    pub across: String,
    /// What is counted upwards, and its unit.
    pub up: String,
    /// The curves.
    pub series: Vec<Series>,
}

const WIDTH: f64 = 560.0;
const HEIGHT: f64 = 380.0;
const LEFT: f64 = 64.0;
const RIGHT: f64 = 150.0;
const TOP: f64 = 40.0;
const BOTTOM: f64 = 48.0;

/// Colours that stay apart for most eyes, in print too (Okabe and Ito).
pub(crate) const COLOURS: [&str; 7] =
    ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#666666"];

impl Series {
    /// The points that a logarithmic axis can show.
    fn shown(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        self.points.iter().copied().filter(|p| p.iter().all(|x| *x > 0.0 && x.is_finite()))
    }

    /// The exponent of the power law that fits best: the slope of the least squares line through the logarithms. `None` for
    /// fewer than two points.
    ///
    /// ```
    /// let points = (1..6).map(|i| 10f64.powi(i)).map(|n| [n, 3.0 * n * n]).collect();
    /// let square = delone_draw::Series { name: "square".into(), points };
    /// assert!((square.exponent().unwrap() - 2.0).abs() < 1e-9);
    /// ```
    #[must_use]
    pub fn exponent(&self) -> Option<f64> {
        let logs: Vec<[f64; 2]> = self.shown().map(|p| p.map(f64::ln)).collect();
        let count = real(logs.len());
        let mean = [0, 1].map(|axis| logs.iter().map(|p| p[axis]).sum::<f64>() / count);
        let moment = |axis: usize| {
            logs.iter().map(|p| (p[0] - mean[0]) * (p[axis] - mean[axis])).sum::<f64>()
        };
        let (run, rise) = (moment(0), moment(1));
        (run > 0.0).then(|| rise / run)
    }
}

impl Plot {
    /// The picture as one `<svg>` element. Grid lines stand at powers of ten.
    #[must_use]
    pub fn svg(&self) -> String {
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" height=\"{HEIGHT}\" \
             role=\"img\" font-family=\"sans-serif\" font-size=\"12\"><title>{0}</title>\
             <rect class=\"paper\" width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"#ffffff\"/>\
             <g class=\"ink\" fill=\"currentColor\"><text x=\"{LEFT}\" y=\"24\" font-size=\"15\">{0}</text>\
             <text x=\"{1}\" y=\"{2}\" text-anchor=\"middle\">{3}</text>\
             <text transform=\"translate(16 {4}) rotate(-90)\" text-anchor=\"middle\">{5}</text>",
            Escaped(&self.title),
            Short(f64::midpoint(LEFT, WIDTH - RIGHT)),
            Short(HEIGHT - 12.0),
            Escaped(&self.across),
            Short(f64::midpoint(TOP, HEIGHT - BOTTOM)),
            Escaped(&self.up),
        );
        let ranges = [0, 1].map(|axis| self.decades(axis));
        for (axis, &range) in ranges.iter().enumerate() {
            grid(&mut out, axis, range);
        }
        out.push_str("</g>");
        for (number, series) in self.series.iter().enumerate() {
            curve(&mut out, series, number, &ranges);
        }
        out.push_str("</svg>\n");
        out
    }

    /// The powers of ten around all points along an axis.
    fn decades(&self, axis: usize) -> [f64; 2] {
        let logs = self.series.iter().flat_map(Series::shown).map(|p| p[axis].log10());
        let [low, high] = logs
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)]);
        if low > high {
            return [0.0, 1.0];
        }
        let (low, high) = (low.floor(), high.ceil());
        [low, high.max(low + 1.0)]
    }
}

/// Where a logarithm along an axis stands on the screen.
fn screen(axis: usize, x: f64, [low, high]: [f64; 2]) -> f64 {
    let t = (x - low) / (high - low);
    if axis == 0 {
        LEFT + t * (WIDTH - RIGHT - LEFT)
    } else {
        HEIGHT - BOTTOM - t * (HEIGHT - BOTTOM - TOP)
    }
}

/// The lines of an axis and their numbers.
fn grid(out: &mut String, axis: usize, range: [f64; 2]) {
    let mut power = range[0];
    while power <= range[1] {
        let at = Short(screen(axis, power, range));
        // Writing to a String cannot fail.
        let _ = if axis == 0 {
            write!(
                out,
                "<path d=\"M{at} {TOP}V{0}\" stroke=\"#888888\" stroke-opacity=\"0.4\"/>\
                 <text x=\"{at}\" y=\"{1}\" text-anchor=\"middle\">1e{power}</text>",
                Short(HEIGHT - BOTTOM),
                Short(HEIGHT - BOTTOM + 16.0),
            )
        } else {
            write!(
                out,
                "<path d=\"M{LEFT} {at}H{0}\" stroke=\"#888888\" stroke-opacity=\"0.4\"/>\
                 <text x=\"{1}\" y=\"{at}\" dy=\"4\" text-anchor=\"end\">1e{power}</text>",
                Short(WIDTH - RIGHT),
                Short(LEFT - 6.0),
            )
        };
        power += 1.0;
    }
}

fn curve(out: &mut String, series: &Series, number: usize, ranges: &[[f64; 2]; 2]) {
    let colour = COLOURS[number % COLOURS.len()];
    let places: Vec<[f64; 2]> = series
        .shown()
        .map(|p| [0, 1].map(|axis| screen(axis, p[axis].log10(), ranges[axis])))
        .collect();
    let _ =
        write!(out, "<g stroke=\"{colour}\" fill=\"{colour}\"><polyline fill=\"none\" points=\"");
    for [x, y] in &places {
        let _ = write!(out, "{},{} ", Short(*x), Short(*y));
    }
    out.push_str("\"/>");
    for [x, y] in &places {
        let _ = write!(out, "<circle cx=\"{}\" cy=\"{}\" r=\"3\"/>", Short(*x), Short(*y));
    }
    let y = TOP + 8.0 + 20.0 * real(number);
    let name = match series.exponent() {
        Some(exponent) => format!("{}, n^{exponent:.2}", series.name),
        None => series.name.clone(),
    };
    let _ = write!(
        out,
        "<circle cx=\"{0}\" cy=\"{1}\" r=\"4\"/></g><text class=\"ink\" fill=\"currentColor\" x=\"{2}\" y=\"{1}\" dy=\"4\">{3}</text>",
        Short(WIDTH - RIGHT + 12.0),
        Short(y),
        Short(WIDTH - RIGHT + 22.0),
        Escaped(&name)
    );
}

#[cfg(test)]
mod tests;
