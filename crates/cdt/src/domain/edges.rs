//! What each subsegment separates.

use std::collections::VecDeque;

use delone_sites::Noded;

use crate::regions::{RegionId, Regions};

/// What a subsegment is in a filled CDT.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum EdgeKind {
    /// Inside on one side; the other is nearer to infinity: an outer boundary.
    Shell,
    /// Inside on one side; the other is farther from infinity: the boundary of a hole.
    Hole,
    /// Two regions, both inside.
    Interface,
    /// Two regions, both outside.
    Outside,
    /// One region on both sides; joins two circuits.
    Bridge,
    /// One region on both sides; part of no circuit, and joins none.
    Slit,
}

impl EdgeKind {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Shell, Self::Hole, Self::Interface, Self::Outside, Self::Bridge, Self::Slit];

    /// Its name, for people and scripts.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Shell => "shell",
            Self::Hole => "hole",
            Self::Interface => "interface",
            Self::Outside => "outside",
            Self::Bridge => "bridge",
            Self::Slit => "slit",
        }
    }
}

/// The kind of each subsegment.
pub(super) fn kinds(regions: &Regions, graph: &impl Noded, inside: &[bool]) -> Vec<EdgeKind> {
    let crossings = crossings(regions, inside);
    let core = core(graph);
    let kind = |(subsegment, &[left, right]): (usize, &[RegionId; 2])| {
        if left == right {
            return if core[subsegment] { EdgeKind::Bridge } else { EdgeKind::Slit };
        }
        match [left, right].map(|region| inside[region as usize]) {
            [true, true] => EdgeKind::Interface,
            [false, false] => EdgeKind::Outside,
            [left_is_inside, _] => {
                let [left, right] = [left, right].map(|region| crossings[region as usize]);
                let (within, beyond) = if left_is_inside { (left, right) } else { (right, left) };
                if beyond < within { EdgeKind::Shell } else { EdgeKind::Hole }
            }
        }
    };
    regions.sides().iter().enumerate().map(kind).collect()
}

/// How often any way from infinity must change between inside and outside: breadth first, steps that change nothing first.
fn crossings(regions: &Regions, inside: &[bool]) -> Vec<u32> {
    let neighbours = regions.neighbours();
    let mut counts = vec![u32::MAX; regions.count()];
    counts[0] = 0;
    let mut queue = VecDeque::from([(0, 0)]);
    for &start in regions.shore() {
        counts[start as usize] = u32::from(inside[start as usize]);
        queue.push_back((start as usize, counts[start as usize]));
    }
    while let Some((region, count)) = queue.pop_front() {
        if counts[region] < count {
            continue; // found before on a shorter way
        }
        for step in &neighbours[region] {
            let there = step.to as usize;
            let changes = inside[region] != inside[there];
            let next = count + u32::from(changes);
            if next < counts[there] {
                counts[there] = next;
                if changes {
                    queue.push_back((there, next));
                } else {
                    queue.push_front((there, next));
                }
            }
        }
    }
    counts
}

/// Which subsegments remain when those with a free end are taken away, again and again: circuits and what joins them.
fn core(graph: &impl Noded) -> Vec<bool> {
    let subsegments = graph.subsegments();
    let mut at = vec![Vec::new(); graph.positions().len()];
    for (subsegment, ends) in subsegments.iter().enumerate() {
        ends.iter().for_each(|&site| at[site as usize].push(subsegment));
    }
    let mut degrees: Vec<usize> = at.iter().map(Vec::len).collect();
    let mut core = vec![true; subsegments.len()];
    let mut free: Vec<usize> = (0..at.len()).filter(|&site| degrees[site] == 1).collect();
    while let Some(site) = free.pop() {
        // The last one may have gone from its other end.
        let Some(&subsegment) = at[site].iter().find(|&&subsegment| core[subsegment]) else {
            continue;
        };
        core[subsegment] = false;
        for end in subsegments[subsegment].map(|end| end as usize) {
            degrees[end] -= 1;
            if degrees[end] == 1 {
                free.push(end);
            }
        }
    }
    core
}
