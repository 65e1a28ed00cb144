//! A progress bar that listens to an algorithm: on standard error, and only on a terminal.

use std::time::Duration;

use delone_probe::{Counts, Event, Probe};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// What is being done, told on a terminal.
pub(crate) fn spinner(quiet: bool) -> ProgressBar {
    let target =
        if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr_with_hz(5) };
    let bar = ProgressBar::with_draw_target(None, target);
    let style = ProgressStyle::with_template("{spinner} {msg} {elapsed}");
    bar.set_style(style.expect("the template is well formed"));
    bar.enable_steady_tick(Duration::from_millis(500));
    bar
}

/// Long work without a length, told on a terminal for as long as this lives; nothing else is printed meanwhile.
pub(crate) struct Busy(ProgressBar);

impl Busy {
    pub(crate) fn new(quiet: bool, what: &'static str) -> Self {
        let bar = spinner(quiet);
        bar.set_message(what);
        Self(bar)
    }

    /// Something else is being done now.
    pub(crate) fn at(&self, what: &'static str) {
        self.0.set_message(what);
    }
}

impl Drop for Busy {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}

/// Counts, and shows how many sites are in.
pub(crate) struct Progress {
    pub(crate) counts: Counts,
    bar: ProgressBar,
}

/// Sites between two looks at the bar.
const STRIDE: usize = 4096;

impl Progress {
    pub(crate) fn new(name: &str, quiet: bool) -> Self {
        let target = if quiet {
            ProgressDrawTarget::hidden()
        } else {
            ProgressDrawTarget::stderr_with_hz(5)
        };
        let bar = ProgressBar::with_draw_target(Some(0), target);
        let style = ProgressStyle::with_template(
            "{msg} {wide_bar} {human_pos}/{human_len} sites, {eta} left",
        );
        bar.set_style(style.expect("the template is well formed"));
        bar.set_message(name.to_owned());
        bar.enable_steady_tick(Duration::from_millis(500));
        Self { counts: Counts::default(), bar }
    }

    pub(crate) fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

impl Probe for Progress {
    fn on(&mut self, event: Event) {
        self.counts.on(event);
        if let Event::Site { done, total } = event
            && done % STRIDE == 0
        {
            self.bar.set_length(total as u64);
            self.bar.set_position(done as u64);
        }
    }
}
