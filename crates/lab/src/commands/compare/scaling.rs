//! `delone compare --scaling`: each algorithm on workloads of growing size; how time and the number of tests grow.

use delone_conforming::methods;
use delone_delaunay::Options;
use delone_draw::{Anchor, Cell, Plot, Report, Series, Table, Tone};
use delone_workloads::{Workload, find};
use serde_json::{Value, json};

use crate::cli;
use crate::engine;
use crate::failure::Failure;
use crate::output;
use crate::progress::Progress;
use crate::subject::Subject;

/// An algorithm is left out of a size where it would take longer than this, by how its steps have grown so far; as long as that is
/// not known, if it were quadratic.
const LONG_SECONDS: f64 = 40.0;

/// What is added to the power by which steps grow: larger sizes wait for memory.
const SLOWER: f64 = 0.25;

/// One run.
struct Point {
    sites: f64,
    seconds: f64,
    /// Orientations, in-sphere tests and edges crossed on the way.
    steps: f64,
    proved: bool,
    fingerprint: String,
}

/// One algorithm on one workload.
struct Curve {
    algorithm: &'static str,
    points: Vec<Point>,
}

/// All algorithms on one workload.
struct Growth {
    workload: &'static Workload,
    curves: Vec<Curve>,
    /// Algorithms, and from how many sites on they were left out.
    left_out: Vec<(&'static str, usize)>,
}

impl Curve {
    /// Whether a run on so many sites is expected to take too long.
    fn is_too_long(&self, sites: usize) -> bool {
        let Some(last) = self.points.last() else { return false };
        let measured = self.series(|point| point.steps).exponent();
        let power = measured.map_or(2.0, |power| power.max(1.0) + SLOWER);
        last.seconds * (sites as f64 / last.sites.max(1.0)).powf(power) > LONG_SECONDS
    }

