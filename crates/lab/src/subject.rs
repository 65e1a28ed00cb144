//! A validated input: what an algorithm is run on, and in what terms its result is told.

use delone_formats::Document;
use delone_sites::{Arrangement, Noded, Pslg, PslgError, Sites};
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
    /// Points and segments of the plane.
    Graph(Pslg),
    /// Points and segments of the plane that may cross, cut there.
    Crossed(Arrangement),
}

impl Subject {
    /// Takes points and, in the plane, segments if there are any.
    pub(crate) fn new(document: Document) -> Result<Self, Failure> {
        if document.dimension == 2 && !document.segments.is_empty() {
            return Self::graph(document);
        }
        Self::points(document)
    }

    /// Takes points alone.
    pub(crate) fn points(document: Document) -> Result<Self, Failure> {
        let refuse = |message: String| refusal(&document, &message);
        let body = if document.dimension == 3 {
            let points = document.points_3d().map_err(Failure::input)?;
            Body::Space(Sites::new(&points).map_err(|error| refuse(error.to_string()))?)
        } else {
            let points = document.points_2d().map_err(Failure::input)?;
            Body::Plane(Sites::new(&points).map_err(|error| refuse(error.to_string()))?)
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
        Self::noded(document, Arrangement::new, Body::Crossed)
    }

    fn noded<G>(
        document: Document,
        make: impl FnOnce(&[[f64; 2]], &[[usize; 2]]) -> Result<G, PslgError>,
        body: impl FnOnce(G) -> Body,
    ) -> Result<Self, Failure> {
        let points = document.points_2d().map_err(Failure::input)?;
        let segments: Vec<[usize; 2]> =
            document.segments.iter().map(|ends| ends.map(|end| end as usize)).collect();
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
        match &self.body {
            Body::Plane(sites) => sites.len(),
            Body::Space(sites) => sites.len(),
            Body::Graph(pslg) => pslg.sites().len(),
            Body::Crossed(graph) => graph.sites().len(),
        }
    }

    pub(crate) fn duplicate_count(&self) -> usize {
        match &self.body {
            Body::Plane(sites) => sites.duplicate_count(),
            Body::Space(sites) => sites.duplicate_count(),
            Body::Graph(pslg) => pslg.sites().duplicate_count(),
            Body::Crossed(graph) => graph.sites().duplicate_count(),
        }
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

    /// The number of each vertex in a list of all input points followed by the vertices that are none.
    pub(crate) fn names(&self) -> Vec<u32> {
        match &self.body {
            Body::Plane(sites) => sites.input_of().to_vec(),
            Body::Space(sites) => sites.input_of().to_vec(),
            Body::Graph(pslg) => pslg.names(),
            Body::Crossed(graph) => graph.names(),
        }
    }
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
