//! The collected files, refined at 20.7 and 30 degrees: judged, angles too, and beside Triangle and CGAL. Skipped, said aloud, where
//! there are none. Without `DELONE_LONG=1` one in ten, and only small ones. Times are worth something in a release build alone.

use std::time::Instant;

use delone::Pslg;
use delone::cdt::Fill;
use delone::check::Promise;
use delone::conforming::{LeftAlone, Limits, Reason, RefineOptions, Refined, refine};
use delone_tests::case::Case;
use delone_tests::cgal::Cgal;
use delone_tests::data::{documents, files, pslg_of};
use delone_tests::{long, say};

use crate::{judged, judged_with_angles};

/// Vertices and seconds, ours over a peer's, by name of the input.
type Ratios = Vec<(f64, f64, String)>;

/// The opponents, and what came of them.
struct Table {
    degrees: f64,
    triangle: Option<Cgal>,
    cgal: Option<Cgal>,
    ratios: [Ratios; 2],
    judged: usize,
    partial: Vec<String>,
    /// Where doubles were too coarse for all angles.
    coarse: Vec<String>,
}

/// The most sites taken.
fn sites_max() -> usize {
    if long() { 20_000 } else { 150 }
}

#[test]
fn files_are_refined_and_judged() {
    for degrees in [20.7, 30.0] {
        let mut table = Table {
            degrees,
            triangle: Cgal::triangle(),
            cgal: Cgal::start(),
            ratios: Default::default(),
            judged: 0,
            partial: Vec::new(),
            coarse: Vec::new(),
        };
        let cases = files("pslg").into_iter().flat_map(|path| documents(&path));
        for (number, case) in cases.filter_map(|document| pslg_of(&document)).enumerate() {
            let small = case.points.len() <= sites_max() && !case.segments.is_empty();
            if small && (long() || number % 10 == 0) {
                table.take(&case);
            }
        }
        table.tell();
    }
}

impl Table {
    fn take(&mut self, case: &Case<2>) {
        let Some(pslg) = case.try_pslg() else { return };
        let Some((refined, seconds, options)) = self.refined(&pslg) else { return };
        let name = format!("{} ({} sites)", case.name, pslg.sites().len());
        let ours = refined.triangulation().kernel().len();
        if !refined.is_complete() {
            return self.partial.push(name);
        }
        let is_coarse = |left: &LeftAlone| left.reason == Reason::Unreachable;
        let verdict = if refined.left_alone().iter().any(is_coarse) {
            self.coarse.push(name.clone());
            judged(&pslg, refined.triangulation(), Promise::Constrained)
        } else {
            judged_with_angles(&pslg, &refined, options.cosine_square())
        };
        assert!(verdict.ok, "{name}: {verdict}");
        self.judged += 1;
        let (degrees, points, pieces) = (self.degrees, pslg.sites().points(), pslg.subsegments());
        let starts: [fn() -> Option<Cgal>; 2] = [Cgal::triangle, Cgal::start];
        let peers = [&mut self.triangle, &mut self.cgal];
        for ((number, peer), again) in peers.into_iter().enumerate().zip(starts) {
            let Some(running) = peer.as_mut() else { continue };
            match running.refine(degrees, points, pieces) {
                Some([theirs, cells]) if cells > 0 => {
                    let ratio = ours as f64 / theirs as f64;
                    let speed = seconds / running.seconds();
                    self.ratios[number].push((ratio, speed, name.clone()));
                }
                Some(_) => {}
                None => {
                    say(format!("{name}: peer {number} did not answer"));
                    *peer = again();
                }
            }
        }
    }

    /// Refined, the best of three times; `None` if nothing is inside.
    fn refined(&self, pslg: &Pslg) -> Option<(Refined, f64, RefineOptions<'static>)> {
        let vertices_max = 20 * pslg.sites().len() + if long() { 100_000 } else { 2_000 };
        let options = RefineOptions {
            angle_deg_min: self.degrees,
            limits: Limits { vertices_max },
            ..RefineOptions::default()
        };
        let mut best = f64::INFINITY;
        let mut last = None;
        for _ in 0..if long() { 3 } else { 1 } {
            let start = Instant::now();
            let refined = refine(pslg, &Fill::Exterior, &options, &mut ()).ok()?;
            best = best.min(start.elapsed().as_secs_f64());
            last = Some(refined);
        }
        last.filter(|refined| refined.cells().next().is_some()).map(|last| (last, best, options))
    }

    fn tell(&mut self) {
        let Self { degrees, judged, partial, coarse, .. } = self;
        say(format!("{degrees} degrees: {judged} graphs refined and judged"));
        partial.iter().for_each(|name| say(format!("{degrees} degrees: a limit stopped {name}")));
        coarse
            .iter()
            .for_each(|name| say(format!("{degrees} degrees: doubles too coarse for {name}")));
        for (name, ratios) in ["Triangle", "CGAL"].iter().zip(&mut self.ratios) {
            let n = ratios.len();
            if n == 0 {
                continue;
            }
            let mut row = format!("{degrees} degrees, ours / {name}'s, {n} graphs:");
            ratios.sort_by(|a, b| a.1.total_cmp(&b.1));
            let at = |place: usize| &ratios[place.min(n - 1)];
            row += &format!(
                " seconds {:.3} {:.3} {:.3};",
                at(n / 10).1,
                at(n / 2).1,
                at(9 * n / 10).1
            );
            row += &format!(" slowest {:.2} {};", at(n).1, at(n).2);
            ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
            let at = |place: usize| &ratios[place.min(n - 1)];
            row += &format!(
                " vertices {:.3} {:.3} {:.3};",
                at(n / 10).0,
                at(n / 2).0,
                at(9 * n / 10).0
            );
            row += &format!(" most {:.3} {}", at(n).0, at(n).2);
            let median = at(n / 2).0;
            say(row);
            assert!(median <= 1.05, "{name}: {median}");
        }
    }
}
