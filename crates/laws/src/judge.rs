//! Results as plain data, and before the judge.

use delone::cdt::Cdt;
use delone::check::{
    Angles, Backend, Binary, Complex, Conformed, Level, Links, Options, Promise, SteinerPoint,
    Verdict, judge_conforming, judge_constrained, judge_delaunay, judge_links, judge_refined,
    judge_regular,
};
use delone::conforming::{Conforming, Method, Refined, SteinerPoint as Added};
use delone::delaunay::{Delaunay, Regular};
use delone::mesh::{Mesh, VertexId};
use delone::predicates::{Dyadic, Sign};
use delone::sites::WeightedSites;
use delone::{Pslg, Sites};

use crate::case::Case;
use crate::id;

/// How hard to look.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rigour {
    /// The judge's default.
    Once,
    /// Every backend, with and without filters, all of one verdict.
    EveryWay,
}

/// Accepts a Delaunay triangulation of the case, or panics with the verdict.
pub fn accept_delaunay<const D: usize>(
    case: &Case<D>,
    sites: &Sites<D>,
    result: &Delaunay<D>,
    rigour: Rigour,
) {
    accept_links(&case.name, result.mesh());
    let cells = solid_cells(result.mesh(), sites.input_of());
    let dimension = result.mesh().dimension();
    let complex = Complex { points: &case.points, dimension, cells: &cells };
    accept(&case.name, Level::Delaunay, rigour, |options| judge_delaunay(&complex, options));
}

/// Accepts a regular triangulation of the case with these weights, or panics with the verdict.
pub fn accept_regular<const D: usize>(
    case: &Case<D>,
    weights: &[f64],
    sites: &WeightedSites<D>,
    result: &Regular<D>,
) {
    accept_links(&case.name, result.mesh());
    let cells = solid_cells(result.mesh(), sites.input_of());
    let dimension = result.mesh().dimension();
    let complex = Complex { points: &case.points, dimension, cells: &cells };
    let rigour = if case.points.len() <= 12 { Rigour::EveryWay } else { Rigour::Once };
    accept(&case.name, Level::Regular, rigour, |options| judge_regular(&complex, weights, options));
}

/// Accepts a constrained Delaunay triangulation of the case, or panics with the verdict.
pub fn accept_constrained(case: &Case<2>, pslg: &Pslg, result: &Cdt, rigour: Rigour) {
    accept_links(&case.name, result.mesh());
    let input_of = pslg.sites().input_of();
    let cells = solid_cells(result.mesh(), input_of);
    let flagged: Vec<[u32; 2]> = result
        .constrained_edges()
        .into_iter()
        .map(|edge| edge.map(|site| input_of[site as usize]))
        .collect();
    let dimension = result.mesh().dimension();
    let complex = Complex { points: &case.points, dimension, cells: &cells };
    accept(&case.name, Level::Constrained, rigour, |options| {
        judge_constrained(&complex, &case.segments, &flagged, options)
    });
}

/// What a result of a method promises: less if a limit was reached.
#[must_use]
pub fn promise(method: &Method, result: &Conforming) -> Promise {
    match (result.is_complete(), method.empties_disks) {
        (false, _) => Promise::Constrained,
        (true, false) => Promise::Conforming,
        (true, true) => Promise::EmptyDisks,
    }
}

/// What the judge says of a triangulation with Steiner points, these being exact.
#[must_use]
pub fn conforming(pslg: &Pslg, result: &Conforming, promise: Promise) -> Verdict {
    with_conformed(pslg, result, promise, judge_conforming)
}

/// What it says of a refined triangulation that is complete, and of its angles.
#[must_use]
pub fn refined(pslg: &Pslg, refined: &Refined, cosine_square: f64) -> Verdict {
    let (inside, exceptions) = refined.promised();
    let angles = Angles { cosine_square, inside: &inside, exceptions: &exceptions };
    with_conformed(pslg, refined.triangulation(), Promise::Constrained, |conformed, options| {
        judge_refined(conformed, &angles, options)
    })
}

/// Asks a judge; of sites in line, to which nothing is added, that of constrained triangulations.
fn with_conformed(
    pslg: &Pslg,
    result: &Conforming,
    promise: Promise,
    judge: impl FnOnce(&Conformed<'_>, &Options) -> Verdict,
) -> Verdict {
    let (mesh, options) = (result.mesh(), Options::default());
    let corners = mesh.solid_cells().flat_map(|cell| mesh.corners(cell));
    let cells: Vec<u32> = corners.map(|v| id(v.index())).collect();
    let (points, flags) = (pslg.sites().points(), result.constrained_edges());
    if mesh.dimension() != Some(2) {
        let complex = Complex { points, dimension: mesh.dimension(), cells: &cells };
        return judge_constrained(&complex, pslg.segments(), flags, &options);
    }
    let added = result.steiner_points().iter().zip(&result.positions()[points.len()..]);
    let steiner = added.map(|(added, &position)| match added {
        Added::On { ends, t, .. } => SteinerPoint::On { ends: *ends, t: binary(t) },
        Added::Free => SteinerPoint::At(position),
        Added::FreeExactly { at } => SteinerPoint::Exactly(at.each_ref().map(binary)),
    });
    let conformed = Conformed {
        points,
        steiner: &steiner.collect::<Vec<_>>(),
        cells: &cells,
        segments: pslg.segments(),
        constrained: flags,
        promise,
    };
    judge(&conformed, &options)
}

/// A number by its digits.
fn binary(x: &Dyadic) -> Binary<'_> {
    let negative = x.sign() == Sign::Negative;
    Binary { mantissa: x.mantissa(), exponent: x.exponent(), negative }
}

fn accept(name: &str, level: Level, rigour: Rigour, judge: impl Fn(&Options) -> Verdict) {
    let first = judge(&Options::default());
    assert!(first.ok && first.level == level, "{name}: {first}");
    if rigour == Rigour::EveryWay {
        for &backend in Backend::all() {
            for filtered in [false, true] {
                let other = judge(&Options { backend, filtered, ..Options::default() });
                assert_eq!(other, first, "{name}: {backend:?}, filtered {filtered}");
            }
        }
    }
}

/// The corners of the solid cells, flat, as input points.
#[must_use]
pub fn solid_cells<const D: usize>(mesh: &Mesh<D>, input_of: &[u32]) -> Vec<u32> {
    let corners = mesh.solid_cells().flat_map(|cell| mesh.corners(cell));
    corners.map(|v| input_of[v.index()]).collect()
}

/// The whole mesh, ghosts included, is a closed oriented sphere.
fn accept_links<const D: usize>(name: &str, mesh: &Mesh<D>) {
    let corners = mesh.corner_count();
    let ghost = u32::MAX;
    let number = |v: &VertexId| if v.is_ghost() { ghost } else { id(v.index()) };
    let vertices: Vec<u32> = mesh.cells().flat_map(|cell| mesh.corners(cell)).map(number).collect();
    let twins: Vec<u32> = mesh
        .cells()
        .flat_map(|cell| mesh.facets(cell))
        .map(|facet| mesh.twin(facet))
        .map(|twin| id(twin.cell().index() * corners + twin.corner()))
        .collect();
    let links = Links { dimension: mesh.dimension(), vertices: &vertices, twins: &twins, ghost };
    let verdict = judge_links(&links, &Options::default());
    assert!(verdict.ok && verdict.level == Level::Linked, "{name}: {verdict}");
}
