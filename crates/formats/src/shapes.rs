//! Rings and lines listed by coordinates become points and segments.
//!
//! Equal coordinates (bit for bit) of one document become one vertex, so that rings close and borders that two
//! polygons share have shared vertices. An edge between equal points is dropped and counted; equal segments are kept
//! with their multiplicity. A ring may or may not repeat its first point at the end; two-point rings give their edge
//! twice, one-point rings give a free point.

use std::collections::BTreeMap;

use crate::document::Document;
use crate::error::ReadError;

#[derive(Debug)]
pub(crate) struct Shapes {
    pub(crate) document: Document,
    vertices: BTreeMap<[u64; 3], u32>,
    listed: usize,
}

impl Shapes {
    pub(crate) fn new(dimension: usize) -> Self {
        Self { document: Document::new(dimension), vertices: BTreeMap::new(), listed: 0 }
    }

    fn vertex<const D: usize>(&mut self, point: &[f64; D]) -> Result<u32, ReadError> {
        let mut key = [0; 3];
        for (bits, x) in key.iter_mut().zip(point) {
            *bits = x.to_bits();
        }
        if let Some(&known) = self.vertices.get(&key) {
            return Ok(known);
        }
        let fresh = self.document.push_point(point, 0)?;
        self.vertices.insert(key, fresh);
        Ok(fresh)
    }

    /// A free point.
    pub(crate) fn point<const D: usize>(&mut self, point: &[f64; D]) -> Result<u32, ReadError> {
        self.listed += 1;
        self.vertex(point)
    }

    /// An open line; closed if its last point equals its first.
    pub(crate) fn line<const D: usize>(&mut self, points: &[[f64; D]]) -> Result<(), ReadError> {
        let ids = self.ids(points)?;
        for pair in ids.windows(2) {
            self.edge(pair[0], pair[1]);
        }
        Ok(())
    }

    /// A closed ring.
    pub(crate) fn ring<const D: usize>(&mut self, points: &[[f64; D]]) -> Result<(), ReadError> {
        let ids = self.ids(points)?;
        for pair in ids.windows(2) {
            self.edge(pair[0], pair[1]);
        }
        if let [first, .., last] = ids[..]
            && first != last
        {
            self.edge(last, first);
        }
        Ok(())
    }

    /// One segment by its end points.
    pub(crate) fn segment<const D: usize>(
        &mut self,
        a: &[f64; D],
        b: &[f64; D],
    ) -> Result<(), ReadError> {
        let (a, b) = (self.point(a)?, self.point(b)?);
        self.edge(a, b);
        Ok(())
    }

    /// A face by its corners; corners are vertices, not listed points.
    pub(crate) fn face<const D: usize>(&mut self, points: &[[f64; D]]) -> Result<(), ReadError> {
        let ids = points.iter().map(|p| self.point(p)).collect::<Result<Vec<u32>, _>>()?;
        self.document.push_face(ids);
        Ok(())
    }

    fn ids<const D: usize>(&mut self, points: &[[f64; D]]) -> Result<Vec<u32>, ReadError> {
        let ids = points.iter().map(|p| self.vertex(p)).collect::<Result<Vec<u32>, _>>()?;
        let closing_repeat = ids.len() > 2 && ids.first() == ids.last();
        self.listed += ids.len() - usize::from(closing_repeat);
        Ok(ids)
    }

    fn edge(&mut self, a: u32, b: u32) {
        if a == b {
            self.document.zero_length_dropped += 1;
        } else {
            self.document.segments.push([a, b]);
        }
    }

    pub(crate) fn note(&mut self, note: impl Into<String>) {
        self.document.note(note);
    }

    pub(crate) fn finish(mut self) -> Document {
        let dropped = self.document.zero_length_dropped;
        if dropped > 0 {
            self.document.note(format!("{dropped} zero-length edges dropped"));
        }
        let distinct = self.document.point_count();
        if self.listed > distinct {
            self.document.note(format!("{} listed points merged to {distinct}", self.listed));
        }
        self.document.points_listed = self.listed;
        self.document
    }
}

#[cfg(test)]
mod tests;
