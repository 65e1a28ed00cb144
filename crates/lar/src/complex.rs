//! The model: vertices, and the cells of each dimension as lists of vertices.

use std::fmt;

use delone_mesh::{CellId, Mesh};

/// A simplicial complex: `(V, [VV, EV, FV, CV, ..])`. See the crate's text.
#[derive(Clone, Debug, PartialEq)]
pub struct Complex<const D: usize> {
    vertices: Vec<[f64; D]>,
    /// By dimension: the cells, each with its vertices in increasing order, in increasing order.
    cells: Vec<Vec<Vec<u32>>>,
    /// By dimension: whether each cell was given in an odd order of its vertices.
    odd: Vec<Vec<bool>>,
}

/// What is wrong with a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ComplexFault {
    /// It has no vertices.
    Empty {
        /// The cell, by place in the list given.
        cell: usize,
    },
    /// It names a vertex that is not there.
    NoSuchVertex {
        /// The cell, by place in the list given.
        cell: usize,
        /// What it names.
        vertex: u32,
        /// How many vertices there are.
        count: usize,
    },
    /// It names a vertex twice.
    Repeated {
        /// The cell, by place in the list given.
        cell: usize,
        /// The vertex.
        vertex: u32,
    },
}

impl fmt::Display for ComplexFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty { cell } => write!(f, "cell {cell} has no vertices: leave it out"),
            Self::NoSuchVertex { cell, vertex, count } => write!(
                f,
                "cell {cell} names vertex {vertex}, but there are {count}: indices go from 0"
            ),
            Self::Repeated { cell, vertex } => {
                write!(
                    f,
                    "cell {cell} names vertex {vertex} twice: a simplex has distinct vertices"
                )
            }
        }
    }
}

impl std::error::Error for ComplexFault {}

impl<const D: usize> Complex<D> {
    /// The complex of given cells, all their faces, and all vertices. A cell given twice is taken once, in the order in
    /// which it came first. O(n log n), for n faces.
    ///
    /// # Errors
    /// With every cell that is empty, names a vertex twice, or one that is not there.
    pub fn closure(vertices: Vec<[f64; D]>, cells: &[&[u32]]) -> Result<Self, Vec<ComplexFault>> {
        let faults: Vec<ComplexFault> = cells
            .iter()
            .enumerate()
            .flat_map(|(i, cell)| faults(i, cell, vertices.len()))
            .collect();
        if !faults.is_empty() {
            return Err(faults);
        }
        Ok(Self::of(vertices, cells.iter().map(|cell| cell.to_vec()).collect()))
    }

    /// The complex of the solid cells of a mesh that are kept, their faces, and all vertices. O(n log n).
    ///
    /// # Panics
    /// If a cell names a vertex that is not there.
    #[must_use]
    pub fn of_mesh(
        vertices: &[[f64; D]],
        mesh: &Mesh<D>,
        is_kept: impl Fn(CellId) -> bool,
    ) -> Self {
        let kept = mesh.solid_cells().filter(|&cell| is_kept(cell));
        let cells = kept.map(|cell| {
            let id = |index: usize| {
                assert!(index < vertices.len(), "a mesh and its vertices belong together");
                u32::try_from(index).expect("a vertex index fits 32 bits")
            };
            mesh.corners(cell).iter().map(|v| id(v.index())).collect()
        });
        Self::of(vertices.to_vec(), cells.collect())
    }

