use delone_check::{Complex, judge_delaunay};
use delone_mesh::Level;
use delone_predicates::{Adaptive, Exact};
use delone_probe::Counts;
use delone_sites::{Sites, scatter};
use delone_workloads::{Kind, Points, all, generate};

use super::*;
use crate::{bowyer_watson, naive_delaunay};

mod vertical;

fn canonical(mesh: &Mesh<2>) -> Vec<u32> {
    mesh.canonical(|vertex| u32::try_from(vertex.index()).unwrap())
}

/// Divide and conquer of some sites: a sphere, and what the incremental construction gives.
fn check_sites(sites: &Sites<2>) -> Mesh<2> {
    let kernel = Adaptive::new(sites.points());
    let mesh = divide_conquer(&kernel, sites, &mut ());
    let n = sites.len();
    let level = if n > 300 { Level::Twins } else { Level::Sphere };
    assert_eq!(mesh.faults(level, n), [], "{:?}", sites.points());
    let incremental = bowyer_watson(&kernel, sites.brio_order(1), &mut ());
    assert_eq!(mesh.dimension(), incremental.dimension());
    assert!(canonical(&mesh) == canonical(&incremental), "{:?}", sites.points());
    assert_eq!(mesh.cell_count(), incremental.cell_count());
    mesh
}

fn check(points: &[[f64; 2]]) -> Mesh<2> {
    check_sites(&Sites::new(points).unwrap())
}

/// And what the definition gives.
fn check_few(points: &[[f64; 2]]) {
    let mesh = check(points);
    if mesh.dimension() == Some(2) {
        let sites = Sites::new(points).unwrap();
        let kernel = Exact::new(sites.points());
        assert_eq!(canonical(&mesh), naive_delaunay(&kernel, sites.len()), "{points:?}");
        assert_eq!(divide_conquer(&kernel, &sites, &mut ()), mesh);
    }
}

/// A number below `below` that is a hash of others.
fn dice(seed: u64, i: u64, below: u64) -> f64 {
    let small = u32::try_from(scatter(seed << 32 ^ i) % below).unwrap();
    f64::from(small)
}

#[test]
fn a_dozen_sites_and_fewer() {
    for n in 0..=12u64 {
        for seed in 0..40 {
            let below = 2 + seed % 6;
            let points: Vec<[f64; 2]> =
                (0..n).map(|i| [dice(seed, 2 * i, below), dice(seed, 2 * i + 1, below)]).collect();
            check_few(&points);
        }
    }
}

#[test]
fn every_subset_of_small_grids() {
    for (columns, rows) in [(3u32, 3u32), (4, 3), (3, 4)] {
        for mask in 0u32..1 << (columns * rows) {
            let places = (0..columns * rows).filter(|i| mask >> i & 1 == 1);
            let points: Vec<[f64; 2]> =
                places.map(|i| [f64::from(i / rows), f64::from(i % rows)]).collect();
            if columns + rows == 6 { check_few(&points) } else { drop(check(&points)) }
        }
    }
}

#[test]
fn collinear_sites_are_a_chain() {
    for n in 2..40u32 {
        for [dx, dy] in [[1.0, 0.0], [0.0, 1.0], [1.0, 3.0], [-2.0, 1.0], [5e-324, 5e-324]] {
            let points: Vec<[f64; 2]> =
                (0..n).map(|i| f64::from(i * 29 % 41)).map(|t| [t * dx, t * dy]).collect();
            let mesh = check(&points);
            assert_eq!((mesh.dimension(), mesh.cell_count()), (Some(1), n as usize + 1));
        }
    }
}

#[test]
fn parallel_lines_and_ladders() {
    for n in 2..30u32 {
        for gap in [1.0, 0.25, 1e-300, 1e10] {
            let ladder = (0..2 * n).map(|i| [f64::from(i / 2), f64::from(i % 2) * gap]);
            check(&ladder.clone().collect::<Vec<_>>());
            check(&ladder.clone().map(|[x, y]| [y, x]).collect::<Vec<_>>());
            check(&ladder.map(|[x, y]| [x + y, x - y]).collect::<Vec<_>>());
            // A line and one site, beside it, above its end, on its extension.
            for off in [[0.5, gap], [f64::from(n), gap], [0.0, gap], [f64::from(n) + 5.0, 0.0]] {
                let line = (0..n).map(|i| [f64::from(i), 0.0]).chain([off]);
                check(&line.clone().collect::<Vec<_>>());
                check(&line.map(|[x, y]| [y, x]).collect::<Vec<_>>());
            }
        }
    }
}

#[test]
fn cocircular_sites_agree() {
    // The 36 lattice points on the circle of radius 65, and parts of them.
    let on_circle: Vec<[f64; 2]> = (-65i32..=65)
        .flat_map(|x| (-65i32..=65).map(move |y| (x, y)))
        .filter(|(x, y)| x * x + y * y == 65 * 65)
        .map(|(x, y)| [f64::from(x), f64::from(y)])
        .collect();
    assert_eq!(on_circle.len(), 36);
    for seed in 0..100 {
        let some: Vec<[f64; 2]> = (0u64..)
            .zip(&on_circle)
            .filter(|&(i, _)| seed == 0 || dice(seed, i, 3) > 0.0)
            .map(|(_, &point)| point)
            .collect();
        check(&some);
        check(&some.iter().copied().chain([[0.0, 0.0]]).collect::<Vec<_>>());
    }
}

