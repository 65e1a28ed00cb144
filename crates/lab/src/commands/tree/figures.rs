//! `delone tree figure`: an object with its labelled tree, its quadtree beside its bin-tree, an octree.

use delone_draw::{Block, Cube, DomainSheet, Panel, Shade};
use delone_formats::Document;
use delone_trees::{BinNode, BinTree, Cell, Colour, Frame, OrthTree, SonOrder};

use super::boundary::{Boundary, Grown, read, segments};
use super::codes::order;
use crate::cli::{Drawn, Figure};
use crate::failure::Failure;
use crate::output;

pub(super) fn figure(arguments: &Figure) -> Result<(), Failure> {
    output::check_paths(arguments.output.as_deref())?;
    let document = read(&arguments.source, false)?;
    let grown = Boundary::of(&document, arguments.inside)?.tree(arguments.depth, arguments.rule)?;
    let sheet = match (arguments.figure, &grown) {
        (Drawn::Labelled, Grown::Plane(tree, frame)) => {
            labelled(tree, outline(&document, frame), order(arguments.order))
        }
        (Drawn::Bintree, Grown::Plane(tree, frame)) => beside(tree, outline(&document, frame)),
        (Drawn::Octree, Grown::Space(tree, _)) => octree(tree),
        (Drawn::Octree, _) => return Err(Failure::input("octrees are of surfaces in space")),
        _ => return Err(Failure::input("this figure is of the plane; figure octree is of space")),
    };
    match &arguments.output {
        Some(path) => output::text(path, &sheet.svg()),
        None => output::print_bytes(sheet.svg().as_bytes()),
    }
}

/// The input's segments in the unit square.
pub(super) fn outline(document: &Document, frame: &Frame<2>) -> Vec<[[f64; 2]; 2]> {
    let points = document.points.as_chunks::<2>().0;
    let place = |v: usize| {
        std::array::from_fn(|axis| (points[v][axis] - frame.corner()[axis]) / frame.side())
    };
    segments(document).iter().map(|ends| ends.map(place)).collect()
}

fn shade(colour: Colour) -> Shade {
    match colour {
        Colour::White => Shade::White,
        Colour::Black => Shade::Black,
        Colour::Gray => Shade::Gray,
    }
}

/// The lower corner and the side of a cell of the unit cube.
fn scaled<const N: usize>(cell: Cell<N>) -> ([f64; N], f64) {
    let side = 0.5f64.powi(i32::from(cell.level()));
    (cell.anchor().map(|place| f64::from(place) * side), side)
}

pub(super) fn block(cell: Cell<2>, shade: Shade, label: String) -> Block {
    let (lower, side) = scaled(cell);
    Block { lower, upper: lower.map(|c| c + side), shade, label }
}

fn blocks(tree: &OrthTree<2>) -> Vec<Block> {
    let leaves = tree.cells().filter(|&(_, colour)| colour != Colour::Gray);
    leaves.map(|(cell, colour)| block(cell, shade(colour), String::new())).collect()
}

/// Where the sons are that come first, second, .., in cells of the first or second level.
fn legend(order: SonOrder, level: u8) -> Result<Panel, Failure> {
    let count = 1usize << (2 * level);
    let mut blocks = Vec::new();
    for key in 0..count {
        let cell = Cell::<2>::of_key(level, key as u128).expect("the key is of this level");
        let dot = OrthTree::from_black(&[cell]).map_err(Failure::input)?;
        blocks.push(block(cell, Shade::White, (1 + before(&dot, order, level)).to_string()));
    }
    Ok(Panel::Blocks { blocks, outline: Vec::new() })
}

/// How many cells of a level come before the only black one.
fn before(tree: &OrthTree<2>, order: SonOrder, level: u8) -> usize {
    let mut sizes = vec![1usize << (2 * level)];
    let mut before = 0;
    for colour in tree.colours_in(order) {
        let size = sizes.pop().unwrap_or(0);
        match colour {
            Colour::Black => break,
            Colour::White => before += size,
            Colour::Gray => sizes.extend([size / 4; 4]),
        }
    }
    before
}

/// The lecture's first figure: an object, its labelled tree, the order of sons, the code.
fn labelled(tree: &OrthTree<2>, outline: Vec<[[f64; 2]; 2]>, order: SonOrder) -> DomainSheet {
    let colours = tree.colours_in(order);
    let counts = tree.counts();
    let level = if order == SonOrder::Hilbert { 2 } else { 1 };
    let caption = |text: &str| text.to_owned();
    let mut first = vec![(
        format!("object, {} black and {} white leaves", counts.black, counts.white),
        Panel::Blocks { blocks: blocks(tree), outline },
    )];
    if let Ok(legend) = legend(order, level) {
        first.push((caption("order of sons"), legend));
    }
    let nodes = colours.into_iter().map(shade).collect();
    let title = format!("Labelled quadtree, depth {}, {} gray nodes", tree.depth(), counts.gray);
    let code = tree.to_text_in(order);
    let bits = counts.nodes() + counts.leaves();
    DomainSheet {
        title,
        rows: vec![
            first,
            vec![(caption("tree, sons in this order"), Panel::Hierarchy { arity: 4, nodes })],
            vec![(format!("depth-first expression, {bits} bits"), Panel::Text(code))],
        ],
    }
}

