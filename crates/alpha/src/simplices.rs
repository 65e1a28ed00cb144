//! All simplices of a triangulation: the faces of its solid cells, each once, with their facets; in flat arrays.
//!
//! **In.** A mesh. **Out.** For each dimension the simplices in lexicographic order of their sorted vertices, and the facets of
//! each.
//! **Invariants.** 1. Ids go up with the dimension, within one in lexicographic order. 2. The facet at place `i` lacks the vertex at
//! place `i`.
//! **Cost.** From the cells down: the facets of all simplices are dealt out by their first vertex and sorted there, O(N log m) for
//! N simplices, m of them around a vertex. 8 (k + 1) bytes a k-simplex.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | no site | no simplices, no dimension | `few_sites_have_few_simplices` |
//! | a mesh of lower dimension | the faces of its own cells | `few_sites_have_few_simplices` |
//! | hidden sites | they are no vertices | `hidden_sites_are_no_vertices` |

use delone_mesh::Mesh;

use crate::bulk::narrow;

/// A simplex, by its place among all: vertices first, then edges, and so on; within a dimension in lexicographic order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SimplexId(u32);

impl SimplexId {
    /// The simplex of this place.
    ///
    /// # Panics
    /// If the place is 2^32 or more.
    #[inline]
    #[must_use]
    pub fn new(index: usize) -> Self {
        Self(narrow(index))
    }

    /// The place, from 0.
    #[inline]
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// The simplices of a triangulation. See the module's text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Simplices {
    levels: Vec<Level>,
}

/// The simplices of one dimension.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Level {
    /// The place of the first one among all.
    first: usize,
    /// The sorted vertices of each.
    vertices: Vec<u32>,
    /// The places of the facets of each, among all; none of vertices.
    facets: Vec<u32>,
}

impl Simplices {
    /// The faces of a mesh's solid cells.
    ///
    /// # Panics
    /// If there are 2^32 or more.
    #[must_use]
    pub fn of<const D: usize>(mesh: &Mesh<D>) -> Self {
        let Some(dimension) = mesh.dimension() else { return Self { levels: Vec::new() } };
        let mut levels = vec![Level::default(); dimension + 1];
        levels[dimension] = match dimension + 1 {
            1 => cells::<D, 1>(mesh),
            2 => cells::<D, 2>(mesh),
            3 => cells::<D, 3>(mesh),
            4 => cells::<D, 4>(mesh),
            5 => cells::<D, 5>(mesh),
            6 => cells::<D, 6>(mesh),
            7 => cells::<D, 7>(mesh),
            8 => cells::<D, 8>(mesh),
            corners => panic!("a cell has {corners} corners: predicates go to 8"),
        };
        for k in (0..dimension).rev() {
            let (below, above) = levels.split_at_mut(k + 1);
            below[k] = match k + 1 {
                1 => facets::<1>(&mut above[0]),
                2 => facets::<2>(&mut above[0]),
                3 => facets::<3>(&mut above[0]),
                4 => facets::<4>(&mut above[0]),
                5 => facets::<5>(&mut above[0]),
                6 => facets::<6>(&mut above[0]),
                _ => facets::<7>(&mut above[0]),
            };
        }
        let mut first = 0;
        for (k, level) in levels.iter_mut().enumerate() {
            level.first = first;
            first += level.vertices.len() / (k + 1);
        }
        for k in 1..=dimension {
            let first = narrow(levels[k - 1].first);
            levels[k].facets.iter_mut().for_each(|facet| *facet += first);
        }
        narrow(first);
        Self { levels }
    }

    /// The dimension of the cells; `None` without sites.
    #[must_use]
    pub fn dimension(&self) -> Option<usize> {
        self.levels.len().checked_sub(1)
    }

