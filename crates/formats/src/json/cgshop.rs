//! Instances of the CG:SHOP 2025 challenge: `points_x`, `points_y`, `region_boundary` (a ring of indices) and
//! `additional_constraints` (index pairs).

use serde_json::Value;

use super::{array, index_list, number, unexpected};
use crate::document::Document;
use crate::error::{ReadError, at};

pub(super) fn read(value: &Value) -> Result<Document, ReadError> {
    let member = |name: &str| array(value.get(name).unwrap_or(&Value::Null), name);
    let (xs, ys) = (member("points_x")?, member("points_y")?);
    if xs.len() != ys.len() {
        let (announced, found) = (xs.len(), ys.len());
        return Err(ReadError::CountDiffers { at: at(0), of: "y coordinates", announced, found });
    }
    let announced = value.get("num_points").and_then(Value::as_u64);
    if announced.is_some_and(|n| usize::try_from(n) != Ok(xs.len())) {
        return Err(unexpected(&format!("num_points {}", xs.len()), &value["num_points"]));
    }
    let mut document = Document::new(2);
    for (x, y) in xs.iter().zip(ys) {
        document.push_point(&[number(x)?, number(y)?], 0)?;
    }
    let points = document.point_count();
    let ring = index_list(value.get("region_boundary").unwrap_or(&Value::Null), points)?;
    document.segments.extend(ring.windows(2).map(|pair| [pair[0], pair[1]]));
    if let [first, .., last] = ring[..] {
        document.segments.push([last, first]);
    }
    for edge in member("additional_constraints")? {
        match index_list(edge, points)?[..] {
            [a, b] => document.segments.push([a, b]),
            _ => return Err(unexpected("a pair of indices", edge)),
        }
    }
    Ok(document)
}
