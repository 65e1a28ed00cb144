//! What the literature says of the work that is done, counted.

use delone_probe::{Event, Probe};
use delone_sites::{WeightedSites, scatter};

use super::*;

/// Uniform sites, in an order that has nothing to do with their positions.
fn uniform<const D: usize>(count: u64) -> Sites<D> {
    let coordinate = |i: u64| f64::from(u32::try_from(scatter(i) >> 32).unwrap());
    let point = |i: u64| std::array::from_fn(|axis| coordinate(8 * i + axis as u64));
    Sites::new(&(0..count).map(point).collect::<Vec<_>>()).unwrap()
}

fn counts<const D: usize>(sites: &Sites<D>, order: Order) -> Counts {
    let mut counts = Counts::default();
    delaunay(sites, &Options { order, ..Options::default() }, &mut counts);
    counts
}

fn ratio(a: u64, b: u64) -> f64 {
    a as f64 / b as f64
}

/// [GKS92]: in random order a new site has expected degree below 6: so many cells come, and 2 fewer go.
#[test]
fn a_site_of_the_plane_makes_six_cells() {
    let sites = uniform::<2>(4000);
    let made_and_removed = |order| {
        let counts = counts(&sites, order);
        (ratio(counts.cells_made, counts.sites), ratio(counts.cavity_cells, counts.sites))
    };
    let (made, removed) = made_and_removed(Order::AsGiven); // which is random
    assert!((5.8..6.0).contains(&made) && (3.8..4.0).contains(&removed), "{made} {removed}");
    // Along a curve within each round, the order is not quite random.
    let (made, removed) = made_and_removed(Order::Brio);
    assert!((5.8..6.3).contains(&made) && (3.8..4.3).contains(&removed), "{made} {removed}");
}

/// [Mei53]: a site of a Poisson process in space has 2 + 48 pi^2 / 35 = 15.54 neighbours, and so 27.07 cells, on average.
/// Sites near the boundary have fewer.
#[test]
fn a_site_of_space_makes_twenty_seven_cells_less_the_boundary() {
    let few = counts(&uniform::<3>(500), Order::Brio);
    let many = counts(&uniform::<3>(4000), Order::Brio);
    let [few, many] = [few, many].map(|counts| ratio(counts.cells_made, counts.sites));
    assert!(few < many && many < 27.07 && many > 23.0, "{few} {many}");
}

/// [ACR03], [DPT02]: a walk from the last site is short along a curve, in rounds or not; in random order it crosses a
/// number of cells that grows with the square root of theirs.
#[test]
fn walks_are_short_along_a_curve_and_grow_in_random_order() {
    let (few, many) = (uniform::<2>(1000), uniform::<2>(4000));
    for order in [Order::Brio, Order::Hilbert] {
        for sites in [&few, &many] {
            let counts = counts(sites, order);
            let steps = ratio(counts.walk_steps, counts.sites);
            assert!((1.0..6.0).contains(&steps), "{order:?}: {steps}");
        }
    }
    let [few, many] = [few, many].map(|sites| {
        let counts = counts(&sites, Order::AsGiven);
        ratio(counts.walk_steps, counts.sites)
    });
    assert!(few > 12.0 && (1.7..2.3).contains(&(many / few)), "{few} {many}");
}

struct Stops {
    after: usize,
    sites: usize,
}

impl Probe for Stops {
    fn on(&mut self, event: Event) {
        self.sites += usize::from(matches!(event, Event::Site { .. }));
    }

    fn goes_on(&mut self) -> bool {
        self.sites < self.after
    }
}

#[test]
fn a_probe_stops_what_can_be_stopped_and_nothing_else() {
    let sites = uniform::<2>(100);
    let stops = |after| Stops { after, sites: 0 };
    let mut probe = stops(10);
    let stopped = delaunay_unless_stopped(&sites, &Options::default(), &mut probe);
    assert_eq!((stopped, probe.sites), (Err(Stopped), 10));
    assert!(Stopped.to_string().starts_with("stopped"));
    let whole = delaunay(&sites, &Options::default(), &mut stops(10));
    assert_eq!(whole.canonical().len() % 3, 0);
    assert_eq!(
        delaunay_unless_stopped(&sites, &Options::default(), &mut stops(99)),
        Ok(whole.clone())
    );
    let weighted = WeightedSites::new(sites.points(), &[1.0; 100]).unwrap();
    let regular = |after| regular_unless_stopped(&weighted, &Options::default(), &mut stops(after));
    assert_eq!(regular(10), Err(Stopped));
    assert_eq!(regular(99).unwrap().canonical(), whole.canonical());
    for algorithm in algorithms::<2>() {
        if let Some(run) = algorithm.run_unless_stopped {
            assert_eq!(run(&sites, &Options::default(), &mut stops(10)), Err(Stopped));
            assert_eq!(run(&sites, &Options::default(), &mut stops(99)), Ok(whole.clone()));
        }
    }
    for algorithm in algorithms::<2>().iter().filter(|a| a.sites_max >= sites.len()) {
        let result = (algorithm.run_with)(&sites, &Options::default(), &mut stops(10));
        assert_eq!(result.canonical(), whole.canonical(), "{}", algorithm.name);
    }
}

/// [ACR03]: the walk is short wherever sites are near those before; also in a cluster narrower than a square of the curve's grid.
#[test]
fn a_narrow_cluster_is_walked_as_a_wide_one() {
    let sites = uniform::<2>(4000);
    let narrow = |&[x, y]: &[f64; 2]| [x * 2f64.powi(-90), y * 2f64.powi(-90)];
    let both: Vec<[f64; 2]> =
        sites.points().iter().copied().chain(sites.points().iter().map(narrow)).collect();
    let both = Sites::new(&both).unwrap();
    let steps = |sites| {
        let counts = counts(sites, Order::Brio);
        ratio(counts.walk_steps, counts.sites)
    };
    assert!(steps(&both) < 1.5 * steps(&sites), "{} {}", steps(&both), steps(&sites));
}
