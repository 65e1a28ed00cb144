//! The widest tier: determinants as sums of monomials in two long accumulators, for any exponents.
//!
//! **Why.** Coordinates 2,000 bits apart are sparse: one limb at each end. Their differences are dense. So nothing is
//! translated: the determinant with a column of ones is expanded into its monomials, each a product of a few mantissas
//! of 53 bits at some exponent, and these are added where they belong, positive ones and negative ones apart, so that
//! no carry runs through the whole length. What is left is a comparison of two numbers.
//!
//! **Cost.** (k+1)! monomials for an orientation in k axes, (k+2)! D for a lifted determinant. The widest sum, lifted in
//! 7 axes, has degree 9: 9 * 2,098 bits, and 22 bits for its 9! * 8 terms: 296 limbs.
//!
//! **In.** Rows of at most [`AXES_MAX`] coordinates. The recursion is as deep as a row is long.

use std::cmp::Ordering;

use super::align::odd;
use super::{AXES_MAX, POINTS_MAX};
use crate::Sign;

const LIMBS: usize = 300;

/// Exponents of a product of `degree` doubles start here.
fn exponent_min(degree: usize) -> i32 {
    -1074 * i32::try_from(degree).expect("degrees are small")
}

/// Sums of monomials of one degree.
struct Sum {
    positive: [u64; LIMBS],
    negative: [u64; LIMBS],
    low: i32,
}

/// `mantissa * 2^exponent`, the mantissa of at most `POINTS_MAX` limbs.
#[derive(Clone, Copy)]
struct Product {
    limbs: [u64; POINTS_MAX],
    len: usize,
    exponent: i32,
    negative: bool,
}

impl Product {
    const ONE: Self = {
        let mut limbs = [0; POINTS_MAX];
        limbs[0] = 1;
        Self { limbs, len: 1, exponent: 0, negative: false }
    };

    /// The product with a double, or nothing if that is zero.
    fn times(&self, value: f64) -> Option<Self> {
        let (mantissa, exponent) = odd(value);
        if mantissa == 0 {
            return None;
        }
        let mut limbs = [0; POINTS_MAX];
        let (mut carry, mut len) = (0, self.len);
        for (slot, &a) in limbs.iter_mut().zip(&self.limbs[..len]) {
            (*slot, carry) = a.carrying_mul_add(mantissa, 0, carry);
        }
        if carry != 0 {
            limbs[len] = carry; // 53 bits for each of at most POINTS_MAX factors
            len += 1;
        }
        let negative = self.negative != value.is_sign_negative();
        Some(Self { limbs, len, exponent: self.exponent + exponent, negative })
    }

    fn negated_if(mut self, negate: bool) -> Self {
        self.negative ^= negate;
        self
    }
}

impl Sum {
    fn new(degree: usize) -> Self {
        Self { positive: [0; LIMBS], negative: [0; LIMBS], low: exponent_min(degree) }
    }

    fn add(&mut self, product: &Product) {
        let shift = product.exponent.abs_diff(self.low) as usize;
        let (mut place, bit) = (shift / 64, shift % 64);
        let sum = if product.negative { &mut self.negative } else { &mut self.positive };
        let (mut above, mut carry) = (0, false);
        for &limb in &product.limbs[..product.len] {
            (sum[place], carry) = sum[place].carrying_add(limb << bit | above, carry);
            above = limb >> 1 >> (63 - bit);
            place += 1;
        }
        (sum[place], carry) = sum[place].carrying_add(above, carry);
        while carry {
            place += 1;
            (sum[place], carry) = sum[place].overflowing_add(1);
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
    let mut sum = Sum::new(axes.len());
    let mut left = Rows::all(points.len());
    // Columns from the last axis down; the row left over takes the column of ones, the first.
    expand(points, axes, &mut left, Product::ONE, &mut |product| sum.add(&product));
    sum.sign()
}

/// The sign of `(b - a) x (d - c)`.
#[inline(never)]
pub(crate) fn cross([a, b, c, d]: [[f64; 2]; 4]) -> Sign {
    let mut sum = Sum::new(2);
    for (p, p_negative) in [(b, false), (a, true)] {
        for (q, q_negative) in [(d, false), (c, true)] {
            for (axis, negative) in [(0, false), (1, true)] {
                let product = Product::ONE.times(p[axis]).and_then(|x| x.times(q[1 - axis]));
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
    let mut sum = Sum::new(axes.len() + 2);
    for (row, point) in points.iter().enumerate() {
        let mut left = Rows::all(points.len());
        let odd = left.take_from_end(row);
        let mut expand_under = |height: Product| {
            let height = height.negated_if(odd);
            expand(points, axes, &mut left, height, &mut |product| sum.add(&product));
        };
        for &x in *point {
            if let Some(square) = Product::ONE.times(x).and_then(|p| p.times(x)) {
                expand_under(square);
            }
        }
        if let Some(weight) = weights.and_then(|weights| Product::ONE.times(-weights[row])) {
            expand_under(weight);
        }
    }
    sum.sign()
}

/// Rows not yet used by a monomial, in order.
#[derive(Clone, Copy)]
struct Rows {
    rows: [usize; POINTS_MAX],
    len: usize,
}

impl Rows {
    fn all(len: usize) -> Self {
        Self { rows: std::array::from_fn(|i| i), len }
    }

    /// Takes out the row at `place`; whether the cofactor of that row and the last column is negative.
    fn take_from_end(&mut self, place: usize) -> bool {
        self.rows.copy_within(place + 1..self.len, place);
        self.len -= 1;
        (self.len - place) % 2 == 1
    }
}

/// All monomials of the determinant of the rows left, with a column of ones before those of `axes`, times `product`.
fn expand(
    points: &[&[f64]],
    axes: &[usize],
    left: &mut Rows,
    product: Product,
    emit: &mut dyn FnMut(Product),
) {
    let Some((&axis, axes)) = axes.split_last() else {
        emit(product);
        return;
    };
    debug_assert!(axes.len() < AXES_MAX);
    for place in 0..left.len {
        let Some(product) = product.times(points[left.rows[place]][axis]) else { continue };
        let mut rest = *left;
        let odd = rest.take_from_end(place);
        expand(points, axes, &mut rest, product.negated_if(odd), emit);
    }
}
