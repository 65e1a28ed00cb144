//! `delone classroom`: maps of the orientation of three points, one of them moving over a square of ULPs.

use delone_draw::{Raster, Rasters};
use delone_predicates::{Adaptive, Kernel, Naive, Sign};
use delone_workloads::{CLASSROOM, Classroom};

use crate::cli;
use crate::failure::Failure;
use crate::output;

/// Points in a row of a square.
const SIDE: usize = 256;

pub(crate) fn classroom(arguments: &cli::Classroom) -> Result<(), Failure> {
    output::check_paths(arguments.output.as_deref())?;
    let svg = maps();
    match &arguments.output {
        Some(path) => output::text(path, &svg),
        None => output::print_bytes(svg.as_bytes()),
    }
}

/// For each line, the map of doubles beside the exact one.
fn maps() -> String {
    let rows = CLASSROOM.iter().map(|case| {
        let naive = signs(case, |points| Naive::new(points).orient(&[0usize, 1, 2]));
        let exact = signs(case, |points| Adaptive::dynamic(points).orient(&[0usize, 1, 2]));
        let wrong = naive.iter().zip(&exact).filter(|(naive, exact)| naive != exact).count();
        let [q, r] = case.far;
        let line = format!("({}, {}), ({}, {})", q[0], q[1], r[0], r[1]);
        let share = format!("plain doubles: {wrong} of {} wrong", naive.len());
        vec![raster(share, naive), raster(format!("exact, line {line}"), exact)]
    });
    Rasters {
        title: "The orientation of two points and a third that moves by ULPs".into(),
        classes: [("right turn", "#c0392b"), ("in line", "#f2c14e"), ("left turn", "#2e6fb0")]
            .map(|(name, colour)| (name.into(), colour.into()))
            .to_vec(),
        rows: rows.collect(),
    }
    .svg()
}

fn raster(caption: String, signs: Vec<Sign>) -> Raster {
    let class = |sign| match sign {
        Sign::Negative => 0,
        Sign::Zero => 1,
        Sign::Positive => 2,
    };
    Raster { caption, width: SIDE, classes: signs.into_iter().map(class).collect() }
}

/// The moving point is the last, to which differences are taken, as the paper does.
fn signs(case: &Classroom, orient: impl Fn([[f64; 2]; 3]) -> Sign) -> Vec<Sign> {
    let [q, r] = case.far;
    case.square(SIDE).map(|p| orient([q, r, p])).collect()
}
