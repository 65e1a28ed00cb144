//! How a point is constructed from plain ones, and its exact value.

use std::fmt;

use crate::ring::{Homogeneous, dot, minor, minus};
use crate::{Dyadic, Sign};

/// A point defined by plain points, named by id.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Construction {
    /// `a + t (b - a)`, exactly, in any dimension. `t` may be outside 0..1.
    SegmentPoint {
        /// Where `t` is 0.
        a: u32,
        /// Where `t` is 1.
        b: u32,
        /// The parameter.
        t: Dyadic,
    },
    /// The crossing of the lines `ab` and `cd` in the plane.
    Crossing {
        /// Of the first line.
        a: u32,
        /// Of the first line.
        b: u32,
        /// Of the second line.
        c: u32,
        /// Of the second line.
        d: u32,
    },
    /// The crossing of the line `ab` and the plane through three points, in space.
    LinePlane {
        /// Of the line.
        a: u32,
        /// Of the line.
        b: u32,
        /// The plane.
        plane: [u32; 3],
    },
    /// The common point of three planes in space.
    ThreePlanes {
        /// Three points for each.
        planes: [[u32; 3]; 3],
    },
}

/// Why a construction makes no point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ConstructionError {
    /// There is no point of this id.
    Unknown {
        /// The id.
        id: u32,
    },
    /// This id is that of a constructed point.
    NotPlain {
        /// The id.
        id: u32,
    },
    /// The lines, the line and the plane, or the planes have no point in common or more than one; or one of them is not
    /// spanned by its points.
    Parallel,
    /// There is no such construction in this dimension.
    Dimension {
        /// The dimension.
        dimension: usize,
    },
}

impl fmt::Display for ConstructionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { id } => {
                write!(f, "there is no point {id}: construct from plain points")
            }
            Self::NotPlain { id } => {
                write!(
                    f,
                    "point {id} is constructed: construct from the plain points that define it"
                )
            }
            Self::Parallel => {
                write!(f, "the lines or planes do not meet in one point: construct from others")
            }
            Self::Dimension { dimension } => {
                write!(
                    f,
                    "points are not constructed so in {dimension} dimensions: use a segment point"
                )
            }
        }
    }
}

impl std::error::Error for ConstructionError {}

type Vector<const D: usize> = [Dyadic; D];

impl Construction {
    /// The ids of the plain points.
    pub(super) fn parents(&self) -> impl Iterator<Item = u32> {
        let ids: smallvec::SmallVec<[u32; 9]> = match *self {
            Self::SegmentPoint { a, b, .. } => [a, b].into_iter().collect(),
            Self::Crossing { a, b, c, d } => [a, b, c, d].into_iter().collect(),
            Self::LinePlane { a, b, plane: [p, q, r] } => [a, b, p, q, r].into_iter().collect(),
            Self::ThreePlanes { planes } => planes.into_iter().flatten().collect(),
        };
        ids.into_iter()
    }

    /// The point, `at` giving the plain ones.
    pub(super) fn value<const D: usize>(
        &self,
        at: impl Fn(u32) -> [f64; D],
    ) -> Result<Homogeneous<Dyadic, D>, ConstructionError> {
        let wrong = ConstructionError::Dimension { dimension: D };
        let at = |id: u32| at(id).map(Dyadic::from);
        match self {
            Self::SegmentPoint { a, b, t } => {
                let (a, b) = (at(*a), at(*b));
                let step = from(&b, &a);
                Ok(Homogeneous::plain(std::array::from_fn(|x| &step[x] * t + &a[x])))
            }
            &Self::Crossing { a, b, c, d } => {
                let points = [a, b, c, d].map(|id| same::<D, 2>(at(id)));
                let [Some(a), Some(b), Some(c), Some(d)] = points else { return Err(wrong) };
                normalized(crossing(&a, &b, &c, &d))
            }
            &Self::LinePlane { a, b, plane: [p, q, r] } => {
                let points = [a, b, p, q, r].map(|id| same::<D, 3>(at(id)));
                let [Some(a), Some(b), Some(p), Some(q), Some(r)] = points else {
                    return Err(wrong);
                };
                normalized(line_plane(&a, &b, &[p, q, r]))
            }
            Self::ThreePlanes { planes } => {
                let planes = planes.map(|plane| plane.map(|id| same::<D, 3>(at(id))));
                let [Some(first), Some(second), Some(third)] = planes.map(all) else {
                    return Err(wrong);
                };
                normalized(three_planes(&[first, second, third]))
            }
        }
    }
}

