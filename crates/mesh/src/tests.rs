use super::*;

fn v(index: usize) -> VertexId {
    VertexId::new(index)
}

fn simplex<const D: usize>(k: usize) -> Mesh<D> {
    Mesh::simplex(&(0..=k).map(v).collect::<Vec<_>>())
}

#[test]
fn handles_take_four_bytes_and_print_short() {
    assert_eq!(size_of::<VertexId>(), 4);
    assert_eq!(size_of::<CellId>(), 4);
    assert_eq!(size_of::<FacetId<3>>(), 4);
    assert_eq!(format!("{:?} {:?}", v(17), CellId::new(4)), "v17 c4");
    assert_eq!(format!("{:?}", FacetId::<3>::new(CellId::new(4), 2)), "c4/2");
    assert!(v(1) < v(2) && v(2) < VertexId::GHOST);
}

#[test]
fn simplices_of_every_dimension_are_spheres() {
    fn check<const D: usize>() {
        for k in 0..=D {
            let mesh = simplex::<D>(k);
            assert_eq!(mesh.faults(Level::Sphere, k + 1), [], "k = {k}, D = {D}");
            assert_eq!(mesh.cell_count(), k + 2);
        }
    }
    check::<1>();
    check::<2>();
    check::<3>();
    check::<5>();
    assert_eq!(Mesh::<2>::empty().faults(Level::Sphere, 0), []);
}

/// A triangle becomes three about a vertex, the first in its slot.
#[test]
fn triangles_are_claimed_and_set() {
    let mut mesh = simplex::<2>(2);
    let old = CellId::new(0);
    let (corners, outer) = (mesh.triangle(old), mesh.triangle_twins(old));
    assert_eq!(corners, [v(0), v(1), v(2)]);
    mesh.retire(old);
    let cells = [0; 3].map(|_| mesh.claim_triangle());
    assert_eq!(cells, [0, 4, 5].map(CellId::new), "one is free, and there are three ghosts");
    for i in 0..3 {
        let (next, last) = ((i + 1) % 3, (i + 2) % 3);
        let twins = [outer[i], HalfEdge::new(cells[next], 2), HalfEdge::new(cells[last], 1)];
        mesh.set_triangle(cells[i], [v(3), corners[next], corners[last]], twins);
        mesh.glue(HalfEdge::new(cells[i], 0), outer[i]);
    }
    assert_eq!(mesh.faults(Level::Sphere, 4), []);
}

/// Splits a cell at the vertex.
fn split(mesh: &mut Mesh<3>, cavity: &mut Cavity<3>, cell: CellId, vertex: usize) {
    cavity.dig(mesh, cell, |_| false);
    mesh.star(cavity, v(vertex));
    mesh.compact(|_, _| {});
}

#[test]
fn starring_one_cell_splits_it() {
    let mut mesh = simplex::<3>(3);
    split(&mut mesh, &mut Cavity::new(), CellId::new(0), 4);
    assert_eq!(mesh.faults(Level::Sphere, 5), []);
    assert_eq!(mesh.solid_cells().count(), 4);
}

/// Splits a tetrahedron at vertex 4, then `splits` cells about that; then the whole star of vertex 4 becomes the cone from
/// another one. There are names for the rim's vertices if there are few, else its ridges are turned about.
fn star_again(splits: usize) {
    let (mut mesh, mut cavity) = (simplex::<3>(3), Cavity::new());
    split(&mut mesh, &mut cavity, CellId::new(0), 4);
    let about = |mesh: &Mesh<3>, cell| mesh.corners(cell).contains(&v(4));
    let star =
        |mesh: &Mesh<3>| -> Vec<CellId> { mesh.cells().filter(|&c| about(mesh, c)).collect() };
    for i in 0..splits {
        let cells = star(&mesh);
        split(&mut mesh, &mut cavity, cells[i * i % cells.len()], 5 + i);
    }
    let cells = star(&mesh);
    cavity.dig(&mesh, cells[0], |cell| about(&mesh, cell));
    assert_eq!((cavity.cells().len(), cavity.rim().len()), (4 + 2 * splits, 4 + 2 * splits));
    let last = 5 + splits;
    mesh.star(&mut cavity, v(last));
    mesh.compact(|_, _| {});
    // Vertex 4 is gone: another takes its name, so that none is missing.
    mesh.relabel(|vertex| if vertex == v(last) { v(4) } else { vertex });
    assert_eq!(mesh.faults(Level::Sphere, last), []);
    assert_eq!(star(&mesh).len(), 4 + 2 * splits);
}

