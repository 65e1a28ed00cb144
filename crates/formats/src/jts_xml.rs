//! Test suites of JTS and GEOS: `<run>` of `<case>`s whose geometries `<a>` and `<b>` are WKT or hexadecimal WKB.
//!
//! Each geometry is a document, named `1a`, `1b`, `2a`, .. by case. Tests and expected results are not read. A
//! geometry that is neither (a file name, a formula) refuses the file with its line.

use crate::document::Document;
use crate::error::ReadError;
use crate::{wkb, wkt, xml};

pub(crate) fn read(text: &str) -> Result<Vec<Document>, ReadError> {
    let tree = xml::parse(text)?;
    let mut documents = Vec::new();
    let cases = tree.descendants().filter(|node| node.has_tag_name("case"));
    for (i, case) in cases.enumerate() {
        for geometry in case.children().filter(|n| n.has_tag_name("a") || n.has_tag_name("b")) {
            let name = geometry.tag_name().name();
            let text: String = geometry.children().filter_map(|child| child.text()).collect();
            let read =
                if wkb::looks_like(&text) { wkb::read_hex(&text) } else { wkt::read_one(&text) };
            let mut document =
                read.map_err(|error| error.after_line(xml::line(&tree, geometry)))?;
            document.name = format!("{}{name}", i + 1);
            documents.push(document);
        }
    }
    if documents.is_empty() && !tree.root_element().has_tag_name("run") {
        let found = tree.root_element().tag_name().name();
        return Err(ReadError::malformed(1, "a test suite: <run> with <case>s", found));
    }
    Ok(documents)
}

#[cfg(test)]
mod tests;
