use super::*;
use crate::naive;
use crate::testing::{Owned, Random};

const GHOST: u32 = u32::MAX;

/// A mesh closed by ghosts, glued by brute force.
#[derive(Clone)]
struct Glued {
    dimension: Option<usize>,
    vertices: Vec<u32>,
    twins: Vec<u32>,
}

impl Glued {
    fn new<const D: usize>(solid: &Owned<D>) -> Self {
        let k = solid.dimension.unwrap();
        let mut vertices = solid.cells.clone();
        for facet in 0..vertices.len() {
            let (cell, i) = (facet / (k + 1), facet % (k + 1));
            let here = facet_of(&solid.cells, k + 1, facet);
            let alone = (0..solid.cells.len())
                .all(|other| other == facet || facet_of(&solid.cells, k + 1, other) != here);
            if alone {
                let mut ghost = solid.cells[cell * (k + 1)..(cell + 1) * (k + 1)].to_vec();
                ghost[i] = GHOST;
                ghost.swap(0, k.min(1));
                vertices.extend(ghost);
            }
        }
        let twins = (0..vertices.len())
            .map(|facet| {
                let here = facet_of(&vertices, k + 1, facet);
                let twin = (0..vertices.len())
                    .find(|&t| t != facet && facet_of(&vertices, k + 1, t) == here);
                u32::try_from(twin.unwrap()).unwrap()
            })
            .collect();
        Self { dimension: Some(k), vertices, twins }
    }

    fn judged(&self) -> Verdict {
        let links = Links {
            dimension: self.dimension,
            vertices: &self.vertices,
            twins: &self.twins,
            ghost: GHOST,
        };
        judge_links(&links, &Options::default())
    }

    fn accepted(&self) {
        let verdict = self.judged();
        assert!(verdict.ok && verdict.level == Level::Linked, "{verdict}");
    }

    fn rejected(&self, kind: &str) -> Verdict {
        let verdict = self.judged();
        assert!(!verdict.ok && verdict.has(kind), "expected {kind} in\n{verdict}");
        verdict
    }
}

fn facet_of(vertices: &[u32], stride: usize, facet: usize) -> Vec<u32> {
    let mut set = vertices[facet / stride * stride..][..stride].to_vec();
    set.remove(facet % stride);
    set.sort_unstable();
    set
}

fn plane() -> Glued {
    Glued::new(&Owned::delaunay(&Random(41).grid::<2>(9, 50)))
}

fn space() -> Glued {
    Glued::new(&Owned::delaunay(&Random(42).grid::<3>(9, 50)))
}

#[test]
fn right_meshes_are_accepted_in_every_dimension() {
    plane().accepted();
    space().accepted();
    Glued::new(&Owned::new(&[[0.0], [1.0], [2.0]], 1, &[0, 1, 1, 2])).accepted();
    let point = Glued { dimension: Some(0), vertices: vec![0, GHOST], twins: vec![1, 0] };
    point.accepted();
    Glued { dimension: None, vertices: Vec::new(), twins: Vec::new() }.accepted();
    let mut random = Random(43);
    for _ in 0..10 {
        let points = random.grid::<4>(9, 9);
        let mut cells = naive::delaunay(&points);
        // Put them the same way up, by their common facets.
        orient(&mut cells);
        Glued::new(&Owned::<4>::new(&points, 4, &cells.concat())).accepted();
    }
}

/// Turns cells over until all pairs agree.
fn orient(cells: &mut [Vec<u32>]) {
    let mut done = vec![0];
    while done.len() < cells.len() {
        let flat = cells.concat();
        let facets = Facets::new(cells[0].len(), &flat, |_| Some(false));
        let step = facets.groups().find_map(|g| match g {
            [f, g] => {
                let (a, b) = (facets.cell_number(f), facets.cell_number(g));
                let fresh = match (done.contains(&a), done.contains(&b)) {
                    (true, false) => b,
                    (false, true) => a,
                    _ => return None,
                };
                Some((fresh, f.negative == g.negative))
            }
            _ => None,
        });
        let (fresh, turn) = step.unwrap();
        if turn {
            cells[fresh].swap(0, 1);
        }
        done.push(fresh);
    }
}

#[test]
fn wrong_twin() {
    for mut mesh in [plane(), space()] {
        // Two pairs exchange partners: still mutual.
        let stride = u32::try_from(mesh.dimension.unwrap() + 1).unwrap();
        let (a, b) = (0, (1..).find(|b| mesh.twins[0] != *b && b / stride > 0).unwrap());
        let (a2, b2) = (mesh.twins[a], mesh.twins[b as usize]);
        mesh.twins[a] = b;
        mesh.twins[b as usize] = 0;
        mesh.twins[a2 as usize] = b2;
        mesh.twins[b2 as usize] = a2;
        assert!(!mesh.rejected("twin-mismatch").has("twin-not-mutual"));
    }
}

