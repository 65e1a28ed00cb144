//! A sample of the `compare` report, with made-up figures: `cargo run -p delone-draw --example report > report.html`

use delone_draw::{Anchor, Cell, Picture, Report, Solid, Style, Table, Tone};
use std::io::{Write, stdout};

/// A jittered lattice, triangulated row by row, with a ring of constraints and the region inside it.
struct Sample {
    name: &'static str,
    points: Vec<[f64; 2]>,
    triangles: Vec<[u32; 3]>,
    segments: Vec<[u32; 2]>,
    classes: Vec<u32>,
}

fn noise(i: u32) -> f64 {
    let mixed = (i ^ 0x5bd1).wrapping_mul(0x9e37_79b1);
    f64::from((mixed ^ (mixed >> 15)).wrapping_mul(0x85eb_ca6b) >> 8) / f64::from(1 << 24) - 0.5
}

fn sample(name: &'static str, k: u32) -> Sample {
    let at =
        |i: u32| [f64::from(i % k) + 0.6 * noise(2 * i), f64::from(i / k) + 0.6 * noise(2 * i + 1)];
    let points = (0..k * k).map(at).collect();
    let inside = |x: u32, y: u32| {
        let [u, v] = [f64::from(x) / f64::from(k) - 0.5, f64::from(y) / f64::from(k) - 0.5];
        let r = u * u + v * v;
        r < 0.14 && r > 0.03
    };
    let (mut triangles, mut classes, mut segments) = (Vec::new(), Vec::new(), Vec::new());
    for (x, y) in (0..k - 1).flat_map(|y| (0..k - 1).map(move |x| (x, y))) {
        let [a, b, c, d] = [y * k + x, y * k + x + 1, (y + 1) * k + x + 1, (y + 1) * k + x];
        triangles.extend([[a, b, c], [a, c, d]]);
        classes.extend([u32::from(inside(x, y)); 2]);
        if x > 0 && inside(x, y) != inside(x - 1, y) {
            segments.push([a, d]);
        }
        if y > 0 && inside(x, y) != inside(x, y - 1) {
            segments.push([a, b]);
        }
    }
    Sample { name, points, triangles, segments, classes }
}

impl Sample {
    fn picture(&self) -> Picture<'_> {
        Picture {
            points: &self.points,
            triangles: &self.triangles,
            segments: &self.segments,
            classes: &self.classes,
            ..Picture::default()
        }
    }
}

fn count(n: usize) -> Cell {
    Cell::count(u64::try_from(n).unwrap_or(u64::MAX))
}

const RUNS: [(&str, f64); 4] = [("chew", 1.0), ("cavity", 1.3), ("flips", 2.4), ("naive", 9.0)];

fn summary(samples: &[Sample]) -> Table {
    let mut table = Table::new([
        "input",
        "sites",
        "segments",
        "algorithm",
        "triangles",
        "time ms",
        "orient",
        "in_circle",
        "exact %",
        "verdict",
    ]);
    for sample in samples {
        table.group();
        for (algorithm, factor) in RUNS {
            let n = sample.points.len() as f64;
            let wrong = algorithm == "flips" && sample.name == "ring";
            let refused = algorithm == "naive" && n > 5_000.0;
            let verdict = match (wrong, refused) {
                (true, _) => Cell::text("not Delaunay")
                    .fault()
                    .hover("edge (17, 42) is not locally Delaunay"),
                (_, true) => Cell::text("time limit").tone(Tone::Warn),
                _ => Cell::text("proved").ok(),
            };
            let known = |x: f64, decimals| Cell::real(if refused { f64::NAN } else { x }, decimals);
            table.row([
                Cell::link(sample.name, &Anchor::new(sample.name)),
                count(sample.points.len()),
                count(sample.segments.len()),
                Cell::text(algorithm),
                known(sample.triangles.len() as f64, 0),
                known(n * factor / 1_700.0, 2).bar(if refused { 0.0 } else { factor / 9.0 }),
                known((n * 11.3 * factor).round(), 0),
                known((n * 7.9 * factor).round(), 0),
                known(0.4 * factor, 2),
                verdict,
            ]);
        }
    }
    table
}

fn details(report: &mut Report, sample: &Sample) {
    report.heading(sample.name, &Anchor::new(sample.name));
    report.columns(|report| {
        let style = Style { title: sample.name.to_owned(), size: 640.0, ..Style::default() };
        report.picture(
            &sample.picture(),
            &style,
            "Constraints dark, the region between them filled.",
        );
        let mut table = Table::new(["event", "chew", "cavity", "flips"]);
        for (event, n) in [
            ("walk step", 1_840),
            ("flip", 611),
            ("cavity", 96),
            ("merge", 0),
            ("Steiner point", 0),
        ] {
            table.row([
                Cell::text(event),
                Cell::count(n),
                Cell::count(2 * n + 3),
                Cell::count(5 * n),
            ]);
        }
        report.table(&table);
    });
    report.details("How to run this again", |report| {
        report.code(&format!(
            "delone gen {} -n {} --seed 7 | delone cdt - --check --counts",
            sample.name,
            sample.points.len()
        ));
    });
}

fn main() -> std::io::Result<()> {
    let samples = [sample("ring", 12), sample("ring-40", 40), sample("ring-320", 320)];
    let mut report = Report::new("Constrained Delaunay triangulations compared");
    report.lead("3 inputs, 4 algorithms, kernel adaptive, seed 7. Sample figures, for the look of the page only.");
    report.notice(
        Tone::Fault,
        "1 of 12 results is wrong: flips on ring. The others agree and were proved.",
    );
    report.table(&summary(&samples));
    samples.iter().for_each(|sample| details(&mut report, sample));
    report.heading("Numbers and solids", &Anchor::new("extras"));
    report.columns(|report| {
        let small = sample("numbered", 5);
        let picture = Picture { highlights: &[[6, 12]], marked: &[12], ..small.picture() };
        let style = Style { numbered: true, circumcircles: false, size: 520.0, ..Style::default() };
        report.picture(
            &picture,
            &style,
            "Vertices and triangles numbered; one edge and one site pointed at.",
        );
        let points: Vec<[f64; 3]> =
            (0..64_u32).map(|i| [i % 4, i / 4 % 4, i / 16].map(f64::from)).collect();
        let corners = |i: u32| [i, i + 1, i + 4, i + 5, i + 16, i + 17, i + 20, i + 21];
        let cubes = (0..64_u32)
            .filter(|i| i % 4 != 3 && i / 4 % 4 != 3 && i / 16 != 3 && i % 3 != 1)
            .map(corners);
        let tets: Vec<[u32; 4]> = cubes
            .flat_map(|[a, b, c, d, e, f, g, h]| {
                [[a, b, d, h], [a, d, c, h], [a, c, g, h], [a, g, e, h], [a, e, f, h], [a, f, b, h]]
            })
            .collect();
        report.svg(
            &Solid { points: &points, tets: &tets, ..Solid::default() }.svg(),
            "Cubes of six tetrahedra each.",
        );
    });
    report.write(&mut stdout().lock())?;
    stdout().flush()
}
