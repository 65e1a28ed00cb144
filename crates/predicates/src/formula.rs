//! Formulas over a ring, and the stages that decide them: doubles with error bounds, numbers of any length;
//! and quicker formulas in words.

use smallvec::SmallVec;

use crate::exact::align::one_limb;
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

/// The answer in numbers of any length.
pub(crate) fn exactly<const D: usize, F: Formula<D>>(
    formula: &F,
    call: &Call<Dyadic, D>,
) -> F::Answer {
    formula.answer(call).expect("exact numbers have a sign")
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
