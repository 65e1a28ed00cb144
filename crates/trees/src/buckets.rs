//! Lists of things, one for each leaf.

/// What is in each leaf, leaf by leaf.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Buckets {
    ends: Vec<usize>,
    items: Vec<u32>,
}

impl Buckets {
    pub(crate) fn push(&mut self, items: &[u32]) {
        self.items.extend(items);
        self.ends.push(self.items.len());
    }

    pub(crate) fn of(&self, leaf: usize) -> &[u32] {
        let start = leaf.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.items[start..self.ends[leaf]]
    }
}

/// An index as it is kept.
pub(crate) fn id(index: usize) -> u32 {
    u32::try_from(index).expect("an index fits 32 bits")
}
