//! The exact arrangement of segments: where they cross, there is a vertex.
//!
//! ```text
//!    b     d          The crossing x is a vertex defined by the ends a, b, c, d of two pieces of segments: its
//!     \   /           coordinates are ratios that no double may hold, and no rounding enters. Three segments through
//!      \ /            one point have one vertex there.
//!       x
//!      / \
//!     c   a
//! ```
//!
//! **Method.** The segments are noded at the sites ([`Pslg`]). All pairs of pieces that cross are found; each crossing is
//! constructed in a [`Constructed`] kernel; equal ones are united; each piece is cut at its crossings, in their lexicographic
//! order. **Numbering.** Sites first, then crossings in lexicographic order: no trace of how they were found.
//! **Cost.** For k crossings O(k log k) exact comparisons and the search for near pairs.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | several segments through one point | one vertex | `segments_through_one_point_have_one_vertex` |
//! | a crossing at a site | no new vertex | `segments_through_one_point_have_one_vertex` |
//! | overlaps, repeated segments, T-junctions | as of [`Pslg`]: shared pieces, cuts | `chains_lead_from_end_to_end` |
//! | crossings that round to one double, or to a site | are two vertices still | `crossings_closer_than_doubles_are_two` |

use delone_predicates::{Constructed, Construction, Kernel};

use crate::{Chains, Pslg, PslgError, Sites};

/// Segments cut wherever they meet, exactly. See the module's text.
///
/// ```
/// use delone_sites::Arrangement;
///
/// let square = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.0, 1.0]];
/// let crossed = Arrangement::new(&square, &[[0, 2], [1, 3]]).unwrap();
/// assert_eq!(crossed.kernel().position(4), [1.5, 0.5]);
/// assert_eq!(crossed.subsegments(), [[0, 4], [1, 4], [2, 4], [3, 4]]);
/// assert_eq!([0, 1].map(|segment| crossed.chains().of(segment)), [[0, 2], [1, 3]]);
/// ```
#[derive(Clone, Debug)]
pub struct Arrangement {
    sites: Sites<2>,
    kernel: Constructed<2>,
    sorted: Vec<u32>,
    segments: Vec<[u32; 2]>,
    subsegments: Vec<[u32; 2]>,
    chains: Chains,
    dropped: Vec<u32>,
    pairs: usize,
    crossings: Vec<[u32; 4]>,
}

impl Arrangement {
    /// The arrangement of segments between points.
    ///
    /// # Errors
    /// With every coordinate that is not finite, and every segment that names no point.
    pub fn new(points: &[[f64; 2]], segments: &[[usize; 2]]) -> Result<Self, PslgError> {
        Ok(Self::of(Pslg::crossed(points, segments)?))
    }

    fn of(pslg: Pslg) -> Self {
        let pairs = pslg.crossing_pieces();
        let (kernel, vertex_of, crossings) = constructed(&pslg, &pairs);
        let count = u32::try_from(kernel.len()).expect("vertices are fewer than ids");
        let mut sorted: Vec<u32> = (0..count).collect();
        sorted.sort_by(|&u, &v| kernel.compare_lexicographic(u as usize, v as usize));
        let mut ranks = vec![0; kernel.len()];
        for (rank, &vertex) in (0u32..).zip(&sorted) {
            ranks[vertex as usize] = rank;
        }
        let mut on_piece = vec![Vec::new(); pslg.subsegments.len()];
        for (pair, &vertex) in pairs.iter().zip(&vertex_of) {
            pair.iter().for_each(|&piece| on_piece[piece as usize].push(vertex));
        }
        let (subsegments, parts) = cut(&pslg, on_piece, &ranks);
        let chains = chains(&pslg, &parts, &subsegments);
        let Pslg { sites, segments, dropped, .. } = pslg;
        let pairs = pairs.len();
        Self { sites, kernel, sorted, segments, subsegments, chains, dropped, pairs, crossings }
    }

    /// The sites: vertices 0 to `sites().len() - 1`. The others are crossings.
    #[must_use]
    pub fn sites(&self) -> &Sites<2> {
        &self.sites
    }

    /// The vertices, exactly.
    #[must_use]
    pub fn kernel(&self) -> &Constructed<2> {
        &self.kernel
    }

    /// The vertices in lexicographic order.
    #[must_use]
    pub fn sorted(&self) -> &[u32] {
        &self.sorted
    }

    /// The input segments, their ends as sites.
    #[must_use]
    pub fn segments(&self) -> &[[u32; 2]] {
        &self.segments
    }

