//! Maps of doubles that lose nothing, or say that they would.

/// `2^k`, for k from -1074 to 1023.
#[must_use]
pub fn power_of_two(k: i32) -> f64 {
    if k >= -1022 {
        f64::from_bits(u64::from((k + 1023).cast_unsigned()) << 52)
    } else {
        f64::from_bits(1 << (k + 1074).cast_unsigned())
    }
}

/// All points times `2^k`, if no bit is lost.
#[must_use]
pub fn scaled<const D: usize>(points: &[[f64; D]], k: i32) -> Option<Vec<[f64; D]>> {
    let factor = power_of_two(k);
    each(points, |_, x| {
        let y = x * factor;
        (y.is_finite() && y / factor == x).then_some(y)
    })
}

/// All points plus `offset`, if every sum is exact.
#[must_use]
pub fn translated<const D: usize>(points: &[[f64; D]], offset: [f64; D]) -> Option<Vec<[f64; D]>> {
    each(points, |axis, x| {
        let (sum, lost) = two_sum(x, offset[axis]);
        (sum.is_finite() && lost == 0.0).then_some(sum)
    })
}

/// The rounded sum and what rounding lost (Knuth); the second is not zero if the first overflows.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_virtual = sum - a;
    (sum, (a - (sum - b_virtual)) + (b - b_virtual))
}

fn each<const D: usize>(
    points: &[[f64; D]],
    map: impl Fn(usize, f64) -> Option<f64>,
) -> Option<Vec<[f64; D]>> {
    points
        .iter()
        .map(|p| {
            let mut image = *p;
            for (axis, x) in image.iter_mut().enumerate() {
                *x = map(axis, *x)?;
            }
            Some(image)
        })
        .collect()
}

/// The double `steps` representable numbers above (or below) a finite one; finite.
#[must_use]
pub fn nudged(x: f64, steps: i32) -> f64 {
    let mut y = x;
    for _ in 0..steps.unsigned_abs() {
        let next = if steps > 0 { y.next_up() } else { y.next_down() };
        if next.is_finite() {
            y = next;
        }
    }
    y
}
