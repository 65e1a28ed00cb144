//! Regular triangulations: the corpus, and weights of several kinds, among them many ties and many hidden sites.

use delone::delaunay::{Options, regular};
use delone::sites::WeightedSites;
use delone::workloads::Rng;
use delone_tests::case::Case;
use delone_tests::cgal::{Answer, Cgal};
use delone_tests::corpus::{Size, plane, space};
use delone_tests::say;

/// The largest square of a difference of coordinates of neighbours in the list: a scale at which weights matter.
fn scale<const D: usize>(points: &[[f64; D]]) -> f64 {
    let squares = points.windows(2).map(|pair| (pair[0][0] - pair[1][0]).powi(2));
    let finite = squares.filter(|square| square.is_finite() && *square < 1e300);
    finite.fold(0.0, f64::max)
}

/// Weights of one kind for each point: small integers, a fraction of the scale, and heights that lie in a plane.
fn weights<const D: usize>(kind: usize, points: &[[f64; D]], rng: &mut Rng) -> Vec<f64> {
    let scale = scale(points) / 16.0;
    let weight = |point: &[f64; D]| match kind {
        0 => (rng.below(4) as f64) - 1.0,
        1 => scale * rng.below(16) as f64,
        _ => point.iter().map(|x| x * x).sum(),
    };
    points.iter().map(weight).map(|w: f64| if w.is_finite() { w } else { 0.0 }).collect()
}

fn compare_all<const D: usize>(cases: Vec<Case<D>>) {
    let Some(mut cgal) = Cgal::start() else { return };
    let mut rng = Rng::named("weights", 1);
    let (mut count, mut hidden) = (0, 0);
    for case in cases {
        for kind in 0..3 {
            let points = case.sites().points().to_vec();
            let weights = weights(kind, &points, &mut rng);
            let sites = WeightedSites::new(&points, &weights).expect("finite");
            let ours = regular(&sites, &Options::default(), &mut ());
            let Answer::Cells { dimension, cells } = cgal.regular(&points, &weights) else {
                panic!("{}: refused", case.name);
            };
            let ours_has = ours.mesh().dimension().map_or(-1, |k| i32::try_from(k).unwrap_or(-2));
            assert_eq!(dimension, ours_has, "{}, weights {kind}: dimension", case.name);
            assert_eq!(cells, ours.canonical(), "{}, weights {kind}", case.name);
            count += 1;
            hidden += ours.hidden().len();
        }
    }
    say(format!("CGAL, weighted, {D} dimensions: {count} equal, cell for cell; {hidden} hidden"));
    assert!(hidden > 100, "{hidden} hidden sites are too few to say something");
}

#[test]
fn weighted_sites_of_the_plane() {
    compare_all([plane(Size::Small), plane(Size::Middle)].concat());
}

#[test]
fn weighted_sites_of_space() {
    compare_all([space(Size::Small), space(Size::Middle)].concat());
}
