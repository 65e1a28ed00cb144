//! Orientations and lifted determinants of constructed points in integers of fixed widths: what is tried before numbers of any
//! length.
//!
//! **Design.** All numerators are put on one power of two, denominators on their own. Differences to a whole point r, one whose denominator is 1, X - r W, are
//! the rows of the determinants of `exact/formulas.rs`. In a lifted determinant a row is (d W, d^2) over W^2: as (d, d^2 / W) over W, and
//! times all denominators (d, d^2 times the others' denominators), which takes no products of rows. Where no
//! point is whole, the orientation in two axes is that of the rows (W, X, Y).
//!
//! **Head-room.** Let coordinates of whole points be below 2^p, numerators below 2^x and denominators below 2^w in magnitude. Rows are at
//! most 2^b, b = max(x, p + w, w) + 1. The formulas in N limbs ask for b <= 64 N - 2 and for heights below 2^(128 N - 1)
//! (`exact.rs`): heights are at most 3 * 2^(2b), and less than 2^(2b + 2 + sum of all w) with the denominators.
//! These bits are counted for each call; `None` if they are too many, or there is no formula.

use num_traits::One;
use smallvec::SmallVec;

use super::Constructed;
use crate::exact::align::{aligned, odd};
use crate::exact::formulas::{circle, plane, space, sphere};
use crate::int::Int;
use crate::kernel::Id;
use crate::ring::Homogeneous;
use crate::{Dyadic, Sign};

