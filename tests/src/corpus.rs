//! The corpus: every workload at small and middle sizes, inputs by hand, and regressions.

use delone::workloads::{Kind, Points, Workload, all};

use crate::case::Case;
use crate::{data, hand};

/// How much of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// Inputs by hand, regressions, and workloads of a few sites under several seeds.
    Small,
    /// Workloads of some hundred sites.
    Middle,
}

impl Size {
    /// Numbers of sites and seeds, in the plane and in space.
    fn runs(self, kind: Kind) -> &'static [(usize, u64)] {
        match (self, kind) {
            (Self::Small, Kind::Points3d) => &[(5, 1), (10, 2), (24, 3)],
            (Self::Small, _) => &[(4, 1), (9, 2), (12, 3), (36, 4)],
            (Self::Middle, Kind::Points3d) => &[(70, 5)],
            (Self::Middle, _) => &[(200, 5)],
        }
    }
}

/// The inputs of one workload.
fn runs(workload: &Workload, size: Size) -> impl Iterator<Item = (String, Points, Vec<[u32; 2]>)> {
    size.runs(workload.kind()).iter().map(|&(n, seed)| {
        let input = workload.generate(n, seed);
        (format!("{} {n} seed {seed}", workload.name), input.points, input.segments)
    })
}

fn of_kind(kind: Kind) -> impl Iterator<Item = &'static Workload> {
    all().iter().filter(move |workload| workload.kind() == kind)
}

/// Points of the plane; those of PSLGs too.
#[must_use]
pub fn plane(size: Size) -> Vec<Case<2>> {
    let mut cases = Vec::new();
    if size == Size::Small {
        cases.extend(hand::plane());
        cases.extend(data::regressions().iter().filter_map(|(_, d)| data::points_of(d)));
    }
    for workload in of_kind(Kind::Points2d).chain(of_kind(Kind::Pslg)) {
        for (name, points, _) in runs(workload, size) {
            cases.extend(points.plane().map(|points| Case::of_points(name, points.to_vec())));
        }
    }
    cases
}

/// Points of space.
#[must_use]
pub fn space(size: Size) -> Vec<Case<3>> {
    let mut cases = Vec::new();
    if size == Size::Small {
        cases.extend(hand::space());
        cases.extend(data::regressions().iter().filter_map(|(_, d)| data::points_of(d)));
    }
    for workload in of_kind(Kind::Points3d) {
        for (name, points, _) in runs(workload, size) {
            cases.extend(points.space().map(|points| Case::of_points(name, points.to_vec())));
        }
    }
    cases
}

/// Graphs in the plane, segments crossing or not.
#[must_use]
pub fn graphs(size: Size) -> Vec<Case<2>> {
    let mut cases = Vec::new();
    if size == Size::Small {
        cases.extend(hand::pslgs());
        cases.extend(data::regressions().iter().filter_map(|(_, d)| data::pslg_of(d)));
    }
    for workload in of_kind(Kind::Pslg) {
        for (name, points, segments) in runs(workload, size) {
            cases.extend(points.plane().map(|points| Case::new(name, points.to_vec(), segments)));
        }
    }
    cases
}

/// Graphs whose segments do not cross.
#[must_use]
pub fn pslgs(size: Size) -> Vec<Case<2>> {
    graphs(size).into_iter().filter(|case| case.try_pslg().is_some()).collect()
}
