//! Wide cavities: one or two long segments through sparse random points, some hanging close below others. Edges dangle in
//! the cavities (both triangles at them are crossed, they are not), chains fold back and have spikes.

use delone::cdt::cavity;
use delone::delaunay::Options;
use delone::workloads::Rng;
use delone_tests::case::Case;
use delone_tests::judge::{Rigour, accept_constrained};

/// Points between the ends of a segment from (-12, 0) to (12, 0).
fn case(seed: u64, on_integers: bool) -> Case<2> {
    let mut rng = Rng::named("cavities", seed);
    let mut points = vec![[-12.0, 0.0], [12.0, 0.0]];
    let tall = [1.0, 3.0, 10.0][rng.index(3)];
    for _ in 0..6 + rng.index(30) {
        let [x, y] = [rng.between(-10.0, 10.0), rng.between(-tall, tall)];
        points.push([x, y]);
        if rng.coin() {
            points.push([x + rng.between(-0.2, 0.2), y * rng.unit()]);
        }
    }
    if on_integers {
        points.iter_mut().for_each(|p| *p = p.map(f64::round));
    }
    let mut segments = vec![[0, 1]];
    let ends = [0, 0].map(|_| delone_tests::id(rng.index(points.len())));
    segments.push(ends);
    let name = format!("cavities, seed {seed}");
    let both = Case::new(name, points, segments);
    if both.try_pslg().is_some() {
        return both;
    }
    Case { segments: vec![[0, 1]], ..both }
}

fn check(case: &Case<2>) {
    let pslg = case.pslg();
    let result = cavity(&pslg, &Options::default(), &mut ());
    accept_constrained(case, &pslg, &result, Rigour::Once);
}

#[test]
fn long_segments_through_sparse_points() {
    (0..4000).for_each(|seed| check(&case(seed, false)));
}

#[test]
fn long_segments_through_points_of_a_lattice() {
    (0..4000).for_each(|seed| check(&case(seed, true)));
}
