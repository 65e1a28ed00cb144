//! `delone tree build`.

use super::boundary::{Boundary, Grown, read, with_tree};
use super::numbers::{numbers, place, tell};
use crate::cli::Build;
use crate::failure::Failure;
use crate::output;

pub(super) fn build(arguments: &Build) -> Result<(), Failure> {
    output::check_paths(arguments.output.as_deref())?;
    let document = read(&arguments.source, arguments.voice.quiet)?;
    let boundary = Boundary::of(&document, arguments.inside)?;
    let grown = boundary.tree(arguments.depth, arguments.rule)?;
    with_tree!(&grown, tree, frame => {
        if let Some(path) = &arguments.output {
            output::text(path, &(tree.to_text() + "\n"))?;
        }
        let mut object = numbers(tree, arguments.depth);
        place(&mut object, frame);
        tell(&object, arguments.voice.json);
    });
    Ok(())
}
