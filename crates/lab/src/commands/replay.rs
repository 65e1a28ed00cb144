//! `delone replay`: a construction step by step, as a page to go through: sites come one by one, then segments; or what a batch
//! algorithm shows of its inside.
//!
//! Steps are those of the structures themselves, under a kernel that notes each question where it can; the mesh after the last step
//! is compared with what another algorithm makes.

mod film;
mod inside;
mod recording;

use delone_cdt::cavity;
use delone_delaunay::{Dynamic, Options};
use delone_draw::{Report, Style};
use delone_mesh::Mesh;
use delone_predicates::Adaptive;
use delone_probe::Counts;
use delone_sites::{Pslg, Sites};
use serde_json::json;

use crate::cli;
use crate::failure::Failure;
use crate::progress::Busy;
use crate::result::{describe, grouped};
use crate::subject::{Body, Subject};
use crate::{input, output};
use film::Film;
use recording::{Notes, Recording};

pub(crate) fn replay(arguments: &cli::Replay) -> Result<(), Failure> {
    output::check_paths([arguments.html.as_path()])?;
    let busy = Busy::new(arguments.voice.quiet, "recording");
    let document = input::read(&arguments.source.input, arguments.source.format.as_deref())?;
    if document.dimension != 2 {
        return Err(Failure::input("only inputs in the plane are replayed"));
    }
    let subject = Subject::new(document)?;
    let count = subject.site_count();
    if count > arguments.sites_max {
        let most = arguments.sites_max;
        return Err(Failure::input(format!(
            "{count} sites: no one goes through that many steps; --sites-max raises the limit of {most}"
        )));
    }
    let (sites, pslg) = match &subject.body {
        Body::Plane(sites) => (sites, None),
        Body::Graph(pslg) => (pslg.sites(), Some(pslg)),
        _ => return Err(Failure::input("weights and crossings are not replayed")),
    };
    let (film, agrees) = match arguments.algorithm {
        cli::Shown::Insertion => shown(sites, pslg),
        cli::Shown::DivideConquer => inside::divide_conquer(sites),
        cli::Shown::Sweep => inside::sweep(sites),
        cli::Shown::Chew => inside::chew(sites, pslg),
    };
    let (steps, asked) = (film.steps(), film.asked);
    output::text(&arguments.html, &page(&subject, film))?;
    drop(busy);
    if matches!(arguments.algorithm, cli::Shown::DivideConquer | cli::Shown::Sweep) {
        no_segments(&subject, arguments.voice.quiet);
    }
    if arguments.voice.json {
        println!(
            "{}",
            json!({
                "schema": "delone.replay/1", "input": crate::result::input(&subject), "steps": steps, "questions": asked,
                "agree": agrees, "html": arguments.html.to_string_lossy(),
            })
        );
    } else {
        let (path, size) = (arguments.html.display(), output::size(&arguments.html));
        println!("{steps} steps, {} questions: {path} ({size})", grouped(asked));
    }
    if agrees {
        return Ok(());
    }
    Err(Failure::Difference(Some("the last step is not what the batch algorithms make".to_owned())))
}

/// Says that segments are left out, if there are any.
fn no_segments(subject: &Subject, quiet: bool) {
    if matches!(subject.body, Body::Graph(_)) && !quiet {
        eprintln!("this algorithm takes sites alone: segments are left out");
    }
}

/// Sites one by one, then segments; and whether the result is what the batch algorithms make.
fn shown(sites: &Sites<2>, pslg: Option<&Pslg>) -> (Film, bool) {
    let (notes, points) = (Notes::default(), sites.points());
    let kernel = Recording::new(Adaptive::new(points), &notes);
    let mut film = Film::new(points);
    let mut dynamic = Dynamic::<2, _>::new(&kernel, sites.len());
    for site in (0u32..).take(sites.len()) {
        let mut counts = Counts::default();
        dynamic.insert(site, &mut counts);
        film.step(&format!("site {site} comes"), dynamic.mesh(), &[], &[site], &counts, &notes);
    }
    let options = Options::default();
    let batch = delone_delaunay::delaunay(sites, &options, &mut ());
    let mut agrees = canonical(dynamic.mesh()) == batch.canonical();
    let Some(pslg) = pslg else { return (film, agrees) };
    film.delaunay_is_done();
    let free = Pslg::new(points, &[]).expect("sites are valid points");
    let start = cavity(&free, &options, &mut ());
    let Some(mut dynamic) = delone_cdt::Dynamic::new(start, &kernel, sites.len()) else {
        return (film, agrees); // all in line: every segment is there
    };
    let _ = notes.take();
    for &[a, b] in pslg.subsegments() {
        let mut counts = Counts::default();
        dynamic.insert_segment([a, b], &mut counts).expect("a noded graph has no crossings");
        let cdt = dynamic.cdt();
        let title = format!("segment {a} {b} comes");
        film.step(&title, cdt.mesh(), &cdt.constrained_edges(), &[a, b], &counts, &notes);
    }
    agrees &= dynamic.cdt().canonical() == cavity(pslg, &options, &mut ()).canonical();
    (film, agrees)
}

fn canonical(mesh: &Mesh<2>) -> Vec<u32> {
    mesh.canonical(|vertex| u32::try_from(vertex.index()).expect("ids of 32 bits"))
}

fn page(subject: &Subject, film: Film) -> String {
    let mut report = Report::new("delone replay");
    report.lead(&describe(subject));
    report.paragraph(
        "Step through with the buttons, the slider, or the keys n and p. New triangles are filled; the outlines of those that \
         went are dashed; circumcircles, if switched on, are those of the new ones. Below are the questions that were asked.",
    );
    let style = Style { size: 900.0, title: subject.name().to_owned(), ..Style::default() };
    report.scene(&film.scene(), &style, subject.name());
    report.finish()
}
