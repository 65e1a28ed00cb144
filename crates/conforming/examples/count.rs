//! Counts and times of refinement on files, for comparison with peers.
//!
//! ```sh
//! cargo run --release -p delone-conforming --example count -- DEGREES SITES_MAX DUMP_FOLDER FILE..
//! ```
//! `DUMP_FOLDER` gets each noded graph with something inside, for peers to read: `n m`, then points, then segments; `-` for none.
#![expect(clippy::print_stdout, clippy::disallowed_methods, reason = "it prints a table of times")]

use std::fmt::Write as _;
use std::path::Path;
use std::time::Instant;

use delone_cdt::Fill;
use delone_conforming::{Centre, Encroachment, Limits, RefineOptions, refine};
use delone_formats::read_all;
use delone_sites::Pslg;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [degrees, sites_max, folder, files @ ..] = words.as_slice() else {
        println!("DEGREES SITES_MAX DUMP_FOLDER FILE..");
        return;
    };
    let (degrees, sites_max) =
        (degrees.parse().unwrap_or(30.0), sites_max.parse().unwrap_or(50_000));
    let mut count = 0;
    for file in files {
        for document in read_all(Path::new(file)).unwrap_or_default() {
            let segments: Vec<[usize; 2]> =
                document.segments.iter().map(|ends| ends.map(|v| v as usize)).collect();
            let Ok(points) = document.points_2d() else { continue };
            let Ok(pslg) = Pslg::new(points, &segments) else { continue };
            if pslg.sites().len() <= sites_max && row(&document.name, &pslg, degrees, count, folder)
            {
                count += 1;
            }
        }
    }
}

/// By itself, for profilers.
#[inline(never)]
fn refine_one(pslg: &Pslg, options: &RefineOptions<'_>) -> Option<delone_conforming::Refined> {
    refine(pslg, &Fill::Exterior, options, &mut ()).ok()
}

/// Prints a row, unless nothing is inside.
fn row(name: &str, pslg: &Pslg, degrees: f64, number: usize, folder: &str) -> bool {
    let sites = pslg.sites().len();
    let mut text = String::new();
    let first = std::env::var_os("FIRST").is_some();
    for (centre, encroachment) in [
        (Centre::OffCentre, Encroachment::Lens),
        (Centre::Circumcentre, Encroachment::Lens),
        (Centre::OffCentre, Encroachment::Disk),
        (Centre::Circumcentre, Encroachment::Disk),
    ]
    .into_iter()
    .take(if first { 1 } else { 4 })
    {
        let options = RefineOptions {
            centre,
            encroachment,
            angle_deg_min: degrees,
            limits: Limits { vertices_max: 20 * sites + 100_000 },
            ..RefineOptions::default()
        };
        let start = Instant::now();
        let Some(refined) = refine_one(pslg, &options) else { return false };
        let seconds = start.elapsed().as_secs_f64();
        if refined.cells().next().is_none() {
            return false;
        }
        let stuck = refined
            .left_alone()
            .iter()
            .filter(|left| left.reason == delone_conforming::Reason::Unreachable)
            .count();
        if std::env::var_os("DETAILS").is_some() {
            let t = refined.triangulation();
            let on = t
                .steiner_points()
                .iter()
                .filter(|s| **s != delone_conforming::SteinerPoint::Free)
                .count();
            println!(
                "on {on} free {} inside {}",
                t.steiner_points().len() - on,
                refined.cells().count()
            );
        }
        let _ = write!(
            text,
            " {} {seconds:.5} {}/{stuck} {}",
            refined.triangulation().kernel().len(),
            refined.left_alone().len(),
            u8::from(refined.is_complete())
        );
    }
    println!("{number} {sites}{text} {}", name.replace(' ', "_"));
    if folder != "-" {
        let points = pslg.sites().points();
        let mut dump = format!("{} {}\n", points.len(), pslg.subsegments().len());
        points.iter().for_each(|[x, y]| dump.push_str(&format!("{x:?} {y:?}\n")));
        pslg.subsegments().iter().for_each(|[a, b]| dump.push_str(&format!("{a} {b}\n")));
        let path = Path::new(folder).join(format!("{number}.txt"));
        std::fs::write(path, dump).unwrap_or_else(|error| println!("{error}"));
    }
    true
}