#[test]
fn starring_a_region_stays_a_sphere_with_names_and_without() {
    for splits in [0, 1, 20, 58, 59, 60, 100, 300] {
        star_again(splits);
    }
}

#[test]
fn half_edges_run_counter_clockwise() {
    let mesh = simplex::<2>(2);
    let h = HalfEdge::new(CellId::new(0), 2);
    assert_eq!((mesh.origin(h), mesh.destination(h), mesh.apex(h)), (v(0), v(1), v(2)));
    assert_eq!(mesh.origin(mesh.next(h)), v(1));
    assert_eq!(mesh.next(mesh.prev(h)), h);
    let twin = mesh.twin(h);
    assert_eq!((mesh.origin(twin), mesh.destination(twin)), (v(1), v(0)));
    let ring: Vec<VertexId> =
        mesh.ring(v(0), CellId::new(0)).map(|h| mesh.destination(h)).collect();
    assert_eq!(ring, [v(1), v(2), VertexId::GHOST]);
    assert!(mesh.half_edge(v(2), v(1), CellId::new(0)).is_some());
}

#[test]
fn each_kind_of_damage_is_found() {
    let whole = simplex::<2>(2);
    let mut mesh = whole.clone();
    mesh.vertices.swap(0, 1);
    assert!(matches!(mesh.faults(Level::Twins, 3)[0], MeshFault::TwinVertices(..)));

    let mut mesh = whole.clone();
    mesh.twins[0] = FacetId::from_index(0);
    assert!(matches!(mesh.faults(Level::Twins, 3)[0], MeshFault::Twin(..)));

    let mut mesh = whole.clone();
    mesh.twins.swap(0, 1);
    assert!(!mesh.faults(Level::Twins, 3).is_empty());

    let mut mesh = whole.clone();
    mesh.vertices[1] = mesh.vertices[0];
    assert!(matches!(mesh.faults(Level::Handles, 3)[0], MeshFault::RepeatedCorner(..)));
    assert!(matches!(whole.faults(Level::Handles, 2)[0], MeshFault::VertexRange(..)));

    let mut mesh = whole.clone();
    mesh.retire(CellId::new(3));
    assert_eq!(mesh.faults(Level::Handles, 3), [MeshFault::Retired(CellId::new(3))]);

    let mut mesh = whole.clone();
    mesh.twins.pop();
    assert_eq!(mesh.faults(Level::Handles, 3), [MeshFault::Lengths]);
}

#[test]
fn two_spheres_are_not_one() {
    let mut mesh = simplex::<2>(2);
    let other = simplex::<2>(2);
    let offset = mesh.cell_count();
    for cell in other.cells() {
        let corners: Vec<VertexId> = other
            .corners(cell)
            .iter()
            .map(|&u| if u.is_ghost() { v(6) } else { v(u.index() + 3) })
            .collect();
        mesh.add_cell(&corners);
    }
    for facet in other.cells().flat_map(|cell| other.facets(cell)) {
        let shift = |f: FacetId<2>| FacetId::<2>::from_index(f.index() + 3 * offset);
        mesh.glue(shift(facet), shift(other.twin(facet)));
    }
    let faults = mesh.faults(Level::Sphere, 7);
    assert!(faults.contains(&MeshFault::Disconnected) && faults.contains(&MeshFault::Euler(4, 2)));
    // Pinched at one vertex: connected only through it.
    mesh.relabel(|u| if u == v(6) { v(0) } else { u });
    assert!(mesh.faults(Level::Sphere, 7).contains(&MeshFault::SplitStar(v(0))));
}

#[test]
fn embedding_keeps_dimension_and_cells() {
    let line = simplex::<1>(1);
    let embedded = Mesh::<3>::embed(&line);
    assert_eq!(embedded.dimension(), Some(1));
    assert_eq!(embedded.faults(Level::Sphere, 2), []);
    assert_eq!(embedded.canonical(|v| u32::try_from(v.index()).unwrap()), [0, 1]);
}

#[test]
fn a_chain_is_a_circle_through_the_ghost() {
    for n in 2..6 {
        let line: Vec<VertexId> = (0..n).map(v).collect();
        let mesh = Mesh::<2>::chain(&line);
        assert_eq!(mesh.faults(Level::Sphere, n), []);
        assert_eq!((mesh.dimension(), mesh.ghost_cells().count()), (Some(1), 2));
    }
    assert_eq!(Mesh::<2>::chain(&[v(0), v(1)]).canonical(|_| 0), [0, 0]);
}

