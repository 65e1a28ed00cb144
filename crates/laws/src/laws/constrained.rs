//! The laws of constrained Delaunay triangulations.

use delone::Pslg;
use delone::cdt::{
    Algorithm, Cdt, Domain, Dynamic, Fill, FillError, algorithms, cavity, chew_from_points,
    from_points,
};
use delone::check::{Complex, FillRule, judge_fill, naive};
use delone::delaunay::{Options, delaunay};
use delone::predicates::Adaptive;

use super::delaunay::in_input_ids;
use super::{Law, THOROUGH_MAX, all_options, scalings, symmetries, translations};
use crate::case::Case;
use crate::cells::delaunay_cells;
use crate::id;
use crate::judge::{Rigour, accept_constrained, solid_cells};

/// Every law of planar straight-line graphs whose segments do not cross.
#[must_use]
pub fn constrained_laws() -> Vec<Law<2>> {
    vec![
        Law { name: "valid", hold: valid },
        Law { name: "agreement", hold: agreement },
        Law { name: "noded on the way", hold: noded_on_the_way },
        Law { name: "order", hold: order },
        Law { name: "scaling", hold: |case| same_cells(case, scalings(case)) },
        Law { name: "translation", hold: |case| same_cells(case, translations(case)) },
        Law { name: "symmetry", hold: symmetry },
        Law { name: "idempotence", hold: idempotence },
        Law { name: "euler", hold: euler },
        Law { name: "definition", hold: definition },
        Law { name: "fill", hold: fill },
        Law { name: "change", hold: change },
    ]
}

fn run(case: &Case<2>) -> Cdt {
    cavity(&case.pslg(), &Options::default(), &mut ())
}

/// The algorithms that are meant for as many sites.
fn fitting(pslg: &Pslg) -> Vec<Algorithm> {
    algorithms().into_iter().filter(|algorithm| pslg.sites().len() <= algorithm.sites_max).collect()
}

fn valid(case: &Case<2>) -> usize {
    let pslg = case.pslg();
    let rigour = if case.points.len() <= THOROUGH_MAX { Rigour::EveryWay } else { Rigour::Once };
    let algorithms = fitting(&pslg);
    for algorithm in &algorithms {
        let result = (algorithm.run)(&pslg, &Options::default());
        accept_constrained(case, &pslg, &result, rigour);
    }
    algorithms.len()
}

fn agreement(case: &Case<2>) -> usize {
    let pslg = case.pslg();
    let first = run(case);
    let (algorithms, options) = (fitting(&pslg), all_options());
    for algorithm in &algorithms {
        for options in &options {
            let other = (algorithm.run)(&pslg, options);
            let which = format!("{}: {} {options:?}", case.name, algorithm.name);
            assert_eq!(other.canonical(), first.canonical(), "{which}");
            assert_eq!(other.constrained_edges(), first.constrained_edges(), "{which}");
        }
    }
    algorithms.len() * options.len()
}

fn noded_on_the_way(case: &Case<2>) -> usize {
    let segments: Vec<[usize; 2]> =
        case.segments.iter().map(|ends| ends.map(|id| id as usize)).collect();
    let first = run(case);
    let ways = [from_points, chew_from_points];
    for way in ways {
        let (pslg, result) = way(&case.points, &segments, &mut ())
            .unwrap_or_else(|error| panic!("{}: {error}", case.name));
        assert_eq!(pslg, case.pslg(), "{}", case.name);
        assert_eq!(result.canonical(), first.canonical(), "{}", case.name);
        assert_eq!(result.constrained_edges(), first.constrained_edges(), "{}", case.name);
    }
    ways.len()
}

fn order(case: &Case<2>) -> usize {
    let print = |case: &Case<2>| run(case).fingerprint(&case.pslg());
    let first = print(case);
    for seed in 1..=3 {
        let shuffled = case.shuffled(seed);
        assert_eq!(print(&shuffled), first, "{}", shuffled.name);
    }
    3
}

fn same_cells(case: &Case<2>, images: Vec<Case<2>>) -> usize {
    let first = run(case);
    for image in &images {
        let other = run(image);
        assert_eq!(other.canonical(), first.canonical(), "{}", image.name);
        assert_eq!(other.constrained_edges(), first.constrained_edges(), "{}", image.name);
    }
    images.len()
}

fn symmetry(case: &Case<2>) -> usize {
    let cells = |case: &Case<2>| {
        let (pslg, result) = (case.pslg(), run(case));
        let corners = result.mesh().corner_count();
        let edges = result.constrained_edges();
        delaunay_cells(pslg.sites().points(), &result.canonical(), corners, &edges)
    };
    let first = cells(case);
    let images = symmetries(case);
    for image in &images {
        assert_eq!(cells(image), first, "{}", image.name);
    }
    images.len()
}

/// All edges of the result as segments: nothing is left to choose. No segments: plain Delaunay.
fn idempotence(case: &Case<2>) -> usize {
    let (pslg, first) = (case.pslg(), run(case));
    let corners = first.mesh().corner_count();
    let mut segments = Vec::new();
    for cell in first.canonical().chunks(corners.max(1)) {
        for (i, &v) in cell.iter().enumerate() {
            segments.extend(cell[..i].iter().map(|&u| [u, v]));
        }
    }
    let name = format!("{}, its own edges", case.name);
    let again = run(&Case::new(name, pslg.sites().points().to_vec(), segments));
    assert_eq!(again.canonical(), first.canonical(), "{}, its own edges", case.name);
    let free = run(&case.without_segments());
    let plain = delaunay(pslg.sites(), &Options::default(), &mut ());
    assert_eq!(free.canonical(), plain.canonical(), "{}, without segments", case.name);
    2
}

