use super::{geometric_mean, median, quantile, ratio};

#[test]
fn medians_and_means_by_hand() {
    assert_eq!(median(&[3.0, 1.0, 2.0]), 2.0);
    assert_eq!((quantile(&[1.0, 2.0, 3.0, 4.0, 5.0], 0.25), quantile(&[7.0], 0.9)), (2.0, 7.0));
    assert!(median(&[]).is_nan());
    assert!((geometric_mean(&[2.0, 8.0]) - 4.0).abs() < 1e-12);
}

#[test]
fn an_interval_holds_its_ratio() {
    let before = [1.0, 1.1, 0.9, 1.0, 1.2];
    let after = before.map(|time| 2.0 * time);
    let [low, middle, high] = ratio(&before, &after);
    assert_eq!(middle, 2.0);
    assert!(low <= 2.0 && 2.0 <= high && low > 1.4 && high < 2.8, "{low} {high}");
    assert_eq!(ratio(&[1.0, 1.0], &[1.0, 1.0]), [1.0; 3]);
}
