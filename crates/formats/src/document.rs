//! The one neutral type every reader makes and every writer takes.
//!
//! **Invariants.** 1. `points.len()` is a multiple of `dimension`, which is 2 or 3. 2. Every index in `segments`,
//! `triangles`, `polygons` and `tets` names a point (0-based, whatever `first_index` says). 3. A list that runs
//! parallel to another (`point_markers`, `segment_markers`, `attributes`, `weights`) is as long as that, or empty.

use crate::error::{ReadError, at};

/// A seed of a region with its attribute and area bound, as in a `.poly` file.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// A point inside, `dimension` coordinates.
    pub seed: Vec<f64>,
    /// The number its cells are given.
    pub attribute: f64,
    /// Largest allowed cell, if stated.
    pub size_max: Option<f64>,
}

/// What a file says, before anything is validated: coordinates as written, NaN included.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// File name, and `#case` for one of several.
    pub name: String,
    /// 2 or 3.
    pub dimension: usize,
    /// Coordinates, `dimension` per point.
    pub points: Vec<f64>,
    /// Point attributes, `attributes_per_point` each.
    pub attributes: Vec<f64>,
    /// Length of a point's run in `attributes`.
    pub attributes_per_point: usize,
    /// Boundary markers of points, or empty.
    pub point_markers: Vec<i64>,
    /// Weights of points for regular triangulations.
    pub weights: Option<Vec<f64>>,
    /// Input segments, with multiplicity.
    pub segments: Vec<[u32; 2]>,
    /// Boundary markers of segments, or empty.
    pub segment_markers: Vec<i64>,
    /// Faces with three corners.
    pub triangles: Vec<[u32; 3]>,
    /// Faces with any other number of corners, one ring each.
    pub polygons: Vec<Vec<u32>>,
    /// Cells with four corners.
    pub tets: Vec<[u32; 4]>,
    /// Attributes of the triangles (in the plane) or tets (in space), `attributes_per_cell` each.
    pub cell_attributes: Vec<f64>,
    /// Length of a cell's run in `cell_attributes`.
    pub attributes_per_cell: usize,
    /// Hole seeds, `dimension` coordinates each.
    pub holes: Vec<f64>,
    /// Region seeds.
    pub regions: Vec<Region>,
    /// Number of the first point in the file, 0 or 1; writers of numbered formats keep it.
    pub first_index: u32,
    /// Points as the file lists them: before equal ones were merged, closing repeats of rings not counted.
    pub points_listed: usize,
    /// Edges between equal points, dropped.
    pub zero_length_dropped: usize,
    /// What was tolerated, rounded or dropped, one sentence each.
    pub notes: Vec<String>,
}

impl Document {
    /// An empty document.
    #[must_use]
    pub fn new(dimension: usize) -> Self {
        Self { dimension, ..Self::default() }
    }

    /// Number of points.
    #[must_use]
    pub fn point_count(&self) -> usize {
        self.points.len().checked_div(self.dimension).unwrap_or(0)
    }

    /// The coordinates of one point, if there is one of that index.
    #[must_use]
    pub fn point(&self, index: usize) -> Option<&[f64]> {
        self.points.chunks_exact(self.dimension.max(1)).nth(index)
    }

    /// All points of a plane document.
    ///
    /// # Errors
    /// [`ReadError::Dimension`] if the document is not in the plane; see [`Self::projected`].
    pub fn points_2d(&self) -> Result<&[[f64; 2]], ReadError> {
        self.points_of::<2>()
    }

    /// All points of a document in space.
    ///
    /// # Errors
    /// [`ReadError::Dimension`] if the document is not in space; see [`Self::raised`].
    pub fn points_3d(&self) -> Result<&[[f64; 3]], ReadError> {
        self.points_of::<3>()
    }

    fn points_of<const D: usize>(&self) -> Result<&[[f64; D]], ReadError> {
        if self.dimension != D {
            let found = self.dimension;
            return Err(ReadError::Dimension { at: at(0), expected: D, found }.in_file(&self.name));
        }
        Ok(self.points.as_chunks::<D>().0)
    }

    /// The document with coordinate `axis` left out: a document in space becomes one in the plane.
    #[must_use]
    pub fn projected(mut self, axis: usize) -> Self {
        if self.dimension != 3 || axis > 2 {
            return self;
        }
        let keep = |flat: &[f64]| -> Vec<f64> {
            flat.iter().enumerate().filter(|(i, _)| i % 3 != axis).map(|(_, &x)| x).collect()
        };
        self.points = keep(&self.points);
        self.holes = keep(&self.holes);
        for region in &mut self.regions {
            region.seed = keep(&region.seed);
        }
        self.dimension = 2;
        self
    }

    /// The document with a third coordinate 0: a document in the plane becomes one in space.
    #[must_use]
    pub fn raised(mut self) -> Self {
        if self.dimension != 2 {
            return self;
        }
        let lift = |flat: &[f64]| -> Vec<f64> {
            flat.as_chunks::<2>().0.iter().flat_map(|p| [p[0], p[1], 0.0]).collect()
        };
        self.points = lift(&self.points);
        self.holes = lift(&self.holes);
        for region in &mut self.regions {
            region.seed = lift(&region.seed);
        }
        self.dimension = 3;
        self
    }

    /// Adds a point; its coordinates beyond `dimension` are ignored. Returns its index.
    pub(crate) fn push_point(&mut self, point: &[f64], line: usize) -> Result<u32, ReadError> {
        let index = u32::try_from(self.point_count())
            .map_err(|_| ReadError::TooMany { at: at(line), of: "points" })?;
        let point = &point[..self.dimension];
        if point.iter().any(|x| !x.is_finite()) {
            self.note_not_finite(index, line);
        }
        self.points.extend_from_slice(point);
        self.points_listed += 1;
        Ok(index)
    }

    /// Non-finite coordinates are the caller's to refuse; the first one's place is said here, where it is known.
    fn note_not_finite(&mut self, index: u32, line: usize) {
        const SAID: &str = "is the first that is not finite";
        if !self.notes.iter().any(|note| note.contains(SAID)) {
            let place = if line > 0 { format!(", line {line}") } else { String::new() };
            self.note(format!("point {index}{place}, {SAID}"));
        }
    }

    /// Adds a face, sorted into the list of its kind.
    pub(crate) fn push_face(&mut self, corners: Vec<u32>) {
        match corners[..] {
            [a, b, c] => self.triangles.push([a, b, c]),
            _ => self.polygons.push(corners),
        }
    }

    pub(crate) fn note(&mut self, note: impl Into<String>) {
        self.notes.push(note.into());
    }

    /// Mesh formats have no plane form; files of plane meshes carry a third coordinate that is zero throughout.
    pub(crate) fn flattened_if_plane(self) -> Self {
        let plane = self.dimension == 3
            && self.point_count() > 0
            && self.points.as_chunks::<3>().0.iter().all(|p| p[2] == 0.0);
        if !plane || !self.tets.is_empty() {
            return self;
        }
        let mut flat = self.projected(2);
        flat.note("every third coordinate is zero: read as a document in the plane");
        flat
    }
}

#[cfg(test)]
mod tests;
