//! Where segments meet at small angles: the sites around which subsegments are split at powers of two.
//!
//! **Definition.** A site is an *apex* if two of its segments make an angle of less than 60 degrees. Nothing is lost if one of a
//! little more counts too, and nothing rests on the last bit: doubles decide, with room on the safe side. The *precision* of
//! an apex is in bits: points at one nominal distance from it, each off by less than 2^-bits of it, do not encroach upon each
//! other's subsegments. The two-ray lemma (see [`crate::split`]) holds for radii that differ by less than (1 - cos a) / 4 of
//! themselves; sin^2 a / 2^3 is less than that.

use delone_cdt::Cdt;
use delone_mesh::{CellId, HalfEdge, VertexId};
use delone_predicates::{Constructed, Dyadic, Metric, Sign};

use crate::live::Live;
use crate::vector::{self, between, square};

/// More than enough for angles that are not tiny, and so little that both `t` and `1 - t` are mostly doubles.
const BITS_MIN: u32 = 30;

/// More bits than the lemma asks for.
const SLACK: i64 = 6;

/// The precision of each site; 0 if it is no apex.
#[derive(Clone, Debug)]
pub(crate) struct Apexes(Vec<u32>);

impl Apexes {
    /// Of the sites of a CDT.
    pub(crate) fn new(cdt: &Cdt, live: &Live) -> Self {
        let spokes = Spokes::of(live);
        let mut bits = vec![0; live.sites];
        let mut in_ring = Vec::new();
        for (z, &Spokes { count, ends }) in spokes.iter().enumerate() {
            match count {
                0 | 1 => {}
                2 => bits[z] = bits_between(&live.kernel, VertexId::new(z), ends),
                _ => in_ring.push(z),
            }
        }
        if !in_ring.is_empty() {
            let cells = cdt.mesh().cells_by_vertex(live.sites);
            for z in in_ring {
                let of = |cell| bits_at(cdt, &live.kernel, VertexId::new(z), cell);
                bits[z] = cells[z].map_or(0, of);
            }
        }
        Self(bits)
    }

    /// The bits of parameters at an apex; `None` if this is no apex.
    pub(crate) fn bits(&self, v: VertexId) -> Option<u32> {
        self.0.get(v.index()).copied().filter(|&bits| bits > 0)
    }
}

/// How many segments a site has, and the other ends of the first two.
#[derive(Clone, Copy)]
struct Spokes {
    count: u32,
    ends: [VertexId; 2],
}

impl Spokes {
    /// By site.
    fn of(live: &Live) -> Vec<Self> {
        let mut spokes = vec![Self { count: 0, ends: [VertexId::GHOST; 2] }; live.sites];
        for ends in &live.segments {
            let [a, b] = ends.map(|v| VertexId::new(v as usize));
            for (from, to) in [(a, b), (b, a)] {
                let Self { count, ends } = &mut spokes[from.index()];
                if let Some(end) = ends.get_mut(*count as usize) {
                    *end = to;
                }
                *count += 1;
            }
        }
        spokes
    }
}

/// The most that two neighbours among the segments of a site ask for.
fn bits_at(cdt: &Cdt, kernel: &Constructed<2>, z: VertexId, cell: CellId) -> u32 {
    let mesh = cdt.mesh();
    let mut spokes = mesh.ring(z, cell).filter(|&h| cdt.is_constrained(h));
    let end = |h: HalfEdge| mesh.destination(h);
    let Some(first) = spokes.next().map(end) else { return 0 };
    let mut before = first;
    let mut bits = 0;
    for next in spokes.map(end).chain([first]) {
        bits = bits.max(bits_between(kernel, z, [before, next]));
        before = next;
    }
    bits
}

/// What the angle between two segments asks for: 0 if it is 60 degrees or more.
fn bits_between(kernel: &Constructed<2>, z: VertexId, [u, w]: [VertexId; 2]) -> u32 {
    if u == w {
        return 0;
    }
    let at = |v: VertexId| kernel.position(u32::try_from(v.index()).expect("an id has 32 bits"));
    let [o, p, q] = [z, u, w].map(at);
    let [p, q] = [p, q].map(|v| [v[0] - o[0], v[1] - o[1]]);
    let (cross, along) = (p[0] * q[1] - p[1] * q[0], p[0] * q[0] + p[1] * q[1]);
    let squares = (p[0] * p[0] + p[1] * p[1]) * (q[0] * q[0] + q[1] * q[1]);
    let sine_square = cross * cross / squares;
    // Where neither sine nor cosine is small, and nothing overflows, their rounding is far less than the room.
    if squares.is_normal() && squares > 1e-200 && sine_square > 1e-4 {
        let is_acute = along > 0.0 && sine_square < 0.75 + 1e-9;
        return if is_acute { BITS_MIN } else { 0 };
    }
    if kernel.dot([z, u, z, w]) != Sign::Positive {
        return 0;
    }
    let [o, p, q] = [z, u, w].map(|v| at(v).map(Dyadic::from));
    let [p, q] = [p, q].map(|v| between(&o, &v));
    let squares = &square(&p) * &square(&q);
    let (Some(cross), Some(squares)) = (vector::cross(&p, &q).magnitude(), squares.magnitude())
    else {
        return 0; // segments do not overlap: a noded graph has no such angle
    };
    let asked = squares + 1 - 2 * cross + 3 + SLACK; // 1 / sin^2 a < 2^(squares + 1 - 2 cross)
    BITS_MIN.max(u32::try_from(asked).unwrap_or(BITS_MIN))
}
