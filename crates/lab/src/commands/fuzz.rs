//! `delone fuzz`: targets, budgets, shards; failures made small.

mod campaign;
pub(crate) mod files;
pub(crate) mod findings;
pub(crate) mod program;
mod shards;
mod state;

use std::sync::Arc;
use std::time::Duration;

use delone_laws::corpus::Corpus;
use delone_laws::fuzz::{Broken, Shard, Subject, Tally, Target, target, targets};
use serde_json::{Value, json};

use crate::cli;
use crate::failure::Failure;
use crate::progress::spinner;
use crate::{output, watch};
use campaign::Budget;
use findings::Kept;
use program::Program;
use state::Timed;

/// Seconds if no budget is given.
const SECONDS: f64 = 10.0;

pub(crate) fn fuzz(arguments: &cli::Fuzz) -> Result<(), Failure> {
    if arguments.list {
        return list(arguments);
    }
    let targets = chosen(arguments)?;
    let mut program = Program::new(&arguments.program)?;
    files::check_folder(&arguments.output)?;
    if let Some(k) = arguments.case {
        return again(arguments, &targets, k, &mut program);
    }
    watch::listen();
    let canary =
        if arguments.merge.is_none() { Some(campaign::canary(arguments.seed)?) } else { None };
    let seen = if let Some(folder) = &arguments.merge {
        merged(folder, &targets, arguments, None)?
    } else if let (Some(count), Some(folder)) = (arguments.shards, &arguments.state) {
        shards::run(arguments, &targets, count)?;
        merged(folder, &targets, arguments, Some(arguments.seed))?
    } else {
        run(arguments, &targets, &mut program)?
    };
    let mut kept = Vec::new();
    let bar = spinner(arguments.voice.quiet);
    bar.set_message("making failures small");
    if arguments.shard.is_none() {
        for Timed { tally, .. } in &seen {
            let target = targets.iter().find(|target| label(target, arguments) == tally.target);
            let target = target.expect("a tally is one of these targets'");
            kept.extend(findings::keep(target, tally, &mut program, &arguments.output)?);
        }
    }
    bar.finish_and_clear();
    tell(arguments, canary, &seen, &kept);
    if watch::is_interrupted() {
        return Err(Failure::Limit("interrupted; what was found until then is told".to_owned()));
    }
    let failed = seen.iter().any(|seen| !seen.tally.findings.is_empty());
    if failed { Err(Failure::Difference(None)) } else { Ok(()) }
}

/// What a target is called in tallies: with a program, or a corpus, a campaign of its own.
fn label(target: &Target, arguments: &cli::Fuzz) -> String {
    let mut label = target.name.to_owned();
    if let Some(program) = &arguments.program.program {
        label.push_str(&format!(" {program}"));
    }
    if !target.corpus().is_empty() {
        label.push_str(&format!(" with corpus {:016x}", target.corpus().digest()));
    }
    label
}

/// The targets asked for, or all but the canary; with a program, those whose answer is cells.
fn chosen(arguments: &cli::Fuzz) -> Result<Vec<Target>, Failure> {
    let judged = ["delaunay-2d", "delaunay-3d", "cdt"];
    let fits = |target: &Target| {
        if arguments.program.program.is_some() { judged.contains(&target.name) } else { true }
    };
    let corpus = Arc::new(match &arguments.corpus {
        Some(folder) => files::corpus(folder, arguments.voice.quiet)?,
        None => Corpus::default(),
    });
    let known = targets().into_iter().filter(|target| fits(target));
    let known: Vec<Target> = known.map(|target| target.with_corpus(corpus.clone())).collect();
    if arguments.targets.is_empty() {
        if arguments.program.program.is_some() {
            return Err(Failure::input(format!(
                "say what the program makes: {}",
                judged.join(", ")
            )));
        }
        return Ok(known.into_iter().filter(|target| !target.is_canary()).collect());
    }
    let find = |name: &String| {
        known.iter().find(|target| target.name == name).cloned().ok_or_else(|| {
            let names: Vec<&str> = known.iter().map(|target| target.name).collect();
            Failure::input(format!("no target is called {name}: there are {}", names.join(", ")))
        })
    };
    arguments.targets.iter().map(find).collect()
}

