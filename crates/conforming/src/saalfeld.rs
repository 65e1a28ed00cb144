//! Conforming by protection: each segment is covered by disks that avoid all else, before any triangle is looked at.
//!
//! ```text
//!        /              About a site z where segments meet at less than a right angle, all of them are cut at one radius,
//!      .x.              a power of two at most a third of z's distance from what is not incident to it. What remains of a
//!     /   \             segment is halved until the diametral disk of each part avoids all other segments and sites.
//!    z--x--()-()--
//! ```
//!
//! **Paper.** \[Saa91\] shows that finitely many such disks do, by compactness; the radii and the halving are ours. It adapts to
//! no triangulation, and takes of the order of 1 / a points where segments meet at a small angle a: to compare with, not to use.
//! **In, Out.** The pieces of a [`Live`] CDT; the same, split.
//! **Invariants.** 1. The disk of a half is inside the disk of the whole: what avoids that avoids this. 2. Doubles steer: what
//! they get wrong in the last bits is found by [`crate::Encroached`], which runs afterwards.
//! **Cost.** What is near a segment or a site is found in an R-tree of all, what is near a half among what is near the whole.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | right or obtuse angles | no cut at the site: the disks touch there | `protection_of_a_square_and_a_cross` |
//! | more cuts of a segment than it may take | only those about its ends | `protection_leaves_slivers_to_the_adaptive_method` |
//! | coordinates whose squares overflow, or differences do | all are scaled by a power of two | `protection_over_the_whole_range` |
//! | distances whose squares underflow | a radius is at most a third of its segments | `protection_over_the_whole_range` |
//! | a million cuts of one segment | the probe is asked before each | `protection_stops_between_any_two_cuts` |

use delone_mesh::VertexId;
use delone_predicates::{Dyadic, Metric, Sign};
use delone_probe::Probe;
use rstar::{AABB, PointDistance, RTree, RTreeObject};

use crate::apexes::Apexes;
use crate::conform::ConformOptions;
use crate::live::{Live, PieceId};
use crate::ratio::{log4, root};

/// Precision where no small angle asks for more.
const BITS: u32 = 52;

/// Parts shorter than this fraction of their segment are left alone.
const PART_MIN: f64 = 1e-13;

/// Cuts all segments. Whether that was done within the limits.
pub(crate) fn protect(
    live: &mut Live,
    apexes: &Apexes,
    options: &ConformOptions,
    probe: &mut impl Probe,
) -> bool {
    let scene = Scene::new(live, apexes);
    let mut vertices = live.sites;
    for segment in 0..live.segments.len() {
        let room = options.limits.vertices_max.saturating_sub(vertices);
        let cuts = match scene.cuts(live, segment, options.cuts_max.min(room)) {
            Some(cuts) => cuts,
            None if room < options.cuts_max => return false,
            None => scene.about_ends(live, segment).into_iter().flatten().collect(),
        };
        if cuts.len() > room {
            return false;
        }
        vertices += cuts.len();
        // Before the first split, pieces and segments have the same numbers.
        let mut piece = PieceId::try_from(segment).expect("segments are fewer than ids");
        for t in cuts {
            if !probe.goes_on() {
                return false;
            }
            live.split_piece(piece, t.into(), probe);
            piece = PieceId::try_from(live.pieces.len() - 1).expect("pieces are fewer than ids");
        }
    }
    true
}

/// What disks avoid, in doubles, and the radii about sites.
struct Scene {
    /// The sites over 2^scale: no coordinate is more than 1, so that nothing overflows.
    points: Vec<[f64; 2]>,
    scale: i64,
    segments: Vec<[u32; 2]>,
    /// The square of the radius at which the segments of a site are cut.
    radii: Vec<Option<Dyadic>>,
    bits: Vec<u32>,
    /// All segments and sites.
    features: RTree<Feature>,
}

