//! Cross-crate tests: laws x algorithms x corpus, exhaustive small worlds, opponents.
//!
//! | net (a file of `tests/`) | what it demands | of |
//! |---|---|---|
//! | `laws` | all [`laws`] | the whole [`corpus`] |
//! | `exhaustive` | the definition, by brute force | every small input of a kind |
//! | `cavities` | validity | 8,000 wide cavities with dangling edges |
//! | `lecture` | areas done by hand, under every rule | the fifteen soups of the lecture |
//! | `crossings` | agreement, and the judge's proof | segments that cross |
//! | `predicates` | the exact sign | 10^5 calls, over the full range of doubles |
//! | `constructed` | the mesh of similar plain points; that by rationals | algorithms over constructed points |
//! | `cgal`, `spade` | the same triangulation as another program's | workloads, and the collected files |
//! | `gudhi` | the same alpha values as another program's | workloads, small integers, the collected files |
//! | `dimensions` | Qhull's cells, in general position; validity | four, five and six dimensions |
//! | `trees` | exact areas and volumes between; codes, sets and components, these as scipy's | workloads, and the collected files |
//! | `generated` | all laws, shrinking what fails | the first cases of every target of the fuzzer |
//! | `regressions` | all laws | `regressions/`, which only grows |
//!
//! **Order of trust** where programs disagree: the judge (`delone::check`), CGAL, spade.
//!
//! **In.** Nothing. The collected files are looked for in `../shared/data`, beside the workspace, or in the folder that
//! `DELONE_DATA` names; CGAL at `target/peers/cgal` (`cargo xtask setup`). Gudhi in the
//! Python that `DELONE_PYTHON` names, or in `python3`. What is not there is skipped, and said so.
//! With `DELONE_LONG=1` the largest files are taken as well; `DELONE_FILES` is a part of the paths of those that are taken. `DELONE_CASES` and `DELONE_SEED` say how many generated inputs,
//! and which: `DELONE_CASES=1000000 cargo test --release -p delone-tests --test generated algorithms_agree`.
//!
//! **Modules.** [`case`] one input; [`corpus`] all of them, of [`hand`] and [`data`]; [`judge`] and [`cells`] what is
//! compared; [`laws`]; [`alpha`]; [`generated`] inputs that shrink; [`cgal`], [`gudhi`], [`qhull`] and [`scipy`] the opponents.

#![expect(clippy::missing_panics_doc, reason = "panicking is how a test's helper speaks")]

pub mod alpha;
pub mod cgal;
pub mod corpus;
pub mod data;
pub mod generated;
pub mod gudhi;
pub mod hand;
pub mod qhull;
pub mod scipy;

pub use delone_laws::{case, cells, exact, id, judge, laws};

/// Says on standard error what a test skipped or counted.
#[expect(clippy::print_stderr, reason = "tests tell what they did not do")]
pub fn say(text: impl AsRef<str>) {
    eprintln!("{}", text.as_ref());
}

/// Whether the long version of a test is asked for.
#[must_use]
pub fn long() -> bool {
    std::env::var("DELONE_LONG").is_ok_and(|value| value == "1")
}

/// The number that a variable of the environment holds, if it is set.
#[must_use]
pub fn number(variable: &str) -> Option<u64> {
    let text = std::env::var(variable).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{variable} is no number: {text}")))
}
