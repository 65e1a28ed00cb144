//! Every Delaunay algorithm by name: what the lab, the tests and the benches walk.

use std::any::Any;
use std::fmt;
use std::num::NonZeroUsize;

use delone_mesh::Mesh;
use delone_predicates::{Adaptive, Exact};
use delone_probe::{Event, Moment, Probe, Unstoppable};
use delone_sites::Sites;

use crate::bowyer_watson::construct;
use crate::{Delaunay, divide_conquer, divide_conquer_in_parallel, flips, naive_mesh, sweep};

/// Which kernel answers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum KernelKind {
    /// Filters, then exact integers.
    #[default]
    Adaptive,
    /// Exact integers only.
    Exact,
}

/// The order in which an incremental algorithm takes the sites.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Order {
    /// Biased randomized rounds along Hilbert's curve.
    #[default]
    Brio,
    /// Along Hilbert's curve.
    Hilbert,
    /// As given.
    AsGiven,
    /// By coordinates.
    Lexicographic,
}

/// How to run an algorithm. No result depends on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Who answers.
    pub kernel: KernelKind,
    /// The order of insertion, where there is one.
    pub order: Order,
    /// Seeds the randomized order.
    pub seed: u64,
    /// How many threads an algorithm may use that can use several.
    pub threads: NonZeroUsize,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            kernel: KernelKind::default(),
            order: Order::default(),
            seed: 0,
            threads: NonZeroUsize::MIN,
        }
    }
}

impl Options {
    /// The order of insertion.
    pub(crate) fn order<const D: usize>(&self, sites: &Sites<D>) -> Vec<u32> {
        match self.order {
            Order::Brio => sites.brio_order(self.seed),
            Order::Hilbert => sites.hilbert_order(),
            Order::AsGiven => (0u32..).take(sites.len()).collect(),
            Order::Lexicographic => sites.sorted().to_vec(),
        }
    }
}

/// One Delaunay algorithm.
#[derive(Clone, Copy, Debug)]
pub struct Algorithm<const D: usize> {
    /// Its name on the command line.
    pub name: &'static str,
    /// Keys of the papers it follows.
    pub papers: &'static [&'static str],
    /// The most sites it is meant for: beyond, it is right, but nobody would wait for it.
    pub sites_max: usize,
    /// Runs it.
    pub run: fn(&Sites<D>, &Options) -> Delaunay<D>,
    /// Runs it, on one thread, and tells the probe.
    pub run_with: fn(&Sites<D>, &Options, &mut dyn Probe) -> Delaunay<D>,
    /// Runs it, on one thread, and stops if the probe does not go on; `None` if it cannot be stopped.
    pub run_unless_stopped: Option<Stoppable<D>>,
}

/// Runs an algorithm that its probe can stop.
pub type Stoppable<const D: usize> =
    fn(&Sites<D>, &Options, &mut dyn Probe) -> Result<Delaunay<D>, Stopped>;

/// All algorithms that run in D dimensions; the first is the one to take if nothing speaks for another.
#[must_use]
pub fn algorithms<const D: usize>() -> Vec<Algorithm<D>> {
    let mut rows = only_in(planar());
    rows.push(Algorithm {
        name: "bowyer-watson",
        papers: &["Bow81", "Wat81", "DT11", "ACR03"],
        sites_max: usize::MAX,
        run: |sites, options| delaunay(sites, options, &mut ()),
        run_with: |sites, options, mut probe| delaunay(sites, options, &mut probe),
        run_unless_stopped: Some(|sites, options, mut probe| {
            delaunay_unless_stopped(sites, options, &mut probe)
        }),
    });
    rows.push(Algorithm {
        name: "naive",
        papers: &["DT11"],
        sites_max: 16,
        run: naive,
        run_with: |sites, options, probe| {
            let result = naive(sites, options);
            probe.on(Event::Site { done: sites.len(), total: sites.len() });
            result
        },
        run_unless_stopped: None,
    });
    rows
}

/// The definition.
fn naive<const D: usize>(sites: &Sites<D>, options: &Options) -> Delaunay<D> {
    let (points, order) = (sites.points(), options.order(sites));
    Delaunay::new(match options.kernel {
        KernelKind::Adaptive => naive_mesh(&Adaptive::new(points), &order),
        KernelKind::Exact => naive_mesh(&Exact::new(points), &order),
    })
}

/// Lawson's incremental flips.
fn lawson(sites: &Sites<2>, options: &Options, probe: &mut impl Probe) -> Delaunay<2> {
    let (points, order) = (sites.points(), options.order(sites));
    Delaunay::new(match options.kernel {
        KernelKind::Adaptive => flips(&Adaptive::new(points), &order, probe),
        KernelKind::Exact => flips(&Exact::new(points), &order, probe),
    })
}

/// Fortune's sweep.
fn fortune(sites: &Sites<2>, options: &Options, probe: &mut impl Probe) -> Delaunay<2> {
    let points = sites.points();
    Delaunay::new(match options.kernel {
        KernelKind::Adaptive => sweep(&Adaptive::new(points), sites, probe),
        KernelKind::Exact => sweep(&Exact::new(points), sites, probe),
    })
}

