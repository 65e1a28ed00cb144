//! `delone bench`: engines side by side on one input, each in a process of its own, each judged once before its times count.

mod compare;
mod definition;
mod numbers;
mod record;
mod report;
mod turn;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::time::Duration;

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
use turn::{Fault, Files, Turn, root};

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
    let mut session = Session {
        arguments,
        engines: &engines.engine,
        records: Vec::new(),
        slow: BTreeSet::new(),
        wrong: Wrong::default(),
        bar,
    };
    for definition in &definitions {
        session.run(definition)?;
    }
    session.bar.finish_and_clear();
    let Session { records, wrong, .. } = session;
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
    let fails = wrong.ours > 0 || (arguments.strict && wrong.peers > 0);
    if fails { Err(Failure::Difference(None)) } else { Ok(()) }
}

/// Answers that are wrong. Those of peers have no time, and are no fault of this program.
#[derive(Default)]
struct Wrong {
    ours: usize,
    peers: usize,
}

impl Wrong {
    fn note(&mut self, ours: bool) {
        if ours {
            self.ours += 1;
        } else {
            self.peers += 1;
        }
    }
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
        check(&definition, engines).map_err(|why| {
            let path = path.display();
            Failure::input(format!("{path}: {why}"))
        })?;
        all.push(definition);
    }
    Ok(all)
}

/// Everything a definition names must be there, before anything is run.
fn check(definition: &Definition, engines: &Engines) -> Result<(), String> {
    for name in &definition.engines {
        if !engines.engine.iter().any(|engine| engine.name == *name) {
            return Err(format!("no engine is called {name}"));
        }
    }
    for input in &definition.inputs {
        find(&input.workload).map_err(|error| error.to_string())?;
    }
    for file in &definition.files {
        std::fs::metadata(&file.path)
            .map_err(|error| format!("{}: {error}", file.path.display()))?;
    }
    Ok(())
}

struct Session<'s> {
    arguments: &'s cli::Bench,
    engines: &'s [Engine],
    records: Vec<Record>,
    /// Definition, input and engine of turns that took too long.
    slow: BTreeSet<[String; 3]>,
    wrong: Wrong,
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
                if self.is_left_out(n) {
                    continue;
                }
                let mut document = document_of(&input.workload, &workload.generate(n, input.seed));
                document.segments.truncate(input.segments.unwrap_or(usize::MAX));
                self.run_on(definition, input.label(), document, answer, folder.path())?;
            }
        }
        for file in &definition.files {
            let document = crate::input::read(&file.path, None)?;
            if !self.is_left_out(document.point_count()) {
                let label = document.name.clone();
                self.run_on(definition, label, document, &file.answer, folder.path())?;
            }
        }
        Ok(())
    }

    fn is_left_out(&self, sites: usize) -> bool {
        self.arguments.sites_max.is_some_and(|most| sites > most) || watch::is_interrupted()
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
    fn run_on(
        &mut self,
        definition: &Definition,
        input: String,
        document: Document,
        answer: &str,
        folder: &Path,
    ) -> Result<(), Failure> {
        let ending = if definition.task == Task::Cdt { "poly" } else { "node" };
        let (given, written) = (folder.join(format!("in.{ending}")), folder.join("out.ele"));
        output::document(&given, &document)?;
        let instance = &Instance { definition, input, document, given, answer };
        let mut engines = self.engines(definition);
        for round in 0..self.arguments.rounds.unwrap_or(definition.rounds) {
            let mut left = Vec::new();
            for engine in engines {
                if watch::is_interrupted() {
                    return Ok(());
                }
                let (input, sites) = (&instance.input, instance.document.point_count());
                let task = &definition.name;
                self.bar.set_message(format!("{task}: {input}, {sites} sites, {}", engine.name));
                let outcome = self.turn(&engine, instance, &written, round);
                if watch::is_interrupted() {
                    return Ok(()); // what was interrupted says nothing
                }
                if self.told_of(&engine, instance, round, outcome) {
                    left.push(engine);
                }
            }
            engines = left;
        }
        Ok(())
    }

    /// One turn, judged if it is the first.
    fn turn(
        &self,
        engine: &Engine,
        instance: &Instance<'_>,
        written: &Path,
        round: u32,
    ) -> Result<Turn, Fault> {
        let definition = instance.definition;
        if self.slow.contains(&instance.of(engine)) {
            return Err(Fault::Slow("it was too slow on fewer sites".to_owned()));
        }
        let files = Files { given: &instance.given, written };
        let turn =
            turn::run(engine, definition.task, &files, definition.times, definition.limit()?)?;
        if round == 0 {
            turn::verdict(engine, &turn, &instance.document, written, instance.answer)?;
        }
        Ok(turn)
    }

    /// Records a turn; whether the engine has another one.
    fn told_of(
        &mut self,
        engine: &Engine,
        instance: &Instance<'_>,
        round: u32,
        outcome: Result<Turn, Fault>,
    ) -> bool {
        let blank = instance.record(engine, round);
        let fault = match outcome {
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
                return true;
            }
            Err(fault) => fault,
        };
        match &fault {
            Fault::Wrong(_) => self.wrong.note(engine.ours),
            // Ours refuse nothing that a definition asks for.
            Fault::Refused(_) if engine.ours => self.wrong.note(true),
            Fault::Slow(_) => {
                self.slow.insert(instance.of(engine));
            }
            Fault::Refused(_) | Fault::Absent(_) => {}
        }
        // Times posted before are taken back.
        self.records.retain(|record| !record.is_of(&blank));
        self.records.push(Record { verdict: told(&fault), ..blank });
        false
    }

    /// Programs that print a table of calls: `| cell | name: median (low..high) | ..`, `(x)` after what is wrong.
    fn run_tables(&mut self, definition: &Definition) {
        let nowhere = Path::new("");
        let files = Files { given: nowhere, written: nowhere };
        let rounds = self.arguments.rounds.unwrap_or(definition.rounds);
        for engine in self.engines(definition) {
            if watch::is_interrupted() {
                return;
            }
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
            let limit = definition.limit();
            match limit.and_then(|limit| turn::run(&engine, definition.task, &files, rounds, limit))
            {
                Ok(turn) => {
                    let rows = table_rows(&turn.text, &blank);
                    for row in rows.iter().filter(|row| row.time.is_none()) {
                        self.wrong.note(definition.ours.contains(&row.engine));
                    }
                    self.records.extend(rows);
                }
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

impl Definition {
    /// What a turn may take.
    fn limit(&self) -> Result<Duration, Fault> {
        Duration::try_from_secs_f64(self.limit)
            .map_err(|error| Fault::Refused(format!("limit = {}: {error}", self.limit)))
    }
}

impl Instance<'_> {
    fn of(&self, engine: &Engine) -> [String; 3] {
        [&self.definition.name, &self.input, &engine.name].map(String::clone)
    }

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
