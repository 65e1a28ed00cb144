//! Domain trees of the corpus: areas, codes, set algebra, components; and scipy's components.

mod files;

use delone::check::{Complex, Options, judge_delaunay};
use delone::trees::{Joined, LeafRule, OrthTree, Raster, Rule, Shape, Solid};
use delone::workloads::Rng;
use delone_tests::case::Case;
use delone_tests::corpus::{Size, graphs, space};
use delone_tests::laws::trees::{Drawn, obeyed};
use delone_tests::laws::{Law, octree_laws, quadtree_laws};
use delone_tests::say;
use delone_tests::scipy::Labels;

fn hold_all<const D: usize>(laws: &[Law<D>], cases: &[Case<D>]) {
    for law in laws {
        let count: usize = cases.iter().map(|case| (law.hold)(case)).sum();
        say(format!("{}: {count} times on {} inputs", law.name, cases.len()));
        assert!(count > cases.len(), "{} is idle", law.name);
    }
}

#[test]
fn quadtrees_of_small_graphs() {
    hold_all(&quadtree_laws(), &graphs(Size::Small));
}

#[test]
fn octrees_of_small_point_sets() {
    hold_all(&octree_laws(), &space(Size::Small));
}

/// The workloads that are closed are shapes as they are.
#[test]
fn quadtrees_of_shapes() {
    let mut shapes = 0;
    for case in graphs(Size::Middle) {
        let segments: Vec<[usize; 2]> =
            case.segments.iter().map(|ends| ends.map(|v| v as usize)).collect();
        let drawn =
            Drawn { points: &case.points, segments: &segments, rule: Rule::EvenOdd, depth: 7 };
        if segments.is_empty() || !is_closed(&drawn) {
            continue;
        }
        shapes += usize::from(obeyed(&drawn).is_some());
    }
    say(format!("{shapes} shapes"));
    assert!(shapes >= 8, "workloads of closed shapes are there");
}

fn is_closed(drawn: &Drawn<'_>) -> bool {
    Shape::new(drawn.points, drawn.segments, drawn.rule).is_ok()
}

/// Noise of two sizes, from sparse to dense.
fn noise<const N: usize>(depth: u8, rng: &mut Rng) -> OrthTree<N> {
    let (seed, share) = (rng.next_u64(), rng.below(100));
    let coarse = rng.below(2);
    let raster = Raster::new(depth, |place: [u32; N]| {
        let mixed = place
            .iter()
            .fold(seed, |mixed, &c| Rng::new(mixed ^ u64::from(c >> coarse)).next_u64());
        mixed % 100 < share
    });
    OrthTree::from_raster(&raster.expect("the raster is small"))
}

#[test]
fn components_are_those_of_scipy() {
    let mut labels = Labels::default();
    let mut rng = Rng::named("components", 1);
    let mut add = |name: &str, labels: &mut Labels| {
        let (plane, space) = (noise::<2>(5, &mut rng), noise::<3>(3, &mut rng));
        for joined in [Joined::ByFacets, Joined::AtCorners] {
            labels.add(name, &plane, joined);
            labels.add(name, &space, joined);
        }
    };
    for k in 0..100 {
        add(&format!("noise {k}"), &mut labels);
    }
    for case in graphs(Size::Middle) {
        let segments: Vec<[usize; 2]> =
            case.segments.iter().map(|ends| ends.map(|v| v as usize)).collect();
        let drawn =
            Drawn { points: &case.points, segments: &segments, rule: Rule::EvenOdd, depth: 7 };
        if !is_closed(&drawn) {
            continue;
        }
        for tree in drawn.trees().into_iter().flatten() {
            labels.add(&case.name, &tree, Joined::ByFacets);
            labels.add(&case.name, &tree, Joined::AtCorners);
        }
    }
    if let Some(count) = labels.compare() {
        say(format!("{count} labellings are scipy's"));
    }
}

/// A solid's three trees.
fn solid_trees(solid: &Solid, depth: u8) -> Option<[OrthTree<3>; 3]> {
    let frame = solid.frame(depth).ok()?;
    let leaves = [LeafRule::Inner, LeafRule::Centre, LeafRule::Outer];
    Some(leaves.map(|rule| solid.tree(&frame, rule)))
}

/// The judge proves what templates make: a Delaunay triangulation, ties broken somehow.
#[test]
fn balanced_quadtrees_are_delaunay_triangulations() {
    for (name, depth) in [("coast", 7), ("comb", 6), ("star-polygon", 6)] {
        let input = delone::workloads::generate(name, 120, 7).expect("there is such a workload");
        let points = input.points.plane().expect("it is of the plane").to_vec();
        let segments: Vec<[usize; 2]> =
            input.segments.iter().map(|ends| ends.map(|v| v as usize)).collect();
        let shape = Shape::new(&points, &segments, Rule::EvenOdd).expect("it is closed");
        let frame = shape.frame(depth).expect("doubles hold it");
        for joined in [Joined::ByFacets, Joined::AtCorners] {
            let leaves = shape.tree(&frame, LeafRule::Outer).leaves().balanced(joined);
            let mesh = leaves.triangles(&frame).expect("it is balanced");
            let complex = Complex {
                points: &mesh.points,
                dimension: Some(2),
                cells: mesh.triangles.as_flattened(),
            };
            let verdict = judge_delaunay(&complex, &Options::foreign());
            assert!(verdict.ok, "{name}: {verdict}");
            say(format!("{name}: {} triangles", mesh.triangles.len()));
        }
    }
}
