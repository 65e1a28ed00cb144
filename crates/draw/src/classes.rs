//! What lives how long in a growing complex: bars and points of persistent homology, and Betti numbers, over one logarithmic axis.
//!
//! Radii that are not positive stand at the left (or lower) edge, marked `0`; what never dies runs into the other edge.

use std::fmt::Write;

use crate::num::real;
use crate::plot::COLOURS;
use crate::text::{Escaped, Short};

/// A class of homology that lives for a while.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Class {
    /// Its dimension.
    pub dimension: usize,
    /// The radius at which it is there.
    pub birth: f64,
    /// The radius at which it is gone.
    pub death: Option<f64>,
}

const LEFT: f64 = 48.0;
const TOP: f64 = 44.0;
const SIDE: f64 = 400.0;
const BOTTOM: f64 = 48.0;
/// More bars than these could not be told apart; the longest are kept.
const BARS_MAX: usize = 200;
const POINTS_MAX: usize = 5_000;

/// A logarithmic axis.
#[derive(Clone, Copy, Debug)]
struct Axis {
    low: f64,
    high: f64,
}

impl Axis {
    /// Around the positive ones of some values, with a little room.
    fn around(values: impl Iterator<Item = f64>) -> Self {
        let logs = values.filter(|x| *x > 0.0 && x.is_finite()).map(f64::log10);
        let (low, high) =
            logs.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        if low > high {
            return Self { low: 0.0, high: 1.0 };
        }
        let room = ((high - low) / 12.0).max(0.1);
        Self { low: low - room, high: high + room }
    }

    /// Where a value stands, from 0 to 1.
    fn place(self, value: f64) -> f64 {
        let log = if value > 0.0 { value.log10() } else { f64::NEG_INFINITY };
        ((log - self.low) / (self.high - self.low)).clamp(0.0, 1.0)
    }

    /// Powers of ten on it, at most nine, and where they stand.
    fn ticks(self) -> Vec<(f64, f64)> {
        let step = ((self.high - self.low) / 8.0).ceil().max(1.0);
        let mut ticks = Vec::new();
        let mut power = (self.low / step).ceil() * step;
        while power <= self.high {
            ticks.push((power, (power - self.low) / (self.high - self.low)));
            power += step;
        }
        ticks
    }
}

/// The bars of classes and, beside them, their diagram: birth to the right, death upwards. A colour for each dimension.
///
/// ```
/// use delone_draw::{Class, barcode};
/// let ring = [Class { dimension: 0, birth: 0.0, death: None }, Class { dimension: 1, birth: 0.5, death: Some(3.0) }];
/// assert_eq!(barcode("a ring", &ring).matches("class=\"bar\"").count(), 2);
/// ```
#[must_use]
pub fn barcode(title: &str, classes: &[Class]) -> String {
    let values = classes.iter().flat_map(|class| [Some(class.birth), class.death]).flatten();
    let axis = Axis::around(values);
    let length = |class: &Class| {
        class.death.map_or(2.0, |death| axis.place(death)) - axis.place(class.birth)
    };
    let mut kept = classes.to_vec();
    kept.sort_by(|a, b| length(b).total_cmp(&length(a)));
    let points = kept[..kept.len().min(POINTS_MAX)].to_vec();
    // As many of each dimension: all components are born early, and would leave nothing to the others.
    let dimensions = classes.iter().map(|class| class.dimension + 1).max().unwrap_or(1);
    let mut left = vec![BARS_MAX.div_ceil(dimensions); dimensions];
    kept.retain(|class| {
        let is_kept = left[class.dimension] > 0;
        left[class.dimension] -= usize::from(is_kept);
        is_kept
    });
    kept.sort_by(|a, b| {
        let end = |class: &Class| class.death.unwrap_or(f64::INFINITY);
        let by_birth = a.birth.total_cmp(&b.birth).then(end(a).total_cmp(&end(b)));
        a.dimension.cmp(&b.dimension).then(by_birth)
    });
    let gap = 72.0;
    let mut out = head(title, LEFT + 2.0 * SIDE + gap + 24.0);
    let said = if kept.len() < classes.len() {
        format!("the {} longest of {} bars; radius", kept.len(), classes.len())
    } else {
        "bars; radius".to_owned()
    };
    frame(&mut out, LEFT, &said, axis);
    bars(&mut out, axis, &kept);
    let x = LEFT + SIDE + gap;
    frame(&mut out, x, "diagram: birth", axis);
    diagram(&mut out, x, axis, &points);
    legend(&mut out, x + 12.0, classes.iter().map(|class| class.dimension).max());
    out.push_str("</svg>\n");
    out
}

