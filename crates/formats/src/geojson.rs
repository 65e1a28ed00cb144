//! GeoJSON: all features of a file are one document; rings, lines and points as in `shapes`, altitudes dropped, noted.
//!
//! Written is a `FeatureCollection` of three features at most: all points, all segments, all faces.

use std::io::{self, Write};

use geojson::{GeoJson, GeometryValue, Position};
use serde_json::Value;

use crate::document::Document;
use crate::error::ReadError;
use crate::shapes::Shapes;
use crate::write::{Lost, shortest};

/// Whether a JSON object is GeoJSON.
pub(crate) fn looks_like(value: &Value) -> bool {
    let kind = value.get("type").and_then(Value::as_str).unwrap_or("");
    matches!(kind, "FeatureCollection" | "Feature" | "GeometryCollection")
        || ["Point", "LineString", "Polygon"].iter().any(|suffix| kind.ends_with(suffix))
}

pub(crate) fn read(value: Value) -> Result<Document, ReadError> {
    let tree: GeoJson = serde_json::from_value(value)
        .map_err(|error| ReadError::malformed(0, "GeoJSON", &error.to_string()))?;
    let mut reader = Reader { shapes: Shapes::new(2), higher: 0 };
    match &tree {
        GeoJson::Geometry(geometry) => reader.geometry(&geometry.value)?,
        GeoJson::Feature(feature) => reader.feature(feature)?,
        GeoJson::FeatureCollection(collection) => {
            for feature in &collection.features {
                reader.feature(feature)?;
            }
        }
    }
    if reader.higher > 0 {
        reader.shapes.note(format!("altitude dropped of {} positions", reader.higher));
    }
    Ok(reader.shapes.finish())
}

struct Reader {
    shapes: Shapes,
    higher: usize,
}

impl Reader {
    fn feature(&mut self, feature: &geojson::Feature) -> Result<(), ReadError> {
        feature.geometry.as_ref().map_or(Ok(()), |geometry| self.geometry(&geometry.value))
    }

    fn geometry(&mut self, value: &GeometryValue) -> Result<(), ReadError> {
        match value {
            GeometryValue::Point { coordinates } => self.point(coordinates)?,
            GeometryValue::MultiPoint { coordinates } => {
                coordinates.iter().try_for_each(|position| self.point(position))?;
            }
            GeometryValue::LineString { coordinates } => self.line(coordinates)?,
            GeometryValue::MultiLineString { coordinates } => {
                coordinates.iter().try_for_each(|line| self.line(line))?;
            }
            GeometryValue::Polygon { coordinates } => {
                coordinates.iter().try_for_each(|ring| self.ring(ring))?;
            }
            GeometryValue::MultiPolygon { coordinates } => {
                coordinates.iter().flatten().try_for_each(|ring| self.ring(ring))?;
            }
            GeometryValue::GeometryCollection { geometries } => {
                geometries.iter().try_for_each(|geometry| self.geometry(&geometry.value))?;
            }
        }
        Ok(())
    }

    fn point(&mut self, position: &Position) -> Result<(), ReadError> {
        let point = self.xy(position)?;
        self.shapes.point(&point).map(drop)
    }

    fn line(&mut self, line: &[Position]) -> Result<(), ReadError> {
        let points = line.iter().map(|p| self.xy(p)).collect::<Result<Vec<_>, _>>()?;
        self.shapes.line(&points)
    }

    fn ring(&mut self, ring: &[Position]) -> Result<(), ReadError> {
        let points = ring.iter().map(|p| self.xy(p)).collect::<Result<Vec<_>, _>>()?;
        self.shapes.ring(&points)
    }

    fn xy(&mut self, position: &Position) -> Result<[f64; 2], ReadError> {
        match position.as_slice() {
            [x, y] => Ok([*x, *y]),
            [x, y, ..] => {
                self.higher += 1;
                Ok([*x, *y])
            }
            short => {
                Err(ReadError::malformed(0, "a position of two numbers", &format!("{short:?}")))
            }
        }
    }
}

/// All faces of a document, triangles first.
pub(crate) fn faces(document: &Document) -> impl Iterator<Item = &[u32]> {
    let triangles = document.triangles.iter().map(|t| &t[..]);
    triangles.chain(document.polygons.iter().map(|p| &p[..])).filter(|face| !face.is_empty())
}

pub(crate) fn write(document: &Document, out: &mut impl Write) -> io::Result<()> {
    let at = |v: u32| {
        usize::try_from(v).ok().and_then(|v| document.point(v)).map_or_else(String::new, position)
    };
    let mut features = Vec::new();
    if document.point_count() > 0 {
        let points: Vec<String> =
            document.points.chunks_exact(document.dimension.max(1)).map(position).collect();
        features.push(feature("MultiPoint", &points));
    }
    if !document.segments.is_empty() {
        let lines: Vec<String> =
            document.segments.iter().map(|&[a, b]| format!("[{},{}]", at(a), at(b))).collect();
        features.push(feature("MultiLineString", &lines));
    }
    let polygons: Vec<String> = faces(document)
        .map(|face| {
            let ring: Vec<String> = face.iter().chain(face.first()).map(|&v| at(v)).collect();
            format!("[[{}]]", ring.join(","))
        })
        .collect();
    if !polygons.is_empty() {
        features.push(feature("MultiPolygon", &polygons));
    }
    writeln!(out, "{{\"type\":\"FeatureCollection\",\"features\":[{}]}}", features.join(",\n"))
}

fn position(point: &[f64]) -> String {
    format!("[{}]", point.iter().map(|&x| shortest(x)).collect::<Vec<_>>().join(","))
}

fn feature(kind: &str, coordinates: &[String]) -> String {
    let coordinates = coordinates.join(",");
    format!(
        "{{\"type\":\"Feature\",\"properties\":{{}},\"geometry\":{{\"type\":\"{kind}\",\"coordinates\":[{coordinates}]}}}}"
    )
}

pub(crate) fn lost(document: &Document, lost: &mut Lost) {
    lost.if_any("tetrahedra", document.tets.len());
    lost.seeds(document);
    lost.labels(document);
}

#[cfg(test)]
mod tests;
