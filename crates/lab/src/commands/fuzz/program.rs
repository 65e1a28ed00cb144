//! Another program as the subject: it is given a file, and the judge is given what it writes.

use std::fs::File;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use delone_check::Options;
use delone_formats::Format;
use delone_laws::case::Case;
use delone_laws::foreign::{is_solid, judged};
use delone_laws::fuzz::{Broken, Input, Subject};
use wait_timeout::ChildExt;

use super::files;
use crate::cli;
use crate::commands::check;
use crate::failure::Failure;
use crate::output;

/// A command, and a folder of its own for its files.
pub(crate) struct Program {
    words: Vec<String>,
    timeout: Duration,
    accepts_refusal: bool,
    in_ending: Option<String>,
    out_ending: String,
    folder: tempfile::TempDir,
}

impl Program {
    /// The program that the arguments name, if any.
    pub(crate) fn new(arguments: &cli::Program) -> Result<Option<Self>, Failure> {
        let Some(command) = &arguments.program else { return Ok(None) };
        let words = shlex::split(command).filter(|words| !words.is_empty());
        let words = words
            .ok_or_else(|| Failure::input(format!("--program {command}: a quote is left open")))?;
        for place in ["{in}", "{out}"] {
            if !words.iter().any(|word| word.contains(place)) {
                return Err(Failure::input(format!("--program {command}: there is no {place}")));
            }
        }
        let timeout = Duration::try_from_secs_f64(arguments.timeout)
            .map_err(|error| Failure::input(format!("--timeout {}: {error}", arguments.timeout)))?;
        for ending in arguments.in_ending.iter().chain([&arguments.out_ending]) {
            if Format::from_path(&format!("file.{ending}")).is_none() {
                return Err(Failure::input(format!("no format ends in .{ending}")));
            }
        }
        Ok(Some(Self {
            words,
            timeout,
            accepts_refusal: arguments.accept_refusal,
            in_ending: arguments.in_ending.clone(),
            out_ending: arguments.out_ending.clone(),
            folder: tempfile::tempdir().map_err(Failure::input)?,
        }))
    }

    /// Runs it on a case and judges what it wrote.
    fn judge<const D: usize>(&self, input: &Input, case: &Case<D>) -> Result<usize, Broken> {
        if !is_solid(case) {
            return Ok(0);
        }
        let ending = self.in_ending.as_deref();
        let ending = ending.unwrap_or(if case.segments.is_empty() { "node" } else { "poly" });
        let [given, written] = [("in", ending), ("out", &self.out_ending)]
            .map(|(name, ending)| self.folder.path().join(format!("{name}.{ending}")));
        let mut document = files::document(input).expect("a case has points");
        output::document(&given, &document).map_err(|failure| broken("write", "input", failure))?;
        // What an earlier run left is not this one's.
        let _ = std::fs::remove_file(&written);
        if !self.run(&given, &written)? {
            return Ok(0);
        }
        document.name = "input".to_owned();
        let cells = self.cells(&document, &written)?;
        judged(case, &cells, &Options::foreign()).map(|()| 1)
    }

    /// Whether it ran to a good end; not so after a refusal that is accepted.
    fn run(&self, given: &Path, written: &Path) -> Result<bool, Broken> {
        let filled = |word: &String| {
            let paths = [given, written].map(|path| path.to_string_lossy().into_owned());
            word.replace("{in}", &paths[0]).replace("{out}", &paths[1])
        };
        let words: Vec<String> = self.words.iter().map(filled).collect();
        let said = self.folder.path().join("stderr");
        let stderr = File::create(&said).map_or_else(|_| Stdio::null(), Stdio::from);
        let mut command = Command::new(&words[0]);
        command.args(&words[1..]).stdin(Stdio::null()).stdout(Stdio::null()).stderr(stderr);
        let mut child = command.spawn().map_err(|error| broken("run", "start", error))?;
        let ended = child.wait_timeout(self.timeout).map_err(|e| broken("run", "wait", e))?;
        let Some(status) = ended else {
            // It may have ended in between, which is as well.
            let _ = child.kill();
            let _ = child.wait();
            return Err(broken("run", "time limit", format!("{} s", self.timeout.as_secs_f64())));
        };
        if status.success() {
            return Ok(true);
        }
        if status.code().is_some() && self.accepts_refusal {
            return Ok(false);
        }
        let text = std::fs::read_to_string(&said).unwrap_or_default();
        let last = text.lines().rfind(|line| !line.trim().is_empty()).unwrap_or("");
        Err(broken("run", &status.to_string(), last))
    }

    /// The cells that it wrote, by input point.
    fn cells(&self, given: &delone_formats::Document, written: &Path) -> Result<Vec<u32>, Broken> {
        let unread = |failure: Failure| broken("output", "read", failure);
        let output = check::read_output(written, given).map_err(unread)?;
        let unread = |error| broken("output", "read", error);
        if given.dimension == 3 {
            let points = (given.points_3d().map_err(unread)?, output.points_3d().map_err(unread)?);
            self.named(points.0, points.1, &output)
        } else {
            let points = (given.points_2d().map_err(unread)?, output.points_2d().map_err(unread)?);
            self.named(points.0, points.1, &output)
        }
    }

    fn named<const D: usize>(
        &self,
        given: &[[f64; D]],
        points: &[[f64; D]],
        output: &delone_formats::Document,
    ) -> Result<Vec<u32>, Broken> {
        let strangers = |failure: Failure| broken("output", "vertices", failure);
        let names = check::names(given, points, output).map_err(strangers)?;
        let cells =
            if D == 3 { output.tets.as_flattened() } else { output.triangles.as_flattened() };
        Ok(cells.iter().map(|&id| names[id as usize]).collect())
    }
}

fn broken(law: &str, place: &str, message: impl std::fmt::Display) -> Broken {
    let (law, place) = (law.to_owned(), place.to_owned());
    Broken { law, place, message: message.to_string() }
}

impl Subject for Program {
    fn try_on(&mut self, input: &Input) -> Result<Vec<(&'static str, usize)>, Broken> {
        let times = match input {
            Input::Plane(case) => self.judge(input, case)?,
            Input::Space(case) => self.judge(input, case)?,
            Input::File(_) => 0,
        };
        Ok(vec![("judge", times)])
    }
}
