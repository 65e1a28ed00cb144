//! Squared radii of smallest spheres, exactly; and what is claimed of them.
//!
//! With edges b from the first vertex, G their products, and r = b^2 + w_0 - w for each, the squared radius of the sphere orthogonal to
//! the simplex with its centre in the simplex's flat is (r G^-1 r) / 4 - w_0, and the power of a point at c, of weight w, less w, to
//! it is c^2 + w_0 - w - (b c) G^-1 r: both are determinants of G with a border, over that of G.

use std::cmp::Ordering;
use std::fmt;

use dashu_int::IBig;

use crate::exact::determinant::determinant;
use crate::exact::lattice::decode;
use crate::exact::{Integer, Sign};

/// Coordinates and weights as integers: over 2^low, and over 2^(2 low).
pub(super) struct Integers<const D: usize> {
    points: Vec<[IBig; D]>,
    weights: Vec<IBig>,
    low: i32,
}

/// `above / below`, times 2^exponent; `below` is positive.
#[derive(Clone, Debug)]
pub(super) struct Radius {
    pub(super) above: IBig,
    pub(super) below: IBig,
    pub(super) exponent: i32,
}

fn scaled(x: f64, low: i32) -> IBig {
    let (mantissa, exponent) = decode(x);
    if mantissa == 0 {
        return IBig::ZERO;
    }
    IBig::from(mantissa) << usize::try_from(exponent - low).expect("low is least")
}

impl<const D: usize> Integers<D> {
    /// Of finite numbers.
    pub(super) fn new(points: &[[f64; D]], weights: Option<&[f64]>) -> Self {
        let weights = weights.map_or_else(|| vec![0.0; points.len()], <[f64]>::to_vec);
        let lowest = |numbers: &[f64]| {
            let exponents = numbers.iter().map(|&x| decode(x)).filter(|(m, _)| *m != 0);
            exponents.map(|(_, exponent)| exponent).min().unwrap_or(0)
        };
        let low = lowest(points.as_flattened()).min(lowest(&weights).div_euclid(2));
        Self {
            points: points.iter().map(|p| p.map(|x| scaled(x, low))).collect(),
            weights: weights.iter().map(|&w| scaled(w, 2 * low)).collect(),
            low,
        }
    }

    fn edge(&self, from: u32, to: u32) -> [IBig; D] {
        let [p, q] = [from, to].map(|v| &self.points[v as usize]);
        std::array::from_fn(|axis| &q[axis] - &p[axis])
    }

    /// The determinant of G, bordered below and, if there is a border, on the right by r.
    fn bordered(&self, simplex: &[u32], border: Option<(&[IBig], IBig)>) -> IBig {
        let edges: Vec<[IBig; D]> =
            simplex[1..].iter().map(|&v| self.edge(simplex[0], v)).collect();
        let size = edges.len() + usize::from(border.is_some());
        let mut matrix = Vec::with_capacity(size * size);
        for (edge, &v) in edges.iter().zip(&simplex[1..]) {
            matrix.extend(edges.iter().map(|other| dot(edge, other)));
            matrix.extend(border.is_some().then(|| self.power(simplex[0], v)));
        }
        if let Some((row, corner)) = border {
            matrix.extend_from_slice(row);
            matrix.push(corner);
        }
        if matrix.is_empty() { IBig::ONE } else { determinant(size, &matrix) }
    }

    /// b^2 + w_0 - w
    fn power(&self, origin: u32, v: u32) -> IBig {
        let edge = self.edge(origin, v);
        dot(&edge, &edge) + &self.weights[origin as usize] - &self.weights[v as usize]
    }

    /// Of the smallest sphere of a simplex that is not flat.
    pub(super) fn radius(&self, simplex: &[u32]) -> Radius {
        let powers: Vec<IBig> = simplex[1..].iter().map(|&v| self.power(simplex[0], v)).collect();
        let corner = &self.weights[simplex[0] as usize] * IBig::from(4);
        Radius {
            above: -self.bordered(simplex, Some((&powers, corner))),
            below: self.bordered(simplex, None) * IBig::from(4),
            exponent: 2 * self.low,
        }
    }

    /// Whether a vertex is strictly inside that sphere.
    pub(super) fn is_inside(&self, simplex: &[u32], v: u32) -> bool {
        let c = self.edge(simplex[0], v);
        let row: Vec<IBig> =
            simplex[1..].iter().map(|&b| dot(&self.edge(simplex[0], b), &c)).collect();
        let corner = self.power(simplex[0], v);
        self.bordered(simplex, Some((&row, corner))).exact_sign() == Sign::Negative
    }
}

fn dot<const D: usize>(a: &[IBig; D], b: &[IBig; D]) -> IBig {
    a.iter().zip(b).fold(IBig::ZERO, |sum, (x, y)| sum + x * y)
}

/// `x 2^e` against `y 2^f`.
fn compare(x: &IBig, e: i32, y: &IBig, f: i32) -> Ordering {
    let least = e.min(f);
    let [up_x, up_y] = [e, f].map(|exponent| usize::try_from(exponent - least).unwrap_or_default());
    (x << up_x).cmp(&(y << up_y))
}

impl Radius {
    /// Against `above / below`, times 2^exponent, `below` being positive.
    fn against(&self, above: &IBig, below: &IBig, exponent: i32) -> Ordering {
        compare(&(&self.above * below), self.exponent, &(above * &self.below), exponent)
    }
}

impl PartialEq for Radius {
    fn eq(&self, other: &Self) -> bool {
        self.against(&other.above, &other.below, other.exponent) == Ordering::Equal
    }
}

impl PartialOrd for Radius {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.against(&other.above, &other.below, other.exponent))
    }
}

impl fmt::Display for Radius {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{} * 2^{}", self.above, self.below, self.exponent)
    }
}

/// What is said of a value.
pub(super) enum Claimed {
    Fraction(IBig, IBig),
    Nearest(f64),
}

impl Claimed {
    /// `None` if it is neither.
    pub(super) fn read(text: &str, is_fraction: bool) -> Option<Self> {
        if !is_fraction {
            return text.parse().ok().filter(|x: &f64| x.is_finite()).map(Self::Nearest);
        }
        let (above, below) = text.split_once('/').unwrap_or((text, "1"));
        let (above, below) = (above.parse().ok()?, below.parse().ok()?);
        (below > IBig::ZERO).then_some(Self::Fraction(above, below))
    }

    /// Whether the value is that, or rounds to it.
    pub(super) fn tells(&self, value: &Radius) -> bool {
        match self {
            Self::Fraction(above, below) => value.against(above, below, 0) == Ordering::Equal,
            Self::Nearest(x) => {
                value.against_middle(*x, x.next_down()) != Ordering::Less
                    && value.against_middle(*x, x.next_up()) != Ordering::Greater
            }
        }
    }
}

impl Radius {
    /// Against the middle of two doubles next to each other; beside infinity, against the largest double.
    fn against_middle(&self, x: f64, next: f64) -> Ordering {
        let next = if next.is_finite() { next } else { x };
        let ((a, e), (b, f)) = (decode(x), decode(next));
        let low = e.min(f);
        let [a, b] = [(a, e), (b, f)].map(|(mantissa, exponent)| {
            IBig::from(mantissa) << usize::try_from(exponent - low).unwrap_or_default()
        });
        self.against(&(a + b), &IBig::from(2), low)
    }
}