/// A segment or a site, and where its ends are.
#[derive(Clone, Copy)]
struct Feature {
    which: Which,
    ends: [[f64; 2]; 2],
}

/// By index.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Which {
    Segment(usize),
    Site(u32),
}

impl Feature {
    fn distance(&self, p: [f64; 2]) -> f64 {
        let [a, b] = self.ends;
        let (along, off) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
        let square = along[0] * along[0] + along[1] * along[1];
        let t = (off[0] * along[0] + off[1] * along[1]) / square;
        let t = if t.is_nan() { 0.0 } else { t.clamp(0.0, 1.0) };
        (off[0] - t * along[0]).hypot(off[1] - t * along[1])
    }
}

impl RTreeObject for Feature {
    type Envelope = AABB<[f64; 2]>;

    fn envelope(&self) -> Self::Envelope {
        AABB::from_corners(self.ends[0], self.ends[1])
    }
}

impl PointDistance for Feature {
    fn distance_2(&self, p: &[f64; 2]) -> f64 {
        let distance = self.distance(*p);
        distance * distance
    }
}

impl Scene {
    fn new(live: &Live, apexes: &Apexes) -> Self {
        let points = &live.kernel.positions()[..live.sites];
        let reach = points.as_flattened().iter().fold(0.0f64, |reach, x| reach.max(x.abs()));
        let scale = Dyadic::from(reach).magnitude().map_or(0, |magnitude| magnitude + 1);
        let scaled = |x: f64| Dyadic::from(x).scaled(-scale).to_f64();
        let points: Vec<[f64; 2]> = points.iter().map(|p| p.map(scaled)).collect();
        let bits = (0..live.sites).map(|v| apexes.bits(VertexId::new(v)).unwrap_or(BITS));
        let at = |v: u32| points[v as usize];
        let sites = (0u32..).zip(&points).map(|(v, &p)| (Which::Site(v), [p; 2]));
        let segments = live.segments.iter().map(|ends| ends.map(at)).enumerate();
        let segments = segments.map(|(segment, ends)| (Which::Segment(segment), ends));
        let features = segments.chain(sites).map(|(which, ends)| Feature { which, ends });
        let mut scene = Self {
            features: RTree::bulk_load(features.collect()),
            points,
            scale,
            segments: live.segments.clone(),
            radii: vec![None; live.sites],
            bits: bits.collect(),
        };
        let mut spokes: Vec<Vec<u32>> = vec![Vec::new(); live.sites];
        for &[a, b] in &live.segments {
            spokes[a as usize].push(b);
            spokes[b as usize].push(a);
        }
        for (site, ends) in (0u32..).zip(&spokes) {
            if has_narrow_angle(live, site, ends) {
                scene.radii[site as usize] = scene.radius(site, ends);
            }
        }
        scene
    }

    /// The square of a power of two that is at most a third of the site's distance from what is not incident to it; in any case
    /// of its segments, to `ends`: the tree compares squares, which may underflow.
    fn radius(&self, site: u32, ends: &[u32]) -> Option<Dyadic> {
        let z = self.points[site as usize];
        let other = self.features.nearest_neighbor_iter(&z).find(|feature| match feature.which {
            Which::Site(other) => other != site,
            Which::Segment(s) => !self.segments[s].contains(&site),
        });
        let at = |v: u32| Feature { which: Which::Site(v), ends: [self.points[v as usize]; 2] };
        let near = ends.iter().map(|&v| at(v)).chain(other.copied());
        let third = near.map(|near| near.distance(z)).fold(f64::INFINITY, f64::min) / 3.0;
        let third = Dyadic::from(Some(third).filter(|d| d.is_normal())?).scaled(self.scale);
        Some(Dyadic::from(1).scaled(2 * log4(&(&third * &third))))
    }

