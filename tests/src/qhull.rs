//! Qhull as an opponent in higher dimensions: Debian's `qdelaunay`, which works in doubles, so on inputs in general position.

use std::fmt::Write as _;
use std::io::{ErrorKind, Write as _};
use std::process::{Command, Stdio};

use crate::say;

/// The Delaunay cells of these points as Qhull finds them, each sorted, in lexicographic order, flat; `None`, said aloud, if
/// it is not installed.
#[must_use]
pub fn delaunay<const D: usize>(points: &[[f64; D]]) -> Option<Vec<u32>> {
    let mut command = Command::new("qdelaunay");
    command.args(["Qt", "i"]).stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut child = match command.spawn() {
        Err(error) if error.kind() == ErrorKind::NotFound => {
            say("skipped: Qhull is not installed (`cargo xtask setup` installs it)");
            return None;
        }
        spawned => spawned.expect("qdelaunay starts"),
    };
    let mut request = format!("{D}\n{}\n", points.len());
    for point in points {
        let line: Vec<String> = point.iter().map(|x| format!("{x:?}")).collect();
        writeln!(request, "{}", line.join(" ")).expect("text grows");
    }
    let mut to = child.stdin.take().expect("its input is piped");
    to.write_all(request.as_bytes()).expect("Qhull listens");
    drop(to);
    let output = child.wait_with_output().expect("Qhull answers");
    let text = String::from_utf8(output.stdout).expect("Qhull prints text");
    assert!(output.status.success(), "Qhull refused: {text}");
    let mut lines = text.lines();
    let count: usize = lines.next().and_then(|line| line.trim().parse().ok()).expect("a count");
    let ids = |line: &str| -> Vec<u32> {
        let mut cell: Vec<u32> =
            line.split_whitespace().map(|id| id.parse().expect("an id")).collect();
        cell.sort_unstable();
        cell
    };
    let mut cells: Vec<Vec<u32>> = lines.map(ids).collect();
    assert_eq!(cells.len(), count, "as many cells as announced");
    cells.sort_unstable();
    Some(cells.concat())
}
