//! JSON files: which dialect, and the pieces all dialects share.
//!
//! | recognised by | dialect |
//! |---|---|
//! | `type` of GeoJSON | GeoJSON |
//! | `V` | LAR |
//! | `type` `Topology` | TopoJSON |
//! | `points_x` | CG:SHOP instance |
//! | `glyphs` | font outlines |
//! | `points`, `edges`, `segments`, `hole_points`, `grids` | collected bug reports |
//! | `[[[x,y],..],..]` | rings: earcut |
//! | `[[x,y],..]`, `[x,y,..]` | points |
//! | `[{"poles": ..},..]` | curves of TriWild |
//!
//! Numbers may be given as decimal strings. JSON tells no line of a fault in its structure, only of its syntax; the
//! faulty value is shown instead.

mod cgshop;
mod curves;
mod glyphs;
mod issues;
mod rings;
mod topojson;

#[cfg(test)]
mod tests;

use serde_json::Value;

use crate::document::Document;
use crate::error::ReadError;
use crate::{geojson, lar};

/// The tree of a text. Its depth is bounded (128) by the parser.
pub(crate) fn parse(text: &str) -> Result<Value, ReadError> {
    serde_json::from_str(text).map_err(|error| {
        if error.is_eof() {
            ReadError::truncated(error.line(), "the end of the JSON value")
        } else {
            ReadError::malformed(error.line(), "valid JSON", &error.to_string())
        }
    })
}

pub(crate) fn read(value: Value) -> Result<Vec<Document>, ReadError> {
    if geojson::looks_like(&value) {
        return Ok(vec![geojson::read(value)?]);
    }
    let has = |key: &str| value.get(key).is_some();
    if lar::looks_like(&value) {
        Ok(vec![lar::read(&value)?])
    } else if has("arcs") && has("objects") {
        Ok(vec![topojson::read(&value)?])
    } else if has("points_x") {
        Ok(vec![cgshop::read(&value)?])
    } else if has("glyphs") {
        glyphs::read(&value)
    } else if has("grids") {
        issues::read_grids(&value)
    } else if has("points") || has("segments") {
        Ok(vec![issues::read(&value)?])
    } else if let Value::Array(items) = &value {
        if items.first().is_some_and(|item| item.get("poles").is_some()) {
            Ok(vec![curves::read(items)?])
        } else {
            Ok(vec![rings::read(items)?])
        }
    } else {
        Err(unexpected("a JSON dialect with points in it", &value))
    }
}

/// A refusal that shows the value.
pub(crate) fn unexpected(expected: &str, found: &Value) -> ReadError {
    ReadError::malformed(0, expected, &abridged(found))
}

/// The first level of a value: printing all of a long array to show its first sixty characters would be a waste.
fn abridged(value: &Value) -> String {
    match value {
        Value::Array(items) if items.len() > 8 => format!("an array of {} items", items.len()),
        Value::Object(members) => {
            let keys: Vec<&str> = members.keys().take(8).map(String::as_str).collect();
            format!("an object with {}", keys.join(", "))
        }
        other => other.to_string(),
    }
}

/// A number, or a number in quotes.
pub(crate) fn number(value: &Value) -> Result<f64, ReadError> {
    let read = match value {
        Value::Number(number) => number.as_f64(),
        Value::String(text) => crate::text::parse_number(text.trim()),
        _ => None,
    };
    read.ok_or_else(|| unexpected("a number", value))
}

/// The numbers of a point, however many.
pub(crate) fn position(value: &Value) -> Result<Vec<f64>, ReadError> {
    array(value, "a point")?.iter().map(number).collect()
}

/// A point in the plane.
pub(crate) fn pair(value: &Value) -> Result<[f64; 2], ReadError> {
    match position(value)?[..] {
        [x, y] => Ok([x, y]),
        _ => Err(unexpected("a point of two coordinates", value)),
    }
}

pub(crate) fn pairs(value: &Value) -> Result<Vec<[f64; 2]>, ReadError> {
    array(value, "an array of points")?.iter().map(pair).collect()
}

pub(crate) fn array<'a>(value: &'a Value, expected: &str) -> Result<&'a [Value], ReadError> {
    value.as_array().map(Vec::as_slice).ok_or_else(|| unexpected(expected, value))
}

/// A point's index among `points`.
pub(crate) fn index(value: &Value, points: usize) -> Result<u32, ReadError> {
    if !value.is_number() {
        return Err(unexpected("a point index", value));
    }
    value
        .as_u64()
        .and_then(|i| u32::try_from(i).ok())
        .filter(|&i| usize::try_from(i).is_ok_and(|i| i < points))
        .ok_or_else(|| lar::out_of_range(value, points))
}

pub(crate) fn index_list(value: &Value, points: usize) -> Result<Vec<u32>, ReadError> {
    array(value, "an array of point indices")?.iter().map(|i| index(i, points)).collect()
}
