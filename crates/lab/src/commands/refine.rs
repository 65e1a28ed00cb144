//! `delone refine`: read, validate, refine what is inside, judge, write, tell.

use std::path::Path;

use delone_cdt::Fill;
use delone_conforming::{
    Centre, Encroachment, Gap, Limits, Reason, RefineOptions, Refined, SizeField, narrowest_gap,
    refine as refined,
};
use serde::Serialize;
use serde_json::{Map, Value, json};

use super::adding::{Adding, Own};
use crate::cli;
use crate::failure::Failure;
use crate::subject::refusal;
use crate::{fill, steiner};

pub(crate) fn refine(arguments: &cli::Refine) -> Result<(), Failure> {
    check_bounds(arguments)?;
    let field = arguments.size.as_deref().map(Field::read).transpose()?;
    let size = field.as_ref().map(|field| |place: [f64; 2]| field.at(place));
    let size = size.as_ref().map(|size| size as &dyn Fn([f64; 2]) -> f64);
    let mut adding = Adding::begin(&arguments.adding, arguments.method.name())?;
    let options = options(arguments, adding.vertices_max(), size);
    if arguments.fill == cli::Fill::None {
        adding.subject.take_hull()?;
    }
    let rule = fill::rule(arguments.fill, &adding.subject);
    let refined = adding
        .build(|subject, watch| refined(steiner::graph(subject), &rule, &options, watch))
        .map_err(|error| refusal(&adding.subject.document, &error.to_string()))?;
    let (subject, conforming) = (&adding.subject, refined.triangulation());
    let pslg = adding.pslg();
    let result = steiner::Result { subject, pslg, conforming, inside: Some(&refined) };
    let mut keys = keys(&refined, arguments.adding.report.voice.json);
    let gap = reason_to_stop(&result, &refined, &rule, &options);
    if let Some(gap) = &gap {
        keys.insert("gap".to_owned(), json!(gap));
    }
    let own = Own { schema: "delone.refine/1", keys };
    let end =
        adding.end(&result, own, || result.verdict_on_angles(&refined, options.cosine_square()));
    end.map_err(|failure| match (failure, gap) {
        (Failure::Limit(text), Some(gap)) => Failure::Limit(format!("{text}; {gap}")),
        (failure, _) => failure,
    })?;
    match refined.left_alone_for(Reason::Unreachable) {
        0 => Ok(()),
        count => Err(Failure::Limit(format!(
            "{}: {count} triangles ask for points beyond the hull, where no segment is to be split; the result is valid, and keeps the bounds elsewhere",
            subject.name()
        ))),
    }
}

/// Why no limit of this size will do: a narrow gap.
#[derive(Serialize)]
struct Reasoned {
    /// Input segments.
    segments: [u32; 2],
    length: f64,
    width: f64,
    triangles_min: f64,
}

impl std::fmt::Display for Reasoned {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { segments: [a, b], length, width, triangles_min } = self;
        write!(
            f,
            "segments {a} and {b} run along each other for {length:.3e}, at most {width:.3e} apart: without smaller angles that takes {triangles_min:.1e} \
             triangles or more, whoever makes them"
        )
    }
}

/// What a limit has stopped, if it asks for more triangles than there are.
fn reason_to_stop(
    result: &steiner::Result<'_>,
    refined: &Refined,
    rule: &Fill,
    options: &RefineOptions<'_>,
) -> Option<Reasoned> {
    if refined.is_complete() {
        return None;
    }
    let gap = narrowest_gap(result.pslg, rule, options.angle_deg_min).ok()??;
    let first = result.first_segments();
    let Gap { subsegments, length, width, triangles_min } = gap;
    let segments = subsegments.map(|s| first[s as usize]);
    let is_more = triangles_min > refined.cells().count() as f64;
    is_more.then_some(Reasoned { segments, length, width, triangles_min })
}

