//! `delone alpha`: read, triangulate, filter; then one complex, or a list of the whole filtration.

mod figures;
mod hull;
mod lists;
mod page;

use std::time::Instant;

use delone_alpha::{AlphaFiltration, AlphaParam, Cut, SimplexId};
use delone_delaunay::Fingerprint;
use delone_draw::{Picture, Style};
use delone_formats::Document;
use serde_json::{Value, json};

use crate::cli::{self, Mode};
use crate::engine::{self, Triangulation};
use crate::failure::Failure;
use crate::pictures::Drawing;
use crate::progress::Busy;
use crate::result::{self, grouped};
use crate::subject::{Body, Subject};
use crate::{input, output};

pub(crate) fn alpha(arguments: &cli::Alpha) -> Result<(), Failure> {
    for path in &arguments.outputs {
        output::format_to_write(path)?;
    }
    let files = arguments.outputs.iter().chain(&arguments.svg).chain(&arguments.html);
    output::check_paths(files.map(std::path::PathBuf::as_path))?;
    let is_list =
        arguments.asked.filtration || arguments.asked.signature || arguments.asked.persistence;
    if is_list && !arguments.outputs.is_empty() {
        return Err(Failure::input("-o holds one complex: name a parameter"));
    }
    if arguments.asked.filtration && arguments.svg.is_some() {
        return Err(Failure::input("--svg draws one complex, --signature or --persistence"));
    }
    let busy = Busy::new(arguments.voice.quiet, "reading");
    let start = Instant::now();
    let mut document = input::read(&arguments.source.input, arguments.source.format.as_deref())?;
    input::take_weights(&mut document, arguments.weights.file.as_deref())?;
    let subject = Subject::points(document)?;
    if arguments.html.is_some() && subject.document.dimension != 2 {
        return Err(Failure::input("--html is for the plane, and the input is in space"));
    }
    if arguments.hull && (is_list || !matches!(subject.body, Body::Plane(_))) {
        let message = "--hull is of one complex of points of the plane, without weights";
        return Err(Failure::input(message));
    }
    let read = start.elapsed().as_secs_f64();
    let start = Instant::now();
    busy.at("filtering");
    let name = engine::choose(&subject, None)?;
    let triangulation =
        engine::run(&subject, name, &delone_delaunay::Options::default(), None).triangulation;
    let task =
        Task { arguments, subject: &subject, triangulation: &triangulation, name, read, start };
    match (&subject.body, &triangulation) {
        (Body::Plane(sites), Triangulation::Plane(result)) => {
            task.answer(&AlphaFiltration::of(sites, result), busy)
        }
        (Body::Space(sites), Triangulation::Space(result)) => {
            task.answer(&AlphaFiltration::of(sites, result), busy)
        }
        (Body::WeightedPlane(sites), Triangulation::RegularPlane(result)) => {
            task.answer(&AlphaFiltration::of_regular(sites, result), busy)
        }
        (Body::WeightedSpace(sites), Triangulation::RegularSpace(result)) => {
            task.answer(&AlphaFiltration::of_regular(sites, result), busy)
        }
        _ => unreachable!("points have Delaunay or regular triangulations"),
    }
}

struct Task<'a> {
    arguments: &'a cli::Alpha,
    subject: &'a Subject,
    triangulation: &'a Triangulation,
    name: &'static str,
    /// Seconds.
    read: f64,
    start: Instant,
}

/// The parameter asked for, with the name of its convention.
fn param(asked: &cli::Asked) -> Option<(&'static str, AlphaParam)> {
    let named = [
        ("radius", asked.radius.map(AlphaParam::Radius)),
        ("squared", asked.squared.map(AlphaParam::Squared)),
        ("inverse", asked.inverse.map(AlphaParam::Inverse)),
        ("rank", asked.rank.map(AlphaParam::Rank)),
        ("unit", asked.unit.map(AlphaParam::Unit)),
        ("critical", asked.critical.map(AlphaParam::Critical)),
    ];
    named.into_iter().find_map(|(name, param)| Some((name, param?)))
}

/// The number of a parameter, or the name of a property.
fn value_of(param: AlphaParam) -> Value {
    match param {
        AlphaParam::Radius(x)
        | AlphaParam::Squared(x)
        | AlphaParam::Inverse(x)
        | AlphaParam::Rank(x)
        | AlphaParam::Unit(x) => json!(x),
        other => json!(format!("{other:?}")),
    }
}