    /// How many simplices there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.levels.len().checked_sub(1).map_or(0, |top| self.of_dimension(top).end)
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.levels.is_empty()
    }

    /// The places of the simplices of a dimension.
    #[must_use]
    pub fn of_dimension(&self, k: usize) -> std::ops::Range<usize> {
        let Some(level) = self.levels.get(k) else { return self.len()..self.len() };
        level.first..level.first + level.vertices.len() / (k + 1)
    }

    /// The dimension of a simplex.
    #[must_use]
    pub fn dimension_of(&self, simplex: SimplexId) -> usize {
        self.levels.partition_point(|level| level.first <= simplex.index()) - 1
    }

    /// The vertices of a simplex, which are sites, in increasing order.
    #[must_use]
    pub fn vertices(&self, simplex: SimplexId) -> &[u32] {
        let k = self.dimension_of(simplex);
        let level = &self.levels[k];
        &level.vertices[(simplex.index() - level.first) * (k + 1)..][..=k]
    }

    /// The facets of a simplex, each opposite the vertex at its place; none of a vertex.
    #[must_use]
    pub fn facets(&self, simplex: SimplexId) -> &[u32] {
        let k = self.dimension_of(simplex);
        if k == 0 {
            return &[];
        }
        let level = &self.levels[k];
        &level.facets[(simplex.index() - level.first) * (k + 1)..][..=k]
    }

    /// The simplices of a dimension with their vertices and facets.
    pub(crate) fn level(&self, k: usize) -> impl Iterator<Item = (usize, &[u32], &[u32])> + Clone {
        let level = &self.levels[k];
        let facets: &[u32] = &level.facets;
        let vertices = level.vertices.chunks_exact(k + 1);
        (level.first..).zip(vertices).enumerate().map(move |(i, (id, vertices))| {
            (id, vertices, facets.get(i * (k + 1)..(i + 1) * (k + 1)).unwrap_or(&[]))
        })
    }

    /// The simplex of these vertices, in any order, if it is one.
    #[must_use]
    pub fn find(&self, vertices: &[u32]) -> Option<SimplexId> {
        let k = vertices.len().checked_sub(1)?;
        let mut sorted = vertices.to_vec();
        sorted.sort_unstable();
        let all: &[u32] = &self.levels.get(k)?.vertices;
        let range = self.of_dimension(k);
        let at = |i: usize| &all[i * (k + 1)..][..=k];
        let (mut low, mut high) = (0, range.len());
        while low < high {
            let middle = low.midpoint(high);
            if at(middle) < &sorted[..] {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        (low < range.len() && at(low) == sorted).then(|| SimplexId::new(range.start + low))
    }
}

/// The solid cells.
fn cells<const D: usize, const W: usize>(mesh: &Mesh<D>) -> Level {
    let all = mesh.solid_cells().map(|cell| {
        let corners = mesh.corners(cell);
        let mut key: [u32; W] = std::array::from_fn(|i| narrow(corners[i].index()));
        key.sort_unstable();
        key
    });
    Level { vertices: distinct(all, |_, _| {}), ..Level::default() }
}

/// The facets, of W vertices, of the simplices above; which are told theirs, counted from the first of these.
fn facets<const W: usize>(above: &mut Level) -> Level {
    let mut facets = vec![0; above.vertices.len()];
    let all = above.vertices.chunks_exact(W + 1).flat_map(|vertices| {
        (0..=W).map(|omitted| -> [u32; W] {
            std::array::from_fn(|i| vertices[i + usize::from(i >= omitted)])
        })
    });
    let vertices = distinct(all, |place, facet| facets[place] = facet);
    above.facets = facets;
    Level { vertices, ..Level::default() }
}

/// The different ones among keys of sorted vertices, in order; `told` hears of each key, by its place, which one it is.
fn distinct<const W: usize>(
    keys: impl Iterator<Item = [u32; W]> + Clone,
    mut told: impl FnMut(usize, u32),
) -> Vec<u32> {
    let buckets = keys.clone().map(|key| key[0] as usize + 1).max().unwrap_or(0);
    let mut ends = vec![0u32; buckets + 1];
    keys.clone().for_each(|key| ends[key[0] as usize + 1] += 1);
    for bucket in 0..buckets {
        ends[bucket + 1] += ends[bucket];
    }
    if W == 1 {
        return vertices_alone(&ends, keys.map(|key| key[0]), told);
    }
    let total = ends[buckets] as usize;
    let mut dealt = vec![([0; W], 0u32); total];
    let mut next = ends.clone();
    for (place, key) in keys.enumerate() {
        let slot = &mut next[key[0] as usize];
        dealt[*slot as usize] = (key, narrow(place));
        *slot += 1;
    }
    let (mut vertices, mut count) = (Vec::new(), 0u32);
    for bucket in 0..buckets {
        let dealt = &mut dealt[ends[bucket] as usize..ends[bucket + 1] as usize];
        sort(dealt);
        for same in dealt.chunk_by(|a, b| a.0 == b.0) {
            vertices.extend_from_slice(&same[0].0);
            same.iter().for_each(|&(_, place)| told(place as usize, count));
            count += 1;
        }
    }
    vertices.shrink_to_fit();
    vertices
}

/// Sorts keys with the same first vertex; the other vertices and the place are compared as one number where they fit.
fn sort<const W: usize>(dealt: &mut [([u32; W], u32)]) {
    let packed = |(key, place): &([u32; W], u32)| {
        key[1..].iter().chain([place]).fold(0, |number, &x| number << 32 | u128::from(x))
    };
    if W <= 4 {
        dealt.sort_unstable_by_key(packed);
    } else {
        dealt.sort_unstable();
    }
}

/// The same for keys of one vertex, which their buckets tell apart.
fn vertices_alone(
    ends: &[u32],
    keys: impl Iterator<Item = u32>,
    mut told: impl FnMut(usize, u32),
) -> Vec<u32> {
    let is_there = |vertex: &u32| ends[*vertex as usize] < ends[*vertex as usize + 1];
    let vertices: Vec<u32> = (0..narrow(ends.len() - 1)).filter(is_there).collect();
    let mut ids = vec![0; ends.len() - 1];
    (0u32..).zip(&vertices).for_each(|(id, &vertex)| ids[vertex as usize] = id);
    keys.enumerate().for_each(|(place, vertex)| told(place, ids[vertex as usize]));
    vertices
}

#[cfg(test)]
mod tests;