#[test]
fn parts_make_the_mesh_they_came_from() {
    let mesh = simplex::<2>(2);
    let copy = Mesh::from_parts(2, mesh.vertices.clone(), mesh.twins.clone());
    assert_eq!(copy, mesh);
}

#[test]
fn a_flip_exchanges_the_diagonal_and_three_more_bring_it_back() {
    let mut mesh = Mesh::<2>::from_cells(2, &[0, 1, 2, 0, 2, 3].map(v)).unwrap();
    let names = |mesh: &Mesh<2>| mesh.canonical(|v| u32::try_from(v.index()).unwrap());
    let h = mesh.half_edge(v(0), v(2), CellId::new(0)).unwrap();
    let (c, d) = (mesh.apex(h), mesh.apex(mesh.twin(h)));
    mesh.flip(h);
    assert_eq!(mesh.faults(Level::Sphere, 4), []);
    assert_eq!(names(&mesh), [0, 1, 3, 1, 2, 3]);
    assert_eq!((mesh.apex(h), mesh.apex(mesh.next(mesh.twin(mesh.next(h))))), (c, c));
    assert!(mesh.corners(h.cell()).contains(&d), "the diagonal joins the apexes");
    let diagonal = mesh.half_edge(v(1), v(3), h.cell()).unwrap();
    mesh.flip(diagonal);
    assert_eq!(mesh.faults(Level::Sphere, 4), []);
    assert_eq!(names(&mesh), [0, 1, 2, 0, 2, 3]);
}

#[test]
fn flips_of_ghost_edges_add_and_remove_a_triangle() {
    let mut mesh = Mesh::<2>::from_cells(2, &[0, 1, 2, 0, 2, 3].map(v)).unwrap();
    let cell = mesh.ghost_cells().find(|&c| mesh.corners(c).contains(&v(1))).unwrap();
    let spoke = mesh.half_edge(v(1), VertexId::GHOST, cell).unwrap();
    mesh.flip(spoke);
    assert_eq!(mesh.faults(Level::Sphere, 4), []);
    assert_eq!((mesh.solid_cells().count(), mesh.ghost_cells().count()), (3, 3));
}

#[test]
fn cells_are_assembled_to_the_mesh_they_come_from() {
    fn check<const D: usize>() {
        for k in 0..=D {
            let whole = simplex::<D>(k);
            let cells: Vec<VertexId> =
                whole.solid_cells().flat_map(|cell| whole.corners(cell).to_vec()).collect();
            let mesh = Mesh::<D>::from_cells(k, &cells).unwrap();
            assert_eq!(mesh.faults(Level::Sphere, k + 1), []);
            assert_eq!(mesh.cell_count(), whole.cell_count());
        }
    }
    check::<2>();
    check::<4>();
    let line = Mesh::<2>::from_cells(1, &[0, 1, 1, 2].map(v)).unwrap();
    assert_eq!(line.faults(Level::Sphere, 3), []);
}

#[test]
fn cells_that_do_not_fit_are_refused() {
    let refused = |cells: &[usize]| {
        let corners: Vec<VertexId> = cells.iter().map(|&i| v(i)).collect();
        Mesh::<2>::from_cells(2, &corners).unwrap_err()
    };
    assert_eq!(refused(&[0, 1]), [MeshFault::Lengths]);
    assert_eq!(refused(&[]), [MeshFault::Lengths]);
    assert_eq!(refused(&[0, 1, 1]), [MeshFault::RepeatedCorner(CellId::new(0))]);
    // Both on the left of 0 1.
    assert!(matches!(refused(&[0, 1, 2, 0, 1, 3])[0], MeshFault::TwinVertices(..)));
    // Three at one edge.
    assert!(matches!(refused(&[0, 1, 2, 1, 0, 3, 0, 1, 4])[0], MeshFault::Twin(..)));
}

#[test]
fn a_transplant_undoes_a_split() {
    let mut mesh = simplex::<3>(3);
    let donor = mesh.clone();
    let mut cavity = Cavity::new();
    split(&mut mesh, &mut cavity, CellId::new(0), 4);
    let about = |cell: CellId| mesh.corners(cell).contains(&v(4));
    let seed = mesh.cells().find(|&cell| about(cell)).unwrap();
    let mut hole = Cavity::new();
    hole.dig(&mesh, seed, about);
    mesh.transplant(&hole, &donor, &cavity, |u| u);
    mesh.compact(|_, _| {});
    assert_eq!(mesh.faults(Level::Sphere, 4), []);
    assert_eq!(mesh.cell_count(), 5);
}
