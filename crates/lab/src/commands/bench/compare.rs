//! Two records beside each other.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::json;

use super::numbers::{geometric_mean, median, ratio};
use super::record::{Record, read};
use crate::cli::Voice;
use crate::failure::Failure;

type Key = (String, String, usize, String);

/// What was timed, by definition, input, sites and engine.
fn times(records: &[Record]) -> BTreeMap<Key, Vec<f64>> {
    let mut all: BTreeMap<Key, Vec<f64>> = BTreeMap::new();
    for r in records {
        let key = (r.definition.clone(), r.input.clone(), r.sites, r.engine.clone());
        all.entry(key).or_default().extend(r.time);
    }
    all.retain(|_, times| !times.is_empty());
    all
}

/// Ratios after / before, below 1 where it became quicker.
pub(super) fn compare(before: &Path, after: &Path, voice: &Voice) -> Result<(), Failure> {
    let [before, after] = [times(&read(before)?), times(&read(after)?)];
    let mut by_engine: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    let (mut rows, mut text) = (Vec::new(), String::new());
    for (key, new) in &after {
        let Some(old) = before.get(key) else { continue };
        let [low, middle, high] = ratio(old, new);
        let (definition, input, sites, engine) = key;
        by_engine.entry(engine).or_default().push(middle);
        let word = if high < 1.0 {
            "quicker"
        } else if low > 1.0 {
            "slower"
        } else {
            ""
        };
        text.push_str(&format!(
            "{definition:14} {input:18} {sites:>9} {engine:20} {:>10.3e} {:>10.3e}  {middle:.3} [{low:.3}, {high:.3}] {word}\n",
            median(old), median(new)
        ));
        rows.push(json!({
            "definition": definition, "input": input, "sites": sites, "engine": engine,
            "before": median(old), "after": median(new), "ratio": middle, "low": low, "high": high,
        }));
    }
    let means: BTreeMap<&str, f64> =
        by_engine.iter().map(|(engine, ratios)| (*engine, geometric_mean(ratios))).collect();
    if voice.json {
        println!(
            "{}",
            json!({ "schema": "delone.bench.compare/1", "rows": rows, "geometric_means": means })
        );
        return Ok(());
    }
    if rows.is_empty() {
        return Err(Failure::input("the two records have no engine and input in common"));
    }
    print!("{text}");
    for (engine, mean) in means {
        println!("{engine:20} geometric mean of its ratios {mean:.3}");
    }
    println!("Ratios after / before of medians, with bootstrap intervals of 95 %.");
    Ok(())
}
