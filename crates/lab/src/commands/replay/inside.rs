//! Batch algorithms from inside: each moment that they show is a step.

use delone_delaunay::Options;
use delone_mesh::Mesh;
use delone_predicates::Adaptive;
use delone_probe::{Counts, Event, Moment, Probe};
use delone_sites::{Pslg, Sites};

use super::canonical;
use super::film::Film;
use super::recording::{Notes, Recording};

/// A probe that keeps what it is shown.
struct Camera<'n> {
    film: Film,
    /// Since the last step.
    counts: Counts,
    notes: &'n Notes,
}

impl<'n> Camera<'n> {
    fn new(sites: &Sites<2>, notes: &'n Notes) -> Self {
        Self { film: Film::new(sites.points()), counts: Counts::default(), notes }
    }
}

impl Probe for Camera<'_> {
    fn on(&mut self, event: Event) {
        self.counts.on(event);
    }

    fn watches(&self) -> bool {
        true
    }

    fn show(&mut self, moment: &Moment<'_>) {
        let counts = std::mem::take(&mut self.counts);
        self.film.moment(moment, &counts, self.notes);
    }
}

/// Blocks of sites and their merges; and whether the result is what insertion makes.
pub(super) fn divide_conquer(sites: &Sites<2>) -> (Film, bool) {
    let notes = Notes::default();
    let kernel = Recording::new(Adaptive::new(sites.points()), &notes);
    let mut camera = Camera::new(sites, &notes);
    let mesh = delone_delaunay::divide_conquer(&kernel, sites, &mut camera);
    finish(camera, sites, &mesh)
}

/// Site events and circle events; and whether the result is what insertion makes. Ties are broken after the last event, by flips.
pub(super) fn sweep(sites: &Sites<2>) -> (Film, bool) {
    let notes = Notes::default();
    let mut camera = Camera::new(sites, &notes);
    let mesh = delone_delaunay::sweep(&Adaptive::new(sites.points()), sites, &mut camera);
    finish(camera, sites, &mesh)
}

/// Strips of sites and segments, and their merges; and whether the result is what segment insertion makes.
pub(super) fn chew(sites: &Sites<2>, pslg: Option<&Pslg>) -> (Film, bool) {
    let notes = Notes::default();
    let free = Pslg::new(sites.points(), &[]).expect("sites are valid points");
    let (pslg, options) = (pslg.unwrap_or(&free), Options::default());
    let mut camera = Camera::new(sites, &notes);
    camera.film.constraints(pslg.subsegments());
    let cdt = delone_cdt::chew(pslg, &options, &mut camera);
    let other = delone_cdt::cavity(pslg, &options, &mut ());
    let agrees = cdt.canonical() == other.canonical();
    last(&mut camera, cdt.mesh(), pslg.subsegments());
    (camera.film, agrees)
}

fn finish(mut camera: Camera<'_>, sites: &Sites<2>, mesh: &Mesh<2>) -> (Film, bool) {
    let other = delone_delaunay::delaunay(sites, &Options::default(), &mut ());
    last(&mut camera, mesh, &[]);
    (camera.film, canonical(mesh) == other.canonical())
}

/// The mesh that is handed over, as the last step.
fn last(camera: &mut Camera<'_>, mesh: &Mesh<2>, constraints: &[[u32; 2]]) {
    let counts = std::mem::take(&mut camera.counts);
    camera.film.step("the mesh is handed over", mesh, constraints, &[], &counts, camera.notes);
}
