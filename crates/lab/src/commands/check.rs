//! `delone check`: the judge, on any program's output.

mod filtration;

use std::path::Path;

use delone_check::{Complex, Options, Verdict, judge_constrained, judge_delaunay, judge_regular};
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
    let points = given.points_2d().map_err(Failure::input)?;
    let names = names(points, output.points_2d().map_err(Failure::input)?, output)?;
    let (dimension, cells) = cells(lone(given), output, &names);
    let complex = Complex { points, dimension, cells: &cells };
    let edges: Vec<[u32; 2]> =
        output.segments.iter().map(|ends| ends.map(|id| names[id as usize])).collect();
    Ok(match arguments.kind {
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
    if arguments.kind == cli::Claim::Cdt {
        return Err(Failure::input("--as cdt is for the plane, and the input is in space"));
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
    let key = |point: &[f64; D]| point.map(|c| (c + 0.0).to_bits());
    let mut sorted: Vec<([u64; D], u32)> = given.iter().map(key).zip(0u32..).collect();
    sorted.sort_unstable();
    let mut names = Vec::with_capacity(output.len());
    let mut strangers = Vec::new();
    for (index, point) in output.iter().enumerate() {
        let wanted = key(point);
        if given.get(index).is_some_and(|same| key(same) == wanted) {
            names.push(u32::try_from(index).map_err(Failure::input)?);
            continue;
        }
        let place = sorted.partition_point(|(position, _)| *position < wanted);
        match sorted.get(place) {
            Some(&(position, name)) if position == wanted => names.push(name),
            _ => strangers.push(format!("  vertex {index} at {point:?}")),
        }
    }
    if strangers.is_empty() {
        return Ok(names);
    }
    let count = strangers.len();
    Err(Failure::Difference(Some(format!(
        "{}: {count} vertices are no points of the input\n{}",
        document.name,
        strangers.join("\n")
    ))))
}
