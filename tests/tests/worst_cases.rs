//! The worst cases that workloads promise, counted: what twice the sites cost, in the order given and in ours.

use delone::delaunay::{Options, Order, algorithms, delaunay};
use delone::probe::Counts;
use delone::workloads::{Points, find};
use delone::{Pslg, Sites};

fn sites(name: &str, n: usize) -> Sites<2> {
    match find(name).expect("a workload").generate(n, 1).points {
        Points::Plane(points) => Sites::new(&points).expect("finite"),
        Points::Space(_) => panic!("{name} is in the plane"),
    }
}

fn counts(name: &str, n: usize, algorithm: &str, order: Order) -> Counts {
    let all = algorithms::<2>();
    let algorithm = all.iter().find(|known| known.name == algorithm).expect("an algorithm");
    let mut counts = Counts::default();
    let options = Options { order, ..Options::default() };
    let _mesh = (algorithm.run_with)(&sites(name, n), &options, &mut counts);
    counts
}

/// How much more so many times as many sites cost.
fn growth(times: usize, of: impl Fn(usize) -> u64) -> f64 {
    let count = |n| f64::from(u32::try_from(of(n)).expect("a small count"));
    count(400 * times) / count(400)
}

#[test]
fn falling_sites_dig_everything_in_the_order_given() {
    for algorithm in ["bowyer-watson", "flips"] {
        let cost = |times, order| {
            growth(times, |n| {
                let counts = counts("falling-sites", n, algorithm, order);
                counts.cells_made + counts.flips
            })
        };
        assert!(cost(2, Order::AsGiven) > 3.8, "{algorithm}: {}", cost(2, Order::AsGiven));
        // Rounds grow by eight: eight times the sites are one round more.
        assert!(cost(8, Order::Brio) < 10.0, "{algorithm}: {}", cost(8, Order::Brio));
    }
}

#[test]
fn a_shuttle_walks_to_and_fro_in_the_order_given() {
    let cost =
        |times, order| growth(times, |n| counts("shuttle", n, "bowyer-watson", order).walk_steps);
    assert!(cost(2, Order::AsGiven) > 3.6, "{}", cost(2, Order::AsGiven));
    // Some ten times, where a quadratic cost were 64: of few sites the first round is most.
    assert!(cost(8, Order::Brio) < 16.0, "{}", cost(8, Order::Brio));
}

/// Strips without horizontal cuts would make cells at each of log n levels; by turns it is half of them, and still nearly twice what uniform sites take.
#[test]
fn a_shuffled_column_is_the_worst_of_merges() {
    let made = |name| counts(name, 2000, "divide-conquer", Order::Brio).cells_made;
    assert!(
        2 * made("shuffled-column") > 3 * made("uniform"),
        "{} {}",
        made("shuffled-column"),
        made("uniform")
    );
}

#[test]
fn a_wheel_has_a_hub() {
    let sites = sites("wheel", 500);
    let cells = delaunay(&sites, &Options::default(), &mut ()).canonical();
    let hub = cells.chunks(3).filter(|cell| cell.contains(&0)).count();
    assert_eq!((hub, cells.len() / 3), (499, 499), "every triangle is at the hub");
}

#[test]
fn lines_and_curves_of_space_have_quadratically_many_cells() {
    for (name, least) in [("skew-lines", 15 * 15), ("moment-curve", 15 * 28)] {
        let Points::Space(points) = find(name).unwrap().generate(32, 1).points else { panic!() };
        let sites = Sites::new(&points).unwrap();
        let cells = delaunay(&sites, &Options::default(), &mut ()).cells().count();
        assert!(cells >= least, "{name}: {cells}");
    }
}

/// Segments of a ladder, flipped in one by one, cross quadratically many edges; for cavities, and for Chew's algorithm, twice as many cost
/// little more than twice as much.
#[test]
fn a_ladder_is_quadratic_for_flips_alone() {
    let cost = |name: &str, of: fn(&Counts) -> u64| {
        growth(2, |n| {
            let input = find("ladder").unwrap().generate(n, 1);
            let segments: Vec<[usize; 2]> =
                input.segments.iter().map(|ends| ends.map(|v| v as usize)).collect();
            let pslg = Pslg::new(input.points.plane().unwrap(), &segments).unwrap();
            let all = delone::cdt::algorithms();
            let algorithm = all.iter().find(|known| known.name == name).unwrap();
            let mut counts = Counts::default();
            let _cdt = (algorithm.run_with)(&pslg, &Options::default(), &mut counts);
            of(&counts)
        })
    };
    let crossed = |counts: &Counts| counts.edges_crossed;
    assert!(cost("flips", crossed) > 3.0, "{}", cost("flips", crossed));
    assert!(cost("cavity", crossed) < 2.6, "{}", cost("cavity", crossed));
    let orients = cost("chew", |counts| counts.orients);
    assert!(orients < 2.6, "{orients}");
}
