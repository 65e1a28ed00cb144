//! A paper cited by key, as in `[She97]`, has a note in `papers/`, and each note is cited.

use std::collections::BTreeSet;
use std::path::Path;

use regex::Regex;

use super::Source;

pub(crate) fn broken(sources: &[Source]) -> Result<Vec<String>, String> {
    let pattern = |text| Regex::new(text).map_err(|error| error.to_string());
    let (in_prose, in_registry) =
        (pattern(r"\[([A-Z][A-Za-z]*[0-9]{2})\\?\]")?, pattern(r#""([A-Z][A-Za-z]*[0-9]{2})""#)?);
    let notes: BTreeSet<&str> = sources
        .iter()
        .filter(|source| source.path.parent() == Some(Path::new("papers")))
        .filter_map(|source| source.path.file_stem()?.to_str())
        .filter(|&stem| stem != "README")
        .collect();
    let mut broken = Vec::new();
    let mut cited = BTreeSet::new();
    for source in sources.iter().filter(|source| source.has_extension("rs")) {
        for pattern in [&in_prose, &in_registry] {
            for capture in pattern.captures_iter(&source.text) {
                let key = capture.get(1).map_or("", |key| key.as_str());
                if !notes.contains(key) {
                    broken.push(format!("{}: papers/{key}.md is missing", source.path.display()));
                }
                cited.insert(key.to_owned());
            }
        }
    }
    broken.extend(
        notes
            .iter()
            .filter(|note| !cited.contains(**note))
            .map(|note| format!("papers/{note}.md: nobody cites it")),
    );
    Ok(broken)
}
