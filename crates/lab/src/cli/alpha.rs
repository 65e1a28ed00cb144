//! What can be asked of `delone alpha`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::{Piped, Voice, Weights};

/// Exactly one of the conventions for the parameter, or one of the lists.
#[derive(Args)]
#[group(id = "what", required = true, multiple = false)]
pub(crate) struct Asked {
    /// The complex of balls of this radius
    #[arg(long, value_name = "R")]
    pub(crate) radius: Option<f64>,
    /// The complex of balls of this squared radius (as in CGAL and Gudhi); may be negative with weights
    #[arg(long, value_name = "A", allow_negative_numbers = true)]
    pub(crate) squared: Option<f64>,
    /// The complex of balls of one over this radius
    #[arg(long, value_name = "Q")]
    pub(crate) inverse: Option<f64>,
    /// The complex at this fraction, 0 to 1, of the different values in order
    #[arg(long, value_name = "T")]
    pub(crate) rank: Option<f64>,
    /// The complex of balls whose radius is this times the longer side of the bounding box
    #[arg(long, value_name = "T")]
    pub(crate) unit: Option<f64>,
    /// The first complex with a property: all-points, one-region, components=K, betti=B0,B1
    #[arg(long, value_name = "PROPERTY", value_parser = critical)]
    pub(crate) critical: Option<delone_alpha::Critical>,
    /// List all simplices in order, with their squared radii
    #[arg(long)]
    pub(crate) filtration: bool,
    /// List numbers of simplices, Betti numbers and, in the plane, area and perimeter, at every value
    #[arg(long)]
    pub(crate) signature: bool,
    /// List the classes of persistent homology: dimension, squared radii of birth and death
    #[arg(long)]
    pub(crate) persistence: bool,
}

#[derive(Args)]
pub(crate) struct Alpha {
    #[command(flatten)]
    pub(crate) source: Piped,
    #[command(flatten)]
    pub(crate) weights: Weights,
    #[command(flatten)]
    pub(crate) asked: Asked,
    /// What a complex holds besides its cells and their faces
    #[arg(long, value_enum, default_value_t = Mode::General)]
    pub(crate) mode: Mode,
    /// In lists, write squared radii as fractions
    #[arg(long)]
    pub(crate) exact: bool,
    /// Write the complex, in the format of the ending; may be repeated
    #[arg(short, long = "output", value_name = "OUT")]
    pub(crate) outputs: Vec<PathBuf>,
    /// Draw the alpha hull too: the arcs of the disks that no site is in; in the plane, without weights. For conventions that name no
    /// radius, that of the last simplex
    #[arg(long, requires = "svg")]
    pub(crate) hull: bool,
    /// Draw the complex; of lists, Betti numbers as curves, or persistence as bars and diagram
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
    /// Write a page with a slider over all complexes, Betti numbers and bars, for points of the plane
    #[arg(long, value_name = "FILE")]
    pub(crate) html: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) voice: Voice,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Mode {
    /// Every simplex of the complex
    General,
    /// Cells and their faces alone
    Regularized,
}

/// A property by its name.
fn critical(text: &str) -> Result<delone_alpha::Critical, String> {
    use delone_alpha::Critical;
    let number = |text: &str| text.parse().map_err(|_| format!("{text} is no number"));
    match text.split_once('=') {
        None if text == "all-points" => Ok(Critical::AllPoints),
        None if text == "one-region" => Ok(Critical::OneRegion),
        Some(("components", most)) => Ok(Critical::Components(number(most)?)),
        Some(("betti", numbers)) => {
            let pair = numbers.split_once(',').ok_or("betti takes two numbers: betti=7,1")?;
            Ok(Critical::Betti(number(pair.0)?, number(pair.1)?))
        }
        _ => Err("give all-points, one-region, components=K or betti=B0,B1".to_owned()),
    }
}
