//! Laws of quadtrees: what is black is inside, every code leads back, sets are sets.

use delone::predicates::{Exact, Kernel, Sign};
use delone::trees::{BinTree, Frame, LeafRule, OrthTree, Rule, Shape, SonOrder};

use crate::case::Case;
use crate::laws::Law;

/// Of the polygon through a case's points, and of another through some of them.
pub(in crate::fuzz) fn of_trees() -> Vec<Law<2>> {
    vec![Law { name: "trees", hold: trees }]
}

/// The level of the smallest cells.
const DEPTH: u8 = 4;

fn trees(case: &Case<2>) -> usize {
    let [whole, part] =
        [case.points.len(), case.points.len().div_ceil(2)].map(|n| polygon(case, n));
    let Ok(frame) = whole.frame(DEPTH) else { return 0 };
    let rules = [LeafRule::Inner, LeafRule::Centre, LeafRule::Outer];
    let [inner, centre, outer] = rules.map(|rule| whole.tree(&frame, rule));
    assert!(
        inner.difference(&centre) == white() && centre.difference(&outer) == white(),
        "{}",
        case.name
    );
    centres(case, &frame, &centre);
    for tree in [&inner, &centre, &outer] {
        codes(case, tree);
        sets(case, tree, &part.tree(&frame, LeafRule::Centre));
    }
    rules.len()
}

fn polygon(case: &Case<2>, corners: usize) -> Shape {
    let sides: Vec<[usize; 2]> = (0..corners).map(|i| [i, (i + 1) % corners]).collect();
    Shape::new(&case.points, &sides, Rule::EvenOdd).expect("a polygon is closed")
}

fn white() -> OrthTree<2> {
    OrthTree::of(delone::trees::Colour::White)
}

/// Each cell is as a ray from its centre says, unless a side goes through that.
fn centres(case: &Case<2>, frame: &Frame<2>, tree: &OrthTree<2>) {
    let raster = tree.to_raster(DEPTH).expect("no leaf is smaller");
    let count = case.points.len();
    for (place, &is_black) in raster.cells().iter().enumerate() {
        let place = u32::try_from(place).expect("4^DEPTH cells");
        let anchor = [place & ((1 << DEPTH) - 1), place >> DEPTH];
        let cell = delone::trees::Cell::new(anchor, DEPTH).expect("a cell of the raster");
        let centre = frame.centre(cell);
        let kernel = Exact::new([&case.points[..], &[centre]].concat());
        let mut is_inside = false;
        let mut is_on = false;
        for (a, b) in (0..count).map(|i| (i, (i + 1) % count)) {
            let (p, q) = (case.points[a], case.points[b]);
            let sign = kernel.orient(&[a, b, count]);
            let between =
                (0..2).all(|i| p[i].min(q[i]) <= centre[i] && centre[i] <= p[i].max(q[i]));
            is_on |= sign == Sign::Zero && between;
            let is_up = q[1] > centre[1];
            let crosses = (p[1] > centre[1]) != is_up;
            is_inside ^= crosses && sign == if is_up { Sign::Positive } else { Sign::Negative };
        }
        assert!(is_on || is_black == is_inside, "{}: the cell at {anchor:?}", case.name);
    }
}

/// Every way to write a tree down can be read.
fn codes(case: &Case<2>, tree: &OrthTree<2>) {
    let mut again = vec![
        OrthTree::from_text(&tree.to_text()),
        OrthTree::from_bits(&tree.to_bits()),
        OrthTree::from_level_bits(&tree.to_level_bits()),
        OrthTree::from_linear(&tree.to_linear()),
        OrthTree::from_black(&tree.black().collect::<Vec<_>>()),
        OrthTree::try_from(&BinTree::from(tree)),
    ];
    for order in [SonOrder::Morton, SonOrder::Hilbert] {
        again.push(OrthTree::from_text_in(order, &tree.to_text_in(order)));
    }
    again.extend(tree.to_raster(DEPTH + 1).map(|raster| Ok(OrthTree::from_raster(&raster))));
    for (way, again) in again.into_iter().enumerate() {
        assert_eq!(again.as_ref(), Ok(tree), "{}: way {way}", case.name);
    }
}

/// The laws of sets, and of their measures.
fn sets(case: &Case<2>, a: &OrthTree<2>, b: &OrthTree<2>) {
    let (meet, join) = (a.intersection(b), a.union(b));
    assert_eq!(a.complement().union(&b.complement()), meet.complement(), "{}", case.name);
    assert_eq!(a.symmetric_difference(b), join.difference(&meet), "{}", case.name);
    assert_eq!(a.difference(b), a.intersection(&b.complement()), "{}", case.name);
    let area = |tree: &OrthTree<2>| tree.volume(DEPTH).expect("no leaf is smaller");
    assert_eq!(area(a) + area(b), area(&meet) + area(&join), "{}: areas", case.name);
    assert_eq!(area(a) + area(&a.complement()), 1 << (2 * DEPTH), "{}: areas", case.name);
}
