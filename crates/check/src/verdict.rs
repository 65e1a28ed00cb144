//! The verdict: what was proved, what is wrong, and how many ties there were.

use crate::fault::Fault;
use std::collections::BTreeMap;
use std::fmt::{Display, Formatter};

/// The strongest property that was proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Level {
    /// Nothing.
    Unproved,
    /// The cells and ghosts of a mesh are glued into a closed oriented pseudomanifold.
    Linked,
    /// The cells triangulate the convex hull of all points.
    Triangulation,
    /// A constrained Delaunay triangulation, ties resolved in any way.
    WeaklyConstrained,
    /// The constrained Delaunay triangulation that the perturbation selects.
    Constrained,
    /// A conforming Delaunay triangulation, ties resolved in any way.
    WeaklyConforming,
    /// The conforming Delaunay triangulation that the perturbation selects for its vertices.
    Conforming,
    /// A regular triangulation, all hidden points left out, ties resolved in any way.
    WeaklyRegular,
    /// The regular triangulation that the perturbation selects.
    Regular,
    /// An alpha filtration, ties of its triangulation resolved in any way.
    AlphaFiltration,
    /// A Delaunay triangulation, ties resolved in any way.
    WeaklyDelaunay,
    /// The Delaunay triangulation that the perturbation selects.
    Delaunay,
}

impl Level {
    /// The name used in reports and JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Unproved => "unproved",
            Self::Linked => "linked",
            Self::Triangulation => "triangulation",
            Self::WeaklyConstrained => "weakly constrained delaunay",
            Self::Constrained => "constrained delaunay",
            Self::WeaklyConforming => "weakly conforming delaunay",
            Self::Conforming => "conforming delaunay",
            Self::WeaklyRegular => "weakly regular",
            Self::Regular => "regular",
            Self::AlphaFiltration => "alpha filtration",
            Self::WeaklyDelaunay => "weakly delaunay",
            Self::Delaunay => "delaunay",
        }
    }
}

impl Display for Level {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

/// The outcome of one judgement.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// Whether everything asked for was proved: there are no faults.
    pub ok: bool,
    /// The strongest property that was proved, faults or not.
    pub level: Level,
    /// The checks that found no fault, in the order they were made.
    pub proved: Vec<String>,
    /// The faults, in the order they were found, at most [`Options::faults_max`](crate::Options) of
    /// a kind.
    pub faults: Vec<Fault>,
    /// How many faults of each kind there are, kept or not.
    pub counts: BTreeMap<&'static str, usize>,
    /// Interior facets with the two cells' vertices exactly on one sphere.
    pub ties: usize,
    /// Points that are not used because they equal a used point.
    pub duplicates: usize,
}

impl Verdict {
    /// Whether a fault of this [kind](Fault::kind) was found.
    #[must_use]
    pub fn has(&self, kind: &str) -> bool {
        self.counts.contains_key(kind)
    }
}

/// One line for the verdict, one for each check, fault, and kind with faults left out.
impl Display for Verdict {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        let word = if self.ok { "accepted" } else { "rejected" };
        writeln!(f, "{word}: {}, {} ties", self.level, self.ties)?;
        for check in &self.proved {
            writeln!(f, "  proved  {check}")?;
        }
        for fault in &self.faults {
            writeln!(f, "  fault   {fault}")?;
        }
        for (kind, &count) in &self.counts {
            let kept = self.faults.iter().filter(|fault| fault.kind() == *kind).count();
            if kept < count {
                writeln!(f, "  and {} more of {kind}", count - kept)?;
            }
        }
        Ok(())
    }
}

/// A verdict in the making.
#[derive(Debug)]
pub(crate) struct Report {
    verdict: Verdict,
    faults_max: usize,
}

impl Report {
    pub(crate) fn new(faults_max: usize) -> Self {
        let verdict = Verdict {
            ok: true,
            level: Level::Unproved,
            proved: Vec::new(),
            faults: Vec::new(),
            counts: BTreeMap::new(),
            ties: 0,
            duplicates: 0,
        };
        Self { verdict, faults_max }
    }

    /// One that goes on from a verdict.
    pub(crate) fn resumed(verdict: Verdict, faults_max: usize) -> Self {
        Self { verdict, faults_max }
    }

    pub(crate) fn fault(&mut self, fault: Fault) {
        self.verdict.ok = false;
        let count = self.verdict.counts.entry(fault.kind()).or_insert(0);
        *count += 1;
        if *count <= self.faults_max {
            self.verdict.faults.push(fault);
        }
    }

    /// Runs a check that is worth noting only if its `premise` was proved.
    pub(crate) fn check_given(
        &mut self,
        premise: bool,
        claim: &str,
        run: impl FnOnce(&mut Self),
    ) -> bool {
        if premise {
            self.check(claim, run)
        } else {
            run(self);
            false
        }
    }

    /// Runs a check, and notes it as proved if it found no fault; returns whether it did not.
    pub(crate) fn check(&mut self, claim: &str, run: impl FnOnce(&mut Self)) -> bool {
        let before = self.total();
        run(self);
        let clean = self.total() == before;
        if clean {
            self.verdict.proved.push(claim.to_owned());
        }
        clean
    }

    pub(crate) fn tie(&mut self) {
        self.verdict.ties += 1;
    }

    pub(crate) fn duplicate(&mut self) {
        self.verdict.duplicates += 1;
    }

    pub(crate) fn reached(&mut self, level: Level) {
        self.verdict.level = level;
    }

    pub(crate) fn is_clean(&self) -> bool {
        self.verdict.ok
    }

    pub(crate) fn count(&self, kind: &str) -> usize {
        self.verdict.counts.get(kind).copied().unwrap_or(0)
    }

    pub(crate) fn verdict(self) -> Verdict {
        self.verdict
    }

    fn total(&self) -> usize {
        self.verdict.counts.values().sum()
    }
}
