//! A missing arrow is a rule: crates depend on each other as ARCHITECTURE.md says, and on nobody's triangulation.

use std::collections::BTreeMap;
use std::path::Path;

use super::Source;

/// Crates that triangulate: opponents, allowed in tests and benches only.
const OPPONENTS: [&str; 6] =
    ["spade", "delaunator", "cdt", "delaunay", "ghx_constrained_delaunay", "geogram_predicates"];

pub(crate) fn broken(root: &Path, sources: &[Source]) -> Result<Vec<String>, String> {
    let architecture = sources.iter().find(|source| source.path == Path::new("ARCHITECTURE.md"));
    let arrows = arrows(&architecture.ok_or("ARCHITECTURE.md is missing")?.text)?;
    let mut broken = Vec::new();
    for source in sources {
        let Some(name) = crate_name(&source.path) else { continue };
        let manifest: toml::Table =
            source.text.parse().map_err(|error| format!("{}: {error}", source.path.display()))?;
        let Some(allowed) = arrows.get(name) else {
            broken.push(format!("{}: no line of arrows in ARCHITECTURE.md", source.path.display()));
            continue;
        };
        for dependency in keys(&manifest, "dependencies") {
            if OPPONENTS.contains(&dependency.as_str()) {
                broken.push(format!("{name} depends on {dependency}, an opponent"));
            }
            let Some(target) = dependency.strip_prefix("delone-") else { continue };
            if !allowed.iter().any(|arrow| arrow == target || arrow == "*") {
                broken.push(format!("{name} -> {target} is no arrow of ARCHITECTURE.md"));
            }
        }
    }
    for name in arrows.keys().filter(|name| !root.join("crates").join(name.as_str()).exists()) {
        broken.push(format!("ARCHITECTURE.md has arrows for {name}, which is no crate"));
    }
    Ok(broken)
}

/// `crates/mesh/Cargo.toml` is `mesh`.
fn crate_name(path: &Path) -> Option<&str> {
    let rest = path.strip_prefix("crates").ok()?;
    let name = rest.parent()?;
    (rest.file_name()? == "Cargo.toml").then(|| name.to_str()).flatten()
}

fn keys(manifest: &toml::Table, table: &str) -> Vec<String> {
    let table = manifest.get(table).and_then(toml::Value::as_table);
    table.map(|table| table.keys().cloned().collect()).unwrap_or_default()
}

/// The lines `a -> b c` of the block marked `arrows`.
fn arrows(text: &str) -> Result<BTreeMap<String, Vec<String>>, String> {
    let block = text.split("```arrows\n").nth(1).and_then(|rest| rest.split("```").next());
    let block = block.ok_or("ARCHITECTURE.md has no block marked arrows")?;
    let mut arrows = BTreeMap::new();
    for line in block.lines() {
        let (from, to) = line.split_once("->").ok_or_else(|| format!("no arrow in `{line}`"))?;
        let to = if to.contains("all of the above") { "*" } else { to };
        let to = to.split_whitespace().map(str::to_owned).collect();
        arrows.insert(from.trim().to_owned(), to);
    }
    Ok(arrows)
}
