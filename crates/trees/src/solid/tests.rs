use delone_predicates::{Dyadic, Sign, orient2d, orient3d};
use proptest::prelude::*;

use crate::{Cell, Colour, Frame, LeafRule, OrthTree, Rule, Solid, SolidFault};

type Point = [f64; 3];
type Mesh = (Vec<Point>, Vec<[usize; 3]>);
/// Over a common positive denominator, which is last.
type Ratios = [i128; 4];

const LEAVES: [LeafRule; 3] = [LeafRule::Inner, LeafRule::Centre, LeafRule::Outer];

/// So that corners and centres of cells of the tests are integers.
fn ints(point: Point) -> Ratios {
    let scaled = point.map(|c| c * 64.0);
    assert!(scaled.iter().all(|c| c.fract() == 0.0 && c.abs() < 1e6));
    #[expect(clippy::cast_possible_truncation, reason = "whole and small")]
    let [x, y, z] = scaled.map(|c| c as i128);
    [x, y, z, 1]
}

fn reduced(point: Ratios) -> Ratios {
    let gcd = |mut a: i128, mut b: i128| {
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a.abs()
    };
    let common = point.into_iter().fold(0, gcd);
    point.map(|c| c / common)
}

/// The part of a convex polygon where sign * x_axis >= sign * bound.
fn clipped(polygon: &[Ratios], axis: usize, bound: i128, sign: i128) -> Vec<Ratios> {
    let over = |p: &Ratios| sign * (p[axis] - bound * p[3]);
    let mut kept = Vec::new();
    for (i, p) in polygon.iter().enumerate() {
        let q = &polygon[(i + 1) % polygon.len()];
        let (f, g) = (over(p), over(q));
        if f >= 0 {
            kept.push(*p);
        }
        if (f > 0 && g < 0) || (f < 0 && g > 0) {
            let mix: Ratios = std::array::from_fn(|k| f.abs() * q[k] + g.abs() * p[k]);
            kept.push(reduced(mix));
        }
    }
    kept
}

/// Whether the open box meets the triangle: what of it is in the closed box has, for each side, a corner off that side.
fn meets(triangle: [Point; 3], lower: Point, upper: Point) -> bool {
    let (lower, upper) = (ints(lower), ints(upper));
    let mut polygon = triangle.map(ints).to_vec();
    for axis in 0..3 {
        polygon = clipped(&polygon, axis, lower[axis], 1);
        polygon = clipped(&polygon, axis, upper[axis], -1);
    }
    let off = |axis: usize, bound: i128| polygon.iter().any(|p| p[axis] != bound * p[3]);
    (0..3).all(|axis| off(axis, lower[axis]) && off(axis, upper[axis]))
}

/// The winding number around a point moved by (ε, ε², ε³), ε = 2^-14: crossings of the ray upwards.
fn winding(triangles: &[[Point; 3]], point: Point) -> i64 {
    let e = [14, 28, 42].map(|bits| 0.5f64.powi(bits));
    let p: Point = std::array::from_fn(|axis| point[axis] + e[axis]);
    let flat = |q: Point| [q[0], q[1]];
    let crossing = |[a, b, c]: &[Point; 3]| {
        let around = [(a, b), (b, c), (c, a)].map(|(u, v)| orient2d(flat(*u), flat(*v), flat(p)));
        let faces = orient2d(flat(*a), flat(*b), flat(*c));
        if faces == Sign::Zero || around.iter().any(|&sign| sign != faces) {
            return 0;
        }
        let below = orient3d(*a, *b, *c, p) != faces;
        match (below, faces) {
            (false, _) => 0,
            (true, Sign::Positive) => 1,
            (true, _) => -1,
        }
    };
    triangles.iter().map(crossing).sum()
}

fn corners((points, triangles): &Mesh) -> Vec<[Point; 3]> {
    triangles.iter().map(|t| t.map(|v| points[v])).collect()
}

