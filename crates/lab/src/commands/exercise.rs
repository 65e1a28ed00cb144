//! The pieces of a class exercise, to be joined by pipes: `delone text`, `delone svg2lar`, `delone sample`; and then `delone alpha`.

use delone_formats::{Document, Format};
use delone_workloads::{Align, Layout, outlines, strokes};

use crate::failure::Failure;
use crate::sampling::Inside;
use crate::subject::Subject;
use crate::{cli, engine, fill, input, output};

pub(crate) fn text(arguments: &cli::Text) -> Result<(), Failure> {
    if !arguments.angle.is_finite() {
        return Err(Failure::input(format!("--angle is {}", arguments.angle)));
    }
    let layout = Layout {
        align: match arguments.align {
            cli::Align::Left => Align::Left,
            cli::Align::Centre => Align::Centre,
            cli::Align::Right => Align::Right,
        },
        angle: arguments.angle,
        spacing: arguments.spacing,
    };
    let draw = if arguments.strokes { strokes } else { outlines };
    let svg = draw(&arguments.text, &layout).map_err(Failure::input)?;
    output::print_bytes(svg.as_bytes())
}

pub(crate) fn svg_to_lar(arguments: &cli::SvgToLar) -> Result<(), Failure> {
    let format = arguments.source.format.as_deref().or(Some("svg"));
    let mut document = input::read(&arguments.source.input, format)?;
    let exponent = normalise(&mut document.points);
    if !arguments.quiet {
        document.notes.iter().for_each(|note| eprintln!("note: {note}"));
        eprintln!(
            "note: x became x / 2^{exponent}, y became -y / 2^{exponent}: exactly, and so to be undone"
        );
    }
    output::print(&document, Format::Lar)
}

/// Turns y up and divides by the power of two that brings the longer side between a half and one: no bit is lost, unless
/// numbers underflow. The exponent of that power.
fn normalise(points: &mut [f64]) -> i32 {
    let side = |axis: usize| {
        let values = points.iter().skip(axis).step_by(2);
        let (low, high) = values
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &x| (low.min(x), high.max(x)));
        high - low
    };
    let longer = side(0).max(side(1));
    let mut exponent = 0;
    if longer > 0.0 && longer.is_finite() {
        while longer * 0.5f64.powi(exponent) > 1.0 {
            exponent += 1; // at most 1024 times
        }
        while longer * 0.5f64.powi(exponent) <= 0.5 && exponent > -1000 {
            exponent -= 1;
        }
    }
    for point in points.as_chunks_mut::<2>().0 {
        *point = [point[0] * 0.5f64.powi(exponent), -point[1] * 0.5f64.powi(exponent) + 0.0];
    }
    exponent
}

pub(crate) fn sample(arguments: &cli::Sample) -> Result<(), Failure> {
    let document = input::read(&arguments.source.input, arguments.source.format.as_deref())?;
    if document.dimension != 2 {
        return Err(Failure::input("samples are taken in the plane, and the input is in space"));
    }
    let subject = Subject::crossed(document)?;
    let options = delone_delaunay::Options::default();
    let name = engine::choose(&subject, None)?;
    let triangulation = engine::run(&subject, name, &options, None).triangulation;
    let domain = fill::domain(&triangulation, &subject, cli::Fill::EvenOdd)?;
    let mut model = triangulation.document(&subject);
    triangulation.keep_inside(&domain, &mut model);
    let inside = Inside::new(&model)
        .ok_or_else(|| Failure::input("nothing is inside: the segments enclose no area"))?;
    let points = inside.sample(arguments.method, arguments.n, arguments.seed);
    let sampled = Document { points: points.as_flattened().to_vec(), ..Document::new(2) };
    output::print(&sampled, Format::Node)
}
