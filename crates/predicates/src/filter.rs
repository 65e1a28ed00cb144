//! Floating-point filters: the sign when doubles suffice to know it, safe under underflow and overflow.
//!
//! **Dynamic.** Each filter computes the determinant of differences in plain doubles, and beside it the *permanent*, the
//! same expression with every product taken in magnitude. With u = 2^-53 the rounding error of the determinant is at
//! most `A * permanent`, where A counts the roundings on the longest path (\[She97\] sections 4.2 to 4.4; A is rounded up
//! there so that the bound itself may be computed in doubles).
//!
//! **Static.** Let X, Y, Z be the extents of the point set's box along the axes, `max - min` in doubles. Rounding is
//! monotone, so every computed difference of coordinates is at most the computed extent in magnitude; and the permanent
//! is made of sums and products of magnitudes, which computed in doubles are monotone in each argument. So the dynamic
//! bound, computed with the extents in place of all differences, in the same order of operations, is at least the
//! dynamic bound of any call: no new constant, no new proof. It is computed once for a point set. Calls that it does not
//! decide go on to the dynamic filter.
//!
//! **Integers.** Where all coordinates of a point set are whole multiples of one power of two g, and so few that the permanent of
//! the extents, a number of g^k in degree k, is below 2^53, every sum and product of a determinant is a whole
//! multiple of a power of g too, and below 2^53 of these: a double, as long as the exponents are in range. Nothing is rounded, and
//! the sign of the determinant in doubles is right, zero included: the static bound is then negative ([`EXACT`]). So are
//! lattices of up to 5,000 x 5,000 and 600 x 600 x 600 decided.
//!
//! **Underflow.** A product that underflows loses at most 2^-1075 in magnitude, which no relative bound covers. So each
//! inner magnitude gets a guard G = 2^-1020 added *before* it is scaled by its outer factor: A G >= 7 * 2^-53 * 2^-1020
//! = 28 * 2^-1075, more than the two (or, in a squared length, three) products below it can lose. The guard of the last
//! sum covers the outermost products and the rounding of `A * permanent` itself. Differences never underflow inexactly.
//! For orient2d, where both products are outermost, \[OBO16\] prove the sharper form used here.
//!
//! **Overflow.** A difference or product that overflows makes the permanent infinite or NaN, and then no comparison
//! below succeeds: uncertain. An extent that overflows turns the static filter off in the same way.
//!
//! **More than three axes.** `filter/any.rs`.
//!
//! **Out.** `None` means uncertain, never "zero".

pub(crate) mod any;
pub(crate) mod outlook;
pub(crate) mod value;

use crate::exact::align::odd;
use crate::{Sign, Stage};

const U: f64 = f64::EPSILON / 2.0;
const GUARD: f64 = 4.0 * f64::MIN_POSITIVE;

const ORIENT_2D: f64 = (3.0 + 16.0 * U) * U;
const ORIENT_3D: f64 = (7.0 + 56.0 * U) * U;
const IN_CIRCLE: f64 = (10.0 + 96.0 * U) * U;
/// As `IN_CIRCLE`, but a height is the sum of one more square: one more rounding on the longest path. The second term, for
/// products of roundings and those of the bound itself, is that of `IN_SPHERE`, whose paths are longer.
const IN_CIRCLE_OF_SPACE: f64 = (11.0 + 224.0 * U) * U;
const IN_SPHERE: f64 = (16.0 + 224.0 * U) * U;

/// A sign and the filter that is sure of it.
pub(crate) type Certain = Option<(Sign, Stage)>;

/// The bounds of the static filters of a point set; infinite where there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    /// Of orientations, and in the plane of cross products.
    pub(crate) orient: f64,
    /// Of lifted determinants.
    pub(crate) lifted: f64,
}

impl Bounds {
    /// For points about which nothing is known.
    pub(crate) const NONE: Self = Self { orient: f64::INFINITY, lifted: f64::INFINITY };

