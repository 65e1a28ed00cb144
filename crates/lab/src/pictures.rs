//! Pictures of subjects and their triangulations.

use delone_delaunay::{Options, PowerDiagram};
use delone_draw::{Picture, Scene, Solid, Span, Style};
use delone_formats::Document;
use delone_sites::Sites;

use crate::engine::Triangulation;
use crate::judge;
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
    /// Points to point at.
    pub(crate) marked: Vec<u32>,
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
            marked: Vec::new(),
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
            marked: &self.marked,
            regions: &self.regions,
            ..Picture::default()
        }
    }

    /// As a scene with layers: the input's triangulation, its constraints, its hull, and what is not Delaunay in it.
    pub(crate) fn scene(&self) -> Scene {
        let known = Sites::new(&self.points).map(|sites| delaunay_edges(&sites));
        let forced = known.map_or_else(
            |_| Vec::new(),
            |known| {
                let edges = edges(self.triangles.iter());
                edges.into_iter().filter(|edge| known.binary_search(edge).is_err()).collect()
            },
        );
        let always = |edges: Vec<[u32; 2]>| edges.into_iter().map(Span::always).collect();
        Scene {
            points: self.points.clone(),
            triangles: self.triangles.iter().copied().map(Span::always).collect(),
            constraints: always(self.segments.clone()),
            ghosts: always(outer(&self.triangles)),
            forced: always(forced),
            ..Scene::default()
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

/// The edges of the Delaunay triangulation, by input point, in increasing order.
fn delaunay_edges(sites: &Sites<2>) -> Vec<[u32; 2]> {
    let result = delone_delaunay::delaunay(sites, &Options::default(), &mut ());
    if result.mesh().dimension() != Some(2) {
        return Vec::new();
    }
    let cells = judge::solid_ids(result.mesh());
    let named: Vec<u32> = cells.iter().map(|&site| sites.input_of()[site as usize]).collect();
    edges(named.as_chunks::<3>().0.iter())
}

/// The directed sides of triangles that no other one has the other way: the hull.
pub(crate) fn outer(triangles: &[[u32; 3]]) -> Vec<[u32; 2]> {
    let mut sides: Vec<[u32; 2]> =
        triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
    sides.sort_unstable();
    let is_outer = |[a, b]: &[u32; 2]| sides.binary_search(&[*b, *a]).is_err();
    sides.iter().copied().filter(is_outer).collect()
}

/// The edges of triangles, smaller end first, in increasing order.
pub(crate) fn edges<'t>(triangles: impl Iterator<Item = &'t [u32; 3]>) -> Vec<[u32; 2]> {
    let sides = triangles.flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let mut edges: Vec<[u32; 2]> = sides.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}
