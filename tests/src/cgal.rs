//! CGAL behind a pipe: the client of `peers/cgal.cpp` and `peers/cgal_alpha.cpp`, whose heads tell the protocol.

use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Write as _};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use crate::{long, say};

/// A running peer.
#[derive(Debug)]
pub struct Cgal {
    child: Child,
    to: ChildStdin,
    from: BufReader<ChildStdout>,
    seconds: f64,
}

/// What CGAL answers.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// The finite cells, sorted, each with its vertices sorted, flat; and the dimension, -1 for no points.
    Cells {
        /// Of the triangulation.
        dimension: i32,
        /// dimension + 1 ids each.
        cells: Vec<u32>,
    },
    /// It threw.
    Refused(String),
}

impl Cgal {
    /// Starts it; `None`, said aloud, if it is not built.
    #[must_use]
    pub fn start() -> Option<Self> {
        Self::named("cgal")
    }

    /// Starts the peer that knows alpha shapes; `None`, said aloud, if it is not built.
    #[must_use]
    pub fn with_alpha_shapes() -> Option<Self> {
        Self::named("cgal_alpha")
    }

    fn named(name: &str) -> Option<Self> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let peer = Self::of(&mut Command::new(root.join("target/peers").join(name)));
        if peer.is_none() {
            say(format!("skipped: {name} is not built (`cargo xtask setup` builds it)"));
        }
        peer
    }

    /// Starts Triangle instead, which refines in the same words and does nothing else; `None`, said aloud, if `python3`, or what
    /// `DELONE_PYTHON` names, has no package `triangle`.
    #[must_use]
    pub fn triangle() -> Option<Self> {
        let python = std::env::var_os("DELONE_PYTHON").unwrap_or_else(|| "python3".into());
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("peers/triangle_refine.py");
        let mut peer = Self::of(Command::new(python).arg(script).stderr(Stdio::null()));
        let mut word = String::new();
        if let Some(peer) = &mut peer {
            peer.from.read_line(&mut word).unwrap_or_default();
        }
        if word.trim_end() != "triangle" {
            say("skipped: python3 has no triangle (name a Python that has it by DELONE_PYTHON)");
            return None;
        }
        peer
    }

    fn of(command: &mut Command) -> Option<Self> {
        command.env("DELONE_PATIENCE", if long() { "10" } else { "1" });
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().ok()?;
        let (to, from) = (child.stdin.take()?, BufReader::new(child.stdout.take()?));
        Some(Self { child, to, from, seconds: 0.0 })
    }

    /// The Delaunay triangulation of distinct points in the plane or in space.
    pub fn delaunay<const D: usize>(&mut self, points: &[[f64; D]]) -> Answer {
        let mut request = format!("delaunay{D} {}\n", points.len());
        write_points(&mut request, points);
        self.ask(&request)
    }

    /// The regular triangulation of distinct points of the plane or of space, with one weight for each.
    pub fn regular<const D: usize>(&mut self, points: &[[f64; D]], weights: &[f64]) -> Answer {
        let mut request = format!("regular{D} {}\n", points.len());
        write_weighted(&mut request, points, weights);
        self.ask(&request)
    }

    /// The alpha values of distinct points, with weights if there are any: of edges and triangles in the plane, of all simplices
    /// in space; sorted, each with its vertices sorted and its value as a reduced fraction. `None` if it refused.
    pub fn alpha_values<const D: usize>(
        &mut self,
        points: &[[f64; D]],
        weights: Option<&[f64]>,
    ) -> Option<Vec<(Vec<u32>, String)>> {
        let mut request = String::new();
        match weights {
            None => {
                writeln!(request, "alpha{D} {}", points.len()).expect("text grows");
                write_points(&mut request, points);
            }
            Some(weights) => {
                writeln!(request, "walpha{D} {}", points.len()).expect("text grows");
                write_weighted(&mut request, points, weights);
            }
        }
        let (_, count) = self.head(&request).ok()?;
        let mut values: Vec<(Vec<u32>, String)> = (0..count).map(|_| value(&self.line())).collect();
        values.sort_unstable();
        Some(values)
    }

    /// The constrained Delaunay triangulation of distinct points and segments.
    pub fn cdt(&mut self, points: &[[f64; 2]], segments: &[[u32; 2]]) -> Answer {
        let mut request = format!("cdt {} {}\n", points.len(), segments.len());
        write_points(&mut request, points);
        for [a, b] in segments {
            writeln!(request, "{a} {b}").expect("text grows");
        }
        self.ask(&request)
    }

    /// How many vertices and cells a conforming triangulation has, of distinct points and segments: by its `strength`,
    /// `delaunay` or `gabriel`. `None` if it threw.
    pub fn conform(
        &mut self,
        strength: &str,
        points: &[[f64; 2]],
        segments: &[[u32; 2]],
    ) -> Option<[usize; 2]> {
        self.counted(&format!("conform {strength}"), points, segments)
    }

    /// The same of a mesh whose angles are at least so many degrees, as far as its method goes.
    pub fn refine(
        &mut self,
        degrees: f64,
        points: &[[f64; 2]],
        segments: &[[u32; 2]],
    ) -> Option<[usize; 2]> {
        self.counted(&format!("refine {degrees} 0"), points, segments)
    }

    fn counted(
        &mut self,
        what: &str,
        points: &[[f64; 2]],
        segments: &[[u32; 2]],
    ) -> Option<[usize; 2]> {
        let mut request = format!("{what} {} {}\n", points.len(), segments.len());
        write_points(&mut request, points);
        for [a, b] in segments {
            writeln!(request, "{a} {b}").expect("text grows");
        }
        self.to.write_all(request.as_bytes()).ok()?;
        self.to.flush().ok()?;
        let mut line = String::new();
        self.from.read_line(&mut line).ok()?;
        let mut words = line.strip_prefix("counted ")?.split_whitespace();
        let counts = [words.next()?.parse().ok()?, words.next()?.parse().ok()?];
        self.seconds = words.next()?.parse().ok()?;
        Some(counts)
    }

    /// What the last construction took, by its own clock.
    #[must_use]
    pub const fn seconds(&self) -> f64 {
        self.seconds
    }

    /// Asks, and reads the first line: the dimension and the number of lines that follow, or why it refused.
    fn head(&mut self, request: &str) -> Result<(i32, usize), String> {
        self.to.write_all(request.as_bytes()).expect("CGAL listens");
        self.to.flush().expect("CGAL listens");
        let head = self.line();
        let Some(rest) = head.strip_prefix("ok ") else {
            return Err(head);
        };
        let mut words = rest.split_whitespace();
        let dimension: i32 = words.next().and_then(|w| w.parse().ok()).expect("a dimension");
        let count: usize = words.next().and_then(|w| w.parse().ok()).expect("a count");
        self.seconds = words.next().and_then(|w| w.parse().ok()).expect("seconds");
        Ok((dimension, count))
    }

    fn ask(&mut self, request: &str) -> Answer {
        let (dimension, count) = match self.head(request) {
            Ok(head) => head,
            Err(message) => return Answer::Refused(message),
        };
        let mut cells: Vec<Vec<u32>> = Vec::with_capacity(count);
        for _ in 0..count {
            let line = self.line();
            let ids = line.split_whitespace().map(|id| id.parse().expect("an id"));
            let mut cell: Vec<u32> = ids.collect();
            cell.sort_unstable();
            cells.push(cell);
        }
        cells.sort_unstable();
        Answer::Cells { dimension, cells: cells.concat() }
    }

    fn line(&mut self) -> String {
        let mut line = String::new();
        let read = self.from.read_line(&mut line).expect("CGAL answers");
        assert!(read > 0, "CGAL went away: it crashed on the last request");
        line.trim_end().to_owned()
    }
}

impl Drop for Cgal {
    fn drop(&mut self) {
        // An error means that it is gone, which is what we want.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn write_points<const D: usize>(request: &mut String, points: &[[f64; D]]) {
    for point in points {
        for x in point {
            write!(request, "{:016x} ", x.to_bits()).expect("text grows");
        }
        request.push('\n');
    }
}

fn write_weighted<const D: usize>(request: &mut String, points: &[[f64; D]], weights: &[f64]) {
    for (point, weight) in points.iter().zip(weights) {
        for x in point.iter().chain([weight]) {
            write!(request, "{:016x} ", x.to_bits()).expect("text grows");
        }
        request.push('\n');
    }
}

/// A line of a count of ids, the ids, and a value.
fn value(line: &str) -> (Vec<u32>, String) {
    let mut words = line.split_whitespace();
    let count: usize = words.next().and_then(|w| w.parse().ok()).expect("a count");
    let ids = words.by_ref().take(count).map(|id| id.parse().expect("an id"));
    let mut ids: Vec<u32> = ids.collect();
    ids.sort_unstable();
    (ids, words.next().expect("a value").to_owned())
}
