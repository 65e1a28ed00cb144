//! Generated inputs that shrink: towards smaller integers, no nudge. Always the same ones, unless `DELONE_SEED` says which;
//! as many as a test says, unless `DELONE_CASES` does.

use proptest::prelude::{Just, Strategy, any, prop_oneof};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

use crate::exact::{nudged, power_of_two};

/// A coordinate of the kinds on which algorithms fail.
pub fn coordinate() -> impl Strategy<Value = f64> {
    let small = (-4..=4i32).prop_map(f64::from);
    let wider = (-40..=40i32).prop_map(f64::from);
    let near = (-3..=3i32, -2..=2i32).prop_map(|(x, ulps)| nudged(f64::from(x), ulps));
    let power = (-1074..=1023i32, any::<bool>())
        .prop_map(|(k, negative)| power_of_two(k) * if negative { -1.0 } else { 1.0 });
    let tenths = (-20..=20i32).prop_map(|x| f64::from(x) / 10.0);
    let ends = prop_oneof![Just(0.0), Just(-0.0), Just(5e-324), Just(f64::MAX), Just(-f64::MAX)];
    prop_oneof![12 => small, 3 => wider, 3 => near, 1 => power, 2 => tenths, 1 => ends]
}

/// Runs a property on `cases` inputs, or on as many as `DELONE_CASES` says.
///
/// # Panics
/// If the property does, with the smallest input found on which it does.
pub fn run<S: Strategy>(cases: u32, strategy: &S, property: impl Fn(S::Value)) {
    let cases = crate::number("DELONE_CASES")
        .map_or(cases, |cases| u32::try_from(cases).expect("DELONE_CASES is less than 2^32"));
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    let seed = crate::number("DELONE_SEED").map_or_else(
        || TestRng::deterministic_rng(config.rng_algorithm),
        |seed| {
            let mut bytes = [0; 32];
            bytes[..8].copy_from_slice(&seed.to_le_bytes());
            TestRng::from_seed(RngAlgorithm::ChaCha, &bytes)
        },
    );
    let mut runner = TestRunner::new_with_rng(config, seed);
    let outcome = runner.run(strategy, |value| {
        property(value);
        Ok(())
    });
    outcome.unwrap_or_else(|failure| panic!("{failure}"));
}
