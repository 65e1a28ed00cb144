//! A target of `delone fuzz` under libFuzzer: its bytes are the generator's choices, so that what it mutates is always an input.

use std::sync::LazyLock;

use delone_laws::choices::Bytes;
use delone_laws::fuzz::{Subject, Target, targets};

static TARGETS: LazyLock<Vec<Target>> = LazyLock::new(targets);

/// Demands the target's laws of the input that these bytes choose.
///
/// # Panics
/// If there is no such target, or a law is broken: with the law and the input.
pub fn hold(name: &str, bytes: &[u8]) {
    let target = TARGETS.iter().find(|target| target.name == name).expect("a target of delone fuzz");
    let input = target.chosen(&mut Bytes(bytes));
    let mut subject = target;
    if let Err(broken) = subject.try_on(&input) {
        panic!("{broken}\n{input:?}");
    }
}
