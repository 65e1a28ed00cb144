//! Where a subsegment is split: at its middle, on a shell about an apex, or where a neighbour of the apex was split.
//!
//! ```text
//!            .w                  Two segments leave the apex z. A subsegment that touches z is split at a power of two
//!          .  |                  from it (a shell), if what encroaches upon it lies on another segment of z. One further
//!        .----v---.              out that v encroaches upon, v being on another segment of z, is split as far from z as
//!      z------e======            v is, if that is in its middle half. All others are split in the middle.
//! ```
//!
//! **Two-ray lemma.** Let two segments leave z at an angle a < 90 degrees, e cover the radii [r, r'] on one, v be at radius s
//! on the other. Then v encroaches upon e exactly if s^2 - s (r + r') cos a + r r' <= 0, and then r < s < r': of equal radii none
//! encroaches upon the other.
//!
//! **Termination.** (1) Innermost subsegments [0, s]: one that a point of the same cluster, at radius s' < s, encroaches upon is
//! split at a power of two. If s is one, then s' has an innermost radius that is at most s / 2, and s / 2 is not below it; from
//! the middle of a power of two comes another. If it is not, that happens once to it, and takes at most a third. Where angles
//! are 60 degrees or more, s' <= s cos a <= s / 2, so the middle is not below s' either. Others than the cluster are at a
//! distance from z: s is more than that, and so is not made less than its third. So innermost radii are bounded
//! below by some positive s0. (2) All other subsegments are at least s0 from their apexes, so at a distance L > 0 from whatever is not on their line,
//! and at least 2 L long if something encroaches upon them; a part has at least a quarter of the length. So no subsegment
//! gets arbitrarily short, each split makes one more, and their lengths add up to a constant.
//!
//! **Precision.** Radii are irrational fractions of a segment: equal ones are equal up to the bits that the apex asks for
//! ([`crate::apexes`]), and the lemma holds for them. Where doubles have these bits, parameters are doubles (`split/doubles.rs`): a third, a
//! half and a quarter above are so up to 2^-12 or better of the piece, which the proof has room for, its "a third" being anything
//! more than a quarter. Else they are as long as the apex asks for.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | both ends are apexes that want a shell | the lexicographically smaller one | `slivers_terminate` |
//! | no copy in the middle half | the middle | `fans_of_the_specification` |

use delone_mesh::VertexId;
use delone_predicates::{Dyadic, Metric, Sign};
use smallvec::SmallVec;

use crate::apexes::Apexes;
use crate::live::{Live, PieceId, Steiner, id};
use crate::parameter::Parameter;
use crate::ratio::{log4, root};

mod doubles;
mod mirror;

pub(crate) use doubles::radius;
use mirror::Opposite;

/// How Steiner points on segments are placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placement {
    /// Whether points are placed as far from an apex as those that encroach: see the module's text. Without, fans of segments
    /// of different lengths take many more.
    pub copies_radii: bool,
    /// Whether points are placed opposite those that encroach, about the bisector of the two lines: see `split/mirror.rs`. Without, segments
    /// close to each other take as many points as the gap between them goes into their lengths.
    pub mirrors: bool,
    /// Whether a subsegment that touches an apex is split on a shell whatever encroaches: so that the shells of a cluster fit, which
    /// refinement relies on. Else that is done only if what encroaches is of the cluster.
    pub always_shells: bool,
}

impl Default for Placement {
    fn default() -> Self {
        Self { copies_radii: true, mirrors: true, always_shells: false }
    }
}

/// Those of the two apexes of a piece that are in its closed diametral disk.
pub(crate) fn encroachers(live: &Live, piece: PieceId) -> SmallVec<[VertexId; 2]> {
    live.apexes(piece).filter(|&v| encroaches(live, piece, v)).collect()
}

/// Whether a vertex is in the closed diametral disk of a piece.
#[inline]
pub(crate) fn encroaches(live: &Live, piece: PieceId, v: VertexId) -> bool {
    let [a, b] = live.pieces[piece as usize].ends;
    live.kernel.dot([v, a, v, b]) != Sign::Positive
}