    fn series(&self, value: impl Fn(&Point) -> f64) -> Series {
        let points = self.points.iter().map(|point| [point.sites, value(point)]).collect();
        Series { name: self.algorithm.to_owned(), points }
    }
}

impl Growth {
    fn is_good(&self) -> bool {
        let longest = self.curves.iter().map(|curve| curve.points.len()).max().unwrap_or(0);
        let agree = (0..longest).all(|size| {
            let mut prints = self.curves.iter().filter_map(|curve| curve.points.get(size));
            let first = prints.next();
            prints.all(|point| first.is_some_and(|first| first.fingerprint == point.fingerprint))
        });
        agree && self.curves.iter().flat_map(|curve| &curve.points).all(|point| point.proved)
    }
}

pub(super) fn scaling(arguments: &cli::Compare, only: &[&str]) -> Result<(), Failure> {
    if let Some(method) = methods().iter().find(|method| only.contains(&method.name)) {
        return Err(Failure::Input(format!(
            "--scaling is of algorithms that all make one triangulation: {} adds Steiner points",
            method.name
        )));
    }
    let mut growths = Vec::new();
    for name in &arguments.workloads {
        let workload = find(name).map_err(Failure::input)?;
        growths.push(growth(workload, arguments, only)?);
    }
    if let Some(path) = &arguments.html {
        output::text(path, &page(&growths))?;
    }
    if arguments.voice.json {
        println!("{}", object(&growths));
    } else {
        print(&growths);
        if let Some(path) = &arguments.html {
            println!("report: {} ({})", path.display(), output::size(path));
        }
    }
    if growths.iter().all(Growth::is_good) { Ok(()) } else { Err(Failure::Difference(None)) }
}

fn growth(
    workload: &'static Workload,
    arguments: &cli::Compare,
    only: &[&str],
) -> Result<Growth, Failure> {
    let (mut curves, mut left_out): (Vec<Curve>, Vec<(&str, usize)>) = Default::default();
    for &size in &arguments.scaling {
        let subject = Subject::generated(workload.name, &workload.generate(size, arguments.seed))?;
        for algorithm in engine::names(&subject) {
            if !only.is_empty() && !only.contains(&algorithm) {
                continue;
            }
            let place = curves.iter().position(|curve| curve.algorithm == algorithm);
            let place = place.unwrap_or_else(|| {
                curves.push(Curve { algorithm, points: Vec::new() });
                curves.len() - 1
            });
            let curve = &mut curves[place];
            let is_out = left_out.iter().any(|&(name, _)| name == algorithm);
            if is_out || curve.is_too_long(subject.site_count()) {
                if !is_out {
                    left_out.push((algorithm, subject.site_count()));
                }
            } else {
                curve.points.push(point(&subject, algorithm));
            }
        }
    }
    curves.retain(|curve| curve.points.len() > 1); // the definition, which takes a few sites only
    Ok(Growth { workload, curves, left_out })
}

fn point(subject: &Subject, algorithm: &'static str) -> Point {
    let options = Options::default();
    let built = engine::run(subject, algorithm, &options, None);
    let mut progress = Progress::new(algorithm, true);
    engine::run(subject, algorithm, &options, Some(&mut progress));
    let counts = progress.counts;
    Point {
        sites: subject.site_count() as f64,
        seconds: built.seconds,
        steps: (counts.orients + counts.in_spheres + counts.edges_crossed) as f64,
        proved: built.triangulation.verdict(subject).ok,
        fingerprint: built.triangulation.fingerprint(subject).to_string(),
    }
}

/// What was left out, as a sentence; none if nothing was.
fn omissions(growth: &Growth) -> Option<String> {
    let each = growth.left_out.iter().map(|(name, sites)| format!("{name} from {sites} sites on"));
    let each: Vec<String> = each.collect();
    (!each.is_empty())
        .then(|| format!("Left out, for it would take too long: {}.", each.join(", ")))
}

fn exponent(series: &Series) -> String {
    series.exponent().map_or_else(|| "-".to_owned(), |exponent| format!("{exponent:.2}"))
}

fn print(growths: &[Growth]) {
    println!(
        "{:18} {:16} {:>9} {:>10} {:>10} {:>10}  verdict",
        "workload", "algorithm", "sites", "ns/site", "steps/site", "steps ~ n^"
    );
    for growth in growths {
        for curve in &growth.curves {
            let Some(last) = curve.points.last() else { continue };
            println!(
                "{:18} {:16} {:>9} {:>10.0} {:>10.1} {:>10}  {}",
                growth.workload.name,
                curve.algorithm,
                last.sites,
                last.seconds * 1e9 / last.sites,
                last.steps / last.sites,
                exponent(&curve.series(|point| point.steps)),
                if growth.is_good() { "proved" } else { "WRONG" },
            );
        }
        if let Some(text) = omissions(growth) {
            println!("{:18} {text}", growth.workload.name);
        }
    }
}

fn page(growths: &[Growth]) -> String {
    let mut report = Report::new("delone compare: how costs grow");
    report.lead(
        "Steps are orientations, in-sphere tests and edges crossed: they are the same on every machine. Times are of one \
         run each. n^k beside a name is the power law that fits best; n log n looks like n^1.1.",
    );
    let good = growths.iter().all(Growth::is_good);
    if good {
        report.notice(Tone::Ok, "Every result is proved, and on each input all algorithms agree.");
    } else {
        report.notice(Tone::Fault, "A result is not proved, or algorithms disagree.");
    }
    for growth in growths {
        let name = growth.workload.name;
        report.heading(name, &Anchor::new(name));
        report.paragraph(growth.workload.about);
        if let Some(text) = omissions(growth) {
            report.paragraph(&text);
        }
        report.columns(|report| {
            let plot = |up: &str, value: fn(&Point) -> f64| Plot {
                title: format!("{name}: {up}"),
                across: "sites".to_owned(),
                up: up.to_owned(),
                series: growth.curves.iter().map(|curve| curve.series(value)).collect(),
            };
            report.svg(&plot("steps", |point| point.steps).svg(), "steps by sites");
            report.svg(&plot("seconds", |point| point.seconds).svg(), "seconds by sites");
        });
        report.details("numbers", |report| report.table(&table(growth)));
    }
    report.finish()
}

fn table(growth: &Growth) -> Table {
    let mut table = Table::new(["algorithm", "sites", "ns / site", "steps / site", "verdict"]);
    for curve in &growth.curves {
        table.group();
        for point in &curve.points {
            let verdict = if point.proved {
                Cell::text("proved").ok()
            } else {
                Cell::text("not proved").fault()
            };
            table.row([
                Cell::text(curve.algorithm),
                Cell::real(point.sites, 0),
                Cell::real(point.seconds * 1e9 / point.sites, 1),
                Cell::real(point.steps / point.sites, 2),
                verdict,
            ]);
        }
    }
    table
}

fn object(growths: &[Growth]) -> Value {
    let mut results = Vec::new();
    for growth in growths {
        for curve in &growth.curves {
            for point in &curve.points {
                results.push(json!({
                    "workload": growth.workload.name,
                    "algorithm": curve.algorithm,
                    "sites": point.sites,
                    "seconds": { "build": point.seconds },
                    "steps": point.steps,
                    "fingerprint": point.fingerprint,
                    "proved": point.proved,
                }));
            }
        }
    }
    let left_out = growths.iter().flat_map(|growth| {
        let name = growth.workload.name;
        let each = growth.left_out.iter();
        each.map(move |(algorithm, sites)| json!({ "workload": name, "algorithm": algorithm, "from": sites }))
    });
    let left_out: Vec<Value> = left_out.collect();
    json!({ "schema": "delone.scaling/1", "results": results, "left_out": left_out, "ok": growths.iter().all(Growth::is_good) })
}

#[cfg(test)]
mod tests;
