//! `delone triangulate2d`: a soup of boundary edges, holes unknown, to triangles inside, as `(V, [EV, FV])`.

mod explain;

use std::path::Path;

use delone_cdt::{Domain, Interior};
use delone_draw::Style;
use delone_formats::{Document, Format};
use delone_lar::{Chain, Coefficients, Complex};
use serde_json::{Value, json};

use crate::cli;
use crate::engine::{self, Triangulation};
use crate::failure::Failure;
use crate::pictures::Drawing;
use crate::progress::Busy;
use crate::result::describe;
use crate::subject::{Body, Subject};
use crate::{fill, input, output};

pub(crate) fn triangulate2d(arguments: &cli::Triangulate2d) -> Result<(), Failure> {
    for path in &arguments.outputs {
        output::format_to_write(path)?;
    }
    let pictures = arguments.svg.iter().chain(&arguments.operators);
    output::check_paths(arguments.outputs.iter().chain(pictures).map(std::path::PathBuf::as_path))?;
    let busy = Busy::new(arguments.voice.quiet, "reading");
    let document = input::read(&arguments.source.input, arguments.source.format.as_deref())?;
    let subject = match arguments.crossings {
        cli::Crossings::Split => Subject::crossed(document)?,
        cli::Crossings::Snap => Subject::snapped(document)?,
        cli::Crossings::Reject => Subject::graph(document)?,
    };
    busy.at("triangulating");
    let name = engine::choose(&subject, None)?;
    let built = engine::run(&subject, name, &delone_delaunay::Options::default(), None);
    let triangulation = built.triangulation;
    let domain = fill::domain(&triangulation, &subject, arguments.fill)?;
    let soup = Soup::of(&subject, &triangulation, domain)?;
    let mut notes = subject.document.notes.clone();
    for path in &arguments.outputs {
        let lost = output::document(path, &soup.document(output::format_to_write(path)?))?;
        notes.extend(lost.into_iter().map(|lost| format!("{}: {lost}", path.display())));
    }
    if let Some(name) = &arguments.operators {
        soup.write_operators(name)?;
    }
    if let Some(path) = &arguments.svg {
        output::text(path, &soup.svg(arguments.numbered))?;
    }
    if let (Some(folder), Triangulation::Constrained(cdt)) = (&arguments.explain, &triangulation) {
        explain::explain(&soup, cdt, folder)?;
    }
    let object = soup.json(&triangulation, arguments.fill);
    drop(busy);
    if arguments.voice.json {
        println!("{object}");
    } else {
        soup.tell(&object);
    }
    if !arguments.voice.quiet {
        notes.iter().for_each(|note| eprintln!("note: {note}"));
    }
    if object["certificate"]["holds"] == json!(false) {
        return Err(Failure::Difference(None));
    }
    Ok(())
}

/// A soup with its inside.
struct Soup<'s> {
    subject: &'s Subject,
    interior: Interior,
    /// The vertices: the input's, then crossings, rounded.
    vertices: Vec<[f64; 2]>,
    /// The complex of the inside.
    complex: Complex<2>,
}

impl<'s> Soup<'s> {
    fn of(
        subject: &'s Subject,
        triangulation: &Triangulation,
        domain: Domain,
    ) -> Result<Self, Failure> {
        let interior = match (triangulation, &subject.body) {
            (Triangulation::Constrained(cdt), Body::Graph(pslg)) => Interior::of(cdt, pslg, domain),
            (Triangulation::Constrained(cdt), Body::Crossed(graph)) => {
                Interior::of(cdt, &**graph, domain)
            }
            _ => unreachable!("a soup is a graph"),
        };
        let mut vertices = subject.document.points_2d().map_err(Failure::input)?.to_vec();
        vertices.extend(subject.added());
        let complex = used(&vertices, &interior.fv);
        Ok(Self { subject, interior, vertices, complex })
    }

    /// `.poly` holds the input and a point in each hole; all others hold the inside.
    fn document(&self, format: Format) -> Document {
        let mut document = self.subject.document.clone();
        document.holes.clear();
        let domain = &self.interior.domain;
        if format == Format::Poly {
            let holes = domain.holes().filter_map(|hole| domain.interior_point(hole));
            document.holes = holes.flatten().collect();
            return document;
        }
        document.points.extend(self.subject.added().as_flattened());
        document.segments.clone_from(&self.interior.ev);
        document.segment_markers.clear();
        document.triangles.clone_from(&self.interior.fv);
        document.polygons.clear();
        document
    }

