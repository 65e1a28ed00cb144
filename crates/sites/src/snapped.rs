//! Segments cut where they cross, with vertices that are doubles: an arrangement, rounded, as often as rounding makes new crossings.
//!
//! **Method.** The exact [`Arrangement`] is made and each crossing rounded to the nearest double; its pieces, between rounded ends, are
//! the segments of the next round, until none cross. What was given never moves, and no vertex moves once it is
//! rounded: a round only cuts. A bound on the rounds is not known (snap rounding to the pixels of a grid has one, and moves
//! all vertices for it); so it is an argument, and to exceed it is said. **Cost.** That of an arrangement each round.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a rounded piece crosses another | both are cut in the next round | `rounding_may_cross_again` |
//! | a piece whose ends round to one double | stays as a segment of no length, which is dropped | `pieces_may_collapse` |
//! | a vertex that rounds to a site | is that site | `pieces_may_collapse` |
//! | pieces that come to lie over one another | both stay, with their multiplicity | `pieces_may_collapse` |

use crate::{Arrangement, Noded, PslgError};

/// Points and segments that do not cross, made of some that did. See the module's text.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapped {
    /// The input points, and then the crossings.
    pub points: Vec<[f64; 2]>,
    /// The pieces, in the order and direction of the input segments.
    pub segments: Vec<[usize; 2]>,
    /// For each piece the input segment.
    pub origins: Vec<u32>,
    /// How often crossings were rounded: 0 if there were none.
    pub rounds: usize,
    /// Whether the last round left no crossing.
    pub is_settled: bool,
}

impl Snapped {
    /// Cuts and rounds, at most `rounds_max` times.
    ///
    /// ```
    /// use delone_sites::Snapped;
    ///
    /// let square = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.0, 1.0]];
    /// let snapped = Snapped::new(&square, &[[0, 2], [1, 3]], 10).unwrap();
    /// assert_eq!(snapped.points[4], [1.5, 0.5]);
    /// assert_eq!(snapped.segments, [[0, 4], [4, 2], [1, 4], [4, 3]]);
    /// assert_eq!((snapped.origins, snapped.rounds), (vec![0, 0, 1, 1], 1));
    /// ```
    ///
    /// # Errors
    /// As [`Arrangement::new`], and if a crossing is beyond all doubles.
    pub fn new(
        points: &[[f64; 2]],
        segments: &[[usize; 2]],
        rounds_max: usize,
    ) -> Result<Self, PslgError> {
        let mut snapped = Self {
            points: points.to_vec(),
            segments: segments.to_vec(),
            origins: (0u32..).take(segments.len()).collect(),
            rounds: 0,
            is_settled: false,
        };
        loop {
            let graph = Arrangement::new(&snapped.points, &snapped.segments)?;
            snapped.is_settled = graph.crossing_count() == 0;
            if snapped.is_settled || snapped.rounds == rounds_max {
                return Ok(snapped);
            }
            snapped.cut(&graph);
        }
    }

    /// Puts the pieces of an arrangement of the segments in their place.
    fn cut(&mut self, graph: &Arrangement) {
        let names = graph.names();
        let (mut segments, mut origins) = (Vec::new(), Vec::new());
        for ((chain, ends), &origin) in graph.chains().iter().zip(&self.segments).zip(&self.origins)
        {
            let ids: Vec<usize> = chain.iter().map(|&piece| piece as usize).collect();
            let mut at = graph.sites().site_of()[ends[0]];
            for piece in ids {
                let [a, b] = graph.subsegments()[piece];
                let to = if a == at { b } else { a };
                segments.push([at, to].map(|v| names[v as usize] as usize));
                origins.push(origin);
                at = to;
            }
        }
        self.points.extend(&graph.positions()[graph.sites().len()..]);
        (self.segments, self.origins) = (segments, origins);
        self.rounds += 1;
    }
}

#[cfg(test)]
mod tests;
