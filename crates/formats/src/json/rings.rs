//! Bare arrays: rings as earcut takes them (the first is the outline, the rest are holes), or points.

use serde_json::Value;

use super::{array, number, pairs, position, unexpected};
use crate::document::Document;
use crate::error::ReadError;
use crate::shapes::Shapes;

pub(super) fn read(items: &[Value]) -> Result<Document, ReadError> {
    let first = items.first();
    let inner = first.and_then(Value::as_array).and_then(|item| item.first());
    if inner.is_some_and(Value::is_array) {
        return read_rings(items);
    }
    if first.is_some_and(|item| !item.is_array()) {
        return read_flat(items);
    }
    read_points(items)
}

fn read_rings(rings: &[Value]) -> Result<Document, ReadError> {
    let mut shapes = Shapes::new(2);
    for ring in rings {
        shapes.ring(&pairs(ring)?)?;
    }
    Ok(shapes.finish())
}

fn read_points(items: &[Value]) -> Result<Document, ReadError> {
    let dimension =
        items.first().map_or(Ok(2), |item| array(item, "a point").map(<[Value]>::len))?;
    if !matches!(dimension, 2 | 3) {
        return Err(unexpected("points of 2 or 3 coordinates", &items[0]));
    }
    let mut document = Document::new(dimension);
    for item in items {
        let point = position(item)?;
        if point.len() != dimension {
            return Err(unexpected(&format!("a point of {dimension} coordinates"), item));
        }
        document.push_point(&point, 0)?;
    }
    Ok(document)
}

/// `[x, y, x, y, ..]`.
fn read_flat(items: &[Value]) -> Result<Document, ReadError> {
    let xs = items.iter().map(number).collect::<Result<Vec<f64>, _>>()?;
    let (points, rest) = xs.as_chunks::<2>();
    if !rest.is_empty() {
        let found = format!("{} numbers", xs.len());
        let want = "x and y in turn (a list of triangle corners has no points to read)";
        return Err(ReadError::malformed(0, want, &found));
    }
    let mut document = Document::new(2);
    for point in points {
        document.push_point(point, 0)?;
    }
    Ok(document)
}
