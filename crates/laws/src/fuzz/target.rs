//! What can be fuzzed: a generator, and the laws to try.

use delone::workloads::{self, Points, Rng};

use super::attempt::{Broken, attempt};
use super::extra;
use crate::case::Case;
use crate::choices::Choices;
use crate::generate;
use crate::laws::{Law, constrained_laws, delaunay_laws, octree_laws, quadtree_laws};
use crate::shrink::{Effort, shrink};

/// A case of either dimension.
#[derive(Clone, Debug, PartialEq)]
pub enum Input {
    /// In the plane.
    Plane(Case<2>),
    /// In space.
    Space(Case<3>),
}

/// Evaluates `$answer` with the case of either dimension, named `$case`.
macro_rules! with_case {
    ($input:expr, $case:ident => $answer:expr) => {
        match $input {
            Input::Plane($case) => $answer,
            Input::Space($case) => $answer,
        }
    };
}

impl Input {
    /// Its number of points.
    #[must_use]
    pub fn points(&self) -> usize {
        with_case!(self, case => case.points.len())
    }

    /// Its number of segments.
    #[must_use]
    pub fn segments(&self) -> usize {
        with_case!(self, case => case.segments.len())
    }

    /// A hash of its bits.
    #[must_use]
    pub fn fingerprint(&self) -> u64 {
        let (points, segments) = match self {
            Self::Plane(case) => (Points::Plane(case.points.clone()), case.segments.clone()),
            Self::Space(case) => (Points::Space(case.points.clone()), Vec::new()),
        };
        workloads::Input { points, segments }.fingerprint()
    }

    /// The smallest input found, from this one on, that `fails`.
    #[must_use]
    pub fn shrunk(&self, effort: &mut Effort, mut fails: impl FnMut(&Self) -> bool) -> Self {
        match self {
            Self::Plane(case) => {
                Self::Plane(shrink(case, effort, |case| fails(&Self::Plane(case.clone()))))
            }
            Self::Space(case) => {
                Self::Space(shrink(case, effort, |case| fails(&Self::Space(case.clone()))))
            }
        }
    }
}

/// What is tried on a case: laws of this project, or another program.
pub trait Subject {
    /// How often something was tried, by law; or what broke first.
    ///
    /// # Errors
    /// If a law is broken.
    fn try_on(&mut self, input: &Input) -> Result<Vec<(&'static str, usize)>, Broken>;
}

/// A named generator with its laws.
#[derive(Clone, Debug)]
pub struct Target {
    /// As on the command line.
    pub name: &'static str,
    /// What it tries, in a line.
    pub about: &'static str,
    kind: Kind,
}

#[derive(Clone, Debug)]
enum Kind {
    Plane(fn(&mut dyn Choices) -> Case<2>, Vec<Law<2>>),
    Space(fn(&mut dyn Choices) -> Case<3>, Vec<Law<3>>),
}

impl Target {
    /// The case that these choices make.
    #[must_use]
    pub fn chosen(&self, choices: &mut dyn Choices) -> Input {
        match &self.kind {
            Kind::Plane(draw, _) => Input::Plane(draw(choices)),
            Kind::Space(draw, _) => Input::Space(draw(choices)),
        }
    }

    /// Case `k` under a seed.
    #[must_use]
    pub fn case(&self, seed: u64, k: u64) -> Input {
        // Both numbers through the generator: seeds 1 and 2 share no case, nor do targets.
        let mixed = Rng::named(self.name, seed).next_u64();
        self.chosen(&mut Rng::new(mixed.wrapping_add(Rng::new(k).next_u64())))
    }

    /// The names of its laws, in the order they are tried.
    #[must_use]
    pub fn laws(&self) -> Vec<&'static str> {
        match &self.kind {
            Kind::Plane(_, laws) => laws.iter().map(|law| law.name).collect(),
            Kind::Space(_, laws) => laws.iter().map(|law| law.name).collect(),
        }
    }

    /// The same target with one of its laws, if it has it.
    #[must_use]
    pub fn only(&self, law: &str) -> Option<Self> {
        let mut one = self.clone();
        match &mut one.kind {
            Kind::Plane(_, laws) => laws.retain(|known| known.name == law),
            Kind::Space(_, laws) => laws.retain(|known| known.name == law),
        }
        (!one.laws().is_empty()).then_some(one)
    }
}

impl Subject for Target {
    fn try_on(&mut self, input: &Input) -> Result<Vec<(&'static str, usize)>, Broken> {
        (&*self).try_on(input)
    }
}

impl Subject for &Target {
    fn try_on(&mut self, input: &Input) -> Result<Vec<(&'static str, usize)>, Broken> {
        match (&self.kind, input) {
            (Kind::Plane(_, laws), Input::Plane(case)) => tried(laws, case),
            (Kind::Space(_, laws), Input::Space(case)) => tried(laws, case),
            _ => Ok(Vec::new()),
        }
    }
}

fn tried<const D: usize>(
    laws: &[Law<D>],
    case: &Case<D>,
) -> Result<Vec<(&'static str, usize)>, Broken> {
    laws.iter().map(|law| Ok((law.name, attempt(law.name, || (law.hold)(case))?))).collect()
}

/// The name of the target that must fail.
const CANARY: &str = "canary";

impl Target {
    /// Whether this is the one that must fail.
    #[must_use]
    pub fn is_canary(&self) -> bool {
        self.name == CANARY
    }
}

/// All targets; the last is the canary, which must fail.
#[must_use]
pub fn targets() -> Vec<Target> {
    let row = |name, about, kind| Target { name, about, kind };
    let (plane, space) = (generate::points::<2>, generate::points::<3>);
    vec![
        row("delaunay-2d", "every law of point sets", Kind::Plane(plane, delaunay_laws())),
        row("delaunay-3d", "every law of point sets", Kind::Space(space, delaunay_laws())),
        row(
            "cdt",
            "every law of graphs whose segments do not cross",
            Kind::Plane(generate::graph, constrained_laws()),
        ),
        row(
            "agreement",
            "one triangulation by all CDT algorithms, judged: a law of \"cdt\", alone and quicker",
            Kind::Plane(generate::graph, extra::of_agreement()),
        ),
        row(
            "crossings",
            "segments that cross, every crossing a vertex",
            Kind::Plane(generate::crossing, extra::of_crossings()),
        ),
        row(
            "predicates-2d",
            "signs beside those of numbers of any length",
            Kind::Plane(plane, extra::of_predicates()),
        ),
        row(
            "predicates-3d",
            "signs beside those of numbers of any length",
            Kind::Space(space, extra::of_predicates()),
        ),
        row(
            "files",
            "what is written is read again, bit for bit",
            Kind::Plane(generate::crossing, extra::of_files()),
        ),
        row(
            "trees-2d",
            "every law of quadtrees, of what is inside a walk through segments",
            Kind::Plane(generate::crossing, quadtree_laws()),
        ),
        row("trees-3d", "every law of octrees, of tetrahedra", Kind::Space(space, octree_laws())),
        row(CANARY, "must fail: that doubles are enough", Kind::Plane(plane, extra::canary())),
    ]
}

/// The target of this name.
#[must_use]
pub fn target(name: &str) -> Option<Target> {
    targets().into_iter().find(|target| target.name == name)
}
