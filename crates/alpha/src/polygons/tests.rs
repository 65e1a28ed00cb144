use delone_workloads::Rng;

use super::*;
use crate::AlphaParam;
use crate::testing::of;

fn doubled_area(points: &[[f64; 2]], ring: &[u32]) -> f64 {
    let at = |i: usize| points[ring[i % ring.len()] as usize];
    (0..ring.len()).map(|i| at(i)[0] * at(i + 1)[1] - at(i)[1] * at(i + 1)[0]).sum()
}

/// Areas of small integers, exact in doubles.
fn check(points: &[[f64; 2]]) -> usize {
    let filtration = of(points);
    let sites = delone_sites::Sites::new(points).unwrap();
    let points = sites.points();
    let betti = filtration.betti_curves();
    let mut holes = 0;
    for ranks in 0..=narrow(filtration.rank_count()) {
        let cut = Cut::new(ranks);
        let polygons = filtration.polygons(cut);
        let rings: Vec<&Vec<u32>> =
            polygons.regions.iter().flat_map(|r| r.holes.iter().chain([&r.outer])).collect();
        let triangles =
            filtration.simplices().of_dimension(2).filter(|&id| cut.holds(filtration.ranks()[id]));
        let area: f64 = triangles
            .map(|id| {
                doubled_area(points, filtration.simplices().vertices(SimplexId::new(id))).abs()
            })
            .sum();
        assert_eq!(rings.iter().map(|ring| doubled_area(points, ring)).sum::<f64>(), area);
        for region in &polygons.regions {
            assert!(doubled_area(points, &region.outer) > 0.0, "Inv 2");
            assert!(region.holes.iter().all(|hole| doubled_area(points, hole) < 0.0), "Inv 2");
            holes += region.holes.len();
        }
        // Inv 1
        let mut sides: Vec<[u32; 2]> = rings
            .iter()
            .flat_map(|ring| (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]))
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        sides.sort_unstable();
        let shape = filtration.shape(cut, crate::Mode::Regularized);
        let regular: Vec<[u32; 2]> = shape
            .iter()
            .map(|&edge| filtration.simplices().vertices(edge))
            .map(|ends| [ends[0], ends[1]])
            .collect();
        assert_eq!(sides, regular);
        // Regions, edges and vertices, joined where they share a vertex, are the components.
        let mut sets = Sets::new(points.len() + 1);
        let mut join = |a: u32, b: u32| {
            let (a, b) = (sets.find(a), sets.find(b));
            if a != b {
                sets.unite(a, b);
            }
        };
        polygons.edges.iter().for_each(|&[a, b]| join(a, b));
        for region in &polygons.regions {
            region
                .holes
                .iter()
                .chain([&region.outer])
                .flatten()
                .for_each(|&v| join(v, region.outer[0]));
        }
        let cells =
            filtration.simplices().of_dimension(2).filter(|&id| cut.holds(filtration.ranks()[id]));
        for id in cells {
            let vertices = filtration.simplices().vertices(SimplexId::new(id));
            vertices.iter().for_each(|&v| join(v, vertices[0]));
        }
        if ranks > 0 {
            let roots = (0..narrow(points.len())).filter(|&v| sets.find(v) == v).count();
            assert_eq!(roots, betti.at(cut)[0]);
        }
    }
    holes
}

#[test]
fn rings_bound_their_area() {
    let mut rng = Rng::new(6);
    let mut holes = 0;
    for side in [6, 12, 30] {
        for _ in 0..12 {
            let points: Vec<[f64; 2]> =
                (0..40).map(|_| [0; 2].map(|_| rng.below(side) as f64)).collect();
            holes += check(&points);
        }
    }
    assert!(holes > 10, "{holes}");
}

#[test]
fn wedges_that_touch_are_apart() {
    // Two triangles of a bow tie, the space between them wider than they are.
    let filtration = of(&[[0.0, 0.0], [-4.0, 1.0], [-4.0, -1.0], [4.0, 1.0], [4.0, -1.0]]);
    let cut = filtration.cut(AlphaParam::Radius(2.2)).unwrap();
    let polygons = filtration.polygons(cut);
    let outers: Vec<&[u32]> = polygons.regions.iter().map(|region| &region.outer[..]).collect();
    assert_eq!(outers, [&[0, 1, 2][..], &[0, 4, 3]]);
    assert!(polygons.edges.is_empty() && polygons.vertices.is_empty());
}

