//! The simplices of a mesh from the vertices up: each is found as one of a shorter simplex's children.
//!
//! ```text
//!   [u]  --->  [u v]  --->  [u v x]        A simplex's parent lacks its last vertex. Children stand together, in order of
//!     \            \                       their last vertices: levels are in lexicographic order. The facet of [u v x] that
//!      -->  [u x]   -->  [u v y]           lacks v is a child of [u], which is the facet of its parent [u v] that lacks v.
//! ```
//!
//! **Out.** Each simplex once. **Invariants.** 1. A face of a cell is offered if the cell is the first, by index, among those that
//! are its neighbours across facets around the face: the first of all cells at the face is such, so every face is offered,
//! and only few more than once. 2. Parents are there before their children: levels are made in order of dimension.

use delone_mesh::{CellId, Mesh};

use super::Level;
use crate::bulk::narrow;

/// Children of the simplices of one dimension, by parent.
struct Children {
    /// Where those of each parent end, after a zero.
    ends: Vec<u32>,
    /// Their last vertices.
    lasts: Vec<u32>,
}

impl Children {
    /// From parents and last vertices, in any order, and perhaps more than once.
    fn new(parents: usize, offered: &[[u32; 2]]) -> Self {
        let mut ends = vec![0u32; parents + 1];
        offered.iter().for_each(|&[parent, _]| ends[parent as usize + 1] += 1);
        for parent in 0..parents {
            ends[parent + 1] += ends[parent];
        }
        let mut lasts = vec![0; offered.len()];
        // From the back, so that each list's start is what is left in the end.
        for &[parent, last] in offered {
            let end = &mut ends[parent as usize + 1];
            *end -= 1;
            lasts[*end as usize] = last;
        }
        let mut children = Self { ends, lasts };
        children.tidy();
        children
    }

    /// Sorts each list, whose *start* stands at its parent's end, and leaves out what is there twice.
    fn tidy(&mut self) {
        let (mut count, parents) = (0, self.ends.len() - 1);
        for parent in 0..parents {
            let start = self.ends[parent + 1] as usize;
            let end = self.ends.get(parent + 2).map_or(self.lasts.len(), |&end| end as usize);
            insertion_sort(&mut self.lasts[start..end]);
            let first = count;
            for i in start..end {
                if count == first || self.lasts[count - 1] != self.lasts[i] {
                    self.lasts[count] = self.lasts[i];
                    count += 1;
                }
            }
            self.ends[parent + 1] = narrow(count);
        }
        self.lasts.truncate(count);
    }

    /// The child of a parent with this last vertex.
    #[inline]
    fn find(&self, parent: u32, last: u32) -> u32 {
        let (start, end) = (self.ends[parent as usize], self.ends[parent as usize + 1]);
        let all = &self.lasts[start as usize..end as usize];
        let place = if all.len() > 32 {
            all.partition_point(|&other| other < last)
        } else {
            all.iter().map(|&other| usize::from(other < last)).sum()
        };
        debug_assert_eq!(all.get(place), Some(&last), "Inv 2");
        start + narrow(place)
    }
}

/// Lists are short, but for those of vertices with very many neighbours.
fn insertion_sort(list: &mut [u32]) {
    if list.len() > 24 {
        return list.sort_unstable();
    }
    for i in 1..list.len() {
        let (mut place, item) = (i, list[i]);
        while place > 0 && list[place - 1] > item {
            list[place] = list[place - 1];
            place -= 1;
        }
        list[place] = item;
    }
}

/// The levels, of cells with W corners.
pub(super) fn levels<const D: usize, const W: usize>(mesh: &Mesh<D>) -> Vec<Level> {
    let sites = Present::in_mesh(mesh);
    let cells = by_first_vertex(&cells::<D, W>(mesh, &sites), sites.vertices.len());
    let mut children: Vec<Children> = Vec::with_capacity(W);
    let mut levels = vec![Level { first: 0, vertices: sites.vertices.clone(), facets: Vec::new() }];
    for k in 1..W {
        let parents = levels[k - 1].vertices.len() / k;
        children.push(Children::new(parents, &offered(&cells, k, &children)));
        levels.push(level(&levels[k - 1], k, &children, &sites.vertices));
    }
    levels
}

/// The sites that are vertices, in order, and by site its place among them.
struct Present {
    vertices: Vec<u32>,
    places: Vec<u32>,
}