    fn write_operators(&self, name: &Path) -> Result<(), Failure> {
        for k in 1..=2 {
            let path = name.with_added_extension(format!("{k}.mtx"));
            let mut text = Vec::new();
            self.complex.write_matrix_market(k, &mut text).map_err(Failure::input)?;
            output::text(&path, &String::from_utf8_lossy(&text))?;
        }
        Ok(())
    }

    fn svg(&self, numbered: bool) -> String {
        let mut document = self.document(Format::Lar);
        let boundary = self.interior.ev.iter().zip(&self.interior.kinds);
        let boundary = boundary.filter(|(_, kind)| kind.is_some()).map(|(&edge, _)| edge);
        document.segments = boundary.collect();
        let mut drawing = Drawing::of_document(&document);
        drawing.classes.clone_from(&self.interior.regions);
        drawing.svg(&Style { title: describe(self.subject), numbered, ..Style::default() })
    }

    /// Whether the boundary of the chain of triangles, by the operators of the complex, is the edges that have inside on one
    /// side only.
    fn certificate(&self) -> bool {
        let area = Chain::new(2, self.complex.orientations(2).into_iter().enumerate());
        let boundary = area.boundary(&self.complex);
        let found: Vec<&[u32]> =
            boundary.terms().map(|(edge, _)| self.complex.cells(1)[edge].as_slice()).collect();
        let edges = self.interior.ev.iter().zip(&self.interior.kinds);
        use delone_cdt::EdgeKind::{Hole, Shell};
        let bounds = edges.filter(|(_, kind)| matches!(kind, Some(Shell | Hole)));
        let is_named = boundary.terms().all(|(_, coefficient)| coefficient.abs() == 1);
        is_named && found.into_iter().eq(bounds.map(|(edge, _)| edge.as_slice()))
    }

    fn json(&self, triangulation: &Triangulation, rule: cli::Fill) -> Value {
        let domain = &self.interior.domain;
        let mut object = json!({
            "schema": "delone.triangulate2d/1",
            "input": crate::result::input(self.subject),
            "fill": clap::ValueEnum::to_possible_value(&rule).map(|value| value.get_name().to_owned()),
            "vertices": self.vertices.len(),
            "edges": self.interior.ev.len(),
            "triangles": self.interior.fv.len(),
            "euler": self.complex.euler(),
            "betti": self.complex.betti(Coefficients::Two),
            "holes": domain.holes().map(|hole| domain.interior_point(hole)).collect::<Vec<_>>(),
            "certificate": {
                "claim": "the boundary of the chain of triangles is the shell and hole edges",
                "holds": self.certificate(),
            },
        });
        for (key, value) in fill::keys(domain) {
            object[key] = value;
        }
        for (key, value) in fill::crossing_keys(triangulation, self.subject) {
            object[key] = value;
        }
        object
    }

    fn tell(&self, object: &Value) {
        println!("{:12} {}", "input", describe(self.subject));
        for key in ["fill", "edges", "triangles", "steiner", "area_exact", "euler", "betti"] {
            let text = object[key].as_str().map_or_else(|| object[key].to_string(), str::to_owned);
            println!("{key:12} {text}");
        }
        println!("{:12} {}", "holes", object["holes"].as_array().map_or(0, Vec::len));
        println!("{:12} {}", "edge kinds", object["edge_kinds"]);
        println!("{:12} holds: {}", "certificate", object["certificate"]["holds"]);
    }
}

/// The complex of triangles alone: vertices that none of them has are no pieces of it.
fn used(vertices: &[[f64; 2]], triangles: &[[u32; 3]]) -> Complex<2> {
    let mut ids: Vec<u32> = triangles.as_flattened().to_vec();
    ids.sort_unstable();
    ids.dedup();
    let place = |v: u32| {
        let place = ids.binary_search(&v).expect("the vertices of triangles are used");
        u32::try_from(place).expect("vertices are fewer than ids")
    };
    let renamed: Vec<[u32; 3]> = triangles.iter().map(|t| t.map(place)).collect();
    let cells: Vec<&[u32]> = renamed.iter().map(<[u32; 3]>::as_slice).collect();
    let kept = ids.iter().map(|&v| vertices[v as usize]).collect();
    Complex::closure(kept, &cells).expect("triangles are simplices over their vertices")
}
