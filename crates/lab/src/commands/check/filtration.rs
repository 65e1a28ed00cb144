//! `delone check --as alpha`: a filtration as `delone alpha --filtration` writes it, judged by definition.

use std::path::Path;

use delone_check::{Options, Verdict, judge_alpha};
use delone_formats::Document;
use serde_json::Value;

use crate::failure::Failure;

/// Judges the list of simplices in a file; the input's weights count if it has any.
pub(super) fn judge(path: &Path, given: &Document, options: &Options) -> Result<Verdict, Failure> {
    let claim = read(path)?;
    let weights = given.weights.as_deref();
    Ok(if given.dimension == 3 {
        judge_alpha(given.points_3d().map_err(Failure::input)?, weights, &claim, options)
    } else {
        judge_alpha(given.points_2d().map_err(Failure::input)?, weights, &claim, options)
    })
}

/// Simplices with their values as text, from rows of columns or from JSON.
fn read(path: &Path) -> Result<Vec<(Vec<u32>, String)>, Failure> {
    let name = path.display();
    let text = std::fs::read_to_string(path)
        .map_err(|error| Failure::input(format!("{name}: {error}")))?;
    if text.trim_start().starts_with('{') {
        let object: Value = serde_json::from_str(&text)
            .map_err(|error| Failure::input(format!("{name}: {error}")))?;
        let rows = object["filtration"].as_array();
        let rows = rows.and_then(|rows| rows.iter().map(of_json).collect());
        return rows.ok_or_else(|| {
            Failure::input(format!(
                "{name}: no rows [dimension, vertices, squared radius] under filtration"
            ))
        });
    }
    let rows =
        text.lines().enumerate().filter(|(_, row)| !row.trim().is_empty() && !row.starts_with('#'));
    rows.map(|(number, row)| {
        of_columns(row).ok_or_else(|| {
            let line = number + 1;
            Failure::input(format!(
                "{name}:{line}: not a dimension, as many vertices and one, a value"
            ))
        })
    })
    .collect()
}

/// `dimension vertices.. value`
fn of_columns(row: &str) -> Option<(Vec<u32>, String)> {
    let words: Vec<&str> = row.split_whitespace().collect();
    let [dimension, vertices @ .., value] = &words[..] else { return None };
    let vertices: Vec<u32> = vertices.iter().map(|v| v.parse().ok()).collect::<Option<_>>()?;
    let is_whole = dimension.parse::<usize>().ok()?.checked_add(1)? == vertices.len();
    is_whole.then(|| (vertices, (*value).to_owned()))
}

/// `[dimension, [vertices..], value]`
fn of_json(row: &Value) -> Option<(Vec<u32>, String)> {
    let vertices = row[1].as_array()?.iter().map(|v| u32::try_from(v.as_u64()?).ok());
    let value = match &row[2] {
        Value::String(text) => text.clone(),
        Value::Number(number) => number.to_string(),
        _ => return None,
    };
    Some((vertices.collect::<Option<_>>()?, value))
}
