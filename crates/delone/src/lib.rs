//! Robust triangulation: exact predicates, Delaunay and constrained Delaunay, and a judge that shares nothing with them.
//!
//! ```
//! use delone::{Pslg, Sites, cdt, delaunay};
//!
//! // Any finite doubles, as degenerate as you like.
//! let sites = Sites::new(&[[0.0, 0.0], [1e300, 0.0], [0.0, 5e-324]]).unwrap();
//! let triangulation = delaunay::delaunay(&sites, &delaunay::Options::default(), &mut ());
//! assert_eq!(triangulation.canonical(), [0, 1, 2]);
//!
//! let pslg = Pslg::new(sites.points(), &[[1, 2]]).unwrap();
//! let constrained = cdt::cavity(&pslg, &delaunay::Options::default(), &mut ());
//! assert_eq!(constrained.constrained_edges(), [[1, 2]]);
//! ```
//!
//! # Which one do I want
//!
//! | you want | module |
//! |---|---|
//! | the predicates alone | [`predicates`] |
//! | the Delaunay triangulation of points, any dimension | [`delaunay`] |
//! | the constrained Delaunay triangulation of points and segments | [`cdt`] |
//! | the same with Steiner points, conforming or refined | [`conforming`] |
//! | alpha complexes and shapes, persistent homology | [`alpha`] |
//! | what is inside a soup of edges, with or without holes | [`cdt::triangulate2d`], [`cdt::Domain`] |
//! | chains, boundary operators, Betti numbers | [`lar`] |
//! | quadtrees, octrees, their codes and set operations | [`trees`] |
//! | a proof that a triangulation is one | [`check`] |
//! | input: files, generators | [`formats`], [`workloads`] |
//! | pictures | [`draw`] |
//!
//! Everything is deterministic, nothing has a tolerance, and ties are broken by one symbolic perturbation, so that all
//! algorithms give the same triangulation.

pub use delone_alpha as alpha;
pub use delone_cdt as cdt;
pub use delone_check as check;
pub use delone_conforming as conforming;
pub use delone_delaunay as delaunay;
pub use delone_draw as draw;
pub use delone_formats as formats;
pub use delone_lar as lar;
pub use delone_mesh as mesh;
pub use delone_predicates as predicates;
pub use delone_probe as probe;
pub use delone_sites as sites;
pub use delone_trees as trees;
pub use delone_workloads as workloads;

pub use delone_mesh::Mesh;
pub use delone_sites::{Pslg, Sites};
