//! Gaps: why a triangulation without small angles may have to be large.
//!
//! ```text
//!      c ---------.-----.--------        Each triangle between the segments a and c that has no angle below
//!                / `.   / `.    g        alpha is over at most 2 g / tan alpha of what they run along each other:
//!      a -------.-----.-----.----        so there are many.
//!               |<--- J --->|
//! ```
//!
//! **Lemma.** Let a and c run along each other over the length J, at most g apart, nothing between them. A triangle between them whose
//! least angle is alpha or more is over at most 2 g / tan alpha of it. *Proof.* Cut it across the gap, everywhere. From either tip the cuts get
//! longer in proportion, up to the cut k through the middle corner, where the area is k w / 2, w being the width. The longest side
//! being l >= w, the area is at least that of the isosceles triangle over it with angles alpha, l^2 tan alpha / 4: so k >= w tan alpha / 2.
//! Cuts over J are at most g long. If k is one of them, w <= 2 g / tan alpha; if not, what is over J is the part of one tip, where at the distance d
//! from it the cut is d k / w or more, so that d <= 2 g / tan alpha.
//!
//! Exceptions at input angles may stand in for the triangles above; where they might, no gap is told (`gap/exceptions.rs`).
//!
//! **Cost.** That of the CDT, and O(m) for each of a few candidates, m being the segments.
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | the segments share an end | no gap: what is between them is at an input angle | `a_wedge_is_no_gap` |
//! | a gap outside | it takes no triangles | `gaps_count_where_they_are_inside` |
//! | ends that do not face each other | the length along which they do | `a_gap_is_as_long_as_its_segments_face_each_other` |

use delone_cdt::{Fill, FillError, Inside, cavity};
use delone_delaunay::Options;
use delone_mesh::{HalfEdge, VertexId};
use delone_predicates::{Dyadic, Sign};
use delone_sites::Pslg;

use crate::apexes::Apexes;
use crate::live::{Live, id};
use crate::ratio::quotient;
use crate::vector::{between, cross, dot, square};
use exceptions::Clusters;

mod exceptions;

/// The most candidates that are looked at, from those that ask for most triangles on.
const CANDIDATES_MAX: usize = 256;

/// The least length of a gap over its width, which the proof asks for.
const RATIO_MIN: f64 = 20.0;

/// Of a gap, the part that is counted on: the inner nine tenths, less what doubles are off by.
const COUNTED: f64 = 0.899_999;

/// Two subsegments that run along each other with nothing between them: see the module's text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// The two, by index, smaller first.
    pub subsegments: [u32; 2],
    /// How far they run along each other.
    pub length: f64,
    /// How far apart they are there, at most.
    pub width: f64,
    /// There is no triangulation with fewer triangles that has no smaller angles but at input angles.
    pub triangles_min: f64,
}

/// The gap inside that asks for most triangles with no angle less than this one; none if none asks for many.
///
/// ```
/// use delone_cdt::Fill;
/// use delone_conforming::narrowest_gap;
/// use delone_sites::Pslg;
///
/// let slot = [[0.0, 0.0], [1e6, 0.0], [1e6, 1e-6], [0.0, 1e-6]];
/// let pslg = Pslg::new(&slot, &[[0, 1], [1, 2], [2, 3], [3, 0]]).unwrap();
/// let gap = narrowest_gap(&pslg, &Fill::Exterior, 20.7).unwrap().unwrap();
/// assert!(gap.subsegments == [0, 3] && (gap.width - 1e-6).abs() < 1e-15);
/// assert!(gap.triangles_min > 1e11);
/// ```
///
/// # Errors
/// If the rule for what is inside does not apply: see [`Inside::new`].
pub fn narrowest_gap(
    pslg: &Pslg,
    fill: &Fill,
    angle_deg_min: f64,
) -> Result<Option<Gap>, FillError> {
    let cdt = cavity(pslg, &Options::default(), &mut ());
    let inside = Inside::new(&cdt, pslg, fill)?;
    if cdt.mesh().dimension() != Some(2) {
        return Ok(None);
    }
    let live = Live::new(&cdt, pslg);
    let tangent = angle_deg_min.clamp(0.0, 60.0).to_radians().tan();
    let mut gaps = Vec::new();
    for cell in cdt.mesh().solid_cells() {
        let is_inside = inside.by_region()[inside.regions().of_cell(cell) as usize];
        for h in cdt.mesh().facets(cell).filter(|_| is_inside) {
            if live.piece_of(h).is_none() {
                gaps.extend(across(&live, h, tangent));
            }
        }
    }
    gaps.sort_by(|a, b| b.triangles_min.total_cmp(&a.triangles_min));
    gaps.truncate(CANDIDATES_MAX);
    let clusters = Clusters::new(&live, Apexes::new(&cdt, &live));
    Ok(gaps.into_iter().find(|gap| clusters.leave_alone(gap.subsegments)))
}

/// The gaps between opposite sides of the two triangles of an edge, each seen from one side of the triangle of `h`.
fn across(live: &Live, h: HalfEdge, tangent: f64) -> impl Iterator<Item = Gap> + use<'_> {
    let mesh = &live.mesh;
    let twin = mesh.twin(h);
    // The triangles x, y, u and y, x, w: the sides ux and wy face each other, and so do uy and wx.
    let (x, y) = (mesh.origin(h), mesh.destination(h));
    let (u, w) = (mesh.apex(h), mesh.apex(twin));
    let sides = [
        ([u, x], [y, w], mesh.prev(h), mesh.prev(twin)),
        ([u, y], [x, w], mesh.next(h), mesh.next(twin)),
    ];
    sides.into_iter().filter_map(move |(base, other, of_base, of_other)| {
        let subsegments = [live.piece_of(of_base)?, live.piece_of(of_other)?];
        gap(live, base, other, subsegments, tangent)
    })
}

/// The gap between the base from `u` to `x` and another segment, the first end of which faces the base.
fn gap(
    live: &Live,
    [u, x]: [VertexId; 2],
    other: [VertexId; 2],
    subsegments: [u32; 2],
    tangent: f64,
) -> Option<Gap> {
    let at = |v: VertexId| live.kernel.position(id(v)).map(Dyadic::from);
    let origin = at(u);
    let along = between(&origin, &at(x));
    // Along the base and off it, both times its length.
    let [(start, low), (end, high)] = other.map(|v| {
        let p = between(&origin, &at(v));
        let off = cross(&along, &p);
        (dot(&along, &p), if off.sign() == Sign::Negative { -off } else { off })
    });
    let whole = square(&along);
    let span = end.clone() - &start;
    let first = if start.sign() == Sign::Negative { Dyadic::ZERO } else { start.clone() };
    let last = if end < whole { end } else { whole.clone() };
    let faced = last.clone() - &first;
    if faced.sign() != Sign::Positive {
        return None;
    }
    // The heights over the ends of what is faced, times `span`.
    let rise = high - &low;
    let height = |place: &Dyadic| &low * &span + &(&rise * &(place.clone() - &start));
    let (near, far) = (height(&first), height(&last));
    let most = if near < far { far } else { near };
    if most.sign() != Sign::Positive {
        return None;
    }
    let ratio = quotient(&(&faced * &span), &most, 53).to_f64(); // of length to width
    let length = live.length(subsegments[0])? * quotient(&faced, &whole, 53).to_f64();
    let [a, b] = subsegments;
    (ratio > RATIO_MIN).then(|| Gap {
        subsegments: [a.min(b), a.max(b)],
        length,
        width: length / ratio,
        triangles_min: COUNTED * ratio * tangent / 2.0,
    })
}

#[cfg(test)]
mod tests;