fn options<'a>(
    arguments: &cli::Refine,
    vertices_max: usize,
    size: Option<SizeField<'a>>,
) -> RefineOptions<'a> {
    RefineOptions {
        centre: match arguments.method {
            cli::Refinement::OffCentre => Centre::OffCentre,
            cli::Refinement::Chew | cli::Refinement::Ruppert => Centre::Circumcentre,
        },
        encroachment: match arguments.method {
            cli::Refinement::OffCentre | cli::Refinement::Chew => Encroachment::Lens,
            cli::Refinement::Ruppert => Encroachment::Disk,
        },
        angle_deg_min: arguments.angle_min,
        area_max: arguments.area_max.unwrap_or(f64::INFINITY),
        size,
        limits: Limits { vertices_max },
    }
}

/// Angles, and what is left alone: each triangle by its vertices, and why.
fn keys(refined: &Refined, all: bool) -> Map<String, Value> {
    let mut keys = Map::new();
    keys.insert("cells_inside".to_owned(), json!(refined.cells().count()));
    keys.insert("angle_deg_min".to_owned(), json!(refined.angle_deg_min()));
    keys.insert("angle_deg_min_elsewhere".to_owned(), json!(refined.angle_deg_min_elsewhere()));
    let mesh = refined.triangulation().mesh();
    let left = refined.left_alone().iter().map(|left| {
        let corners: Vec<usize> = mesh.corners(left.cell).iter().map(|v| v.index()).collect();
        let reason = match left.reason {
            Reason::InputAngle => "input angle",
            Reason::Unreachable => "beyond the hull",
            Reason::Limit => "limit",
        };
        json!({ "vertices": corners, "reason": reason })
    });
    let left: Vec<Value> = left.collect();
    let told = if all { json!(left) } else { json!(left.len()) };
    keys.insert("left_alone".to_owned(), told);
    keys
}

fn check_bounds(arguments: &cli::Refine) -> Result<(), Failure> {
    let angle = arguments.angle_min;
    if !(0.0..60.0).contains(&angle) {
        return Err(Failure::input(format!("--angle-min {angle}: give 0 to less than 60 degrees")));
    }
    match arguments.area_max {
        Some(area) if area.is_nan() || area <= 0.0 => {
            Err(Failure::input(format!("--area-max {area}: give a number over 0")))
        }
        _ => Ok(()),
    }
}

/// Sizes by place.
enum Field {
    One(f64),
    /// Places and their sizes.
    Places(Vec<[f64; 3]>),
}

impl Field {
    /// From a number, or a file of lines `x y size`.
    fn read(word: &str) -> Result<Self, Failure> {
        let wrong = |what: &str| Failure::input(format!("--size {word}: {what}"));
        let sound = |size: &f64| size.is_finite() && *size > 0.0;
        if let Ok(size) = word.parse::<f64>() {
            let size = Some(size).filter(sound);
            return size.map(Self::One).ok_or_else(|| wrong("give a number over 0"));
        }
        let text = std::fs::read_to_string(Path::new(word))
            .map_err(|error| wrong(&format!("no number, and no file: {error}")))?;
        let mut places = Vec::new();
        for (number, line) in (1..).zip(text.lines()) {
            let line = line.split('#').next().unwrap_or("");
            let words = line.split(|c: char| c == ',' || c.is_whitespace());
            let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
            if words.is_empty() {
                continue;
            }
            let numbers: Vec<f64> = words.iter().filter_map(|word| word.parse().ok()).collect();
            match numbers[..] {
                [x, y, size] if words.len() == 3 && (x + y).is_finite() && sound(&size) => {
                    places.push([x, y, size]);
                }
                _ => return Err(wrong(&format!("line {number}: give x, y and a size over 0"))),
            }
        }
        if places.is_empty() { Err(wrong("no places")) } else { Ok(Self::Places(places)) }
    }

    /// The least over all places of the size there and the distance to it.
    fn at(&self, [x, y]: [f64; 2]) -> f64 {
        match self {
            Self::One(size) => *size,
            Self::Places(places) => {
                let sizes = places.iter().map(|&[px, py, size]| size + (px - x).hypot(py - y));
                sizes.fold(f64::INFINITY, f64::min)
            }
        }
    }
}
