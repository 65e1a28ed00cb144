//! Every method of making a triangulation conforming, by name: what the lab, the tests and the benches walk.

use delone_probe::Probe;
use delone_sites::Pslg;

use crate::Conforming;
use crate::conform::{ConformOptions, Encroached, Missing, conform, conform_by_protection};

/// One method.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// Its name on the command line.
    pub name: &'static str,
    /// Keys of the papers it follows.
    pub papers: &'static [&'static str],
    /// Whether the closed diametral disks of subsegments are empty.
    pub empties_disks: bool,
    /// The most subsegments that it is meant for: it runs on more, for longer than anybody waits.
    pub segments_max: usize,
    /// Runs it and tells the probe.
    pub run: fn(&Pslg, &ConformOptions, &mut dyn Probe) -> Conforming,
}

/// All methods; the first is the one to take if nothing speaks for another. Edelsbrunner's and Tan's, with its bound on the
/// number of points, is not among them.
#[must_use]
pub fn methods() -> Vec<Method> {
    vec![
        Method {
            name: "delaunay",
            papers: &["Rup95", "She02"],
            empties_disks: false,
            segments_max: usize::MAX,
            run: |pslg, options, mut probe| conform(pslg, &Missing, options, &mut probe),
        },
        Method {
            name: "gabriel",
            papers: &["Rup95", "She02"],
            empties_disks: true,
            segments_max: usize::MAX,
            run: |pslg, options, mut probe| conform(pslg, &Encroached, options, &mut probe),
        },
        Method {
            name: "saalfeld",
            papers: &["Saa91"],
            empties_disks: true,
            segments_max: usize::MAX,
            run: |pslg, options, mut probe| conform_by_protection(pslg, options, &mut probe),
        },
    ]
}
