//! The laws of domain trees: of what is inside a closed walk through a case's segments, or tetrahedra on a case's points.

use std::collections::BTreeSet;
use std::fmt::Debug;

use delone::cdt::{Domain, Fill, cdt_of_arrangement};
use delone::predicates::{Dyadic, Sign};
use delone::sites::Arrangement;
use delone::trees::{
    Cell, Colour, Joined, LeafRule, OrthTree, Quadrant, Raster, Rule, Shape, Solid, SonOrder,
};

use super::Law;
use crate::case::Case;

/// Every law of trees in the plane.
#[must_use]
pub fn quadtree_laws() -> Vec<Law<2>> {
    vec![
        Law { name: "area between", hold: |case| plane(case, |_, drawn| area_between(drawn)) },
        Law { name: "codes", hold: |case| plane(case, |trees, _| quadtree_codes(trees)) },
        Law { name: "algebra", hold: |case| plane(case, |trees, _| algebra(trees)) },
        Law { name: "components", hold: |case| plane(case, |trees, _| components(trees)) },
    ]
}

/// Every law of trees in space.
#[must_use]
pub fn octree_laws() -> Vec<Law<3>> {
    vec![
        Law { name: "volume between", hold: volume_between },
        Law { name: "codes", hold: |case| space(case, codes) },
        Law { name: "algebra", hold: |case| space(case, algebra) },
        Law { name: "components", hold: |case| space(case, components) },
    ]
}

const RULES: [Rule; 2] = [Rule::EvenOdd, Rule::NonZero];
const LEAVES: [LeafRule; 3] = [LeafRule::Inner, LeafRule::Centre, LeafRule::Outer];
/// Depths of trees.
const PLANE: u8 = 6;
const SPACE: u8 = 3;

/// A closed boundary in the plane.
#[derive(Clone, Copy, Debug)]
pub struct Drawn<'a> {
    /// Its points.
    pub points: &'a [[f64; 2]],
    /// Its segments.
    pub segments: &'a [[usize; 2]],
    /// What is inside.
    pub rule: Rule,
    /// The level of the smallest cells of its trees.
    pub depth: u8,
}

impl Drawn<'_> {
    /// The inner, the centre's and the outer tree, if doubles can hold their cells.
    #[must_use]
    pub fn trees(&self) -> Option<[OrthTree<2>; 3]> {
        let shape = Shape::new(self.points, self.segments, self.rule);
        let shape = shape.unwrap_or_else(|fault| panic!("the boundary is closed: {fault}"));
        let frame = shape.frame(self.depth).ok()?;
        Some(LEAVES.map(|leaves| shape.tree(&frame, leaves)))
    }
}

/// The trees of a drawing, of which every law was demanded.
#[must_use]
pub fn obeyed(drawn: &Drawn<'_>) -> Option<[OrthTree<2>; 3]> {
    let trees = drawn.trees()?;
    let times = [area_between(drawn), quadtree_codes(&trees), algebra(&trees), components(&trees)];
    assert!(!times.contains(&0), "every law was tried");
    Some(trees)
}

/// Demands the laws of codes, sets and components of the inner, the centre's and the outer tree of a solid.
pub fn obey_in_space(trees: &[OrthTree<3>; 3]) {
    let times = [codes(trees), algebra(trees), components(trees)];
    assert!(!times.contains(&0), "every law was tried");
}