/// The cells of a bin-tree's leaves.
fn bin_blocks(tree: &BinTree<2>) -> Vec<Block> {
    let mut pending = vec![([0.0; 2], [1.0; 2])];
    let mut blocks = Vec::new();
    for &node in tree.nodes() {
        let Some((lower, upper)) = pending.pop() else { break };
        let leaf = |shade| Block { lower, upper, shade, label: String::new() };
        match node {
            BinNode::White => blocks.push(leaf(Shade::White)),
            BinNode::Black => blocks.push(leaf(Shade::Black)),
            BinNode::Cut { axis, at } => {
                let (mut below, mut above) = ((lower, upper), (lower, upper));
                below.1[usize::from(axis)] = at;
                above.0[usize::from(axis)] = at;
                pending.extend([above, below]);
            }
        }
    }
    blocks
}

/// The lecture's second figure: the quadtree and the bin-tree of one object.
fn beside(tree: &OrthTree<2>, outline: Vec<[[f64; 2]; 2]>) -> DomainSheet {
    let bin = BinTree::from(tree);
    let (quad_counts, bin_counts) = (tree.counts(), bin.counts());
    let nodes = |name: &str, gray: usize, leaves: usize| {
        format!("{name}: {gray} gray nodes, {leaves} leaves, {} bits", gray + 2 * leaves)
    };
    let quad = nodes("quadtree", quad_counts.gray, quad_counts.leaves());
    let bin_caption = nodes("bin-tree", bin_counts.gray, bin_counts.leaves());
    let quad_nodes = tree.colours().iter().map(|&colour| shade(colour)).collect();
    let bin_nodes = bin.nodes().iter().map(|node| match node {
        BinNode::White => Shade::White,
        BinNode::Black => Shade::Black,
        BinNode::Cut { .. } => Shade::Gray,
    });
    DomainSheet {
        title: format!("Quadtree and bin-tree, depth {}", tree.depth()),
        rows: vec![
            vec![
                (quad, Panel::Blocks { blocks: blocks(tree), outline: outline.clone() }),
                (bin_caption, Panel::Blocks { blocks: bin_blocks(&bin), outline }),
            ],
            vec![("quadtree".into(), Panel::Hierarchy { arity: 4, nodes: quad_nodes })],
            vec![("bin-tree".into(), Panel::Hierarchy { arity: 2, nodes: bin_nodes.collect() })],
        ],
    }
}

/// How far the octants of the third figure are moved apart.
const APART: f64 = 0.25;

/// Black leaves from back to front, octants moved apart.
fn cubes(tree: &OrthTree<3>, apart: f64) -> Vec<Cube> {
    let depth = u32::from(tree.depth());
    // Morton's order with y backwards: each key's digits with the second bit turned, filled up to the depth.
    let rank = |cell: &Cell<3>| {
        let level = u32::from(cell.level());
        let turned = (0..level).fold(cell.key(), |key, digit| key ^ 2 << (3 * digit));
        turned << (3 * (depth - level))
    };
    let mut black: Vec<Cell<3>> = tree.black().collect();
    black.sort_by_key(rank);
    let moved = |cell: Cell<3>| {
        let (lower, side) = scaled(cell);
        // The root itself is not moved.
        let away = |c: f64| {
            if side > 0.5 {
                0.0
            } else if c < 0.5 {
                -apart / 2.0
            } else {
                apart / 2.0
            }
        };
        Cube { lower: lower.map(|c| c + away(c)), side }
    };
    black.into_iter().map(moved).collect()
}

/// The lecture's third figure: a cell cut into eight, and an octree with its cubes.
fn octree(tree: &OrthTree<3>) -> DomainSheet {
    let counts = tree.counts();
    let octants: Vec<Cell<3>> = (0..8).filter_map(|key| Cell::of_key(1, key)).collect();
    let mut eight = octants;
    eight.sort_by_key(|cell| cell.key() ^ 2);
    let eight = eight.into_iter().map(|cell| {
        let (lower, side) = scaled(cell);
        Cube { lower: lower.map(|c| if c < 0.5 { c - 0.1 } else { c + 0.1 }), side }
    });
    let nodes = tree.colours().iter().map(|&colour| shade(colour)).collect();
    let caption = format!("{} black leaves", counts.black);
    DomainSheet {
        title: format!("Octree, depth {}, {} gray nodes", tree.depth(), counts.gray),
        rows: vec![
            vec![
                ("a cell cut by three planes".into(), Panel::Cubes(eight.collect())),
                (caption, Panel::Cubes(cubes(tree, 0.0))),
                ("its octants moved apart".into(), Panel::Cubes(cubes(tree, APART))),
            ],
            vec![("tree, sons in Morton's order".into(), Panel::Hierarchy { arity: 8, nodes })],
        ],
    }
}
