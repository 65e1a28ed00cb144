use super::{Broken, MergeError, Shard, Tally, attempt, target, targets};

fn run(name: &str, seed: u64, shard: Shard, cases: u64) -> Tally {
    let target = target(name).unwrap();
    let mut tally = Tally::new(&target, seed, shard);
    (0..shard.share(cases)).for_each(|_| tally.step(&target));
    tally
}

#[test]
fn every_target_holds_but_the_canary() {
    for target in targets() {
        let cases = if target.is_canary() { 200 } else { 12 };
        let tally = run(target.name, 1, Shard::WHOLE, cases);
        assert_eq!(tally.executions, cases);
        assert_eq!(tally.findings.is_empty(), !target.is_canary(), "{:?}", tally.findings);
        let idle = target.laws().into_iter().filter(|law| !tally.tried.contains_key(*law));
        assert_eq!(idle.count(), 0, "{}: {:?}", target.name, tally.tried);
    }
}

#[test]
fn shards_add_up_in_any_order() {
    let whole = run("canary", 3, Shard::WHOLE, 101);
    assert!(!whole.findings.is_empty());
    let mut shards: Vec<Tally> =
        [5, 2, 7, 0, 1, 6, 3, 4].map(|i| run("canary", 3, Shard::of(i, 8).unwrap(), 101)).into();
    assert_eq!(Tally::merged(&shards), Ok(whole.clone()));
    shards.reverse();
    assert_eq!(Tally::merged(&shards), Ok(whole));
}

#[test]
fn shards_that_do_not_fit_are_refused() {
    let shard = |i, n| run("canary", 3, Shard::of(i, n).unwrap(), 30);
    assert_eq!(Tally::merged(&[]), Err(MergeError::Nothing));
    let missing = Tally::merged(&[shard(0, 3), shard(2, 3)]);
    assert!(matches!(missing, Err(MergeError::Shards { .. } | MergeError::Short(_))));
    let twice = Tally::merged(&[shard(0, 2), shard(0, 2)]);
    assert!(matches!(twice, Err(MergeError::Shards { .. } | MergeError::Short(_))));
    let seeds = [run("canary", 1, Shard::of(0, 2).unwrap(), 30), shard(1, 2)];
    assert_eq!(Tally::merged(&seeds), Err(MergeError::Campaigns));
    let short = [run("canary", 3, Shard::of(0, 2).unwrap(), 20), shard(1, 2)];
    assert!(matches!(Tally::merged(&short), Err(MergeError::Short(_))));
    assert_eq!((Shard::of(2, 2), Shard::of(0, 0)), (None, None));
}

#[test]
fn seeds_and_targets_share_no_case() {
    let target = target("delaunay-2d").unwrap();
    let prints: std::collections::BTreeSet<u64> = (0..4)
        .flat_map(|seed| (0..50).map(move |k| [seed, k]))
        .map(|[seed, k]| target.case(seed, k).fingerprint())
        .collect();
    // Small cases repeat by chance: no points, one point at 0.
    assert!(prints.len() > 150, "{}", prints.len());
}

#[test]
fn a_panic_is_caught_with_its_place() {
    let broken = attempt("law", || panic!("cell 17 of 3 has no twin")).unwrap_err();
    assert!(broken.place.starts_with("crates/laws/src/fuzz/tests.rs:"), "{}", broken.place);
    assert_eq!(broken.message, "cell 17 of 3 has no twin");
    assert!(broken.bucket().ends_with("cell of has no twin"), "{}", broken.bucket());
    assert_eq!(attempt("law", || 5), Ok(5));
}

#[test]
fn buckets_tell_causes_apart() {
    let broken = |place: &str, message: &str| {
        Broken { law: "valid".into(), place: place.into(), message: message.into() }.bucket()
    };
    assert_eq!(broken("a:1", "cell 3 is flat"), broken("a:1", "cell 99 is flat"));
    assert_ne!(broken("a:1", "cell 3 is flat"), broken("a:2", "cell 3 is flat"));
    assert_ne!(
        broken("a:1", "rejected\n  fault   3 is flat"),
        broken("a:1", "rejected\n  fault   3 overlaps")
    );
}
