//! Feature curves of TriWild: Bezier curves by their `poles`, read as open polylines of the control points.

use serde_json::Value;

use super::{pairs, unexpected};
use crate::document::Document;
use crate::error::ReadError;
use crate::shapes::Shapes;

pub(super) fn read(items: &[Value]) -> Result<Document, ReadError> {
    let mut shapes = Shapes::new(2);
    for item in items {
        let poles = item.get("poles").ok_or_else(|| unexpected("a curve with poles", item))?;
        shapes.line(&pairs(poles)?)?;
    }
    shapes.note(format!("{} curves read as polylines of their control points", items.len()));
    Ok(shapes.finish())
}
