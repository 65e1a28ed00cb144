//! The list of all workloads, and generation by name.

use crate::{Input, Points, Rng};
use std::fmt;
use std::sync::LazyLock;

mod points2d;
mod points3d;
mod pslg;

/// More sites than this are not generated: `n` is cut down to it.
pub const SITES_MAX: usize = 1 << 28;

/// What a workload makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Sites of the plane.
    Points2d,
    /// Sites of space.
    Points3d,
    /// Sites of the plane, and segments.
    Pslg,
}

impl Kind {
    /// `points2d`, `points3d` or `pslg`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Points2d => "points2d",
            Self::Points3d => "points3d",
            Self::Pslg => "pslg",
        }
    }
}

/// The worst way in which two segments of a workload may meet; each allows those before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Meets {
    /// Two segments share at most one end; no site lies inside a segment; no two sites are equal.
    AtEnds,
    /// A site may lie inside a segment.
    InsideOne,
    /// Segments may overlap, contain or repeat each other.
    Along,
    /// Segments cross: not a PSLG until noded, and to be refused by what does not node.
    Crossing,
}

/// One family of inputs.
#[derive(Debug)]
pub struct Workload {
    /// Its name, in kebab case and unique.
    pub name: &'static str,
    /// What it is and what it attacks, in a line.
    pub about: &'static str,
    /// How many sites it makes when asked for n.
    pub rounds: &'static str,
    /// How its segments may meet.
    pub meets: Meets,
    make: Make,
}

#[derive(Debug)]
enum Make {
    Plane(fn(usize, &mut Rng) -> Vec<[f64; 2]>),
    Space(fn(usize, &mut Rng) -> Vec<[f64; 3]>),
    Pslg(fn(usize, &mut Rng) -> Input),
}

impl Workload {
    /// What it makes.
    #[must_use]
    pub fn kind(&self) -> Kind {
        match self.make {
            Make::Plane(_) => Kind::Points2d,
            Make::Space(_) => Kind::Points3d,
            Make::Pslg(_) => Kind::Pslg,
        }
    }

    /// Whether its segments cross.
    #[must_use]
    pub fn crosses(&self) -> bool {
        self.meets == Meets::Crossing
    }

    /// The input for about `n` sites.
    #[must_use]
    pub fn generate(&self, n: usize, seed: u64) -> Input {
        let (n, mut rng) = (n.min(SITES_MAX), Rng::named(self.name, seed));
        let points = match self.make {
            Make::Plane(make) => Points::Plane(make(n, &mut rng)),
            Make::Space(make) => Points::Space(make(n, &mut rng)),
            Make::Pslg(make) => return make(n, &mut rng),
        };
        Input { points, segments: Vec::new() }
    }
}

const EXACTLY: &str = "n";

/// A row of sites in the plane.
const fn plane(
    name: &'static str,
    make: fn(usize, &mut Rng) -> Vec<[f64; 2]>,
    about: &'static str,
) -> Workload {
    Workload { name, about, rounds: EXACTLY, meets: Meets::AtEnds, make: Make::Plane(make) }
}

/// A row of sites in space.
const fn space(
    name: &'static str,
    make: fn(usize, &mut Rng) -> Vec<[f64; 3]>,
    about: &'static str,
) -> Workload {
    Workload { name, about, rounds: EXACTLY, meets: Meets::AtEnds, make: Make::Space(make) }
}

/// A row of sites and segments.
const fn graph(
    name: &'static str,
    make: fn(usize, &mut Rng) -> Input,
    about: &'static str,
) -> Workload {
    Workload { name, about, rounds: EXACTLY, meets: Meets::AtEnds, make: Make::Pslg(make) }
}

impl Workload {
    const fn rounding(mut self, rounds: &'static str) -> Self {
        self.rounds = rounds;
        self
    }

    const fn meeting(mut self, meets: Meets) -> Self {
        self.meets = meets;
        self
    }
}

/// All workloads: point sets of the plane, of space, then PSLGs.
#[must_use]
pub fn all() -> &'static [Workload] {
    static ALL: LazyLock<Vec<Workload>> = LazyLock::new(|| {
        points2d::ROWS.into_iter().chain(points3d::ROWS).chain(pslg::ROWS).collect()
    });
    &ALL
}

/// The workload called `name`.
///
/// # Errors
/// If there is none.
pub fn find(name: &str) -> Result<&'static Workload, UnknownWorkload> {
    let unknown = || {
        let nearest = all().iter().min_by_key(|w| edits(w.name, name));
        UnknownWorkload { name: name.to_owned(), nearest: nearest.map_or("", |w| w.name) }
    };
    all().iter().find(|w| w.name == name).ok_or_else(unknown)
}

/// The input of the workload called `name`, for about `n` sites: a pure function of the three.
///
/// # Errors
/// If there is no such workload.
pub fn generate(name: &str, n: usize, seed: u64) -> Result<Input, UnknownWorkload> {
    find(name).map(|workload| workload.generate(n, seed))
}

/// No workload has this name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownWorkload {
    /// What was asked for.
    pub name: String,
    /// The name that is the fewest edits away.
    pub nearest: &'static str,
}

impl fmt::Display for UnknownWorkload {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no workload is called `{}`; did you mean `{}`?", self.name, self.nearest)
    }
}

impl std::error::Error for UnknownWorkload {}

/// Levenshtein's distance, one row at a time.
fn edits(from: &str, to: &str) -> usize {
    let to: Vec<char> = to.chars().collect();
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (i, c) in from.chars().enumerate() {
        let mut diagonal = i;
        row[0] = i + 1;
        for (j, &d) in to.iter().enumerate() {
            let substitute = diagonal + usize::from(c != d);
            diagonal = row[j + 1];
            row[j + 1] = substitute.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[to.len()]
}

#[cfg(test)]
mod tests;
