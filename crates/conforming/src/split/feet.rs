//! Opposite what encroaches: the foot of its perpendicular on the piece.
//!
//! ```text
//!     q ----v---------      At p there are right angles, so v is in the disk of neither part of s.
//!           :
//!     s ----p---------
//! ```
//! Nor is p in the disk of a piece of q that ends at v. Let the lines of q and s meet, at an angle a, and v be r' from there:
//! then p is at s = r' cos a. By the two-ray lemma of the module above no piece beyond v has p in its disk, as s < r'; nor has a
//! piece [r, r'] before it, as s^2 - s (r + r') cos a + r r' = r r' sin^2 a > 0.
//! So nothing is handed to and fro: segments along a gap take some points for each end, however narrow it is. With middles alone
//! they take as many as the gap goes into their lengths.
//!
//! **Not of neighbours.** Where r may be 0, the segments sharing an end, p would encroach upon [0, r'], and so on down to the
//! end. There radii are copied, if the angle is less than 60 degrees, and middles taken else.
//!
//! **Precision.** Nothing but the number of points rests on it. At a distance h from the line, v is in neither disk while p is
//! off its place by less than h^2 over their length. Doubles are taken where they are off by far less than that, else as many
//! bits as that asks for.

use delone_mesh::VertexId;
use delone_predicates::{Dyadic, Sign};
use smallvec::SmallVec;

use super::on_other;
use crate::live::{Live, PieceId, Steiner, id};
use crate::parameter::Parameter;
use crate::ratio::quotient;
use crate::vector::{between, cross, dot, square};

/// Parameters on the segment of a piece.
pub(super) type Feet = SmallVec<[Parameter; 2]>;

/// Where h^2 over the length is more than this times the greatest coordinate, it is far more than what doubles are off by.
const ERROR: f64 = 1.0 / (1u64 << 44) as f64;

/// More bits than the disks ask for.
const SLACK: i64 = 10;

/// The fewest bits: those of the first approximation.
const BITS_MIN: u32 = 48;

/// The feet, on the line of a piece, of those that encroach upon it and are not on a segment that shares an end with its own.
pub(super) fn feet(live: &Live, piece: PieceId, encroachers: &[VertexId]) -> Feet {
    let segment = live.pieces[piece as usize].segment;
    let ends = live.segments[segment as usize].map(|z| VertexId::new(z as usize));
    let is_near = |v: VertexId| ends.iter().any(|&z| on_other(live, segment, z, v).is_some());
    let far = encroachers.iter().filter(|&&v| !is_near(v));
    far.map(|&v| match near_foot(live, piece, v) {
        Some(t) => Parameter::Double(t),
        None => exact_foot(live, piece, v).into(),
    })
    .collect()
}

/// The parameter of the foot of v on the segment of a piece, d u / u^2, with u along it and d from its first end to v; `None` if
/// doubles are too coarse.
fn near_foot(live: &Live, piece: PieceId, v: VertexId) -> Option<f64> {
    let [Parameter::Double(t0), Parameter::Double(t1)] = live.parameters(piece) else {
        return None;
    };
    let segment = live.pieces[piece as usize].segment;
    let [a, b] = live.segments[segment as usize].map(|z| live.kernel.position(z));
    let at = live.kernel.position(id(v));
    let [u, d] = [b, at].map(|p| [p[0] - a[0], p[1] - a[1]]);
    let square = u[0] * u[0] + u[1] * u[1];
    let cross = u[0] * d[1] - u[1] * d[0];
    let reach = [a, b, at].as_flattened().iter().fold(0.0f64, |reach, x| reach.max(x.abs()));
    // Neither under- nor overflow gets through: that makes the left side 0, or a side infinite.
    let is_certain = cross * cross > ERROR * reach * (t1 - t0) * square * square.sqrt();
    (is_certain && square.is_normal() && cross.is_finite())
        .then(|| (d[0] * u[0] + d[1] * u[1]) / square)
}

/// The same in numbers of any length.
fn exact_foot(live: &Live, piece: PieceId, v: VertexId) -> Dyadic {
    let segment = live.pieces[piece as usize].segment;
    let at = |z: u32| live.kernel.position(z).map(Dyadic::from);
    let ends = |segment: u32| live.segments[segment as usize].map(at);
    let v = match live.steiner_of(v) {
        Some(Steiner::On { segment, t }) => {
            let [a, b] = ends(segment);
            let (w, t) = (between(&a, &b), t.exact());
            [0, 1].map(|axis| &t * &w[axis] + &a[axis])
        }
        _ => at(id(v)),
    };
    let [a, b] = ends(segment);
    let (u, d) = (between(&a, &b), between(&a, &v));
    let (square, cross, along) = (square(&u), cross(&u, &d), dot(&u, &d));
    let [t0, t1] = live.parameters(piece).map(|t| t.exact());
    let sizes = [&square, &(t1 - &t0), &along, &cross].map(Dyadic::magnitude);
    let [Some(square_size), Some(share), Some(foot), Some(off)] = sizes else {
        return Dyadic::ZERO; // at the first end, or on the line: no place for a point
    };
    if along.sign() == Sign::Negative {
        return Dyadic::ZERO;
    }
    // h^2 over the length, as part of what is to the foot: cross^2 / (u^2 share d u).
    let bits = u32::try_from(square_size + share + foot - 2 * off + SLACK).unwrap_or(0);
    quotient(&along, &square, bits.max(BITS_MIN))
}
