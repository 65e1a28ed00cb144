//! Laws of points asked about: where they lie, whom they are nearest to, by trying everything; and of Voronoi's diagram.

use std::num::NonZeroUsize;

use delone::Sites;
use delone::delaunay::{
    Delaunay, Dual, Located, Options, PowerDiagram, delaunay, locate, natural_neighbours,
    nearest_sites,
};
use delone::mesh::{CellId, Mesh, VertexId};
use delone::predicates::{Dyadic, Exact, Kernel, Sign};

use crate::case::Case;
use crate::exact::nudged;
use crate::id;
use crate::laws::Law;

/// In any dimension.
pub(in crate::fuzz) fn of_queries<const D: usize>() -> Vec<Law<D>> {
    vec![
        Law { name: "location", hold: location },
        Law { name: "nearest", hold: nearest },
        Law { name: "voronoi", hold: voronoi },
    ]
}

/// Those of the plane as well.
pub(in crate::fuzz) fn of_plane_queries() -> Vec<Law<2>> {
    [of_queries(), vec![Law { name: "natural neighbours", hold: natural }]].concat()
}

/// Sites, points between them, beside them, beyond them.
fn queries<const D: usize>(sites: &Sites<D>) -> Vec<[f64; D]> {
    let points = sites.points();
    let mut all = points.to_vec();
    for pair in points.windows(2) {
        all.push(std::array::from_fn(|i| pair[0][i] / 2.0 + pair[1][i] / 2.0));
        all.push(std::array::from_fn(|i| if i == 0 { nudged(pair[0][0], 1) } else { pair[0][i] }));
        all.push(std::array::from_fn(|i| if i == 0 { pair[0][0] } else { pair[1][i] }));
    }
    all
}

fn run<const D: usize>(sites: &Sites<D>) -> Delaunay<D> {
    delaunay(sites, &Options::default(), &mut ())
}

/// The face found is the one in whose relative interior exact orientations put the point.
fn location<const D: usize>(case: &Case<D>) -> usize {
    let (sites, asked) = (case.sites(), queries(&case.sites()));
    let result = run(&sites);
    let mesh = result.mesh();
    let Ok(found) = locate(mesh, &sites, &asked, NonZeroUsize::MIN) else {
        assert_ne!(mesh.dimension(), Some(D), "{}: refused", case.name);
        return 0;
    };
    let kernel = Exact::new([sites.points(), &asked].concat());
    for (place, located) in found.iter().enumerate() {
        let q = VertexId::new(sites.len() + place);
        let expected = mesh.solid_cells().find_map(|cell| holding_face(mesh, &kernel, cell, q));
        let (found, what) = (face(mesh, *located), asked[place]);
        assert_eq!(found, expected, "{}: {what:?} is {located:?}", case.name);
        if let Located::Ghost(ghost) = located {
            let beyond = mesh.corners(*ghost).iter().map(|&v| if v.is_ghost() { q } else { v });
            let sign = kernel.orient(&beyond.collect::<Vec<_>>());
            assert_eq!(sign, Sign::Positive, "{}: {what:?} is not beyond", case.name);
        }
    }
    found.len()
}

/// The vertices of the face of a closed cell in whose relative interior a vertex of the kernel is, sorted; if it is in the cell.
fn holding_face<const D: usize>(
    mesh: &Mesh<D>,
    kernel: &impl Kernel<D>,
    cell: CellId,
    q: VertexId,
) -> Option<Vec<VertexId>> {
    let corners = mesh.corners(cell);
    let mut face = Vec::new();
    for place in 0..corners.len() {
        let mut replaced = corners.to_vec();
        replaced[place] = q;
        match kernel.orient(&replaced) {
            Sign::Negative => return None,
            Sign::Zero => {}
            Sign::Positive => face.push(corners[place]),
        }
    }
    face.sort_unstable();
    Some(face)
}

