//! predicates.
