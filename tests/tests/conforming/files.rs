//! The collected files: all methods end, and are judged and counted beside CGAL and Triangle. Skipped, said aloud, where there are none. Without
//! `DELONE_LONG=1` one in ten, and only small ones. Segments that cross are cut where they do, in doubles.

use delone::Pslg;
use delone::conforming::{
    ConformOptions, Conforming, Encroached, Limits, Method, conform, methods,
};
use delone::sites::Snapped;
use delone_tests::case::Case;
use delone_tests::cgal::Cgal;
use delone_tests::data::{documents, files, pslg_of};
use delone_tests::{judge, long, say};

use crate::effort::{Ratios, tell_names};

/// The most sites taken.
fn sites_max() -> usize {
    if long() { 200_000 } else { 150 }
}

/// The most segments that are cut where they cross.
const CUT_MAX: usize = 1_000;

/// What came of all files.
struct Table {
    cgal: Option<Cgal>,
    triangle: Option<Cgal>,
    graphs: usize,
    snapped: usize,
    /// Segments that cross, and are too many, or go on crossing in doubles.
    refused: Vec<String>,
    judged: [usize; 3],
    /// By method: steiner points, ours over CGAL's.
    ratios: [Ratios; 2],
    /// Of `gabriel` in a box, over Triangle's.
    over_triangle: Ratios,
    /// By method: of which CGAL said nothing in ten seconds.
    silent: [Vec<String>; 2],
}

#[test]
fn all_methods_conform_on_files() {
    let mut table = Table {
        cgal: Cgal::start(),
        triangle: Cgal::triangle(),
        graphs: 0,
        snapped: 0,
        refused: Vec::new(),
        judged: [0; 3],
        ratios: Default::default(),
        over_triangle: Ratios::default(),
        silent: Default::default(),
    };
    let cases = files("pslg").into_iter().flat_map(|path| documents(&path));
    for (number, case) in cases.filter_map(|document| pslg_of(&document)).enumerate() {
        if case.points.len() <= sites_max() && (long() || number % 10 == 9) {
            table.take(&case);
        }
    }
    table.tell();
}

/// The graph, its segments cut where they cross if they do.
fn graph_of(case: &Case<2>) -> Option<(Pslg, bool)> {
    if let Some(pslg) = case.try_pslg() {
        return Some((pslg, false));
    }
    if case.segments.len() > CUT_MAX {
        return None;
    }
    let segments: Vec<[usize; 2]> =
        case.segments.iter().map(|ends| ends.map(|v| v as usize)).collect();
    let cut = Snapped::new(&case.points, &segments, 20).ok().filter(|cut| cut.is_settled)?;
    Some((Pslg::new(&cut.points, &cut.segments).ok()?, true))
}

/// The graph and a box around it, as far away as it is wide.
fn boxed(pslg: &Pslg) -> Option<Pslg> {
    let mut points = pslg.sites().points().to_vec();
    let ends = |axis: usize| {
        let low = points.iter().fold(f64::INFINITY, |low, point| low.min(point[axis]));
        (low, points.iter().fold(f64::NEG_INFINITY, |high, point| high.max(point[axis])))
    };
    let (x, y) = (ends(0), ends(1));
    let away = (x.1 - x.0).max(y.1 - y.0);
    let (x, y) = ((x.0 - away, x.1 + away), (y.0 - away, y.1 + away));
    let first = points.len();
    points.extend([[x.0, y.0], [x.1, y.0], [x.1, y.1], [x.0, y.1]]);
    let given = pslg.subsegments().iter().map(|ends| ends.map(|v| v as usize));
    let sides = (0..4).map(|side| [first + side, first + (side + 1) % 4]);
    Pslg::new(&points, &given.chain(sides).collect::<Vec<_>>()).ok()
}

