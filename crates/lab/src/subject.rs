//! A validated input: what an algorithm is run on, and in what terms its result is told.

use std::num::NonZeroUsize;

use delone_formats::Document;
use delone_sites::{Arrangement, Noded, Pslg, PslgError, Sites, Snapped, WeightedSites};
use delone_workloads::{Input, Points};

use crate::failure::Failure;

/// Validated sites, with the document that they come from.
pub(crate) struct Subject {
    pub(crate) document: Document,
    pub(crate) body: Body,
}

/// What there is to triangulate.
pub(crate) enum Body {
    /// Points of the plane, without segments.
    Plane(Sites<2>),
    /// Points of space.
    Space(Sites<3>),
    /// Points of the plane with weights.
    WeightedPlane(WeightedSites<2>),
    /// Points of space with weights.
    WeightedSpace(WeightedSites<3>),
    /// Points and segments of the plane.
    Graph(Pslg),
    /// Points and segments of the plane that may cross, cut there.
    Crossed(Box<Arrangement>),
}

/// Evaluates `$answer` with the sites of any body, named `$sites`.
macro_rules! with_sites {
    ($body:expr, $sites:ident => $answer:expr) => {
        match $body {
            Body::Plane($sites) => $answer,
            Body::Space($sites) => $answer,
            Body::WeightedPlane(weighted) => {
                let $sites = weighted.sites();
                $answer
            }
            Body::WeightedSpace(weighted) => {
                let $sites = weighted.sites();
                $answer
            }
            Body::Graph(pslg) => {
                let $sites = pslg.sites();
                $answer
            }
            Body::Crossed(graph) => {
                let $sites = graph.sites();
                $answer
            }
        }
    };
}

impl Subject {
    /// Takes points and, in the plane, segments if there are any.
    pub(crate) fn new(document: Document) -> Result<Self, Failure> {
        if document.dimension == 2 && !document.segments.is_empty() {
            return Self::graph(document);
        }
        Self::points(document)
    }

    /// Takes points alone, with their weights if they have any.
    pub(crate) fn points(document: Document) -> Result<Self, Failure> {
        Self::points_in_parallel(document, NonZeroUsize::MIN)
    }

    /// The same on up to so many threads.
    pub(crate) fn points_in_parallel(
        document: Document,
        threads: NonZeroUsize,
    ) -> Result<Self, Failure> {
        let body = if document.dimension == 3 {
            let points = document.points_3d().map_err(Failure::input)?;
            sites_body(&document, points, threads, Body::Space, Body::WeightedSpace)?
        } else {
            let points = document.points_2d().map_err(Failure::input)?;
            sites_body(&document, points, threads, Body::Plane, Body::WeightedPlane)?
        };
        Ok(Self { document, body })
    }

    /// Takes points and segments of the plane.
    pub(crate) fn graph(document: Document) -> Result<Self, Failure> {
        Self::noded(document, Pslg::new, Body::Graph)
    }

    /// Takes points and segments of the plane that need no repair.
    pub(crate) fn strict(document: Document) -> Result<Self, Failure> {
        Self::noded(document, Pslg::strict, Body::Graph)
    }

    /// Takes points and segments of the plane that may cross.
    pub(crate) fn crossed(document: Document) -> Result<Self, Failure> {
        Self::noded(document, Arrangement::new, |graph| Body::Crossed(Box::new(graph)))
    }

    /// Takes points and segments of the plane that may cross, and cuts them at doubles: the document is then that of the pieces.
    pub(crate) fn snapped(mut document: Document) -> Result<Self, Failure> {
        let (points, segments) = lists(&document)?;
        let snapped = Snapped::new(&points, &segments, SNAPPING_ROUNDS)
            .map_err(|error| refusal(&document, &error.to_string()))?;
        if !snapped.is_settled {
            return Err(Failure::Limit(format!(
                "{}: rounded crossings still made new ones after {SNAPPING_ROUNDS} rounds",
                document.name
            )));
        }
        take_pieces(&mut document, &snapped);
        Self::graph(document)
    }

    /// Makes the edges of the hull segments, of a graph.
    pub(crate) fn take_hull(&mut self) -> Result<(), Failure> {
        let Body::Graph(pslg) = &self.body else { return Ok(()) };
        let (names, mut document) = (pslg.names(), self.document.clone());
        let bare = bare_hull(pslg);
        document.segments.extend(bare.iter().map(|ends| ends.map(|v| names[v as usize])));
        if !document.segment_markers.is_empty() {
            document.segment_markers.resize(document.segments.len(), 0);
        }
        if !bare.is_empty() {
            document.notes.push(format!("edges of the hull that became segments: {}", bare.len()));
        }
        *self = Self::graph(document)?;
        Ok(())
    }

    fn noded<G>(
        document: Document,
        make: impl FnOnce(&[[f64; 2]], &[[usize; 2]]) -> Result<G, PslgError>,
        body: impl FnOnce(G) -> Body,
    ) -> Result<Self, Failure> {
        let (points, segments) = lists(&document)?;
        let graph = make(&points, &segments);
        let graph = graph.map_err(|error| refusal(&document, &error.to_string()))?;
        Ok(Self { body: body(graph), document })
    }

    /// An input to be drawn as it is; it is not validated, and nothing may be run on it.
    pub(crate) fn unchecked(document: Document) -> Self {
        let nothing = Sites::new(&[]).expect("no points are valid points");
        Self { document, body: Body::Plane(nothing) }
    }

