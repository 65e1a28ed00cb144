//! One mesh for every dimension: the vertices of each cell and the twin of each facet, and never a coordinate.
//!
//! ```text
//!          ghost                       The hull is closed by ghost cells at the vertex GHOST, so the mesh is always
//!         / | \                        a sphere, and no facet is without a twin:
//!        /  |  \                       three sites not in line: 1 solid and 3 ghost triangles, a 2-sphere;
//!       a---|---b                      all sites in line (dimension 1): a circle of segments through GHOST;
//!        \  |  /                       one site (dimension 0): a solid and a ghost point;
//!         \ | /                        no site: nothing.
//!           c
//! ```
//!
//! ```
//! use delone_mesh::{Level, Mesh, VertexId};
//!
//! let corners = [0, 1, 2].map(VertexId::new);
//! let mesh = Mesh::<2>::simplex(&corners);
//! assert_eq!((mesh.solid_cells().count(), mesh.ghost_cells().count()), (1, 3));
//! assert_eq!(mesh.faults(Level::Sphere, 3), []);
//! ```
//!
//! # Which one do I want
//!
//! | you want | use |
//! |---|---|
//! | to walk over cells and facets, any dimension | [`Mesh::cells`], [`Mesh::facets`], [`Mesh::twin`], [`Mesh::apex`] |
//! | half-edges and rings in the plane | [`HalfEdge`] and the methods of `Mesh<2>` |
//! | to flip an edge of the plane | [`Mesh::flip`] |
//! | to replace cells by a cone | [`Cavity`] and [`Mesh::star`] |
//! | to replace cells by cells of another mesh | [`Cavity`] and [`Mesh::transplant`] |
//! | a mesh from a list of cells | [`Mesh::from_cells`] |
//! | to know that it is a sphere | [`Mesh::faults`] |
//!
//! # Contract
//!
//! Facet `i` of a cell is opposite its corner `i`. A cell and its neighbour induce opposite orientations on the facet
//! between them; a ghost cell is oriented as if GHOST were a point beyond its facet. Handles are stable while no cell is
//! retired. Memory: 8 (D + 1) bytes a cell.
//!
//! **Not here.** Geometry (`delone-predicates`), construction (`delone-delaunay`), judgement (`delone-check`).

mod assemble;
mod cavity;
mod flip;
mod half_edge;
mod handle;
mod mesh;
mod transplant;
mod validate;

pub use cavity::{Cavity, Digger};
pub use half_edge::HalfEdge;
pub use handle::{CellId, FacetId, VertexId};
pub use mesh::Mesh;
pub use validate::{Level, MeshFault};

#[cfg(test)]
mod tests;
