//! In-sphere tests of the cells around a cell, in space: what they have in common is computed once.
//!
//! Let q see the vertices of a positive cell as rows (x, y, z, h): differences to q and their squared length. A cell beyond
//! one of its facets has a row e in the place of one of these, and `in_sphere` of it and q is the determinant of the four rows.
//! By Laplace, that is the sum over complementary pairs of columns of 2 x 2 minors, those of e and one row times those of the
//! two other rows. These two are paired so that their minors serve two facets: rows 2 and 3 beyond the facets
//! opposite 0 and 1, rows 0 and 1 beyond the others.
//!
//! **Bound.** A minor of two coordinates has 4 roundings on its longest path, one of a coordinate and a height 8. Each product has one
//! of each: 4 + 8 and its own, and 3 sums, 16 as in `in_sphere`, whose constant serves. The permanent is made of the same
//! magnitudes, each minor guarded before it is scaled; the six outermost products can lose 6 * 2^-1075 by underflow, which the last guard covers.

use super::{Bounds, GUARD, IN_SPHERE};
use crate::Sign;

/// What the sphere tests beyond the facets of one cell have in common, as prepared by [`crate::Kernel::look`].
///
/// By default nothing is seen, and all is uncertain.
#[derive(Clone, Copy, Debug)]
pub struct Outlook {
    /// The minors of rows 2 and 3, then of rows 0 and 1.
    pairs: [Minors; 2],
}

/// How one vertex sees another. By default it does not, and all is uncertain.
#[derive(Clone, Copy, Debug)]
pub struct Sight(Row);

/// x and y, then z and h.
type Row = [Lanes; 2];

/// Two numbers to be computed with in step.
type Lanes = [f64; 2];

/// By complementary pairs of columns: xy and zh, xz and yh, xh and yz.
type Minors = [Lanes; 3];

#[inline(always)]
fn times(a: Lanes, b: Lanes) -> Lanes {
    [a[0] * b[0], a[1] * b[1]]
}

#[inline(always)]
fn less(a: Lanes, b: Lanes) -> Lanes {
    [a[0] - b[0], a[1] - b[1]]
}

/// How `from` sees a point.
#[inline(always)]
fn row(point: &[f64; 3], from: &[f64; 3]) -> Row {
    let [x, y] = less([point[0], point[1]], [from[0], from[1]]);
    let z = point[2] - from[2];
    [[x, y], [z, x * x + y * y + z * z]]
}

#[inline(always)]
fn minors([a, b]: Row, [c, d]: Row) -> Minors {
    let turned = |[z, h]: Lanes| [h, z];
    [
        less(times([a[0], b[0]], [c[1], d[1]]), times([a[1], b[1]], [c[0], d[0]])),
        less(times(a, d), times(b, c)),
        less(times(a, turned(d)), times(turned(b), c)),
    ]
}

/// The determinant of four rows, from the minors of the first two and of the others.
#[inline(always)]
fn determinant(a: Minors, b: Minors) -> f64 {
    let term = |i: usize| times(a[i], [b[i][1], b[i][0]]);
    let (sum, middle, last) = (term(0), term(1), term(2));
    let [left, right] = less([sum[0] + last[0], sum[1] + last[1]], middle);
    left + right
}

const NOTHING: Lanes = [f64::NAN; 2];

impl Default for Sight {
    fn default() -> Self {
        Self([NOTHING; 2])
    }
}

impl Sight {
    /// How `from` sees a point.
    #[inline(always)]
    pub(crate) fn see(&mut self, point: &[f64; 3], from: &[f64; 3]) {
        self.0 = row(point, from);
    }
}

impl Default for Outlook {
    fn default() -> Self {
        Self { pairs: [[NOTHING; 3]; 2] }
    }
}

impl Outlook {
    /// A cell whose corners are seen so.
    #[inline(always)]
    pub(crate) fn look(&mut self, [a, b, c, d]: [&Sight; 4]) {
        self.pairs = [minors(c.0, d.0), minors(a.0, b.0)];
    }

    /// The in-sphere test of the cell beyond the facet opposite `corner`, whose apex is seen so; `end` is the row of corner `corner ^ 1`,
    /// `bound` that of all tests.
    #[inline(always)]
    pub(crate) fn beyond(
        &self,
        corner: usize,
        end: &Sight,
        apex: &Sight,
        bound: f64,
    ) -> Option<Sign> {
        let value = determinant(minors(end.0, apex.0), self.pairs[corner / 2 % 2]);
        let value = value * TURNS[corner % 2];
        (value.abs() > bound).then(|| Sign::of(value))
    }
}

/// Whether the rows in their order turn the right way, by the parity of the corner that is replaced.
static TURNS: [f64; 2] = [-1.0, 1.0];

impl Bounds {
    /// The bound of [`Outlook::beyond`] where differences are at most these.
    pub(super) fn beyond([x, y, z]: [f64; 3]) -> f64 {
        let height = x * x + y * y + z * z + GUARD;
        let minor = |a: f64, b: f64| a * b + a * b + GUARD;
        let term = |a: f64, b: f64| a * b + GUARD;
        let xy = term(minor(x, y), minor(z, height));
        let xz = term(minor(x, z), minor(y, height));
        let yz = term(minor(y, z), minor(x, height));
        IN_SPHERE * (((xy + yz) + xz) + ((xy + yz) + xz) + GUARD)
    }
}

#[cfg(test)]
mod tests;