#[test]
fn what_bounds_nothing_is_listed() {
    let filtration = of(&[[0.0, 0.0], [1.0, 0.0], [9.0, 9.0]]);
    let cut = filtration.cut(AlphaParam::Radius(1.0)).unwrap();
    let polygons = filtration.polygons(cut);
    assert_eq!((polygons.edges, polygons.vertices), (vec![[0, 1]], vec![2]));
    assert_eq!(polygons.regions, []);
    let line = of(&[[0.0, 0.0], [1.0, 1.0], [9.0, 9.0]]);
    let cut = line.cut(AlphaParam::Radius(1.0)).unwrap();
    assert_eq!(line.polygons(cut).edges, [[0, 1]]);
    assert_eq!(line.polygons(cut).vertices, [2]);
    assert_eq!(of(&[[0.0, 1.0]]).polygons(Cut::new(1)).vertices, [0]);
    assert_eq!(of(&[]).polygons(Cut::new(0)), Polygons::default());
}

#[test]
fn lobes_of_a_hole_may_meet() {
    // A ring of a grid around two holes, up and down, that meet in the vertex on their left.
    let mut points: Vec<[f64; 2]> = Vec::new();
    for x in 0..9u8 {
        for y in 0..9u8 {
            let (x, y) = (f64::from(x), f64::from(y));
            let right = x - 2.0;
            let up = y - 4.0;
            let in_lobe = x > 2.0
                && x < 7.0
                && up.abs() > 0.25 * right
                && up.abs() < 3.0
                && up.abs() <= right;
            if !in_lobe {
                points.push([x, y]);
            }
        }
    }
    assert!(check(&points) > 0);
}

/// Whether a circle of this squared radius, a fraction, goes from a to b with its centre on the right, and no point is inside.
/// With e = b - a, n = e turned right, m the middle: the centre is m + s n with s^2 = r^2 / e^2 - 1 / 4, and a point m + q inside if
/// q^2 - e^2 / 4 < 2 s n q. Small integers: exact in doubles.
fn is_empty_on_the_right(
    points: &[[f64; 2]],
    [a, b]: [usize; 2],
    [above, below]: [f64; 2],
) -> bool {
    let dot = |u: [f64; 2], v: [f64; 2]| u[0] * v[0] + u[1] * v[1];
    let (p, q) = (points[a], points[b]);
    let e = [q[0] - p[0], q[1] - p[1]];
    let (n, length) = ([e[1], -e[0]], dot(e, e));
    // 16 s^2, times the radius's denominator and e^2.
    let s = 16.0 * above - 4.0 * below * length;
    let is_inside = |point: &[f64; 2]| {
        let twice = [0, 1].map(|axis| 2.0 * point[axis] - p[axis] - q[axis]);
        let (power, along) = (dot(twice, twice) - length, dot(n, twice));
        let (left, right) = (power * power * below * length, s * along * along);
        if along > 0.0 { power < 0.0 || left < right } else { power < 0.0 && left > right }
    };
    s >= 0.0 && !points.iter().any(is_inside)
}

#[test]
fn hull_arcs_are_those_of_the_definition() {
    let mut rng = Rng::new(11);
    let mut arcs = 0;
    for _ in 0..80 {
        let points: Vec<[f64; 2]> = (0..8).map(|_| [0; 2].map(|_| rng.below(5) as f64)).collect();
        let sites = delone_sites::Sites::new(&points).unwrap();
        let points = sites.points();
        let filtration = of(points);
        let values: Vec<[f64; 2]> = filtration
            .spectrum()
            .map(|value| [value.numerator().to_f64(), value.denominator().to_f64()])
            .collect();
        // Between two values no circle goes through three sites and is empty.
        for (cut, pair) in (1..).map(Cut::new).zip(values.windows(2)) {
            let [[a, b], [c, d]] = [pair[0], pair[1]];
            let middle = [a * d + c * b, 2.0 * b * d];
            let pairs = (0..points.len()).flat_map(|a| (0..points.len()).map(move |b| [a, b]));
            let expected: Vec<[u32; 2]> = pairs
                .filter(|&ends| ends[0] != ends[1] && is_empty_on_the_right(points, ends, middle))
                .map(|ends| ends.map(narrow))
                .collect();
            let mut ours = filtration.polygons(cut).hull_arcs();
            ours.sort_unstable();
            assert_eq!(ours, expected, "{points:?}, {middle:?}");
            arcs += ours.len();
        }
    }
    assert!(arcs > 3000, "{arcs}");
}