fn euler(case: &Case<2>) -> usize {
    let result = run(case);
    if result.mesh().dimension() != Some(2) {
        return 0;
    }
    let (n, h) = (case.sites().len(), result.mesh().ghost_cells().count());
    assert_eq!(result.mesh().solid_cells().count() + 2 + h, 2 * n, "{}", case.name);
    1
}

/// The most points for which brute force is quick.
const NAIVE_MAX: usize = 12;

fn definition(case: &Case<2>) -> usize {
    if case.points.len() > NAIVE_MAX {
        return 0;
    }
    let (pslg, result) = (case.pslg(), run(case));
    let corners = result.mesh().corner_count();
    let found = in_input_ids(&result.canonical(), corners, pslg.sites().input_of());
    assert_eq!(found, naive::constrained(&case.points, &case.segments), "{}", case.name);
    1
}

/// What is inside by each rule is what the judge says; where there is no answer, an odd vertex or an unbalanced one is shown.
fn fill(case: &Case<2>) -> usize {
    let (pslg, result) = (case.pslg(), run(case));
    if result.mesh().dimension() != Some(2) {
        return 0;
    }
    let cells = solid_cells(result.mesh(), pslg.sites().input_of());
    let complex = Complex { points: &case.points, dimension: Some(2), cells: &cells };
    // Some points about the middle of cells; one that is on a segment is refused.
    let some = cells.as_chunks::<3>().0.iter().step_by(1 + cells.len() / 12);
    let middle = |corners: &[u32; 3]| {
        let corners = corners.map(|v| case.points[v as usize]);
        [0, 1].map(|x| corners.iter().map(|corner| corner[x] / 3.0).sum::<f64>())
    };
    let seeds: Vec<[f64; 2]> = some.map(middle).collect();
    let rules = [
        (Fill::Seeds(seeds.clone()), FillRule::Seeds(&seeds)),
        (Fill::EvenOdd, FillRule::EvenOdd),
        (Fill::NonZero, FillRule::NonZero),
        (Fill::Positive, FillRule::Positive),
        (Fill::Nesting, FillRule::Nesting),
        (Fill::Exterior, FillRule::Exterior),
    ];
    for (fill, rule) in &rules {
        match Domain::new(&result, &pslg, fill) {
            Ok(domain) => {
                let is_inside = |cell| domain.is_inside(domain.regions().of_cell(cell));
                let inside: Vec<bool> = result.cells().map(is_inside).collect();
                let options = delone::check::Options::default();
                let verdict = judge_fill(&complex, &case.segments, &inside, *rule, &options);
                assert!(verdict.ok, "{}, {rule:?}: {verdict}", case.name);
            }
            Err(FillError::OddVertices(open) | FillError::Unbalanced(open)) => {
                assert!(!open.is_empty(), "{}, {rule:?}", case.name);
            }
            Err(FillError::Seeds(faults)) => assert!(!faults.is_empty(), "{}", case.name),
            Err(error) => panic!("{}, {rule:?}: {error}", case.name),
        }
    }
    rules.len()
}

/// Vertices without segments and segments go, one after the other, and what is left is as from scratch; all come again, and
/// all is as before.
fn change(case: &Case<2>) -> usize {
    let (pslg, first) = (case.pslg(), run(case));
    let (points, count) = (pslg.sites().points(), pslg.sites().len());
    let kernel = Adaptive::new(points);
    let Some(mut dynamic) = Dynamic::new(first.clone(), &kernel, count) else { return 0 };
    let every = count.div_ceil(THOROUGH_MAX);
    let gone: Vec<u32> = (0..id(count))
        .filter(|v| (*v as usize).is_multiple_of(every))
        .filter(|&v| dynamic.remove_vertex(v, &mut ()).is_ok())
        .collect();
    let left: Vec<usize> = (0..count).filter(|&v| dynamic.holds(id(v))).collect();
    assert_eq!(left.len() + gone.len(), count, "{}", case.name);
    let place = |v: u32| id(left.binary_search(&(v as usize)).expect("ends of segments stay"));
    let fewer = Case::new(
        format!("{} less {} vertices", case.name, gone.len()),
        left.iter().map(|&v| points[v]).collect(),
        pslg.subsegments().iter().map(|s| s.map(place)).collect(),
    );
    let expected: Vec<u32> =
        run(&fewer).canonical().iter().map(|&v| id(left[v as usize])).collect();
    assert_eq!(dynamic.cdt().canonical(), expected, "{}", fewer.name);
    for &v in gone.iter().rev() {
        assert!(dynamic.insert_vertex(v, &mut ()), "{}", case.name);
    }
    assert_eq!(dynamic.cdt().canonical(), first.canonical(), "{}", case.name);
    assert_eq!(dynamic.cdt().constrained_edges(), first.constrained_edges(), "{}", case.name);
    for &ends in pslg.subsegments() {
        assert!(dynamic.remove_segment(ends, &mut ()), "{}", case.name);
    }
    let plain = delaunay(pslg.sites(), &Options::default(), &mut ());
    assert_eq!(dynamic.cdt().canonical(), plain.canonical(), "{}", case.name);
    3
}
