//! Formulas over a ring, and the stages that decide them: doubles with error bounds, short integers, numbers of any length.

use smallvec::SmallVec;

use crate::exact::align::one_limb;
use crate::narrow::Narrow;
use crate::ring::{self, Homogeneous, Ring};
use crate::{Approximate, Dyadic, Sign};

/// A ring whose numbers have a sign, if it is known.
pub(crate) trait Signed: Ring {
    /// The sign, unless the number is too inexact.
    fn known_sign(&self) -> Option<Sign>;
}

impl Signed for Approximate {
    #[inline]
    fn known_sign(&self) -> Option<Sign> {
        self.sign()
    }
}

impl<const N: usize> Signed for Narrow<N> {
    fn known_sign(&self) -> Option<Sign> {
        self.sign()
    }
}

impl Signed for Dyadic {
    fn known_sign(&self) -> Option<Sign> {
        Some(self.sign())
    }
}

/// What a question is about, in numbers of one kind.
pub(crate) struct Call<T, const D: usize> {
    pub(crate) points: SmallVec<[Homogeneous<T, D>; 5]>,
    /// Weights, bounds: whatever scales as squares of coordinates.
    pub(crate) squares: SmallVec<[T; 2]>,
}

/// A question that has one answer whatever powers of two multiply its points, each (X : W) by one of its own, and all
/// coordinates by another.
pub(crate) trait Formula<const D: usize> {
    /// A sign or an order.
    type Answer;

    /// Whether eight limbs are known to be too few, as a rule.
    const IS_LONG: bool = false;

    /// Whether there is a formula in words.
    const HAS_WORDS: bool = false;

    /// The answer for plain points, if there is a quicker formula in fixed widths: of coordinates over one unit, at most 2^61 in magnitude, the
    /// third zero in the plane.
    fn in_words(&self, _points: &[[i64; 3]]) -> Option<Self::Answer> {
        None
    }

    /// The answer, unless a sign is not known.
    fn answer<T: Signed>(&self, call: &Call<T, D>) -> Option<Self::Answer>;
}

impl<T, const D: usize> Call<T, D> {
    pub(crate) const fn new() -> Self {
        Self { points: SmallVec::new_const(), squares: SmallVec::new_const() }
    }
}

/// The most points of a formula in words.
const POINTS: usize = 8;

/// The answer in words, if all points are doubles, of at most three coordinates.
#[inline]
pub(crate) fn in_words<const D: usize, F: Formula<D>>(
    formula: &F,
    points: impl Iterator<Item = Option<[f64; D]>>,
) -> Option<F::Answer> {
    let (mut values, mut count) = ([0.0; 3 * POINTS], 0);
    for point in points {
        values.get_mut(3 * count..3 * count + 3)?.get_mut(..D)?.copy_from_slice(&point?);
        count += 1;
    }
    let integers = one_limb(&values)?;
    formula.in_words(&integers.as_chunks().0[..count])
}

/// The answer: in short integers if they suffice, of eight limbs and then of sixteen.
pub(crate) fn exactly<const D: usize, F: Formula<D>>(
    formula: &F,
    call: &Call<Dyadic, D>,
) -> F::Answer {
    let short = if F::IS_LONG { None } else { in_limbs::<8, D, F>(formula, call) };
    short
        .or_else(|| in_limbs::<16, D, F>(formula, call))
        .unwrap_or_else(|| formula.answer(call).expect("exact numbers have a sign"))
}

/// The answer, if N limbs suffice.
#[inline(never)]
fn in_limbs<const N: usize, const D: usize, F: Formula<D>>(
    formula: &F,
    call: &Call<Dyadic, D>,
) -> Option<F::Answer> {
    let mut short = Call::<Narrow<N>, D>::new();
    if narrow_into(&mut short, call) { formula.answer(&short) } else { None }
}

/// All numbers as integers on one power of two, a W on one of its own; whether they are short enough. Into a place of the
/// caller's, since calls are long to move.
fn narrow_into<const N: usize, const D: usize>(
    short: &mut Call<Narrow<N>, D>,
    call: &Call<Dyadic, D>,
) -> bool {
    let low = unit(call);
    for Homogeneous { x, w } in &call.points {
        let x = x.each_ref().map(|x| Narrow::aligned(x, low + w.exponent()));
        short.points.push(Homogeneous { x, w: Narrow::aligned(w, w.exponent()) });
    }
    short.squares.extend(call.squares.iter().map(|x| Narrow::aligned(x, 2 * low)));
    let of_points = short.points.iter().flat_map(|Homogeneous { x, w }| x.iter().chain([w]));
    !of_points.chain(&short.squares).any(Narrow::is_lost)
}

/// The exponent over which all coordinates are integers, and twice which all squares.
fn unit<const D: usize>(call: &Call<Dyadic, D>) -> i64 {
    let is_some = |x: &&Dyadic| x.sign() != Sign::Zero;
    let coordinates = call.points.iter().flat_map(|Homogeneous { x, w }| {
        x.iter().filter(is_some).map(|x| x.exponent() - w.exponent())
    });
    let squares = call.squares.iter().filter(is_some).map(|x| x.exponent().div_euclid(2));
    coordinates.chain(squares).min().unwrap_or(0)
}

/// The orientation on some axes.
pub(crate) struct Orient<'a>(pub(crate) &'a [usize]);

impl<const D: usize> Formula<D> for Orient<'_> {
    type Answer = Sign;
    fn answer<T: Signed>(&self, call: &Call<T, D>) -> Option<Sign> {
        ring::orient(&call.points, self.0).known_sign()
    }
}

/// The lifted determinant on some axes.
pub(crate) struct Lifted<'a>(pub(crate) &'a [usize]);

impl<const D: usize> Formula<D> for Lifted<'_> {
    type Answer = Sign;
    fn answer<T: Signed>(&self, call: &Call<T, D>) -> Option<Sign> {
        ring::lifted(&call.points, self.0).known_sign()
    }
}

/// The cross product of two edges of the plane.
pub(crate) struct Cross;

impl Formula<2> for Cross {
    type Answer = Sign;
    fn answer<T: Signed>(&self, call: &Call<T, 2>) -> Option<Sign> {
        let points = call.points.as_slice().try_into().expect("four points");
        ring::cross(points).known_sign()
    }
}

#[cfg(test)]
mod tests;
