//! `delone bench`: engines side by side on one input, each in a process of its own, each judged once before its times count.

mod compare;
mod definition;
mod numbers;
mod record;
mod report;
mod turn;

use std::path::{Path, PathBuf};

use delone_formats::Document;
use delone_workloads::find;
use indicatif::ProgressBar;
use serde_json::{Value, json};

use crate::cli;
use crate::failure::Failure;
use crate::progress::spinner;
use crate::subject::document_of;
use crate::{output, watch};
use definition::{Definition, Engine, Engines, Task};
use record::Record;
use turn::{Fault, Files, root};

pub(crate) fn bench(arguments: &cli::Bench) -> Result<(), Failure> {
    if let Some(cli::BenchAction::Compare { before, after, voice }) = &arguments.action {
        return compare::compare(before, after, voice);
    }
    let files = arguments.csv.iter().chain(&arguments.html).chain(&arguments.latex);
    output::check_paths(files.map(PathBuf::as_path))?;
    let engines_path = arguments.engines.clone();
    let engines: Engines =
        definition::read(&engines_path.unwrap_or_else(|| root().join("benches/engines.toml")))?;
    let definitions = definitions(arguments, &engines)?;
    watch::listen();
    let bar = spinner(arguments.voice.quiet);
    let mut session = Session { arguments, engines: &engines.engine, records: Vec::new(), bar };
    for definition in &definitions {
        session.run(definition)?;
    }
    session.bar.finish_and_clear();
    let records = session.records;
    if let Some(path) = &arguments.csv {
        output::text(path, &record::csv(&records))?;
    }
    if let Some(path) = &arguments.html {
        output::text(path, &report::page(&definitions, &records))?;
    }
    if let Some(path) = &arguments.latex {
        output::text(path, &report::latex(&definitions, &records))?;
    }
    if arguments.voice.json {
        println!("{}", json(&records));
    } else {
        print!("{}", report::text(&definitions, &records));
    }
    if watch::is_interrupted() {
        return Err(Failure::Limit("interrupted; what was run until then is told".to_owned()));
    }
    let wrong = records.iter().any(|record| record.verdict.starts_with("WRONG"));
    if wrong { Err(Failure::Difference(None)) } else { Ok(()) }
}

/// The definitions asked for, or all there are; their engines must be known.
fn definitions(arguments: &cli::Bench, engines: &Engines) -> Result<Vec<Definition>, Failure> {
    let mut paths = arguments.definitions.clone();
    if paths.is_empty() {
        let folder = root().join("benches/definitions");
        let entries = std::fs::read_dir(&folder)
            .map_err(|error| Failure::input(format!("{}: {error}", folder.display())))?;
        paths = entries.flatten().map(|entry| entry.path()).collect();
        paths.sort();
    }
    let mut all = Vec::new();
    for path in paths {
        let definition: Definition = definition::read(&path)?;
        for name in &definition.engines {
            if !engines.engine.iter().any(|engine| engine.name == *name) {
                let path = path.display();
                return Err(Failure::input(format!("{path}: no engine is called {name}")));
            }
        }
        all.push(definition);
    }
    Ok(all)
}

struct Session<'s> {
    arguments: &'s cli::Bench,
    engines: &'s [Engine],
    records: Vec<Record>,
    bar: ProgressBar,
}

/// An input, with its file and its answer.
struct Instance<'i> {
    definition: &'i Definition,
    input: String,
    document: Document,
    given: PathBuf,
    answer: &'i str,
}