    /// A generated input.
    pub(crate) fn generated(name: &str, input: &Input) -> Result<Self, Failure> {
        Self::new(document_of(name, input))
    }

    pub(crate) fn name(&self) -> &str {
        &self.document.name
    }

    pub(crate) fn site_count(&self) -> usize {
        with_sites!(&self.body, sites => sites.len())
    }

    pub(crate) fn duplicate_count(&self) -> usize {
        with_sites!(&self.body, sites => sites.duplicate_count())
    }

    /// Sites, and crossings that became vertices.
    pub(crate) fn vertex_count(&self) -> usize {
        self.site_count() + self.added().len()
    }

    /// The positions, rounded, of the vertices that are no input points.
    pub(crate) fn added(&self) -> &[[f64; 2]] {
        match &self.body {
            Body::Crossed(graph) => &graph.positions()[graph.sites().len()..],
            _ => &[],
        }
    }

    /// The number of each vertex in a list of all input points followed by the vertices that are none. A site stands for
    /// the first input point at its position; with weights, for the heaviest.
    pub(crate) fn names(&self) -> Vec<u32> {
        match &self.body {
            Body::Plane(sites) => sites.input_of().to_vec(),
            Body::Space(sites) => sites.input_of().to_vec(),
            Body::WeightedPlane(sites) => sites.input_of().to_vec(),
            Body::WeightedSpace(sites) => sites.input_of().to_vec(),
            Body::Graph(pslg) => pslg.names(),
            Body::Crossed(graph) => graph.names(),
        }
    }
}

/// The edges of the hull that are no segments, as pairs of sites.
fn bare_hull(pslg: &Pslg) -> Vec<[u32; 2]> {
    let cdt = delone_cdt::cavity(pslg, &delone_delaunay::Options::default(), &mut ());
    let mesh = cdt.mesh();
    if mesh.dimension() != Some(2) {
        return Vec::new();
    }
    let edges = mesh.ghost_cells().flat_map(|cell| mesh.facets(cell));
    let bare = edges.filter(|&h| !mesh.is_ghost(mesh.twin(h).cell()) && !cdt.is_constrained(h));
    let site = |v: delone_mesh::VertexId| u32::try_from(v.index()).expect("sites have 32-bit ids");
    bare.map(|h| [mesh.origin(h), mesh.destination(h)].map(site)).collect()
}

/// Points and segments of the plane.
pub(crate) type Lists = (Vec<[f64; 2]>, Vec<[usize; 2]>);

pub(crate) fn lists(document: &Document) -> Result<Lists, Failure> {
    let points = document.points_2d().map_err(Failure::input)?.to_vec();
    Ok((points, document.segments.iter().map(|ends| ends.map(|end| end as usize)).collect()))
}

/// Rounds of cutting and rounding before giving up.
const SNAPPING_ROUNDS: usize = 100;

/// Puts snapped pieces in place of the segments; they keep the markers of these.
fn take_pieces(document: &mut Document, snapped: &Snapped) {
    let before = document.points.len() / 2;
    let added = snapped.points.len() - before;
    if added > 0 {
        let (rounds, s) = (snapped.rounds, if snapped.rounds == 1 { "" } else { "s" });
        document.notes.push(format!("{added} vertices at crossings, rounded in {rounds} round{s}"));
    }
    document.points.extend(snapped.points[before..].as_flattened());
    let attributes = document.attributes.len() + added * document.attributes_per_point;
    document.attributes.resize(attributes, 0.0);
    if !document.point_markers.is_empty() {
        document.point_markers.resize(before + added, 0);
    }
    if let Some(weights) = &mut document.weights {
        weights.resize(before + added, 0.0);
    }
    let id = |end: usize| u32::try_from(end).expect("points have 32-bit ids");
    document.segments = snapped.segments.iter().map(|ends| ends.map(id)).collect();
    if !document.segment_markers.is_empty() {
        let markers = &document.segment_markers;
        let marker = |&origin: &u32| markers[origin as usize];
        document.segment_markers = snapped.origins.iter().map(marker).collect();
    }
}

/// Points as sites, with their weights if they have any.
fn sites_body<const D: usize>(
    document: &Document,
    points: &[[f64; D]],
    threads: NonZeroUsize,
    plain: fn(Sites<D>) -> Body,
    weighted: fn(WeightedSites<D>) -> Body,
) -> Result<Body, Failure> {
    match &document.weights {
        None => {
            Sites::new_in_parallel(points, threads).map(plain).map_err(|error| error.to_string())
        }
        Some(weights) => {
            WeightedSites::new(points, weights).map(weighted).map_err(|error| error.to_string())
        }
    }
    .map_err(|message| refusal(document, &message))
}

/// The document of a generated input.
pub(crate) fn document_of(name: &str, input: &Input) -> Document {
    let mut document = match &input.points {
        Points::Plane(points) => {
            Document { points: points.as_flattened().to_vec(), ..Document::new(2) }
        }
        Points::Space(points) => {
            Document { points: points.as_flattened().to_vec(), ..Document::new(3) }
        }
    };
    name.clone_into(&mut document.name);
    document.segments.clone_from(&input.segments);
    document
}

/// Every violation, under the input's name.
pub(crate) fn refusal(document: &Document, violations: &str) -> Failure {
    let count = violations.lines().count();
    let lines: Vec<String> = violations.lines().map(|line| format!("  {line}")).collect();
    let noun = if count == 1 { "violation" } else { "violations" };
    Failure::input(format!("{}: {count} {noun}\n{}", document.name, lines.join("\n")))
}
