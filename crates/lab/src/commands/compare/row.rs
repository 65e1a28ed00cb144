//! One algorithm on one input: run, counted, judged.
//!
//! Algorithms that add no points all make one triangulation, and have to agree. Methods with Steiner points each make their own,
//! which each is to be judged by its own promise; they have to agree with themselves, when points and segments come in reverse order.

use std::time::{Duration, Instant};

use delone_check::{Level, Verdict};
use delone_conforming::{ConformOptions, Conforming, Limits, Method};
use delone_delaunay::Options;
use delone_probe::Counts;
use delone_sites::Pslg;

use crate::engine::{self, Sizes};
use crate::failure::Failure;
use crate::pictures::Drawing;
use crate::progress::Progress;
use crate::subject::{self, Subject};
use crate::watch::{self, Watch};
use crate::{cli, steiner};

/// What came of it.
pub(super) struct Row {
    pub(super) algorithm: &'static str,
    pub(super) fingerprint: String,
    /// The median of the runs.
    pub(super) seconds: f64,
    pub(super) runs: usize,
    pub(super) check_seconds: f64,
    pub(super) counts: Counts,
    pub(super) sizes: Sizes,
    /// None of a method that was stopped too late for a judge.
    pub(super) verdict: Option<Verdict>,
    /// Of a method with Steiner points.
    pub(super) added: Option<Added>,
}

/// What only methods with Steiner points have to tell.
pub(super) struct Added {
    pub(super) points: usize,
    pub(super) is_complete: bool,
    empties_disks: bool,
    /// Whether the input in reverse order has the same result; none if a limit was reached.
    pub(super) ignores_order: Option<bool>,
}

impl Row {
    /// Whether the judge has found a fault.
    pub(super) fn is_refuted(&self) -> bool {
        self.verdict.as_ref().is_some_and(|verdict| !verdict.ok)
    }

    pub(super) fn is_stopped(&self) -> bool {
        self.added.as_ref().is_some_and(|added| !added.is_complete)
    }

    pub(super) fn depends_on_order(&self) -> bool {
        self.added.as_ref().is_some_and(|added| added.ignores_order == Some(false))
    }

    /// What was proved, or that it was not.
    pub(super) fn word(&self) -> String {
        let Some(verdict) = &self.verdict else { return "stopped, not judged".to_owned() };
        let level = verdict.level.name();
        match &self.added {
            _ if !verdict.ok => "not proved".to_owned(),
            Some(added) if !added.is_complete => format!("stopped: {level}"),
            Some(added) if added.empties_disks && verdict.level == Level::Conforming => {
                format!("{level}, empty disks")
            }
            _ => level.to_owned(),
        }
    }
}

/// Runs longer than this are not repeated.
const REPEAT_BELOW_SECONDS: f64 = 0.2;
const RUNS: usize = 5;

/// A result and the seconds that it took, until there are five or the first took long: the first result, the median and their number.
fn repeated<T>(mut run: impl FnMut() -> (T, f64)) -> (T, f64, usize) {
    let (result, first) = run();
    let mut seconds = vec![first];
    while seconds.len() < RUNS && first < REPEAT_BELOW_SECONDS {
        seconds.push(run().1);
    }
    seconds.sort_by(f64::total_cmp);
    (result, seconds[seconds.len() / 2], seconds.len())
}

/// An algorithm that adds no points, with a picture.
pub(super) fn of_algorithm(subject: &Subject, name: &'static str) -> (Row, Drawing) {
    let options = Options::default();
    let (triangulation, seconds, runs) = repeated(|| {
        let built = engine::run(subject, name, &options, None);
        (built.triangulation, built.seconds)
    });
    let mut progress = Progress::new(name, true);
    engine::run(subject, name, &options, Some(&mut progress));
    let clock = Instant::now();
    let verdict = triangulation.verdict(subject);
    let row = Row {
        algorithm: name,
        fingerprint: triangulation.fingerprint(subject).to_string(),
        seconds,
        runs,
        check_seconds: clock.elapsed().as_secs_f64(),
        counts: progress.counts,
        sizes: triangulation.sizes(subject),
        verdict: Some(verdict),
        added: None,
    };
    (row, Drawing::of(subject, Some(&triangulation)))
}

/// How far methods go.
#[derive(Clone, Copy)]
pub(super) struct Bounds {
    vertices_max: Option<usize>,
    time: Option<Duration>,
}

/// Vertices beyond which a result that is not complete is not judged: its numbers are as long as its gaps are small.
const JUDGED_MAX: usize = 2_000;

impl Bounds {
    pub(super) fn new(bounds: cli::Bounds) -> Result<Self, Failure> {
        let time = watch::limit(Some(bounds.time_limit))?;
        Ok(Self { vertices_max: bounds.vertices_max, time })
    }

    fn run(self, method: &Method, pslg: &Pslg, listener: Option<&mut Progress>) -> Conforming {
        let enough = pslg.sites().len().saturating_mul(10).saturating_add(10_000);
        let limits = Limits { vertices_max: self.vertices_max.unwrap_or(enough) };
        let options = ConformOptions { limits, ..ConformOptions::default() };
        (method.run)(pslg, &options, &mut Watch::by_clock(listener, self.time))
    }
}

/// A method with Steiner points, with a picture.
pub(super) fn of_method(subject: &Subject, method: &Method, bounds: Bounds) -> (Row, Drawing) {
    let pslg = steiner::graph(subject);
    let (conforming, seconds, runs) = repeated(|| {
        let clock = Instant::now();
        let conforming = bounds.run(method, pslg, None);
        (conforming, clock.elapsed().as_secs_f64())
    });
    let mut progress = Progress::new(method.name, true);
    bounds.run(method, pslg, Some(&mut progress));
    let result = steiner::Result { subject, pslg, conforming: &conforming, inside: None };
    let (is_complete, sizes) = (conforming.is_complete(), result.sizes());
    let clock = Instant::now();
    let is_judged = is_complete || sizes.vertices <= JUDGED_MAX;
    let verdict = is_judged.then(|| result.verdict(method));
    let check_seconds = clock.elapsed().as_secs_f64();
    let fingerprint = conforming.fingerprint();
    let reversed = reversed(subject).filter(|_| is_complete);
    let again = reversed.map(|reversed| bounds.run(method, &reversed, None));
    let again = again.filter(Conforming::is_complete);
    let row = Row {
        algorithm: method.name,
        fingerprint: fingerprint.to_string(),
        seconds,
        runs,
        check_seconds,
        counts: progress.counts,
        verdict,
        added: Some(Added {
            points: sizes.vertices - pslg.sites().len(),
            is_complete,
            empties_disks: method.empties_disks,
            ignores_order: again.map(|again| again.fingerprint() == fingerprint),
        }),
        sizes,
    };
    (row, result.drawing(&result.document()))
}

/// The graph again, its points and segments in reverse order, each segment turned round.
fn reversed(subject: &Subject) -> Option<Pslg> {
    let (mut points, mut segments) = subject::lists(&subject.document).ok()?;
    let last = points.len().checked_sub(1)?;
    points.reverse();
    segments.reverse();
    segments.iter_mut().for_each(|ends| *ends = [last - ends[1], last - ends[0]]);
    Pslg::new(&points, &segments).ok()
}
