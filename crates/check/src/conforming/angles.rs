//! The least angle of what is inside, and the exceptions at small input angles.
//!
//! **R1.** The angle between edges u and v is less than the bound if `u . v > 0` and `(u . v)^2 > c |u|^2 |v|^2`, c being the square of the
//! bound's cosine. **R2.** An exception has two corners on two segments that meet in a point at less than 60 degrees: `u . v > 0`
//! and `4 (u . v)^2 > |u|^2 |v|^2`.

use std::collections::{BTreeMap, BTreeSet};

use super::{Conformed, SteinerPoint, judge};
use crate::exact::{Integer, Number, Pure, Sign};
use crate::fault::Fault;
use crate::options::Options;
use crate::scene::Scene;
use crate::verdict::Verdict;

/// What is said of the angles of a refined triangulation.
#[derive(Clone, Copy, Debug)]
pub struct Angles<'a> {
    /// The square of the cosine of the least angle; between 0 and 1.
    pub cosine_square: f64,
    /// Whether each cell is inside, in the order of [`Conformed::cells`]: no angle of others counts.
    pub inside: &'a [bool],
    /// The cells inside that may have smaller angles, by index.
    pub exceptions: &'a [usize],
}

/// [`judge_conforming`](crate::judge_conforming), and whether all angles inside are at least the promised one, exactly, but for
/// exceptions, each of which touches two segments that meet at less than 60 degrees.
///
/// ```
/// use delone_check::{Angles, Conformed, Options, Promise, judge_refined};
///
/// let conformed = Conformed {
///     points: &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]],
///     steiner: &[],
///     cells: &[0, 1, 2],
///     segments: &[[0, 1], [1, 2], [2, 0]],
///     constrained: &[[0, 1], [1, 2], [0, 2]],
///     promise: Promise::Constrained,
/// };
/// // 45 degrees: exactly what the triangle has.
/// let mut angles = Angles { cosine_square: 0.5, inside: &[true], exceptions: &[] };
/// assert!(judge_refined(&conformed, &angles, &Options::default()).ok);
/// angles.cosine_square = 0.5f64.next_down();
/// assert!(judge_refined(&conformed, &angles, &Options::default()).has("small-angle"));
/// ```
#[must_use]
pub fn judge_refined(conformed: &Conformed<'_>, angles: &Angles<'_>, options: &Options) -> Verdict {
    judge(conformed, options, |scene, covered, report| {
        let cells = scene.cells.as_chunks::<3>().0;
        let known = angles.exceptions.iter().all(|&cell| cell < cells.len());
        if cells.len() != angles.inside.len() || !known || !angles.cosine_square.is_finite() {
            let expected = format!("a side for each of {} cells", cells.len());
            let length = angles.inside.len();
            return report.fault(Fault::BadLength { array: "inside", length, expected });
        }
        let exceptions: BTreeSet<usize> = angles.exceptions.iter().copied().collect();
        report.check("R1: no angle inside is less than the least, but for exceptions", |report| {
            let bound = Bound::new(angles.cosine_square);
            for (cell, corners) in cells.iter().enumerate() {
                if angles.inside[cell]
                    && !exceptions.contains(&cell)
                    && let Some(at) = bound.smaller_angle(scene, *corners)
                {
                    let cell = scene.witnesses(corners);
                    report.fault(Fault::SmallAngle { cell, at: scene.witness(at) });
                }
            }
        });
        report.check("R2: each exception touches segments that meet at less than 60", |report| {
            let rays = Rays::new(scene, conformed.steiner, covered);
            for &cell in &exceptions {
                let [a, b, c] = cells[cell];
                let touch = |&[p, q]: &[u32; 2]| rays.meet_sharply(scene, p, q);
                if ![[a, b], [b, c], [c, a]].iter().any(touch) {
                    let cell = scene.witnesses(&[a, b, c]);
                    report.fault(Fault::NoException { cell });
                }
            }
        });
    })
}

/// The square of a cosine as a ratio: `numerator / 2^digits`.
struct Bound {
    numerator: Pure,
    denominator: Pure,
}

