//! delone.
