use delone_predicates::{Dyadic, Sign, orient2d};
use proptest::prelude::*;

use super::edge::Edge;
use crate::{Cell, Colour, Frame, LeafRule, OrthTree, Rule, Shape, ShapeFault};

type Int = i128;
type Segment = [[f64; 2]; 2];

/// Scaled so that corners, centres, ε = 2^-16 and its square are integers, for small coordinates.
fn int(value: f64) -> Int {
    let scaled = value * 128.0;
    assert_eq!(scaled.fract(), 0.0);
    (scaled as Int) << 32
}

fn ints(point: [f64; 2]) -> [Int; 2] {
    point.map(int)
}

fn cross(a: [Int; 2], b: [Int; 2], c: [Int; 2]) -> Int {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// The winding number of a point moved by (ε, ε²): crossings of the ray to the right.
fn winding(segments: &[Segment], point: [f64; 2]) -> i64 {
    let moved = ints(point);
    let moved = [moved[0] + (1 << 16), moved[1] + 1];
    let crossing = |[a, b]: &Segment| {
        let (a, b) = (ints(*a), ints(*b));
        let side = cross(a, b, moved);
        assert!(side != 0 || a == b, "the moved point is on no segment");
        match (a[1] <= moved[1], b[1] <= moved[1]) {
            (true, false) if side > 0 => 1,
            (false, true) if side < 0 => -1,
            _ => 0,
        }
    };
    segments.iter().map(crossing).sum()
}

/// Whether a + t (b - a) is in the open box for a t of [0, 1].
fn meets([a, b]: Segment, lower: [f64; 2], upper: [f64; 2]) -> bool {
    let (mut above, mut below) = (Vec::new(), Vec::new()); // bounds of t, as fractions
    for axis in 0..2 {
        let [a, b, lower, upper] =
            [a[axis], b[axis], lower[axis], upper[axis]].map(|c| int(c) >> 32);
        if a == b && (a <= lower || a >= upper) {
            return false;
        }
        if a < b {
            above.push((lower - a, b - a));
            below.push((upper - a, b - a));
        } else if a > b {
            above.push((a - upper, a - b));
            below.push((a - lower, a - b));
        }
    }
    let less = |p: &(Int, Int), q: &(Int, Int)| p.0 * q.1 < q.0 * p.1;
    above.iter().all(|p| less(p, &(1, 1)) && below.iter().all(|q| less(p, q)))
        && below.iter().all(|q| less(&(0, 1), q))
}

fn expected(
    segments: &[Segment],
    rule: Rule,
    frame: &Frame<2>,
    leaves: LeafRule,
    cell: Cell<2>,
) -> bool {
    let inside = |point| match rule {
        Rule::EvenOdd => winding(segments, point) % 2 != 0,
        Rule::NonZero => winding(segments, point) != 0,
    };
    let [lower, upper] = frame.corners(cell);
    if !segments.iter().any(|&s| meets(s, lower, upper)) {
        return inside(lower);
    }
    match leaves {
        LeafRule::Inner => false,
        LeafRule::Outer => true,
        LeafRule::Centre => inside(frame.centre(cell)),
    }
}

/// Segments left after those that are there twice, or there and back, have cancelled.
fn kept(shape: &Shape) -> Vec<Segment> {
    let copies = |edge: &Edge| {
        let [a, b] = edge.ends;
        let ends = if edge.weight > 0 { [a, b] } else { [b, a] };
        vec![ends; usize::try_from(edge.weight.abs()).unwrap()]
    };
    shape.edges.iter().flat_map(copies).collect()
}

const LEAVES: [LeafRule; 3] = [LeafRule::Inner, LeafRule::Centre, LeafRule::Outer];

proptest! {
    /// Closed walks over a small lattice: they cross, overlap, turn back and pass through corners and centres of cells.
    #[test]
    fn trees_are_as_defined(
        walks in prop::collection::vec(prop::collection::vec([0i8..9, 0i8..9], 1..7), 0..3),
        depth in 0u8..5, odd in any::<bool>(),
    ) {
        let rule = if odd { Rule::EvenOdd } else { Rule::NonZero };
        let (points, segments) = closed(&walks);
        let shape = Shape::new(&points, &segments, rule).unwrap();
        let frame = shape.frame(depth).unwrap();
        let all: Vec<Segment> = segments.iter().map(|ends| ends.map(|i| points[i])).collect();
        let kept = kept(&shape);
        let side = 1u32 << depth;
        for leaves in LEAVES {
            let raster = shape.tree(&frame, leaves).to_raster(depth).unwrap();
            for (at, &black) in raster.cells().iter().enumerate() {
                let at = u32::try_from(at).unwrap();
                let cell = Cell::new([at % side, at / side], depth).unwrap();
                prop_assert_eq!(black, expected(&kept, rule, &frame, leaves, cell));
                let [lower, _] = frame.corners(cell);
                let parity = |segments: &[Segment]| winding(segments, lower).rem_euclid(2);
                prop_assert_eq!(parity(&all), parity(&kept));
            }
        }
    }

    /// Axis-parallel walks on half the lattice of smallest cells: a cell's share is that of its parts, and these have no boundary
    /// in their interior.
    #[test]
    fn areas_decide_as_sums_over_small_cells_do(
        walks in prop::collection::vec(prop::collection::vec([0i8..9, 0i8..9], 1..7), 1..3),
        odd in any::<bool>(),
    ) {
        let rule = if odd { Rule::EvenOdd } else { Rule::NonZero };
        // From point to point first along x, then along y.
        let bent: Vec<Vec<[i8; 2]>> = walks.iter().map(|walk| {
            let next = |i: usize| walk[(i + 1) % walk.len()];
            (0..walk.len()).flat_map(|i| [walk[i], [next(i)[0], walk[i][1]]]).collect()
        }).collect();
        let (points, segments) = closed(&bent);
        let shape = Shape::new(&points, &segments, rule).unwrap();
        let around = [[0.0, 0.0], [16.0, 16.0]];
        let (coarse, fine) = (Frame::around(&around, 2).unwrap(), Frame::around(&around, 4).unwrap());
        let fine = shape.tree(&fine, LeafRule::Inner).to_raster(4).unwrap();
        let raster = shape.tree_by_area(&coarse).to_raster(2).unwrap();
        for (at, &black) in raster.cells().iter().enumerate() {
            let (x, y) = (at % 4 * 4, at / 4 * 4);
            let parts = (0..16).filter(|part| fine.cells()[(y + part / 4) * 16 + x + part % 4]);
            prop_assert_eq!(black, parts.count() >= 8, "{} {}", x, y);
        }
    }

    /// Any walks: a cell's share is between those of the inner and of the outer tree of much smaller cells.
    #[test]
    fn areas_are_between_those_of_fine_trees(
        walks in prop::collection::vec(prop::collection::vec([0i8..17, 0i8..17], 1..7), 1..3),
        odd in any::<bool>(),
    ) {
        let rule = if odd { Rule::EvenOdd } else { Rule::NonZero };
        let (points, segments) = closed(&walks);
        let shape = Shape::new(&points, &segments, rule).unwrap();
        let around = [[0.0, 0.0], [16.0, 16.0]];
        let (coarse, fine) = (Frame::around(&around, 2).unwrap(), Frame::around(&around, 7).unwrap());
        let [inner, outer] =
            [LeafRule::Inner, LeafRule::Outer].map(|leaves| shape.tree(&fine, leaves).to_raster(7).unwrap());
        let raster = shape.tree_by_area(&coarse).to_raster(2).unwrap();
        for (at, &black) in raster.cells().iter().enumerate() {
            let (x, y) = (at % 4 * 32, at / 4 * 32);
            let parts = |raster: &crate::Raster<2>| {
                (0..1024).filter(|part| raster.cells()[(y + part / 32) * 128 + x + part % 32]).count()
            };
            let (least, most) = (parts(&inner), parts(&outer));
            prop_assert!(least < 512 || black, "{} {}: at least {} of 1024", x, y, least);
            prop_assert!(most >= 512 || !black, "{} {}: at most {} of 1024", x, y, most);
        }
    }

    #[test]
    fn inner_is_in_centre_is_in_outer(seed in any::<u64>(), depth in 0u8..8) {
        let shape = coast(200, seed);
        let frame = shape.frame(depth).unwrap();
        let [inner, centre, outer] = LEAVES.map(|leaves| shape.tree(&frame, leaves));
        let nothing = OrthTree::of(Colour::White);
        prop_assert_eq!(inner.difference(&centre), nothing.clone());
        prop_assert_eq!(centre.difference(&outer), nothing);
    }
}

fn closed(walks: &[Vec<[i8; 2]>]) -> (Vec<[f64; 2]>, Vec<[usize; 2]>) {
    let (mut points, mut segments) = (Vec::new(), Vec::new());
    for walk in walks {
        let first = points.len();
        points.extend(walk.iter().map(|p| p.map(f64::from)));
        segments.extend((0..walk.len()).map(|i| [first + i, first + (i + 1) % walk.len()]));
    }
    (points, segments)
}

type Polygon = (Vec<[f64; 2]>, Vec<[usize; 2]>);

fn polygon(name: &str, n: usize, seed: u64) -> Polygon {
    let input = delone_workloads::generate(name, n, seed).unwrap();
    let segments = input.segments.iter().map(|ends| ends.map(|end| end as usize)).collect();
    (input.points.plane().unwrap().to_vec(), segments)
}

fn coast(n: usize, seed: u64) -> Shape {
    let (points, segments) = polygon("coast", n, seed);
    Shape::new(&points, &segments, Rule::EvenOdd).unwrap()
}

/// The rings of disjoint polygons, as points.
fn rings((points, segments): &Polygon) -> Vec<Vec<[f64; 2]>> {
    let mut at: Vec<Vec<usize>> = vec![Vec::new(); points.len()];
    for &[a, b] in segments {
        at[a].push(b);
        at[b].push(a);
    }
    let mut rings = Vec::new();
    for first in 0..points.len() {
        let (mut ring, mut vertex) = (Vec::new(), first);
        while let Some(next) = at[vertex].pop() {
            at[next].retain(|&end| end != vertex);
            ring.push(points[vertex]);
            vertex = next;
        }
        rings.push(ring);
    }
    rings.retain(|ring| !ring.is_empty());
    rings
}

fn edges(ring: &[[f64; 2]]) -> impl Iterator<Item = Segment> {
    (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]])
}

