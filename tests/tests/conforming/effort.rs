//! What came of many inputs: ratios with a peer, and the names of those of which nothing else can be said.

use delone_tests::say;

/// Ratios, ours over a peer's, by input.
#[derive(Default)]
pub(crate) struct Ratios(Vec<(f64, String)>);

impl Ratios {
    pub(crate) fn push(&mut self, ratio: f64, name: &str) {
        self.0.push((ratio, name.to_owned()));
    }

    /// Says the 10th percentile, the median and the 90th, and the largest with its name; the median.
    pub(crate) fn tell(&mut self, of_what: &str) -> Option<f64> {
        self.0.sort_by(|a, b| a.0.total_cmp(&b.0));
        let n = self.0.len();
        let at = |place: usize| self.0.get(place.min(n.saturating_sub(1)));
        let [low, median, high, most] = [at(n / 10)?, at(n / 2)?, at(9 * n / 10)?, at(n)?];
        say(format!(
            "{of_what}, {n} inputs: {:.3} {:.3} {:.3}; most {:.3} {}",
            low.0, median.0, high.0, most.0, most.1
        ));
        Some(median.0)
    }
}

/// Says how many there are, and which.
pub(crate) fn tell_names(of_what: &str, names: &[String]) {
    if !names.is_empty() {
        say(format!("{of_what}: {}: {}", names.len(), names.join(", ")));
    }
}