    /// The parameters of the cuts of a segment about its ends.
    fn about_ends(&self, live: &Live, segment: usize) -> [Option<Dyadic>; 2] {
        let square =
            live.squared_length(u32::try_from(segment).expect("segments are fewer than ids"));
        let [first, last] = self.segments[segment].map(|site| {
            let radius = self.radii[site as usize].as_ref()?;
            Some(root(radius, &square, self.bits[site as usize]))
        });
        [first, last.map(|t| Dyadic::from(1) - t)]
    }

    /// The parameters at which a segment is cut, in increasing order; `None` if there are more than `most`.
    fn cuts(&self, live: &Live, segment: usize, most: usize) -> Option<Vec<Dyadic>> {
        let [a, b] = self.segments[segment];
        let [first, last] = self.about_ends(live, segment);
        let mut cuts: Vec<Dyadic> = first.iter().chain(&last).cloned().collect();
        let touched = [(a, &first), (b, &last)].map(|(site, cut)| cut.is_none().then_some(site));
        let ends = [first.unwrap_or(Dyadic::ZERO), last.unwrap_or(Dyadic::from(1))];
        let (centre, radius) = self.disk(segment, &ends);
        let [low, high] = [-radius, radius].map(|r| centre.map(|x| x + r));
        let near = self.features.locate_in_envelope_intersecting(&AABB::from_corners(low, high));
        let near = near.copied().filter(|feature| match feature.which {
            Which::Site(site) => site != a && site != b,
            Which::Segment(s) => s != segment,
        });
        let near: Vec<Feature> = near.collect();
        let mut parts = vec![(ends, touched, near)];
        while let Some((ends, touched, near)) = parts.pop() {
            let near = self.within_disk(segment, &ends, touched, &near);
            if near.is_empty() {
                continue;
            }
            if cuts.len() >= most {
                return None;
            }
            let [t0, t1] = ends;
            let middle = (t0.clone() + &t1).half();
            cuts.push(middle.clone());
            parts.push(([middle.clone(), t1], [None, touched[1]], near.clone()));
            parts.push(([t0, middle], [touched[0], None], near)); // Inv 1
        }
        cuts.sort();
        Some(cuts)
    }

    /// Which of the features are in the diametral disk of a part, but for those that meet it in an end; none if the part is
    /// too short.
    fn within_disk(
        &self,
        segment: usize,
        ends: &[Dyadic; 2],
        touched: [Option<u32>; 2],
        features: &[Feature],
    ) -> Vec<Feature> {
        let [t0, t1] = ends.each_ref().map(Dyadic::to_f64);
        if t1 - t0 < PART_MIN {
            return Vec::new();
        }
        let (centre, radius) = self.disk(segment, ends);
        let meets = |feature: &Feature| match feature.which {
            Which::Site(_) => false,
            Which::Segment(s) => {
                touched.iter().flatten().any(|site| self.segments[s].contains(site))
            }
        };
        let inside = |feature: &Feature| !meets(feature) && feature.distance(centre) <= radius;
        features.iter().copied().filter(inside).collect()
    }

    /// The diametral disk of a part: its centre and radius.
    fn disk(&self, segment: usize, ends: &[Dyadic; 2]) -> ([f64; 2], f64) {
        let [a, b] = self.segments[segment].map(|v| self.points[v as usize]);
        let at = |t: f64| [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
        let [t0, t1] = ends.each_ref().map(Dyadic::to_f64);
        let [p, q] = [at(t0), at(t1)];
        (at(t0.midpoint(t1)), (q[0] - p[0]).hypot(q[1] - p[1]) / 2.0)
    }
}

/// Whether two of the segments from a site to these ends make less than a right angle.
fn has_narrow_angle(live: &Live, site: u32, ends: &[u32]) -> bool {
    let acute =
        |u: u32, w: u32| live.kernel.dot([site, u, site, w].map(|v| v as usize)) == Sign::Positive;
    // Of five directions two are closer than a right angle.
    ends.len() > 4 || ends.iter().enumerate().any(|(i, &u)| ends[..i].iter().any(|&w| acute(u, w)))
}

#[cfg(test)]
mod tests;
