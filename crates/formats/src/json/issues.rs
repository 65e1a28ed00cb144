//! Inputs collected from bug reports: `points`, `edges` (index pairs), `segments` (coordinate quadruples),
//! `hole_points`; and `grids` of Kettner et al., whose triples p, q, r each become a document of three points.
//!
//! Points are kept as listed. The ends of a quadruple name the first equal point, or are added.

use serde_json::Value;

use super::{array, index_list, pair, position, unexpected};
use crate::document::Document;
use crate::error::ReadError;

pub(super) fn read(value: &Value) -> Result<Document, ReadError> {
    let list = |name: &str| match value.get(name) {
        None => Ok(&[][..]),
        Some(list) => array(list, name),
    };
    let points = list("points")?;
    let dimension = points.first().map_or(Ok(2), |point| position(point).map(|p| p.len()))?;
    if !matches!(dimension, 2 | 3) {
        return Err(unexpected("points of 2 or 3 coordinates", &points[0]));
    }
    let mut document = Document::new(dimension);
    for point in points {
        let xs = position(point)?;
        if xs.len() != dimension {
            return Err(unexpected(&format!("a point of {dimension} coordinates"), point));
        }
        document.push_point(&xs, 0)?;
    }
    for edge in list("edges")? {
        match index_list(edge, document.point_count())?[..] {
            [a, b] => document.segments.push([a, b]),
            _ => return Err(unexpected("a pair of indices", edge)),
        }
    }
    read_quadruples(list("segments")?, &mut document)?;
    for hole in list("hole_points")? {
        let seed = position(hole)?;
        if seed.len() != dimension {
            return Err(unexpected(&format!("a point of {dimension} coordinates"), hole));
        }
        document.holes.extend(seed);
    }
    Ok(document)
}

fn read_quadruples(segments: &[Value], document: &mut Document) -> Result<(), ReadError> {
    if segments.is_empty() {
        return Ok(());
    }
    let listed = document.point_count() + 2 * segments.len();
    let mut known = std::collections::BTreeMap::new();
    for (i, point) in (0_u32..).zip(document.points.chunks_exact(document.dimension)) {
        known.entry(key(point)).or_insert(i);
    }
    for segment in segments {
        let xs = position(segment)?;
        if document.dimension != 2 || xs.len() != 4 {
            return Err(unexpected("a segment x1, y1, x2, y2", segment));
        }
        let mut ends = [0; 2];
        for (end, point) in ends.iter_mut().zip(xs.chunks_exact(2)) {
            *end = match known.get(&key(point)) {
                Some(&index) => index,
                None => document.push_point(point, 0)?,
            };
            known.insert(key(point), *end);
        }
        if ends[0] == ends[1] {
            document.zero_length_dropped += 1;
        } else {
            document.segments.push(ends);
        }
    }
    document.points_listed = listed;
    Ok(())
}

fn key(point: &[f64]) -> Vec<u64> {
    point.iter().map(|x| x.to_bits()).collect()
}

pub(super) fn read_grids(value: &Value) -> Result<Vec<Document>, ReadError> {
    let grids = array(value.get("grids").unwrap_or(&Value::Null), "an array of grids")?;
    let mut documents = Vec::new();
    for grid in grids {
        let mut document = Document::new(2);
        for corner in ["p", "q", "r"] {
            let point =
                grid.get(corner).ok_or_else(|| unexpected("a grid with p, q and r", grid))?;
            document.push_point(&pair(point)?, 0)?;
        }
        document.note("only the three corners of the sweep are read");
        documents.push(document);
    }
    Ok(documents)
}