#[test]
fn random_small_integers_agree() {
    for seed in 0..600u64 {
        let below = [2, 3, 4, 5, 8, 20, 1000][usize::try_from(seed % 7).unwrap()];
        let other = [1, 2, below][usize::try_from(seed / 7 % 3).unwrap()];
        let n = 13 + scatter(seed) % 80;
        let points = (0..n).map(|i| [dice(seed, 2 * i, below), dice(seed, 2 * i + 1, other)]);
        check(&points.collect::<Vec<_>>());
    }
}

#[test]
fn jittered_lattices_and_wide_exponents_agree() {
    for seed in 0..30u64 {
        let jitter = |value: f64, i: u64| {
            let ulps = scatter(seed << 32 ^ i) % 3;
            f64::from_bits(value.to_bits() + ulps)
        };
        let lattice: Vec<[f64; 2]> = (0..64u32)
            .map(|i| [f64::from(1 + i / 8), f64::from(1 + i % 8)])
            .zip(0u64..)
            .map(|([x, y], i)| [jitter(x, 2 * i), jitter(y, 2 * i + 1)])
            .collect();
        check(&lattice);
        let wide = |i: u64| {
            let exponent = i32::try_from(scatter(seed << 32 ^ i) % 400).unwrap() - 200;
            (dice(seed, i, 15) - 7.0) * 2f64.powi(exponent)
        };
        check(&(0..50).map(|i| [wide(2 * i), wide(2 * i + 1)]).collect::<Vec<_>>());
    }
}

fn planar(points: Points) -> Option<Vec<[f64; 2]>> {
    match points {
        Points::Plane(points) => Some(points),
        Points::Space(_) => None,
    }
}

#[test]
fn every_workload_agrees_and_is_judged() {
    for workload in all().iter().filter(|workload| workload.kind() == Kind::Points2d) {
        for n in [1, 2, 3, 5, 17, 100, 700] {
            let points = planar(workload.generate(n, 5).points).unwrap();
            let sites = Sites::new(&points).unwrap();
            let mesh = check_sites(&sites);
            let cells = canonical_oriented(&mesh);
            let complex =
                Complex { points: sites.points(), dimension: mesh.dimension(), cells: &cells };
            let verdict = judge_delaunay(&complex, &delone_check::Options::default());
            assert!(verdict.ok, "{} {n}: {verdict}", workload.name);
        }
    }
}

/// The solid cells as they stand in the mesh.
fn canonical_oriented(mesh: &Mesh<2>) -> Vec<u32> {
    let corners = mesh.solid_cells().flat_map(|cell| mesh.corners(cell));
    corners.map(|vertex| u32::try_from(vertex.index()).unwrap()).collect()
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    for name in
        ["uniform", "gauss", "clusters", "grid", "circle", "line-diagonal", "parallel-lines"]
    {
        let points = planar(generate(name, 70_000, 1).unwrap().points).unwrap();
        let sites = Sites::new(&points).unwrap();
        let kernel = Adaptive::new(sites.points());
        let alone = divide_conquer(&kernel, &sites, &mut ());
        for threads in [1, 2, 3, 8] {
            let threads = NonZeroUsize::new(threads).unwrap();
            let mesh = divide_conquer_in_parallel(&kernel, &sites, threads);
            assert!(mesh == alone, "{name} on {threads} threads");
        }
    }
}

#[test]
fn the_order_of_input_leaves_no_trace() {
    let points = planar(generate("clusters", 5_000, 1).unwrap().points).unwrap();
    let sites = Sites::new(&points).unwrap();
    let reversed = Sites::new(&points.iter().rev().copied().collect::<Vec<_>>()).unwrap();
    let by_rank = |sites: &Sites<2>| {
        let (kernel, ranks) = (Adaptive::new(sites.points()), sites.ranks());
        let mut mesh = divide_conquer(&kernel, sites, &mut ());
        mesh.relabel(|vertex| VertexId::new(ranks[vertex.index()] as usize));
        mesh
    };
    assert_eq!(by_rank(&sites), by_rank(&reversed));
}

#[test]
fn counts_stay_small() {
    let points = planar(generate("uniform", 20_000, 1).unwrap().points).unwrap();
    let sites = Sites::new(&points).unwrap();
    let mut counts = Counts::default();
    divide_conquer(&Adaptive::new(sites.points()), &sites, &mut counts);
    assert!(counts.in_spheres < 9 * 20_000, "{counts:?}");
    assert!(counts.orients < 8 * 20_000, "{counts:?}");
    assert!(counts.cells_made < 4 * 20_000, "{counts:?}");
}