impl Bound {
    /// Of a number that is finite and not negative; from 1 on, no angle is less.
    fn new(cosine_square: f64) -> Self {
        let bits = cosine_square.clamp(0.0, 1.0).to_bits();
        let mantissa = i64::try_from(bits & ((1 << 52) - 1)).unwrap_or(0);
        let exponent = u32::try_from(bits >> 52 & 0x7ff).unwrap_or(0);
        let implicit = i64::from(exponent > 0) << 52;
        // Up to 1, the exponent of the unit is at most -52.
        let digits = 1075 - exponent.max(1);
        Self {
            numerator: Pure::shifted(mantissa + implicit, 0),
            denominator: Pure::shifted(1, digits),
        }
    }

    /// A corner whose angle is less.
    fn smaller_angle(&self, scene: &Scene<'_>, [a, b, c]: [u32; 3]) -> Option<u32> {
        let corners = [[a, b, c], [b, c, a], [c, a, b]];
        corners.into_iter().find(|&[z, p, q]| self.is_more(scene, z, [p, q])).map(|[z, ..]| z)
    }

    /// Whether the angle at z is less: its cosine is more.
    fn is_more(&self, scene: &Scene<'_>, z: u32, [p, q]: [u32; 2]) -> bool {
        let z = &scene.at[z as usize];
        // Each of the two vectors times the product of two positive denominators: both sides are of degree two in either.
        let [u, v] = [p, q].map(|p| {
            let p = &scene.at[p as usize];
            [0, 1].map(|x| p[x].times(&z[2]).minus(&z[x].times(&p[2])))
        });
        let dot = |u: &[Pure; 2], v: &[Pure; 2]| u[0].times(&v[0]).plus(&u[1].times(&v[1]));
        let uv = dot(&u, &v);
        let squares = dot(&u, &u).times(&dot(&v, &v));
        let over = uv.times(&uv).times(&self.denominator).minus(&squares.times(&self.numerator));
        uv.exact_sign() == Sign::Positive && over.exact_sign() == Sign::Positive
    }
}

/// The segments between points that are chains of edges, by the points at their ends.
struct Rays<'a> {
    steiner: &'a [SteinerPoint<'a>],
    points: usize,
    from: BTreeMap<u32, BTreeSet<u32>>,
}

impl<'a> Rays<'a> {
    fn new(
        scene: &Scene<'_>,
        steiner: &'a [SteinerPoint<'a>],
        covered: &BTreeSet<[u32; 2]>,
    ) -> Self {
        let points = scene.points.len();
        let mut from: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
        let on = steiner.iter().filter_map(|steiner| match *steiner {
            SteinerPoint::On { ends, .. } => Some(ends),
            SteinerPoint::At(_) | SteinerPoint::Exactly(_) => None,
        });
        let whole = covered.iter().copied().filter(|e| e.iter().all(|&v| (v as usize) < points));
        for [a, b] in on.chain(whole) {
            from.entry(a).or_default().insert(b);
            from.entry(b).or_default().insert(a);
        }
        Self { steiner, points, from }
    }

    /// The segments that a vertex is on, seen from an end that it is not: from where to where.
    fn through(&self, v: u32) -> Vec<[u32; 2]> {
        match (v as usize).checked_sub(self.points).and_then(|place| self.steiner.get(place)) {
            Some(&SteinerPoint::On { ends: [a, b], .. }) => vec![[a, b], [b, a]],
            Some(SteinerPoint::At(_) | SteinerPoint::Exactly(_)) => Vec::new(),
            None => self.from.get(&v).into_iter().flatten().map(|&z| [z, v]).collect(),
        }
    }

    /// Whether two vertices are on two segments that meet at less than 60 degrees.
    fn meet_sharply(&self, scene: &Scene<'_>, p: u32, q: u32) -> bool {
        let sixty = Bound::new(0.25);
        let of_q = self.through(q);
        self.through(p).into_iter().any(|[z, b]| {
            let others = of_q.iter().filter(|&&[at, c]| at == z && c != b);
            others.into_iter().any(|&[_, c]| sixty.is_more(scene, z, [b, c]))
        })
    }
}
