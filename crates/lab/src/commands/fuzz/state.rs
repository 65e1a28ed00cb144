//! Tallies as files: one for each target and shard, whole or not there, read again by whoever goes on or merges.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use delone_laws::fuzz::{Broken, Finding, Shard, Tally};
use serde_json::{Map, Value, json};

use crate::failure::Failure;
use crate::output;

const SCHEMA: &str = "delone.fuzz.shard/1";

/// The file of a tally.
pub(crate) fn path(folder: &Path, target: &str, seed: u64, shard: Shard) -> PathBuf {
    let [part, parts] = shard.parts();
    let name: String =
        target.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
    folder.join(format!("{name}.seed-{seed}.{part}-of-{parts}.json"))
}

/// A tally, and the seconds that it took.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Timed {
    pub(crate) tally: Tally,
    pub(crate) seconds: f64,
}

/// Writes a tally.
pub(crate) fn save(folder: &Path, timed: &Timed) -> Result<(), Failure> {
    let tally = &timed.tally;
    std::fs::create_dir_all(folder).map_err(Failure::input)?;
    let path = path(folder, &tally.target, tally.seed, tally.shard);
    output::text(&path, &format!("{}\n", to_json(timed)))
}

/// The tally of a file.
pub(crate) fn load(path: &Path) -> Result<Timed, Failure> {
    let refuse = |why: &str| Failure::input(format!("{}: {why}", path.display()));
    let text = std::fs::read_to_string(path).map_err(|error| refuse(&error.to_string()))?;
    let value: Value = serde_json::from_str(&text).map_err(|error| refuse(&error.to_string()))?;
    from_json(&value).ok_or_else(|| refuse("this is no shard of a fuzzing campaign"))
}

/// All tallies in a folder, by target and seed.
pub(crate) fn load_all(folder: &Path) -> Result<Vec<Vec<Timed>>, Failure> {
    let entries = std::fs::read_dir(folder)
        .map_err(|error| Failure::input(format!("{}: {error}", folder.display())))?;
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "json"));
    paths.sort();
    let mut all: BTreeMap<(String, u64), Vec<Timed>> = BTreeMap::new();
    for path in paths {
        let timed = load(&path)?;
        let campaign = (timed.tally.target.clone(), timed.tally.seed);
        all.entry(campaign).or_default().push(timed);
    }
    Ok(all.into_values().collect())
}

fn to_json(Timed { tally, seconds }: &Timed) -> Value {
    let findings = tally.findings.iter().map(|(bucket, finding)| {
        json!({
            "bucket": bucket,
            "case": finding.case,
            "law": finding.broken.law,
            "place": finding.broken.place,
            "message": finding.broken.message,
            "seen": finding.seen,
        })
    });
    json!({
        "schema": SCHEMA,
        "target": tally.target,
        "seed": tally.seed,
        "shard": tally.shard.parts(),
        "executions": tally.executions,
        "seconds": seconds,
        "digest": format!("{:016x}", tally.digest),
        "tried": tally.tried,
        "findings": findings.collect::<Vec<_>>(),
    })
}

fn from_json(value: &Value) -> Option<Timed> {
    let text = |value: &Value, key: &str| value.get(key)?.as_str().map(str::to_owned);
    let number = |value: &Value, key: &str| value.get(key)?.as_u64();
    let shard = value.get("shard")?.as_array()?;
    let tried: &Map<String, Value> = value.get("tried")?.as_object()?;
    let finding = |value: &Value| {
        let [law, place, message] = ["law", "place", "message"].map(|key| text(value, key));
        let broken = Broken { law: law?, place: place?, message: message? };
        let finding =
            Finding { case: number(value, "case")?, broken, seen: number(value, "seen")? };
        Some((text(value, "bucket")?, finding))
    };
    (text(value, "schema")? == SCHEMA).then_some(())?;
    let tally = Tally {
        target: text(value, "target")?,
        seed: number(value, "seed")?,
        shard: Shard::of(shard.first()?.as_u64()?, shard.get(1)?.as_u64()?)?,
        executions: number(value, "executions")?,
        digest: u64::from_str_radix(&text(value, "digest")?, 16).ok()?,
        tried: tried
            .iter()
            .map(|(law, times)| Some((law.clone(), times.as_u64()?)))
            .collect::<Option<_>>()?,
        findings: value.get("findings")?.as_array()?.iter().map(finding).collect::<Option<_>>()?,
    };
    Some(Timed { tally, seconds: value.get("seconds")?.as_f64()? })
}

#[cfg(test)]
mod tests;
