//! How much of a smallest cell is inside, exactly: whether half of it.
//!
//! **In / Out.** The segments that meet a cell, the winding number at its reference point, the rule; the sign of twice the area inside
//! less the cell's area.
//!
//! The cell is cut into slabs at all abscissas where something happens: ends of segments, crossings of two, crossings with the lower
//! and the upper side. In the interior of a slab segments do not cross, so that the area between two of them is the slab's width times
//! their distance in its middle.
//!
//! **Cost.** O(k^3) operations on fractions of some hundred digits for k segments.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | exactly half | black | `half_a_cell_is_enough` |
//! | vertical segments | bound slabs, are crossed by none | `areas_decide_as_sums_over_small_cells_do` |
//! | segments that overlap | no area between them | `areas_decide_as_sums_over_small_cells_do` |

use std::cmp::Ordering;

use delone_predicates::{Dyadic, Sign};

use super::edge::Edge;
use crate::Rule;
use crate::grow::{Held, Wall};

/// A fraction with a positive denominator.
#[derive(Clone, Debug)]
struct Ratio {
    over: Dyadic,
    under: Dyadic,
}

impl Ratio {
    fn whole(value: f64) -> Self {
        Self { over: Dyadic::from(value), under: Dyadic::from(1) }
    }

    /// None if the denominator is zero.
    fn new(over: Dyadic, under: Dyadic) -> Option<Self> {
        match under.sign() {
            Sign::Positive => Some(Self { over, under }),
            Sign::Zero => None,
            Sign::Negative => Some(Self { over: -over, under: -under }),
        }
    }

    fn compare(&self, other: &Self) -> Ordering {
        (&self.over * &other.under).cmp(&(&other.over * &self.under))
    }

    fn is_less(&self, other: &Self) -> bool {
        self.compare(other).is_lt()
    }

    fn plus(&self, other: &Self) -> Self {
        let over = &self.over * &other.under + &other.over * &self.under;
        Self { over, under: &self.under * &other.under }
    }

    fn less(&self, other: &Self) -> Self {
        self.plus(&Self { over: -other.over.clone(), under: other.under.clone() })
    }

    fn times(&self, other: &Self) -> Self {
        Self { over: &self.over * &other.over, under: &self.under * &other.under }
    }

    fn half(self) -> Self {
        Self { over: self.over.half(), under: self.under }
    }
}

/// A segment in exact numbers: its first end, and the way to the other one.
struct Line {
    from: [Dyadic; 2],
    way: [Dyadic; 2],
    weight: i64,
    /// Abscissas of the ends.
    span: [f64; 2],
}

impl Line {
    fn new(edge: &Edge) -> Self {
        let [a, b] = edge.ends.map(|end| end.map(Dyadic::from));
        let way = [0, 1].map(|axis| b[axis].clone() - &a[axis]);
        Self { from: a, way, weight: edge.weight, span: edge.ends.map(|end| end[0]) }
    }

    /// The coordinate `other` of the line's point whose other coordinate is given; none if it is constant.
    fn at(&self, axis: usize, place: &Ratio) -> Option<Ratio> {
        let other = 1 - axis;
        // from_o + (place - from_a) way_o / way_a
        let along = place.over.clone() - &(&self.from[axis] * &place.under);
        let over =
            &(&self.from[other] * &self.way[axis]) * &place.under + &along * &self.way[other];
        Ratio::new(over, &self.way[axis] * &place.under)
    }

    /// The abscissa where two lines cross; none if they are parallel.
    fn crossing(&self, other: &Self) -> Option<Ratio> {
        let cross = |u: &[Dyadic; 2], v: &[Dyadic; 2]| &u[0] * &v[1] - &u[1] * &v[0];
        let between = [0, 1].map(|axis| other.from[axis].clone() - &self.from[axis]);
        let under = cross(&self.way, &other.way);
        let over = &self.from[0] * &under + &self.way[0] * &cross(&between, &other.way);
        Ratio::new(over, under)
    }

    fn spans(&self, abscissa: &Ratio) -> bool {
        let [from, to] = self.span.map(Ratio::whole);
        from.is_less(abscissa) && abscissa.is_less(&to)
    }
}

/// Whether at least half of a cell is inside.
pub(super) fn is_half_inside(
    held: &Held<'_, Edge>,
    rule: Rule,
    winding: i64,
    [lower, upper]: [[f64; 2]; 2],
) -> bool {
    let lines: Vec<Line> = held.iter().map(Line::new).collect();
    let [bottom, top] = [lower[1], upper[1]].map(Ratio::whole);
    let mut covered = Ratio::whole(0.0);
    for slab in abscissas(&lines, lower, upper).windows(2) {
        let middle = slab[0].plus(&slab[1]).half();
        let start = winding + steps_below(held, lower, &bottom, &middle);
        let height = height_inside(&lines, rule, start, &middle, [&bottom, &top]);
        covered = covered.plus(&slab[1].less(&slab[0]).times(&height));
    }
    let side = Ratio::whole(upper[0]).less(&Ratio::whole(lower[0]));
    !covered.is_less(&side.times(&side).half())
}

/// Where slabs begin and end, in order.
fn abscissas(lines: &[Line], lower: [f64; 2], upper: [f64; 2]) -> Vec<Ratio> {
    let [left, right] = [lower[0], upper[0]].map(Ratio::whole);
    let mut found: Vec<Ratio> = Vec::new();
    for (i, line) in lines.iter().enumerate() {
        found.extend(line.span.map(Ratio::whole));
        found.extend([lower[1], upper[1]].iter().filter_map(|&y| line.at(1, &Ratio::whole(y))));
        found.extend(lines[..i].iter().filter_map(|other| line.crossing(other)));
    }
    found.retain(|abscissa| left.is_less(abscissa) && abscissa.is_less(&right));
    found.extend([left, right]);
    found.sort_by(Ratio::compare);
    found.dedup_by(|a, b| a.compare(b).is_eq());
    found
}

/// How the winding number changes along the lower side, from the reference point to an abscissa at which no segment is.
fn steps_below(held: &Held<'_, Edge>, lower: [f64; 2], bottom: &Ratio, to: &Ratio) -> i64 {
    let step = |edge: &Edge| {
        let Some(crossing) = Line::new(edge).at(1, bottom) else { return 0 };
        let is_up = edge.ends[0][1] < edge.ends[1][1];
        let is_left = to.is_less(&crossing) == is_up;
        edge.weight * (i64::from(is_left) - i64::from(edge.has_left(lower)))
    };
    held.iter().filter(|edge| edge.covers(lower, 0)).map(step).sum()
}

/// How much of the vertical line at an abscissa is inside.
fn height_inside(
    lines: &[Line],
    rule: Rule,
    mut winding: i64,
    middle: &Ratio,
    [bottom, top]: [&Ratio; 2],
) -> Ratio {
    let over = lines.iter().filter(|line| line.spans(middle));
    let mut crossed: Vec<(Ratio, i64)> = over
        .filter_map(|line| Some((line.at(0, middle)?, line.weight)))
        .filter(|(y, _)| bottom.is_less(y) && y.is_less(top))
        .collect();
    crossed.sort_by(|a, b| a.0.compare(&b.0));
    let mut height = Ratio::whole(0.0);
    let mut below = bottom.clone();
    for (y, weight) in crossed.into_iter().chain([(top.clone(), 0)]) {
        if rule.holds(winding) {
            height = height.plus(&y.less(&below));
        }
        winding += weight; // from the right of a segment that runs to the right, to its left
        below = y;
    }
    height
}
