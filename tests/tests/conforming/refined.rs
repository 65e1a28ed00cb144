//! The collected files, refined at 20.7 and 30 degrees: judged, angles too, and beside Triangle and CGAL. What a limit stops has a gap that is proved
//! to ask for more triangles than there may be. Skipped, said aloud, where there are none. Without `DELONE_LONG=1` one in ten, and only small ones. Times are worth something in a release build alone.

use std::time::Instant;

use delone::Pslg;
use delone::cdt::Fill;
use delone::conforming::{Limits, Reason, RefineOptions, Refined, narrowest_gap, refine};
use delone_tests::case::Case;
use delone_tests::cgal::Cgal;
use delone_tests::data::{documents, files, pslg_of};
use delone_tests::{judge, long, say};

use crate::effort::{Ratios, tell_names};

/// The opponents, and what came of them.
struct Table {
    degrees: f64,
    triangle: Option<Cgal>,
    cgal: Option<Cgal>,
    /// By peer: vertices, and seconds.
    ratios: [[Ratios; 2]; 2],
    /// By peer: inputs of which it said nothing in ten seconds.
    silent: [Vec<String>; 2],
    judged: usize,
    /// What a limit stopped, each with the triangles that it takes at least.
    partial: Vec<String>,
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
            silent: Default::default(),
            judged: 0,
            partial: Vec::new(),
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
        let short = case.name.rsplit("pslg/").next().unwrap_or(&case.name);
        let name = format!("{short} ({} sites)", pslg.sites().len());
        let ours = refined.triangulation().kernel().len();
        let gap =
            narrowest_gap(&pslg, &Fill::Exterior, self.degrees).expect("the exterior is a rule");
        let triangles_min = gap.map_or(0.0, |gap| gap.triangles_min);
        if !refined.is_complete() {
            // There are fewer than two for each vertex.
            let vertices_max = options.limits.vertices_max;
            assert!(triangles_min > 2.0 * vertices_max as f64, "{name}: stopped, {gap:?}");
            return self.partial.push(format!("{name}, {triangles_min:.1e} triangles"));
        }
        assert_eq!(refined.left_alone_for(Reason::Unreachable), 0, "{name}");
        assert!(refined.cells().count() as f64 >= triangles_min, "{name}: {gap:?}");
        let verdict = judge::refined(&pslg, &refined, options.cosine_square());
        assert!(verdict.ok, "{name}: {verdict}");
        self.judged += 1;
        let (degrees, points, pieces) = (self.degrees, pslg.sites().points(), pslg.subsegments());
        let starts: [fn() -> Option<Cgal>; 2] = [Cgal::triangle, Cgal::start];
        let peers = [&mut self.triangle, &mut self.cgal];
        for ((number, peer), again) in peers.into_iter().enumerate().zip(starts) {
            let Some(running) = peer.as_mut() else { continue };
            match running.refine(degrees, points, pieces) {
                Some([theirs, cells]) if cells > 0 => {
                    let [vertices, times] = &mut self.ratios[number];
                    vertices.push(ours as f64 / theirs as f64, &name);
                    times.push(seconds / running.seconds(), &name);
                }
                Some(_) => {}
                None => {
                    self.silent[number].push(name.clone());
                    *peer = again();
                }
            }
        }
    }

    /// Refined, the best of three times if it takes less than a second; `None` if nothing is inside.
    fn refined(&self, pslg: &Pslg) -> Option<(Refined, f64, RefineOptions<'static>)> {
        let vertices_max = 20 * pslg.sites().len() + if long() { 2_000_000 } else { 20_000 };
        let options = RefineOptions {
            angle_deg_min: self.degrees,
            limits: Limits { vertices_max },
            ..RefineOptions::default()
        };
        let once = || {
            let start = Instant::now();
            let refined = refine(pslg, &Fill::Exterior, &options, &mut ()).ok()?;
            Some((refined, start.elapsed().as_secs_f64()))
        };
        let (refined, mut best) = once()?;
        for _ in 0..if long() && best < 1.0 { 2 } else { 0 } {
            best = best.min(once()?.1);
        }
        let has_inside = refined.cells().next().is_some();
        has_inside.then_some((refined, best, options))
    }

    fn tell(&mut self) {
        let Self { degrees, judged, .. } = self;
        say(format!("{degrees} degrees: {judged} graphs refined and judged"));
        tell_names(&format!("{degrees} degrees: stopped by a limit"), &self.partial);
        for (number, peer) in ["Triangle", "CGAL"].into_iter().enumerate() {
            tell_names(&format!("{degrees} degrees: {peer} does not answer"), &self.silent[number]);
            let [vertices, times] = &mut self.ratios[number];
            let [_, median] = [("seconds", times), ("vertices", vertices)].map(|(what, ratios)| {
                ratios.tell(&format!("{degrees} degrees, {what}, ours / {peer}'s"))
            });
            assert!(median.is_none_or(|median| median <= 1.05), "{peer}: {median:?}");
        }
    }
}
