//! Pictures of subjects and their triangulations.

use delone_delaunay::PowerDiagram;
use delone_draw::{Picture, Solid, Style};
use delone_formats::Document;

use crate::engine::Triangulation;
use crate::subject::{Body, Subject};

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
    /// Regions of Voronoi's or the power diagram.
    regions: Vec<Vec<[f64; 2]>>,
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
            regions: Vec::new(),
        }
    }

    /// Adds Voronoi's diagram of sites in the plane, or with weights the power diagram, in a window a little larger than
    /// their box. Sites in line have none.
    pub(crate) fn add_regions(&mut self, subject: &Subject, triangulation: &Triangulation) {
        let diagram = match (triangulation, &subject.body) {
            (Triangulation::Plane(result), Body::Plane(sites)) => {
                PowerDiagram::of_delaunay(result, sites)
            }
            (Triangulation::RegularPlane(result), Body::WeightedPlane(sites)) => {
                PowerDiagram::of_regular(result, sites)
            }
            _ => None,
        };
        let Some(diagram) = diagram else { return };
        let window = self.window();
        let polygons = (0u32..).take(subject.site_count()).map(|s| diagram.polygon(s, window));
        self.regions = polygons.filter(|polygon| polygon.len() > 2).collect();
    }

    /// The points' box, and a twentieth of its extents around it.
    fn window(&self) -> [[f64; 2]; 2] {
        let mut window = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for axis in 0..2 {
            let [low, high] = window.each_mut().map(|corner| &mut corner[axis]);
            for point in &self.points {
                (*low, *high) = (low.min(point[axis]), high.max(point[axis]));
            }
            let margin = *high / 20.0 - *low / 20.0; // an extent may overflow
            *low = (*low - margin).max(f64::MIN);
            *high = (*high + margin).min(f64::MAX);
        }
        window
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
            regions: &self.regions,
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
