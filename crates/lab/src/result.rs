//! What a command says of its result: one JSON object for scripts, a short table for people.

use delone_check::Verdict;
use delone_probe::Counts;
use serde_json::{Map, Value, json};

use crate::engine::Sizes;
use crate::subject::{Body, Subject};

/// Seconds by phase, in the order in which they passed.
#[derive(Clone, Copy, Default)]
pub(crate) struct Seconds {
    pub(crate) read: f64,
    pub(crate) build: f64,
    pub(crate) check: Option<f64>,
    pub(crate) write: Option<f64>,
}

/// Everything that a triangulating command has to tell.
pub(crate) struct Outcome<'s> {
    pub(crate) schema: &'static str,
    pub(crate) subject: &'s Subject,
    pub(crate) algorithm: &'static str,
    pub(crate) kernel: &'static str,
    pub(crate) fingerprint: String,
    pub(crate) sizes: Sizes,
    pub(crate) seconds: Seconds,
    pub(crate) counts: Option<Counts>,
    pub(crate) verdict: Option<Verdict>,
    /// Keys that only this command has.
    pub(crate) extra: Map<String, Value>,
    pub(crate) notes: Vec<String>,
}

impl Outcome<'_> {
    pub(crate) fn json(&self) -> Value {
        let Seconds { read, build, check, write } = self.seconds;
        let mut seconds = json!({ "read": read, "build": build });
        if let Some(check) = check {
            seconds["check"] = json!(check);
        }
        if let Some(write) = write {
            seconds["write"] = json!(write);
        }
        let mut object = json!({
            "schema": self.schema,
            "input": input(self.subject),
            "algorithm": self.algorithm,
            "kernel": self.kernel,
            "fingerprint": self.fingerprint,
            "dimension": self.sizes.dimension,
            "vertices": self.sizes.vertices,
            "cells": self.sizes.cells,
            "hull_facets": self.sizes.hull_facets,
            "seconds": seconds,
        });
        if let Some(counts) = &self.counts {
            object["counts"] = self::counts(counts);
        }
        if let Some(verdict) = &self.verdict {
            object["check"] = check_value(verdict);
        }
        for (key, value) in &self.extra {
            object[key] = value.clone();
        }
        object
    }

    /// The table for people.
    pub(crate) fn text(&self) -> String {
        let Seconds { read, build, check, write } = self.seconds;
        let mut rows: Vec<(&str, String)> = vec![
            ("input", describe(self.subject)),
            ("algorithm", format!("{} ({} kernel)", self.algorithm, self.kernel)),
            ("dimension", self.sizes.dimension.map_or("none".to_owned(), |k| k.to_string())),
            ("cells", grouped(self.sizes.cells as u64)),
            ("hull facets", grouped(self.sizes.hull_facets as u64)),
            ("fingerprint", self.fingerprint.clone()),
        ];
        let mut spent =
            vec![format!("read {}", seconds(read)), format!("build {}", seconds(build))];
        spent.extend(check.map(|check| format!("check {}", seconds(check))));
        spent.extend(write.map(|write| format!("write {}", seconds(write))));
        rows.push(("seconds", spent.join(", ")));
        for (key, value) in &self.extra {
            let told =
                value.as_array().map_or(value.to_string(), |list| grouped(list.len() as u64));
            rows.push((key, told));
        }
        if let Some(counts) = &self.counts {
            let counts = counts.named().into_iter().filter(|&(_, count)| count > 0);
            let counts: Vec<String> = counts
                .map(|(name, count)| format!("{} {}", grouped(count), name.replace('_', " ")))
                .collect();
            rows.push(("counts", counts.join(", ")));
        }
        let mut text: String =
            rows.iter().map(|(name, value)| format!("{name:12} {value}\n")).collect();
        if let Some(verdict) = &self.verdict {
            text.push_str(&verdict_text(verdict));
        }
        text
    }
}

/// The lines that tell a verdict to people.
pub(crate) fn verdict_text(verdict: &Verdict) -> String {
    let level = if verdict.ok { verdict.level.name() } else { "NOT PROVED" };
    let mut text = format!("{:12} {level}, {} ties\n", "check", grouped(verdict.ties as u64));
    for (place, claim) in verdict.proved.iter().enumerate() {
        let label = if place == 0 { "proved" } else { "" };
        text.push_str(&format!("{label:12} {claim}\n"));
    }
    for fault in &verdict.faults {
        text.push_str(&format!("{:12} {fault}\n", "fault"));
    }
    for (kind, &count) in &verdict.counts {
        let told = verdict.faults.iter().filter(|fault| fault.kind() == *kind).count();
        if told < count {
            text.push_str(&format!("{:12} and {} more of {kind}\n", "", count - told));
        }
    }
    text
}

pub(crate) fn check_value(verdict: &Verdict) -> Value {
    let faults: Vec<String> = verdict.faults.iter().map(ToString::to_string).collect();
    json!({
        "ok": verdict.ok,
        "level": verdict.level.name(),
        "proved": verdict.proved,
        "faults": faults,
        "fault_counts": verdict.counts,
        "ties": verdict.ties,
    })
}

pub(crate) fn counts(counts: &Counts) -> Value {
    let named = counts.named().into_iter().map(|(name, count)| (name.to_owned(), json!(count)));
    Value::Object(named.collect())
}

pub(crate) fn input(subject: &Subject) -> Value {
    let mut object = json!({
        "path": subject.name(),
        "sites": subject.site_count(),
        "duplicates": subject.duplicate_count(),
        "segments": subject.document.segments.len(),
    });
    let noded = match &subject.body {
        Body::Graph(pslg) => Some((pslg.subsegments().len(), pslg.dropped())),
        Body::Crossed(graph) => Some((graph.subsegments().len(), graph.dropped())),
        _ => None,
    };
    if let Some((subsegments, dropped)) = noded {
        object["subsegments"] = json!(subsegments);
        object["dropped_segments"] = json!(dropped);
    }
    object
}

pub(crate) fn describe(subject: &Subject) -> String {
    let mut parts = vec![format!("{} sites", grouped(subject.site_count() as u64))];
    if subject.duplicate_count() > 0 {
        parts.push(format!("{} duplicates", grouped(subject.duplicate_count() as u64)));
    }
    if let Body::Graph(_) | Body::Crossed(_) = &subject.body {
        parts.push(format!("{} segments", grouped(subject.document.segments.len() as u64)));
    }
    format!("{}: {}", subject.name(), parts.join(", "))
}

/// A number with its digits in groups of three.
pub(crate) fn grouped(number: u64) -> String {
    indicatif::HumanCount(number).to_string()
}

/// Seconds with three digits that say something.
pub(crate) fn seconds(seconds: f64) -> String {
    if seconds >= 1.0 {
        format!("{seconds:.2} s")
    } else if seconds >= 1e-3 {
        format!("{:.2} ms", seconds * 1e3)
    } else {
        format!("{:.0} us", seconds * 1e6)
    }
}
