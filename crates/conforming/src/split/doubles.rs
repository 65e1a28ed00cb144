//! The same in doubles, where these are precise enough: nearly always.
//!
//! **Precision.** A length is off by less than 3 u of itself, u = 2^-53, a parameter from an end by u, a radius, their product, by 5 u, a
//! radius over a length by 9 u: less than 2^-49. From the other end, 1 - s is off by u / 2, which is less than 2^-b of s where
//! s is at least 2^(b - 53). A middle is at least a fifth and at most four fifths into its piece; of a piece from an end its
//! distance to that end is, within the same bounds, half.

use delone_mesh::VertexId;
use smallvec::SmallVec;

use super::{Placement, on_other};
use crate::apexes::Apexes;
use crate::live::{Live, PieceId};
use crate::parameter::Parameter;

/// Bits of radii that are certain.
const BITS: u32 = 48;

/// The shortest piece, of its further end's parameter.
const SHORTEST: f64 = 1.0 / (1u64 << 40) as f64;

/// See [`super::parameter`]; `None` where it takes more than doubles.
pub(super) fn parameter(
    live: &Live,
    apexes: &Apexes,
    piece: PieceId,
    encroachers: &[VertexId],
    feet: &[Parameter],
    placement: Placement,
) -> Option<f64> {
    let segment = live.pieces[piece as usize].segment;
    let [Parameter::Double(t0), Parameter::Double(t1)] = live.parameters(piece) else {
        return None;
    };
    let (length, ends) = (live.length(segment)?, live.pieces[piece as usize].ends);
    if t1 - t0 < SHORTEST * t1 {
        return None;
    }
    let mut copies = SmallVec::<[f64; 4]>::new();
    for z in [0, 1] {
        let apex = VertexId::new(live.segments[segment as usize][z] as usize);
        let Some(bits) = apexes.bits(apex) else { continue };
        let touches = ends[z] == apex;
        if bits > BITS
            || touches && from_apex(z, (0.5 - placement.off_max()) * (t1 - t0), bits).is_none()
        {
            return None;
        }
        let is_of_cluster = |&v: &VertexId| on_other(live, segment, apex, v).is_some();
        let is_wanted = placement.always_shells || encroachers.iter().any(is_of_cluster);
        if touches && is_wanted {
            return from_apex(z, shell((t1 - t0) * length)? / length, bits);
        }
        for &v in encroachers {
            if is_of_cluster(&v) && placement.copies_radii {
                copies.push(from_apex(z, radius(live, segment, apex, v)? / length, bits)?);
            }
        }
    }
    for t in feet {
        let Parameter::Double(t) = t else { return None };
        copies.push(*t);
    }
    let middle = t0.midpoint(t1);
    let off = |t: f64| (t - middle).abs();
    let copies = copies.into_iter().filter(|&t| off(t) <= placement.off_max() * (t1 - t0));
    let nearest = copies.min_by(|&s, &t| off(s).total_cmp(&off(t)).then_with(|| s.total_cmp(&t)));
    Some(nearest.unwrap_or(middle))
}

/// The distance from the apex z, an end of `segment`, of a vertex on another segment of z.
pub(crate) fn radius(live: &Live, segment: u32, z: VertexId, v: VertexId) -> Option<f64> {
    let (other, from_z) = on_other(live, segment, z, v)?;
    let share = from_z.map_or(1.0, |(t, end)| t.away_from(end));
    Some(share * live.length(other)?)
}

/// The parameter at that distance from an end, as part of the segment; `None` if it takes more bits than a double has.
fn from_apex(end: usize, s: f64, bits: u32) -> Option<f64> {
    let least = f64::from_bits(u64::from(970 + bits) << 52); // 2^(bits - 53)
    if end == 0 { Some(s) } else { (s >= least).then_some(1.0 - s) }
}

/// The greatest power of two that is at most two thirds of a length, up to a rounding; `None` unless it is normal.
fn shell(length: f64) -> Option<f64> {
    let two_thirds = length / 1.5;
    let power = f64::from_bits(two_thirds.to_bits() >> 52 << 52);
    power.is_normal().then_some(power)
}
