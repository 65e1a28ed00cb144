//! Domain trees: quadtrees, octrees and their kin as depth-first codes of white, black and gray nodes, and as leaves alone.
//!
//! ```
//! use delone_trees::{BinTree, LeafRule, Rule, Shape};
//!
//! let points = [[0.0, 0.0], [8.0, 1.0], [3.0, 7.0]];
//! let shape = Shape::new(&points, &[[0, 1], [1, 2], [2, 0]], Rule::EvenOdd)?;
//! let frame = shape.frame(5)?; // L = 8, r = L / 2^5
//! let [inner, outer] = [LeafRule::Inner, LeafRule::Outer].map(|rule| shape.tree(&frame, rule));
//! let area = |tree: &delone_trees::OrthTree<2>| tree.volume(5).unwrap() as f64 / 16.0;
//! assert!(area(&inner) < 26.5 && 26.5 < area(&outer));
//! assert_eq!(inner.union(&outer), outer);
//! assert!(BinTree::from(&inner).counts().leaves() < inner.counts().leaves());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which one do I want
//!
//! | you want | use | time |
//! |---|---|---|
//! | the quadtree of a boundary in the plane | [`Shape::tree`] in a [`Frame`] \[HS79\] | O(its leaves), see its page |
//! | its octree from a closed surface of triangles | [`Solid::tree`] | O(its leaves) for each triangle that meets them |
//! | cells black if half of them is inside | [`Shape::tree_by_area`] | |
//! | a tree of 2^N sons, N = 1 to 4 | [`OrthTree`] | |
//! | union, intersection, difference, complement | [`OrthTree::union`], [`OrthTree::combine`] | O(n) |
//! | a text, bits, linear codes \[Gar82\], keys | [`OrthTree::to_text`], [`OrthTree::to_bits`], [`OrthTree::to_linear`], [`OrthTree::black`] | O(n) |
//! | pictures in and out | [`Raster`] | O(cells) |
//! | area, perimeter, Euler number \[Gra71\], components | [`OrthTree::volume`], [`OrthTree::surface`], [`OrthTree::euler`], [`OrthTree::components`] | O(n depth) |
//! | boundary polygons, as rings or (V, EV) \[DRS80\] | [`OrthTree::boundary`], [`OrthTree::boundary_complex`] | O(n log n) |
//! | neighbours of cells by their keys \[Sch92\] | [`Key::neighbour`] | O(1) |
//! | leaves: that of a point, those in a box, neighbours | [`OrthTree::leaves`], [`Frame::cell_at`] | O(log n) |
//! | neighbours that differ by one level at most \[SSB08\] | [`Leaves::balanced`] | O(n log n) |
//! | a triangulation with angles from 26.5 to 90 degrees \[BEG94\] | [`Leaves::triangles`] | O(n log n) |
//! | leaves with few sites \[Sam84\], with simple parts of a PSLG \[SW85\] | [`PrTree`], [`PmTree`] | |
//! | sons in another order \[KE80\] | [`SonOrder`] | O(n) |
//! | one hyperplane at a time \[Tam84\] | [`BinTree`] | O(n) |
//!
//! # Contract
//!
//! **Normal form.** No inner node has leaves of one colour only; every constructor sees to it. So trees are equal if and only if they
//! are the same set. **Identity.** Leaves are (2^N - 1) gray + 1, in a [`BinTree`] gray + 1. **Sons** are in Morton's order, axis 0
//! first, unless a [`SonOrder`] is named. **Exact.** Corners of cells are doubles, what is inside is decided by exact predicates, areas
//! are integers of cells. **Deterministic.** No randomness, no recursion; depths up to [`DEPTH_MAX`].
//!
//! **Fails.** Codes that are no tree ([`CodeFault`]), open boundaries ([`ShapeFault`], [`SolidFault`]), frames that doubles cannot hold ([`FrameFault`]).
//!
//! **Not here.** Shares of cells of space; triangulations that follow the input's own segments (`conforming` has those).

mod bintree;
mod boundary;
mod buckets;
mod cell;
mod chain;
mod codes;
mod colour;
mod fault;
mod frame;
mod grow;
mod key;
mod leaves;
mod measure;
mod nudge;
mod order;
mod orth;
mod pm;
mod pr;
mod raster;
mod sets;
mod shape;
mod solid;
#[cfg(test)]
mod testing;
mod writer;

pub use bintree::{BinNode, BinTree};
pub use cell::{Cell, DEPTH_MAX};
pub use chain::BoundaryFault;
pub use codes::Bits;
pub use colour::Colour;
pub use fault::CodeFault;
pub use frame::{Frame, FrameFault};
pub use grow::LeafRule;
pub use key::Key;
pub use leaves::{Leaves, Triangles, TrianglesFault};
pub use measure::{Components, Joined};
pub use order::{Quadrant, SonOrder};
pub use orth::{Counts, OrthTree};
pub use pm::{PmRule, PmTree};
pub use pr::{OutsideFrame, PrTree};
pub use raster::{RASTER_BITS_MAX, Raster};
pub use shape::{Rule, Shape, ShapeFault};
pub use solid::{Solid, SolidFault};
