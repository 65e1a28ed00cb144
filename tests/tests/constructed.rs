//! Algorithms written for plain points, over constructed ones.

use std::cmp::Ordering;

use delone::cdt::insert_segments;
use delone::delaunay::{bowyer_watson, divide_conquer, naive_delaunay};
use delone::mesh::Mesh;
use delone::predicates::{Adaptive, Constructed, Construction, Dyadic, Kernel};
use delone::sites::{Pslg, Sites};
use delone::workloads::Rng;
use delone_tests::exact::power_of_two;
use delone_tests::id;
use rug::{Integer, Rational};

/// Distinct points of a grid: ties everywhere.
fn grid<const D: usize>(side: u32, count: usize, rng: &mut Rng) -> Sites<D> {
    let points: Vec<[f64; D]> = (0..count)
        .map(|_| std::array::from_fn(|_| f64::from(id(rng.index(side as usize + 1)))))
        .collect();
    let distinct = Sites::new(&points).expect("finite");
    Sites::new(distinct.points()).expect("finite")
}

/// The sites times a number of 80 bits near 1/3, exactly: similar to them, and none a double but the origin.
fn third<const D: usize>(sites: &Sites<D>) -> Constructed<D> {
    let mut points = sites.points().to_vec();
    let origin = id(points.len());
    points.push([0.0; D]);
    let mut kernel = Constructed::new(points);
    let ids: Vec<u32> = (0..origin)
        .map(|b| {
            let t = Dyadic::from(1.0 / 3.0) + Dyadic::from(power_of_two(-80));
            kernel.push(&Construction::SegmentPoint { a: origin, b, t }).expect("plain ends")
        })
        .collect();
    let rounded = ids.iter().filter(|&&id| !kernel.is_exact_position(id)).count();
    assert!(rounded + 1 >= sites.len(), "{rounded} of {} are rounded", sites.len());
    kernel.reordered(&ids)
}

fn canonical<const D: usize>(mesh: &Mesh<D>) -> Vec<u32> {
    mesh.canonical(|v| id(v.index()))
}

fn same_mesh<const D: usize>(side: u32, count: usize, name: &str) {
    for seed in 0..6 {
        let sites = grid::<D>(side, count, &mut Rng::named(name, seed));
        let order: Vec<u32> = (0..id(sites.len())).collect();
        let plain = bowyer_watson(&Adaptive::new(sites.points()), &order, &mut ());
        let constructed = bowyer_watson(&third(&sites), &order, &mut ());
        assert_eq!(canonical(&constructed), canonical(&plain), "seed {seed}");
    }
}

#[test]
fn similar_constructed_points_have_the_same_mesh_in_the_plane() {
    same_mesh::<2>(9, 80, "similar 2");
    same_mesh::<2>(60, 60, "similar 2, sparse");
}

#[test]
fn similar_constructed_points_have_the_same_mesh_in_space() {
    same_mesh::<3>(3, 50, "similar 3");
}

#[test]
fn similar_constructed_points_in_a_line_have_the_same_mesh() {
    let sites = Sites::new(&[[1.0, 2.0, 3.0], [5.0, 10.0, 15.0], [3.0, 6.0, 9.0]]).unwrap();
    let order = [0, 1, 2];
    let plain = bowyer_watson(&Adaptive::new(sites.points()), order, &mut ());
    assert_eq!(canonical(&bowyer_watson(&third(&sites), order, &mut ())), canonical(&plain));
}

#[test]
fn divide_and_conquer_and_segments_run_over_constructed_points() {
    for seed in 0..6 {
        let mut rng = Rng::named("similar, segments", seed);
        let sites = grid::<2>(12, 90, &mut rng);
        let (plain, constructed) = (Adaptive::new(sites.points()), third(&sites));
        let mesh = divide_conquer(&plain, &sites, &mut ());
        let other = divide_conquer(&constructed, &sites, &mut ());
        assert_eq!(canonical(&other), canonical(&mesh), "seed {seed}");
        let mut segments: Vec<[usize; 2]> = Vec::new();
        for _ in 0..60 {
            segments.push([0; 2].map(|_| rng.index(sites.len())));
            if Pslg::new(sites.points(), &segments).is_err() {
                segments.pop();
            }
        }
        let pslg = Pslg::new(sites.points(), &segments).unwrap();
        let n = sites.len();
        let (mesh, _) = insert_segments(mesh, &plain, n, pslg.subsegments(), &mut ());
        let (other, _) = insert_segments(other, &constructed, n, pslg.subsegments(), &mut ());
        assert!(segments.len() > 10, "{segments:?}");
        assert_eq!(canonical(&other), canonical(&mesh), "seed {seed}");
    }
}

