//! The widest tier: determinants as sums of monomials in two long accumulators, for any exponents.
//!
//! **Why.** Coordinates 2,000 bits apart are sparse: one limb at each end. Their differences are dense. So nothing is
//! translated: the determinant with a column of ones is expanded into its monomials, each a product of a few mantissas
//! of 53 bits at some exponent, and these are added where they belong, positive ones and negative ones apart, so that
//! no carry runs through the whole length. What is left is a comparison of two numbers.
//!
//! **Cost.** (k+1)! monomials for an orientation in k axes, (k+2)! D for a lifted determinant. The widest sum, lifted in
//! 7 axes, has degree 9: 9 * 2,098 bits, 22 bits for its 9! * 8 terms, and the limbs of a product over the highest place: 306 limbs. In up to three axes numbers are cut to
//! the degree at hand: most of the time would go into clearing and comparing limbs that are not there.
//!
//! **In.** Rows of at most [`AXES_MAX`] coordinates. The recursion is as deep as a row is long.

use std::cmp::Ordering;

use super::align::odd;
use super::{AXES_MAX, POINTS_MAX};
use crate::Sign;

/// Exponents of a product of `degree` doubles start here.
fn exponent_min(degree: usize) -> i32 {
    -1074 * i32::try_from(degree).expect("degrees are small")
}

/// A double taken apart; the mantissa is odd, or zero.
#[derive(Clone, Copy)]
struct Factor {
    mantissa: u64,
    exponent: i32,
    negative: bool,
}

impl Factor {
    fn of(value: f64) -> Self {
        let (mantissa, exponent) = odd(value);
        Self { mantissa, exponent, negative: value.is_sign_negative() }
    }
}

/// `mantissa * 2^exponent`, a product of at most L doubles: 53 bits for each.
#[derive(Clone, Copy)]
struct Product<const L: usize> {
    limbs: [u64; L],
    exponent: i32,
    negative: bool,
}

impl<const L: usize> Product<L> {
    const ONE: Self = {
        let mut limbs = [0; L];
        limbs[0] = 1;
        Self { limbs, exponent: 0, negative: false }
    };

    /// The product with a double, or nothing if that is zero.
    #[inline]
    fn times(&self, factor: Factor) -> Option<Self> {
        if factor.mantissa == 0 {
            return None;
        }
        let mut limbs = self.limbs;
        let mut carry = 0;
        for slot in &mut limbs {
            (*slot, carry) = slot.carrying_mul_add(factor.mantissa, 0, carry);
        }
        let negative = self.negative != factor.negative;
        Some(Self { limbs, exponent: self.exponent + factor.exponent, negative })
    }

    /// The product with a product of two doubles; together they are one of at most L.
    #[inline]
    fn by(&self, other: &Product<2>) -> Self {
        let mut limbs = [0; L];
        for (place, &b) in other.limbs.iter().enumerate() {
            let mut carry = 0;
            for (slot, &a) in limbs[place..].iter_mut().zip(&self.limbs) {
                (*slot, carry) = a.carrying_mul_add(b, *slot, carry);
            }
        }
        let negative = self.negative != other.negative;
        Self { limbs, exponent: self.exponent + other.exponent, negative }
    }

    fn negated_if(mut self, negate: bool) -> Self {
        self.negative ^= negate;
        self
    }
}

/// Sums of monomials of one degree, products of L limbs, in N limbs.
struct Sum<const L: usize, const N: usize> {
    positive: [u64; N],
    negative: [u64; N],
    low: i32,
}

impl<const L: usize, const N: usize> Sum<L, N> {
    fn new(degree: usize) -> Self {
        debug_assert!(N * 64 >= degree * 2098 + 64 * (L + 1) + 22, "limbs for the degree");
        Self { positive: [0; N], negative: [0; N], low: exponent_min(degree) }
    }

    #[inline]
    fn add(&mut self, product: &Product<L>) {
        let shift = product.exponent.abs_diff(self.low) as usize;
        let (place, bit) = (shift / 64, shift % 64);
        let sum = if product.negative { &mut self.negative } else { &mut self.positive };
        let (slots, higher) = sum[place..].split_at_mut(L);
        let (mut above, mut carry) = (0, false);
        for (slot, limb) in slots.iter_mut().zip(product.limbs) {
            (*slot, carry) = slot.carrying_add(limb << bit | above, carry);
            above = limb >> 1 >> (63 - bit);
        }
        let mut higher = higher.iter_mut();
        while above != 0 || carry {
            let slot = higher.next().expect("limbs for the degree");
            (*slot, carry) = slot.carrying_add(above, carry);
            above = 0;
        }
    }

    fn sign(&self) -> Sign {
        let pairs = self.positive.iter().rev().zip(self.negative.iter().rev());
        pairs.map(|(p, n)| p.cmp(n)).find(|o| o.is_ne()).unwrap_or(Ordering::Equal).into()
    }
}

/// The sign of `det[1 p_i]` on the given axes, rows in order: the orientation `det[p1 - p0; ..; pk - p0]`.
#[inline(never)]
pub(crate) fn orient(points: &[&[f64]], axes: &[usize]) -> Sign {
    match axes.len() {
        0..=2 => orient_in::<2, 2, 72>(points, axes),
        3 => orient_in::<3, 3, 106>(points, axes),
        _ => orient_in::<AXES_MAX, POINTS_MAX, 308>(points, axes),
    }
}