impl Task<'_> {
    fn answer<const D: usize>(
        &self,
        filtration: &AlphaFiltration<D>,
        busy: Busy,
    ) -> Result<(), Failure> {
        let build = self.start.elapsed().as_secs_f64();
        let param = param(&self.arguments.asked);
        let cut = match param {
            None => filtration.whole(),
            Some((_, param)) => filtration.cut(param).map_err(Failure::input)?,
        };
        if let Some(path) = &self.arguments.html {
            output::text(path, &page::slider(self, filtration, cut))?;
        }
        drop(busy);
        match param {
            None => lists::tell(self, filtration, build),
            Some((name, param)) => self.complex(filtration, build, name, (param, cut)),
        }
    }

    /// The keys that every result has.
    fn head<const D: usize>(&self, filtration: &AlphaFiltration<D>, build: f64, cut: Cut) -> Value {
        let sizes = self.triangulation.sizes(self.subject);
        let betti = filtration.betti_curves();
        json!({
            "schema": "delone.alpha/1",
            "input": result::input(self.subject),
            "algorithm": self.name,
            "kernel": "adaptive",
            "fingerprint": self.fingerprint(filtration, cut).to_string(),
            "dimension": sizes.dimension,
            "vertices": sizes.vertices,
            "cells": sizes.cells,
            "hull_facets": sizes.hull_facets,
            "seconds": { "read": self.read, "build": build },
            "values": filtration.rank_count(),
            "simplices": filtration.simplex_curves().at(cut),
            "betti": betti.at(cut),
        })
    }

    /// A hash of the sites and of the complex's simplices in their order, by the ranks of sites.
    fn fingerprint<const D: usize>(
        &self,
        filtration: &AlphaFiltration<D>,
        cut: Cut,
    ) -> Fingerprint {
        let mut hash = Fingerprint::new();
        let fixed = self.triangulation.fingerprint(self.subject).to_string();
        fixed.bytes().for_each(|byte| hash.word(byte.into()));
        hash.word(cut.ranks().into());
        hash.word(filtration.rank_count() as u64);
        hash
    }

    fn complex<const D: usize>(
        &self,
        filtration: &AlphaFiltration<D>,
        build: f64,
        name: &str,
        (param, cut): (AlphaParam, Cut),
    ) -> Result<(), Failure> {
        let document = self.document(filtration, cut);
        for path in &self.arguments.outputs {
            output::document(path, &document)?;
        }
        if let Some(path) = &self.arguments.svg {
            let title = format!("alpha complex, {param:?}");
            let style = Style { title, ..Style::default() };
            let drawing = Drawing::of_document(&document);
            let svg = if self.arguments.hull {
                let arcs = hull::arcs(self, param, cut, filtration);
                Picture { arcs: &arcs, segments: &[], ..drawing.plane() }.svg(&style)
            } else {
                drawing.svg(&style)
            };
            output::text(path, &svg)?;
        }
        let mut object = self.head(filtration, build, cut);
        object["parameter"] = json!({ "convention": name, "value": value_of(param) });
        object["rank"] = json!(cut.ranks().checked_sub(1));
        let last = cut.ranks().checked_sub(1).map(|rank| filtration.value_of_rank(rank));
        object["squared_radius"] = json!(last.as_ref().map(delone_alpha::SquaredRadius::to_f64));
        object["squared_radius_exact"] = json!(last.as_ref().map(delone_alpha::fraction));
        if self.arguments.voice.json {
            println!("{object}");
        } else {
            print!("{}", self.text(&object));
        }
        Ok(())
    }

    fn text(&self, object: &Value) -> String {
        let list = |key: &str| -> String {
            let numbers = object[key].as_array().into_iter().flatten().filter_map(Value::as_u64);
            numbers.map(grouped).collect::<Vec<_>>().join(", ")
        };
        let rows = [
            ("input", result::describe(self.subject)),
            (
                "parameter",
                format!("{} {}", object["parameter"]["convention"], object["parameter"]["value"]),
            ),
            ("squared", object["squared_radius_exact"].as_str().unwrap_or("none").to_owned()),
            ("simplices", list("simplices")),
            ("betti", list("betti")),
            ("seconds", result::seconds(object["seconds"]["build"].as_f64().unwrap_or(0.0))),
        ];
        rows.iter().map(|(name, value)| format!("{name:12} {value}\n")).collect()
    }

    /// The input's points with the simplices of a complex: all of them, or cells and their faces alone.
    fn document<const D: usize>(&self, filtration: &AlphaFiltration<D>, cut: Cut) -> Document {
        let names = self.subject.names();
        let simplices = filtration.simplices();
        let top = simplices.dimension().unwrap_or(0);
        let mut document = self.subject.document.clone();
        let mut is_kept = vec![self.arguments.mode == Mode::General; simplices.len()];
        for id in simplices.of_dimension(top) {
            is_kept[id] = true;
        }
        if self.arguments.mode == Mode::Regularized {
            for id in (0..simplices.len()).rev() {
                let is_in = is_kept[id] && cut.holds(filtration.ranks()[id]);
                let facets = simplices.facets(SimplexId::new(id));
                facets.iter().filter(|_| is_in).for_each(|&facet| is_kept[facet as usize] = true);
            }
        }
        (document.segments, document.segment_markers) = Default::default();
        for simplex in filtration.complex(cut).filter(|simplex| is_kept[simplex.index()]) {
            let site = |&v: &u32| names[v as usize];
            match *simplices.vertices(simplex).iter().map(site).collect::<Vec<_>>() {
                [a, b] => document.segments.push([a, b]),
                [a, b, c] => document.triangles.push([a, b, c]),
                [a, b, c, d] => document.tets.push([a, b, c, d]),
                _ => {}
            }
        }
        document
    }
}
