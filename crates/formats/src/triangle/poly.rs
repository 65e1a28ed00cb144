//! `.poly` and `.smesh`: points as in `.node` (or `0` of them: they are in the `.node` file beside), segments, holes, regions.
//!
//! In space (TetGen) facets stand in place of segments: a facet is one or more polygons and the holes in them. Its
//! polygons of two corners become segments, of one corner are dropped; which polygons shared a facet, facet holes and
//! facet markers are not kept, and noted. The holes part may be missing at the end of the file (noted).

use std::io::{self, Write};

use super::{Items, edge, header_of, node, nodes_beside, real};
use crate::document::{Document, Region};
use crate::error::ReadError;
use crate::text::{Line, index};
use crate::write::{Lost, shortest};

/// How facets in space are listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Facets {
    /// `.poly`: each a head, then its polygons and holes.
    Compound,
    /// `.smesh`: each one polygon on one line, with its marker.
    Simple,
}

pub(crate) fn read(text: &str, nodes: Option<&str>, facets: Facets) -> Result<Document, ReadError> {
    let mut items = Items::new(text);
    let header = items.next("`points dimension attributes markers`")?;
    let mut document = if header.fields().next() == Some("0") {
        header_of(&header, "`0 dimension attributes markers`", [0, 2, 0, 0])?;
        nodes_beside(nodes)?
    } else {
        node::read_points(&header, &mut items)?
    };
    match (document.dimension, facets) {
        (2, Facets::Compound) => edge::read_list(&mut items, &mut document, "segment")?,
        (_, Facets::Compound) => read_facets(&mut items, &mut document)?,
        (_, Facets::Simple) => read_simple_facets(&mut items, &mut document)?,
    }
    read_holes_and_regions(&mut items, &mut document)?;
    items.finish()?;
    Ok(document)
}

fn read_facets(items: &mut Items<'_>, document: &mut Document) -> Result<(), ReadError> {
    let (_, [facets, _markers]) = items.header("`facets markers`", [0, 0])?;
    let (mut compound, mut holes) = (0_usize, 0_usize);
    for _ in 0..facets {
        let header = items.next("the next facet")?;
        let fields: Vec<&str> = header.fields().take(2).collect();
        let counts = fields
            .iter()
            .map(|field| crate::text::count(field, header.number, "`polygons [holes] [marker]`"))
            .collect::<Result<Vec<usize>, _>>()?;
        let polygons = counts.first().copied().unwrap_or(0);
        compound += usize::from(polygons > 1);
        for _ in 0..polygons {
            read_polygon(items, document)?;
        }
        for _ in 0..counts.get(1).copied().unwrap_or(0) {
            items.next("the next facet hole")?;
            holes += 1;
        }
    }
    if compound + holes > 0 {
        document.note(format!(
            "{compound} facets of several polygons taken apart, {holes} facet holes dropped"
        ));
    }
    Ok(())
}

fn read_simple_facets(items: &mut Items<'_>, document: &mut Document) -> Result<(), ReadError> {
    let (_, [facets, markers]) = items.header("`facets markers`", [0, 0])?;
    for _ in 0..facets {
        read_polygon(items, document)?;
    }
    if markers > 0 && facets > 0 {
        document.note("facet markers dropped");
    }
    Ok(())
}

/// `corners c1 c2 ..`, over as many lines as it takes; what else is on the last line (a marker) is left.
fn read_polygon(items: &mut Items<'_>, document: &mut Document) -> Result<(), ReadError> {
    let (points, first) = (document.point_count(), usize::from(document.first_index == 1));
    let mut line: Line<'_> = items.next("the next polygon")?;
    let mut fields = line.fields();
    let corners =
        crate::text::count(fields.next().unwrap_or(""), line.number, "a number of corners")?;
    let mut polygon = Vec::new();
    while polygon.len() < corners {
        match fields.next() {
            Some(field) => polygon.push(index(field, line.number, first, points)?),
            None => {
                line = items.next("the polygon's next corner")?;
                fields = line.fields();
            }
        }
    }
    match polygon[..] {
        [] | [_] => document.note("a facet polygon of fewer than two corners dropped"),
        [a, b] => document.segments.push([a, b]),
        _ => document.push_face(polygon),
    }
    Ok(())
}

