//! CGAL's predicates, by a program of its own: `benches/peers/cgal_predicates.cpp`, built here if CGAL is installed.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::Predicate;

/// The built peer.
#[derive(Clone, Debug)]
pub struct Cgal {
    binary: PathBuf,
}

impl Cgal {
    /// Builds the peer, unless it is there and newer than its source. `None` if that fails: no compiler, no CGAL.
    #[must_use]
    pub fn build() -> Option<Self> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let source = root.join("peers/cgal_predicates.cpp");
        let folder = root.join("../target/peers");
        std::fs::create_dir_all(&folder).ok()?;
        let binary = folder.join("cgal_predicates");
        let written = |path: &Path| path.metadata().and_then(|data| data.modified()).ok();
        if written(&binary) <= written(&source) {
            let mut compiler = Command::new("g++");
            compiler.args(["-O3", "-frounding-math", "-std=c++17", "-DNDEBUG", "-o"]);
            compiler.arg(&binary).arg(&source).args(["-lmpfr", "-lgmp"]);
            compiler.status().ok().filter(std::process::ExitStatus::success)?;
        }
        Some(Self { binary })
    }

    /// The nanoseconds of a call in the second quickest round, the median and the upper quartile, and the numbers of positive
    /// and negative signs.
    #[must_use]
    pub fn run(
        &self,
        predicate: Predicate,
        tuples: &[[f64; 3]],
        rounds: usize,
    ) -> Option<([f64; 3], [usize; 2])> {
        let path = self.binary.with_extension("calls");
        let mut file = std::io::BufWriter::new(std::fs::File::create(&path).ok()?);
        tuples.iter().flatten().try_for_each(|x| file.write_all(&x.to_ne_bytes())).ok()?;
        file.flush().ok()?;
        let mut command = Command::new(&self.binary);
        command.arg(predicate.name()).arg(&path).arg(rounds.to_string());
        let output = String::from_utf8(command.output().ok()?.stdout).ok()?;
        let mut words = output.split_whitespace();
        let mut time = || words.next()?.parse().ok();
        let nanoseconds = [time()?, time()?, time()?];
        let [positive, negative] = [words.next()?.parse().ok()?, words.next()?.parse().ok()?];
        Some((nanoseconds, [positive, negative]))
    }
}
