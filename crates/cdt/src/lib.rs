//! cdt.