impl Present {
    fn in_mesh<const D: usize>(mesh: &Mesh<D>) -> Self {
        let corners = || mesh.solid_cells().flat_map(|cell| mesh.corners(cell));
        let count = corners().map(|v| v.index() + 1).max().unwrap_or(0);
        let mut places = vec![u32::MAX; count];
        corners().for_each(|v| places[v.index()] = 0);
        let is_there = |&v: &u32| places[v as usize] == 0;
        let vertices: Vec<u32> = (0..narrow(count)).filter(is_there).collect();
        (0u32..).zip(&vertices).for_each(|(place, &v)| places[v as usize] = place);
        Self { vertices, places }
    }
}

/// A solid cell.
#[derive(Clone, Copy)]
struct Cell<const W: usize> {
    /// Its vertices in order, by place.
    vertices: [u32; W],
    /// The set of those opposite which a solid cell of lower index lies.
    before: u32,
}

fn cells<const D: usize, const W: usize>(mesh: &Mesh<D>, sites: &Present) -> Vec<Cell<W>> {
    let is_ghost: Vec<bool> = mesh.cells().map(|cell| mesh.is_ghost(cell)).collect();
    let of_cell = |cell: CellId| {
        let mut corners = [(0, false); W];
        for (corner, facet) in corners.iter_mut().zip(mesh.facets(cell)) {
            let beyond = mesh.twin(facet).cell();
            let is_before = beyond < cell && !is_ghost[beyond.index()];
            *corner = (sites.places[mesh.apex(facet).index()], is_before);
        }
        corners.sort_unstable();
        let before = (0..).zip(&corners).map(|(i, corner)| u32::from(corner.1) << i).sum();
        Cell { vertices: corners.map(|corner| corner.0), before }
    };
    mesh.cells().filter(|cell| !is_ghost[cell.index()]).map(of_cell).collect()
}

/// Cells in order of their first vertices: those of one find the same few parents.
fn by_first_vertex<const W: usize>(cells: &[Cell<W>], vertices: usize) -> Vec<Cell<W>> {
    let mut next = vec![0u32; vertices + 1];
    cells.iter().for_each(|cell| next[cell.vertices[0] as usize + 1] += 1);
    for vertex in 0..vertices {
        next[vertex + 1] += next[vertex];
    }
    let mut dealt = vec![Cell { vertices: [0; W], before: 0 }; cells.len()];
    for &cell in cells {
        let slot = &mut next[cell.vertices[0] as usize];
        dealt[*slot as usize] = cell;
        *slot += 1;
    }
    dealt
}

/// Parents and last vertices of faces of dimension k; each face at least once.
fn offered<const W: usize>(cells: &[Cell<W>], k: usize, children: &[Children]) -> Vec<[u32; 2]> {
    let faces: Vec<u32> =
        (0..1 << W).filter(|set: &u32| set.count_ones() as usize == k + 1).collect();
    let mut offered = Vec::with_capacity(cells.len());
    for Cell { vertices, before } in cells {
        for &set in faces.iter().filter(|&&set| before & !set == 0) {
            let mut rest = set;
            let mut next = || {
                let vertex = vertices[rest.trailing_zeros() as usize];
                rest &= rest - 1;
                vertex
            };
            let first = next();
            let parent = children[..k - 1].iter().fold(first, |parent, of| of.find(parent, next()));
            offered.push([parent, next()]);
        }
    }
    offered
}

/// The simplices of dimension k, their facets counted from the first of those below.
fn level(below: &Level, k: usize, children: &[Children], sites: &[u32]) -> Level {
    let Children { ends, lasts } = &children[k - 1];
    let mut level = Level {
        first: 0,
        vertices: Vec::with_capacity(lasts.len() * (k + 1)),
        facets: Vec::with_capacity(lasts.len() * (k + 1)),
    };
    let parents = below.vertices.chunks_exact(k).zip(ends.windows(2)).enumerate();
    for (parent, (vertices, range)) in parents {
        for &last in &lasts[range[0] as usize..range[1] as usize] {
            level.vertices.extend_from_slice(vertices);
            level.vertices.push(sites[last as usize]);
            if k == 1 {
                level.facets.push(last);
            } else {
                let of_parent = &below.facets[parent * k..(parent + 1) * k];
                let facets = of_parent.iter().map(|&facet| children[k - 2].find(facet, last));
                level.facets.extend(facets);
            }
            level.facets.push(narrow(parent));
        }
    }
    level
}
