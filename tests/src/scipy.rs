//! `scipy.ndimage.label` as an opponent of components: Python 3 with scipy, `python3` or what `DELONE_PYTHON` names.

use std::fmt::Write as _;
use std::io::{ErrorKind, Write as _};
use std::path::Path;
use std::process::{Command, Stdio};

use delone::trees::{Joined, OrthTree};

use crate::say;

/// Labels of rasters, asked about all at once.
#[derive(Clone, Debug, Default)]
pub struct Labels {
    names: Vec<String>,
    request: String,
}

impl Labels {
    /// Adds the components of a tree on its raster.
    pub fn add<const N: usize>(&mut self, name: &str, tree: &OrthTree<N>, joined: Joined) {
        let depth = tree.depth();
        let side = 1usize << depth;
        let mut labels = vec![0; side.pow(u32::try_from(N).expect("axes are few"))];
        let components = tree.components(joined);
        for (cell, component) in tree.black().zip(&components.of_black) {
            let scale = 1u32 << (depth - cell.level());
            let lower = cell.anchor().map(|c| (c * scale) as usize);
            let width = scale as usize;
            for part in 0..width.pow(u32::try_from(N).expect("axes are few")) {
                let mut rest = part;
                let at = lower.iter().fold(0, |at, c| {
                    let place = c + rest % width;
                    rest /= width;
                    at * side + place
                });
                labels[at] = component + 1;
            }
        }
        let reach = if joined == Joined::ByFacets { 1 } else { N };
        writeln!(self.request, "{N} {side} {reach}").expect("text grows");
        let labels: Vec<String> = labels.iter().map(ToString::to_string).collect();
        writeln!(self.request, "{}", labels.join(" ")).expect("text grows");
        self.names.push(format!("{name}, {joined:?}"));
    }

    /// Panics where scipy has other components. How many cases it was asked about, or `None`, said aloud, where it is not.
    #[must_use]
    pub fn compare(&self) -> Option<usize> {
        let python = std::env::var("DELONE_PYTHON").unwrap_or_else(|_| "python3".to_owned());
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("peers/label.py");
        let mut command = Command::new(python);
        command.arg(script).stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = match command.spawn() {
            Err(error) if error.kind() == ErrorKind::NotFound => {
                say("skipped: there is no Python to ask scipy");
                return None;
            }
            spawned => spawned.expect("Python starts"),
        };
        let mut to = child.stdin.take().expect("its input is piped");
        let request = self.request.clone().into_bytes();
        // It answers while it is asked; without scipy it does not listen.
        let writer = std::thread::spawn(move || to.write_all(&request));
        let output = child.wait_with_output().expect("Python answers");
        let written = writer.join().expect("the writer ends");
        if output.status.code() == Some(3) {
            say("skipped: Python has no scipy (DELONE_PYTHON may name another)");
            return None;
        }
        written.expect("Python listens");
        let text = String::from_utf8(output.stdout).expect("Python prints text");
        assert!(output.status.success(), "scipy failed: {text}");
        let answers: Vec<&str> = text.lines().collect();
        assert_eq!(answers.len(), self.names.len(), "an answer for each case");
        for (name, answer) in self.names.iter().zip(&answers) {
            assert!(answer.starts_with("same "), "{name}: {answer}");
        }
        Some(answers.len())
    }
}