/// The Betti numbers of a growing complex, dimension by dimension: at each radius, what they are from there on. Upwards, one more
/// than the number on a logarithmic scale: so zero can be seen, and seven beside ten thousand.
#[must_use]
pub fn betti_curves(title: &str, radii: &[f64], numbers: &[Vec<usize>]) -> String {
    let axis = Axis::around(radii.iter().copied());
    let most = numbers.iter().flatten().copied().max().unwrap_or(0);
    let decades = (real(most) + 1.0).log10().max(1.0);
    let up = |count: f64| TOP + SIDE * (1.0 - (count + 1.0).log10() / decades);
    let mut out = head(title, LEFT + SIDE + 24.0);
    frame(&mut out, LEFT, "radius", axis);
    let mut ticks = vec![0.0, 1.0];
    ticks.extend((1..=20).map(|power| 10f64.powi(power)).filter(|&count| count <= real(most)));
    for count in ticks {
        let y = Short(up(count) + 4.0);
        let x = Short(LEFT - 6.0);
        let _ = write!(
            out,
            "<text class=\"ink\" x=\"{x}\" y=\"{y}\" text-anchor=\"end\">{count}</text>"
        );
    }
    let dimensions = numbers.iter().map(Vec::len).max().unwrap_or(0);
    for k in 0..dimensions {
        let mut d = format!("M{LEFT} {}", Short(up(0.0)));
        let mut last = String::new();
        for (&radius, betti) in radii.iter().zip(numbers) {
            let y = Short(up(real(betti.get(k).copied().unwrap_or(0)))).to_string();
            if y != last {
                let _ = write!(d, "H{}V{y}", Short(LEFT + SIDE * axis.place(radius)));
                last = y;
            }
        }
        let _ = write!(d, "H{}", Short(LEFT + SIDE));
        let colour = COLOURS[k % COLOURS.len()];
        let _ = write!(
            out,
            "<path class=\"betti\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.5\" d=\"{d}\"/>"
        );
    }
    legend(&mut out, LEFT + SIDE - 60.0, dimensions.checked_sub(1));
    out.push_str("</svg>\n");
    out
}

/// The beginning of a picture of some width. (Writing to a String cannot fail.)
fn head(title: &str, width: f64) -> String {
    let (title, height) = (Escaped(title), TOP + SIDE + BOTTOM);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         role=\"img\" font-family=\"sans-serif\" font-size=\"12\"><title>{title}</title>\
         <rect class=\"paper\" width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\
         <text class=\"ink\" x=\"{LEFT}\" y=\"24\" font-size=\"15\">{title}</text>"
    )
}

/// A square panel with its axis of radii.
fn frame(out: &mut String, x: f64, across: &str, axis: Axis) {
    let (left, bottom) = (Short(x), TOP + SIDE);
    let _ = write!(
        out,
        "<rect x=\"{left}\" y=\"{TOP}\" width=\"{SIDE}\" height=\"{SIDE}\" fill=\"none\" stroke=\"#888888\"/>\
         <text class=\"ink\" x=\"{left}\" y=\"{}\" text-anchor=\"middle\">0</text>\
         <text class=\"ink\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
        bottom + 16.0,
        Short(x + SIDE / 2.0),
        bottom + 36.0,
        Escaped(across)
    );
    for (power, place) in axis.ticks() {
        let at = Short(x + SIDE * place);
        let _ = write!(
            out,
            "<path d=\"M{at} {TOP}V{bottom}\" stroke=\"#888888\" stroke-opacity=\"0.4\"/>\
             <text class=\"ink\" x=\"{at}\" y=\"{}\" text-anchor=\"middle\">1e{power}</text>",
            bottom + 16.0
        );
    }
}

fn bars(out: &mut String, axis: Axis, classes: &[Class]) {
    let step = SIDE / (real(classes.len()) + 1.0);
    let width = Short((0.6 * step).clamp(0.5, 6.0));
    for (i, class) in classes.iter().enumerate() {
        let [from, to] =
            [axis.place(class.birth), class.death.map_or(1.0, |death| axis.place(death))];
        let _ = write!(
            out,
            "<path class=\"bar\" stroke=\"{}\" stroke-width=\"{width}\" d=\"M{} {}H{}\"/>",
            COLOURS[class.dimension % COLOURS.len()],
            Short(LEFT + SIDE * from),
            Short(TOP + step * real(i + 1)),
            Short(LEFT + SIDE * to),
        );
    }
}

fn diagram(out: &mut String, x: f64, axis: Axis, classes: &[Class]) {
    let bottom = TOP + SIDE;
    let _ = write!(
        out,
        "<path d=\"M{} {bottom}L{} {TOP}\" stroke=\"#888888\"/>\
         <text class=\"ink\" transform=\"translate({} {}) rotate(-90)\" text-anchor=\"middle\">death</text>",
        Short(x),
        Short(x + SIDE),
        Short(x - 8.0),
        TOP + SIDE / 2.0
    );
    for class in classes {
        let up = class.death.map_or(1.0, |death| axis.place(death));
        let r = if class.death.is_none() { 4.0 } else { 2.0 };
        let _ = write!(
            out,
            "<circle class=\"point\" fill=\"{}\" fill-opacity=\"0.7\" cx=\"{}\" cy=\"{}\" r=\"{r}\"/>",
            COLOURS[class.dimension % COLOURS.len()],
            Short(x + SIDE * axis.place(class.birth)),
            Short(bottom - SIDE * up),
        );
    }
}

/// The colours of the dimensions up to the highest.
fn legend(out: &mut String, x: f64, highest: Option<usize>) {
    for k in (0..).take(highest.map_or(0, |highest| highest + 1)) {
        let (y, colour) = (TOP + 18.0 + 18.0 * real(k), COLOURS[k % COLOURS.len()]);
        let _ = write!(
            out,
            "<circle fill=\"{colour}\" cx=\"{}\" cy=\"{}\" r=\"4\"/>\
             <text class=\"ink\" x=\"{}\" y=\"{y}\">H{k}</text>",
            Short(x),
            Short(y - 4.0),
            Short(x + 10.0)
        );
    }
}

#[cfg(test)]
mod tests;