fn is_in(ring: &[[f64; 2]], p: [f64; 2]) -> bool {
    let crossed = edges(ring).filter(|[a, b]| {
        let up = a[1] <= p[1];
        up != (b[1] <= p[1]) && (orient2d(*a, *b, p) == Sign::Positive) == up
    });
    crossed.count() % 2 == 1
}

/// Twice the area inside disjoint rings: added where an even number of others is around, else subtracted.
fn twice_the_area(polygon: &Polygon) -> Dyadic {
    let rings = rings(polygon);
    let mut all = Dyadic::from(0);
    for (i, ring) in rings.iter().enumerate() {
        let mut sum = Dyadic::from(0);
        for [a, b] in edges(ring).map(|ends| ends.map(|p| p.map(Dyadic::from))) {
            sum += &(&a[0] * &b[1]);
            sum -= &(&a[1] * &b[0]);
        }
        let around = rings.iter().enumerate().filter(|(j, other)| i != *j && is_in(other, ring[0]));
        let even = around.count().is_multiple_of(2);
        all += &(if (sum > Dyadic::from(0)) == even { sum } else { -sum });
    }
    all
}

#[test]
fn areas_bracket_the_exact_area() {
    for name in
        ["coast", "coast-tiny", "coast-huge", "star-polygon", "koch", "spiral-polygon", "comb"]
    {
        let polygon = polygon(name, 300, 3);
        let exact = twice_the_area(&polygon);
        assert!(exact > Dyadic::from(0), "{name}");
        let shape = Shape::new(&polygon.0, &polygon.1, Rule::EvenOdd).unwrap();
        let mut last: Option<[Dyadic; 2]> = None;
        for depth in 0..9 {
            let frame = shape.frame(depth).unwrap();
            let resolution = Dyadic::from(frame.resolution());
            let unit = &(&resolution * &resolution) * &Dyadic::from(2);
            let area = |leaves| {
                let cells = shape.tree(&frame, leaves).volume(depth).unwrap();
                &unit * &Dyadic::from(i64::try_from(cells).unwrap())
            };
            let [inner, outer] = [area(LeafRule::Inner), area(LeafRule::Outer)];
            assert!(inner <= exact && exact <= outer, "{name} at depth {depth}");
            last = Some([inner, outer]);
        }
        let [inner, outer] = last.unwrap();
        assert!(inner < outer, "{name} has slanting sides, or not of this lattice");
    }
}

