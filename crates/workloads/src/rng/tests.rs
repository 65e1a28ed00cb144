use super::Rng;

/// Computed from the published constants by `contract/independent.py`, which shares no code with this crate.
#[test]
fn the_stream_is_pinned() {
    let mut rng = Rng::new(0);
    let first = [rng.next_u64(), rng.next_u64(), rng.next_u64(), rng.next_u64()];
    assert_eq!(first, PINNED);
}

const PINNED: [u64; 4] =
    [0x99ec_5f36_cb75_f2b4, 0xbf6e_1f78_4956_452a, 0x1a5f_849d_4933_e6e0, 0x6aa5_94f1_262d_2d2c];

#[test]
fn below_is_in_range_and_even() {
    let mut rng = Rng::new(1);
    let mut counts = [0; 6];
    (0..60_000).for_each(|_| counts[rng.index(6)] += 1);
    assert!(counts.iter().all(|&c| (9_600..10_400).contains(&c)), "{counts:?}");
    assert_eq!(rng.below(0), 0);
    assert_eq!(rng.below(1), 0);
    assert!((0..1000).all(|_| (-2..=2).contains(&rng.integer(-2, 2))));
    assert_eq!(rng.integer(i64::MAX, i64::MAX), i64::MAX);
    rng.integer(i64::MIN, i64::MAX);
}

/// Mean 0, variance 1, kurtosis 3, and P(|x| < 1) = 0.6827, each within about four standard errors.
#[test]
fn gauss_has_the_moments_of_the_normal() {
    let mut rng = Rng::new(2);
    let n = 200_000.0;
    let draws: Vec<f64> = (0..200_000).map(|_| rng.gauss()).collect();
    let moment = |k: i32| draws.iter().map(|x| (0..k).map(|_| x).product::<f64>()).sum::<f64>() / n;
    assert!(moment(1).abs() < 0.01, "{}", moment(1));
    assert!((moment(2) - 1.0).abs() < 0.015, "{}", moment(2));
    assert!((moment(4) - 3.0).abs() < 0.1, "{}", moment(4));
    let inside = draws.iter().filter(|x| x.abs() < 1.0).map(|_| 1.0).sum::<f64>() / n;
    assert!((inside - 0.6827).abs() < 0.005, "{inside}");
}

#[test]
fn shuffle_permutes_and_directions_have_length_one() {
    let mut rng = Rng::new(3);
    let mut items: Vec<u32> = (0..100).collect();
    rng.shuffle(&mut items);
    assert!(!items.is_sorted());
    items.sort_unstable();
    assert!(items.iter().copied().eq(0..100));
    rng.shuffle::<u32>(&mut []);
    let [x, y] = rng.direction();
    assert!((x * x + y * y - 1.0).abs() < 1e-15);
}
