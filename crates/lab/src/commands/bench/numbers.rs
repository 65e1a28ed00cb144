//! Medians, spreads, ratios with intervals.

use delone_workloads::Rng;

/// The median; not a number if there is none.
pub(super) fn median(times: &[f64]) -> f64 {
    quantile(times, 0.5)
}

/// The value below which this part of the times lies.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "a place in a list"
)]
pub(super) fn quantile(times: &[f64], part: f64) -> f64 {
    let mut sorted = times.to_vec();
    sorted.sort_by(f64::total_cmp);
    let place = (sorted.len().saturating_sub(1) as f64 * part).round() as usize;
    sorted.get(place).copied().unwrap_or(f64::NAN)
}

/// The geometric mean.
#[expect(clippy::cast_precision_loss, reason = "a few numbers")]
pub(super) fn geometric_mean(ratios: &[f64]) -> f64 {
    (ratios.iter().map(|ratio| ratio.ln()).sum::<f64>() / ratios.len() as f64).exp()
}

/// Resamplings for an interval.
const SAMPLES: usize = 1000;

/// Median of `after` over median of `before`, with the interval that holds 95 of 100 bootstrap samples.
pub(super) fn ratio(before: &[f64], after: &[f64]) -> [f64; 3] {
    let mut rng = Rng::named("bootstrap", 1);
    let mut sample = |times: &[f64]| {
        let drawn: Vec<f64> = times.iter().map(|_| times[rng.index(times.len())]).collect();
        median(&drawn)
    };
    let ratios: Vec<f64> = (0..SAMPLES).map(|_| sample(after) / sample(before)).collect();
    [quantile(&ratios, 0.025), median(after) / median(before), quantile(&ratios, 0.975)]
}

#[cfg(test)]
mod tests;