#[test]
fn leaves_grow_with_the_perimeter() {
    let shape = coast(64, 1);
    let leaves = |depth| {
        let frame = shape.frame(depth).unwrap();
        shape.tree(&frame, LeafRule::Centre).counts().leaves() as f64
    };
    // Twice for each level, not four times.
    let ratio = leaves(10) / leaves(8);
    assert!((3.0..5.0).contains(&ratio), "four times in two levels, but {ratio}");
}

#[test]
fn cells_that_are_only_touched_are_not_cut() {
    // A square that is the frame, and one whose corner touches a cell's corner.
    let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let ring = [[0, 1], [1, 2], [2, 3], [3, 0]];
    let shape = Shape::new(&square, &ring, Rule::NonZero).unwrap();
    let frame = shape.frame(5).unwrap();
    for leaves in LEAVES {
        assert_eq!(shape.tree(&frame, leaves), OrthTree::of(Colour::Black));
    }
    let diamond = [[2.0, 0.0], [4.0, 2.0], [2.0, 4.0], [0.0, 2.0]];
    let shape = Shape::new(&diamond, &ring, Rule::NonZero).unwrap();
    let inner = shape.tree(&shape.frame(2).unwrap(), LeafRule::Inner);
    assert_eq!(inner.to_text(), "((WWWB(WWBW(WBWW(BWWW");
}

