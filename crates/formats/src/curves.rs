//! The one rule by which curves become lines: eight steps of equal parameter per Bezier piece.
//!
//! A fixed count keeps the result the same on every machine and free of any tolerance; end points are taken as written.

/// Steps per Bezier piece.
const STEPS: u8 = 8;

/// Appends the piece that starts at `from` and has the other control points `controls`, without `from` itself.
pub(crate) fn flatten(from: [f64; 2], controls: &[[f64; 2]], out: &mut Vec<[f64; 2]>) {
    for step in 1..STEPS {
        let t = f64::from(step) / f64::from(STEPS);
        let mut points: Vec<[f64; 2]> =
            std::iter::once(from).chain(controls.iter().copied()).collect();
        while points.len() > 1 {
            points = points.windows(2).map(|pair| between(pair[0], pair[1], t)).collect();
        }
        out.extend(points);
    }
    out.extend(controls.last());
}

fn between(a: [f64; 2], b: [f64; 2], t: f64) -> [f64; 2] {
    [a[0] * (1.0 - t) + b[0] * t, a[1] * (1.0 - t) + b[1] * t]
}

#[cfg(test)]
mod tests;
