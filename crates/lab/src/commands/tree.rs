//! `delone tree`: quadtrees and octrees of what is inside a boundary, their numbers, codes and pictures.

mod boundary;
mod build;
mod codes;
mod divide;
mod export;
mod figures;
mod growth;
mod numbers;

use crate::cli::{Tree, TreeAction};
use crate::failure::Failure;

pub(crate) fn tree(arguments: &Tree) -> Result<(), Failure> {
    match &arguments.action {
        TreeAction::Build(arguments) => build::build(arguments),
        TreeAction::Stats(arguments) => codes::stats(arguments),
        TreeAction::Encode(arguments) => codes::encode(arguments),
        TreeAction::Op(arguments) => codes::operate(arguments),
        TreeAction::Figure(arguments) => figures::figure(arguments),
        TreeAction::Polygons(arguments) => export::polygons(arguments),
        TreeAction::Mesh(arguments) => export::mesh(arguments),
        TreeAction::Divide(arguments) => divide::divide(arguments),
        TreeAction::Growth(arguments) => growth::growth(arguments),
    }
}