/// Tetrahedra with corners on a lattice, their faces from outside, or all of them from inside.
fn tetrahedra(given: &[[[i8; 3]; 4]]) -> Mesh {
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    for tetrahedron in given {
        let first = points.len();
        points.extend(tetrahedron.iter().map(|p| p.map(f64::from)));
        let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
        triangles.extend(faces.map(|face| face.map(|v: usize| first + v)));
    }
    (points, triangles)
}

proptest! {
    /// Tetrahedra that cross, touch, coincide and are flat, with corners on corners and centres of cells.
    #[test]
    fn solids_are_as_defined(
        given in prop::collection::vec(prop::array::uniform4(prop::array::uniform3(0i8..5)), 1..4),
        depth in 0u8..4, odd in any::<bool>(),
    ) {
        let rule = if odd { Rule::EvenOdd } else { Rule::NonZero };
        let mesh = tetrahedra(&given);
        let solid = Solid::new(&mesh.0, &mesh.1, rule).unwrap();
        let frame = solid.frame(depth).unwrap();
        let all = corners(&mesh);
        let kept: Vec<[Point; 3]> = solid.facets.iter().map(|facet| facet.corners()).collect();
        let trees = LEAVES.map(|leaves| solid.tree(&frame, leaves).to_raster(depth).unwrap());
        let side = 1u32 << depth;
        for at in 0..trees[0].cells().len() {
            let place = u32::try_from(at).unwrap();
            let anchor = [place % side, place / side % side, place / side / side];
            let cell = Cell::new(anchor, depth).unwrap();
            let [lower, upper] = frame.corners(cell);
            let met = kept.iter().any(|&triangle| meets(triangle, lower, upper));
            let inside = |p| rule.holds(winding(&all, p));
            let black = trees.each_ref().map(|raster| raster.cells()[at]);
            let expected = match met {
                true => [false, inside(frame.centre(cell)), true],
                false => [inside(lower); 3],
            };
            prop_assert_eq!(black, expected, "{:?}", cell);
        }
    }
}

