//! SVG drawings, read only: `path`, `polygon`, `polyline`, `line`, `rect` become rings and lines.
//!
//! Transforms of the element and of the groups around it are applied (when there is none, coordinates stay exactly as
//! written; y points down as in the file). Curves are flattened by the rule of `curves`. A subpath ended by `Z`, a
//! `polygon` and a `rect` are rings, the rest are lines. Text, circles, styles, `use` and clipping are not read; circles
//! and ellipses are noted. All shapes of a file are one document.

use roxmltree::Node;
use svgtypes::{PathParser, PointsParser, SimplePathSegment, SimplifyingPathParser, Transform};

use crate::curves::flatten;
use crate::document::Document;
use crate::error::ReadError;
use crate::shapes::Shapes;
use crate::text::parse_number;
use crate::xml;

pub(crate) fn read(text: &str) -> Result<Document, ReadError> {
    let tree = xml::parse(text)?;
    if !tree.root_element().has_tag_name("svg") && tree.root_element().tag_name().name() != "svg" {
        return Err(ReadError::malformed(
            1,
            "an <svg> element",
            tree.root_element().tag_name().name(),
        ));
    }
    let mut shapes = Shapes::new(2);
    let mut round = 0_usize;
    for node in tree.root_element().descendants().filter(Node::is_element) {
        round += usize::from(matches!(node.tag_name().name(), "circle" | "ellipse"));
        let subpaths = element(&node).map_err(|error| error.after_line(xml::line(&tree, node)))?;
        for subpath in subpaths {
            if subpath.closed {
                shapes.ring(&subpath.points)?
            } else {
                shapes.line(&subpath.points)?
            }
        }
    }
    if round > 0 {
        shapes.note(format!("{round} circles and ellipses not read"));
    }
    Ok(shapes.finish())
}

#[derive(Debug, Default)]
struct Subpath {
    points: Vec<[f64; 2]>,
    closed: bool,
}

/// The subpaths of an element, transformed. Lines of faults count from the element's own.
fn element(node: &Node<'_, '_>) -> Result<Vec<Subpath>, ReadError> {
    let mut subpaths = match node.tag_name().name() {
        "path" => path(node.attribute("d").unwrap_or(""))?,
        "polygon" => vec![Subpath { points: points(node), closed: true }],
        "polyline" => vec![Subpath { points: points(node), closed: false }],
        "line" => vec![segment(node)?],
        "rect" => vec![rect(node)?],
        _ => return Ok(Vec::new()),
    };
    if let Some(ts) = transform_of(node)? {
        for p in subpaths.iter_mut().flat_map(|subpath| &mut subpath.points) {
            *p = [ts.a * p[0] + ts.c * p[1] + ts.e, ts.b * p[0] + ts.d * p[1] + ts.f];
        }
    }
    Ok(subpaths)
}

fn path(data: &str) -> Result<Vec<Subpath>, ReadError> {
    let mut subpaths: Vec<Subpath> = Vec::new();
    if data.trim().is_empty() {
        return Ok(subpaths);
    }
    // The lenient parser ends at the first fault; the strict one says whether there is one.
    if let Some(error) = PathParser::from(data).find_map(Result::err) {
        return Err(ReadError::malformed(1, "SVG path data", &error.to_string()));
    }
    let mut current = Subpath::default();
    let mut start = [0.0; 2];
    for segment in SimplifyingPathParser::from(data) {
        let segment = segment
            .map_err(|error| ReadError::malformed(1, "SVG path data", &error.to_string()))?;
        if !matches!(segment, SimplePathSegment::MoveTo { .. } | SimplePathSegment::ClosePath)
            && current.points.is_empty()
        {
            current.points.push(start);
        }
        let from = current.points.last().copied().unwrap_or(start);
        match segment {
            SimplePathSegment::MoveTo { x, y } => {
                subpaths.push(std::mem::take(&mut current));
                start = [x, y];
                current.points.push(start);
            }
            SimplePathSegment::LineTo { x, y } => current.points.push([x, y]),
            SimplePathSegment::Quadratic { x1, y1, x, y } => {
                flatten(from, &[[x1, y1], [x, y]], &mut current.points);
            }
            SimplePathSegment::CurveTo { x1, y1, x2, y2, x, y } => {
                flatten(from, &[[x1, y1], [x2, y2], [x, y]], &mut current.points);
            }
            SimplePathSegment::ClosePath => {
                current.closed = true;
                subpaths.push(std::mem::take(&mut current));
            }
        }
    }
    subpaths.push(current);
    // A lone `M` draws nothing.
    subpaths.retain(|subpath| subpath.points.len() > 1);
    Ok(subpaths)
}

fn points(node: &Node<'_, '_>) -> Vec<[f64; 2]> {
    PointsParser::from(node.attribute("points").unwrap_or("")).map(|(x, y)| [x, y]).collect()
}

fn attribute(node: &Node<'_, '_>, name: &str) -> Result<f64, ReadError> {
    let text = node.attribute(name).unwrap_or("0").trim();
    parse_number(text.strip_suffix("px").unwrap_or(text))
        .ok_or_else(|| ReadError::malformed(1, format!("a number as {name}"), text))
}

fn segment(node: &Node<'_, '_>) -> Result<Subpath, ReadError> {
    let at = |name: &str| attribute(node, name);
    Ok(Subpath { points: vec![[at("x1")?, at("y1")?], [at("x2")?, at("y2")?]], closed: false })
}

fn rect(node: &Node<'_, '_>) -> Result<Subpath, ReadError> {
    let at = |name: &str| attribute(node, name);
    let ([x, y], [w, h]) = ([at("x")?, at("y")?], [at("width")?, at("height")?]);
    Ok(Subpath { points: vec![[x, y], [x + w, y], [x + w, y + h], [x, y + h]], closed: true })
}

/// The product of all transforms from the root down, or nothing if there is none.
fn transform_of(node: &Node<'_, '_>) -> Result<Option<Transform>, ReadError> {
    let mut product: Option<Transform> = None;
    for text in node.ancestors().filter_map(|ancestor| ancestor.attribute("transform")) {
        let outer: Transform =
            text.parse().map_err(|_| ReadError::malformed(1, "a transform list", text))?;
        product = Some(product.map_or(outer, |inner| multiply(&outer, &inner)));
    }
    Ok(product)
}

fn multiply(outer: &Transform, inner: &Transform) -> Transform {
    Transform {
        a: outer.a * inner.a + outer.c * inner.b,
        b: outer.b * inner.a + outer.d * inner.b,
        c: outer.a * inner.c + outer.c * inner.d,
        d: outer.b * inner.c + outer.d * inner.d,
        e: outer.a * inner.e + outer.c * inner.f + outer.e,
        f: outer.b * inner.e + outer.d * inner.f + outer.f,
    }
}

#[cfg(test)]
mod tests;
