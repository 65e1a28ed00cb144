//! Draws sites and segments read as text from standard input (`n m`, sites, segments) as SVG or, with `html`, as a report.
//!
//! `cargo run -p delone-workloads --example dump -- coast 20000 7 | cargo run -p delone-draw --example picture > coast.svg`

use delone_draw::{Picture, Report, Solid, Style};
use std::io::{Read, Write, stdin, stdout};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut text = String::new();
    stdin().read_to_string(&mut text)?;
    let mut lines = text.lines().map(|line| line.split_whitespace().collect::<Vec<_>>());
    let head = lines.next().unwrap_or_default();
    let n: usize = head.first().unwrap_or(&"0").parse()?;
    let sites: Vec<Vec<f64>> = lines
        .by_ref()
        .take(n)
        .map(|line| line.iter().map(|x| x.parse()).collect())
        .collect::<Result<_, _>>()?;
    let segments: Vec<[u32; 2]> = lines
        .filter(|line| line.len() == 2)
        .map(|line| Ok([line[0].parse()?, line[1].parse()?]))
        .collect::<Result<_, std::num::ParseIntError>>()?;
    let space: Vec<[f64; 3]> = sites.iter().filter_map(|p| p.as_slice().try_into().ok()).collect();
    let plane: Vec<[f64; 2]> = sites.iter().filter_map(|p| p.as_slice().try_into().ok()).collect();
    let picture = Picture { points: &plane, segments: &segments, ..Picture::default() };
    let style =
        Style { numbered: std::env::args().any(|arg| arg == "numbered"), ..Style::default() };
    let out = if !space.is_empty() {
        Solid { points: &space, ..Solid::default() }.svg()
    } else if std::env::args().any(|arg| arg == "html") {
        let mut report = Report::new("Picture");
        report.picture(&picture, &style, &format!("{n} sites, {} segments", segments.len()));
        report.finish()
    } else {
        picture.svg(&style)
    };
    Ok(stdout().lock().write_all(out.as_bytes())?)
}
