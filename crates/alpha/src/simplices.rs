//! All simplices of a triangulation: the faces of its solid cells, each once, with their facets; in flat arrays.
//!
//! **In.** A mesh. **Out.** For each dimension the simplices in lexicographic order of their sorted vertices, and the facets of
//! each.
//! **Invariants.** 1. Ids go up with the dimension, within one in lexicographic order. 2. The facet at place `i` lacks the vertex at
//! place `i`.
//! **Cost.** From the vertices up (`simplices/build.rs`): O(N m) for N simplices, m vertices beside one in the mean over simplices.
//! 8 (k + 1) bytes a k-simplex.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | no site | no simplices, no dimension | `few_sites_have_few_simplices` |
//! | a mesh of lower dimension | the faces of its own cells | `few_sites_have_few_simplices` |
//! | hidden sites | they are no vertices | `hidden_sites_are_no_vertices` |

use delone_mesh::Mesh;

use crate::bulk::narrow;

mod build;

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
        let mut levels = match mesh.corner_count() {
            0 => Vec::new(),
            1 => build::levels::<D, 1>(mesh),
            2 => build::levels::<D, 2>(mesh),
            3 => build::levels::<D, 3>(mesh),
            4 => build::levels::<D, 4>(mesh),
            5 => build::levels::<D, 5>(mesh),
            6 => build::levels::<D, 6>(mesh),
            7 => build::levels::<D, 7>(mesh),
            8 => build::levels::<D, 8>(mesh),
            corners => panic!("a cell has {corners} corners: predicates go to 8"),
        };
        let mut first = 0;
        for (k, level) in levels.iter_mut().enumerate() {
            level.first = first;
            first += level.vertices.len() / (k + 1);
        }
        for k in 1..levels.len() {
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

#[cfg(test)]
mod tests;