fn all([p, q, r]: [Option<Vector<3>>; 3]) -> Option<[Vector<3>; 3]> {
    Some([p?, q?, r?])
}

/// The vector as one of N coordinates, if N is D.
fn same<const D: usize, const N: usize>(vector: Vector<D>) -> Option<Vector<N>> {
    Vec::from(vector).try_into().ok()
}

fn from<const D: usize>(p: &Vector<D>, origin: &Vector<D>) -> Vector<D> {
    std::array::from_fn(|axis| minus(p[axis].clone(), &origin[axis]))
}

/// A point that is `origin + numerator / w`.
struct Offset<const N: usize> {
    origin: Vector<N>,
    numerator: Vector<N>,
    w: Dyadic,
}

/// With a positive denominator.
fn normalized<const D: usize, const N: usize>(
    offset: Offset<N>,
) -> Result<Homogeneous<Dyadic, D>, ConstructionError> {
    let Offset { origin, numerator, w } = offset;
    let x = std::array::from_fn::<_, N, _>(|axis| &origin[axis] * &w + &numerator[axis]);
    let x = same::<N, D>(x).ok_or(ConstructionError::Dimension { dimension: D })?;
    match w.sign() {
        Sign::Zero => Err(ConstructionError::Parallel),
        Sign::Positive => Ok(Homogeneous { x, w }),
        Sign::Negative => Ok(Homogeneous { x: x.map(|x| -x), w: -w }),
    }
}

/// `a + ((c - a) x (d - c)) / ((b - a) x (d - c)) (b - a)`.
fn crossing(a: &Vector<2>, b: &Vector<2>, c: &Vector<2>, d: &Vector<2>) -> Offset<2> {
    let (along, other, between) = (from(b, a), from(d, c), from(c, a));
    let cross = |u: &Vector<2>, v: &Vector<2>| minor(&u[0], &u[1], &v[0], &v[1]);
    let times = cross(&between, &other);
    let w = cross(&along, &other);
    Offset { origin: a.clone(), numerator: along.map(|x| x * &times), w }
}

/// The cross product of two vectors of space.
fn normal(u: &Vector<3>, v: &Vector<3>) -> Vector<3> {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| minor(&u[i], &u[j], &v[i], &v[j]))
}

/// `a + (n . (p - a)) / (n . (b - a)) (b - a)`, n being the plane's normal.
fn line_plane(a: &Vector<3>, b: &Vector<3>, [p, q, r]: &[Vector<3>; 3]) -> Offset<3> {
    let n = normal(&from(q, p), &from(r, p));
    let along = from(b, a);
    let times = dot(&n, &from(p, a));
    let w = dot(&n, &along);
    Offset { origin: a.clone(), numerator: along.map(|x| x * &times), w }
}

/// By Cramer's rule for `n_i . (x - o) = n_i . (p_i - o)`, o being a point of the first plane.
fn three_planes(planes: &[[Vector<3>; 3]; 3]) -> Offset<3> {
    let [first, second, third] = planes;
    let origin = &first[0];
    let [l, m, n] = planes.each_ref().map(|[p, q, r]| normal(&from(q, p), &from(r, p)));
    let height = |normal: &Vector<3>, p: &Vector<3>| dot(normal, &from(p, origin));
    let (second, third) = (height(&m, &second[0]), height(&n, &third[0]));
    let (nl, lm) = (normal(&n, &l), normal(&l, &m));
    let numerator = std::array::from_fn(|x| &second * &nl[x] + &third * &lm[x]);
    Offset { origin: origin.clone(), numerator, w: dot(&l, &normal(&m, &n)) }
}
