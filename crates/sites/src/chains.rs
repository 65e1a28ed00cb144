//! The subsegments of each segment, in two flat arrays.

/// For each input segment its subsegments, by index, from its first end to its second.
///
/// ```
/// use delone_sites::Pslg;
///
/// let pslg = Pslg::new(&[[0.0, 0.0], [2.0, 0.0], [1.0, 0.0]], &[[1, 0], [2, 0]]).unwrap();
/// assert_eq!(pslg.subsegments(), [[0, 2], [1, 2]]);
/// assert_eq!(pslg.chains().of(0), [1, 0]);
/// assert_eq!(pslg.chains().iter().map(<[u32]>::len).collect::<Vec<_>>(), [2, 1]);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chains {
    /// The chain of segment s is `pieces[starts[s]..starts[s + 1]]`.
    starts: Vec<u32>,
    pieces: Vec<u32>,
}

impl Chains {
    /// Chains of these lengths, to be filled.
    pub(crate) fn of_lengths(lengths: impl Iterator<Item = u32>) -> Self {
        let mut starts = vec![0];
        let mut sum = 0u32;
        starts.extend(lengths.map(|length| {
            sum = sum.checked_add(length).expect("pieces, counted by segments, are fewer than ids");
            sum
        }));
        Self { starts, pieces: vec![0; sum as usize] }
    }

    /// Says which subsegment is at a place of a segment's chain.
    pub(crate) fn set(&mut self, segment: u32, place: u32, piece: u32) {
        self.pieces[(self.starts[segment as usize] + place) as usize] = piece;
    }

    /// The chain of a segment.
    ///
    /// # Panics
    /// If there is no such segment.
    #[must_use]
    pub fn of(&self, segment: usize) -> &[u32] {
        let [from, to] = [segment, segment + 1].map(|s| self.starts[s] as usize);
        &self.pieces[from..to]
    }

    /// The chains of all segments, in order.
    #[must_use]
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> + Clone {
        self.starts.windows(2).map(|ends| &self.pieces[ends[0] as usize..ends[1] as usize])
    }

    /// The number of segments.
    #[must_use]
    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// Whether there is no segment.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl<C: AsRef<[u32]>> FromIterator<C> for Chains {
    fn from_iter<I: IntoIterator<Item = C>>(chains: I) -> Self {
        let chains: Vec<C> = chains.into_iter().collect();
        let length = |chain: &C| u32::try_from(chain.as_ref().len()).expect("pieces have ids");
        let mut all = Self::of_lengths(chains.iter().map(length));
        all.pieces.clear();
        chains.iter().for_each(|chain| all.pieces.extend(chain.as_ref()));
        all
    }
}
