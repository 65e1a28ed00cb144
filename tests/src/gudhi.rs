//! Gudhi behind a pipe: the client of `peers/gudhi_alpha.py`, whose head tells the protocol.
//!
//! Python is `python3`, or what `DELONE_PYTHON` names, which must have Gudhi then.

use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Write as _};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use crate::say;

/// A running peer.
#[derive(Debug)]
pub struct Gudhi {
    child: Child,
    to: ChildStdin,
    from: BufReader<ChildStdout>,
}

impl Gudhi {
    /// Starts it; `None`, said aloud, if there is no Python with Gudhi.
    ///
    /// # Panics
    /// If `DELONE_PYTHON` names a Python without Gudhi.
    #[must_use]
    pub fn start() -> Option<Self> {
        let named = std::env::var_os("DELONE_PYTHON");
        let started = Self::of(Command::new(named.clone().unwrap_or_else(|| "python3".into())));
        if started.is_none() {
            assert!(named.is_none(), "DELONE_PYTHON names {named:?}, which has no Gudhi");
            say("skipped: python3 has no Gudhi (name a Python that has it by DELONE_PYTHON)");
        }
        started
    }

    fn of(mut python: Command) -> Option<Self> {
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("peers/gudhi_alpha.py");
        python.arg(script).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null());
        let mut child = python.spawn().ok()?;
        let to = child.stdin.take()?;
        let from = BufReader::new(child.stdout.take()?);
        let mut gudhi = Self { child, to, from };
        gudhi.line().starts_with("gudhi ").then_some(gudhi)
    }

    /// The simplices of the alpha complex of distinct points, with weights if there are any, each with its vertices and its squared
    /// radius; sorted by dimension, then vertices.
    ///
    /// # Panics
    /// If Gudhi goes away.
    pub fn alpha_values<const D: usize>(
        &mut self,
        points: &[[f64; D]],
        weights: Option<&[f64]>,
    ) -> Vec<(Vec<u32>, f64)> {
        let has_weights = u8::from(weights.is_some());
        let mut request = format!("alpha {D} {} {has_weights}\n", points.len());
        for (i, point) in points.iter().enumerate() {
            for x in point.iter().chain(weights.map(|weights| &weights[i])) {
                write!(request, "{:016x} ", x.to_bits()).expect("text grows");
            }
            request.push('\n');
        }
        self.to.write_all(request.as_bytes()).expect("Gudhi listens");
        self.to.flush().expect("Gudhi listens");
        let head = self.line();
        let count = head.strip_prefix("ok ").and_then(|count| count.parse().ok());
        let count: usize = count.unwrap_or_else(|| panic!("Gudhi went away: {head:?}"));
        let mut values: Vec<_> = (0..count).map(|_| value(&self.line())).collect();
        values.sort_by(|(a, _), (b, _)| (a.len(), a).cmp(&(b.len(), b)));
        values
    }

    fn line(&mut self) -> String {
        let mut line = String::new();
        // Nothing is read if it is gone.
        self.from.read_line(&mut line).unwrap_or_default();
        line.trim_end().to_owned()
    }
}

/// Ids and the bits of a double.
fn value(line: &str) -> (Vec<u32>, f64) {
    let (ids, bits) = line.rsplit_once(' ').expect("vertices and a value");
    let ids = ids.split(' ').map(|id| id.parse().expect("an id")).collect();
    (ids, f64::from_bits(u64::from_str_radix(bits, 16).expect("the bits of a double")))
}

impl Drop for Gudhi {
    fn drop(&mut self) {
        // An error means that it is gone, which is what we want.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
