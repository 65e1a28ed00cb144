//! Font outlines in the drawing operations of fontTools; each glyph is a document named by its character.
//!
//! Curves are flattened by the rule of `curves`: a `curveTo` is one cubic; a `qCurveTo` is a chain of quadratics with an
//! implied point half way between each two control points, its last point on the curve.

use serde_json::Value;

use super::{array, pairs, unexpected};
use crate::curves::flatten;
use crate::document::Document;
use crate::error::ReadError;
use crate::shapes::Shapes;

pub(super) fn read(value: &Value) -> Result<Vec<Document>, ReadError> {
    let glyphs = value.get("glyphs").and_then(Value::as_object);
    let glyphs = glyphs.ok_or_else(|| unexpected("an object of glyphs", value))?;
    let mut documents = Vec::new();
    for (name, glyph) in glyphs {
        let path = array(glyph.get("path").unwrap_or(&Value::Null), "a glyph's path")?;
        let mut document = outline(path)?;
        document.name.clone_from(name);
        documents.push(document);
    }
    Ok(documents)
}

fn outline(path: &[Value]) -> Result<Document, ReadError> {
    let mut shapes = Shapes::new(2);
    let mut ring: Vec<[f64; 2]> = Vec::new();
    for step in path {
        let (Some(verb), Some(controls)) = (step.get(0).and_then(Value::as_str), step.get(1))
        else {
            return Err(unexpected("[verb, points]", step));
        };
        let controls = pairs(controls)?;
        let from = ring.last().copied();
        match (verb, from, &controls[..]) {
            ("moveTo", _, [start]) => {
                shapes.line(&std::mem::take(&mut ring))?;
                ring.push(*start);
            }
            ("lineTo", Some(_), [to]) => ring.push(*to),
            ("curveTo", Some(from), [_, _, _]) => flatten(from, &controls, &mut ring),
            ("qCurveTo", Some(_), [.., _]) => quadratics(&controls, &mut ring),
            ("closePath", _, []) => shapes.ring(&std::mem::take(&mut ring))?,
            ("endPath", _, []) => shapes.line(&std::mem::take(&mut ring))?,
            _ => return Err(unexpected("a drawing step with its points", step)),
        }
    }
    shapes.line(&ring)?;
    Ok(shapes.finish())
}

/// Off-curve points and, last, the one on the curve.
fn quadratics(controls: &[[f64; 2]], ring: &mut Vec<[f64; 2]>) {
    let Some((&end, off)) = controls.split_last() else { return };
    for (i, &control) in off.iter().enumerate() {
        let to = match off.get(i + 1) {
            Some(next) => [f64::midpoint(control[0], next[0]), f64::midpoint(control[1], next[1])],
            None => end,
        };
        if let Some(&from) = ring.last() {
            flatten(from, &[control, to], ring);
        }
    }
    if off.is_empty() {
        ring.push(end);
    }
}