fn read_holes_and_regions(items: &mut Items<'_>, document: &mut Document) -> Result<(), ReadError> {
    let Some(header) = items.next_if_any() else {
        document.note("the file ends without its holes part");
        return Ok(());
    };
    let [holes] = header_of(&header, "a number of holes", [0])?;
    for _ in 0..holes {
        let (seed, _) = read_seed(items, document.dimension, 0..1, "the next hole")?;
        document.holes.extend(seed);
    }
    let Some(header) = items.next_if_any() else { return Ok(()) };
    let [regions] = header_of(&header, "a number of regions", [0])?;
    for _ in 0..regions {
        let (seed, rest) = read_seed(items, document.dimension, 1..3, "the next region")?;
        let attribute = rest.first().copied().unwrap_or(0.0);
        document.regions.push(Region { seed, attribute, size_max: rest.get(1).copied() });
    }
    Ok(())
}

/// `number x y [z] ..`: the point, and the reals after it, whose count must lie in `extra`.
fn read_seed(
    items: &mut Items<'_>,
    dimension: usize,
    extra: std::ops::Range<usize>,
    expected: &str,
) -> Result<(Vec<f64>, Vec<f64>), ReadError> {
    let line = items.next(expected)?;
    let reals = line
        .fields()
        .skip(1)
        .map(|field| real(field, line.number))
        .collect::<Result<Vec<f64>, _>>()?;
    if reals.len() < dimension || !extra.contains(&(reals.len() - dimension)) {
        return Err(ReadError::malformed(line.number, "a number and a point", line.text));
    }
    let (seed, rest) = reals.split_at(dimension);
    Ok((seed.to_vec(), rest.to_vec()))
}

pub(crate) fn write(document: &Document, out: &mut impl Write) -> io::Result<()> {
    node::write(document, out)?;
    let first = document.first_index;
    let shift = usize::from(first == 1);
    if document.dimension == 2 {
        let markers = u8::from(!document.segment_markers.is_empty());
        writeln!(out, "{} {markers}", document.segments.len())?;
        for (i, [a, b]) in document.segments.iter().enumerate() {
            write!(
                out,
                "{} {} {}",
                i + shift,
                u64::from(*a) + u64::from(first),
                u64::from(*b) + u64::from(first)
            )?;
            if let Some(marker) = document.segment_markers.get(i) {
                write!(out, " {marker}")?;
            }
            writeln!(out)?;
        }
    } else {
        write_facets(document, out)?;
    }
    let dimension = document.dimension.max(1);
    writeln!(out, "{}", document.holes.len() / dimension)?;
    for (i, hole) in document.holes.chunks_exact(dimension).enumerate() {
        write_seed(i + shift, hole, out)?;
        writeln!(out)?;
    }
    if !document.regions.is_empty() {
        writeln!(out, "{}", document.regions.len())?;
    }
    for (i, region) in document.regions.iter().enumerate() {
        write_seed(i + shift, &region.seed, out)?;
        write!(out, " {}", shortest(region.attribute))?;
        if let Some(size) = region.size_max {
            write!(out, " {}", shortest(size))?;
        }
        writeln!(out)?;
    }
    Ok(())
}

fn write_seed(number: usize, seed: &[f64], out: &mut impl Write) -> io::Result<()> {
    write!(out, "{number}")?;
    seed.iter().try_for_each(|&x| write!(out, " {}", shortest(x)))
}

fn write_facets(document: &Document, out: &mut impl Write) -> io::Result<()> {
    let segments = document.segments.iter().map(|s| &s[..]);
    let triangles = document.triangles.iter().map(|t| &t[..]);
    let polygons = document.polygons.iter().map(|p| &p[..]);
    let facets = document.segments.len() + document.triangles.len() + document.polygons.len();
    writeln!(out, "{facets} 0")?;
    for facet in segments.chain(triangles).chain(polygons) {
        writeln!(out, "1")?;
        write!(out, "{}", facet.len())?;
        for &v in facet {
            write!(out, " {}", u64::from(v) + u64::from(document.first_index))?;
        }
        writeln!(out)?;
    }
    Ok(())
}

pub(crate) fn lost(document: &Document, lost: &mut Lost) {
    if document.dimension == 2 {
        lost.if_any("triangles", document.triangles.len());
        lost.if_any("polygons", document.polygons.len());
    } else {
        lost.if_any("segment markers", document.segment_markers.len());
    }
    lost.if_any("tetrahedra", document.tets.len());
    lost.if_any("weights", document.weights.as_ref().map_or(0, Vec::len));
}
