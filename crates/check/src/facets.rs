//! The facets of a list of simplices, brought together by their vertices.
//!
//! **In.** `stride` ids per simplex. **Out.** All facets, sorted by vertex set, each with the sign
//! it has in the oriented boundary of its simplex, compared with its vertices in ascending order:
//! facet `i` of `(v0..vk)` counts as `(-1)^i` times the parity of the permutation that sorts the
//! rest. **Cost.** One sort of 32-byte records.

/// One facet of one simplex.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Facet {
    /// The four smallest vertices, packed.
    key: u128,
    /// Its number, `cell * stride + opposite corner`.
    pub(crate) number: usize,
    /// Whether it is minus its sorted vertices.
    pub(crate) negative: bool,
}

/// All facets of the simplices of one list, in order of vertex set, then number.
#[derive(Debug)]
pub(crate) struct Facets<'a> {
    stride: usize,
    cells: &'a [u32],
    sorted: Vec<Facet>,
}

impl<'a> Facets<'a> {
    /// The facets of those cells for which `sign` says whether they count negatively; `None` skips
    /// a cell.
    pub(crate) fn new(
        stride: usize,
        cells: &'a [u32],
        sign: impl Fn(usize) -> Option<bool>,
    ) -> Self {
        let mut sorted = Vec::with_capacity(cells.len());
        let mut rest = Vec::with_capacity(stride);
        for (cell, corners) in cells.chunks_exact(stride).enumerate() {
            let Some(turned) = sign(cell) else { continue };
            for i in 0..stride {
                let odd = sort_without(corners, i, &mut rest);
                let key = rest.iter().take(4).fold(0, |key, &v| key << 32 | u128::from(v));
                let negative = turned ^ (i % 2 == 1) ^ odd;
                sorted.push(Facet { key, number: cell * stride + i, negative });
            }
        }
        let mut facets = Self { stride, cells, sorted: Vec::new() };
        if stride <= 5 {
            sorted.sort_unstable_by_key(|f| (f.key, f.number));
        } else {
            sorted.sort_by_cached_key(|f| (facets.vertices(f), f.number));
        }
        facets.sorted = sorted;
        facets
    }

    /// The facets with equal vertex sets, together.
    pub(crate) fn groups(&self) -> impl Iterator<Item = &[Facet]> {
        self.sorted.chunk_by(|a, b| {
            a.key == b.key && (self.stride <= 5 || self.vertices(a) == self.vertices(b))
        })
    }

    /// The vertices of a facet, ascending.
    pub(crate) fn vertices(&self, facet: &Facet) -> Vec<u32> {
        let mut vertices = Vec::with_capacity(self.stride);
        sort_without(self.cell(facet), facet.number % self.stride, &mut vertices);
        vertices
    }

    /// The vertex opposite the facet.
    pub(crate) fn apex(&self, facet: &Facet) -> u32 {
        self.cells[facet.number]
    }

    /// The vertices of the simplex of a facet.
    pub(crate) fn cell(&self, facet: &Facet) -> &'a [u32] {
        let start = self.cell_number(facet) * self.stride;
        &self.cells[start..start + self.stride]
    }

    /// The number of the simplex of a facet.
    pub(crate) fn cell_number(&self, facet: &Facet) -> usize {
        facet.number / self.stride
    }
}

/// Sorts the corners but one into `rest`; whether the permutation was odd.
fn sort_without(corners: &[u32], skipped: usize, rest: &mut Vec<u32>) -> bool {
    rest.clear();
    let mut odd = false;
    for (i, &v) in corners.iter().enumerate() {
        if i == skipped {
            continue;
        }
        let place = rest.iter().rposition(|&w| w <= v).map_or(0, |p| p + 1);
        odd ^= (rest.len() - place) % 2 == 1;
        rest.insert(place, v);
    }
    odd
}

/// Disjoint sets, to count connected pieces.
#[derive(Debug)]
pub(crate) struct Pieces {
    parent: Vec<usize>,
}

impl Pieces {
    pub(crate) fn new(n: usize) -> Self {
        Self { parent: (0..n).collect() }
    }

    pub(crate) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b)] = a.min(b);
    }

    /// How many pieces the members that are `counted` make up.
    pub(crate) fn count(&mut self, counted: impl Fn(usize) -> bool) -> usize {
        let mut roots: Vec<usize> =
            (0..self.parent.len()).filter(|&i| counted(i)).map(|i| self.root(i)).collect();
        roots.sort_unstable();
        roots.dedup();
        roots.len()
    }

    pub(crate) fn root(&mut self, mut i: usize) -> usize {
        while self.parent[i] != i {
            self.parent[i] = self.parent[self.parent[i]];
            i = self.parent[i];
        }
        i
    }
}
