//! The program `delone`.
fn main() {}
