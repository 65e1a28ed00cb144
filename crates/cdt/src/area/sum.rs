//! Sums of the areas of triangles between the vertices of a kernel.

use std::collections::BTreeSet;

use dashu_int::{IBig, UBig};
use delone_predicates::{Constructed, Dyadic, Sign};

use super::Area;

/// What is needed to sum areas: the vertices, and the finest power of two among plain ones.
pub(crate) struct Areas<'k> {
    kernel: &'k Constructed<2>,
    low: i64,
}

impl<'k> Areas<'k> {
    pub(crate) fn new(kernel: &'k Constructed<2>) -> Self {
        let plain = (0u32..).zip(kernel.positions()).filter(|&(v, _)| kernel.is_plain(v));
        let coordinates = plain.flat_map(|(_, p)| *p).filter(|&x| x != 0.0);
        let low = coordinates.map(|x| Dyadic::from(x).exponent()).min();
        Self { kernel, low: low.unwrap_or(0) }
    }

    /// The area of all the triangles together, which are counter-clockwise and do not overlap. Only their common boundary is
    /// looked at: twice the area is the sum over its edges of x y' - y x'.
    pub(crate) fn sum(&self, triangles: &[[usize; 3]]) -> Area {
        let mut boundary: BTreeSet<[usize; 2]> = BTreeSet::new();
        for &[a, b, c] in triangles {
            for [u, v] in [[a, b], [b, c], [c, a]] {
                if !boundary.remove(&[v, u]) {
                    boundary.insert([u, v]);
                }
            }
        }
        let mut integers = IBig::ZERO;
        let mut ratios = Vec::new();
        for [u, v] in boundary {
            if [u, v].iter().all(|&v| self.kernel.is_plain(id(v))) {
                integers += self.cross(u, v);
            } else {
                ratios.push(self.ratio(u, v));
            }
        }
        ratios.push(Area::dyadic(integers, 2 * self.low - 1));
        total(ratios)
    }

    /// x y' - y x' of two plain vertices, in units of `2^(2 low)`.
    fn cross(&self, u: usize, v: usize) -> IBig {
        let integer = |x: &f64| {
            let (integer, exponent) = split(&Dyadic::from(*x));
            if integer.is_zero() { integer } else { integer << super::size_of(exponent - self.low) }
        };
        let [[a, b], [c, d]] = [u, v].map(|v| self.kernel.positions()[v].each_ref().map(integer));
        a * d - b * c
    }

    /// Half of x y' - y x' of two vertices.
    fn ratio(&self, u: usize, v: usize) -> Area {
        let [p, q] = [u, v].map(|v| self.kernel.exact(id(v)));
        let over = &p.x[0] * &q.x[1] - &p.x[1] * &q.x[0];
        let under = &p.w * &q.w;
        let ((over, up), (under, down)) = (split(&over), split(&under));
        let size = super::size_of(up - down - 1);
        let under = UBig::try_from(under).expect("denominators are positive");
        if up > down { Area::ratio(over << size, under) } else { Area::ratio(over, under << size) }
    }
}

fn id(v: usize) -> u32 {
    u32::try_from(v).expect("vertices are fewer than ids")
}

/// The sum, by halves: so that long denominators meet late.
pub(crate) fn total(mut terms: Vec<Area>) -> Area {
    while terms.len() > 1 {
        terms = terms
            .chunks(2)
            .map(|pair| {
                let mut sum = pair[0].clone();
                pair[1..].iter().for_each(|term| sum += term);
                sum
            })
            .collect();
    }
    terms.pop().unwrap_or_default()
}

/// `x = integer * 2^exponent`.
fn split(x: &Dyadic) -> (IBig, i64) {
    let bytes: Vec<u8> = x.mantissa().iter().flat_map(|limb| limb.to_le_bytes()).collect();
    let size = IBig::from(UBig::from_le_bytes(&bytes));
    (if x.sign() == Sign::Negative { -size } else { size }, x.exponent())
}