#[test]
fn every_single_wrong_twin_is_found() {
    let right = plane();
    for facet in 0..right.twins.len() {
        for twin in 0..u32::try_from(right.twins.len()).unwrap() {
            if twin != right.twins[facet] {
                let mut mesh = right.clone();
                mesh.twins[facet] = twin;
                let verdict = mesh.rejected("twin-mismatch");
                let itself = twin as usize == facet;
                assert!(itself || verdict.has("twin-not-mutual"), "{verdict}");
            }
        }
    }
}

#[test]
fn twin_out_of_range() {
    let mut mesh = plane();
    for twin in [u32::MAX, u32::try_from(mesh.twins.len()).unwrap()] {
        mesh.twins[5] = twin;
        mesh.rejected("twin-out-of-range");
    }
}

#[test]
fn cell_turned_over() {
    for mut mesh in [plane(), space()] {
        let stride = mesh.dimension.unwrap() + 1;
        mesh.vertices.swap(0, 1);
        mesh.twins.swap(0, 1);
        for facet in 0..mesh.twins.len() {
            let twin = mesh.twins[facet] as usize;
            mesh.twins[twin] = u32::try_from(facet).unwrap();
        }
        let verdict = mesh.rejected("twin-orientation");
        assert_eq!(verdict.counts["twin-orientation"], 2 * stride);
        assert_eq!(verdict.counts.len(), 1);
    }
}

#[test]
fn ghosts_astray() {
    let mut mesh = plane();
    let last = mesh.vertices.len() - 3;
    let corner = (last..last + 3).find(|&i| mesh.vertices[i] != GHOST).unwrap();
    mesh.vertices[corner] = GHOST;
    mesh.rejected("two-ghosts");

    // A solid vertex renamed to the ghost: the outside is then glued into the inside.
    let mut mesh = plane();
    let inner = mesh.vertices[0];
    for v in &mut mesh.vertices {
        if *v == inner {
            *v = GHOST;
        }
    }
    assert!(!mesh.judged().ok);
}

#[test]
fn a_ghost_must_face_a_solid_cell() {
    // Two ghosts back to back make a sphere too, with nothing solid in it.
    let mesh = Glued {
        dimension: Some(2),
        vertices: vec![0, 1, GHOST, 1, 0, GHOST],
        twins: vec![4, 3, 5, 1, 0, 2],
    };
    let verdict = mesh.rejected("ghost-beside-ghost");
    assert_eq!(verdict.counts.len(), 1, "{verdict}");
}

#[test]
fn a_missing_cell_leaves_it_open() {
    let mut mesh = plane();
    mesh.vertices.truncate(mesh.vertices.len() - 3);
    mesh.twins.truncate(mesh.vertices.len());
    mesh.rejected("not-closed");
    mesh.rejected("twin-out-of-range");
}

#[test]
fn bad_lengths() {
    let mut mesh = plane();
    mesh.twins.pop();
    mesh.rejected("bad-length");
    mesh.vertices.pop();
    mesh.rejected("bad-length");
    let empty = Glued { dimension: Some(2), vertices: Vec::new(), twins: Vec::new() };
    empty.rejected("bad-length");
    let full = Glued { dimension: None, vertices: vec![GHOST], twins: vec![0] };
    full.rejected("bad-length");
}

#[test]
fn two_spheres_are_not_one() {
    let one = plane();
    let mut two = one.clone();
    let shift = u32::try_from(one.twins.len()).unwrap();
    // The ghost must differ, or facets at it would still be distinct: all vertices do.
    two.vertices.extend(one.vertices.iter().map(|&v| if v == GHOST { 1000 } else { v + 100 }));
    two.twins.extend(one.twins.iter().map(|t| t + shift));
    assert!(two.rejected("disconnected").has("euler"));
}

#[test]
fn garbage_is_rejected_without_panic() {
    let mut random = Random(44);
    for _ in 0..500 {
        let k = random.below(4) as usize;
        let n = random.below(12) as usize * (k + 1);
        let mesh = Glued {
            dimension: Some(k),
            vertices: (0..n).map(|_| [0, 1, 2, 3, 4, GHOST][random.below(6) as usize]).collect(),
            twins: (0..n).map(|_| random.below(40)).collect(),
        };
        mesh.judged();
    }
}

#[test]
fn many() {
    let solid = crate::testing::square_grid(100);
    let mut vertices = solid.cells.clone();
    let facets = Facets::new(3, &solid.cells, |_| Some(false));
    for lone in facets.groups().filter(|g| g.len() == 1) {
        let mut ghost = facets.cell(&lone[0]).to_vec();
        ghost[lone[0].number % 3] = GHOST;
        ghost.swap(0, 1);
        vertices.extend(ghost);
    }
    let mut twins = vec![0; vertices.len()];
    let facets = Facets::new(3, &vertices, |_| Some(false));
    for pair in facets.groups() {
        twins[pair[0].number] = u32::try_from(pair[1].number).unwrap();
        twins[pair[1].number] = u32::try_from(pair[0].number).unwrap();
    }
    Glued { dimension: Some(2), vertices, twins }.accepted();
}
