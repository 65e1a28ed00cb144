use delone_mesh::Level;
use delone_predicates::{Adaptive, Exact};
use delone_probe::Counts;
use delone_sites::scatter;
use delone_workloads::{Kind, Points, all};

use super::*;
use crate::divide_conquer;

fn canonical(mesh: &Mesh<2>) -> Vec<u32> {
    mesh.canonical(|vertex| u32::try_from(vertex.index()).unwrap())
}

/// The sweep of some points: a sphere, and what divide and conquer gives.
fn check(points: &[[f64; 2]]) -> (Mesh<2>, Counts) {
    let sites = Sites::new(points).unwrap();
    let kernel = Adaptive::new(sites.points());
    let mut counts = Counts::default();
    let mesh = sweep(&kernel, &sites, &mut counts);
    let level = if sites.len() > 300 { Level::Twins } else { Level::Sphere };
    assert_eq!(mesh.faults(level, sites.len()), [], "{points:?}");
    let expected = divide_conquer(&kernel, &sites, &mut ());
    assert_eq!(mesh.dimension(), expected.dimension());
    assert!(canonical(&mesh) == canonical(&expected), "{points:?}");
    (mesh, counts)
}

/// And without filters the same, bit for bit.
fn check_exactly(points: &[[f64; 2]]) -> Counts {
    let (mesh, counts) = check(points);
    let sites = Sites::new(points).unwrap();
    assert_eq!(sweep(&Exact::new(sites.points()), &sites, &mut ()), mesh);
    counts
}

/// A number below `below` that is a hash of others.
fn dice(seed: u64, i: u64, below: u64) -> f64 {
    f64::from(u32::try_from(scatter(seed << 32 ^ i) % below).unwrap())
}

/// The lattice points on the circle of a radius about the origin.
fn on_circle(radius: i32) -> Vec<[f64; 2]> {
    let all = (-radius..=radius).flat_map(|x| (-radius..=radius).map(move |y| [x, y]));
    let on = all.filter(|[x, y]| x * x + y * y == radius * radius);
    on.map(|point| point.map(f64::from)).collect()
}

#[test]
fn every_subset_of_small_grids_is_swept() {
    for (columns, rows) in [(3u32, 3u32), (4, 3), (3, 4)] {
        for mask in 0u32..1 << (columns * rows) {
            let places = (0..columns * rows).filter(|i| mask >> i & 1 == 1);
            let points: Vec<[f64; 2]> =
                places.map(|i| [f64::from(i / rows), f64::from(i % rows)]).collect();
            check_exactly(&points);
        }
    }
}

#[test]
fn lines_are_chains() {
    for n in 0..30u32 {
        for [dx, dy] in [[1.0, 0.0], [0.0, 1.0], [1.0, 3.0], [-2.0, 1.0], [5e-324, 5e-324]] {
            let points: Vec<[f64; 2]> =
                (0..n).map(|i| f64::from(i * 29 % 41)).map(|t| [t * dx, t * dy]).collect();
            let (mesh, counts) = check(&points);
            assert_eq!(
                (mesh.dimension(), counts.circle_events),
                ([None, Some(0)].get(n as usize).copied().unwrap_or(Some(1)), 0)
            );
        }
    }
}

#[test]
fn a_site_where_two_arcs_meet_cuts_off_an_empty_arc() {
    // With the line at (5, 0) the arcs of (0, -5) and (0, 5) meet at the centre, at the height of the site; and so do those of
    // (-3, -4) and (0, 5), and of (0, -5) and (-3, 4).
    for [lower, upper] in
        [[[0.0, -5.0], [0.0, 5.0]], [[-3.0, -4.0], [0.0, 5.0]], [[0.0, -5.0], [-3.0, 4.0]]]
    {
        for beyond in [None, Some([6.0, -9.0]), Some([6.0, 0.0]), Some([5.0, 1.0])] {
            let points: Vec<[f64; 2]> =
                [lower, upper, [5.0, 0.0]].into_iter().chain(beyond).collect();
            let sites = Sites::new(&points).unwrap();
            let kernel = Adaptive::new(sites.points()).reordered(sites.sorted());
            let mut sweep = Sweep::start(&kernel, &[0, 1, 2]);
            let [site, first, second] = [2, 0, 1].map(VertexId::new);
            let is_first_lower = lower[0] <= upper[0];
            let (below, over) = if is_first_lower { (first, second) } else { (second, first) };
            assert!(!is_above(&kernel, site, below, over));
            sweep.site_event(VertexId::new(2), &mut ());
            let pending = sweep.queue.peek().unwrap();
            assert!(kernel.compare_event_with_site(&pending.event, VertexId::new(2)).is_eq());
            check_exactly(&points);
        }
    }
}

