//! Opposite a vertex that encroaches: its mirror image on the piece, about the bisector of its line and the piece's.
//!
//! ```text
//!     q -----v-------      Let v be on another line q, at less than 60 degrees to the piece's. Its image about the bisector of the two lines is as
//!            :             far from where they meet as v is. So by the two-ray lemma of [`super`] neither encroaches upon pieces that
//!     s -----+-------      end at the other, and the image of the image is v: nothing is handed on. Any two segments along a gap
//!                          take a few points for what each end costs, whatever the gap.
//! ```
//!
//! Opposite a vertex with no such line is the foot of its perpendicular: it makes right angles there, and is in neither disk.
//!
//! **Which line.** Of a Steiner point its segment's; of a site, of the segments it has, the one at the least angle. One on a segment that shares an end
//! with the piece's has no image here: radii are copied if that end is an apex, and nothing is gained otherwise.
//!
//! **Precision.** Nothing but the number of points rests on it. At a distance h from the line, v is in the disk of neither part, [a, p] or [p, b], while
//! p is off its place by less than h^2 over their length. Doubles are taken where their errors are far less than that, else as many bits as that asks for.

use delone_mesh::{CellId, VertexId};
use delone_predicates::{Dyadic, Sign};
use smallvec::SmallVec;

use super::on_other;
use crate::live::{Live, PieceId, Steiner, id};
use crate::parameter::Parameter;
use crate::ratio::{quotient, root};

/// Parameters on the segment of a piece.
pub(super) type Opposite = SmallVec<[Parameter; 2]>;

/// Of two lines at less than this, the image is taken: the cosine.
const COSINE_MIN: f64 = 0.5;

/// Where h^2 / |u| is more than this times the greatest coordinate, it is more than eight times what doubles are off by.
const ERROR: f64 = 1.0 / (1u64 << 46) as f64;

/// More bits than the disks ask for.
const SLACK: i64 = 6;

/// The fewest bits that are worth the way.
const BITS_MIN: u32 = 60;

/// The points on the line of a piece that are opposite those of its apexes that encroach upon it.
pub(super) fn opposite(live: &Live, piece: PieceId, encroachers: &[VertexId]) -> Opposite {
    let half = live.half_edge(piece);
    let segment = live.pieces[piece as usize].segment;
    let ends = live.segments[segment as usize].map(|z| VertexId::new(z as usize));
    let shares_end = |v: VertexId| ends.iter().any(|&z| on_other(live, segment, z, v).is_some());
    let sides = [half, live.mesh.twin(half)].map(|h| (live.mesh.apex(h), h.cell()));
    let seen = sides.into_iter().filter(|&(v, _)| encroachers.contains(&v) && !shares_end(v));
    seen.map(|(v, cell)| image(live, segment, v, facing(live, segment, v, cell))).collect()
}

/// The line of a vertex about which it has an image on `segment`; `None` if it has the foot of its perpendicular.
fn facing(live: &Live, segment: u32, v: VertexId, cell: CellId) -> Option<u32> {
    let [ux, uy] = direction(live, segment);
    // Their squared sine, if they are close.
    let angle = |&line: &u32| {
        let [wx, wy] = direction(live, line);
        let (along, cross) = (ux * wx + uy * wy, ux * wy - uy * wx);
        let squares = (ux * ux + uy * uy) * (wx * wx + wy * wy);
        (along * along > COSINE_MIN * COSINE_MIN * squares).then_some(cross * cross / squares)
    };
    match live.steiner_of(v) {
        Some(Steiner::On { segment: line, .. }) => angle(&line).map(|_| line),
        Some(Steiner::Free) => None,
        None => {
            let lines = live.mesh.ring(v, cell).filter_map(|h| live.piece_of(h));
            let lines = lines.map(|piece| live.pieces[piece as usize].segment);
            let angles = lines.filter_map(|line| Some((angle(&line)?, line)));
            angles.min_by(|(a, _), (b, _)| a.total_cmp(b)).map(|(_, line)| line)
        }
    }
}