    /// The pieces: smaller vertex first, in increasing order, each once.
    #[must_use]
    pub fn subsegments(&self) -> &[[u32; 2]] {
        &self.subsegments
    }

    /// For each input segment its subsegments from its first end to its second.
    #[must_use]
    pub fn chains(&self) -> &Chains {
        &self.chains
    }

    /// Input segments of no length.
    #[must_use]
    pub fn dropped(&self) -> &[u32] {
        &self.dropped
    }

    /// How many pairs of pieces cross; several pairs may cross in one vertex.
    #[must_use]
    pub fn crossing_count(&self) -> usize {
        self.pairs
    }

    /// For each vertex after the sites, the sites that define it: the line of the first two crosses that of the last two.
    #[must_use]
    pub fn crossings(&self) -> &[[u32; 4]] {
        &self.crossings
    }
}

/// The sites and the distinct crossings, these in lexicographic order; the vertex of each pair; the sites that define each
/// crossing.
fn constructed(pslg: &Pslg, pairs: &[[u32; 2]]) -> (Constructed<2>, Vec<u32>, Vec<[u32; 4]>) {
    let ends = |&[piece, other]: &[u32; 2]| {
        let [[a, b], [c, d]] = [piece, other].map(|piece| pslg.subsegments[piece as usize]);
        [a, b, c, d]
    };
    let push = |kernel: &mut Constructed<2>, [a, b, c, d]: [u32; 4]| {
        let crossing = Construction::Crossing { a, b, c, d };
        kernel.push(&crossing).expect("pieces that cross are not parallel")
    };
    let points = pslg.sites.points().to_vec();
    let mut all = Constructed::new(points.clone());
    let mut found: Vec<(u32, usize)> =
        pairs.iter().enumerate().map(|(place, pair)| (push(&mut all, ends(pair)), place)).collect();
    let order = |u: u32, v: u32| all.compare_lexicographic(u as usize, v as usize);
    found.sort_by(|&(u, _), &(v, _)| order(u, v).then(u.cmp(&v)));
    let mut kernel = Constructed::new(points);
    let (mut vertex_of, mut crossings) = (vec![0; pairs.len()], Vec::new());
    for equal in found.chunk_by(|&(u, _), &(v, _)| order(u, v).is_eq()) {
        let defined = ends(&pairs[equal[0].1]);
        let vertex = push(&mut kernel, defined);
        crossings.push(defined);
        equal.iter().for_each(|&(_, place)| vertex_of[place] = vertex);
    }
    (kernel, vertex_of, crossings)
}

/// All pieces cut at the vertices on them, sorted; and for each old piece the ends of its parts, from smaller to larger site.
fn cut(pslg: &Pslg, on_piece: Vec<Vec<u32>>, ranks: &[u32]) -> (Vec<[u32; 2]>, Vec<Vec<[u32; 2]>>) {
    let parts: Vec<Vec<[u32; 2]>> = pslg
        .subsegments
        .iter()
        .zip(on_piece)
        .map(|(&[a, b], mut stops)| {
            stops.extend([a, b]);
            stops.sort_unstable_by_key(|&vertex| ranks[vertex as usize]);
            stops.dedup(); // several may cross the piece in one vertex
            if ranks[a as usize] > ranks[b as usize] {
                stops.reverse();
            }
            stops.windows(2).map(|ends| [ends[0].min(ends[1]), ends[0].max(ends[1])]).collect()
        })
        .collect();
    let mut subsegments: Vec<[u32; 2]> = parts.iter().flatten().copied().collect();
    subsegments.sort_unstable();
    (subsegments, parts)
}

/// The chains of input segments over the parts.
fn chains(pslg: &Pslg, parts: &[Vec<[u32; 2]>], subsegments: &[[u32; 2]]) -> Chains {
    let number = |part: &[u32; 2]| {
        let place = subsegments.binary_search(part).expect("a part is a subsegment");
        u32::try_from(place).expect("subsegments are fewer than ids")
    };
    let chain = |(chain, &[first, _]): (&[u32], &[u32; 2])| {
        let mut at = first;
        let mut numbers = Vec::new();
        for &piece in chain {
            let [low, high] = pslg.subsegments[piece as usize];
            let along = parts[piece as usize].iter().map(number);
            if at == low {
                numbers.extend(along);
                at = high;
            } else {
                numbers.extend(along.rev());
                at = low;
            }
        }
        numbers
    };
    pslg.chains.iter().zip(&pslg.segments).map(chain).collect()
}

#[cfg(test)]
mod tests;
