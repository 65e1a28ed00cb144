//! One input with a name, and what can be done to it without changing what it is.

use delone::workloads::Rng;
use delone::{Pslg, Sites};

use crate::id;

/// Points, and in the plane segments between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Case<const D: usize> {
    /// Where it comes from: enough to make it again.
    pub name: String,
    /// The points as a user would give them: duplicates and -0.0 included.
    pub points: Vec<[f64; D]>,
    /// Pairs of point indices; empty if D is not 2.
    pub segments: Vec<[u32; 2]>,
}

impl<const D: usize> Case<D> {
    /// A case without segments.
    #[must_use]
    pub fn of_points(name: impl Into<String>, points: Vec<[f64; D]>) -> Self {
        Self { name: name.into(), points, segments: Vec::new() }
    }

    /// The sites.
    #[must_use]
    pub fn sites(&self) -> Sites<D> {
        Sites::new(&self.points).unwrap_or_else(|error| panic!("{}: {error}", self.name))
    }

    /// The same input in another order: points, segments, and the ends of segments.
    #[must_use]
    pub fn shuffled(&self, seed: u64) -> Self {
        let mut rng = Rng::named("order", seed);
        let mut order: Vec<usize> = (0..self.points.len()).collect();
        rng.shuffle(&mut order);
        let mut place = vec![0; order.len()];
        for (new, &old) in order.iter().enumerate() {
            place[old] = id(new);
        }
        let mut segments: Vec<[u32; 2]> =
            self.segments.iter().map(|ends| ends.map(|v| place[v as usize])).collect();
        rng.shuffle(&mut segments);
        for ends in &mut segments {
            if rng.coin() {
                ends.reverse();
            }
        }
        let points = order.iter().map(|&i| self.points[i]).collect();
        Self { name: format!("{}, shuffle {seed}", self.name), points, segments }
    }

    /// The same input under a map of its points.
    #[must_use]
    pub fn mapped(&self, what: &str, map: impl Fn([f64; D]) -> [f64; D]) -> Self {
        let points = self.points.iter().map(|&p| map(p)).collect();
        Self { name: format!("{}, {what}", self.name), points, segments: self.segments.clone() }
    }

    /// The points alone.
    #[must_use]
    pub fn without_segments(&self) -> Self {
        Self { segments: Vec::new(), ..self.clone() }
    }
}

impl Case<2> {
    /// A case with segments.
    #[must_use]
    pub fn new(name: impl Into<String>, points: Vec<[f64; 2]>, segments: Vec<[u32; 2]>) -> Self {
        Self { name: name.into(), points, segments }
    }

    /// The noded graph, or `None` if segments cross.
    #[must_use]
    pub fn try_pslg(&self) -> Option<Pslg> {
        let segments: Vec<[usize; 2]> =
            self.segments.iter().map(|ends| ends.map(|v| v as usize)).collect();
        Pslg::new(&self.points, &segments).ok()
    }

    /// The noded graph.
    #[must_use]
    pub fn pslg(&self) -> Pslg {
        self.try_pslg().unwrap_or_else(|| panic!("{}: refused", self.name))
    }
}
