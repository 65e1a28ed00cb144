//! The sentences of the faults.

use super::{Fault, Witness};
use std::fmt::{Display, Formatter, Result};

impl Display for Witness {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "p{}(", self.id)?;
        for (i, x) in self.at.iter().enumerate() {
            write!(f, "{}{x:?}", if i == 0 { "" } else { ", " })?;
        }
        write!(f, ")")
    }
}

struct List<'a, T>(&'a [T]);

impl<T: Display> Display for List<'_, T> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        for (i, x) in self.0.iter().enumerate() {
            write!(f, "{}{x}", if i == 0 { "" } else { " " })?;
        }
        Ok(())
    }
}

impl Display for Fault {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Self::NotFinite { .. }
            | Self::WeightNotFinite { .. }
            | Self::BadLength { .. }
            | Self::BadDimension { .. }
            | Self::IdOutOfRange { .. }
            | Self::RepeatedVertex { .. }
            | Self::DuplicateCell { .. }
            | Self::UnusedPoint { .. }
            | Self::DuplicatePoint { .. }
            | Self::SegmentOutOfRange { .. } => fmt_input(self, f),
            Self::ExtraSimplex { .. } | Self::MissingSimplex { .. } | Self::WrongValue { .. } => {
                fmt_filtration(self, f)
            }
            Self::TwoGhosts { .. }
            | Self::TwinOutOfRange { .. }
            | Self::TwinNotMutual { .. }
            | Self::TwinMismatch { .. }
            | Self::TwinOrientation { .. }
            | Self::NotClosed { .. }
            | Self::GhostBesideGhost { .. } => fmt_links(self, f),
            Self::BrokenSegment { .. }
            | Self::MissingFlag { .. }
            | Self::ExtraFlag { .. }
            | Self::FlagNotEdge { .. }
            | Self::FillLeaks { .. }
            | Self::OffSegment { .. }
            | Self::BesideSegment { .. }
            | Self::EncroachedEdge { .. }
            | Self::SmallAngle { .. }
            | Self::NoException { .. }
            | Self::WrongSide { .. } => fmt_constraints(self, f),
            _ => fmt_geometry(self, f),
        }
    }
}

fn fmt_input(fault: &Fault, f: &mut Formatter<'_>) -> Result {
    match fault {
        Fault::NotFinite { point } => write!(f, "{point} has a coordinate that is not finite"),
        Fault::WeightNotFinite { point, weight } => {
            write!(f, "{point} has the weight {weight}, which is not finite")
        }
        Fault::BadLength { array, length, expected } => {
            write!(f, "{array} holds {length} entries, which is not {expected}")
        }
        Fault::BadDimension { dimension: Some(k), ambient, points } => {
            write!(f, "dimension {k} is impossible for {points} points in {ambient} dimensions")
        }
        Fault::BadDimension { dimension: None, points, .. } => {
            write!(f, "there are {points} points, so the dimension cannot be that of the empty set")
        }
        Fault::IdOutOfRange { cell, id, points } => {
            write!(f, "cell {cell} has the vertex {id}, but there are only {points} points")
        }
        Fault::RepeatedVertex { cell, vertices } => {
            write!(f, "cell {cell} = {} has a vertex twice", List(vertices))
        }
        Fault::DuplicateCell { first, second, vertices } => {
            write!(f, "cells {first} and {second} are both made of {}", List(vertices))
        }
        Fault::UnusedPoint { point } => {
            write!(f, "{point} is a vertex of no cell and equals no point that is")
        }
        Fault::DuplicatePoint { point, first } => {
            write!(f, "{point} is a vertex, and so is p{first}, which equals it")
        }
        Fault::SegmentOutOfRange { segment, id, points } => {
            write!(f, "segment {segment} ends at {id}, but there are only {points} points")
        }
        _ => f.write_str(fault.kind()),
    }
}

