//! Pictures of subjects and their triangulations.

use delone_draw::{Picture, Solid, Style};
use delone_formats::Document;

use crate::engine::Triangulation;
use crate::subject::Subject;

/// What a picture is drawn from, owned.
pub(crate) struct Drawing {
    points: Vec<[f64; 2]>,
    space: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    tets: Vec<[u32; 4]>,
    segments: Vec<[u32; 2]>,
    /// The colour of each triangle of the plane, or none.
    pub(crate) classes: Vec<u32>,
    /// Faces of a subject in space.
    facets: Vec<[u32; 3]>,
}

impl Drawing {
    /// The input alone, or with its triangulation.
    pub(crate) fn of(subject: &Subject, triangulation: Option<&Triangulation>) -> Self {
        let document = triangulation.map(|result| result.document(subject));
        Self::of_document(document.as_ref().unwrap_or(&subject.document))
    }

    /// A document as it is.
    pub(crate) fn of_document(document: &Document) -> Self {
        let is_space = document.dimension == 3;
        Self {
            points: if is_space { Vec::new() } else { document.points.as_chunks::<2>().0.to_vec() },
            space: if is_space { document.points.as_chunks::<3>().0.to_vec() } else { Vec::new() },
            triangles: if is_space { Vec::new() } else { document.triangles.clone() },
            facets: if is_space { document.triangles.clone() } else { Vec::new() },
            tets: document.tets.clone(),
            segments: document.segments.clone(),
            classes: Vec::new(),
        }
    }

    pub(crate) fn is_space(&self) -> bool {
        !self.space.is_empty()
    }

    pub(crate) fn plane(&self) -> Picture<'_> {
        Picture {
            points: &self.points,
            triangles: &self.triangles,
            segments: &self.segments,
            classes: &self.classes,
            ..Picture::default()
        }
    }

    /// As SVG.
    pub(crate) fn svg(&self, style: &Style) -> String {
        if self.is_space() {
            let solid = Solid {
                points: &self.space,
                tets: &self.tets,
                facets: &self.facets,
                title: &style.title,
            };
            solid.svg()
        } else {
            self.plane().svg(style)
        }
    }
}