/// The vertices of a located face, sorted; nothing outside.
fn face<const D: usize>(mesh: &Mesh<D>, located: Located<D>) -> Option<Vec<VertexId>> {
    let mut vertices: Vec<VertexId> = match located {
        Located::Vertex(v) => vec![v],
        Located::Face { cell, corners } => {
            let on = mesh.corners(cell).iter().enumerate();
            on.filter(|(i, _)| corners >> i & 1 == 1).map(|(_, &v)| v).collect()
        }
        Located::Facet(facet) => {
            let corners = mesh.corners(facet.cell());
            corners.iter().copied().filter(|&v| v != mesh.apex(facet)).collect()
        }
        Located::Cell(cell) => mesh.corners(cell).to_vec(),
        _ => return None,
    };
    vertices.sort_unstable();
    Some(vertices)
}

/// No site is nearer, none at the same distance is less.
fn nearest<const D: usize>(case: &Case<D>) -> usize {
    let (sites, asked) = (case.sites(), queries(&case.sites()));
    let found = nearest_sites(&run(&sites), &sites, &asked, NonZeroUsize::MIN).expect("finite");
    let ranks = sites.ranks();
    for (q, found) in asked.iter().zip(&found) {
        let all = (0..id(sites.len()))
            .map(|site| (distance(q, &sites.points()[site as usize]), ranks[site as usize], site));
        let expected = all.min_by(|a, b| a.0.cmp(&b.0).then(a.1.cmp(&b.1)));
        assert_eq!(*found, expected.map(|(_, _, site)| site), "{}: {q:?}", case.name);
    }
    found.len()
}

/// The square of the distance.
fn distance<const D: usize>(p: &[f64; D], q: &[f64; D]) -> Dyadic {
    (0..D).fold(Dyadic::from(0), |sum, axis| {
        let away = Dyadic::from(p[axis]) - &Dyadic::from(q[axis]);
        sum + &(away.clone() * &away)
    })
}

/// Two neighbours have one center if and only if they are cospherical; each facet has its edge, each site its region.
fn voronoi<const D: usize>(case: &Case<D>) -> usize {
    let sites = case.sites();
    let result = run(&sites);
    let mesh = result.mesh();
    let Some(diagram) = PowerDiagram::of_delaunay(&result, &sites) else {
        assert_ne!(mesh.dimension(), Some(D), "{}: refused", case.name);
        return 0;
    };
    let kernel = Exact::new(sites.points());
    let mut edges = 0;
    for (facet, dual) in diagram.edges() {
        edges += 1;
        if let Dual::Segment([one, other]) = dual {
            let apex = mesh.apex(mesh.twin(facet));
            let tie = kernel.lifted(mesh.corners(one), apex) == Sign::Zero;
            let same = diagram.vertex(one) == diagram.vertex(other);
            assert_eq!(same, tie, "{}: centers of {one:?} and {other:?}", case.name);
        }
    }
    let (solid, ghosts) = (mesh.solid_cells().count(), mesh.ghost_cells().count());
    assert_eq!(2 * edges, (D + 1) * solid + ghosts, "{}: edges of the diagram", case.name);
    edges
}

/// The neighbours of a point inside the hull are those it would have as a site.
fn natural(case: &Case<2>) -> usize {
    let (sites, asked) = (case.sites(), queries(&case.sites()));
    let result = run(&sites);
    let threads = NonZeroUsize::MIN;
    let Ok(found) = natural_neighbours(&result, &sites, &asked, threads) else { return 0 };
    let located = locate(result.mesh(), &sites, &asked, threads).expect("they were found");
    for ((q, found), located) in asked.iter().zip(&found).zip(&located) {
        let mesh = result.mesh();
        let inside = match *located {
            Located::Cell(_) => true,
            Located::Facet(h) => ![h, mesh.twin(h)].iter().any(|h| mesh.is_ghost(h.cell())),
            _ => false,
        };
        if !inside {
            continue;
        }
        let more = Sites::new(&[sites.points(), &[*q]].concat()).expect("finite");
        let cells = run(&more).canonical();
        let around = cells.chunks(3).filter(|cell| cell.contains(&id(sites.len())));
        let mut expected: Vec<u32> = around.flatten().copied().collect();
        expected.retain(|&v| v != id(sites.len()));
        expected.sort_unstable();
        expected.dedup();
        let mut names: Vec<u32> = found.iter().map(|&(site, _)| site).collect();
        names.sort_unstable();
        assert_eq!(names, expected, "{}: neighbours of {q:?}", case.name);
    }
    found.len()
}