fn fmt_geometry(fault: &Fault, f: &mut Formatter<'_>) -> Result {
    match fault {
        Fault::FlatCell { cell, corners } => {
            write!(f, "cell {cell} = {} is flat", List(corners))
        }
        Fault::NegativeCell { cell, corners } => {
            write!(f, "cell {cell} = {} is oriented negatively", List(corners))
        }
        Fault::OffFlat { point, flat } => {
            write!(f, "{point} is not in the flat through {}", List(flat))
        }
        Fault::FoldedFacet { facet, cells: [a, b] } => {
            write!(f, "cells {a} and {b} lie on the same side of their facet {}", List(facet))
        }
        Fault::CrowdedFacet { facet, cells } => {
            write!(f, "{cells} cells share the facet {}", List(facet))
        }
        Fault::OpenBoundary { ridge, facets } => write!(
            f,
            "the boundary is open at the ridge {}, where {facets} of its facets meet",
            List(ridge)
        ),
        Fault::Disconnected { what, pieces } => write!(f, "the {what} form {pieces} pieces"),
        Fault::ReflexRidge { facet, beyond } => write!(
            f,
            "the boundary is not convex: {beyond} of a neighbouring facet lies beyond {}",
            List(facet)
        ),
        Fault::UnseenFacet { facet, cell } => write!(
            f,
            "the barycentre of {} is not strictly inside the boundary facet {}",
            List(cell),
            List(facet)
        ),
        Fault::WindsAgain { facet, cell, times } => write!(
            f,
            "a ray from the barycentre of {} through {} meets the boundary {times} times",
            List(cell),
            List(facet)
        ),
        Fault::RayUndecided { facet } => {
            write!(f, "no ray in general position through {} was found", List(facet))
        }
        Fault::Euler { found, expected } => {
            write!(f, "the euler characteristic is {found} instead of {expected}")
        }
        Fault::NotDelaunay { cell, inside } => {
            write!(f, "{inside} is inside the sphere of the neighbouring cell {}", List(cell))
        }
        Fault::NotHidden { point, cell } => {
            write!(f, "{point} is no vertex, and inside the sphere of {}", List(cell))
        }
        Fault::BeyondHull { point, facet } => {
            write!(f, "{point} is no vertex, and outside the hull, beyond {}", List(facet))
        }
        Fault::WrongTie { cell, inside } => write!(
            f,
            "{inside} is on the sphere of the neighbouring cell {}, and its rank puts it inside",
            List(cell)
        ),
        _ => f.write_str(fault.kind()),
    }
}

fn fmt_constraints(fault: &Fault, f: &mut Formatter<'_>) -> Result {
    match fault {
        Fault::BrokenSegment { segment, ends, stuck } => {
            write!(f, "no edge leads from {stuck} along segment {segment} = {}", List(ends))
        }
        Fault::FillLeaks { edge } => {
            write!(f, "the fill changes across the edge {}, which is on no segment", List(edge))
        }
        Fault::WrongSide { cell, inside: true } => {
            write!(f, "the cell {} is inside and should be outside", List(cell))
        }
        Fault::WrongSide { cell, inside: false } => {
            write!(f, "the cell {} is outside and should be inside", List(cell))
        }
        Fault::MissingFlag { edge, segment } => write!(
            f,
            "the edge {} lies on segment {segment} and is not flagged as constrained",
            List(edge)
        ),
        Fault::ExtraFlag { edge } => {
            write!(f, "the edge {} is flagged as constrained and lies on no segment", List(edge))
        }
        Fault::OffSegment { point, ends } => write!(
            f,
            "the steiner point {point} is not strictly between {}, or these are no part of a segment",
            List(ends)
        ),
        Fault::BesideSegment { segment, ends, point, distance } => write!(
            f,
            "the steiner point {point} is {distance:e} off segment {segment}, {}",
            List(ends)
        ),
        Fault::EncroachedEdge { edge, by } => {
            write!(f, "{by} is in the closed diametral disk of the subsegment {}", List(edge))
        }
        Fault::SmallAngle { cell, at } => {
            write!(f, "the angle at {at} in {} is less than the least", List(cell))
        }
        Fault::NoException { cell } => write!(
            f,
            "{} is an exception, and touches no two segments that meet at less than 60 degrees",
            List(cell)
        ),
        Fault::FlagNotEdge { ends: [a, b] } => {
            write!(f, "{a} {b} is flagged as constrained and is not an edge")
        }
        _ => f.write_str(fault.kind()),
    }
}

fn fmt_filtration(fault: &Fault, f: &mut Formatter<'_>) -> Result {
    match fault {
        Fault::ExtraSimplex { simplex } => {
            write!(f, "{} is no face of a cell, or told twice", List(simplex))
        }
        Fault::MissingSimplex { simplex } => write!(f, "the face {} is missing", List(simplex)),
        Fault::WrongValue { simplex, claimed, value } => {
            write!(f, "{} has the value {value} and not {claimed}", List(simplex))
        }
        _ => f.write_str(fault.kind()),
    }
}

fn fmt_links(fault: &Fault, f: &mut Formatter<'_>) -> Result {
    match fault {
        Fault::TwoGhosts { cell } => write!(f, "cell {cell} has the ghost vertex twice"),
        Fault::TwinOutOfRange { facet, twin } => {
            write!(f, "facet {facet} has the twin {twin}, which is not the number of a facet")
        }
        Fault::TwinNotMutual { facet, twin, back } => {
            write!(f, "facet {facet} has the twin {twin}, whose twin is {back}")
        }
        Fault::TwinMismatch { facet, twin, vertices: [a, b] } => write!(
            f,
            "facet {facet} has the vertices {} and its twin {twin} has {}",
            List(a),
            List(b)
        ),
        Fault::TwinOrientation { facet, twin, vertices } => write!(
            f,
            "facet {facet} and its twin {twin} see their vertices {} from the same side",
            List(vertices)
        ),
        Fault::NotClosed { vertices, cells } => {
            write!(f, "the facet {} occurs in {cells} cells instead of 2", List(vertices))
        }
        Fault::GhostBesideGhost { cell, beyond } => {
            write!(f, "the outer facet of the ghost cell {cell} leads to the ghost cell {beyond}")
        }
        _ => f.write_str(fault.kind()),
    }
}
