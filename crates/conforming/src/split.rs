//! Where a subsegment is split: on a shell about an apex, where a neighbour of the apex was split, opposite what encroaches, or in the middle.
//!
//! ```text
//!            .w                  Two segments leave the apex z. A subsegment that touches z is split at a power of two
//!          .  |                  from it (a shell), if what encroaches upon it lies on another segment of z. One further
//!        .----v---.              out that v encroaches upon, v being on another segment of z, is split as far from z as
//!      z------e======            v is. If v is on no segment that shares an end with it, it is split at the foot of v's perpendicular
//!                                (split/feet.rs). Neither is done where a part would have less than a sixteenth: then it is split in the middle.
//! ```
//!
//! **Two-ray lemma.** Let two segments leave z at an angle a < 90 degrees, e cover the radii [r, r'] on one, v be at radius s
//! on the other. Then v encroaches upon e exactly if s^2 - s (r + r') cos a + r r' <= 0, and then r < s < r': of equal radii none
//! encroaches upon the other.
//!
//! **Termination.** (1) Innermost subsegments [0, s] at z. Let f(s) be s if that is a power of two, else half the greatest one in
//! s, and m the least f at z. What a point of the same cluster at radius s' < s encroaches upon is split at a power of two. If s
//! is one, that is s / 2, and the greatest power in the innermost radius before s', which is at most s', is not more: m is not
//! made less. If it is not, at least f(s) is left: neither is it. Where angles at z are all 60 degrees or more, no shells are
//! taken: but s' <= s cos a <= s / 2, so the middle is not below s'. Others than the cluster are at a distance d from z: s is
//! more than that, a sixteenth of s is left, and m is d / 64 or more. So innermost radii are bounded below by some positive s0.
//! (2) All other subsegments are at least s0 from their apexes, so at a distance L > 0 from whatever is not on their line, and at
//! least 2 L long if something encroaches upon them; a part has at least a sixteenth of the length. So no subsegment gets
//! arbitrarily short, each split makes one more, and their lengths add up to a constant.
//!
//! **Precision.** Radii are irrational fractions of a segment: equal ones are equal up to the bits that the apex asks for
//! ([`crate::apexes`]), and the lemma holds for them. Where doubles have these bits, parameters are doubles (`split/doubles.rs`):
//! a third, a half and a sixteenth above are so up to 2^-12 or better of the piece, which the proof has room for: any other parts
//! would do. Else they are as long as the apex asks for.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | both ends are apexes that want a shell | the lexicographically smaller one | `slivers_terminate` |
//! | no copy and no foot but near an end | the middle | `fans_of_the_specification` |
//! | two of them equally far from the middle | the one nearer to the lexicographically smaller end | `of_two_feet_as_good_the_first_is_taken` |
//! | a gap that is 10^-15 of what is along it | a few points for each end, of as many bits as it takes | `gaps_of_any_width_take_few_points` |

use delone_mesh::VertexId;
use delone_predicates::{Dyadic, Metric, Sign};
use smallvec::SmallVec;

use crate::apexes::Apexes;
use crate::live::{Live, PieceId, Steiner, id};
use crate::parameter::Parameter;
use crate::ratio::{log4, root};

mod doubles;
mod feet;

pub(crate) use doubles::radius;
use feet::Feet;

/// How Steiner points on segments are placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placement {
    /// Whether points are placed as far from an apex as those that encroach: see the module's text. Without, fans of segments
    /// of different lengths take many more.
    pub copies_radii: bool,
    /// Whether points are placed opposite those that encroach, at the feet of their perpendiculars: see `split/feet.rs`. Without,
    /// segments close to each other take as many points as the gap between them goes into their lengths.
    pub takes_feet: bool,
    /// Radii are copied and feet taken where each part gets at least one over this of the piece: 3 or more. 4 is the middle half.
    pub parts_max: u32,
    /// Whether a subsegment that touches an apex is split on a shell whatever encroaches: so that the shells of a cluster fit, which
    /// refinement relies on. Else that is done only if what encroaches is of the cluster.
    pub always_shells: bool,
}

impl Default for Placement {
    fn default() -> Self {
        Self { copies_radii: true, takes_feet: true, parts_max: 16, always_shells: false }
    }
}

impl Placement {
    /// How far from the middle of a piece copies and feet are taken, of its length.
    fn off_max(self) -> f64 {
        0.5 - 1.0 / f64::from(self.parts_max.max(3))
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
    let feet =
        if placement.takes_feet { feet::feet(live, piece, encroachers) } else { Feet::new() };
    match doubles::parameter(live, apexes, piece, encroachers, &feet, placement) {
        Some(t) => Parameter::Double(t),
        None => exact_parameter(live, apexes, piece, encroachers, &feet, placement).into(),
    }
}

/// The same in numbers of any length.
fn exact_parameter(
    live: &Live,
    apexes: &Apexes,
    piece: PieceId,
    encroachers: &[VertexId],
    feet: &[Parameter],
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
        if placement.copies_radii {
            copies.extend(radii.iter().map(|radius| from_apex(root(radius, &square, bits))));
        }
    }
    let middle = (t0.clone() + &t1).half();
    copies.extend(feet.iter().map(Parameter::exact));
    let off_max = &(t1 - &t0) * &Dyadic::from(placement.off_max());
    let off = |t: &Dyadic| {
        let off = t.clone() - &middle;
        if off.sign() == Sign::Negative { -off } else { off }
    };
    let copies = copies.into_iter().filter(|t| off(t) <= off_max);
    copies.min_by(|s, t| off(s).cmp(&off(t)).then_with(|| s.cmp(t))).unwrap_or(middle)
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
