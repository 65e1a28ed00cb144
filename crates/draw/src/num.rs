//! Every conversion between numbers, so that no other file casts.

/// The nearest single: coordinates of the unit square, for a canvas.
#[expect(clippy::cast_possible_truncation, reason = "a canvas needs no more than single precision")]
pub(crate) fn single(x: f64) -> f32 {
    x as f32
}

/// A count as a double.
pub(crate) fn real(i: usize) -> f64 {
    i as f64
}

/// A number of [0, 1] as a byte.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "`as` saturates, and the argument is clamped"
)]
pub(crate) fn byte(x: f64) -> u8 {
    (x.clamp(0.0, 1.0) * 255.0) as u8
}

/// The item at a 32-bit index, if there is one.
pub(crate) fn at<T: Copy>(items: &[T], i: u32) -> Option<T> {
    usize::try_from(i).ok().and_then(|i| items.get(i).copied())
}
