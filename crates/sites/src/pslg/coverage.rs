//! How often the input covers each subsegment, and in which direction.

use super::Pslg;

/// The input segments over one subsegment.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Coverage {
    /// How many there are; 1 or more.
    pub times: u32,
    /// Those that run from the smaller site to the larger, less those that run back.
    pub net: i64,
}

impl Pslg {
    /// How often the input covers each subsegment: multiplicities, which overlaps and repeated segments add to.
    ///
    /// ```
    /// use delone_sites::Pslg;
    ///
    /// let line = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]];
    /// let pslg = Pslg::new(&line, &[[0, 2], [1, 0]]).unwrap();
    /// let coverage = pslg.coverage().into_iter().map(|c| (c.times, c.net));
    /// assert_eq!(coverage.collect::<Vec<_>>(), [(2, 0), (1, 1)]); // of [0, 1] and [1, 2]
    /// ```
    #[must_use]
    pub fn coverage(&self) -> Vec<Coverage> {
        self.coverage_where(|_| true)
    }

    /// [`Pslg::coverage`] by the input segments that are `counted`, by index.
    #[must_use]
    pub fn coverage_where(&self, counted: impl Fn(u32) -> bool) -> Vec<Coverage> {
        let mut coverage = vec![Coverage::default(); self.subsegments.len()];
        for ((segment, chain), &[first, _]) in (0u32..).zip(&self.chains).zip(&self.segments) {
            let mut at = first;
            for &piece in chain.iter().filter(|_| counted(segment)) {
                let [low, high] = self.subsegments[piece as usize];
                let covered = &mut coverage[piece as usize];
                covered.times += 1;
                covered.net += if at == low { 1 } else { -1 };
                at = if at == low { high } else { low };
            }
        }
        coverage
    }

    /// For each subsegment the input segments over it, in increasing order.
    #[must_use]
    pub fn parents(&self) -> Vec<Vec<u32>> {
        let mut parents = vec![Vec::new(); self.subsegments.len()];
        for (segment, chain) in (0u32..).zip(&self.chains) {
            chain.iter().for_each(|&piece| parents[piece as usize].push(segment));
        }
        parents
    }
}
