//! Each row of a table of degeneracies names a test of the same crate that exists.
//!
//! A table of degeneracies is one in a doc comment whose head is `| case | answer | test |`.

use std::path::Path;

use regex::Regex;

use super::Source;

pub(crate) fn broken(sources: &[Source]) -> Result<Vec<String>, String> {
    let name = Regex::new(r"`([a-z0-9_]+)`\s*\|\s*$").map_err(|error| error.to_string())?;
    let mut broken = Vec::new();
    for source in sources.iter().filter(|source| source.has_extension("rs")) {
        for (number, row) in rows(&source.text) {
            let place = format!("{}:{}", source.path.display(), number + 1);
            match name.captures(row).and_then(|capture| capture.get(1)) {
                None => broken.push(format!("{place}: this case names no test")),
                Some(test) if !has_test(sources, &source.path, test.as_str()) => {
                    broken.push(format!("{place}: no test {} in this crate", test.as_str()));
                }
                Some(_) => {}
            }
        }
    }
    Ok(broken)
}

/// The rows below each head, with their line numbers.
fn rows(text: &str) -> Vec<(usize, &str)> {
    let mut rows = Vec::new();
    let mut inside = false;
    for (number, line) in text.lines().enumerate() {
        let line = line.trim_start();
        let content = line.strip_prefix("//!").or_else(|| line.strip_prefix("///")).map(str::trim);
        match content {
            Some("| case | answer | test |") => inside = true,
            Some(row) if row.starts_with('|') => {
                if inside && !row.starts_with("|---") {
                    rows.push((number, row));
                }
            }
            _ => inside = false,
        }
    }
    rows
}

fn has_test(sources: &[Source], path: &Path, test: &str) -> bool {
    let home: Vec<_> = path.components().take(2).collect();
    let head = format!("fn {test}(");
    sources
        .iter()
        .filter(|source| source.path.components().take(2).eq(home.iter().copied()))
        .any(|source| source.text.contains(&head))
}
