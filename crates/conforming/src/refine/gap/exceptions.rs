//! Where triangles at small input angles may fill a gap, so that it asks for nothing.
//!
//! **Exceptions** are triangles whose shortest edge joins, at one distance from it, two segments of an apex z (`refine/shells.rs`). They
//! might stand in for the triangles that [`super`] counts only where a line across the gap meets nothing else. Then there are two cases.
//!
//! (1) The shortest edge crosses the line. It makes 60 degrees or more with both segments of z, so that its ends are outside of J, if the
//! line is in the inner nine tenths of J and g is less than a twentieth: those inside are on a or c, along which it would run. Then a or c
//! is between the two segments, nearer than their far ends.
//!
//! (2) All shortest edges are on one side of the line or the other. Then the corners on one side lead from a to c, each step being along
//! the two segments of an apex, from segment to segment over sites that they share.
//!
//! A gap is told only if neither can be.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | both sides of the gap are between segments of an apex, which their own is not | it is not told | `a_gap_within_a_wedge_is_not_told` |
//! | apexes lead around its end | it is not told | `a_gap_round_which_apexes_lead_is_not_told` |

use delone_mesh::VertexId;

use crate::apexes::Apexes;
use crate::live::{Live, id};

/// A cosine a little below that of 60 degrees.
const COSINE: f64 = 0.499_999;

/// More than doubles are off by, in terms of lengths.
const SLACK: f64 = 1e-9;

/// The segments at apexes.
pub(super) struct Clusters<'a> {
    live: &'a Live,
    apexes: Apexes,
    /// By site, the other ends of its segments.
    spokes: Vec<Vec<u32>>,
    /// By site: the cluster of the segments there that end in an apex, each cluster being those that hang together.
    of_site: Vec<Option<u32>>,
}

impl<'a> Clusters<'a> {
    pub(super) fn new(live: &'a Live, apexes: Apexes) -> Self {
        let mut spokes = vec![Vec::new(); live.sites];
        for &[a, b] in &live.segments {
            spokes[a as usize].push(b);
            spokes[b as usize].push(a);
        }
        let is_apex = |v: u32| apexes.bits(VertexId::new(v as usize)).is_some();
        let mut of_site: Vec<Option<u32>> = vec![None; live.sites];
        let mut stack = Vec::new();
        for first in 0..id(VertexId::new(live.sites)) {
            if is_apex(first) && of_site[first as usize].is_none() {
                of_site[first as usize] = Some(first);
                stack.push(first);
            }
            while let Some(v) = stack.pop() {
                for &w in &spokes[v as usize] {
                    let hangs = is_apex(v) || is_apex(w);
                    if hangs && of_site[w as usize].replace(first).is_none() {
                        stack.push(w);
                    }
                }
            }
        }
        Self { live, apexes, spokes, of_site }
    }

    /// Whether no exceptions may stand in for the triangles between two segments.
    pub(super) fn leave_alone(&self, subsegments: [u32; 2]) -> bool {
        let [a, c] = subsegments.map(|s| self.live.segments[s as usize]);
        let hang_together = a.iter().any(|&v| {
            let of_v = self.of_site[v as usize];
            of_v.is_some() && c.iter().any(|&w| self.of_site[w as usize] == of_v)
        });
        !hang_together && [a, c].iter().all(|segment| !self.encloses(segment))
    }

    /// Whether a segment may be between two segments that meet at less than 60 degrees in an apex that is not its own end: what joins segments
    /// on both sides of one that comes from the apex itself does not run along that.
    fn encloses(&self, ends: &[u32; 2]) -> bool {
        let [p, q] = ends.map(|v| self.live.kernel.position(v));
        let middle = [p[0] + 0.5 * (q[0] - p[0]), p[1] + 0.5 * (q[1] - p[1])];
        (0u32..).zip(&self.spokes).any(|(z, spokes)| {
            self.apexes.bits(VertexId::new(z as usize)).is_some()
                && !ends.contains(&z)
                && is_between(self.live, z, spokes, middle)
        })
    }
}

/// Whether a place has segments of a site on both sides, at less than 60 degrees, that reach as far: rather yes than no.
fn is_between(live: &Live, z: u32, spokes: &[u32], place: [f64; 2]) -> bool {
    let at = live.kernel.position(z);
    let polar = |p: [f64; 2]| {
        let [x, y] = [p[0] - at[0], p[1] - at[1]];
        let length = x.hypot(y);
        ([x / length, y / length], length)
    };
    let (d, to_place) = polar(place);
    let (mut left, mut right, mut reach) = (false, false, 0.0f64);
    for &end in spokes {
        let (s, length) = polar(live.kernel.position(end));
        let (cosine, sine) = (d[0] * s[0] + d[1] * s[1], d[0] * s[1] - d[1] * s[0]);
        if !(cosine + sine + length / to_place).is_finite() {
            return true; // beyond what doubles tell
        }
        if cosine >= COSINE {
            left |= sine >= -SLACK;
            right |= sine <= SLACK;
            reach = reach.max(length / to_place);
        }
    }
    left && right && reach >= 1.0 - SLACK
}
