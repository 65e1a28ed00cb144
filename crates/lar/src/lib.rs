//! Linear algebraic representation: a simplicial complex as lists of cells by vertex indices, its chains, its boundary
//! operators as sparse matrices, its homology.
//!
//! ```
//! use delone_lar::{Coefficients, Complex};
//!
//! // A triangle without its inside, and one beside it that is filled.
//! let v = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
//! let complex = Complex::closure(v, &[&[0, 1], &[0, 2], &[1, 2, 3]]).unwrap();
//! assert_eq!(complex.counts(), [4, 5, 1]);
//! assert_eq!(complex.euler(), 0);
//! assert_eq!(complex.betti(Coefficients::Rational), [1, 1, 0]); // one piece, one hole
//!
//! let boundary = complex.boundary(2); // 5 x 1: edges by triangles
//! assert_eq!((boundary.rows(), boundary.cols(), boundary.nnz()), (5, 1, 3));
//! ```
//!
//! # Which one do I want
//!
//! | item | what it is | cost |
//! |---|---|---|
//! | [`Complex::closure`] | the model `(V, [VV, EV, FV, CV])` of given cells and all their faces | O(n log n) |
//! | [`Complex::of_mesh`] | the model of some cells of a mesh | O(n log n) |
//! | [`Complex::boundary`], [`Complex::coboundary`] | signed operators, compressed by columns or rows | O(n) |
//! | [`Chain`] | an integer combination of cells of one dimension, its boundary | O(its size) |
//! | [`Complex::betti`] | Betti numbers over Z/2 or the rationals, exactly | mostly near linear; O(n^3) |
//! | [`Complex::write_matrix_market`] | an operator for other programs | O(n) |
//!
//! # Contract
//!
//! **Orientation.** A cell is stored with its vertices in increasing order, and that is its orientation; the face without
//! vertex `i` comes with the sign `(-1)^i`. The sign of the order in which a cell was *given* is kept beside
//! ([`Complex::orientations`]), so that the chain of all counter-clockwise triangles can be written down. Cells are sorted,
//! and numbered from 0. Out of range, repeated or no vertices: refused, all of them.
//!
//! **Paper.** \[DPS14\], restricted to simplices.
//!
//! **Not here.** Cells that are no simplices; positions, which are carried along and never looked at; files of whole models
//! (`delone-formats`); pictures (`delone-draw`).

mod chain;
mod complex;
mod homology;
mod operator;

pub use chain::Chain;
pub use complex::{Complex, ComplexFault};
pub use homology::Coefficients;
pub use operator::Operator;

#[cfg(test)]
mod tests;