/// A point in doubles, or homogeneous.
enum Vertex<'a, const D: usize> {
    Plain(&'a [f64; D]),
    Ratio(&'a Homogeneous<Dyadic, D>),
}

/// The vertices of a call, and what they need.
pub(super) struct Short<'a, const D: usize> {
    vertices: SmallVec<[Vertex<'a, D>; 5]>,
    /// The exponent of the common unit.
    low: i64,
    /// Of rows.
    bits: i64,
    /// Of all denominators together.
    bits_of_denominators: i64,
}

impl<'a, const D: usize> Short<'a, D> {
    pub(super) fn new<V: Id>(
        kernel: &'a Constructed<D>,
        vertices: impl Iterator<Item = V>,
    ) -> Self {
        let vertices = vertices.map(|v| match kernel.value_at(v.index()) {
            None => Vertex::Plain(&kernel.positions[v.index()]),
            Some(exact) => Vertex::Ratio(exact),
        });
        let mut short =
            Self { vertices: vertices.collect(), low: i64::MAX, bits: 0, bits_of_denominators: 0 };
        short.measure();
        short
    }

    fn measure(&mut self) {
        let (mut whole, mut ratio, mut denominator) = (i64::MIN / 4, i64::MIN / 4, 1);
        for vertex in &self.vertices {
            match vertex {
                Vertex::Plain(point) => {
                    for (mantissa, exponent) in point.map(odd) {
                        if mantissa != 0 {
                            let bits = 64 - i64::from(mantissa.leading_zeros());
                            self.low = self.low.min(exponent.into());
                            whole = whole.max(i64::from(exponent) + bits);
                        }
                    }
                }
                Vertex::Ratio(Homogeneous { x, w }) => {
                    let bits = w.top() + 1 - w.exponent();
                    denominator = denominator.max(bits);
                    self.bits_of_denominators += bits;
                    let largest = if w.is_one() { &mut whole } else { &mut ratio };
                    for x in x.iter().filter(|x| x.sign() != Sign::Zero) {
                        self.low = self.low.min(x.exponent() - w.exponent());
                        *largest = (*largest).max(x.top() + 1 - w.exponent());
                    }
                }
            }
        }
        if self.low == i64::MAX {
            self.low = 0; // all coordinates are zero
        }
        let of_rows = ratio.max(whole + denominator) - self.low;
        self.bits = of_rows.max(denominator) + 1;
    }

    /// Numerators and denominator.
    fn integers<const N: usize>(&self, i: usize) -> ([Int<N>; D], Int<N>) {
        match self.vertices[i] {
            Vertex::Plain(point) => {
                let low = i32::try_from(self.low).unwrap_or(0); // if it is not, all of these are zero
                (point.map(|x| aligned(x, low)), Int::ONE)
            }
            Vertex::Ratio(Homogeneous { x, w }) => {
                let low = self.low + w.exponent();
                (x.each_ref().map(|x| integer(x, low)), integer(w, w.exponent()))
            }
        }
    }

    fn fits<const N: usize>(&self) -> bool {
        self.bits <= Self::limbs_to_bits(N) - 2
    }

    fn limbs_to_bits(limbs: usize) -> i64 {
        64 * i64::try_from(limbs).expect("few limbs")
    }

    /// The last whole point.
    fn reference(&self) -> Option<usize> {
        self.vertices.iter().rposition(|vertex| match vertex {
            Vertex::Plain(_) => true,
            Vertex::Ratio(Homogeneous { w, .. }) => w.is_one(),
        })
    }

    /// The rows relative to a whole point, and their denominators.
    fn rows<const N: usize, const R: usize>(&self, place: usize) -> [([Int<N>; D], Int<N>); R] {
        let (origin, _) = self.integers::<N>(place);
        let mut others = (0..self.vertices.len()).filter(|&i| i != place);
        std::array::from_fn(|_| {
            let (x, w) = self.integers::<N>(others.next().expect("R others"));
            let one = w == Int::ONE;
            let difference = |axis: usize| {
                let origin = &origin[axis];
                x[axis] - if one { *origin } else { origin.wrapping_times(&w) }
            };
            (std::array::from_fn(difference), w)
        })
    }

    /// The orientation on two or three axes.
    pub(super) fn orient(&self, axes: &[usize]) -> Option<Sign> {
        if self.vertices.len() != axes.len() + 1 {
            return None;
        }
        match () {
            () if self.fits::<4>() => self.orient_in::<4, 8, 12, 6>(axes),
            () if self.fits::<8>() => self.orient_in::<8, 16, 24, 10>(axes),
            () => None,
        }
    }

    fn orient_in<const N: usize, const N2: usize, const N3: usize, const M: usize>(
        &self,
        axes: &[usize],
    ) -> Option<Sign> {
        let place = match (axes, self.reference()) {
            (_, Some(place)) => place,
            (&[x, y], None) => {
                let [p, q, r] = [0, 1, 2].map(|i| {
                    let (point, w) = self.integers::<N>(i);
                    [w, point[x], point[y]]
                });
                return Some(space::<N, N2, N3>([&p, &q, &r]).sign());
            }
            _ => return None,
        };
        let sign = match *axes {
            [x, y] => {
                let [p, q] = self.rows::<N, 2>(place).map(|(p, _)| [p[x], p[y]]);
                plane::<N, N2>([&p, &q]).sign()
            }
            [x, y, z] => {
                let [p, q, r] = self.rows::<N, 3>(place).map(|(p, _)| [p[x], p[y], p[z]]);
                let beside_plain = beside_short::<N, M>([&p, &q, &r]);
                beside_plain.unwrap_or_else(|| space::<N, N2, N3>([&p, &q, &r]).sign())
            }
            _ => return None,
        };
        Some(sign.times_minus_one_to(place)) // the one of the reference's row, in the first column
    }

    /// The lifted determinant on two or three axes.
    pub(super) fn lifted(&self, axes: &[usize]) -> Option<Sign> {
        let bits = 2 * self.bits + 2 + self.bits_of_denominators;
        let fits = |limbs: usize| bits < 2 * Self::limbs_to_bits(limbs);
        if D > 3 || self.vertices.len() != axes.len() + 2 {
            return None;
        }
        match () {
            () if self.fits::<4>() && fits(4) => self.lifted_in::<4, 8, 12, 16, 20>(axes),
            () if self.fits::<8>() && fits(8) => self.lifted_in::<8, 16, 24, 32, 40>(axes),
            () => None,
        }
    }

    fn lifted_in<
        const N: usize,
        const N2: usize,
        const N3: usize,
        const N4: usize,
        const N5: usize,
    >(
        &self,
        axes: &[usize],
    ) -> Option<Sign> {
        let place = self.reference()?;
        let sign = match *axes {
            [x, y] => {
                let rows = self.rows::<N, 3>(place);
                let [hp, hq, hr] = &heights::<N, N2, D, 3>(&rows);
                let [p, q, r] = rows.map(|(p, _)| [p[x], p[y]]);
                -circle::<N, N2, N4>([&p, &q, &r], [hp, hq, hr]).sign()
            }
            [x, y, z] => {
                let rows = self.rows::<N, 4>(place);
                let [hp, hq, hr, hs] = &heights::<N, N2, D, 4>(&rows);
                let [p, q, r, s] = rows.map(|(p, _)| [p[x], p[y], p[z]]);
                sphere::<N, N2, N3, N5>([&p, &q, &r, &s], [hp, hq, hr, hs]).sign()
            }
            _ => return None,
        };
        Some(sign.times_minus_one_to(place))
    }
}

/// The sign of `det[p; q; r]` if two of the rows are of one limb, as those between plain points are: M is N + 2.
///
/// Entries of these two are at most 2^62 in magnitude, minors 2^125, and the sum 3 * 2^(64 N - 2 + 125) < 2^(64 M - 1).
fn beside_short<const N: usize, const M: usize>(rows: [&[Int<N>; 3]; 3]) -> Option<Sign> {
    let short = rows.map(|[x, y, z]| Some([x.short()?, y.short()?, z.short()?]));
    let (first, q, r) = match short {
        [_, Some(q), Some(r)] => (0, q, r),
        [Some(r), _, Some(q)] => (1, q, r),
        [Some(q), Some(r), _] => (2, q, r),
        _ => return None,
    };
    let minor = |i: usize, j: usize| -> Int<2> {
        (i128::from(q[i]) * i128::from(r[j]) - i128::from(q[j]) * i128::from(r[i])).into()
    };
    let [x, y, z] = rows[first];
    let sum: Int<M> = x.times(&minor(1, 2)) + y.times(&minor(2, 0)) + z.times(&minor(0, 1));
    Some(sum.sign())
}

/// Squared lengths times the denominators of the other rows.
fn heights<const N: usize, const N2: usize, const D: usize, const R: usize>(
    rows: &[([Int<N>; D], Int<N>); R],
) -> [Int<N2>; R] {
    std::array::from_fn(|i| {
        let square = rows[i].0.iter().fold(Int::ZERO, |sum, x| sum + x.times::<N, N2>(x));
        let others = rows.iter().enumerate().filter(|(j, (_, w))| *j != i && *w != Int::ONE);
        others.fold(square, |height, (_, (_, w))| height.wrapping_times(&w.extended()))
    })
}

/// `value / 2^low`, an integer by the choice of `low`. Bits over the width are lost.
fn integer<const N: usize>(value: &Dyadic, low: i64) -> Int<N> {
    let shift = value.exponent().abs_diff(low);
    Int::from_limbs(value.mantissa(), shift, value.sign() == Sign::Negative)
}

#[cfg(test)]
mod tests;
