//! Cuts across y: a region that is higher than it is wide is cut into blocks, where cuts are clean.
//!
//! ```text
//!    ------------     A cut is clean if no segment with an end in the region has ends on both sides of it. Then each block is a region by
//!    |  C  .   /      itself, of the same slab: pieces of segments in the slab do not cross the cuts, nor does an edge of one
//!    | .    . /       block. Segments of another block may still be next below or above a site: what separates the region
//!    |- - - -/- -     from others takes their place. Neighbouring blocks are zipped along the cut as two slabs are along
//!    |  B . /  .|     their wall, in one window, from left to right: C is the left hand turned by 90 degrees, B the right one.
//!    |- - - - - |
//!    |  A .  .  |
//!    ------------
//! ```
//!
//! **Paper.** [Che89] cuts slabs alone. That cuts of both kinds in turn leave less to be undone is Dwyer's observation [Dwy87], for sites
//! without segments: the triangles of narrow, high slabs are slivers, which wider ones undo. **Order.** Across y sites compare by ordinate, then
//! abscissa: as if cuts fell by an infinitesimal to the right. **Cost.** O(k log k) for k sites, once for each site: blocks are not cut again. A cut
//! that is not clean would part segments; without clean ones the region is halved like others, and so it is where segments are
//! nearly as many as sites.

use std::cmp::Ordering;
use std::ops::Range;

use delone_predicates::PlaneKernel;
use delone_probe::Probe;
use delone_sites::Ends;

use super::Chew;
use super::region::{Region, Wall};
use super::rings::Half;
use super::zip::{Cut, Hand};

/// Blocks have so many sites at least.
const LEAST: usize = 8;

/// Which is lower, across y.
fn compare_across(kernel: &impl PlaneKernel, u: u32, v: u32) -> Ordering {
    kernel.compare(1, u as usize, v as usize).then(u.cmp(&v))
}

/// What is needed to cut across, and is kept to be used again.
#[derive(Debug, Default)]
pub(super) struct Across {
    /// For each site of the region at hand its place in the run, were that sorted across y.
    height: Vec<u32>,
    by_height: Vec<u32>,
    /// For each cut how many more segments cross it than the one below.
    change: Vec<i32>,
    /// The blocks of the region at hand, from bottom to top.
    blocks: Vec<Block>,
}

impl Across {
    pub(super) fn new(sites: usize) -> Self {
        Self { height: vec![0; sites], ..Self::default() }
    }
}

/// A block: its first place in the run, its lowest and its highest site.
#[derive(Clone, Copy, Debug)]
struct Block {
    start: u32,
    lowest: u32,
    highest: u32,
}

/// The places of a block of a region whose places end with `end`.
fn places_of(blocks: &[Block], block: usize, end: usize) -> Range<usize> {
    let next = blocks.get(block + 1).map_or(end, |next| next.start as usize);
    blocks[block].start as usize..next
}

/// A cut of a region of the slab, below the block that begins at place `start`.
struct Level<'a> {
    slab: Ends,
    height: &'a [u32],
    start: u32,
}

impl Cut for Level<'_> {
    #[inline]
    fn holds(&self, hand: Hand, v: u32) -> bool {
        let [i, j] = self.slab;
        // A site of the slab that is met in a ring of the region is of the region.
        (i..j).contains(&v) && (self.height[v as usize] >= self.start) == (hand == Hand::Left)
    }
}

impl<K: PlaneKernel, P: Probe> Chew<'_, '_, K, P> {
    /// Cuts the region of the sites at these places into blocks and solves it, if it is high and there are clean cuts.
    pub(super) fn solve_across(&mut self, places: Range<usize>, slab: Ends) -> Option<Region> {
        let width = u64::from(slab[1] - slab[0]);
        // Of an even cloud, as many sites are in a block as high as the slab is wide.
        let square = width * width / self.bounds.len() as u64;
        let size = usize::try_from(square).unwrap_or(usize::MAX).max(LEAST);
        if places.len() < size.saturating_mul(2) || self.is_full_of_chains() {
            return None;
        }
        self.sort_across(places.clone());
        self.find_blocks(places.start, slab, size);
        if self.across.blocks.len() == 1 {
            return None;
        }
        self.part(places.clone(), slab);
        let base = self.regions.len();
        let count = self.across.blocks.len();
        for block in 0..count {
            match places_of(&self.across.blocks, block, places.end) {
                alone if alone.len() == 1 => {
                    let region = self.single(self.run.sites[alone.start]);
                    self.regions.push(region);
                }
                block => self.solve_region(block, slab),
            }
        }
        assert_eq!(self.regions.len(), base + count, "the sites of one region make one");
        let region = self.zip_blocks(0..count, base, slab);
        self.regions.truncate(base);
        Some(region)
    }

    /// Whether there are so many segments that chains of them are in the way of most cuts: to look for clean ones costs what they save.
    fn is_full_of_chains(&self) -> bool {
        4 * self.segments.len() > 3 * self.bounds.len()
    }

