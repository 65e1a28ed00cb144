//! The division: slabs are halved; in narrow slabs the sites are first told apart by region.
//!
//! ```text
//!    ------a------      Segments that span the slab separate its regions: sites of different regions do not see each other in
//!     .   .    .        any narrower slab either. So each region is divided for itself, at the middle of its own sites, and the
//!    ------b------      many narrow slabs in which each site has a region to itself are never looked at.
//! ```
//!
//! **Paper.** [Che89] halves slabs down to single sites, and merges all regions of two slabs at each level. Where segments are
//! many, a slab of k sites has some k regions until it is wide, and merging costs O(k) at each of these levels without a
//! triangle made. **Cost.** O(k) for the labels of k sites, and a sort of their regions: less than half of one level of merges.

use std::ops::Range;

use delone_predicates::PlaneKernel;
use delone_probe::Probe;
use delone_sites::compare_along;

use super::Chew;

/// A slab is narrow if an even cloud is so many sites wide in it. In narrow slabs regions are told apart, and high ones are cut
/// across; in wider ones most sites are of one region, and hardly a cut across would be clean.
const WIDTH: u32 = 4;

/// No site, no segment.
const NONE: u32 = u32::MAX;

/// The sites of one narrow slab, region by region, and what tells the regions apart.
#[derive(Debug)]
pub(super) struct Run {
    pub(super) sites: Vec<u32>,
    /// For each site the segment next below that spans the slab.
    low: Vec<u32>,
    /// For each site another of its region, whose `low` is the same, until that is known.
    hop: Vec<u32>,
    /// For each segment the place in `lows` of the region above it; last, that of the region without one. `NONE` between two uses.
    place_of: Vec<u32>,
    lows: Vec<u32>,
    starts: Vec<usize>,
    sorted: Vec<u32>,
}

impl Run {
    pub(super) fn new(sites: usize, segments: usize) -> Self {
        Self {
            sites: Vec::new(),
            low: vec![NONE; sites],
            hop: vec![NONE; sites],
            place_of: vec![NONE; segments + 1],
            lows: Vec::new(),
            starts: Vec::new(),
            sorted: Vec::new(),
        }
    }

    /// The last site that `v` leads to; those on the way then lead there at once.
    fn last_hop(&mut self, v: u32) -> u32 {
        let mut last = v;
        while self.hop[last as usize] != NONE {
            last = self.hop[last as usize];
        }
        let mut at = v;
        while at != last {
            at = std::mem::replace(&mut self.hop[at as usize], last);
        }
        last
    }
}

impl<K: PlaneKernel, P: Probe> Chew<'_, '_, K, P> {
    /// Triangulates the slab of sites `i` to `j - 1`, and puts its regions on top of the others.
    pub(super) fn solve(&mut self, i: u32, j: u32) {
        let count = u32::try_from(self.bounds.len()).expect("sites have 32-bit ids");
        if j - i <= (WIDTH * count.isqrt()).max(1) {
            self.run.sites.clear();
            self.run.sites.extend(i..j);
            return self.each_region(0..self.run.sites.len(), [i, j], Self::solve_high);
        }
        let m = i + (j - i) / 2;
        let left = self.regions.len();
        self.solve(i, m);
        let right = self.regions.len();
        self.solve(m, j);
        self.merge([i, m, j], left, right);
    }

    /// The same for the sites at these places of the run: all those of some regions of the slab.
    fn solve_run(&mut self, places: Range<usize>, slab: [u32; 2]) {
        self.each_region(places, slab, Self::solve_region);
    }

    /// The same, regions of two sites and more by `solve`.
    fn each_region(
        &mut self,
        places: Range<usize>,
        slab: [u32; 2],
        solve: impl Fn(&mut Self, Range<usize>, [u32; 2]),
    ) {
        if places.len() == 1 {
            let region = self.single(self.run.sites[places.start]);
            return self.regions.push(region);
        }
        self.sort_by_region(places.clone(), slab);
        let mut start = places.start;
        while start < places.end {
            let low = |run: &Run, place: usize| run.low[run.sites[place] as usize];
            let region = low(&self.run, start);
            let same = (start..places.end).take_while(|&place| low(&self.run, place) == region);
            let end = start + same.count();
            if end - start == 1 {
                self.solve_run(start..end, slab);
            } else {
                solve(self, start..end, slab);
            }
            start = end;
        }
    }