    /// Cells that are known to be simplices over the vertices.
    fn of(vertices: Vec<[f64; D]>, given: Vec<Vec<u32>>) -> Self {
        let top = given.iter().map(|cell| cell.len() - 1).max().unwrap_or(0);
        // By dimension, with where each was given: what was given goes before faces.
        let mut found: Vec<Vec<(Vec<u32>, usize, bool)>> = vec![Vec::new(); top + 1];
        for (place, mut cell) in given.into_iter().enumerate() {
            let odd = sort_parity(&mut cell);
            found[cell.len() - 1].push((cell, place, odd));
        }
        found[0].extend((0u32..).zip(&vertices).map(|(v, _)| (vec![v], usize::MAX, false)));
        let mut complex = Self { vertices, cells: Vec::new(), odd: Vec::new() };
        for k in (0..=top).rev() {
            let mut level = std::mem::take(&mut found[k]);
            level.sort_unstable();
            level.dedup_by(|later, first| later.0 == first.0);
            if k > 0 {
                for (cell, _, _) in &level {
                    let faces = (0..=k).map(|i| (without(cell, i), usize::MAX, false));
                    found[k - 1].extend(faces);
                }
            }
            complex.odd.push(level.iter().map(|&(_, _, odd)| odd).collect());
            complex.cells.push(level.into_iter().map(|(cell, _, _)| cell).collect());
        }
        complex.odd.reverse();
        complex.cells.reverse();
        if complex.vertices.is_empty() {
            (complex.cells, complex.odd) = Default::default();
        }
        complex
    }

    /// The positions of the vertices.
    #[must_use]
    pub fn vertices(&self) -> &[[f64; D]] {
        &self.vertices
    }

    /// The largest dimension of a cell; `None` without vertices.
    #[must_use]
    pub fn dimension(&self) -> Option<usize> {
        self.cells.len().checked_sub(1)
    }

    /// The cells of dimension `k`, each with its vertices in increasing order, in increasing order; none beyond the
    /// dimension.
    #[must_use]
    pub fn cells(&self, k: usize) -> &[Vec<u32>] {
        self.cells.get(k).map_or(&[], Vec::as_slice)
    }

    /// For each cell of dimension `k`: +1 if it was given in an even order of its vertices (as faces that were not given
    /// are), -1 if in an odd one. Over counter-clockwise triangles, the chain of the whole area.
    #[must_use]
    pub fn orientations(&self, k: usize) -> Vec<i64> {
        self.odd
            .get(k)
            .map_or(&[][..], Vec::as_slice)
            .iter()
            .map(|&odd| if odd { -1 } else { 1 })
            .collect()
    }

    /// The number of a cell among those of its dimension; its vertices in any order. O(log n).
    #[must_use]
    pub fn find(&self, cell: &[u32]) -> Option<usize> {
        let mut sorted = cell.to_vec();
        sorted.sort_unstable();
        self.cells(cell.len().checked_sub(1)?).binary_search(&sorted).ok()
    }

    /// The number of cells of each dimension.
    #[must_use]
    pub fn counts(&self) -> Vec<usize> {
        self.cells.iter().map(Vec::len).collect()
    }

    /// The Euler characteristic: the alternating sum of the counts.
    #[must_use]
    pub fn euler(&self) -> i64 {
        let signed = |(k, &count): (usize, &usize)| {
            let count = i64::try_from(count).unwrap_or(i64::MAX);
            if k % 2 == 0 { count } else { -count }
        };
        self.counts().iter().enumerate().map(signed).sum()
    }
}

fn faults(cell: usize, vertices: &[u32], count: usize) -> Vec<ComplexFault> {
    if vertices.is_empty() {
        return vec![ComplexFault::Empty { cell }];
    }
    let mut faults = Vec::new();
    for (i, &vertex) in vertices.iter().enumerate() {
        if usize::try_from(vertex).map_or(true, |v| v >= count) {
            faults.push(ComplexFault::NoSuchVertex { cell, vertex, count });
        }
        if vertices[..i].contains(&vertex) {
            faults.push(ComplexFault::Repeated { cell, vertex });
        }
    }
    faults
}

/// The cell without its vertex `i`.
pub(crate) fn without(cell: &[u32], i: usize) -> Vec<u32> {
    [&cell[..i], &cell[i + 1..]].concat()
}

/// Sorts distinct vertices; whether their order was odd.
fn sort_parity(cell: &mut [u32]) -> bool {
    let inversions: usize =
        (0..cell.len()).map(|i| cell[i + 1..].iter().filter(|&&v| v < cell[i]).count()).sum();
    cell.sort_unstable();
    inversions % 2 == 1
}
