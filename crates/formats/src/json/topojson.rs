//! TopoJSON: every arc once, as a line; quantized arcs are summed up and scaled as `transform` says.
//!
//! Which arcs make which object is not read: the arcs already are the map without its double borders. Points of the
//! objects, which have no arcs, are not read either (noted when there are some).

use serde_json::Value;

use super::{array, number, pair, pairs, unexpected};
use crate::document::Document;
use crate::error::ReadError;
use crate::shapes::Shapes;

pub(super) fn read(value: &Value) -> Result<Document, ReadError> {
    let arcs = array(value.get("arcs").unwrap_or(&Value::Null), "an array of arcs")?;
    let transform = value.get("transform").map(Transform::read).transpose()?;
    let mut shapes = Shapes::new(2);
    for arc in arcs {
        let mut points = pairs(arc)?;
        if let Some(transform) = &transform {
            transform.dequantize(&mut points);
        }
        shapes.line(&points)?;
    }
    let objects = value.get("objects").and_then(Value::as_object);
    let loose =
        objects.into_iter().flat_map(serde_json::Map::values).filter(|object| holds_points(object));
    let loose = loose.count();
    if loose > 0 {
        shapes.note(format!("points of {loose} objects not read"));
    }
    Ok(shapes.finish())
}

fn holds_points(object: &Value) -> bool {
    let is_point =
        |o: &Value| matches!(o.get("type").and_then(Value::as_str), Some("Point" | "MultiPoint"));
    let members = object.get("geometries").and_then(Value::as_array);
    is_point(object) || members.is_some_and(|members| members.iter().any(is_point))
}

struct Transform {
    scale: [f64; 2],
    translate: [f64; 2],
}

impl Transform {
    fn read(value: &Value) -> Result<Self, ReadError> {
        match (value.get("scale"), value.get("translate")) {
            (Some(scale), Some(translate)) => {
                array(scale, "a scale")?.iter().try_for_each(|x| number(x).map(drop))?;
                Ok(Self { scale: pair(scale)?, translate: pair(translate)? })
            }
            _ => Err(unexpected("a transform with scale and translate", value)),
        }
    }

    /// Quantized positions are whole and relative to the one before: their sums are exact.
    fn dequantize(&self, points: &mut [[f64; 2]]) {
        let mut sum = [0.0; 2];
        for point in points {
            for axis in 0..2 {
                sum[axis] += point[axis];
                point[axis] = sum[axis] * self.scale[axis] + self.translate[axis];
            }
        }
    }
}