#[test]
fn half_a_cell_is_enough() {
    // Of the unit square: half by a diagonal, by two crossing segments, by a vertical one; and a little less.
    let black = |ring: &[[f64; 2]]| {
        let segments: Vec<[usize; 2]> =
            (0..ring.len()).map(|i| [i, (i + 1) % ring.len()]).collect();
        let shape = Shape::new(ring, &segments, Rule::EvenOdd).unwrap();
        let frame = Frame::around(&[[0.0, 0.0], [1.0, 1.0]], 0).unwrap();
        shape.tree_by_area(&frame) == OrthTree::of(Colour::Black)
    };
    let less = 0.5f64.next_down();
    assert!(black(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]));
    assert!(black(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]), "two triangles");
    assert!(black(&[[0.5, 0.0], [1.0, 0.0], [1.0, 1.0], [0.5, 1.0]]));
    assert!(!black(&[[0.0, 0.0], [less, 0.0], [less, 1.0], [0.0, 1.0]]));
    assert!(!black(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0f64.next_down()]]));
}

#[test]
fn nothing_is_white() {
    let shape = Shape::new(&[], &[], Rule::EvenOdd).unwrap();
    let frame = shape.frame(6).unwrap();
    assert_eq!(shape.tree(&frame, LeafRule::Outer), OrthTree::of(Colour::White));
}

#[test]
fn open_boundaries_are_refused() {
    let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [-0.0, 0.0]];
    let open = |segments: &[[usize; 2]], rule| Shape::new(&points, segments, rule).unwrap_err();
    assert_eq!(
        open(&[[0, 1], [1, 2]], Rule::EvenOdd),
        ShapeFault::Open(vec![[0.0, 0.0], [0.0, 1.0]])
    );
    assert!(Shape::new(&points, &[[0, 1], [2, 1], [2, 3]], Rule::EvenOdd).is_ok());
    let turned = open(&[[0, 1], [2, 1], [2, 3]], Rule::NonZero);
    assert_eq!(turned, ShapeFault::Open(vec![[0.0, 1.0], [1.0, 0.0]]));
    assert_eq!(open(&[[0, 9], [1, 2]], Rule::EvenOdd), ShapeFault::NoSuchPoint(vec![0]));
    let strange = Shape::new(&[[0.0, f64::NAN]], &[], Rule::EvenOdd).unwrap_err();
    assert_eq!(strange, ShapeFault::NotFinite(vec![0]));
}
