//! The comparison as tables for papers and programs: CSV, and LaTeX with the rules of booktabs.

use super::Comparison;

const HEADS: [&str; 11] = [
    "input",
    "sites",
    "segments",
    "algorithm",
    "verdict",
    "cells",
    "build s",
    "judge s",
    "orientations",
    "in-spheres",
    "steiner",
];

fn rows(comparison: &Comparison) -> impl Iterator<Item = [String; 11]> + '_ {
    comparison.entries.iter().flat_map(|entry| {
        entry.rows.iter().map(|row| {
            let steiner = row.added.as_ref().map_or(String::new(), |a| a.points.to_string());
            [
                entry.subject.name().to_owned(),
                entry.subject.site_count().to_string(),
                entry.subject.document.segments.len().to_string(),
                row.algorithm.to_owned(),
                row.word(),
                row.sizes.cells.to_string(),
                format!("{:.3e}", row.seconds),
                format!("{:.3e}", row.check_seconds),
                row.counts.orients.to_string(),
                row.counts.in_spheres.to_string(),
                steiner,
            ]
        })
    })
}

pub(super) fn csv(comparison: &Comparison) -> String {
    let cell = |text: &String| {
        let is_plain = !text.contains([',', '"', '\n']);
        if is_plain { text.clone() } else { format!("\"{}\"", text.replace('"', "\"\"")) }
    };
    let line =
        |row: [String; 11]| format!("{}\n", row.iter().map(cell).collect::<Vec<_>>().join(","));
    format!("{}\n{}", HEADS.join(","), rows(comparison).map(line).collect::<String>())
}

pub(super) fn latex(comparison: &Comparison) -> String {
    let line = |row: [String; 11]| {
        let cells: Vec<String> = row.iter().map(|text| escaped(text)).collect();
        format!("{} \\\\\n", cells.join(" & "))
    };
    let rows: String = rows(comparison).map(line).collect();
    let heads = HEADS.join(" & ");
    format!(
        "\\begin{{tabular}}{{lrrllrrrrrr}}\n\\toprule\n{heads} \\\\\n\\midrule\n{rows}\\bottomrule\n\\end{{tabular}}\n"
    )
}

/// A text as LaTeX prints it.
fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '&' | '%' | '$' | '#' | '_' | '{' | '}' => {
                out.push('\\');
                out.push(c);
            }
            '\\' => out.push_str("\\textbackslash{}"),
            '~' => out.push_str("\\textasciitilde{}"),
            '^' => out.push_str("\\textasciicircum{}"),
            _ => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests;
