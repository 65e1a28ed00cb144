//! Polygons as counted runs of points (`.dat` and `.poly` of CGAL's polygon packages); coordinates may be `p/q`.
//!
//! Three grammars share the ending and are told apart by which consumes the file exactly, tried in this order. A
//! count must lead its line.
//!
//! | grammar | meaning |
//! |---|---|
//! | `k`, then k runs | k rings (or k open lines) |
//! | (run, `h`, h runs) repeated, the last `h` optional | polygons with holes |
//! | runs | rings |
//!
//! where a run is `n` and n points.

use super::segments::{note_rounded, point};
use crate::document::Document;
use crate::error::ReadError;
use crate::shapes::Shapes;
use crate::text::{Tokens, is_count};

/// Whether a run's last point is joined to its first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Runs {
    Closed,
    Open,
}

type Grammar = fn(&mut Tokens<'_>, &mut Reading) -> Result<(), ReadError>;

#[derive(Debug, Default)]
struct Reading {
    runs: Vec<Vec<[f64; 2]>>,
    rounded: usize,
}

pub(crate) fn read(text: &str, runs: Runs) -> Result<Document, ReadError> {
    let start = Tokens::new(text, Some('#'));
    let grammars: [Grammar; 3] = [counted_runs, polygons_with_holes, bare_runs];
    let mut furthest: Option<(usize, ReadError)> = None;
    for grammar in grammars {
        let mut tokens = start.clone();
        let mut reading = Reading::default();
        let outcome =
            grammar(&mut tokens, &mut reading).and_then(|()| tokens.finish("the end of the file"));
        match outcome {
            Ok(()) => return finish(reading, runs),
            Err(error) => {
                if furthest.as_ref().is_none_or(|(reached, _)| tokens.cursor > *reached) {
                    furthest = Some((tokens.cursor, error));
                }
            }
        }
    }
    Err(furthest.map_or_else(|| ReadError::truncated(1, "a number of points"), |(_, error)| error))
}

fn finish(reading: Reading, runs: Runs) -> Result<Document, ReadError> {
    let mut shapes = Shapes::new(2);
    for run in &reading.runs {
        match runs {
            Runs::Closed => shapes.ring(run)?,
            Runs::Open => shapes.line(run)?,
        }
    }
    note_rounded(&mut shapes, reading.rounded);
    Ok(shapes.finish())
}

fn counted_runs(tokens: &mut Tokens<'_>, reading: &mut Reading) -> Result<(), ReadError> {
    let runs = leading_count(tokens)?;
    for _ in 0..runs {
        run(tokens, reading)?;
    }
    Ok(())
}

fn polygons_with_holes(tokens: &mut Tokens<'_>, reading: &mut Reading) -> Result<(), ReadError> {
    while !tokens.is_done() {
        run(tokens, reading)?;
        if !tokens.is_done() {
            let holes = leading_count(tokens)?;
            for _ in 0..holes {
                run(tokens, reading)?;
            }
        }
    }
    Ok(())
}

fn bare_runs(tokens: &mut Tokens<'_>, reading: &mut Reading) -> Result<(), ReadError> {
    while !tokens.is_done() {
        run(tokens, reading)?;
    }
    Ok(())
}

fn run(tokens: &mut Tokens<'_>, reading: &mut Reading) -> Result<(), ReadError> {
    let count = leading_count(tokens)?;
    let mut run = Vec::new();
    for _ in 0..count {
        run.push(point(tokens, &mut reading.rounded)?);
    }
    reading.runs.push(run);
    Ok(())
}

fn leading_count(tokens: &mut Tokens<'_>) -> Result<usize, ReadError> {
    let token = tokens.next("a number of points or rings")?;
    if !token.leads || !is_count(token.text) {
        let want = "a number of points or rings at the start of a line";
        return Err(ReadError::malformed(token.line, want, token.text));
    }
    crate::text::count(token.text, token.line, "a number of points or rings")
}
