//! The judge of a mesh's links (T4): twins, ghosts, and the closed sphere they should form. No
//! coordinates.
//!
//! **In.** A [`Links`]: flat arrays. Facet `cell * (k+1) + i` is the one opposite corner `i` of its
//! cell.
//! **Checks.** 1. Each cell has distinct vertices, GHOST at most once. 2. Twins are facet numbers,
//! and mutual. 3. Twins have the same vertices and opposite orientations. 4. Every vertex set of a
//! facet occurs in exactly two cells: so the twins are forced, and ghost cells stand exactly on
//! those facets that only one solid cell has. 5. The outer facet of a ghost cell leads to a solid
//! cell (for `k >= 1`). 6. The mesh is connected, and its Euler characteristic is that of the
//! `k`-sphere.
//! **Cost.** One sort of the facets.

use crate::facets::{Facets, Pieces};
use crate::fault::Fault;
use crate::options::Options;
use crate::triangulation::{alternating_sum, count_faces};
use crate::verdict::{Level, Report, Verdict};

/// A mesh closed by ghost cells, as plain data.
#[derive(Clone, Copy, Debug)]
pub struct Links<'a> {
    /// The dimension `k` of the cells; `None` for the mesh of no sites, which has none.
    pub dimension: Option<usize>,
    /// `k+1` vertices for each cell, solid or ghost.
    pub vertices: &'a [u32],
    /// For each facet the number of the facet glued to it.
    pub twins: &'a [u32],
    /// The id that stands for the vertex at infinity.
    pub ghost: u32,
}

/// Judges whether the cells are glued into a closed, oriented, connected mesh with the ghosts
/// outside.
#[must_use]
pub fn judge_links(links: &Links<'_>, options: &Options) -> Verdict {
    let mut report = Report::new(options.faults_max);
    if let Some(stride) = checked_shape(links, &mut report) {
        Gluing { links, stride }.check(&mut report);
    }
    if report.is_clean() {
        report.reached(Level::Linked);
    }
    report.verdict()
}

/// The number of vertices per cell, if the arrays fit it and there are cells.
fn checked_shape(links: &Links<'_>, report: &mut Report) -> Option<usize> {
    let (length, stride) = (links.vertices.len(), links.dimension.map_or(0, |k| k + 1));
    if stride == 0 && length > 0 {
        report.fault(Fault::BadLength { array: "vertices", length, expected: "0".to_owned() });
    } else if stride > 0 && (length == 0 || !length.is_multiple_of(stride)) {
        let expected = format!("a positive multiple of {stride}");
        report.fault(Fault::BadLength { array: "vertices", length, expected });
    }
    if links.twins.len() != length {
        let expected = format!("{length}, as many as vertices");
        report.fault(Fault::BadLength { array: "twins", length: links.twins.len(), expected });
    }
    (report.is_clean() && stride > 0).then_some(stride)
}

struct Gluing<'a> {
    links: &'a Links<'a>,
    stride: usize,
}

