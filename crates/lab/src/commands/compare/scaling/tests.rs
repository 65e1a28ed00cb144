use super::*;

/// Runs of so many sites, steps and seconds.
fn curve(runs: &[(f64, f64, f64)]) -> Curve {
    let point = |&(sites, steps, seconds): &(f64, f64, f64)| Point {
        sites,
        seconds,
        steps,
        proved: true,
        fingerprint: String::new(),
    };
    Curve { algorithm: "some", points: runs.iter().map(point).collect() }
}

#[test]
fn what_takes_long_is_told_from_how_steps_grow() {
    // Nothing is known, or one size: then the square.
    assert!(!curve(&[]).is_too_long(usize::MAX));
    assert!(!curve(&[(1e4, 1e6, 0.3)]).is_too_long(100_000));
    assert!(curve(&[(1e4, 1e6, 0.5)]).is_too_long(100_000));
    // Linear: ten times the sites take about 18 times as long.
    assert!(!curve(&[(1e4, 1e6, 0.0), (1e5, 1e7, 2.0)]).is_too_long(1_000_000));
    assert!(curve(&[(1e4, 1e6, 0.0), (1e5, 1e7, 3.0)]).is_too_long(1_000_000));
    // Quadratic steps: 178 times.
    assert!(!curve(&[(1e4, 1e6, 0.0), (1e5, 1e8, 0.2)]).is_too_long(1_000_000));
    assert!(curve(&[(1e4, 1e6, 0.0), (1e5, 1e8, 0.3)]).is_too_long(1_000_000));
}

#[test]
fn what_is_left_out_is_said() {
    let workload = find("uniform").unwrap();
    let growth = |left_out| Growth { workload, curves: Vec::new(), left_out };
    assert_eq!(omissions(&growth(Vec::new())), None);
    let said = omissions(&growth(vec![("sweep", 1_000), ("flips", 100)])).unwrap();
    assert!(said.contains("sweep from 1000 sites on, flips from 100 sites on"), "{said}");
}