    /// The same for all sites of one region of a slab that was just narrow enough.
    fn solve_high(&mut self, places: Range<usize>, slab: [u32; 2]) {
        match self.solve_across(places.clone(), slab) {
            Some(region) => self.regions.push(region),
            None => self.solve_region(places, slab),
        }
    }

    /// The same for all sites of one region, two or more. To tell regions apart at every second level is enough.
    pub(super) fn solve_region(&mut self, places: Range<usize>, slab: [u32; 2]) {
        if let [a, b] = self.run.sites[places.clone()] {
            let low = Some(self.run.low[a as usize]).filter(|&low| low != NONE);
            let region = self.pair([a, b], low);
            return self.regions.push(region);
        }
        self.halve(places, slab, |work, half, slab| {
            if half.len() < 4 {
                work.solve_run(half, slab);
            } else {
                work.halve(half, slab, Self::solve_run);
            }
        });
    }

    /// The same by halves, each solved by `solve`.
    fn halve(
        &mut self,
        places: Range<usize>,
        [i, j]: [u32; 2],
        solve: impl Fn(&mut Self, Range<usize>, [u32; 2]),
    ) {
        let middle = places.start + places.len() / 2;
        let m = self.run.sites[middle];
        let left = self.regions.len();
        solve(self, places.start..middle, [i, m]);
        let right = self.regions.len();
        solve(self, middle..places.end, [m, j]);
        self.merge([i, m, j], left, right);
    }

    /// Sorts the sites at these places by region, from bottom to top, and within one by rank, as they are sorted before.
    fn sort_by_region(&mut self, places: Range<usize>, slab: [u32; 2]) {
        self.find_lows(places.clone(), slab);
        let run = &mut self.run;
        let none = run.place_of.len() - 1;
        let slot = |low: u32| if low == NONE { none } else { low as usize };
        run.lows.clear();
        for &v in &run.sites[places.clone()] {
            let low = run.low[v as usize];
            if run.place_of[slot(low)] == NONE {
                run.place_of[slot(low)] = 0;
                run.lows.push(low);
            }
        }
        if run.lows.len() > 1 {
            run.lows.sort_unstable_by(|&e, &f| match (e == NONE, f == NONE) {
                (false, false) => compare_along(self.kernel, self.segments, e, f),
                (e_is_none, f_is_none) => f_is_none.cmp(&e_is_none),
            });
            for (place, &low) in (0u32..).zip(&run.lows) {
                run.place_of[slot(low)] = place;
            }
            run.starts.clear();
            run.starts.resize(run.lows.len() + 1, 0);
            let place = |v: u32| run.place_of[slot(run.low[v as usize])] as usize;
            run.sites[places.clone()].iter().for_each(|&v| run.starts[place(v) + 1] += 1);
            for region in 1..run.starts.len() {
                run.starts[region] += run.starts[region - 1];
            }
            run.sorted.clear();
            run.sorted.resize(places.len(), 0);
            for &v in &run.sites[places.clone()] {
                let at = &mut run.starts[place(v)];
                run.sorted[*at] = v;
                *at += 1;
            }
            run.sites[places].copy_from_slice(&run.sorted);
        }
        run.lows.iter().for_each(|&low| run.place_of[slot(low)] = NONE);
    }

    /// Finds for each site the segment next below that spans the slab. The segment next below of all either does, or has an end in
    /// the slab, which sees the same.
    fn find_lows(&mut self, places: Range<usize>, [i, j]: [u32; 2]) {
        let run = &mut self.run;
        for &v in &run.sites[places.clone()] {
            let ([low, _], at) = (self.bounds[v as usize], v as usize);
            (run.low[at], run.hop[at]) = (NONE, NONE);
            if let Some(low) = low {
                let [a, b] = self.segments[low as usize];
                if a >= i {
                    run.hop[at] = a;
                } else if b < j {
                    run.hop[at] = b;
                } else {
                    run.low[at] = low;
                }
            }
        }
        for place in places {
            let v = run.sites[place];
            let last = run.last_hop(v);
            run.low[v as usize] = run.low[last as usize];
        }
    }
}
