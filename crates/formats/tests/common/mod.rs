//! What the property tests share.

use proptest::test_runner::{Config, RngSeed};

/// `cases` cases, the same ones in each run unless PROPTEST_RNG_SEED says others or PROPTEST_CASES more.
pub(crate) fn cases(cases: u32) -> Config {
    let asked = Config::default();
    let rng_seed = match asked.rng_seed {
        RngSeed::Random => RngSeed::Fixed(1),
        fixed @ RngSeed::Fixed(_) => fixed,
    };
    let cases = if std::env::var_os("PROPTEST_CASES").is_some() { asked.cases } else { cases };
    Config { cases, rng_seed, failure_persistence: None, ..asked }
}