impl Session<'_> {
    fn run(&mut self, definition: &Definition) -> Result<(), Failure> {
        if definition.task == Task::Table {
            self.run_tables(definition);
            return Ok(());
        }
        let folder = tempfile::tempdir().map_err(Failure::input)?;
        for input in &definition.inputs {
            let workload = find(&input.workload).map_err(Failure::input)?;
            for (n, answer) in input.sizes()? {
                if self.arguments.sites_max.is_some_and(|most| n > most) || watch::is_interrupted()
                {
                    continue;
                }
                let document = document_of(&input.workload, &workload.generate(n, input.seed));
                let ending = if definition.task == Task::Cdt { "poly" } else { "node" };
                let given = folder.path().join(format!("in.{ending}"));
                output::document(&given, &document)?;
                let input = input.workload.clone();
                self.run_on(
                    &Instance { definition, input, document, given, answer },
                    folder.path(),
                );
            }
        }
        Ok(())
    }

    /// The engines of a definition that are asked for.
    fn engines(&self, definition: &Definition) -> Vec<Engine> {
        let only = &self.arguments.only;
        let wanted =
            definition.engines.iter().filter(|name| only.is_empty() || only.contains(name));
        let find = |name: &String| self.engines.iter().find(|engine| engine.name == *name).cloned();
        wanted.filter_map(find).collect()
    }

    /// All engines take turns, round by round; those that are wrong have no further turn, and no time.
    fn run_on(&mut self, instance: &Instance<'_>, folder: &Path) {
        let definition = instance.definition;
        let written = folder.join("out.ele");
        let files = Files { given: &instance.given, written: &written };
        let mut engines = self.engines(definition);
        for round in 0..self.arguments.rounds.unwrap_or(definition.rounds) {
            engines.retain(|engine| {
                let (input, sites) = (&instance.input, instance.document.point_count());
                let task = &definition.name;
                self.bar.set_message(format!("{task}: {input}, {sites} sites, {}", engine.name));
                let turn = turn::run(engine, definition.task, &files, definition.times);
                let outcome = turn.and_then(|turn| {
                    if round == 0 {
                        let (document, answer) = (&instance.document, instance.answer);
                        turn::verdict(engine, &turn, document, &written, answer)?;
                    }
                    Ok(turn)
                });
                let blank = instance.record(engine, round);
                match outcome {
                    Ok(turn) => {
                        let counts = turn.counts.iter().map(|(name, n)| format!("{name}={n}"));
                        let row = Record {
                            verdict: "ok".to_owned(),
                            version: turn.version,
                            fingerprint: turn.fingerprint,
                            counts: counts.collect::<Vec<_>>().join(" "),
                            ..blank
                        };
                        let timed = |&time: &f64| Record { time: Some(time), ..row.clone() };
                        self.records.extend(turn.seconds.iter().map(timed));
                        true
                    }
                    Err(fault) => {
                        // Times posted before are taken back.
                        let same = |r: &Record| r.is_of(&blank);
                        self.records.retain(|record| !same(record));
                        self.records.push(Record { verdict: told(&fault), ..blank });
                        false
                    }
                }
            });
        }
    }

    /// Programs that print a table of calls: `| cell | name: median (low..high) | ..`, `(x)` after what is wrong.
    fn run_tables(&mut self, definition: &Definition) {
        let nowhere = Path::new("");
        let files = Files { given: nowhere, written: nowhere };
        let rounds = self.arguments.rounds.unwrap_or(definition.rounds);
        for engine in self.engines(definition) {
            self.bar.set_message(format!("{}: {}", definition.name, engine.name));
            let blank = Record {
                definition: definition.name.clone(),
                input: String::new(),
                sites: 0,
                segments: 0,
                engine: engine.name.clone(),
                version: String::new(),
                round: 0,
                time: None,
                verdict: String::new(),
                fingerprint: String::new(),
                counts: String::new(),
            };
            match turn::run(&engine, definition.task, &files, rounds) {
                Ok(turn) => self.records.extend(table_rows(&turn.text, &blank)),
                Err(fault) => self.records.push(Record { verdict: told(&fault), ..blank }),
            }
        }
    }
}

fn told(fault: &Fault) -> String {
    format!("{}: {}", fault.word(), fault.why())
}

fn table_rows(text: &str, blank: &Record) -> Vec<Record> {
    let mut rows = Vec::new();
    for line in text.lines().filter(|line| line.starts_with('|')) {
        let mut cells = line.trim_matches('|').split('|').map(str::trim);
        let input = cells.next().unwrap_or("");
        for cell in cells {
            let Some((engine, rest)) = cell.rsplit_once(": ") else { continue };
            let median = rest.split_whitespace().next().and_then(|word| word.parse().ok());
            let wrong = rest.ends_with("(x)");
            rows.push(Record {
                input: input.to_owned(),
                engine: engine.to_owned(),
                time: median.filter(|_| !wrong),
                verdict: if wrong {
                    "wrong: its tally of signs is not the exact one".to_owned()
                } else {
                    "ok".to_owned()
                },
                ..blank.clone()
            });
        }
    }
    rows
}

impl Instance<'_> {
    fn record(&self, engine: &Engine, round: u32) -> Record {
        Record {
            definition: self.definition.name.clone(),
            input: self.input.clone(),
            sites: self.document.point_count(),
            segments: self.document.segments.len(),
            engine: engine.name.clone(),
            version: String::new(),
            round,
            time: None,
            verdict: String::new(),
            fingerprint: String::new(),
            counts: String::new(),
        }
    }
}

impl Record {
    /// Whether both are of one engine on one input of one definition.
    fn is_of(&self, other: &Self) -> bool {
        (&self.definition, &self.input, self.sites, &self.engine)
            == (&other.definition, &other.input, other.sites, &other.engine)
    }
}

fn json(records: &[Record]) -> Value {
    let row = |r: &Record| {
        json!({
            "definition": r.definition, "input": r.input, "sites": r.sites, "segments": r.segments, "engine": r.engine,
            "round": r.round, "time": r.time, "verdict": r.verdict, "fingerprint": r.fingerprint, "counts": r.counts,
        })
    };
    json!({ "schema": "delone.bench/1", "records": records.iter().map(row).collect::<Vec<_>>() })
}