/// From the first end of a segment to the other, to the nearest doubles.
fn direction(live: &Live, segment: u32) -> [f64; 2] {
    let [a, b] = live.segments[segment as usize].map(|z| live.kernel.position(z));
    [b[0] - a[0], b[1] - a[1]]
}

/// The parameter on `segment` of what is opposite v, which is on `line`, or on none.
fn image(live: &Live, segment: u32, v: VertexId, line: Option<u32>) -> Parameter {
    match near_image(live, segment, v, line) {
        Some(t) => Parameter::Double(t),
        None => exact_image(live, segment, v, line).into(),
    }
}

/// With u and w along the two, turned to each other, and d from the first end to v: the image p of v has v - p perpendicular to u / |u| + w / |w|,
/// so that t (|u| |w| + u w) = d u |w| / |u| + d w.
fn near_image(live: &Live, segment: u32, v: VertexId, line: Option<u32>) -> Option<f64> {
    let dot = |p: [f64; 2], q: [f64; 2]| p[0] * q[0] + p[1] * q[1];
    let [a, b] = live.segments[segment as usize].map(|z| live.kernel.position(z));
    let at = live.kernel.position(id(v));
    let (u, d) = (direction(live, segment), [at[0] - a[0], at[1] - a[1]]);
    let square = dot(u, u);
    let cross = u[0] * d[1] - u[1] * d[0];
    let reach = [a, b, at].as_flattened().iter().fold(0.0f64, |reach, x| reach.max(x.abs()));
    if !(cross * cross > ERROR * reach * square * square.sqrt()) {
        return None;
    }
    let t = match line {
        None => dot(d, u) / square,
        Some(line) => {
            let w = direction(live, line);
            let w = if dot(u, w) < 0.0 { w.map(|x| -x) } else { w };
            let ratio = (dot(w, w) / square).sqrt();
            (dot(d, u) * ratio + dot(d, w)) / (square * ratio + dot(u, w))
        }
    };
    t.is_finite().then_some(t)
}

/// The same in numbers of any length.
fn exact_image(live: &Live, segment: u32, v: VertexId, line: Option<u32>) -> Dyadic {
    let dot = |p: &[Dyadic; 2], q: &[Dyadic; 2]| &p[0] * &q[0] + &p[1] * &q[1];
    let from = |a: &[Dyadic; 2], b: &[Dyadic; 2]| [0, 1].map(|axis| b[axis].clone() - &a[axis]);
    let at = |z: u32| live.kernel.position(z).map(Dyadic::from);
    let along = |segment: u32| {
        let [a, b] = live.segments[segment as usize].map(at);
        from(&a, &b)
    };
    let a = at(live.segments[segment as usize][0]);
    let v = match live.steiner_of(v) {
        Some(Steiner::On { segment, t }) => {
            let [from, w] = [at(live.segments[segment as usize][0]), along(segment)];
            let t = t.exact();
            [0, 1].map(|axis| &t * &w[axis] + &from[axis])
        }
        _ => at(id(v)),
    };
    let (u, d) = (along(segment), from(&a, &v));
    let square = dot(&u, &u);
    let cross = &u[0] * &d[1] - &u[1] * &d[0];
    let (Some(whole), Some(off)) = (square.magnitude(), cross.magnitude()) else {
        return Dyadic::ZERO; // on the line: no image is in the piece
    };
    let bits = u32::try_from(2 * (whole - off) + SLACK).unwrap_or(0).max(BITS_MIN);
    let (n, d) = match line {
        None => (dot(&d, &u), square),
        Some(line) => {
            let w = along(line);
            let w = if dot(&u, &w).sign() == Sign::Negative { w.map(|x| -x) } else { w };
            let ratio = root(&dot(&w, &w), &square, bits);
            (&dot(&d, &u) * &ratio + dot(&d, &w), &square * &ratio + dot(&u, &w))
        }
    };
    if n.sign() == Sign::Positive { quotient(&n, &d, bits) } else { Dyadic::ZERO }
}
