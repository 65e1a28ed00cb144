//! Stopping long work: at a time limit, or when the user interrupts.

use std::fmt;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use delone_probe::{Event, Probe};

use crate::failure::Failure;
use crate::output;
use crate::progress::Progress;
use crate::result::grouped;

/// Whether the user has interrupted.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Sites between two looks at the clock.
const STRIDE: u32 = 64;

/// Seconds that a run may take, as given.
pub(crate) fn limit(seconds: Option<f64>) -> Result<Option<Duration>, Failure> {
    let Some(seconds) = seconds else { return Ok(None) };
    let limit = Duration::try_from_secs_f64(seconds);
    limit.map(Some).map_err(|error| Failure::input(format!("--time-limit {seconds}: {error}")))
}

/// Whether something asks, and stops by itself.
static LISTENS: AtomicBool = AtomicBool::new(false);

/// From here on an interruption leaves nothing half-written. It ends the program, but for the first one while something
/// [listens](listen).
pub(crate) fn guard() {
    // Where no handler can be set an interruption ends the program at once: files are whole all the same, or not there but for a
    // hidden part.
    let _ = ctrlc::set_handler(|| {
        if !LISTENS.load(Ordering::Relaxed) || INTERRUPTED.swap(true, Ordering::Relaxed) {
            output::remove_unfinished();
            std::process::exit(130);
        }
    });
}

/// From here on the first interruption only stops what asks; the second ends the program.
pub(crate) fn listen() {
    LISTENS.store(true, Ordering::Relaxed);
}

/// Whether the user has interrupted since [`listen`].
pub(crate) fn is_interrupted() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}

/// A probe that stops at a time limit and at an interruption, and lets another one listen.
pub(crate) struct Watch<'p> {
    progress: Option<&'p mut Progress>,
    limit: Option<Duration>,
    start: Instant,
    asked: u32,
    sites: [usize; 2],
}

impl<'p> Watch<'p> {
    /// Begins to watch. From here on the first interruption only stops what asks; the second ends the program.
    pub(crate) fn start(progress: Option<&'p mut Progress>, limit: Option<Duration>) -> Self {
        listen();
        Self::by_clock(progress, limit)
    }

    /// The same, but an interruption ends the program, as ever.
    pub(crate) fn by_clock(progress: Option<&'p mut Progress>, limit: Option<Duration>) -> Self {
        Self { progress, limit, start: Instant::now(), asked: 0, sites: [0, 0] }
    }
}

impl Drop for Watch<'_> {
    fn drop(&mut self) {
        LISTENS.store(false, Ordering::Relaxed);
    }
}

impl fmt::Display for Watch<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.limit {
            Some(limit) if !INTERRUPTED.load(Ordering::Relaxed) => {
                write!(f, "the time limit of {} s was reached", limit.as_secs_f64())?;
            }
            _ => write!(f, "interrupted")?,
        }
        let [done, total] = self.sites.map(|count| grouped(count as u64));
        if self.sites[1] > 0 {
            write!(f, " with {done} of {total} sites in")?;
        }
        write!(f, "; there is no result, and nothing was written")
    }
}

impl Probe for Watch<'_> {
    fn on(&mut self, event: Event) {
        if let Event::Site { done, total } = event {
            self.sites = [done, total];
        }
        if let Some(progress) = &mut self.progress {
            progress.on(event);
        }
    }

    fn goes_on(&mut self) -> bool {
        let looks = self.asked.is_multiple_of(STRIDE);
        self.asked = self.asked.wrapping_add(1);
        let is_over = looks && self.limit.is_some_and(|limit| self.start.elapsed() >= limit);
        !(is_over || INTERRUPTED.load(Ordering::Relaxed))
    }
}