/// An octahedron, its faces cut in four so many times, corners pushed out to about a sphere.
fn ball(cuts: usize) -> Mesh {
    let mut points: Vec<Point> = Vec::new();
    let mut triangles = Vec::new();
    for bits in 0..8usize {
        let sign = |axis: usize| if bits >> axis & 1 == 1 { 1.0 } else { -1.0 };
        let first = points.len();
        points.extend([[sign(0), 0.0, 0.0], [0.0, sign(1), 0.0], [0.0, 0.0, sign(2)]]);
        let turned = bits.count_ones() % 2 == 0;
        triangles.push([first, first + 1 + usize::from(turned), first + 2 - usize::from(turned)]);
    }
    for _ in 0..cuts {
        triangles = triangles
            .into_iter()
            .flat_map(|[a, b, c]| {
                let first = points.len();
                for (u, v) in [(a, b), (b, c), (c, a)] {
                    let sum: Point = std::array::from_fn(|axis| points[u][axis] + points[v][axis]);
                    let length = sum.iter().map(|c| c * c).sum::<f64>().sqrt();
                    points.push(sum.map(|c| c / length));
                }
                let [ab, bc, ca] = [first, first + 1, first + 2];
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    (points, triangles)
}

/// Six times the volume.
fn six_volumes(mesh: &Mesh) -> Dyadic {
    let mut sum = Dyadic::from(0);
    for [a, b, c] in corners(mesh).into_iter().map(|t| t.map(|p| p.map(Dyadic::from))) {
        for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
            sum += &(&a[i] * &(&b[j] * &c[k] - &b[k] * &c[j]));
        }
    }
    sum
}

#[test]
fn volumes_bracket_the_exact_volume() {
    let mesh = ball(2);
    let exact = six_volumes(&mesh);
    assert!(exact > Dyadic::from(20) && exact < Dyadic::from(26), "nearly 8 pi");
    let solid = Solid::new(&mesh.0, &mesh.1, Rule::NonZero).unwrap();
    for depth in 0..6 {
        let frame = solid.frame(depth).unwrap();
        let r = Dyadic::from(frame.resolution());
        let unit = &(&(&r * &r) * &r) * &Dyadic::from(6);
        let [inner, centre, outer] = LEAVES.map(|leaves| solid.tree(&frame, leaves));
        let volume = |tree: &OrthTree<3>| {
            &unit * &Dyadic::from(i64::try_from(tree.volume(depth).unwrap()).unwrap())
        };
        assert!(volume(&inner) <= exact && exact <= volume(&outer), "at depth {depth}");
        assert_eq!(inner.difference(&centre), OrthTree::of(Colour::White));
        assert_eq!(centre.difference(&outer), OrthTree::of(Colour::White));
        assert_eq!(outer.counts().leaves(), 7 * outer.counts().gray + 1);
    }
}

/// A box as six squares of two triangles each, from outside.
fn cuboid(lower: Point, upper: Point) -> Mesh {
    let point = |bits: usize| std::array::from_fn(|a| [lower, upper][bits >> a & 1][a]);
    let squares =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = squares.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    ((0..8).map(point).collect(), triangles)
}

#[test]
fn boxes_of_the_lattice_are_exact() {
    let mesh = cuboid([1.0, 2.0, 0.0], [3.0, 3.0, 4.0]);
    let solid = Solid::new(&mesh.0, &mesh.1, Rule::NonZero).unwrap();
    let frame = Frame::around(&[[0.0; 3], [4.0; 3]], 2).unwrap();
    let expected = crate::Raster::new(2, |[x, y, _]| (1..3).contains(&x) && y == 2).unwrap();
    for leaves in LEAVES {
        assert_eq!(solid.tree(&frame, leaves), OrthTree::from_raster(&expected));
    }
    // An octahedron's edges and corners touch cells that its faces do not meet.
    let points = [
        [2.0, 2.0, 0.0],
        [2.0, 2.0, 4.0],
        [0.0, 2.0, 2.0],
        [4.0, 2.0, 2.0],
        [2.0, 0.0, 2.0],
        [2.0, 4.0, 2.0],
    ];
    let faces =
        [[0, 2, 4], [0, 4, 3], [0, 3, 5], [0, 5, 2], [1, 4, 2], [1, 3, 4], [1, 5, 3], [1, 2, 5]];
    let octahedron = Solid::new(&points, &faces, Rule::EvenOdd).unwrap();
    let outer = octahedron.tree(&frame, LeafRule::Outer);
    // Of eight sons of each octant: one inside, three with a corner of the face and an edge in the plane x + y + z = 1, three
    // cut, one beyond. In units where the octant is 2 wide: min < 2 < max of x + y + z.
    let met = |i: u32, j: u32, k: u32| i + j + k < 2;
    let expected = crate::Raster::new(2, |p: [u32; 3]| {
        let [i, j, k] = p.map(|c| if c < 2 { 1 - c } else { c - 2 });
        met(i, j, k)
    });
    assert_eq!(outer, OrthTree::from_raster(&expected.unwrap()));
}

#[test]
fn open_surfaces_are_refused() {
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let three = [[0, 2, 1], [0, 1, 3], [1, 2, 3]];
    let open = Solid::new(&points, &three, Rule::EvenOdd).unwrap_err();
    let sides = vec![[points[0], points[2]], [points[0], points[3]], [points[3], points[2]]];
    let mut sorted = sides;
    sorted.sort_by(|a, b| a.partial_cmp(b).unwrap());
    assert_eq!(open, SolidFault::Open(sorted));
    assert!(open.to_string().contains("close it"));
    let turned = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 2, 3]];
    assert!(Solid::new(&points, &turned, Rule::EvenOdd).is_ok());
    assert!(matches!(Solid::new(&points, &turned, Rule::NonZero), Err(SolidFault::Open(_))));
    let nowhere = Solid::new(&points, &[[0, 1, 2], [0, 1, 4]], Rule::EvenOdd).unwrap_err();
    assert_eq!(nowhere, SolidFault::NoSuchPoint(vec![1]));
}