fn orient_in<const K: usize, const L: usize, const N: usize>(
    points: &[&[f64]],
    axes: &[usize],
) -> Sign {
    let mut sum = Sum::<L, N>::new(axes.len());
    let factors = factors::<K>(points, axes);
    // Columns from the last axis down; the row left over takes the column of ones, the first.
    expand(&factors, axes.len(), all(points), Product::<L>::ONE, &mut |_, product| {
        sum.add(product)
    });
    sum.sign()
}

/// The sign of `(b - a) x (d - c)`.
#[inline(never)]
pub(crate) fn cross([a, b, c, d]: [[f64; 2]; 4]) -> Sign {
    let mut sum = Sum::<2, 72>::new(2);
    let [a, b, c, d] = [a, b, c, d].map(|p| p.map(Factor::of));
    for (p, p_negative) in [(b, false), (a, true)] {
        for (q, q_negative) in [(d, false), (c, true)] {
            for (axis, negative) in [(0, false), (1, true)] {
                let product = Product::<2>::ONE.times(p[axis]).and_then(|x| x.times(q[1 - axis]));
                if let Some(product) = product {
                    sum.add(&product.negated_if(p_negative ^ q_negative ^ negative));
                }
            }
        }
    }
    sum.sign()
}

/// The sign of `det[1 p_i h_i]` on the given axes, rows in order, `h_i = |p_i|^2 - weight_i` over all coordinates.
#[inline(never)]
pub(crate) fn lifted(points: &[&[f64]], axes: &[usize], weights: Option<&[f64]>) -> Sign {
    match axes.len() {
        0..=2 => lifted_in::<2, 4, 140>(points, axes, weights),
        3 => lifted_in::<3, 5, 172>(points, axes, weights),
        _ => lifted_in::<AXES_MAX, POINTS_MAX, 308>(points, axes, weights),
    }
}

fn lifted_in<const K: usize, const L: usize, const N: usize>(
    points: &[&[f64]],
    axes: &[usize],
    weights: Option<&[f64]>,
) -> Sign {
    let mut sum = Sum::<L, N>::new(axes.len() + 2);
    let factors = factors::<K>(points, axes);
    let heights: [_; POINTS_MAX] = std::array::from_fn(|row| {
        points.get(row).map(|point| Height::of(point, weights.map(|weights| weights[row])))
    });
    // Columns from the last axis down; of the two rows left over one takes the height, the other the column of ones. The
    // heights are the last column: it passes the k axes to stand before them.
    let turned = axes.len() % 2 == 1;
    expand(&factors, axes.len(), all(points), Product::<L>::ONE, &mut |left, minor| {
        let first = left.trailing_zeros() as usize;
        let second = (left & (left - 1)).trailing_zeros() as usize;
        for (row, negated) in [(first, !turned), (second, turned)] {
            for term in heights[row].iter().flat_map(Height::terms) {
                sum.add(&minor.by(term).negated_if(negated));
            }
        }
    });
    sum.sign()
}

/// The terms of a height, in two limbs each: squares, and a weight.
struct Height {
    terms: [Product<2>; AXES_MAX + 1],
    len: usize,
}

impl Height {
    fn of(point: &[f64], weight: Option<f64>) -> Self {
        let mut height = Self { terms: [Product::ONE; AXES_MAX + 1], len: 0 };
        let squares = point.iter().map(|&x| Factor::of(x)).map(|x| Product::ONE.times(x)?.times(x));
        let weight = weight.map(|weight| Product::ONE.times(Factor::of(-weight)));
        for term in squares.chain(weight).flatten() {
            height.terms[height.len] = term;
            height.len += 1;
        }
        height
    }

    fn terms(&self) -> &[Product<2>] {
        &self.terms[..self.len]
    }
}

/// The coordinates on the axes, by rows.
fn factors<const K: usize>(points: &[&[f64]], axes: &[usize]) -> [[Factor; K]; POINTS_MAX] {
    let mut rows = [[Factor { mantissa: 0, exponent: 0, negative: false }; K]; POINTS_MAX];
    for (row, point) in rows.iter_mut().zip(points) {
        for (factor, &axis) in row.iter_mut().zip(axes) {
            *factor = Factor::of(point[axis]);
        }
    }
    rows
}

/// Rows not yet used by a monomial, as a bit set.
type Rows = u32;

fn all(points: &[&[f64]]) -> Rows {
    (1 << points.len()) - 1
}

/// Without one of the rows; and whether the cofactor of that row and the last column is negative.
#[inline]
fn without(rows: Rows, row: usize) -> (Rows, bool) {
    (rows & !(1 << row), (rows >> row >> 1).count_ones() % 2 == 1)
}

/// Calls `add` with all monomials of the determinants of `columns` of the rows left, times `product`, and with the rows that
/// are left over: as if columns with a one in one of them stood before.
fn expand<const K: usize, const L: usize>(
    factors: &[[Factor; K]; POINTS_MAX],
    columns: usize,
    left: Rows,
    product: Product<L>,
    add: &mut impl FnMut(Rows, &Product<L>),
) {
    let Some(column) = columns.checked_sub(1) else {
        add(left, &product);
        return;
    };
    let mut rest = left;
    while rest != 0 {
        let row = rest.trailing_zeros() as usize;
        rest &= rest - 1;
        let Some(product) = product.times(factors[row][column]) else { continue };
        let (left, odd) = without(left, row);
        expand(factors, column, left, product.negated_if(odd), add);
    }
}