/// `I/N`.
fn shard(text: Option<&str>) -> Result<Shard, Failure> {
    let Some(text) = text else { return Ok(Shard::WHOLE) };
    let numbers = text
        .split_once('/')
        .and_then(|(part, parts)| Shard::of(part.parse().ok()?, parts.parse().ok()?));
    numbers.ok_or_else(|| Failure::input(format!("--shard {text}: say I/N with I below N, as 0/8")))
}

/// Runs all targets in this process, each for its part of the time.
fn run(
    arguments: &cli::Fuzz,
    targets: &[Target],
    program: &mut Option<Program>,
) -> Result<Vec<Timed>, Failure> {
    let shard = shard(arguments.shard.as_deref())?;
    let limited = arguments.seconds.or_else(|| arguments.cases.is_none().then_some(SECONDS));
    let count = u32::try_from(targets.len()).expect("a few targets");
    let each = limited.map(|seconds| Duration::try_from_secs_f64(seconds / f64::from(count)));
    let each = each.transpose().map_err(|error| Failure::input(format!("--seconds: {error}")))?;
    let budget = Budget { seconds: each, cases: arguments.cases, first: arguments.first };
    let (folder, quiet) = (arguments.state.as_deref(), arguments.voice.quiet);
    let mut all = Vec::new();
    for target in targets {
        let label = label(target, arguments);
        let saved = folder.map(|folder| state::path(folder, &label, arguments.seed, shard));
        let mut timed = match saved.filter(|path| path.is_file()) {
            Some(path) => state::load(&path)?,
            None => {
                let tally = Tally::new(target, arguments.seed, shard);
                Timed { tally: Tally { target: label, ..tally }, seconds: 0.0 }
            }
        };
        campaign::run(target, &mut timed, budget, program, folder, quiet)?;
        all.push(timed);
    }
    Ok(all)
}

/// The shards of a folder, merged by target; only those of a seed, if one is given.
fn merged(
    folder: &std::path::Path,
    targets: &[Target],
    arguments: &cli::Fuzz,
    seed: Option<u64>,
) -> Result<Vec<Timed>, Failure> {
    let mut all = Vec::new();
    for shards in state::load_all(folder)? {
        let wanted = |Timed { tally, .. }: &Timed| {
            targets.iter().any(|target| label(target, arguments) == tally.target)
                && seed.is_none_or(|seed| tally.seed == seed)
        };
        if shards.iter().all(wanted) {
            // They ran at one time.
            let seconds = shards.iter().map(|timed| timed.seconds).fold(0.0, f64::max);
            let tallies: Vec<Tally> = shards.into_iter().map(|timed| timed.tally).collect();
            let tally = Tally::merged(&tallies).map_err(|error| {
                Failure::input(format!("{}: {}: {error}", folder.display(), tallies[0].target))
            })?;
            all.push(Timed { tally, seconds });
        }
    }
    if all.is_empty() {
        let folder = folder.display();
        return Err(Failure::input(format!("{folder}: no shard is of such a campaign")));
    }
    Ok(all)
}

