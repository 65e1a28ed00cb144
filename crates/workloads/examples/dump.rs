//! Prints a workload as text, for other programs: `n m`, then one site a line, then one segment a line.
//!
//! `cargo run -p delone-workloads --example dump -- coast 20000 7`

use delone_workloads::{Points, UnknownWorkload, all, generate};
use std::io::{BufWriter, Write, stdout};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let mut out = BufWriter::new(stdout().lock());
    let [name, n, seed] = args.as_slice() else {
        for w in all() {
            writeln!(out, "{:<22} {:<9} {}", w.name, w.kind().name(), w.about)?;
        }
        return Ok(());
    };
    let input = generate(name, n.parse()?, seed.parse()?)
        .map_err(|unknown: UnknownWorkload| unknown.to_string())?;
    writeln!(out, "{} {}", input.points.len(), input.segments.len())?;
    match &input.points {
        Points::Plane(points) => points.iter().try_for_each(|[x, y]| writeln!(out, "{x} {y}"))?,
        Points::Space(points) => {
            points.iter().try_for_each(|[x, y, z]| writeln!(out, "{x} {y} {z}"))?;
        }
    }
    input.segments.iter().try_for_each(|[a, b]| writeln!(out, "{a} {b}"))?;
    Ok(out.flush()?)
}
