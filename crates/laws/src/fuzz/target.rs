//! What can be fuzzed: a generator, and the laws to try.

use std::sync::Arc;

use delone::workloads::{self, Points, Rng};

use super::attempt::{Broken, attempt};
use super::file::File;
use super::hash::Hash;
use crate::case::Case;
use crate::choices::{Beside, Choices};
use crate::corpus::Corpus;
use crate::laws::Law;
use crate::shrink::{Effort, shrink};

/// A case of either dimension, or a file.
#[derive(Clone, Debug, PartialEq)]
pub enum Input {
    /// In the plane.
    Plane(Case<2>),
    /// In space.
    Space(Case<3>),
    /// Any bytes.
    File(File),
}

impl Input {
    /// Its number of points; of a file, of bytes.
    #[must_use]
    pub fn points(&self) -> usize {
        match self {
            Self::Plane(case) => case.points.len(),
            Self::Space(case) => case.points.len(),
            Self::File(file) => file.bytes.len(),
        }
    }

    /// Its number of segments.
    #[must_use]
    pub fn segments(&self) -> usize {
        if let Self::Plane(case) = self { case.segments.len() } else { 0 }
    }

    /// A hash of its bits.
    #[must_use]
    pub fn fingerprint(&self) -> u64 {
        let (points, segments) = match self {
            Self::Plane(case) => (Points::Plane(case.points.clone()), case.segments.clone()),
            Self::Space(case) => (Points::Space(case.points.clone()), Vec::new()),
            Self::File(file) => {
                let mut hash = Hash::default();
                hash.text(&file.format.to_string());
                hash.bytes(&file.bytes);
                return hash.value();
            }
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
            Self::File(file) => {
                Self::File(file.shrunk(effort, |file| fails(&Self::File(file.clone()))))
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
    pub(super) kind: Kind,
    /// What cases may take pieces of.
    pub(super) corpus: Arc<Corpus>,
}

#[derive(Clone, Debug)]
pub(super) enum Kind {
    Plane(fn(&mut dyn Choices) -> Case<2>, Vec<Law<2>>),
    Space(fn(&mut dyn Choices) -> Case<3>, Vec<Law<3>>),
    File(fn(&mut dyn Choices) -> File, (&'static str, fn(&File) -> usize)),
}

impl Target {
    /// The case that these choices make.
    #[must_use]
    pub fn chosen(&self, choices: &mut dyn Choices) -> Input {
        match &self.kind {
            Kind::Plane(draw, _) => Input::Plane(draw(choices)),
            Kind::Space(draw, _) => Input::Space(draw(choices)),
            Kind::File(draw, _) => Input::File(draw(choices)),
        }
    }

    /// Case `k` under a seed.
    #[must_use]
    pub fn case(&self, seed: u64, k: u64) -> Input {
        // Both numbers through the generator: seeds 1 and 2 share no case, nor do targets.
        let mixed = Rng::named(self.name, seed).next_u64() ^ self.corpus.digest();
        let rng = Rng::new(mixed.wrapping_add(Rng::new(k).next_u64()));
        self.chosen(&mut Beside { rng, corpus: &self.corpus })
    }

    /// The same target, whose cases take pieces of a corpus: other cases, by its digest.
    #[must_use]
    pub fn with_corpus(self, corpus: Arc<Corpus>) -> Self {
        Self { corpus, ..self }
    }

    /// What its cases take pieces of.
    #[must_use]
    pub fn corpus(&self) -> &Corpus {
        &self.corpus
    }

    /// The names of its laws, in the order they are tried.
    #[must_use]
    pub fn laws(&self) -> Vec<&'static str> {
        match &self.kind {
            Kind::Plane(_, laws) => laws.iter().map(|law| law.name).collect(),
            Kind::Space(_, laws) => laws.iter().map(|law| law.name).collect(),
            Kind::File(_, (law, _)) => vec![law],
        }
    }

    /// The same target with one of its laws, if it has it.
    #[must_use]
    pub fn only(&self, law: &str) -> Option<Self> {
        let mut one = self.clone();
        match &mut one.kind {
            Kind::Plane(_, laws) => laws.retain(|known| known.name == law),
            Kind::Space(_, laws) => laws.retain(|known| known.name == law),
            Kind::File(..) => {}
        }
        one.laws().contains(&law).then_some(one)
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
            (Kind::File(_, (law, hold)), Input::File(file)) => {
                Ok(vec![(law, attempt(law, || hold(file))?)])
            }
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
pub(super) const CANARY: &str = "canary";

impl Target {
    /// Whether this is the one that must fail.
    #[must_use]
    pub fn is_canary(&self) -> bool {
        self.name == CANARY
    }
}
