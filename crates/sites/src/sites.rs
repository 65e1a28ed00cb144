//! Sites: input points, checked once, each position once.

use std::fmt;
use std::num::NonZeroUsize;

use crate::order::low_half;
use crate::sorting::{are_finite, collected, id, sorted};

/// More points than this are worth a pool of threads, which takes as long to start as a thousand of them.
const POOL: usize = 1 << 15;

/// Distinct finite points of R^D, in the order in which they first came.
///
/// -0.0 becomes 0.0. Of equal points the first is the site; [`Sites::site_of`] says which site each input point is.
#[derive(Clone, Debug, PartialEq)]
pub struct Sites<const D: usize> {
    points: Vec<[f64; D]>,
    site_of: Vec<u32>,
    input_of: Vec<u32>,
    /// The sites in lexicographic order.
    sorted: Vec<u32>,
}

/// A coordinate that is no site's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotFinite {
    /// The index of the point.
    pub point: usize,
    /// The axis, from 0.
    pub axis: usize,
    /// NaN or an infinity.
    pub value: f64,
}

/// Why points were refused: every violation.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum SitesError {
    /// Coordinates that are NaN or infinite.
    NotFinite(Vec<NotFinite>),
    /// More points than ids.
    TooMany(usize),
}

impl fmt::Display for NotFinite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { point, axis, value } = self;
        write!(f, "point {point} has the coordinate {value} on axis {axis}: give a finite number")
    }
}

impl fmt::Display for SitesError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite(all) => {
                let lines: Vec<String> = all.iter().map(ToString::to_string).collect();
                f.write_str(&lines.join("\n"))
            }
            Self::TooMany(count) => {
                write!(
                    f,
                    "{count} points are more than the 2^32 - 3 that ids can name: split the input"
                )
            }
        }
    }
}

impl std::error::Error for SitesError {}

impl<const D: usize> Sites<D> {
    /// Checks and takes the points. O(n log n).
    ///
    /// # Errors
    /// If a coordinate is not finite (all of them are listed), or there are 2^32 - 2 points or more.
    pub fn new(points: &[[f64; D]]) -> Result<Self, SitesError> {
        Self::in_parts(points, 1)
    }

    /// The same, to the bit, on up to `threads` threads.
    ///
    /// ```
    /// use delone_sites::Sites;
    /// let points: Vec<[f64; 2]> = (0..50_000).map(|i| [f64::from(i % 7), f64::from(i)]).collect();
    /// let threads = std::num::NonZeroUsize::new(2).unwrap();
    /// assert_eq!(Sites::new_in_parallel(&points, threads), Sites::new(&points));
    /// ```
    ///
    /// # Errors
    /// As [`Sites::new`].
    pub fn new_in_parallel(points: &[[f64; D]], threads: NonZeroUsize) -> Result<Self, SitesError> {
        let alone = threads.get() == 1 || points.len() <= POOL;
        let pool = || rayon::ThreadPoolBuilder::new().num_threads(threads.get()).build().ok();
        // A system that gives no threads gets the same sites from one.
        let Some(pool) = (!alone).then(pool).flatten() else { return Self::new(points) };
        pool.install(|| Self::in_parts(points, threads.get()))
    }

    /// Checks and takes the points, in `parts` at a time.
    fn in_parts(points: &[[f64; D]], parts: usize) -> Result<Self, SitesError> {
        let count = points.len();
        u32::try_from(count)
            .ok()
            .filter(|&count| count < u32::MAX - 1)
            .ok_or(SitesError::TooMany(count))?;
        if !are_finite(points, parts) {
            return Err(SitesError::NotFinite(not_finite(points)));
        }
        let points = collected(count, parts, |i| points[i].map(|c| c + 0.0));
        let (items, distinct) = sorted(&points, parts);
        let sorted = collected(count, parts, |i| low_half(items[i]));
        drop(items);
        if distinct {
            let all = || collected(count, parts, id);
            return Ok(Self { points, site_of: all(), input_of: all(), sorted });
        }
        Ok(Self::merged(&points, sorted))
    }

    /// Of each run of equal points in `sorted` (ties by index) the first becomes the site.
    fn merged(points: &[[f64; D]], mut sorted: Vec<u32>) -> Self {
        let mut first = vec![0u32; points.len()];
        for run in sorted.chunk_by(|&i, &j| points[i as usize] == points[j as usize]) {
            run.iter().for_each(|&i| first[i as usize] = run[0]);
        }
        let mut site_of = vec![0u32; points.len()];
        let mut input_of: Vec<u32> = Vec::with_capacity(points.len());
        for (i, input) in (0u32..).zip(0..points.len()) {
            let representative = first[input] as usize;
            if representative == input {
                site_of[input] = u32::try_from(input_of.len()).expect("no more sites than points");
                input_of.push(i);
            } else {
                site_of[input] = site_of[representative];
            }
        }
        sorted.retain(|&i| first[i as usize] == i);
        sorted.iter_mut().for_each(|i| *i = site_of[*i as usize]);
        let points = input_of.iter().map(|&i| points[i as usize]).collect();
        Self { points, site_of, input_of, sorted }
    }

    /// The sites' positions.
    #[inline]
    #[must_use]
    pub fn points(&self) -> &[[f64; D]] {
        &self.points
    }

    /// The number of sites.
    #[inline]
    #[must_use]
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there is no site.
    #[inline]
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// The site of each input point.
    #[must_use]
    pub fn site_of(&self) -> &[u32] {
        &self.site_of
    }

    /// The first input point of each site.
    #[must_use]
    pub fn input_of(&self) -> &[u32] {
        &self.input_of
    }

    /// Input points that are not the first at their position.
    #[must_use]
    pub fn duplicate_count(&self) -> usize {
        self.site_of.len() - self.points.len()
    }

    /// The sites in lexicographic order of their coordinates.
    #[must_use]
    pub fn sorted(&self) -> &[u32] {
        &self.sorted
    }

    /// The place of each site in the lexicographic order.
    #[must_use]
    pub fn ranks(&self) -> Vec<u32> {
        let mut ranks = vec![0; self.len()];
        for (rank, &site) in (0u32..).zip(&self.sorted) {
            ranks[site as usize] = rank;
        }
        ranks
    }
}

fn not_finite<const D: usize>(points: &[[f64; D]]) -> Vec<NotFinite> {
    let bad = |(point, coordinates): (usize, &[f64; D])| {
        let coordinates = *coordinates;
        (0..D)
            .map(move |axis| NotFinite { point, axis, value: coordinates[axis] })
            .filter(|fault| !fault.value.is_finite())
    };
    points.iter().enumerate().flat_map(bad).collect()
}