fn plane(case: &Case<2>, hold: impl Fn(&[OrthTree<2>; 3], &Drawn<'_>) -> usize) -> usize {
    // From segment to segment, and back to the first; without segments from point to point.
    let mut walk: Vec<usize> = case.segments.iter().flatten().map(|&v| v as usize).collect();
    if walk.is_empty() {
        walk = (0..case.points.len()).collect();
    }
    let next = walk.iter().cycle().skip(1);
    let segments: Vec<[usize; 2]> = walk.iter().zip(next).map(|(&a, &b)| [a, b]).collect();
    let mut times = 0;
    for rule in RULES {
        let drawn = Drawn { points: &case.points, segments: &segments, rule, depth: PLANE };
        times += drawn.trees().map_or(0, |trees| hold(&trees, &drawn));
    }
    times
}

/// The area inside is not less than that of the inner tree, nor more than that of the outer one.
fn area_between(drawn: &Drawn<'_>) -> usize {
    let shape = Shape::new(drawn.points, drawn.segments, drawn.rule).expect("it is closed");
    let (Ok(frame), Some([inner, _, outer])) = (shape.frame(drawn.depth), drawn.trees()) else {
        return 0;
    };
    let graph = Arrangement::new(drawn.points, drawn.segments).expect("points are finite");
    let cdt = cdt_of_arrangement(&graph, &mut ());
    let fill = match drawn.rule {
        Rule::EvenOdd => Fill::EvenOdd,
        Rule::NonZero => Fill::NonZero,
    };
    let domain = Domain::new(&cdt, &graph, &fill).expect("it is closed");
    let [over, under] = fraction(&domain.area().to_string());
    let r = Dyadic::from(frame.resolution());
    let scaled = |tree: &OrthTree<2>| &(&(&r * &r) * &under) * &cells(tree, drawn.depth);
    let brackets = scaled(&inner) <= over && over <= scaled(&outer);
    assert!(brackets, "{:?}: area {} of inner and outer", drawn.rule, domain.area());
    1
}

fn cells<const N: usize>(tree: &OrthTree<N>, depth: u8) -> Dyadic {
    let volume = tree.volume(depth).expect("no leaf is smaller");
    Dyadic::from(i64::try_from(volume).expect("trees are small"))
}

/// `p` or `p/q`.
fn fraction(text: &str) -> [Dyadic; 2] {
    let number = |digits: &str| {
        let ten = Dyadic::from(10);
        digits.bytes().fold(Dyadic::from(0), |sum, digit| {
            assert!(digit.is_ascii_digit(), "areas are not negative: {text}");
            &sum * &ten + Dyadic::from(i64::from(digit - b'0'))
        })
    };
    match text.split_once('/') {
        Some((over, under)) => [number(over), number(under)],
        None => [number(text), Dyadic::from(1)],
    }
}

fn same<T: PartialEq + Debug, E: Debug>(found: Result<T, E>, expected: &T, what: &str) {
    assert_eq!(found.as_ref().ok(), Some(expected), "{what}: {:?}", found.as_ref().err());
}

/// Every code leads back, and leaves are (2^N - 1) gray + 1.
fn codes<const N: usize>(trees: &[OrthTree<N>; 3]) -> usize {
    for tree in trees {
        let counts = tree.counts();
        assert_eq!(counts.leaves(), (OrthTree::<N>::ARITY - 1) * counts.gray + 1, "identity");
        let (bits, levels) = (tree.to_bits(), tree.to_level_bits());
        assert_eq!(bits.len(), counts.nodes() + counts.leaves(), "bits of a code");
        assert_eq!(levels.len(), bits.len(), "bits of a code");
        same(OrthTree::from_text(&tree.to_text()), tree, "text");
        same(OrthTree::from_bits(&bits), tree, "bits");
        same(OrthTree::from_level_bits(&levels), tree, "levels");
        same(OrthTree::from_linear(&tree.to_linear()), tree, "linear");
        let black: Vec<Cell<N>> = tree.black().collect();
        same(OrthTree::from_black(&black), tree, "black cells");
        let keys = black.iter().map(|cell| Cell::of_key(cell.level(), cell.key()));
        assert!(keys.zip(&black).all(|(again, cell)| again == Some(*cell)), "keys");
        let raster = tree.to_raster(tree.depth()).expect("the raster is small");
        assert_eq!(&OrthTree::from_raster(&raster), tree, "raster");
        let bin = delone::trees::BinTree::from(tree);
        assert_eq!(bin.counts().leaves(), bin.counts().gray + 1, "identity of bin-trees");
        same(OrthTree::try_from(&bin), tree, "bin-tree");
    }
    trees.len()
}

/// Codes of the plane as well.
fn quadtree_codes(trees: &[OrthTree<2>; 3]) -> usize {
    let clockwise = SonOrder::Clockwise(Quadrant::NorthWest);
    for tree in trees {
        for order in [clockwise, SonOrder::Hilbert, SonOrder::Morton] {
            same(OrthTree::from_text_in(order, &tree.to_text_in(order)), tree, "order of sons");
        }
        let raster = tree.to_raster(tree.depth()).expect("the raster is small");
        same(Raster::from_pbm(&raster.to_pbm()), &raster, "PBM");
    }
    codes(trees)
}

/// The laws of sets.
fn algebra<const N: usize>(trees: &[OrthTree<N>; 3]) -> usize {
    let [a, b, c] = trees;
    let (nothing, all) = (OrthTree::of(Colour::White), OrthTree::of(Colour::Black));
    assert_eq!(a.difference(b), nothing, "inner is in centre");
    assert_eq!(b.difference(c), nothing, "centre is in outer");
    // Three sets of which none holds another, unless they must.
    let rim = c.difference(a);
    let (b, c) = (&b.symmetric_difference(&rim), &b.complement());
    assert_eq!(a.union(b), b.union(a));
    assert_eq!(a.union(&b.intersection(c)), a.union(b).intersection(&a.union(c)), "distributes");
    assert_eq!(a.union(b).complement(), a.complement().intersection(&b.complement()), "De Morgan");
    assert_eq!(a.union(&a.intersection(b)), *a, "absorption");
    assert_eq!(a.symmetric_difference(b).symmetric_difference(b), *a, "twice is nothing");
    assert_eq!(b.union(&b.complement()), all);
    assert_eq!(b.intersection(&b.complement()), nothing);
    assert_eq!(b.complement().complement(), *b);
    1
}

/// Components are those of the raster, flooded.
fn components<const N: usize>(trees: &[OrthTree<N>; 3]) -> usize {
    for tree in trees {
        let depth = tree.depth();
        let raster = tree.to_raster(depth).expect("the raster is small");
        let black: BTreeSet<[u32; N]> = raster.black().collect();
        for joined in [Joined::ByFacets, Joined::AtCorners] {
            let count = tree.components(joined).count;
            assert_eq!(count, pieces(black.clone(), joined), "components {joined:?}");
        }
    }
    trees.len()
}

/// Flood fill.
fn pieces<const N: usize>(mut left: BTreeSet<[u32; N]>, joined: Joined) -> usize {
    let steps = joined.steps::<N>();
    let mut count = 0;
    while let Some(seed) = left.pop_first() {
        count += 1;
        let mut pending = vec![seed];
        while let Some(place) = pending.pop() {
            for step in &steps {
                let next = std::array::from_fn(|axis| {
                    place[axis].wrapping_add_signed(i32::from(step[axis]))
                });
                if left.remove(&next) {
                    pending.push(next);
                }
            }
        }
    }
    count
}

/// The faces of a tetrahedron, all seen from outside or all from inside.
const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];

