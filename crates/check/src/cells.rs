//! Cells read in and put right side up: T1, T2, and the flat they live in.
//!
//! **In.** `k+1` ids per cell. **Out.** A [`Triangulation`]: the same cells, turned positive where
//! the options allow it, each with the sign of its orientation, and the space restricted to `k`
//! axes on which a cell is not flat. For `k < D` all points are proved to lie in the flat of one
//! cell: with every further axis, the point and that cell have rank `k`.

use crate::exact::{Integer, Sign};
use crate::fault::Fault;
use crate::options::{Options, Orientation};
use crate::sites::{Unused, check_finite, check_used, check_weights, witness, witnesses};
use crate::space::Space;
use crate::verdict::Report;

/// A triangulation of dimension `k`, as plain data.
#[derive(Clone, Copy, Debug)]
pub struct Complex<'a, const D: usize> {
    /// The input points. Points equal to a used point need not be used.
    pub points: &'a [[f64; D]],
    /// The affine dimension `k` of the points: 0 if they are all equal, `None` if there are none.
    pub dimension: Option<usize>,
    /// `k+1` vertex ids per solid cell; no ghosts. One point: `[0]`, of dimension 0.
    pub cells: &'a [u32],
}

/// A complex under judgement.
#[derive(Debug)]
pub(crate) struct Triangulation<'a, const D: usize, I> {
    pub(crate) space: Space<'a, D, I>,
    /// `k`; 0 also for no points at all.
    pub(crate) dimension: usize,
    /// The cells, turned positive as far as allowed.
    pub(crate) cells: Vec<u32>,
    /// The orientation of each cell; `None` if its ids are unusable.
    pub(crate) signs: Vec<Option<Sign>>,
    /// For each point, the used point equal to it.
    pub(crate) representative: Vec<u32>,
    /// Whether T1, T2 and the flat were proved.
    pub(crate) sound: bool,
}

impl<'a, const D: usize, I: Integer> Triangulation<'a, D, I> {
    /// Reads and checks the cells one by one. `None`: the data have no meaning, and the report says
    /// why.
    pub(crate) fn read(
        complex: &Complex<'a, D>,
        options: &Options,
        report: &mut Report,
    ) -> Option<Self> {
        let mut this = Self::read_cells(complex, None, options, report)?;
        this.representative = check_used(complex.points, complex.cells, Unused::Fault, report);
        Some(this)
    }

    /// The same for points with weights, of which some may be hidden: T8 says of those nothing.
    pub(crate) fn read_weighted(
        complex: &Complex<'a, D>,
        weights: &'a [f64],
        options: &Options,
        report: &mut Report,
    ) -> Option<Self> {
        let mut this = Self::read_cells(complex, Some(weights), options, report)?;
        this.representative = check_used(complex.points, complex.cells, Unused::Hidden, report);
        Some(this)
    }

    fn read_cells(
        complex: &Complex<'a, D>,
        weights: Option<&'a [f64]>,
        options: &Options,
        report: &mut Report,
    ) -> Option<Self> {
        let points = complex.points;
        let dimension = checked_shape(complex, report)?;
        if !(check_finite(points, report) && check_weights(points, weights, report)) {
            return None;
        }
        let stride = dimension + 1;
        let well_formed = check_ids(complex, stride, report);
        let mut this = Self {
            space: Space::weighted(points, weights, options.filtered),
            dimension,
            cells: complex.cells.to_vec(),
            signs: well_formed.iter().map(|&ok| ok.then_some(Sign::Positive)).collect(),
            representative: Vec::new(),
            sound: well_formed.iter().all(|&ok| ok),
        };
        let frame = if dimension < D { this.choose_axes() } else { None };
        this.sound &= this.orient_cells(options, report);
        if dimension < D {
            this.sound &= this.check_flat(frame, report);
        }
        Some(this)
    }

    /// The vertices of a cell.
    pub(crate) fn cell(&self, cell: usize) -> &[u32] {
        let stride = self.dimension + 1;
        &self.cells[cell * stride..(cell + 1) * stride]
    }

    /// Restricts the space to axes on which some cell is not flat; returns that cell.
    fn choose_axes(&mut self) -> Option<usize> {
        let well_formed = (0..self.signs.len()).filter(|&c| self.signs[c].is_some());
        let found = well_formed.into_iter().find_map(|c| Some((c, self.axes_of(self.cell(c))?)));
        self.space.axes = match &found {
            Some((_, axes)) => axes.clone(),
            None => (0..self.dimension).collect(),
        };
        found.map(|(cell, _)| cell)
    }

