//! What a shard of a campaign has seen; shards add up.

use std::collections::BTreeMap;
use std::fmt;

use super::attempt::Broken;
use super::hash::Hash;
use super::target::{Input, Subject, Target};

/// Which cases are a process's: those whose number is `part` modulo `parts`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Shard {
    part: u64,
    parts: u64,
}

impl Shard {
    /// All cases.
    pub const WHOLE: Self = Self { part: 0, parts: 1 };

    /// Shard `part` of `parts`, counted from 0; `None` if there is no such one.
    #[must_use]
    pub fn of(part: u64, parts: u64) -> Option<Self> {
        (part < parts).then_some(Self { part, parts })
    }

    /// Its number, and how many there are.
    #[must_use]
    pub const fn parts(self) -> [u64; 2] {
        [self.part, self.parts]
    }

    /// How many of the cases `0..cases` are this shard's.
    #[must_use]
    pub fn share(self, cases: u64) -> u64 {
        cases.saturating_sub(self.part).div_ceil(self.parts)
    }
}

/// The first case of a bucket.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The number of the case.
    pub case: u64,
    /// How it failed.
    pub broken: Broken,
    /// How many cases failed in this way.
    pub seen: u64,
}

/// A shard's count of what it did.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tally {
    /// The target's name.
    pub target: String,
    /// The seed.
    pub seed: u64,
    /// Whose cases these are; merged tallies are whole.
    pub shard: Shard,
    /// How many cases were run: the first of the shard.
    pub executions: u64,
    /// The sum, over all cases, of a hash of number, input and outcome.
    pub digest: u64,
    /// How often each law was tried.
    pub tried: BTreeMap<String, u64>,
    /// Failures by bucket.
    pub findings: BTreeMap<String, Finding>,
}

impl Tally {
    /// Nothing yet.
    #[must_use]
    pub fn new(target: &Target, seed: u64, shard: Shard) -> Self {
        Self {
            target: target.name.to_owned(),
            seed,
            shard,
            executions: 0,
            digest: 0,
            tried: BTreeMap::new(),
            findings: BTreeMap::new(),
        }
    }

    /// The number of the next case.
    #[must_use]
    pub const fn next(&self) -> u64 {
        self.shard.part + self.executions * self.shard.parts
    }

    /// Runs the next case under the target's laws.
    pub fn step(&mut self, target: &Target) {
        let input = target.case(self.seed, self.next());
        self.step_with(&input, &mut &*target);
    }

    /// Runs the next case, which is `input`, under any subject.
    pub fn step_with(&mut self, input: &Input, subject: &mut impl Subject) {
        let (case, outcome) = (self.next(), subject.try_on(input));
        let mut hash = Hash::default();
        hash.take(case);
        hash.take(input.fingerprint());
        match outcome {
            Ok(tried) => {
                for (law, times) in tried {
                    hash.text(law);
                    hash.take(times as u64);
                    *self.tried.entry(law.to_owned()).or_insert(0) += times as u64;
                }
            }
            Err(broken) => {
                let bucket = broken.bucket();
                hash.text(&bucket);
                let finding = Finding { case, broken, seen: 0 };
                self.findings.entry(bucket).or_insert(finding).seen += 1;
            }
        }
        self.digest = self.digest.wrapping_add(hash.value());
        self.executions += 1;
    }

    /// All shards of one campaign as one; the order does not matter.
    ///
    /// # Errors
    /// If they are of different campaigns, one is there twice, one is missing, or one stopped short of the others.
    pub fn merged(shards: &[Self]) -> Result<Self, MergeError> {
        let first = shards.first().ok_or(MergeError::Nothing)?;
        let mut sorted: Vec<&Self> = shards.iter().collect();
        sorted.sort_by_key(|tally| tally.shard);
        let cases: u64 = shards.iter().map(|tally| tally.executions).sum();
        let (parts, mut whole) = (first.shard.parts, Self { shard: Shard::WHOLE, ..first.empty() });
        for (part, tally) in (0..).zip(&sorted) {
            if (&tally.target, tally.seed) != (&first.target, first.seed) {
                return Err(MergeError::Campaigns);
            }
            let expected = Shard { part, parts };
            if tally.shard != expected {
                return Err(MergeError::Shards { expected, found: tally.shard });
            }
            if tally.executions != tally.shard.share(cases) {
                return Err(MergeError::Short(tally.shard));
            }
            whole.add(tally);
        }
        if sorted.len() as u64 != parts {
            let expected = Shard { part: sorted.len() as u64, parts };
            return Err(MergeError::Shards { expected, found: first.shard });
        }
        Ok(whole)
    }

    fn empty(&self) -> Self {
        let (tried, findings) = (BTreeMap::new(), BTreeMap::new());
        Self { executions: 0, digest: 0, tried, findings, ..self.clone() }
    }

    fn add(&mut self, other: &Self) {
        self.executions += other.executions;
        self.digest = self.digest.wrapping_add(other.digest);
        for (law, times) in &other.tried {
            *self.tried.entry(law.clone()).or_insert(0) += times;
        }
        for (bucket, finding) in &other.findings {
            let kept = self.findings.entry(bucket.clone());
            let kept = kept.or_insert_with(|| Finding { seen: 0, ..finding.clone() });
            let seen = kept.seen + finding.seen;
            if finding.case < kept.case {
                *kept = finding.clone();
            }
            kept.seen = seen;
        }
    }
}

/// Why shards do not add up.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MergeError {
    /// There are none.
    Nothing,
    /// They differ in target or seed.
    Campaigns,
    /// One is missing, there twice, or of another division.
    Shards {
        /// The next in order.
        expected: Shard,
        /// What is there.
        found: Shard,
    },
    /// This one has run fewer cases, or more, than its share of all.
    Short(Shard),
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.part, self.parts)
    }
}

impl fmt::Display for MergeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Nothing => write!(f, "there are no shards to merge"),
            Self::Campaigns => write!(f, "the shards differ in target or seed"),
            Self::Shards { expected, found } => {
                write!(f, "shard {expected} is expected and {found} is there: give each once")
            }
            Self::Short(shard) => {
                write!(f, "shard {shard} has not run its share: resume it with the same --cases")
            }
        }
    }
}

impl std::error::Error for MergeError {}