/// Crossings of lines through points of a small grid, each once.
fn crossings(rng: &mut Rng) -> Constructed<2> {
    let points: Vec<[f64; 2]> =
        (0..7).map(|_| [0; 2].map(|_| f64::from(id(rng.index(6))))).collect();
    let mut kernel = Constructed::new(points);
    let mut ids = Vec::new();
    for _ in 0..60 {
        let [a, b, c, d] = [0; 4].map(|_| id(rng.index(7)));
        ids.extend(kernel.push(&Construction::Crossing { a, b, c, d }).ok());
    }
    let order = |&u: &u32, &v: &u32| kernel.compare_lexicographic(u as usize, v as usize);
    ids.sort_by(order);
    ids.dedup_by(|u, v| order(u, v) == Ordering::Equal);
    rng.shuffle(&mut ids);
    ids.truncate(12);
    kernel.reordered(&ids)
}

fn rational(x: &Dyadic) -> Rational {
    let limbs = x.mantissa().iter().rev();
    let mantissa = limbs.fold(Integer::new(), |sum, &limb| (sum << 64) + limb);
    let exponent = i32::try_from(x.exponent()).expect("small");
    let value = Rational::from(mantissa) << exponent;
    if x.sign() == delone::predicates::Sign::Negative { -value } else { value }
}

/// All triangles whose circles hold no other point, heights raised by 2^(1000 (rank - n)): by a determinant in rationals.
fn by_definition(points: &[[Rational; 2]]) -> Vec<u32> {
    let n = points.len();
    let mut ranks: Vec<usize> = (0..n).collect();
    ranks.sort_by(|&i, &j| points[i].cmp(&points[j]));
    let height = |i: usize| {
        let place = ranks.iter().position(|&r| r == i).expect("ranked");
        let raised = Rational::from(1) >> u32::try_from(1000 * (n - place)).expect("small");
        let [x, y] = &points[i];
        Rational::from(x * x) + Rational::from(y * y) + raised
    };
    let heights: Vec<Rational> = (0..n).map(height).collect();
    let from = |i: usize, q: usize| {
        let [x, y] = [0, 1].map(|axis: usize| Rational::from(&points[i][axis] - &points[q][axis]));
        (x, y, Rational::from(&heights[i] - &heights[q]))
    };
    let minor = |u: &(Rational, Rational, Rational), v: &(Rational, Rational, Rational)| {
        Rational::from(&u.0 * &v.1) - Rational::from(&u.1 * &v.0)
    };
    let mut cells = Vec::new();
    for c in 0..n {
        for b in 0..c {
            for a in 0..b {
                let turn = minor(&from(b, a), &from(c, a)).cmp0();
                let is_outside = |q: usize| {
                    let [u, v, w] = [a, b, c].map(|i| from(i, q));
                    let det = minor(&v, &w) * &u.2 + minor(&w, &u) * &v.2 + minor(&u, &v) * &w.2;
                    det.cmp0() == turn.reverse()
                };
                let mut others = (0..n).filter(|q| ![a, b, c].contains(q));
                if turn.is_ne() && others.all(is_outside) {
                    cells.push([id(a), id(b), id(c)]);
                }
            }
        }
    }
    cells.sort_unstable();
    cells.concat()
}

#[test]
fn crossings_are_triangulated_as_by_rationals() {
    let mut count = 0;
    for seed in 0..40 {
        let kernel = crossings(&mut Rng::named("crossings", seed));
        let points: Vec<[Rational; 2]> = (0..id(kernel.len()))
            .map(|v| {
                let point = kernel.exact(v);
                point.x.map(|x| rational(&x) / rational(&point.w))
            })
            .collect();
        let order: Vec<u32> = (0..id(kernel.len())).collect();
        let mesh = bowyer_watson(&kernel, &order, &mut ());
        if mesh.dimension() == Some(2) {
            let expected = by_definition(&points);
            assert_eq!(canonical(&mesh), expected, "seed {seed}");
            assert_eq!(naive_delaunay(&kernel, kernel.len()), expected, "seed {seed}");
            count += 1;
        }
    }
    assert!(count > 30, "{count}");
}
