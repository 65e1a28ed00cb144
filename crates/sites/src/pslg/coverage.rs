//! Which input segments cover each subsegment.

use super::Pslg;

/// The input segments over one subsegment, counted.
///
/// ```
/// use delone_sites::{Noded, Pslg};
///
/// let line = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]];
/// let pslg = Pslg::new(&line, &[[0, 2], [1, 0]]).unwrap();
/// let coverage = pslg.coverage().into_iter().map(|c| (c.times, c.net));
/// assert_eq!(coverage.collect::<Vec<_>>(), [(2, 0), (1, 1)]); // of [0, 1] and [1, 2]
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Coverage {
    /// How many there are; 1 or more.
    pub times: u32,
    /// Those that run from the smaller site to the larger, less those that run back.
    pub net: i64,
}

impl Pslg {
    /// For each subsegment the input segments over it, in increasing order.
    #[must_use]
    pub fn parents(&self) -> Vec<Vec<u32>> {
        let mut parents = vec![Vec::new(); self.subsegments.len()];
        for (segment, chain) in (0u32..).zip(self.chains.iter()) {
            chain.iter().for_each(|&piece| parents[piece as usize].push(segment));
        }
        parents
    }
}
