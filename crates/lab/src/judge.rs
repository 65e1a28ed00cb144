//! Asking the judge: meshes as the plain data that it takes, and several verdicts as one.

use delone_cdt::Cdt;
use delone_check::{
    Arranged, Complex, Links, Options, Promise, Verdict, judge_arranged, judge_constrained,
    judge_delaunay, judge_links, judge_regular,
};
use delone_conforming::{Conforming, Refined};
use delone_delaunay::{Delaunay, Regular};
use delone_laws::judge as laws;
use delone_mesh::Mesh;
use delone_sites::{Arrangement, Pslg, Sites, WeightedSites};

/// The solid cells as ids of vertices, as the mesh has them.
pub(crate) fn solid_ids<const D: usize>(mesh: &Mesh<D>) -> Vec<u32> {
    mesh.solid_cells()
        .flat_map(|cell| mesh.corners(cell))
        .map(|vertex| id(vertex.index()))
        .collect()
}

fn id(index: usize) -> u32 {
    u32::try_from(index).expect("a handle fits 32 bits")
}

/// Judges a Delaunay triangulation: first its links, then its geometry.
pub(crate) fn delaunay<const D: usize>(sites: &Sites<D>, result: &Delaunay<D>) -> Verdict {
    let options = Options::default();
    let mesh = result.mesh();
    let cells = solid_ids(mesh);
    let complex = Complex { points: sites.points(), dimension: mesh.dimension(), cells: &cells };
    joined(links(mesh), judge_delaunay(&complex, &options))
}

/// Judges a regular triangulation, and what is hidden.
pub(crate) fn regular<const D: usize>(sites: &WeightedSites<D>, result: &Regular<D>) -> Verdict {
    let mesh = result.mesh();
    let cells = solid_ids(mesh);
    let points = sites.sites().points();
    let complex = Complex { points, dimension: mesh.dimension(), cells: &cells };
    joined(links(mesh), judge_regular(&complex, sites.weights(), &Options::default()))
}

/// Judges a CDT against the segments as they were given.
pub(crate) fn cdt(pslg: &Pslg, result: &Cdt) -> Verdict {
    let mesh = result.mesh();
    let cells = solid_ids(mesh);
    let points = pslg.sites().points();
    let complex = Complex { points, dimension: mesh.dimension(), cells: &cells };
    let flags = result.constrained_edges();
    joined(links(mesh), judge_constrained(&complex, pslg.segments(), &flags, &Options::default()))
}

/// Judges the CDT of an arrangement, crossings and all, in exact ratios.
pub(crate) fn arranged(graph: &Arrangement, result: &Cdt) -> Verdict {
    let mesh = result.mesh();
    let cells = solid_ids(mesh);
    let (points, flags) = (graph.sites().points(), result.constrained_edges());
    let verdict = if graph.crossings().is_empty() {
        let complex = Complex { points, dimension: mesh.dimension(), cells: &cells };
        judge_constrained(&complex, graph.segments(), &flags, &Options::default())
    } else {
        let arranged = Arranged {
            points,
            crossings: graph.crossings(),
            cells: &cells,
            segments: graph.segments(),
            constrained: &flags,
        };
        judge_arranged(&arranged, &Options::default())
    };
    joined(links(mesh), verdict)
}

/// Judges a triangulation with Steiner points, these being exact.
pub(crate) fn conforming(pslg: &Pslg, result: &Conforming, promise: Promise) -> Verdict {
    joined(links(result.mesh()), laws::conforming(pslg, result, promise))
}

/// Judges a refined triangulation that is complete, and its angles.
pub(crate) fn refined(pslg: &Pslg, result: &Refined, cosine_square: f64) -> Verdict {
    joined(links(result.triangulation().mesh()), laws::refined(pslg, result, cosine_square))
}

/// Judges a mesh with each vertex at the nearest doubles: whether rounding keeps it a triangulation of the hull with all
/// pieces as edges. That it is still Delaunay is not asked.
pub(crate) fn rounded(mesh: &Mesh<2>, positions: &[[f64; 2]]) -> bool {
    let cells = solid_ids(mesh);
    let complex = Complex { points: positions, dimension: mesh.dimension(), cells: &cells };
    let verdict = judge_constrained(&complex, &[], &[], &Options::default());
    let is_geometry = |kind: &&&str| !matches!(**kind, "not-delaunay" | "wrong-tie");
    verdict.counts.keys().filter(is_geometry).count() == 0
}

/// Judges twins and ghosts.
fn links<const D: usize>(mesh: &Mesh<D>) -> Verdict {
    let ghost = u32::MAX;
    let count = mesh.corner_count();
    let corners = mesh.cells().flat_map(|cell| mesh.corners(cell));
    let vertices: Vec<u32> =
        corners.map(|v| if v.is_ghost() { ghost } else { id(v.index()) }).collect();
    let facets = mesh.cells().flat_map(|cell| mesh.facets(cell)).map(|facet| mesh.twin(facet));
    let twins: Vec<u32> =
        facets.map(|twin| id(twin.cell().index() * count + twin.corner())).collect();
    let dimension = mesh.dimension();
    judge_links(
        &Links { dimension, vertices: &vertices, twins: &twins, ghost },
        &Options::default(),
    )
}

/// The verdict on a CDT and that on its fill; the level is that of the CDT.
pub(crate) fn with_fill(cdt: Verdict, fill: Verdict) -> Verdict {
    let (level, ties, duplicates) = (cdt.level, cdt.ties, cdt.duplicates);
    let claims = fill.proved.iter().filter(|claim| claim.starts_with('F')).cloned().collect();
    let fill = Verdict { proved: claims, ..fill };
    Verdict { level, ties, duplicates, ..joined(cdt, fill) }
}

/// Both verdicts; the level is that of the second.
fn joined(first: Verdict, second: Verdict) -> Verdict {
    let mut proved = first.proved;
    proved.extend(second.proved);
    let mut faults = first.faults;
    faults.extend(second.faults);
    let mut counts = first.counts;
    for (kind, count) in second.counts {
        *counts.entry(kind).or_insert(0) += count;
    }
    Verdict { ok: first.ok && second.ok, proved, faults, counts, ..second }
}
