//! One pass over the input that finds everything that is wrong with it.
//!
//! What cannot be used (a point that is not finite, a segment that names no point or such a one) is named and set aside; the
//! rest is noded, so that what is wrong with the rest is found as well.

use super::{Planar, Pslg, PslgFault};
use crate::{NotFinite, Sites};

/// The usable part of the input, and why the rest is not.
pub(super) struct Survey {
    /// The usable part, noded; its segments may cross.
    pub(super) pslg: Pslg,
    pub(super) planar: Planar,
    /// What was set aside.
    pub(super) faults: Vec<PslgFault>,
    pub(super) names: Names,
}

/// The input indices of what was used.
pub(super) struct Names {
    points: Vec<usize>,
    segments: Vec<usize>,
}

impl Survey {
    pub(super) fn of(points: &[[f64; 2]], segments: &[[usize; 2]]) -> Self {
        let too_many = [points.len(), segments.len()]
            .into_iter()
            .find(|&count| u32::try_from(count).ok().is_none_or(|count| count >= u32::MAX - 1));
        if let Some(count) = too_many {
            return Self { faults: vec![PslgFault::TooMany(count)], ..Self::of(&[], &[]) };
        }
        let mut faults: Vec<PslgFault> = points.iter().enumerate().flat_map(not_finite).collect();
        let mut names = Names { points: Vec::new(), segments: Vec::new() };
        let mut places = vec![None; points.len()];
        let mut finite = Vec::new();
        for (point, p) in points.iter().enumerate().filter(|(_, p)| p.iter().all(|x| x.is_finite()))
        {
            places[point] = Some(finite.len());
            finite.push(*p);
            names.points.push(point);
        }
        let mut usable: Vec<[usize; 2]> = Vec::new();
        for (segment, ends) in segments.iter().enumerate() {
            let absent = ends.iter().filter(|&&point| point >= points.len());
            faults.extend(absent.map(|&point| PslgFault::NoSuchPoint {
                segment,
                point,
                count: points.len(),
            }));
            if let [Some(&Some(a)), Some(&Some(b))] = ends.map(|point| places.get(point)) {
                usable.push([a, b]);
                names.segments.push(segment);
            }
        }
        let sites = Sites::new(&finite).expect("finite points, fewer than ids");
        let ends = usable.iter().map(|ends| ends.map(|point| sites.site_of()[point])).collect();
        let (pslg, planar) = Pslg::noded(sites, ends);
        Self { pslg, planar, faults, names }
    }
}

fn not_finite((point, p): (usize, &[f64; 2])) -> impl Iterator<Item = PslgFault> {
    let p = *p;
    let bad = (0..2).filter(move |&axis| !p[axis].is_finite());
    bad.map(move |axis| PslgFault::NotFinite(NotFinite { point, axis, value: p[axis] }))
}

impl Names {
    fn segment(&self, segment: u32) -> usize {
        self.segments[segment as usize]
    }

    /// The first input point of a site.
    fn point(&self, pslg: &Pslg, site: u32) -> usize {
        self.points[pslg.sites.input_of()[site as usize] as usize]
    }

    /// Every crossing, in terms of the input.
    pub(super) fn crossings(&self, pslg: &Pslg, planar: Planar) -> Vec<PslgFault> {
        let mut crossings = pslg.crossings(planar);
        for crossing in &mut crossings {
            crossing.segments = crossing.segments.map(|segment| {
                u32::try_from(self.segment(segment)).expect("segments are fewer than ids")
            });
        }
        crossings.into_iter().map(PslgFault::Crossing).collect()
    }

    /// Everything that noding has repaired.
    pub(super) fn repaired(&self, pslg: &Pslg) -> Vec<PslgFault> {
        let at = |site: u32| pslg.sites.points()[site as usize];
        let mut faults = Vec::new();
        for (place, &site) in pslg.sites.site_of().iter().enumerate() {
            let (point, first) = (self.points[place], self.point(pslg, site));
            if point != first {
                faults.push(PslgFault::DuplicatePoint { point, first, at: at(site) });
            }
        }
        faults.extend(pslg.dropped.iter().map(|&segment| PslgFault::ZeroLength {
            segment: self.segment(segment),
            at: at(pslg.segments[segment as usize][0]),
        }));
        for (segment, chain) in (0u32..).zip(pslg.chains.iter()) {
            let mut site = pslg.segments[segment as usize][0];
            for &piece in chain.iter().take(chain.len().saturating_sub(1)) {
                let [low, high] = pslg.subsegments[piece as usize];
                site = if site == low { high } else { low };
                let point = self.point(pslg, site);
                let segment = self.segment(segment);
                faults.push(PslgFault::Junction { segment, point, at: at(site) });
            }
        }
        faults.extend(self.overlaps(pslg));
        faults
    }

    fn overlaps(&self, pslg: &Pslg) -> Vec<PslgFault> {
        let mut pairs: Vec<([u32; 2], usize)> = Vec::new();
        for (piece, parents) in pslg.parents().iter().enumerate() {
            pairs.extend(parents.windows(2).map(|pair| ([pair[0], pair[1]], piece)));
        }
        pairs.sort_unstable();
        pairs.dedup_by_key(|(pair, _)| *pair);
        let overlap = |([s, t], piece): ([u32; 2], usize)| {
            let [[a, b], other] = [s, t].map(|segment| pslg.segments[segment as usize]);
            let same = [a, b] == other || [b, a] == other;
            let ends = if same { [a, b] } else { pslg.subsegments[piece] };
            PslgFault::Overlap {
                segments: [s, t].map(|segment| self.segment(segment)),
                piece: ends.map(|site| pslg.sites.points()[site as usize]),
                same,
            }
        };
        pairs.into_iter().map(overlap).collect()
    }
}
