//! `delone check`: the judge, on any program's output.

mod filtration;

use std::path::Path;

use delone_check::{
    Complex, Options, Verdict, judge_conforming_doubles, judge_constrained, judge_delaunay,
    judge_regular,
};
use delone_formats::{Document, Format, Source, one, read_bytes, write};
use serde_json::json;

use crate::cli;
use crate::failure::Failure;
use crate::input;
use crate::progress::Busy;
use crate::result::{check_value, verdict_text};

pub(crate) fn check(arguments: &cli::Check) -> Result<(), Failure> {
    let busy = Busy::new(arguments.voice.quiet, "reading");
    let mut given = input::read(&arguments.input, None)?;
    input::take_weights(&mut given, arguments.weights.file.as_deref())?;
    busy.at("judging");
    let (name, verdict) = if arguments.kind == cli::Claim::Alpha {
        let verdict = filtration::judge(&arguments.output, &given, &Options::foreign())?;
        (arguments.output.display().to_string(), verdict)
    } else {
        let output = read_output(&arguments.output, &given)?;
        let verdict = if given.dimension == 3 {
            judge_space(arguments, &given, &output)?
        } else {
            judge_plane(arguments, &given, &output)?
        };
        (output.name, verdict)
    };
    drop(busy);
    if arguments.voice.json {
        let object = json!({
            "schema": "delone.check/1",
            "input": { "path": given.name, "sites": given.point_count(), "segments": given.segments.len() },
            "output": name,
            "check": check_value(&verdict),
        });
        println!("{object}");
    } else {
        print!("{}", verdict_text(&verdict));
    }
    if verdict.ok { Ok(()) } else { Err(Failure::Difference(None)) }
}

/// The output's document. A file of elements without nodes beside it takes the input's points.
pub(crate) fn read_output(path: &Path, given: &Document) -> Result<Document, Failure> {
    let name = path.to_string_lossy();
    let wants_nodes = matches!(Format::from_path(&name), Some(Format::Ele | Format::Edge));
    if !wants_nodes || path.with_extension("node").is_file() {
        return input::read(path, None);
    }
    let mut nodes = Vec::new();
    write(given, Format::Node, &mut nodes).map_err(Failure::input)?;
    let bytes = std::fs::read(path).map_err(|error| Failure::input(format!("{name}: {error}")))?;
    let source = Source { name: &name, bytes: &bytes, format: None, nodes: Some(&nodes) };
    one(read_bytes(&source).map_err(Failure::input)?, &name).map_err(Failure::input)
}

fn judge_plane(
    arguments: &cli::Check,
    given: &Document,
    output: &Document,
) -> Result<Verdict, Failure> {
    let mut points = given.points_2d().map_err(Failure::input)?.to_vec();
    let count = points.len();
    let drawn = output.points_2d().map_err(Failure::input)?;
    let names = if arguments.kind == cli::Claim::Conforming {
        with_steiner_points(&mut points, drawn)
    } else {
        names(&points, drawn, output)?
    };
    let (dimension, cells) = cells(lone(given), output, &names);
    let complex = Complex { points: &points, dimension, cells: &cells };
    let edges: Vec<[u32; 2]> =
        output.segments.iter().map(|ends| ends.map(|id| names[id as usize])).collect();
    Ok(match arguments.kind {
        cli::Claim::Conforming => {
            // Of a line, they are its cells.
            let flags = Some(&edges[..]).filter(|flags| dimension == Some(2) && !flags.is_empty());
            judge_conforming_doubles(&complex, count, &given.segments, flags, &options(arguments))
        }
        cli::Claim::Delaunay | cli::Claim::Alpha => judge_delaunay(&complex, &options(arguments)),
        cli::Claim::Regular => judge_regular(&complex, weights(given)?, &options(arguments)),
        cli::Claim::Cdt => {
            judge_constrained(&complex, &given.segments, &edges, &options(arguments))
        }
    })
}

