//! A peer as an engine of `delone bench`: `peer NAME TASK IN OUT TIMES`, with TASK `delaunay` or `cdt`. It prints `seconds S` for
//! each construction, and writes the triangles of the last one.
#![expect(clippy::print_stdout, reason = "this is how an engine speaks")]

use std::error::Error;
use std::path::Path;

use delone::formats::{Document, Format, read, write, write_atomically};
use delone_benches::triangulations::{Contestant, Peers, Task, plane, space};

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().collect();
    let [_, name, task, given, written, times] = &words[..] else {
        return Err("peer NAME delaunay|cdt IN OUT TIMES".into());
    };
    let (mut document, times) = (read(Path::new(given))?, times.parse()?);
    let peers = Peers::start();
    let constrained = task == "cdt";
    let segments = if constrained { document.segments.clone() } else { Vec::new() };
    if document.dimension == 3 {
        let points = document.points_3d()?.to_vec();
        let cells = build(space(&peers), name, &Task { points, segments }, times)?;
        document.tets = cells.as_chunks::<4>().0.to_vec();
    } else {
        let points = document.points_2d()?.to_vec();
        let cells = build(plane(&peers, constrained, 1), name, &Task { points, segments }, times)?;
        document.triangles = cells.as_chunks::<3>().0.to_vec();
    }
    save(&document, Path::new(written))
}

fn build<const D: usize>(
    mut contestants: Vec<Contestant<'_, D>>,
    name: &str,
    task: &Task<D>,
    times: u32,
) -> Result<Vec<u32>, Box<dyn Error>> {
    let contestant = contestants.iter_mut().find(|contestant| contestant.name == name);
    let contestant = contestant.ok_or_else(|| format!("{name} is not here"))?;
    let mut cells = Vec::new();
    for _ in 0..times {
        let run = (contestant.run)(task);
        cells = run.cells.ok_or_else(|| format!("{name} refused"))?;
        println!("seconds {:e}", run.seconds);
    }
    Ok(cells)
}

fn save(document: &Document, path: &Path) -> Result<(), Box<dyn Error>> {
    write_atomically(path, |out| write(document, Format::Ele, out))?;
    Ok(())
}
