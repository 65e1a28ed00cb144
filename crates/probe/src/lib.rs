//! What an algorithm did, told as it happens: events, and the counters that tally them.
//!
//! Every algorithm takes `&mut impl Probe` as its last argument and reports through it. The unit type is the probe that
//! costs nothing; [`Counts`] tallies; a recorder for step-by-step pictures is the caller's to write.
//!
//! ```
//! use delone_probe::{Counts, Event, Probe};
//!
//! fn walk(steps: usize, probe: &mut impl Probe) {
//!     (0..steps).for_each(|_| probe.on(Event::WalkStep));
//! }
//!
//! let mut counts = Counts::default();
//! walk(3, &mut counts);
//! walk(5, &mut ()); // compiles to nothing
//! assert_eq!(counts.walk_steps, 3);
//! ```
//!
//! **Progress and cancellation.** [`Event::Site`] tells how many sites are in, of how many. A probe whose
//! [`goes_on`](Probe::goes_on) says no stops what can be stopped: it may look at a flag that another thread sets, at a
//! count, at a clock.
//!
//! **Step by step.** A probe that [`watches`](Probe::watches) is shown each [`Moment`] of some algorithms, triangles and all, as their
//! insides have them: for pictures. To others nothing is shown, at no cost.
//!
//! **Not here.** Clocks and progress bars: only the lab reads a clock.

/// One thing an algorithm did. Shared by all algorithms, so that their counts compare.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Event {
    /// An orientation was asked.
    Orient,
    /// A perturbed in-sphere test was asked.
    InSphere,
    /// A site was put into the triangulation; `done` are in it now, of `total`.
    Site {
        /// Sites inserted so far.
        done: usize,
        /// Sites to insert in all.
        total: usize,
    },
    /// Location crossed one facet, or compared a site with one place of a beach line.
    WalkStep,
    /// A cavity of this many cells was dug and starred.
    Cavity {
        /// Cells removed.
        cells: usize,
    },
    /// One flip.
    Flip,
    /// A sweep expects an arc to vanish. Those that do not make a cell were false alarms.
    CircleEvent,
    /// One cell was made.
    CellMade,
    /// A segment on its way through the mesh crossed an edge.
    EdgeCrossed,
    /// A segment, or a piece of one, became an edge of the mesh.
    Subsegment,
    /// A Steiner point became a vertex.
    SteinerPoint,
}

/// What there is after a step of an algorithm, vertices named as its caller does.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a> {
    /// What has just been done, in a line.
    pub title: &'a str,
    /// The triangles there are, counter-clockwise.
    pub triangles: &'a [[u32; 3]],
    /// Edges that are not sides of these triangles on both sides, some of them twice.
    pub edges: &'a [[u32; 2]],
    /// The vertices that the step was about.
    pub marked: &'a [u32],
}

/// Listens to an algorithm.
pub trait Probe {
    /// Called at each event, in the order things happen.
    fn on(&mut self, event: Event);

    /// Whether it is to be shown what there is after each step; that takes O(n) for each.
    #[inline(always)]
    fn watches(&self) -> bool {
        false
    }

    /// Called after each step by algorithms that show their insides, if the probe watches.
    #[inline(always)]
    fn show(&mut self, _moment: &Moment<'_>) {}

    /// Whether to go on. Asked between two sites, and only by algorithms that say that they can be stopped: those return
    /// an error instead of a result if the answer is no. All others neither ask nor stop.
    #[inline(always)]
    fn goes_on(&mut self) -> bool {
        true
    }
}

/// The probe that listens to nothing, at no cost.
impl Probe for () {
    #[inline(always)]
    fn on(&mut self, _: Event) {}
}

impl<P: Probe + ?Sized> Probe for &mut P {
    #[inline]
    fn on(&mut self, event: Event) {
        (**self).on(event);
    }

    #[inline]
    fn watches(&self) -> bool {
        (**self).watches()
    }

    #[inline]
    fn show(&mut self, moment: &Moment<'_>) {
        (**self).show(moment);
    }

    #[inline]
    fn goes_on(&mut self) -> bool {
        (**self).goes_on()
    }
}

/// The same probe, but that always goes on.
#[derive(Clone, Copy, Debug)]
pub struct Unstoppable<P>(pub P);

impl<P: Probe> Probe for Unstoppable<P> {
    #[inline(always)]
    fn on(&mut self, event: Event) {
        self.0.on(event);
    }

    #[inline(always)]
    fn watches(&self) -> bool {
        self.0.watches()
    }

    #[inline(always)]
    fn show(&mut self, moment: &Moment<'_>) {
        self.0.show(moment);
    }
}

/// Tallies of every kind of event.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Orientations asked.
    pub orients: u64,
    /// Perturbed in-sphere tests asked.
    pub in_spheres: u64,
    /// Sites inserted.
    pub sites: u64,
    /// Steps of location: facets crossed, places of a beach line compared with.
    pub walk_steps: u64,
    /// Cavities dug.
    pub cavities: u64,
    /// Cells removed in all cavities together.
    pub cavity_cells: u64,
    /// The largest cavity, in cells.
    pub cavity_cells_max: u64,
    /// Flips.
    pub flips: u64,
    /// Circle events that a sweep expected.
    pub circle_events: u64,
    /// Cells made.
    pub cells_made: u64,
    /// Edges crossed by segments on their way through the mesh.
    pub edges_crossed: u64,
    /// Subsegments made.
    pub subsegments: u64,
    /// Steiner points added.
    pub steiner_points: u64,
}

impl Probe for Counts {
    fn on(&mut self, event: Event) {
        match event {
            Event::Orient => self.orients += 1,
            Event::InSphere => self.in_spheres += 1,
            Event::Site { .. } => self.sites += 1,
            Event::WalkStep => self.walk_steps += 1,
            Event::Cavity { cells } => {
                self.cavities += 1;
                self.cavity_cells += cells as u64;
                self.cavity_cells_max = self.cavity_cells_max.max(cells as u64);
            }
            Event::Flip => self.flips += 1,
            Event::CircleEvent => self.circle_events += 1,
            Event::CellMade => self.cells_made += 1,
            Event::EdgeCrossed => self.edges_crossed += 1,
            Event::Subsegment => self.subsegments += 1,
            Event::SteinerPoint => self.steiner_points += 1,
        }
    }
}

impl Counts {
    /// Each tally under its name, in a fixed order.
    #[must_use]
    pub fn named(&self) -> [(&'static str, u64); 13] {
        [
            ("orients", self.orients),
            ("in_spheres", self.in_spheres),
            ("sites", self.sites),
            ("walk_steps", self.walk_steps),
            ("cavities", self.cavities),
            ("cavity_cells", self.cavity_cells),
            ("cavity_cells_max", self.cavity_cells_max),
            ("flips", self.flips),
            ("circle_events", self.circle_events),
            ("cells_made", self.cells_made),
            ("edges_crossed", self.edges_crossed),
            ("subsegments", self.subsegments),
            ("steiner_points", self.steiner_points),
        ]
    }
}

#[cfg(test)]
mod tests;
