//! Laws of triangulations with Steiner points: the judge accepts them, and the order of input leaves no trace.

use delone::Pslg;
use delone::cdt::Fill;
use delone::check::{Level, Promise};
use delone::conforming::{
    ConformOptions, Conforming, Limits, Reason, RefineOptions, Refined, methods, narrowest_gap,
    refine,
};
use delone::mesh::CellId;
use delone::predicates::{Dyadic, Homogeneous, Metric, Sign};

use crate::case::Case;
use crate::judge;
use crate::laws::Law;

/// Few enough to be quick.
const LIMITS: Limits = Limits { vertices_max: 40 };

/// Every method's result is what it promises.
pub(in crate::fuzz) fn of_conforming() -> Vec<Law<2>> {
    vec![Law { name: "conforming", hold: conforming }]
}

fn conforming(case: &Case<2>) -> usize {
    let (pslg, options) = (case.pslg(), ConformOptions { limits: LIMITS, ..Default::default() });
    let shuffled = case.shuffled(1).pslg();
    for method in methods() {
        let result = (method.run)(&pslg, &options, &mut ());
        let promise = judge::promise(&method, &result);
        accept(case, &pslg, &result, promise);
        if result.is_complete() {
            let other = (method.run)(&shuffled, &options, &mut ());
            let prints = [&result, &other].map(Conforming::fingerprint);
            assert_eq!(prints[0], prints[1], "{}: {}, shuffled", case.name, method.name);
        }
    }
    methods().len()
}

fn accept(case: &Case<2>, pslg: &Pslg, result: &Conforming, promise: Promise) {
    if result.mesh().dimension() != Some(2) {
        assert!(result.steiner_points().is_empty(), "{}: points in a flat", case.name);
        return;
    }
    let verdict = judge::conforming(pslg, result, promise);
    let level =
        if promise == Promise::Constrained { Level::Constrained } else { Level::Conforming };
    assert!(verdict.ok && verdict.level == level, "{}, {promise:?}: {verdict}", case.name);
}

/// What refinement leaves is a constrained Delaunay triangulation without small angles inside, and as large as its gaps ask for.
pub(in crate::fuzz) fn of_refinement() -> Vec<Law<2>> {
    vec![Law { name: "refinement", hold: refinement }]
}

fn refinement(case: &Case<2>) -> usize {
    let (pslg, options) = (case.pslg(), RefineOptions { limits: LIMITS, ..Default::default() });
    let fills = [Fill::Hull, Fill::Exterior];
    for fill in &fills {
        let refined = refine(&pslg, fill, &options, &mut ()).expect("these rules always apply");
        let result = refined.triangulation();
        accept(case, &pslg, result, Promise::Constrained);
        let gap = narrowest_gap(&pslg, fill, options.angle_deg_min).expect("as before");
        if refined.is_complete() {
            let (cells, of_gap) =
                (refined.cells().count(), gap.map_or(0.0, |gap| gap.triangles_min));
            assert!(cells as f64 >= of_gap, "{}: {cells} triangles for {gap:?}", case.name);
            let beyond_hull = refined.left_alone_for(Reason::Unreachable);
            assert!(beyond_hull == 0 || matches!(fill, Fill::Hull), "{}: {beyond_hull}", case.name);
            let left = |cell| refined.left_alone().iter().any(|left| left.cell == cell);
            for cell in refined.cells().filter(|&cell| !left(cell)) {
                assert!(!has_small_angle(&refined, cell), "{}: {cell:?} is skinny", case.name);
            }
        }
    }
    fills.len()
}

/// Whether an angle is certainly less than 20.7 degrees: its cosine's square is more than 0.8751, in exact numbers.
fn has_small_angle(refined: &Refined, cell: CellId) -> bool {
    let kernel = refined.triangulation().kernel();
    let corners = refined.triangulation().mesh().corners(cell);
    let at = |i: usize| -> Homogeneous<Dyadic, 2> { kernel.exact_point(corners[i % 3]) };
    (0..3).any(|i| {
        let (o, p, q) = (at(i), at(i + 1), at(i + 2));
        let (u, v) = (between(&o, &p), between(&o, &q));
        let cosine = dot(&u, &v);
        let squares = dot(&u, &u) * &dot(&v, &v) * &Dyadic::from(8751);
        let excess = cosine.clone() * &cosine * &Dyadic::from(10_000) - &squares;
        cosine.sign() == Sign::Positive && excess.sign() == Sign::Positive
    })
}

/// A positive multiple of the vector between two points.
fn between(from: &Homogeneous<Dyadic, 2>, to: &Homogeneous<Dyadic, 2>) -> [Dyadic; 2] {
    std::array::from_fn(|axis| to.x[axis].clone() * &from.w - &(from.x[axis].clone() * &to.w))
}

fn dot(u: &[Dyadic; 2], v: &[Dyadic; 2]) -> Dyadic {
    u[0].clone() * &v[0] + &(u[1].clone() * &v[1])
}