#[test]
fn cocircular_sites_are_swept() {
    for radius in [5, 25, 65] {
        let circle = on_circle(radius);
        for seed in 0..60 {
            let some: Vec<[f64; 2]> = (0u64..)
                .zip(&circle)
                .filter(|&(i, _)| seed == 0 || dice(seed, i, 3) > 0.0)
                .map(|(_, &point)| point)
                .collect();
            let counts = check_exactly(&some);
            assert!(some.len() < 3 || counts.cells_made == some.len() as u64 - 2);
            assert_eq!(counts.flips, 0, "Inv 5");
            // The centre, and a site on the line that touches the circle.
            let [r, height] = [f64::from(radius), dice(seed, 99, 9) - 4.0];
            check_exactly(&some.iter().copied().chain([[0.0, 0.0]]).collect::<Vec<_>>());
            check_exactly(&some.iter().copied().chain([[r, height], [r, 0.5]]).collect::<Vec<_>>());
        }
    }
}

#[test]
fn events_of_one_circle_come_in_the_order_of_the_perturbation() {
    for name in ["circle-exact", "grid", "grid-tilted-exact", "parallel-lines", "few-columns"] {
        let Points::Plane(points) = delone_workloads::generate(name, 900, 1).unwrap().points else {
            panic!("{name} is of the plane");
        };
        let (_, counts) = check(&points);
        assert_eq!(counts.flips, 0, "Inv 5 on {name}");
    }
}

#[test]
fn random_small_integers_are_swept() {
    for seed in 0..400u64 {
        let below = [2, 3, 4, 5, 8, 20, 1000][usize::try_from(seed % 7).unwrap()];
        let other = [1, 2, below][usize::try_from(seed / 7 % 3).unwrap()];
        let n = 3 + scatter(seed) % 60;
        let points = (0..n).map(|i| [dice(seed, 2 * i, below), dice(seed, 2 * i + 1, other)]);
        let points: Vec<[f64; 2]> = points.collect();
        check_exactly(&points);
        check_exactly(&points.iter().map(|&[x, y]| [-y, x]).collect::<Vec<_>>());
    }
}

#[test]
fn jittered_lattices_and_all_exponents_are_swept() {
    for seed in 0..24u64 {
        let jitter =
            |value: f64, i: u64| f64::from_bits(value.to_bits() + scatter(seed << 32 ^ i) % 3);
        let lattice: Vec<[f64; 2]> = (0..49u32)
            .map(|i| [f64::from(1 + i / 7), f64::from(1 + i % 7)])
            .zip(0u64..)
            .map(|([x, y], i)| [jitter(x, 2 * i), jitter(y, 2 * i + 1)])
            .collect();
        check_exactly(&lattice);
        let spread = [40u64, 400, 2000][usize::try_from(seed % 3).unwrap()];
        let wide = |i: u64| {
            let exponent = i32::try_from(scatter(seed << 32 ^ i) % spread).unwrap()
                - i32::try_from(spread / 2).unwrap();
            (dice(seed, i, 15) - 7.0) * 2f64.powi(exponent)
        };
        check_exactly(&(0..24).map(|i| [wide(2 * i), wide(2 * i + 1)]).collect::<Vec<_>>());
    }
}

#[test]
fn every_workload_is_swept() {
    for workload in all().iter().filter(|workload| workload.kind() == Kind::Points2d) {
        for n in [1, 2, 3, 5, 17, 100, 500] {
            let Points::Plane(points) = workload.generate(n, 5).points else { continue };
            check(&points);
        }
    }
}

#[test]
fn the_queue_holds_few_false_alarms() {
    let points: Vec<[f64; 2]> =
        (0..2000u64).map(|i| [dice(1, 2 * i, 1 << 30), dice(1, 2 * i + 1, 1 << 30)]).collect();
    let (mesh, counts) = check(&points);
    assert_eq!(counts.cells_made, mesh.solid_cells().count() as u64);
    assert_eq!((counts.sites, counts.flips), (1998, 0), "no ties, no flips");
    // Each site event asks for two, and each circle event for two: six a site, of which one in two turns the right way.
    assert!(
        (2.0..4.0).contains(&(counts.circle_events as f64 / 2000.0)),
        "{}",
        counts.circle_events
    );
    // The beach line of uniform sites has O(sqrt n) arcs.
    let steps = counts.walk_steps as f64 / 2000.0;
    assert!(steps < 2.5 * 2000f64.log2(), "{steps}");
}