fn judge_space(
    arguments: &cli::Check,
    given: &Document,
    output: &Document,
) -> Result<Verdict, Failure> {
    if let kind @ (cli::Claim::Cdt | cli::Claim::Conforming) = arguments.kind {
        let name = if kind == cli::Claim::Cdt { "cdt" } else { "conforming" };
        return Err(Failure::input(format!(
            "--as {name} is for the plane, and the input is in space"
        )));
    }
    let points = given.points_3d().map_err(Failure::input)?;
    let names = names(points, output.points_3d().map_err(Failure::input)?, output)?;
    let (dimension, cells) = cells(lone(given), output, &names);
    let complex = Complex { points, dimension, cells: &cells };
    Ok(match arguments.kind {
        cli::Claim::Regular => judge_regular(&complex, weights(given)?, &options(arguments)),
        _ => judge_delaunay(&complex, &options(arguments)),
    })
}

fn weights(given: &Document) -> Result<&[f64], Failure> {
    given.weights.as_deref().ok_or_else(|| {
        Failure::input(format!("{}: there are no weights: give --weights FILE", given.name))
    })
}

/// The one vertex there is if all points are equal: the first of them; with weights, the heaviest.
pub(crate) fn lone(given: &Document) -> Option<u32> {
    let weight = |i: u32| given.weights.as_ref().and_then(|w| w.get(i as usize)).copied();
    let points = (0u32..).take(given.point_count());
    points.reduce(|best, i| if weight(i) > weight(best) { i } else { best })
}

/// The cells of the output by input point: its simplices of the highest dimension that it has. Without any, it can only
/// be the triangulation of a single site, or of none.
pub(crate) fn cells(
    lone: Option<u32>,
    output: &Document,
    names: &[u32],
) -> (Option<usize>, Vec<u32>) {
    let named = |ids: &[u32]| ids.iter().map(|&id| names[id as usize]).collect::<Vec<u32>>();
    if !output.tets.is_empty() {
        (Some(3), named(output.tets.as_flattened()))
    } else if !output.triangles.is_empty() {
        (Some(2), named(output.triangles.as_flattened()))
    } else if !output.segments.is_empty() {
        (Some(1), named(output.segments.as_flattened()))
    } else {
        (lone.map(|_| 0), lone.into_iter().collect())
    }
}

fn options(arguments: &cli::Check) -> Options {
    if arguments.strict { Options::default() } else { Options::foreign() }
}

/// For each point of the output, the input point at the same position: the same index if that one is.
pub(crate) fn names<const D: usize>(
    given: &[[f64; D]],
    output: &[[f64; D]],
    document: &Document,
) -> Result<Vec<u32>, Failure> {
    let known = known(given, output);
    if let Some(names) = known.iter().copied().collect::<Option<Vec<u32>>>() {
        return Ok(names);
    }
    let strangers = (0..output.len()).filter(|&index| known[index].is_none());
    let strangers = strangers.map(|index| format!("  vertex {index} at {:?}", output[index]));
    let strangers: Vec<String> = strangers.collect();
    Err(Failure::Difference(Some(format!(
        "{}: {} vertices are no points of the input\n{}",
        document.name,
        strangers.len(),
        strangers.join("\n")
    ))))
}

/// The same; points of the output that are none of the input are put after these.
fn with_steiner_points(points: &mut Vec<[f64; 2]>, output: &[[f64; 2]]) -> Vec<u32> {
    let known = known(points, output);
    let mut next = (0u32..).skip(points.len());
    let steiner = known.iter().zip(output).filter(|(name, _)| name.is_none());
    points.extend(steiner.map(|(_, point)| point));
    known.iter().map(|name| name.or_else(|| next.next()).unwrap_or(u32::MAX)).collect()
}

/// For each point of the output, the input point at the same position, if there is one.
fn known<const D: usize>(given: &[[f64; D]], output: &[[f64; D]]) -> Vec<Option<u32>> {
    let key = |point: &[f64; D]| point.map(|c| (c + 0.0).to_bits());
    let mut sorted: Vec<([u64; D], u32)> = given.iter().map(key).zip(0u32..).collect();
    sorted.sort_unstable();
    let name = |(index, point): (u32, &[f64; D])| {
        let wanted = key(point);
        if given.get(index as usize).is_some_and(|same| key(same) == wanted) {
            return Some(index);
        }
        let place = sorted.partition_point(|(position, _)| *position < wanted);
        sorted.get(place).filter(|(position, _)| *position == wanted).map(|&(_, name)| name)
    };
    (0u32..).zip(output).map(name).collect()
}
