//! What a fill rule says of a CDT, for scripts and people.

use delone_cdt::{Cdt, Domain, EdgeKind, Fill};
use delone_check::{Complex, FillRule, Options, Verdict, judge_fill};
use delone_sites::Noded;
use serde_json::{Map, Value, json};

use crate::cli;
use crate::engine::Triangulation;
use crate::failure::Failure;
use crate::judge;
use crate::subject::{Body, Subject, refusal};

/// The rule that the command line names.
pub(crate) fn rule(fill: cli::Fill, subject: &Subject) -> Fill {
    match fill {
        cli::Fill::None => Fill::Hull,
        cli::Fill::EvenOdd => Fill::EvenOdd,
        cli::Fill::Nonzero => Fill::NonZero,
        cli::Fill::Positive => Fill::Positive,
        cli::Fill::Nesting => Fill::Nesting,
        cli::Fill::Exterior => Fill::Exterior,
        cli::Fill::Seeds => Fill::Seeds(subject.document.holes.as_chunks::<2>().0.to_vec()),
    }
}

/// Fills a CDT.
pub(crate) fn domain(
    triangulation: &Triangulation,
    subject: &Subject,
    fill: cli::Fill,
) -> Result<Domain, Failure> {
    let rule = rule(fill, subject);
    triangulation
        .domain(subject, &rule)
        .map_err(|error| refusal(&subject.document, &error.to_string()))
}

/// What the judge says of a fill; `None` if it does not judge this rule, or vertices that doubles do not hold.
pub(crate) fn verdict(
    triangulation: &Triangulation,
    subject: &Subject,
    domain: &Domain,
    fill: cli::Fill,
) -> Option<Verdict> {
    let rule = match fill {
        cli::Fill::EvenOdd => FillRule::EvenOdd,
        cli::Fill::Nonzero => FillRule::NonZero,
        cli::Fill::Positive => FillRule::Positive,
        cli::Fill::Nesting => FillRule::Nesting,
        cli::Fill::Exterior => FillRule::Exterior,
        cli::Fill::Seeds => FillRule::Seeds(subject.document.holes.as_chunks::<2>().0),
        cli::Fill::None => return None,
    };
    let (Triangulation::Constrained(cdt), Body::Graph(pslg)) = (triangulation, &subject.body)
    else {
        return None;
    };
    let mesh = cdt.mesh();
    let complex = Complex {
        points: pslg.sites().points(),
        dimension: mesh.dimension(),
        cells: &judge::solid_ids(mesh),
    };
    let is_inside = |cell| domain.is_inside(domain.regions().of_cell(cell));
    let inside: Vec<bool> = cdt.cells().map(is_inside).collect();
    Some(judge_fill(&complex, pslg.segments(), &inside, rule, &Options::default()))
}

/// The keys of a filled CDT.
pub(crate) fn keys(domain: &Domain) -> Map<String, Value> {
    let area = domain.area();
    let mut keys = Map::new();
    keys.insert("area".to_owned(), json!(area.to_f64()));
    keys.insert("area_exact".to_owned(), json!(area.to_string()));
    let region = |region: u32| {
        let area = domain.region_area(region);
        json!({
            "area": area.to_f64(),
            "area_exact": area.to_string(),
            "depth": domain.depth(region),
            "inside": domain.is_inside(region),
            "coefficient": domain.chain().map(|chain| chain[region as usize]),
            "point": domain.interior_point(region),
        })
    };
    let regions = (1u32..).take(domain.regions().count() - 1).map(region);
    keys.insert("regions".to_owned(), json!(regions.collect::<Vec<_>>()));
    let counts = EdgeKind::ALL.map(|kind| {
        let count = domain.kinds().iter().filter(|found| **found == kind).count();
        (kind.name().to_owned(), json!(count))
    });
    keys.insert("edge_kinds".to_owned(), Value::Object(counts.into_iter().collect()));
    keys
}

/// The crossings that became vertices, and whether the triangulation survives their rounding.
pub(crate) fn crossing_keys(
    triangulation: &Triangulation,
    subject: &Subject,
) -> Map<String, Value> {
    let mut keys = Map::new();
    keys.insert("steiner".to_owned(), json!(subject.added().len()));
    if let (Triangulation::Constrained(cdt), Body::Crossed(graph)) = (triangulation, &subject.body)
    {
        keys.insert("crossings".to_owned(), json!(graph.crossing_count()));
        let rounded = (graph.sites().len()..graph.positions().len())
            .filter(|&v| !graph.kernel().is_exact_position(u32::try_from(v).unwrap_or(u32::MAX)));
        keys.insert("rounded_vertices".to_owned(), json!(rounded.count()));
        keys.insert("rounding_keeps_validity".to_owned(), json!(rounding_is_valid(graph, cdt)));
    }
    keys
}

fn rounding_is_valid(graph: &delone_sites::Arrangement, cdt: &Cdt) -> bool {
    let finite = graph.positions().as_flattened().iter().all(|x| x.is_finite());
    finite && judge::rounded(cdt.mesh(), graph.positions())
}