    /// For calls on these points, all of which are looked at: exact if they lie on a small lattice.
    pub(crate) fn of_all<const D: usize>(points: &[[f64; D]]) -> Self {
        let extents = extents(points);
        let bounds = Self::in_box(extents);
        match exact_degrees(points, extents) {
            None => bounds,
            Some([orient, lifted]) => Self {
                orient: if orient { EXACT } else { bounds.orient },
                lifted: if lifted { EXACT } else { bounds.lifted },
            },
        }
    }

    /// For calls on points in the box of these.
    pub(crate) fn of<const D: usize>(points: &[[f64; D]]) -> Self {
        Self::in_box(extents(points))
    }

    /// For calls on points in a box of these extents; negative ones are those of no points.
    fn in_box<const D: usize>(extents: [f64; D]) -> Self {
        match *extents.as_slice() {
            _ if extents.iter().any(|&extent| extent < 0.0) => Self::NONE,
            [x, y] => {
                let minor = x * y + x * y + GUARD;
                let height = x * x + y * y + GUARD;
                Self {
                    orient: orient_2d_bound(x * y + x * y),
                    lifted: IN_CIRCLE * in_circle_permanent([height; 3], [minor; 3]),
                }
            }
            [x, y, z] => {
                let minor = x * y + x * y + GUARD;
                let height = x * x + y * y + z * z + GUARD;
                let cofactor = z * minor + z * minor + z * minor + GUARD;
                Self {
                    orient: ORIENT_3D * cofactor,
                    lifted: (IN_SPHERE * in_sphere_permanent([height; 4], [cofactor; 4]))
                        .max(Self::beyond([x, y, z])),
                }
            }
            _ => Self::NONE,
        }
    }
}

/// The bound of what is not rounded: any magnitude is over it.
const EXACT: f64 = -1.0;

/// Whether the orientations and the lifted determinants of these points, whose box has these `extents`, are exact in doubles; `None`
/// for "neither".
fn exact_degrees<const D: usize>(points: &[[f64; D]], extents: [f64; D]) -> Option<[bool; 2]> {
    /// The permanents of [`Bounds::of`] for extents of 1 in all axes, and the degrees.
    const fn permanents(axes: usize) -> Option<[(f64, i32); 2]> {
        match axes {
            2 => Some([(2.0, 2), (12.0, 4)]),
            3 => Some([(6.0, 3), (72.0, 5)]),
            _ => None,
        }
    }
    let permanents = permanents(D)?;
    let widest = extents.into_iter().fold(0.0, f64::max);
    // The unit g, until there are too many of it.
    let mut unit = i32::MAX;
    for &coordinate in points.iter().flatten().filter(|&&x| x != 0.0) {
        let (_, exponent) = odd(coordinate);
        if exponent < unit {
            unit = exponent;
            if widest / 2f64.powi(unit) > 16384.0 {
                return None;
            }
        }
    }
    // In this range g^5 is a normal number, and 2^53 of them are finite.
    if !(-200..=180).contains(&unit) {
        return None;
    }
    let count = widest / 2f64.powi(unit);
    Some(permanents.map(|(factor, degree)| factor * count.powi(degree) < 2f64.powi(53)))
}

/// The extents of the points' box.
fn extents<const D: usize>(points: &[[f64; D]]) -> [f64; D] {
    let (mut low, mut high) = ([f64::INFINITY; D], [f64::NEG_INFINITY; D]);
    for point in points {
        for axis in 0..D {
            low[axis] = low[axis].min(point[axis]);
            high[axis] = high[axis].max(point[axis]);
        }
    }
    std::array::from_fn(|axis| high[axis] - low[axis])
}

/// The sign of `value`, if its magnitude is over one of its error bounds.
#[inline(always)]
fn certain(value: f64, of_all: f64, of_call: impl FnOnce() -> f64) -> Certain {
    let sign = Sign::of(value);
    if value.abs() > of_all {
        Some((sign, Stage::StaticFilter))
    } else if value.abs() > of_call() {
        Some((sign, Stage::DynamicFilter))
    } else {
        None
    }
}