    /// Finds the order across y of the sites at these places, all of one region.
    fn sort_across(&mut self, places: Range<usize>) {
        let (kernel, across) = (self.kernel, &mut self.across);
        across.by_height.clear();
        across.by_height.extend_from_slice(&self.run.sites[places.clone()]);
        across.by_height.sort_unstable_by(|&u, &v| compare_across(kernel, u, v));
        for (place, &v) in places.zip(&across.by_height) {
            across.height[v as usize] = u32::try_from(place).expect("sites have 32-bit ids");
        }
    }

    /// Finds blocks of so many sites and more between clean cuts; the region's first place is `offset`.
    fn find_blocks(&mut self, offset: usize, [i, j]: Ends, size: usize) {
        let Across { height, by_height, change, blocks } = &mut self.across;
        let count = by_height.len();
        change.clear();
        change.resize(count + 2, 0);
        for (at, &v) in by_height.iter().enumerate() {
            for h in self.rings.halves(v) {
                let d = self.rings.destination(h);
                let crossed = if (i..j).contains(&d) {
                    let other = height[d as usize] as usize - offset;
                    at.min(other) + 1..at.max(other) + 1
                } else {
                    let is_lower = |&u: &u32| compare_across(self.kernel, u, d).is_lt();
                    let below = by_height.partition_point(is_lower);
                    (at + 1).min(below)..at.max(below) + 1
                };
                change[crossed.start] += 1;
                change[crossed.end] -= 1;
            }
        }
        blocks.clear();
        let (mut in_the_way, mut start) = (0, 0);
        for (cut, change) in change[..count].iter().enumerate() {
            in_the_way += change;
            let is_wanted = cut - start >= size && count - cut >= size;
            if cut == 0 || (in_the_way == 0 && is_wanted) {
                let lowest = by_height[cut];
                blocks.push(Block { start: height[lowest as usize], lowest, highest: lowest });
                start = cut;
            }
        }
    }

    /// Sorts the sites by block, those of each by rank, and puts what bounds the whole region in place of bounds of other blocks.
    fn part(&mut self, places: Range<usize>, [i, j]: Ends) {
        let Across { height, by_height, blocks, .. } = &mut self.across;
        let end_of = |segment: u32| {
            let [a, b] = self.segments[segment as usize];
            if (i..j).contains(&a) { Some(a) } else { Some(b).filter(|b| (i..j).contains(b)) }
        };
        // From the lowest site downwards and from the highest upwards, to what spans the slab.
        let mut outer = [None; 2];
        for (side, v) in [(0, by_height[0]), (1, by_height[by_height.len() - 1])] {
            let mut bound = self.bounds[v as usize][side];
            while let Some(end) = bound.and_then(end_of) {
                bound = self.bounds[end as usize][side];
            }
            outer[side] = bound;
        }
        self.run.sites[places.clone()].copy_from_slice(by_height);
        for block in 0..blocks.len() {
            let range = places_of(blocks, block, places.end);
            let sites = &mut self.run.sites[range.clone()];
            blocks[block].highest = sites[sites.len() - 1];
            sites.sort_unstable();
            for &v in &*sites {
                for (bound, outer) in self.bounds[v as usize].iter_mut().zip(outer) {
                    let end = bound.and_then(end_of);
                    if end.is_some_and(|end| !range.contains(&(height[end as usize] as usize))) {
                        *bound = outer;
                    }
                }
            }
        }
    }

    /// Zips the regions from place `base` on, of these blocks.
    fn zip_blocks(&mut self, blocks: Range<usize>, base: usize, slab: Ends) -> Region {
        if blocks.len() == 1 {
            return self.regions[base];
        }
        let middle = blocks.start + blocks.len() / 2;
        let lower = self.zip_blocks(blocks.start..middle, base, slab);
        let upper = self.zip_blocks(middle..blocks.end, base + blocks.len() / 2, slab);
        let [below, above] = [self.across.blocks[middle - 1], self.across.blocks[middle]];
        let (l, r) = (above.lowest, below.highest);
        let stands =
            [(l, self.level_sector(l, Hand::Left)), (r, self.level_sector(r, Hand::Right))];
        let height = std::mem::take(&mut self.across.height);
        self.zip_level(&Level { slab, height: &height, start: above.start }, stands);
        self.across.height = height;
        let mut region = lower;
        region.take(&upper);
        self.lists.append(&mut region.left, Wall::Left, upper.left);
        self.lists.append(&mut region.right, Wall::Right, upper.right);
        region
    }

    /// The sector of a site next to a cut that faces it: down for the left hand, which is the upper part, up for the right one.
    fn level_sector(&mut self, v: u32, hand: Hand) -> Option<Half> {
        let is_right = |h: Half| self.rings.destination(h) > v;
        let faces = |&h: &Half| match hand {
            Hand::Left => !is_right(h) && is_right(self.rings.next(h)),
            Hand::Right => is_right(h) && !is_right(self.rings.next(h)),
        };
        let between = self.rings.halves(v).find(faces);
        between.or_else(|| self.open_sector(v))
    }
}