/// The parameter at which to split a piece upon which `encroachers` encroach.
pub(crate) fn parameter(
    live: &Live,
    apexes: &Apexes,
    piece: PieceId,
    encroachers: &[VertexId],
    placement: Placement,
) -> Parameter {
    let opposite =
        if placement.mirrors { mirror::opposite(live, piece, encroachers) } else { Opposite::new() };
    match doubles::parameter(live, apexes, piece, encroachers, &opposite, placement) {
        Some(t) => Parameter::Double(t),
        None => exact_parameter(live, apexes, piece, encroachers, &opposite, placement).into(),
    }
}

/// The same in numbers of any length.
fn exact_parameter(
    live: &Live,
    apexes: &Apexes,
    piece: PieceId,
    encroachers: &[VertexId],
    opposite: &[Parameter],
    placement: Placement,
) -> Dyadic {
    let segment = live.pieces[piece as usize].segment;
    let [t0, t1] = live.parameters(piece).map(|t| t.exact());
    let ends = live.pieces[piece as usize].ends;
    let mut copies = Vec::new();
    for z in [0, 1] {
        let apex = VertexId::new(live.segments[segment as usize][z] as usize);
        let Some(bits) = apexes.bits(apex) else { continue };
        let radii = encroachers.iter().filter_map(|&v| squared_radius(live, segment, apex, v));
        let radii: Vec<Dyadic> = radii.collect();
        let touches = ends[z] == apex;
        if radii.is_empty() && !(touches && placement.always_shells) {
            continue;
        }
        let square = live.squared_length(segment);
        let from_apex = |t: Dyadic| if z == 0 { t } else { Dyadic::from(1) - t };
        if touches {
            let length = t1 - &t0;
            return from_apex(root(&shell(&(&(&length * &length) * &square)), &square, bits));
        }
        copies.extend(radii.iter().map(|radius| from_apex(root(radius, &square, bits))));
    }
    let middle = (t0.clone() + &t1).half();
    if !placement.copies_radii {
        copies.clear();
    }
    copies.extend(opposite.iter().map(Parameter::exact));
    let quarter = (t1 - &t0).half().half();
    let off = |t: &Dyadic| {
        let off = t.clone() - &middle;
        if off.sign() == Sign::Negative { -off } else { off }
    };
    copies.into_iter().filter(|t| off(t) <= quarter).min_by_key(off).unwrap_or(middle)
}

/// The squared distance from the apex z, an end of `segment`, of a vertex on another segment of z.
pub(crate) fn squared_radius(
    live: &Live,
    segment: u32,
    z: VertexId,
    v: VertexId,
) -> Option<Dyadic> {
    let (other, from_z) = on_other(live, segment, z, v)?;
    let square = live.squared_length(other);
    Some(from_z.map_or(square.clone(), |(t, end)| {
        let share = t.exactly_away_from(end);
        &(&share * &share) * &square
    }))
}

/// The other segment of the apex z, an end of `segment`, that a vertex is on; and its parameter with the end from which to take it, none if it
/// is the segment's other end.
fn on_other(
    live: &Live,
    segment: u32,
    z: VertexId,
    v: VertexId,
) -> Option<(u32, Option<(&Parameter, usize)>)> {
    match live.steiner_of(v) {
        Some(Steiner::On { segment: other, t }) => {
            let end = live.segments[other as usize].iter().position(|&end| end == id(z))?;
            (other != segment).then_some((other, Some((t, end))))
        }
        Some(Steiner::Free) => None,
        None => {
            let other = live.segment_between([z, v])?;
            (other != segment).then_some((other, None))
        }
    }
}

/// The square of the greatest power of two that is at most two thirds of a length, which is more than a third.
fn shell(squared_length: &Dyadic) -> Dyadic {
    let four_ninths = |k: i64| Dyadic::from(9).scaled(2 * k) <= squared_length.clone().scaled(2);
    let k = log4(squared_length); // of two thirds it is this or one less
    let k = if four_ninths(k) { k } else { k - 1 };
    Dyadic::from(1).scaled(2 * k)
}

#[cfg(test)]
mod tests;
