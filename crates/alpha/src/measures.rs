//! Area and perimeter of a shape of the plane along its filtration, and exact values as text.
//!
//! Areas are exact until they are rounded once. Lengths are square roots: each is rounded, their sum is not but once more, so that
//! what comes and goes again leaves nothing behind.

use dashu_int::IBig;
use delone_predicates::{Dyadic, Sign, SquaredRadius};

use crate::geometry::Geometry;
use crate::{AlphaFiltration, Interval};

impl<const D: usize> AlphaFiltration<D> {
    /// For each cut, from the empty one on, the area of the shape and the length of its boundary, of the triangles alone; in the
    /// plane, that is for sites of two coordinates. The boundary of what touches itself is counted on every side.
    #[must_use]
    pub fn plane_measures(&self) -> Option<Vec<[f64; 2]>> {
        let points: &[[f64; D]] = match self.geometry() {
            Geometry::Plain(kernel) => kernel.points(),
            Geometry::Weighted(kernel) => kernel.points(),
        };
        if D != 2 {
            return None;
        }
        let at = |v: u32| [0, 1].map(|axis| Dyadic::from(points[v as usize][axis]));
        let mut changes = vec![[Dyadic::ZERO, Dyadic::ZERO]; self.rank_count() + 1];
        let simplices = self.simplices();
        if simplices.dimension() == Some(2) {
            for (id, vertices, _) in simplices.level(2) {
                let [p, q, r] = [0, 1, 2].map(|i| at(vertices[i]));
                changes[self.ranks()[id] as usize + 1][0] += &doubled_area(&p, &q, &r).half();
            }
            let intervals = self.intervals();
            let first = self.first_triangles();
            for (place, (id, vertices, _)) in simplices.level(1).enumerate() {
                let [p, q] = [0, 1].map(|i| points[vertices[i] as usize]);
                let length = Dyadic::from((q[0] - p[0]).hypot(q[1] - p[1]));
                changes[first[place] as usize + 1][1] += &length;
                let Interval { hi, .. } = intervals[id];
                if hi != Interval::NEVER {
                    changes[hi as usize + 1][1] -= &length;
                }
            }
        }
        let mut sums = [Dyadic::ZERO, Dyadic::ZERO];
        let rounded = changes.iter().map(|change| {
            sums.iter_mut().zip(change).for_each(|(sum, more)| *sum += more);
            sums.each_ref().map(Dyadic::to_f64)
        });
        Some(rounded.collect())
    }

    /// Of each edge of the plane, the rank of its first triangle.
    fn first_triangles(&self) -> Vec<u32> {
        let rank = |cell: &Option<u32>| cell.map(|cell| self.ranks()[cell as usize]);
        let beside = self.cells_beside_facets();
        let first = beside.iter().map(|sides| sides.iter().filter_map(rank).min());
        first.map(|rank| rank.expect("an edge has a triangle")).collect()
    }
}

fn doubled_area(p: &[Dyadic; 2], q: &[Dyadic; 2], r: &[Dyadic; 2]) -> Dyadic {
    let from = |a: &[Dyadic; 2], axis: usize| a[axis].clone() - &p[axis];
    let area = from(q, 0) * &from(r, 1) - from(q, 1) * &from(r, 0);
    if area.sign() == Sign::Negative { -area } else { area }
}

/// An exact value as a reduced fraction, `n/d` or `n`; `inf` if it is infinite.
///
/// ```
/// use delone_alpha::fraction;
/// use delone_predicates::{Adaptive, Metric};
/// let kernel = Adaptive::new([[0.0, 0.0], [1.0, 0.0], [0.5, 1.5]]);
/// assert_eq!(fraction(&kernel.exact_squared_radius(&[0usize, 1, 2])), "25/36");
/// ```
#[must_use]
pub fn fraction(value: &SquaredRadius) -> String {
    use dashu_int::ops::Gcd;
    if value.denominator().sign() == Sign::Zero {
        return "inf".to_owned();
    }
    let (n, d) = (value.numerator(), value.denominator());
    let low = n.exponent().min(d.exponent());
    let (n, d) = (integer(n, low), integer(d, low));
    let common = IBig::from((&n).gcd(&d));
    let (n, d) = (n / &common, d / &common);
    if d == IBig::ONE { n.to_string() } else { format!("{n}/{d}") }
}

/// The number over `2^low`.
fn integer(number: &Dyadic, low: i64) -> IBig {
    let shift = usize::try_from(number.exponent() - low).expect("low is the least exponent");
    let limbs = number.mantissa().iter().rev();
    let magnitude = limbs.fold(IBig::ZERO, |sum, &limb| (sum << 64) + IBig::from(limb)) << shift;
    if number.sign() == Sign::Negative { -magnitude } else { magnitude }
}

#[cfg(test)]
mod tests;
