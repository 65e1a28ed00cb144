//! Pictures and reports: SVG of planar and spatial meshes, and HTML in one self-contained file.
//!
//! ```
//! use delone_draw::{Anchor, Cell, Picture, Report, Style, Table};
//!
//! let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
//! let picture = Picture { points: &points, triangles: &[[0, 1, 2], [0, 2, 3]], segments: &[[0, 2]], ..Picture::default() };
//! assert!(picture.svg(&Style::default()).starts_with("<svg"));
//!
//! let mut report = Report::new("Two triangles");
//! report.heading("The square", &Anchor::new("square"));
//! let mut table = Table::new(["input", "triangles", "verdict"]);
//! table.row([Cell::text("square"), Cell::count(2), Cell::text("proved").ok()]);
//! report.table(&table);
//! report.picture(&picture, &Style::default(), "A square and its diagonal.");
//! assert!(report.finish().ends_with("</html>\n"));
//! ```
//!
//! # Which one do I want
//!
//! | module | draws | when |
//! |---|---|---|
//! | [`Picture`] | a planar triangulation as SVG, numbered if asked | up to some 10,000 edges, papers, rustdoc |
//! | [`Exploded`] | its triangles moved apart | complexes of a few cells |
//! | [`panels()`] | several pictures on one sheet | before and after |
//! | [`Solid`] | a tetrahedral mesh as SVG: shaded boundary, wires inside | up to some 10,000 facets |
//! | [`Plot`] | curves on logarithmic axes, with their exponents | how a cost grows |
//! | [`barcode`], [`betti_curves`] | classes of persistent homology, Betti numbers | what lives how long |
//! | [`Rasters`] | fields of signs or classes, side by side in rows | maps of predicates |
//! | [`DomainSheet`] | cells, trees, cubes and codes of quadtrees and octrees | up to some 1,000 nodes |
//! | [`Scene`] | layers to switch, steps to go through, in a report | what an algorithm did |
//! | [`Slider`] | a complex that grows, as a page with a slider | alpha complexes |
//! | [`Report`] | paragraphs, sortable tables, figures; a figure of more than [`SVG_EDGES_MAX`] edges becomes a canvas with pan and zoom | `compare`, benchmarks |
//!
//! # Contract
//!
//! - Input is plain coordinates and indices; an index out of range or a coordinate that is not finite leaves its element
//!   out, and the picture's description says how many were left out.
//! - Any finite doubles will do: all coordinates are brought into the unit square by powers of two and one division, so
//!   no NaN or infinity reaches the output. A figure too flat to be seen is stretched, and says so.
//! - The same input gives the same bytes. Text is escaped everywhere. The HTML is also well-formed XML, uses no
//!   network, and follows the reader's light or dark scheme.
//!
//! Not here: layout of graphs, geometry (circumcircles apart), reading clocks or files.

mod classes;
mod domain;
mod frame;
mod html;
mod num;
mod plot;
mod rasters;
mod slider;
mod solid;
mod svg;
mod text;

pub use classes::{Class, barcode, betti_curves};
pub use domain::{Block, Cube, DomainSheet, Panel, Shade};
pub use html::{Anchor, Cell, Report, SVG_EDGES_MAX, Scene, Span, Step, Table, Tone};
pub use plot::{Plot, Series};
pub use rasters::{Raster, Rasters};
pub use slider::Slider;
pub use solid::Solid;
pub use svg::{Arc, Aspect, Dots, Exploded, Picture, Style, panels};
