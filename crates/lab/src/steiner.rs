//! Results with Steiner points: as documents, in keys, and what the judge says of them.

use delone_check::{Promise, Verdict};
use delone_conforming::{Conforming, Method, Refined, SteinerPoint};
use delone_formats::Document;
use delone_sites::{Noded, Pslg};
use serde_json::{Map, Value, json};

use crate::engine::{Sizes, sizes_of};
use crate::judge;
use crate::pictures::Drawing;
use crate::subject::{Body, Subject};

/// A result and what it is of.
pub(crate) struct Result<'a> {
    pub(crate) subject: &'a Subject,
    pub(crate) pslg: &'a Pslg,
    pub(crate) conforming: &'a Conforming,
    /// If not all of it is inside.
    pub(crate) inside: Option<&'a Refined>,
}

/// The graph of a subject that is one.
pub(crate) fn graph(subject: &Subject) -> &Pslg {
    match &subject.body {
        Body::Graph(pslg) => pslg,
        _ => unreachable!("the subject was read as a graph"),
    }
}

impl Result<'_> {
    pub(crate) fn sizes(&self) -> Sizes {
        sizes_of(self.conforming.mesh(), self.conforming.kernel().len())
    }

    /// What a method promises, proved: less of what a limit has stopped.
    pub(crate) fn verdict(&self, method: &Method) -> Verdict {
        self.verdict_on(delone_laws::judge::promise(method, self.conforming))
    }

    fn verdict_on(&self, promise: Promise) -> Verdict {
        judge::conforming(self.pslg, self.conforming, promise)
    }

    /// That it is constrained Delaunay; and if nothing stopped it, that angles inside are at least the promised one but where small
    /// input angles are.
    pub(crate) fn verdict_on_angles(&self, refined: &Refined, cosine_square: f64) -> Verdict {
        if !self.conforming.is_complete() || self.conforming.mesh().dimension() != Some(2) {
            return self.verdict_on(Promise::Constrained);
        }
        judge::refined(self.pslg, refined, cosine_square)
    }

    /// How many points there are, and what becomes of them in doubles.
    pub(crate) fn keys(&self) -> Map<String, Value> {
        let Self { pslg, conforming, .. } = self;
        let sites = pslg.sites().len();
        let is_rounded = |v: u32| !conforming.kernel().is_exact_position(v);
        let all = (0u32..).take(conforming.kernel().len());
        let mut keys = Map::new();
        keys.insert("steiner".to_owned(), json!(conforming.kernel().len() - sites));
        keys.insert("complete".to_owned(), json!(conforming.is_complete()));
        keys.insert("rounded_vertices".to_owned(), json!(all.filter(|&v| is_rounded(v)).count()));
        let valid = judge::rounded(conforming.mesh(), conforming.positions());
        keys.insert("rounding_keeps_validity".to_owned(), json!(valid));
        keys
    }

    /// The input with the Steiner points after its own, the cells as faces and the subsegments as segments. A subsegment has
    /// the marker of the first segment that it is part of, and so have the Steiner points on it; their attributes are
    /// interpolated between its ends. Free points have the marker 0 and attributes 0.
    pub(crate) fn document(&self) -> Document {
        let Self { subject, pslg, conforming, inside } = self;
        let mut document = subject.document.clone();
        let (names, sites) = (self.names(), pslg.sites().len());
        document.points.extend(conforming.positions()[sites..].as_flattened());
        let parents = self.first_segments();
        let marker = |subsegment: u32| {
            let segment = parents[subsegment as usize] as usize;
            subject.document.segment_markers.get(segment).copied().unwrap_or(0)
        };
        let named = |ends: &[u32; 2]| ends.map(|v| names[v as usize]);
        document.segments = conforming.constrained_edges().iter().map(named).collect();
        if !document.segment_markers.is_empty() {
            document.segment_markers = conforming.parents().iter().map(|&s| marker(s)).collect();
        }
        self.extend_points(&mut document, marker);
        (document.triangles, document.tets, document.polygons) = Default::default();
        (document.cell_attributes, document.attributes_per_cell) = Default::default();
        if conforming.mesh().dimension() == Some(2) {
            let cells = judge::solid_ids(conforming.mesh());
            let is_inside = conforming.cells().map(|c| inside.is_none_or(|all| all.is_inside(c)));
            let cells =
                cells.as_chunks::<3>().0.iter().zip(is_inside).filter(|&(_, inside)| inside);
            document.triangles = cells.map(|(cell, _)| cell.map(|v| names[v as usize])).collect();
        }
        document
    }

    /// The document as a picture, the Steiner points marked.
    pub(crate) fn drawing(&self, document: &Document) -> Drawing {
        let mut drawing = Drawing::of_document(document);
        let points = (0u32..).take(document.point_count());
        drawing.marked = points.skip(self.subject.document.point_count()).collect();
        drawing
    }

    /// Markers and attributes of the Steiner points.
    fn extend_points(&self, document: &mut Document, marker: impl Fn(u32) -> i64) {
        let input_of = self.pslg.sites().input_of();
        let per = document.attributes_per_point;
        let has_attributes = !document.attributes.is_empty();
        for steiner in self.conforming.steiner_points() {
            let on = match steiner {
                SteinerPoint::On { subsegment, ends, t } => Some((*subsegment, *ends, t.to_f64())),
                SteinerPoint::Free | SteinerPoint::FreeExactly { .. } => None,
            };
            if !document.point_markers.is_empty() {
                document.point_markers.push(on.map_or(0, |(subsegment, ..)| marker(subsegment)));
            }
            for i in (0..per).filter(|_| has_attributes) {
                let of =
                    |site: u32| document.attributes[input_of[site as usize] as usize * per + i];
                let value = on.map_or(0.0, |(_, [a, b], t)| of(a) * (1.0 - t) + of(b) * t);
                document.attributes.push(value);
            }
        }
    }

    /// The number of each vertex in the document's list of points.
    fn names(&self) -> Vec<u32> {
        let points = u32::try_from(self.subject.document.point_count()).expect("ids of 32 bits");
        let steiner = (points..).take(self.conforming.kernel().len() - self.pslg.sites().len());
        self.pslg.names().into_iter().chain(steiner).collect()
    }

    /// For each subsegment the first input segment that runs over it.
    pub(crate) fn first_segments(&self) -> Vec<u32> {
        let mut first = vec![u32::MAX; self.pslg.subsegments().len()];
        for (segment, chain) in (0u32..).zip(self.pslg.chains().iter()) {
            for &subsegment in chain {
                first[subsegment as usize] = first[subsegment as usize].min(segment);
            }
        }
        first
    }
}
