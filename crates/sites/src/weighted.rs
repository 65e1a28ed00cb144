//! Sites with weights: points and their weights, checked once, each position once.

use std::fmt;

use crate::{Sites, SitesError};

/// Distinct finite points of R^D with a finite weight each. Of equal points the heaviest counts, of those the first.
///
/// ```
/// use delone_sites::WeightedSites;
///
/// let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]];
/// let sites = WeightedSites::new(&points, &[1.0, 2.0, 3.0]).unwrap();
/// assert_eq!((sites.weights(), sites.input_of()), (&[3.0, 2.0][..], &[2, 1][..]));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct WeightedSites<const D: usize> {
    sites: Sites<D>,
    weights: Vec<f64>,
    input_of: Vec<u32>,
}

/// Why points with weights were refused: every violation of the first kind found.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum WeightsError {
    /// The points are no sites.
    Sites(SitesError),
    /// There is not one weight for each point.
    Count {
        /// How many points.
        points: usize,
        /// How many weights.
        weights: usize,
    },
    /// Weights that are NaN or infinite: the index of the point, and the weight.
    NotFinite(Vec<(usize, f64)>),
}

impl fmt::Display for WeightsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sites(error) => error.fmt(f),
            Self::Count { points, weights } => {
                write!(f, "{points} points have {weights} weights: give one for each")
            }
            Self::NotFinite(all) => {
                let line = |(point, weight): &(usize, f64)| {
                    format!("point {point} has the weight {weight}: give a finite number")
                };
                f.write_str(&all.iter().map(line).collect::<Vec<_>>().join("\n"))
            }
        }
    }
}

impl std::error::Error for WeightsError {}

impl From<SitesError> for WeightsError {
    fn from(error: SitesError) -> Self {
        Self::Sites(error)
    }
}

impl<const D: usize> WeightedSites<D> {
    /// Checks and takes points with their weights. O(n log n).
    ///
    /// # Errors
    /// If [`Sites::new`] refuses the points, or there is not one weight for each, or one is not finite.
    pub fn new(points: &[[f64; D]], weights: &[f64]) -> Result<Self, WeightsError> {
        let sites = Sites::new(points)?;
        if points.len() != weights.len() {
            return Err(WeightsError::Count { points: points.len(), weights: weights.len() });
        }
        let bad: Vec<(usize, f64)> =
            weights.iter().copied().enumerate().filter(|(_, weight)| !weight.is_finite()).collect();
        if !bad.is_empty() {
            return Err(WeightsError::NotFinite(bad));
        }
        let mut input_of = sites.input_of().to_vec();
        for (input, &site) in (0u32..).zip(sites.site_of()) {
            let heaviest = &mut input_of[site as usize];
            if weights[input as usize] > weights[*heaviest as usize] {
                *heaviest = input;
            }
        }
        let weights = input_of.iter().map(|&input| weights[input as usize] + 0.0).collect();
        Ok(Self { sites, weights, input_of })
    }

    /// The sites, without their weights.
    #[must_use]
    pub const fn sites(&self) -> &Sites<D> {
        &self.sites
    }

    /// The weight of each site.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The input point that each site stands for: the heaviest at its position.
    #[must_use]
    pub fn input_of(&self) -> &[u32] {
        &self.input_of
    }
}