impl Gluing<'_> {
    fn check(&self, report: &mut Report) {
        report.check("T1: vertices are distinct within each cell, the ghost at most once", |r| {
            self.check_cells(r);
        });
        let facets = Facets::new(self.stride, self.links.vertices, |_| Some(false));
        report.check("T4: twins are mutual, with equal vertices and opposite orientations", |r| {
            self.check_twins(&facets, r);
        });
        report.check("T4: every facet occurs in exactly two cells", |r| check_closed(&facets, r));
        report.check("T4: ghosts stand on the boundary of the solid cells", |r| {
            self.check_ghosts(r);
        });
        report.check("T6, T7: connected, with the euler characteristic of a sphere", |r| {
            self.check_sphere(&facets, r);
        });
    }

    fn cell(&self, cell: usize) -> &[u32] {
        &self.links.vertices[cell * self.stride..(cell + 1) * self.stride]
    }

    /// The twin of a facet, if in range.
    fn twin(&self, facet: usize) -> Option<usize> {
        let twin = self.links.twins[facet] as usize;
        (twin < self.links.twins.len()).then_some(twin)
    }

    fn check_cells(&self, report: &mut Report) {
        for (cell, corners) in self.links.vertices.chunks_exact(self.stride).enumerate() {
            let Some(i) = (1..self.stride).find(|&i| corners[..i].contains(&corners[i])) else {
                continue;
            };
            report.fault(if corners[i] == self.links.ghost {
                Fault::TwoGhosts { cell }
            } else {
                Fault::RepeatedVertex { cell, vertices: corners.to_vec() }
            });
        }
    }

    fn check_twins(&self, facets: &Facets<'_>, report: &mut Report) {
        // The rank of its vertex set, and the sign, of every facet.
        let mut known = vec![(0, false); self.links.twins.len()];
        for (rank, group) in facets.groups().enumerate() {
            for f in group {
                known[f.number] = (rank, f.negative);
            }
        }
        for facet in 0..self.links.twins.len() {
            let Some(twin) = self.twin(facet) else {
                let twin = self.links.twins[facet] as usize;
                report.fault(Fault::TwinOutOfRange { facet, twin });
                continue;
            };
            let back = self.links.twins[twin] as usize;
            if back != facet {
                report.fault(Fault::TwinNotMutual { facet, twin, back });
            }
            let (mine, other) = (known[facet], known[twin]);
            if mine.0 != other.0 || facet == twin {
                let vertices = [self.facet(facet), self.facet(twin)];
                report.fault(Fault::TwinMismatch { facet, twin, vertices });
            } else if mine.1 == other.1 && self.stride > 1 {
                // In dimension 0 two points carry no order to compare.
                let vertices = self.facet(facet);
                report.fault(Fault::TwinOrientation { facet, twin, vertices });
            }
        }
    }

    /// The vertices of a facet, ascending.
    fn facet(&self, facet: usize) -> Vec<u32> {
        let (cell, skipped) = (facet / self.stride, facet % self.stride);
        let mut vertices = self.cell(cell).to_vec();
        vertices.remove(skipped);
        vertices.sort_unstable();
        vertices
    }

    fn check_ghosts(&self, report: &mut Report) {
        if self.stride == 1 {
            return; // one point and the ghost: there is nothing between them
        }
        let ghost = self.links.ghost;
        for (facet, &v) in self.links.vertices.iter().enumerate() {
            let Some(twin) = self.twin(facet).filter(|_| v == ghost) else { continue };
            let beyond = twin / self.stride;
            if self.cell(beyond).contains(&ghost) {
                report.fault(Fault::GhostBesideGhost { cell: facet / self.stride, beyond });
            }
        }
    }

    fn check_sphere(&self, facets: &Facets<'_>, report: &mut Report) {
        let (k, cells) = (self.stride - 1, self.links.vertices.len() / self.stride);
        let mut pieces = Pieces::new(cells);
        for facet in 0..self.links.twins.len() {
            if let Some(twin) = self.twin(facet) {
                pieces.join(facet / self.stride, twin / self.stride);
            }
        }
        let pieces = pieces.count(|_| true);
        if pieces != 1 {
            report.fault(Fault::Disconnected { what: "cells, ghosts included,", pieces });
        }
        if k > 5 {
            return;
        }
        let mut counts: Vec<usize> =
            (1..k).map(|size| count_faces(self.links.vertices, self.stride, size)).collect();
        if k > 0 {
            counts.push(facets.groups().count());
        }
        counts.push(cells);
        let (found, expected) = (alternating_sum(&counts), if k % 2 == 0 { 2 } else { 0 });
        if found != expected {
            report.fault(Fault::Euler { found, expected });
        }
    }
}

fn check_closed(facets: &Facets<'_>, report: &mut Report) {
    for group in facets.groups().filter(|g| g.len() != 2) {
        report.fault(Fault::NotClosed { vertices: facets.vertices(&group[0]), cells: group.len() });
    }
}

#[cfg(test)]
mod tests;