/// `|a d| + |b c|`, guarded.
#[inline(always)]
fn minor_magnitude([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    (a * d).abs() + (b * c).abs() + GUARD
}

#[inline(always)]
fn orient_2d_bound(sum: f64) -> f64 {
    ORIENT_2D * (sum.abs() + f64::MIN_POSITIVE)
}

/// Of guarded heights and minors.
#[inline(always)]
fn in_circle_permanent(h: [f64; 3], m: [f64; 3]) -> f64 {
    h[0] * m[0] + h[1] * m[1] + h[2] * m[2] + GUARD
}

/// Of guarded heights and cofactors.
#[inline(always)]
fn in_sphere_permanent(h: [f64; 4], c: [f64; 4]) -> f64 {
    h[0] * c[0] + h[1] * c[1] + h[2] * c[2] + h[3] * c[3] + GUARD
}

#[inline(always)]
pub(crate) fn orient2d(a: &[f64; 2], b: &[f64; 2], c: &[f64; 2], bound: f64) -> Certain {
    let [left, right] = value::orient2d_products(a, b, c);
    certain(left - right, bound, || orient_2d_bound(left + right))
}

/// The sign of `(b - a) x (d - c)`: the same roundings as in `orient2d`, one for each difference.
#[inline(always)]
pub(crate) fn cross(points: [&[f64; 2]; 4], bound: f64) -> Certain {
    let [left, right] = value::cross_products(points);
    certain(left - right, bound, || orient_2d_bound(left + right))
}

#[inline(always)]
pub(crate) fn orient3d(points: [&[f64; 3]; 4], bound: f64) -> Certain {
    certain(value::orient3d(points), bound, || {
        let ([p, q, r], z) = value::orient3d_rows(points);
        let permanent = z[0].abs() * minor_magnitude(q, r)
            + z[1].abs() * minor_magnitude(r, p)
            + z[2].abs() * minor_magnitude(p, q)
            + GUARD;
        ORIENT_3D * permanent
    })
}

#[inline(always)]
pub(crate) fn in_circle(points: [&[f64; 2]; 4], bound: f64) -> Certain {
    certain(value::in_circle(points), bound, || {
        let ([p, q, r], h) = value::in_circle_rows(points);
        let minors = [minor_magnitude(q, r), minor_magnitude(r, p), minor_magnitude(p, q)];
        IN_CIRCLE * in_circle_permanent(h.map(|h| h + GUARD), minors)
    })
}

/// Of points in a plane of space, projected onto the first two axes; heights are lengths in space.
pub(crate) fn in_circle_of_space(points: [&[f64; 3]; 4]) -> Certain {
    let ([p, q, r], h) = value::in_circle_of_space_rows(points);
    let det = h[0] * value::minor(q, r) + h[1] * value::minor(r, p) + h[2] * value::minor(p, q);
    certain(det, f64::INFINITY, || {
        let minors = [minor_magnitude(q, r), minor_magnitude(r, p), minor_magnitude(p, q)];
        IN_CIRCLE_OF_SPACE * in_circle_permanent(h.map(|h| h + GUARD), minors)
    })
}

#[inline(always)]
pub(crate) fn in_sphere(points: [&[f64; 3]; 5], bound: f64) -> Certain {
    certain(value::in_sphere(points), bound, || in_sphere_bound(points))
}

/// The error bound of a call.
#[inline(always)]
pub(crate) fn in_sphere_bound(points: [&[f64; 3]; 5]) -> f64 {
    let ([p, q, r, s], z, h) = value::in_sphere_rows(points);
    let [pz, qz, rz, sz] = z.map(f64::abs);
    let (pq, qr, rs) = (minor_magnitude(p, q), minor_magnitude(q, r), minor_magnitude(r, s));
    let (sp, pr, qs) = (minor_magnitude(s, p), minor_magnitude(p, r), minor_magnitude(q, s));
    let pqr = pz * qr + qz * pr + rz * pq + GUARD;
    let qrs = qz * rs + rz * qs + sz * qr + GUARD;
    let rsp = rz * sp + sz * pr + pz * rs + GUARD;
    let spq = sz * pq + pz * qs + qz * sp + GUARD;
    IN_SPHERE * in_sphere_permanent(h.map(|h| h + GUARD), [qrs, rsp, spq, pqr])
}
