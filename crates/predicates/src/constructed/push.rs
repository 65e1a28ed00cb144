//! How constructed points come in.

use super::lazy::Value;
use super::{Constructed, Construction, ConstructionError, PLAIN, ROUNDED};
use crate::Dyadic;
use crate::dyadic::nearest_ratio;
use crate::ring::Homogeneous;

impl<const D: usize> Constructed<D> {
    /// Adds a constructed point. Its id. O(1).
    ///
    /// # Errors
    /// If the construction is not from plain points, makes no point, or is not one of this dimension.
    ///
    /// # Panics
    /// If there are 2^32 - 1 points.
    pub fn push(&mut self, construction: &Construction) -> Result<u32, ConstructionError> {
        construction.parents().try_for_each(|id| self.check_plain(id))?;
        let exact = construction.value(|id| self.positions[id as usize])?;
        Ok(self.add_known(exact))
    }

    /// Adds a point by its coordinates, exactly; one of doubles is not plain either. Its id. O(1).
    ///
    /// # Panics
    /// If there are 2^32 - 1 points.
    pub fn push_exact(&mut self, point: [Dyadic; D]) -> u32 {
        self.add_known(Homogeneous::plain(point))
    }

    /// [`Construction::SegmentPoint`] with a parameter that is a double: no long number is made before one is needed.
    ///
    /// # Errors
    /// If `a` or `b` is not a plain point.
    ///
    /// # Panics
    /// If the parameter is not finite, or if there are 2^32 - 1 points.
    pub fn push_between(&mut self, [a, b]: [u32; 2], t: f64) -> Result<u32, ConstructionError> {
        [a, b].into_iter().try_for_each(|id| self.check_plain(id))?;
        let ends = [a, b].map(|id| self.positions[id as usize]);
        match Value::between(ends, t) {
            Some((value, position, is_exact)) => Ok(self.add_value(value, position, is_exact)),
            None => self.push(&Construction::SegmentPoint { a, b, t: t.into() }),
        }
    }

    fn check_plain(&self, id: u32) -> Result<(), ConstructionError> {
        match self.places.get(id as usize) {
            None => Err(ConstructionError::Unknown { id }),
            Some(&place) if place & !ROUNDED != PLAIN => Err(ConstructionError::NotPlain { id }),
            Some(_) => Ok(()),
        }
    }

    fn add_known(&mut self, exact: Homogeneous<Dyadic, D>) -> u32 {
        let position = exact.x.each_ref().map(|x| nearest_ratio(x, &exact.w));
        let is_exact = |axis: usize| {
            position[axis].is_finite() && Dyadic::from(position[axis]) * &exact.w == exact.x[axis]
        };
        let all_exact = (0..D).all(is_exact);
        self.add_value(Value::known(exact), position, all_exact)
    }

    fn add_value(&mut self, value: Value<D>, position: [f64; D], is_exact: bool) -> u32 {
        let rounded = if is_exact { 0 } else { ROUNDED };
        let place = u32::try_from(self.values.len()).ok().filter(|&place| place < PLAIN);
        self.values.push(value);
        self.add(position, place.expect("fewer than 2^31 - 1 constructed points") | rounded)
    }
}
