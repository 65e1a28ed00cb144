//! Failures: made small, kept in files, told.

use std::path::{Path, PathBuf};

use delone_laws::Effort;
use delone_laws::fuzz::{Broken, Finding, Input, Subject, Tally, Target};
use serde_json::{Value, json};

use super::files;
use super::program::Program;
use crate::cli;
use crate::failure::Failure;

/// A failure with the small input that shows it.
pub(crate) struct Kept {
    target: &'static str,
    seed: u64,
    finding: Finding,
    file: PathBuf,
    points: usize,
    segments: usize,
}

/// Smaller inputs tried for all failures of a target together, and at least for each.
const TESTS_MAX: usize = 6000;
const TESTS_MIN: usize = 300;

/// Makes each failure of a tally small, and writes it.
pub(crate) fn keep(
    target: &Target,
    tally: &Tally,
    program: &mut Option<Program>,
    folder: &Path,
) -> Result<Vec<Kept>, Failure> {
    let mut kept = Vec::new();
    let tests = TESTS_MAX / tally.findings.len().max(1);
    for finding in tally.findings.values() {
        let input = target.case(tally.seed, finding.case);
        let mut run = |input: &Input| match program {
            Some(program) => program.try_on(input).err(),
            None => (&mut &*target).try_on(input).err(),
        };
        let small = smallest(&input, &finding.broken, tests.max(TESTS_MIN), &mut run);
        // What is said is said of the small one.
        let broken = run(&small).unwrap_or_else(|| finding.broken.clone());
        let law = finding.broken.law.replace(' ', "-");
        let name = format!("{}-{law}-seed-{}-case-{}", target.name, tally.seed, finding.case);
        let file = files::path(folder, &name, &small);
        files::keep(&file, &small, &broken)?;
        kept.push(Kept {
            target: target.name,
            seed: tally.seed,
            finding: Finding { broken, ..finding.clone() },
            file,
            points: small.points(),
            segments: small.segments(),
        });
    }
    Ok(kept)
}

/// The smallest input found that breaks the same law at the same place.
pub(crate) fn smallest(
    input: &Input,
    broken: &Broken,
    tests: usize,
    mut run: impl FnMut(&Input) -> Option<Broken>,
) -> Input {
    let same = |other: &Broken| (&other.law, &other.place) == (&broken.law, &broken.place);
    input.shrunk(&mut Effort { tests }, |input| run(input).is_some_and(|other| same(&other)))
}

impl Kept {
    pub(crate) fn json(&self) -> Value {
        json!({
            "target": self.target,
            "law": self.finding.broken.law,
            "file": self.file.to_string_lossy(),
            "place": self.finding.broken.place,
            "message": self.finding.broken.message,
            "seed": self.seed,
            "case": self.finding.case,
            "seen": self.finding.seen,
            "points": self.points,
            "segments": self.segments,
        })
    }

    /// For people: what broke, where the input is, how to see it again.
    pub(crate) fn text(&self, arguments: &cli::Fuzz) -> String {
        let Broken { law, place, message } = &self.finding.broken;
        let said = message.lines().find(|line| !line.trim().is_empty()).unwrap_or("").trim();
        let program = arguments.program.program.iter();
        let corpus = arguments.corpus.iter();
        let with: String = program
            .map(|command| format!(" --program '{command}'"))
            .chain(corpus.map(|folder| format!(" --corpus '{}'", folder.display())))
            .collect();
        format!(
            "FAILED {}: {law} at {place}, in {} cases\n  {said}\n  smallest: {} ({} points, {} segments)\n  \
             again: delone fuzz {} --seed {} --case {}{with}\n",
            self.target,
            self.finding.seen,
            self.file.display(),
            self.points,
            self.segments,
            self.target,
            self.seed,
            self.finding.case,
        )
    }
}