/// The solid of tetrahedra on every four points in turn.
fn solid(points: &[[f64; 3]], rule: Rule) -> Solid {
    let first = (0..points.len() / 4).map(|i| 4 * i);
    let faces: Vec<[usize; 3]> =
        first.flat_map(|first| FACES.map(|face| face.map(|v| first + v))).collect();
    Solid::new(points, &faces, rule).unwrap_or_else(|fault| panic!("it is closed: {fault}"))
}

fn space(case: &Case<3>, hold: impl Fn(&[OrthTree<3>; 3]) -> usize) -> usize {
    let mut times = 0;
    for rule in RULES {
        let solid = solid(&case.points, rule);
        if let Ok(frame) = solid.frame(SPACE) {
            times += hold(&LEAVES.map(|leaves| solid.tree(&frame, leaves)));
        }
    }
    times
}

/// The volume of each tetrahedron is not less than that of the inner tree, nor more than that of the outer one.
fn volume_between(case: &Case<3>) -> usize {
    let mut times = 0;
    for corners in case.points.as_chunks::<4>().0 {
        let solid = solid(corners, Rule::EvenOdd);
        let Ok(frame) = solid.frame(SPACE) else { continue };
        let r = Dyadic::from(frame.resolution());
        let unit = &(&(&r * &r) * &r) * &Dyadic::from(6);
        let scaled = |leaves| &unit * &cells(&solid.tree(&frame, leaves), SPACE);
        let exact = six_volumes(corners);
        let brackets = scaled(LeafRule::Inner) <= exact && exact <= scaled(LeafRule::Outer);
        assert!(brackets, "volume of inner and outer");
        times += 1;
    }
    times
}

fn six_volumes(corners: &[[f64; 3]; 4]) -> Dyadic {
    let [a, b, c, d] = corners.map(|p| p.map(Dyadic::from));
    let from_a = |p: &[Dyadic; 3]| -> [Dyadic; 3] { std::array::from_fn(|i| p[i].clone() - &a[i]) };
    let [u, v, w] = [from_a(&b), from_a(&c), from_a(&d)];
    let mut sum = Dyadic::from(0);
    for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
        sum += &(&u[i] * &(&v[j] * &w[k] - &v[k] * &w[j]));
    }
    if sum.sign() == Sign::Negative { -sum } else { sum }
}