/// Algorithms of the plane.
fn planar() -> Vec<Algorithm<2>> {
    let divide_conquer = Algorithm {
        name: "divide-conquer",
        papers: &["GS85", "LS80", "Dwy87", "She96", "DT11"],
        sites_max: usize::MAX,
        run: |sites, options| {
            let (points, threads) = (sites.points(), options.threads);
            Delaunay::new(match options.kernel {
                KernelKind::Adaptive => {
                    divide_conquer_in_parallel(&Adaptive::new(points), sites, threads)
                }
                KernelKind::Exact => {
                    divide_conquer_in_parallel(&Exact::new(points), sites, threads)
                }
            })
        },
        run_with: |sites, options, mut probe| {
            let points = sites.points();
            Delaunay::new(match options.kernel {
                KernelKind::Adaptive => divide_conquer(&Adaptive::new(points), sites, &mut probe),
                KernelKind::Exact => divide_conquer(&Exact::new(points), sites, &mut probe),
            })
        },
        run_unless_stopped: None,
    };
    let flips = Algorithm {
        name: "flips",
        papers: &["Law77", "GKS92", "DT11", "ACR03"],
        sites_max: usize::MAX,
        run: |sites, options| lawson(sites, options, &mut ()),
        run_with: |sites, options, mut probe| lawson(sites, options, &mut probe),
        run_unless_stopped: None,
    };
    let sweep = Algorithm {
        name: "sweep",
        papers: &["For87", "Law77", "DT11"],
        sites_max: usize::MAX,
        run: |sites, options| fortune(sites, options, &mut ()),
        run_with: |sites, options, mut probe| fortune(sites, options, &mut probe),
        run_unless_stopped: None,
    };
    vec![divide_conquer, flips, sweep]
}

/// These rows if D is their dimension K, else none. Where D is K, the two types are one, and a cast finds out.
fn only_in<const D: usize, const K: usize>(rows: Vec<Algorithm<K>>) -> Vec<Algorithm<D>> {
    let rows: Box<dyn Any> = Box::new(rows);
    rows.downcast().map_or_else(|_| Vec::new(), |rows| *rows)
}

/// The Delaunay triangulation of sites, by [`crate::bowyer_watson()`] in the given order under the given kernel.
pub fn delaunay<const D: usize>(
    sites: &Sites<D>,
    options: &Options,
    probe: &mut impl Probe,
) -> Delaunay<D> {
    Delaunay::new(by_bowyer_watson(sites, options, &mut Unstoppable(probe)))
}

/// The mesh of sites; of some of them, if the probe does not go on.
fn by_bowyer_watson<const D: usize>(
    sites: &Sites<D>,
    options: &Options,
    probe: &mut impl Probe,
) -> Mesh<D> {
    let order = options.order(sites);
    match options.kernel {
        KernelKind::Adaptive => construct(&Adaptive::new(sites.points()), order, probe),
        KernelKind::Exact => construct(&Exact::new(sites.points()), order, probe),
    }
}

/// That an algorithm was stopped by its probe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stopped;

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "stopped before all sites were in, as the probe asked")
    }
}

impl std::error::Error for Stopped {}

/// The same as [`delaunay()`], unless the probe says, between two sites, not to go on.
///
/// ```
/// use delone_delaunay::{Options, Stopped, delaunay_unless_stopped};
/// use delone_probe::{Event, Probe, Unstoppable};
/// use delone_sites::Sites;
///
/// struct AtMost(usize);
/// impl Probe for AtMost {
///     fn on(&mut self, _: Event) {}
///     fn goes_on(&mut self) -> bool {
///         self.0 = self.0.saturating_sub(1);
///         self.0 > 0
///     }
/// }
///
/// let sites = Sites::new(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [1.0, 1.0]]).unwrap();
/// let run = |most| delaunay_unless_stopped(&sites, &Options::default(), &mut AtMost(most));
/// assert!(run(9).is_ok());
/// assert_eq!(run(2), Err(Stopped));
/// ```
///
/// # Errors
/// If the probe stopped it.
pub fn delaunay_unless_stopped<const D: usize>(
    sites: &Sites<D>,
    options: &Options,
    probe: &mut impl Probe,
) -> Result<Delaunay<D>, Stopped> {
    unless_stopped(probe, |probe| by_bowyer_watson(sites, options, probe)).map(Delaunay::new)
}

/// What `work` gives, unless its probe did not let it go on.
pub(crate) fn unless_stopped<P: Probe, R>(
    probe: P,
    work: impl FnOnce(&mut Watched<P>) -> R,
) -> Result<R, Stopped> {
    let mut watched = Watched { probe, is_stopped: false };
    let result = work(&mut watched);
    if watched.is_stopped { Err(Stopped) } else { Ok(result) }
}

/// A probe that remembers having stopped.
pub(crate) struct Watched<P> {
    probe: P,
    is_stopped: bool,
}

impl<P: Probe> Probe for Watched<P> {
    fn on(&mut self, event: Event) {
        self.probe.on(event);
    }

    fn watches(&self) -> bool {
        self.probe.watches()
    }

    fn show(&mut self, moment: &Moment<'_>) {
        self.probe.show(moment);
    }

    fn goes_on(&mut self) -> bool {
        self.is_stopped |= !self.probe.goes_on();
        !self.is_stopped
    }
}
