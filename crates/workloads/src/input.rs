//! What a generator hands over: plain coordinates and pairs of indices.

use crate::Rng;
use crate::fingerprint::Fnv;
use crate::num::id;

/// Sites of the plane or of space.
#[derive(Clone, Debug, PartialEq)]
pub enum Points {
    /// Sites of the plane.
    Plane(Vec<[f64; 2]>),
    /// Sites of space.
    Space(Vec<[f64; 3]>),
}

impl Points {
    /// How many.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::Plane(points) => points.len(),
            Self::Space(points) => points.len(),
        }
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The sites, if they lie in the plane.
    #[must_use]
    pub fn plane(&self) -> Option<&[[f64; 2]]> {
        match self {
            Self::Plane(points) => Some(points),
            Self::Space(_) => None,
        }
    }

    /// The sites, if they lie in space.
    #[must_use]
    pub fn space(&self) -> Option<&[[f64; 3]]> {
        match self {
            Self::Plane(_) => None,
            Self::Space(points) => Some(points),
        }
    }
}

/// A generated input: sites, and for a PSLG the segments between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// The sites, in the order their generator made them.
    pub points: Points,
    /// Pairs of indices into the sites; empty for point sets.
    pub segments: Vec<[u32; 2]>,
}

impl Input {
    /// The same sites in a random order, segments renumbered: the order of input is a variable of its own.
    pub fn shuffle(&mut self, seed: u64) {
        let mut order: Vec<u32> = (0..self.points.len()).map(id).collect();
        Rng::named("shuffle", seed).shuffle(&mut order);
        match &mut self.points {
            Points::Plane(points) => *points = reordered(points, &order),
            Points::Space(points) => *points = reordered(points, &order),
        }
        let mut place = vec![0_u32; order.len()];
        for (new, &old) in order.iter().enumerate() {
            place[old as usize] = id(new);
        }
        for segment in &mut self.segments {
            *segment = segment.map(|v| place[v as usize]);
        }
    }

    /// FNV-1a over the bits of all coordinates and indices, little-endian, in order.
    #[must_use]
    pub fn fingerprint(&self) -> u64 {
        let mut hash = Fnv::new();
        match &self.points {
            Points::Plane(points) => points.iter().flatten().for_each(|&x| hash.double(x)),
            Points::Space(points) => points.iter().flatten().for_each(|&x| hash.double(x)),
        }
        self.segments.iter().flatten().for_each(|v| hash.bytes(&v.to_le_bytes()));
        hash.value()
    }
}

fn reordered<T: Copy>(items: &[T], order: &[u32]) -> Vec<T> {
    order.iter().map(|&i| items[i as usize]).collect()
}
