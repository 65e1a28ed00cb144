//! delaunay.
