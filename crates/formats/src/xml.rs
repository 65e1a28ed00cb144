//! XML trees, not nested deeper than any drawing or test suite: transforms are looked up along the ancestors.

use roxmltree::{Document, Node, ParsingOptions};

use crate::error::ReadError;

const DEPTH_MAX: usize = 256;

pub(crate) fn parse(text: &str) -> Result<Document<'_>, ReadError> {
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    let tree = Document::parse_with_options(text, options).map_err(|error| {
        let line = usize::try_from(error.pos().row).unwrap_or(0);
        ReadError::malformed(line, "well-formed XML", &error.to_string())
    })?;
    refuse_deep(&tree)?;
    Ok(tree)
}

pub(crate) fn line(tree: &Document<'_>, node: Node<'_, '_>) -> usize {
    usize::try_from(tree.text_pos_at(node.range().start).row).unwrap_or(0)
}

/// Nodes come parents first, so each depth is one more than one already known.
fn refuse_deep(tree: &Document<'_>) -> Result<(), ReadError> {
    let mut depths: Vec<usize> = Vec::new();
    for node in tree.descendants() {
        let above = node.parent().and_then(|parent| depths.get(parent.id().get_usize()));
        let depth = above.map_or(0, |depth| depth + 1);
        if depth > DEPTH_MAX {
            return Err(ReadError::malformed(
                line(tree, node),
                "XML nested at most 256 deep",
                "more",
            ));
        }
        depths.push(depth);
    }
    Ok(())
}