    /// Axes on which a simplex is not flat: one more for each vertex, by which it leaves the flat
    /// of those before. `None` if there are none.
    fn axes_of(&self, simplex: &[u32]) -> Option<Vec<usize>> {
        let mut axes: Vec<usize> = Vec::new();
        for end in 2..=simplex.len() {
            let next = (0..D).filter(|x| !axes.contains(x)).find(|&x| {
                let wider: Vec<usize> = axes.iter().copied().chain([x]).collect();
                self.space.orient_along(&wider, &simplex[..end]) != Sign::Zero
            })?;
            axes.push(next);
        }
        axes.sort_unstable();
        Some(axes)
    }

    /// T2: computes all signs, and turns cells over where the options allow it.
    fn orient_cells(&mut self, options: &Options, report: &mut Report) -> bool {
        let (k, stride) = (self.dimension, self.dimension + 1);
        for cell in 0..self.signs.len() {
            if self.signs[cell].is_some() && k > 0 {
                self.signs[cell] = Some(self.space.orient(self.cell(cell)));
            }
        }
        // In a flat no side is up: the first cell says which.
        let first = self.signs.iter().flatten().find(|&&s| s != Sign::Zero);
        let all_over = k < D && first == Some(&Sign::Negative);
        for (cell, corners) in self.cells.chunks_exact_mut(stride).enumerate() {
            let turn = match options.orientation {
                Orientation::Positive => all_over,
                Orientation::Any => self.signs[cell] == Some(Sign::Negative),
            };
            if k > 0 && turn {
                corners.swap(0, 1);
                self.signs[cell] = self.signs[cell].map(|s| s.flipped_if(true));
            }
        }
        report.check("T2: every cell is oriented positively", |report| {
            for (cell, &sign) in self.signs.iter().enumerate() {
                let corners = || witnesses(self.space.points, self.cell(cell));
                match sign {
                    Some(Sign::Zero) => report.fault(Fault::FlatCell { cell, corners: corners() }),
                    Some(Sign::Negative) => {
                        report.fault(Fault::NegativeCell { cell, corners: corners() });
                    }
                    Some(Sign::Positive) | None => {}
                }
            }
        })
    }

    /// Every point lies in the flat of the cell `frame`.
    fn check_flat(&self, frame: Option<usize>, report: &mut Report) -> bool {
        let first = if self.dimension == 0 { (!self.signs.is_empty()).then_some(0) } else { frame };
        let Some(cell) = first.filter(|&c| self.signs[c].is_some()) else { return false };
        let axes = &self.space.axes;
        let further: Vec<Vec<usize>> = (0..D)
            .filter(|x| !axes.contains(x))
            .map(|x| axes.iter().copied().chain([x]).collect())
            .collect();
        let claim = format!("all points lie in one flat of dimension {}", self.dimension);
        report.check(&claim, |report| {
            let mut simplex = self.cell(cell).to_vec();
            for (id, _) in (0u32..).zip(self.space.points) {
                simplex.push(id);
                if further.iter().any(|a| self.space.orient_along(a, &simplex) != Sign::Zero) {
                    let flat = witnesses(self.space.points, self.cell(cell));
                    report.fault(Fault::OffFlat { point: witness(self.space.points, id), flat });
                }
                simplex.pop();
            }
        })
    }
}

/// The dimension, if it and the array lengths make sense.
fn checked_shape<const D: usize>(complex: &Complex<'_, D>, report: &mut Report) -> Option<usize> {
    let (points, length) = (complex.points.len(), complex.cells.len());
    let possible = match complex.dimension {
        None => points == 0,
        Some(k) => k <= D && points > 0 && u32::try_from(points).is_ok(),
    };
    if !possible {
        let dimension = complex.dimension;
        report.fault(Fault::BadDimension { dimension, ambient: D, points });
        return None;
    }
    let Some(k) = complex.dimension else {
        if length == 0 {
            return Some(0);
        }
        report.fault(Fault::BadLength { array: "cells", length, expected: "0".to_owned() });
        return None;
    };
    if !length.is_multiple_of(k + 1) {
        let expected = format!("a multiple of {}", k + 1);
        report.fault(Fault::BadLength { array: "cells", length, expected });
        return None;
    }
    Some(k)
}

/// The first half of T1: ids in range, and distinct within a cell. (The second half is in
/// `triangulation`.)
fn check_ids<const D: usize>(
    complex: &Complex<'_, D>,
    stride: usize,
    report: &mut Report,
) -> Vec<bool> {
    let points = complex.points.len();
    let mut well_formed = vec![true; complex.cells.len() / stride];
    report.check("T1: ids are in range, and distinct within each cell", |report| {
        for (cell, corners) in complex.cells.chunks_exact(stride).enumerate() {
            if let Some(&id) = corners.iter().find(|&&v| v as usize >= points) {
                report.fault(Fault::IdOutOfRange { cell, id, points });
                well_formed[cell] = false;
            } else if (1..stride).any(|i| corners[..i].contains(&corners[i])) {
                report.fault(Fault::RepeatedVertex { cell, vertices: corners.to_vec() });
                well_formed[cell] = false;
            }
        }
    });
    well_formed
}