impl Table {
    fn take(&mut self, case: &Case<2>) {
        let name = case.name.rsplit("pslg/").next().unwrap_or(&case.name);
        let Some((pslg, is_cut)) = graph_of(case) else {
            return self.refused.push(name.to_owned());
        };
        self.graphs += 1;
        self.snapped += usize::from(is_cut);
        let mut row = format!("{name} {}", pslg.sites().len());
        let has_segments = !pslg.subsegments().is_empty();
        for (number, method) in methods().iter().enumerate() {
            let result = self.judged(number, method, &pslg, name);
            let ours = result.steiner_points().len();
            row += &format!(" | {} {ours}", method.name);
            if number < 2 && has_segments && result.mesh().dimension() == Some(2) {
                row += &self.beside_peers(number, method.name, &pslg, ours, name);
            }
        }
        say(row);
    }

    /// The result, of which the judge says what the method promises.
    fn judged(&mut self, number: usize, method: &Method, pslg: &Pslg, name: &str) -> Conforming {
        let vertices_max = 100 * pslg.sites().len() + 50_000;
        let options =
            ConformOptions { limits: Limits { vertices_max }, ..ConformOptions::default() };
        let result = (method.run)(pslg, &options, &mut ());
        assert!(result.is_complete(), "{} {name}: more than {vertices_max}", method.name);
        if result.mesh().dimension() == Some(2) {
            let verdict = judge::conforming(pslg, &result, judge::promise(method, &result));
            assert!(verdict.ok, "{} {name}: {verdict}", method.name);
            self.judged[number] += 1;
        }
        result
    }

    /// What the peers take. On what takes too many, they do not come back: they are started again.
    fn beside_peers(
        &mut self,
        number: usize,
        method: &str,
        pslg: &Pslg,
        ours: usize,
        name: &str,
    ) -> String {
        let (points, pieces) = (pslg.sites().points(), pslg.subsegments());
        let ratio = |theirs: usize| (theirs + ours > 0).then(|| ours as f64 / theirs as f64);
        let mut row = String::new();
        if let Some(peer) = &mut self.cgal {
            match peer.conform(method, points, pieces) {
                Some([vertices, _]) => {
                    let theirs = vertices.checked_sub(points.len()).expect("no vertex is lost");
                    row += &format!(" (CGAL {theirs})");
                    ratio(theirs).into_iter().for_each(|r| self.ratios[number].push(r, name));
                }
                None => {
                    self.silent[number].push(name.to_owned());
                    self.cgal = Cgal::start();
                }
            }
        }
        if method == "gabriel" {
            row += &self.beside_triangle(pslg, name);
        }
        row
    }

    /// What Triangle takes, and what we do, of the graph in a box: it leaves out what no segment is around.
    fn beside_triangle(&mut self, pslg: &Pslg, name: &str) -> String {
        let Some(peer) = &mut self.triangle else { return String::new() };
        let Some(graph) = boxed(pslg) else { return String::new() };
        let (points, pieces) = (graph.sites().points(), graph.subsegments());
        let Some([vertices, _]) = peer.conform("gabriel", points, pieces) else {
            self.triangle = Cgal::triangle();
            return String::new();
        };
        let ours = conform(&graph, &Encroached, &ConformOptions::default(), &mut ());
        let (ours, theirs) = (ours.steiner_points().len(), vertices.saturating_sub(points.len()));
        if ours + theirs > 0 {
            self.over_triangle.push(ours as f64 / theirs as f64, name);
        }
        format!(" (in a box {ours}, Triangle {theirs})")
    }

    fn tell(&mut self) {
        let Self { graphs, snapped, judged, .. } = self;
        say(format!("{graphs} graphs, of which {snapped} cut at crossings; judged {judged:?}"));
        tell_names("crossing, and too many or not settled in doubles", &self.refused);
        self.over_triangle.tell("gabriel, in a box, Steiner points, ours / Triangle's -D");
        for (number, method) in ["delaunay", "gabriel"].into_iter().enumerate() {
            tell_names(&format!("{method}: CGAL does not answer"), &self.silent[number]);
            let of_what = format!("{method}, Steiner points, ours / CGAL's");
            if let Some(median) = self.ratios[number].tell(&of_what) {
                assert!(median <= 1.0, "{method}: no more Steiner points than CGAL's");
            }
        }
    }
}
