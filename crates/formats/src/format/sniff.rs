//! Telling formats apart by what is in them.

use super::{Format, plain_name};
use crate::text::{Line, Tokens, decode, is_count, lines, parse_number};
use crate::{npy, wkt};

pub(super) fn by_content(path: &str, bytes: &[u8]) -> Option<Format> {
    if bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r\n") {
        return Some(Format::Ply);
    }
    if bytes.starts_with(npy::MAGIC) {
        return Some(Format::Npy);
    }
    let text = decode(bytes);
    let first = lines(&text, Some('#')).next()?;
    match first.text.chars().next() {
        Some('{' | '[') => return Some(Format::Json),
        Some('<') => return Some(if text.contains("<svg") { Format::Svg } else { Format::JtsXml }),
        Some('>') => return Some(Format::Gshhg),
        _ => {}
    }
    let leader = first.text.split_whitespace().next().unwrap_or("");
    if leader.starts_with("CAPTION") {
        Some(Format::Clipper)
    } else if leader.ends_with("OFF") {
        Some(Format::Off)
    } else if leader == "v" {
        Some(Format::Obj)
    } else if matches!(leader, "p" | "s") {
        Some(Format::Cin)
    } else if wkt::looks_like(first.text) && !first.text.contains('|') {
        Some(Format::Wkt)
    } else if is_wkt_table(&first) {
        Some(Format::WktTable)
    } else if parse_number(first.fields().next().unwrap_or("")).is_some() || leader.contains('/') {
        numeric(path, &text, &first)
    } else {
        by_names(&text, &first)
    }
}

/// A first line that begins with a name: Manifold's header, or a table's.
fn by_names(text: &str, first: &Line<'_>) -> Option<Format> {
    let fields: Vec<&str> = first.fields().collect();
    let numbers = fields.iter().skip(1).filter(|field| parse_number(field).is_some()).count();
    if fields.len() == 4 && numbers == 3 {
        return Some(Format::Manifold);
    }
    let names = fields.iter().filter(|field| matches!(**field, "x" | "X" | "y" | "Y")).count();
    if names == 2 {
        return Some(Format::Csv);
    }
    let mut keywords =
        lines(text, Some('#')).filter_map(|line| line.text.split_whitespace().next());
    keywords.any(|word| word == "v").then_some(Format::Obj)
}

fn is_wkt_table(first: &Line<'_>) -> bool {
    let mut fields = first.text.split('|');
    fields.any(|field| {
        wkt::looks_like(field.trim_start_matches(|c: char| c.is_ascii_digit() || c == ' '))
    })
}

/// Files of numbers, told apart by how many there must be.
fn numeric(path: &str, text: &str, first: &Line<'_>) -> Option<Format> {
    let name = plain_name(path);
    let tokens = Tokens::new(text, Some('#'));
    let head: Vec<&str> = first.fields().collect();
    let whole = head.iter().all(|field| is_count(field));
    let number = |i: usize| head.get(i).and_then(|field| field.parse::<usize>().ok());
    let total = tokens.len();
    match head.len() {
        4 if whole && is_numbered_nodes(text, &head) => {
            return Some(node_or_poly(text, number(0)?));
        }
        3 if whole && is_detria(text) => return Some(Format::Detria),
        2 if whole => {
            if number(0) == Some(0) && number(1)?.checked_mul(4)?.checked_add(2)? == total {
                return Some(Format::Boost);
            }
            let expected = number(0)?.checked_add(number(1)?)?.checked_mul(2)?.checked_add(2)?;
            if expected == total && !name.ends_with(".dat") {
                return Some(Format::VertexEdge);
            }
        }
        1 if whole => {
            let n = number(0)?;
            let second = lines(text, Some('#')).nth(1).map(|line| line.fields().count());
            if second == Some(4) {
                return Some(Format::SegmentList);
            }
            if name.ends_with(".txt") {
                return Some(if is_list_of_three(text, n, total) {
                    Format::Xyz
                } else {
                    Format::Boost
                });
            }
            if name.contains("point")
                && n.checked_mul(2).and_then(|m| m.checked_add(1)) == Some(total)
            {
                return Some(Format::Xyz);
            }
            return Some(if path.contains("polyline") {
                Format::PolylineList
            } else {
                Format::RingList
            });
        }
        _ => {}
    }
    if name.ends_with(".dat") {
        // `4 0 0 3 0 ..`: a count and its run on one line.
        let run = number(0).and_then(|n| n.checked_mul(2)).and_then(|n| n.checked_add(1));
        return Some(if run == Some(head.len()) { Format::RingList } else { Format::P2t });
    }
    Some(Format::Xyz)
}

/// `points dimension attributes markers`, then lines that begin with their own number and have as many fields as that says.
fn is_numbered_nodes(text: &str, head: &[&str]) -> bool {
    let parsed: Vec<usize> = head.iter().filter_map(|field| field.parse().ok()).collect();
    let &[points, dimension @ (2 | 3), attributes, markers @ (0 | 1)] = parsed.as_slice() else {
        return false;
    };
    let width = attributes.checked_add(1 + dimension + markers);
    let mut rows = lines(text, Some('#')).skip(1).take(points);
    let first = rows.clone().next().and_then(|row| row.fields().next()?.parse::<usize>().ok());
    let Some(first @ (0 | 1)) = first else { return points == 0 };
    (first..).zip(&mut rows).all(|(number, row)| {
        let mut fields = row.fields();
        fields.next().and_then(|field| field.parse().ok()) == Some(number)
            && Some(fields.count() + 1) == width
    })
}

/// Whether anything comes after the points.
fn node_or_poly(text: &str, points: usize) -> Format {
    let after = lines(text, Some('#')).nth(points.saturating_add(1));
    if after.is_some() { Format::Poly } else { Format::Node }
}

fn is_list_of_three(text: &str, points: usize, total: usize) -> bool {
    let second = lines(text, Some('#')).nth(1).map(|line| line.fields().count());
    points.checked_mul(3).and_then(|m| m.checked_add(1)) == Some(total) && second == Some(3)
}

/// `npoints npolylines nedges`, then exactly as many numbers as that says.
fn is_detria(text: &str) -> bool {
    let mut tokens = Tokens::new(text, None);
    let total = tokens.len();
    let (Ok(points), Ok(polylines), Ok(edges)) =
        (tokens.count(""), tokens.count(""), tokens.count(""))
    else {
        return false;
    };
    let mut expected = Some(3_usize);
    let mut add = |n: Option<usize>| expected = expected.and_then(|sum| sum.checked_add(n?));
    add(polylines.checked_mul(2));
    add(points.checked_mul(2));
    add(edges.checked_mul(2));
    for _ in 0..polylines {
        match tokens.count("") {
            Ok(size) => add(Some(size)),
            Err(_) => return false,
        }
    }
    expected == Some(total)
}

/// Not a counted run under the same ending: the header has more than one number.
pub(super) fn is_triangle_poly(bytes: &[u8]) -> bool {
    let text = decode(bytes);
    lines(&text, Some('#')).next().is_none_or(|line| line.fields().nth(1).is_some())
}
