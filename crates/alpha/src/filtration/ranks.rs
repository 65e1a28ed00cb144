//! What is attached, and the order of the values of what is not.
//!
//! One sphere for each simplex, in doubles ([`Metric::circumball`]), tells the bounds of its value and which of its facets are
//! attached because of the corner opposite; what doubles leave open is asked exactly. Values are sorted by the leading digits of
//! their lower bounds, then by these, and then in truth wherever bounds overlap.

use std::cmp::Ordering;

use delone_predicates::{Metric, Sign};

use crate::bulk::{narrow, sort_by_high_half};
use crate::geometry::{Measured, Site, named};
use crate::{SimplexId, Simplices};

/// For each simplex whether a vertex of a coface is inside its smallest sphere; and those of which that is not so.
pub(super) struct Measures {
    pub(super) attached: Vec<bool>,
    own: Vec<Measured>,
}

impl Measures {
    pub(super) fn of<const D: usize>(
        simplices: &Simplices,
        kernel: &impl Metric<D>,
        has_weights: bool,
    ) -> Self {
        let mut measures = Self {
            attached: vec![false; simplices.len()],
            own: Vec::with_capacity(simplices.len()),
        };
        let least = if has_weights { 1 } else { 2 }; // equal weights leave every vertex its own
        for k in (0..simplices.dimension().map_or(0, |top| top + 1)).rev() {
            let marks = k >= least;
            match k + 1 {
                1 => measures.level::<D, 1>(simplices, kernel, marks),
                2 => measures.level::<D, 2>(simplices, kernel, marks),
                3 => measures.level::<D, 3>(simplices, kernel, marks),
                4 => measures.level::<D, 4>(simplices, kernel, marks),
                5 => measures.level::<D, 5>(simplices, kernel, marks),
                6 => measures.level::<D, 6>(simplices, kernel, marks),
                7 => measures.level::<D, 7>(simplices, kernel, marks),
                _ => measures.level::<D, 8>(simplices, kernel, marks),
            }
        }
        measures
    }

    /// Measures the simplices of W vertices, and marks those of their facets that are attached because of them. Cofaces have been
    /// here before: it is known of each simplex whether it is attached.
    fn level<const D: usize, const W: usize>(
        &mut self,
        simplices: &Simplices,
        kernel: &impl Metric<D>,
        marks: bool,
    ) {
        for (id, vertices, facets) in simplices.level(W - 1) {
            let sites: [Site; W] = std::array::from_fn(|i| Site(vertices[i]));
            let ball = kernel.circumball(&sites);
            if !self.attached[id] {
                let bounds = ball.map(|ball| ball.squared_radius);
                self.own.push(Measured::new(kernel, narrow(id), &sites, bounds));
            }
            if !marks {
                continue;
            }
            for (corner, &facet) in facets.iter().enumerate() {
                let is_attached = &mut self.attached[facet as usize];
                match ball.and_then(|ball| *ball.inside.get(corner)?) {
                    Some(sign) => *is_attached |= sign == Sign::Positive,
                    None if *is_attached => {}
                    None => *is_attached = is_inside(kernel, sites, corner),
                }
            }
        }
    }

    /// The ranks of the simplices that are not attached, and a simplex for each rank.
    pub(super) fn ranks<const D: usize>(
        self,
        simplices: &Simplices,
        kernel: &impl Metric<D>,
    ) -> (Vec<u32>, Vec<u32>) {
        let compare = |a: &Measured, b: &Measured| {
            a.order(b).unwrap_or_else(|| {
                let simplex = |m: &Measured| simplices.vertices(SimplexId::new(m.simplex as usize));
                let (mut of_a, mut of_b) = ([Site(0); 8], [Site(0); 8]);
                kernel.compare_radii(named(simplex(a), &mut of_a), named(simplex(b), &mut of_b))
            })
        };
        let mut measured = by_lower_bound(self.own);
        let (mut ranks, mut spectrum) = (vec![u32::MAX; self.attached.len()], Vec::new());
        let mut rest = &mut measured[..];
        while !rest.is_empty() {
            let (cluster, others) = rest.split_at_mut(overlapping(rest));
            cluster.sort_unstable_by(compare);
            for equal in cluster.chunk_by(|a, b| compare(a, b) == Ordering::Equal) {
                let rank = narrow(spectrum.len());
                equal.iter().for_each(|m| ranks[m.simplex as usize] = rank);
                spectrum.extend(equal.iter().map(|m| m.simplex).min());
            }
            rest = others;
        }
        (ranks, spectrum)
    }
}

/// Whether a corner is inside the smallest sphere through the others.
#[cold]
#[inline(never)]
fn is_inside<const D: usize, const W: usize>(
    kernel: &impl Metric<D>,
    mut sites: [Site; W],
    corner: usize,
) -> bool {
    sites[corner..].rotate_left(1); // that corner last, the others before it in their order
    kernel.in_smallest_sphere(&sites[..W - 1], sites[W - 1]) == Sign::Positive
}

/// In order of lower bounds.
fn by_lower_bound(measured: Vec<Measured>) -> Vec<Measured> {
    let images = || measured.iter().filter(|m| m.bounds[0] != 0.0).map(Measured::image);
    let (least, most) = (images().min().unwrap_or(0), images().max().unwrap_or(0));
    let shift = 32u32.saturating_sub((most - least).leading_zeros());
    // Of those that are zero only the order matters; equal digits are told apart below.
    let digits = |m: &Measured| (m.image().clamp(least, most) - least) >> shift;
    let items = (0u64..).zip(&measured).map(|(place, m)| digits(m) << 32 | place).collect();
    let places = sort_by_high_half(items);
    let mut sorted: Vec<Measured> = places.iter().map(|&place| measured[place as usize]).collect();
    for alike in sorted.chunk_by_mut(|a, b| digits(a) == digits(b)).filter(|run| run.len() > 1) {
        alike.sort_unstable_by(|a, b| a.bounds[0].total_cmp(&b.bounds[0]));
    }
    sorted
}

/// How many of the first, in order of lower bounds, are joined by overlaps of bounds: at least one, and all others are greater.
fn overlapping(measured: &[Measured]) -> usize {
    let mut reach = f64::NEG_INFINITY;
    let joined = measured.iter().enumerate().take_while(|&(i, m)| {
        let is_joined = i == 0 || m.bounds[0] <= reach;
        reach = reach.max(m.bounds[1]);
        is_joined
    });
    joined.count()
}