/// One case again: its outcome, and its input as a file.
fn again(
    arguments: &cli::Fuzz,
    targets: &[Target],
    k: u64,
    program: &mut Option<Program>,
) -> Result<(), Failure> {
    let [target] = targets else {
        return Err(Failure::input("--case is the number of one target's case: name the target"));
    };
    let input = target.case(arguments.seed, k);
    let outcome = match program {
        Some(program) => program.try_on(&input),
        None => (&mut &*target).try_on(&input),
    };
    let none = Broken { law: "none".into(), place: "nothing broke".into(), message: String::new() };
    let broken = outcome.as_ref().err().unwrap_or(&none);
    let name = format!("{}-seed-{}-case-{k}", target.name, arguments.seed);
    let file = files::path(&arguments.output, &name, &input);
    files::keep(&file, &input, broken)?;
    if arguments.voice.json {
        let ok = outcome.is_ok();
        println!(
            "{}",
            json!({
                "schema": "delone.fuzz.case/1", "target": target.name, "seed": arguments.seed, "case": k, "ok": ok,
                "law": broken.law, "place": broken.place, "message": broken.message, "file": file.to_string_lossy(),
            })
        );
    } else {
        println!("{} points, {} segments: {}", input.points(), input.segments(), file.display());
        println!(
            "{}",
            if outcome.is_ok() { "every law holds".to_owned() } else { broken.to_string() }
        );
    }
    if outcome.is_ok() { Ok(()) } else { Err(Failure::Difference(None)) }
}

fn tell(arguments: &cli::Fuzz, canary: Option<u64>, seen: &[Timed], kept: &[Kept]) {
    if arguments.voice.json {
        println!("{}", json(arguments, canary, seen, kept));
        return;
    }
    if let Some(case) = canary {
        println!("canary         dies in case {case}, as it must");
    }
    for Timed { tally, seconds } in seen {
        println!(
            "{:14} {} cases, {:.0} a second, {} kinds of failure, digest {:016x}",
            tally.target,
            tally.executions,
            per_second(tally, *seconds),
            tally.findings.len(),
            tally.digest
        );
    }
    kept.iter().for_each(|kept| print!("{}", kept.text(arguments)));
}

/// Cases a second, of all shards together; of those run now and before alike if a campaign was resumed.
#[expect(clippy::cast_precision_loss, reason = "a rate for people")]
fn per_second(tally: &Tally, seconds: f64) -> f64 {
    tally.executions as f64 / seconds.max(1e-9)
}

fn json(arguments: &cli::Fuzz, canary: Option<u64>, seen: &[Timed], kept: &[Kept]) -> Value {
    let row = |Timed { tally, seconds }: &Timed| {
        json!({
            "target": tally.target,
            "executions": tally.executions,
            "seconds": seconds,
            "per_second": per_second(tally, *seconds),
            "digest": format!("{:016x}", tally.digest),
            "tried": tally.tried,
            "failures": tally.findings.len(),
        })
    };
    json!({
        "schema": "delone.fuzz/1",
        "seed": arguments.seed,
        "canary": canary,
        "executions": seen.iter().map(|seen| seen.tally.executions).sum::<u64>(),
        "targets": seen.iter().map(row).collect::<Vec<_>>(),
        "failures": kept.iter().map(Kept::json).collect::<Vec<_>>(),
    })
}

fn list(arguments: &cli::Fuzz) -> Result<(), Failure> {
    let rows = targets();
    if arguments.voice.json {
        let row = |t: &Target| json!({ "target": t.name, "about": t.about, "laws": t.laws() });
        let rows: Vec<Value> = rows.iter().map(row).collect();
        println!("{}", json!({ "schema": "delone.fuzz.targets/1", "targets": rows }));
        return Ok(());
    }
    let line =
        |t: &Target| format!("{:14} {}\n{:14}   {}\n", t.name, t.about, "", t.laws().join(", "));
    output::print_bytes(rows.iter().map(line).collect::<String>().as_bytes())
}

/// The target whose laws an input is put under, if none is named.
pub(crate) fn target_for(
    name: Option<&str>,
    input: &delone_laws::fuzz::Input,
) -> Result<Target, Failure> {
    let fitting = match input {
        delone_laws::fuzz::Input::Space(_) => "delaunay-3d",
        delone_laws::fuzz::Input::Plane(case) if case.segments.is_empty() => "delaunay-2d",
        delone_laws::fuzz::Input::Plane(_) => "cdt",
        delone_laws::fuzz::Input::File(_) => files::READERS,
    };
    let name = name.unwrap_or(fitting);
    target(name).ok_or_else(|| Failure::input(format!("no target is called {name}")))
}
