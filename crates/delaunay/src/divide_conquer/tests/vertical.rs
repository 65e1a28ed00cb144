//! Guibas and Stolfi's cuts, across x alone, from the same leaves and merges: what Dwyer's alternating cuts save.

use super::*;

/// The Delaunay mesh of sites that span the plane.
fn vertical(sites: &Sites<2>, probe: &mut impl Probe) -> Mesh<2> {
    let order = sites.sorted();
    let kernel = Adaptive::new(sites.points()).reordered(order);
    let mut arrays = Arrays::new(order.len());
    let patch = Patch::new(&mut arrays.apexes, &mut arrays.twins);
    solve_across_x(&mut Work { patch, kernel: &kernel, probe, names: order }, 0, count(order));
    arrays.into_mesh(order)
}

fn solve_across_x<K: Kernel<2>, P: Probe>(work: &mut Work<'_, K, P>, i: Place, j: Place) -> Hull {
    if j - i <= 3 {
        return leaf(work, i, j);
    }
    let m = i + (j - i) / 2;
    let (left, right) = (solve_across_x(work, i, m), solve_across_x(work, m, j));
    work.merge(left, right, Axis::X, 2 * m - 2)
}

/// The tests of a circle for each of uniform sites, by cuts across x alone, and by turns.
fn tests_per_site(n: u32) -> [f64; 2] {
    let points = planar(generate("uniform", n as usize, 3).unwrap().points).unwrap();
    let sites = Sites::new(&points).unwrap();
    let (mut across_x, mut by_turns) = (Counts::default(), Counts::default());
    let mesh = vertical(&sites, &mut across_x);
    let other = divide_conquer(&Adaptive::new(sites.points()), &sites, &mut by_turns);
    assert_eq!(canonical(&mesh), canonical(&other));
    [across_x, by_turns].map(|counts| counts.in_spheres as f64 / f64::from(n))
}

/// \[Dwy87\]: for each site, a constant more with each doubling by cuts across x alone; by turns, next to nothing.
#[test]
fn alternating_cuts_save_tests_that_grow_with_the_logarithm() {
    let [few, more, many] = [500, 4000, 32_000].map(tests_per_site);
    assert!(few[1] < few[0] && more[1] < more[0] && many[1] < many[0], "{few:?} {many:?}");
    // Three doublings each: the same again for cuts across x, within a third, and much less by turns.
    let (first, second) = (more[0] - few[0], many[0] - more[0]);
    assert!(first > 0.5 && (0.67..1.5).contains(&(second / first)), "{few:?} {more:?} {many:?}");
    assert!(many[1] - few[1] < (many[0] - few[0]) / 4.0, "{few:?} {more:?} {many:?}");
}
