use super::*;
use crate::{Sites, scatter};

/// All sites inside all segments between two of the points, against every site by definition; how many there were.
fn check(points: &[[f64; 2]]) -> usize {
    let sites = Sites::new(points).unwrap();
    let strips = Strips::new(sites.points(), sites.sorted());
    let count = u32::try_from(sites.len()).unwrap();
    let mut total = 0;
    for last in 0..count {
        for first in 0..last {
            let (a, b) = (strips.point(first), strips.point(last));
            let on = |&rank: &u32| orient2d(a, b, strips.point(rank)) == Sign::Zero;
            let expected: Vec<u32> = (first + 1..last).filter(on).collect();
            assert_eq!(strips.inside(first, last), expected, "{a:?} {b:?}");
            total += expected.len();
        }
    }
    total
}

/// A coordinate for each step: small integers times a power of two, over a range of exponents.
fn scattered(count: u64, size: u64, exponents: std::ops::Range<i32>) -> Vec<[f64; 2]> {
    let span = u64::from(exponents.end.abs_diff(exponents.start));
    let coordinate = |step: u64| {
        let random = scatter(step);
        let exponent = exponents.start + i32::try_from(scatter(random) % span).unwrap();
        let integer = u32::try_from(random % (2 * size + 1)).unwrap();
        (f64::from(integer) - f64::from(u32::try_from(size).unwrap())) * f64::from(exponent).exp2()
    };
    (0..count).map(|i| [coordinate(2 * i), coordinate(2 * i + 1)]).collect()
}

#[test]
fn sites_inside_segments_are_found() {
    assert!(check(&scattered(150, 6, 0..1)) > 1000);
    // Slanted lines of sites, whose heights in a strip are rounded.
    let line = (0..120).map(f64::from).map(|i| [i * 0.1, 3.0 * (i * 0.1)]);
    assert!(check(&line.collect::<Vec<_>>()) > 100);
    let parallels = (0..150).map(|i| [f64::from(i / 3), f64::from(i / 3) * 7.0 + f64::from(i % 3)]);
    assert!(check(&parallels.collect::<Vec<_>>()) > 1000);
}

#[test]
fn sites_inside_segments_are_found_in_the_whole_range() {
    assert!(check(&scattered(120, 3, 1021..1023)) > 100, "differences overflow");
    assert!(check(&scattered(120, 3, -1070..-1068)) > 100, "denormal numbers");
    check(&scattered(120, 1000, -1000..1000));
    check(&scattered(120, 1 << 30, -60..-20));
}
