//! Chains: cells with integer coefficients, and what is left of a sum of them.

use std::fmt;

use crate::Rule;

/// The sum of a chain's terms, sorted, each cell once, none with coefficient zero. Under the even-odd rule modulo two.
pub(crate) fn summed<C: PartialOrd>(
    terms: impl Iterator<Item = (C, i64)>,
    rule: Rule,
) -> Vec<(C, i64)> {
    let mut terms: Vec<(C, i64)> = terms.collect();
    terms.sort_by(|a, b| a.0.partial_cmp(&b.0).expect("coordinates are finite"));
    terms.dedup_by(|next, kept| {
        let same = next.0 == kept.0;
        kept.1 += if same { next.1 } else { 0 };
        same
    });
    if rule == Rule::EvenOdd {
        terms.iter_mut().for_each(|term| term.1 = term.1.rem_euclid(2));
    }
    terms.retain(|term| term.1 != 0);
    terms
}

/// Simplices given by the indices of their corners, as their corners.
///
/// # Errors
/// With all points that are not finite, or all simplices that name no point.
pub(crate) fn placed<'a, const N: usize, const K: usize, F>(
    points: &'a [[f64; N]],
    simplices: &'a [[usize; K]],
) -> Result<impl Iterator<Item = [[f64; N]; K]> + 'a, BoundaryFault<F>> {
    let strange = |&i: &usize| points[i].iter().any(|c| !c.is_finite());
    let not_finite: Vec<usize> = (0..points.len()).filter(strange).collect();
    if !not_finite.is_empty() {
        return Err(BoundaryFault::NotFinite(not_finite));
    }
    let nowhere = |&i: &usize| simplices[i].iter().any(|&corner| corner >= points.len());
    let no_such: Vec<usize> = (0..simplices.len()).filter(nowhere).collect();
    if !no_such.is_empty() {
        return Err(BoundaryFault::NoSuchPoint(no_such));
    }
    let place = |i: usize| points[i].map(|c| c + 0.0);
    Ok(simplices.iter().map(move |corners| corners.map(place)))
}

/// Why simplices bound nothing.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum BoundaryFault<F> {
    /// Points with a coordinate that is no finite number.
    NotFinite(Vec<usize>),
    /// Simplices that name no point.
    NoSuchPoint(Vec<usize>),
    /// Where the boundary is not closed: an odd number of simplices ends there, or under [`Rule::NonZero`] not as many with the
    /// one direction as with the other.
    Open(Vec<F>),
}

impl<F: fmt::Debug> fmt::Display for BoundaryFault<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite(points) => write!(
                f,
                "points {points:?} have coordinates that are no numbers: give finite ones"
            ),
            Self::NoSuchPoint(simplices) => {
                write!(f, "cells {simplices:?} name points that are not there: check indices")
            }
            Self::Open(places) => {
                let shown = &places[..places.len().min(SHOWN_MAX)];
                let more = if places.len() > SHOWN_MAX { " and more" } else { "" };
                write!(f, "the boundary is open at {shown:?}{more}: close it")
            }
        }
    }
}

impl<F: fmt::Debug> std::error::Error for BoundaryFault<F> {}

/// Places named in a message.
const SHOWN_MAX: usize = 8;
