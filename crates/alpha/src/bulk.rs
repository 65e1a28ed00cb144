//! Ids in bulk: narrow numbers, lists of lists in two flat arrays.

/// An index as an id of four bytes.
#[inline]
pub(crate) fn narrow(index: usize) -> u32 {
    u32::try_from(index)
        .expect("there are fewer than 2^32 simplices, and facets of those of one dimension")
}

/// Sorts numbers by their high halves, keeping the order of equal ones; returns the low halves. By digits, the lowest first.
pub(crate) fn sort_by_high_half(mut items: Vec<u64>) -> Vec<u32> {
    const BITS: u32 = 11;
    const MASK: u64 = (1 << BITS) - 1;
    let mut spare = vec![0; items.len()];
    for shift in [32, 32 + BITS, 32 + 2 * BITS] {
        let digit = |item: u64| (item >> shift & MASK) as usize;
        let mut next = vec![0u32; 1 << BITS];
        items.iter().for_each(|&item| next[digit(item)] += 1);
        let mut sum = 0;
        next.iter_mut().for_each(|slot| sum += std::mem::replace(slot, sum));
        for &item in &items {
            let slot = &mut next[digit(item)];
            spare[*slot as usize] = item;
            *slot += 1;
        }
        std::mem::swap(&mut items, &mut spare);
    }
    let low_half = |item: u64| u32::try_from(item & u64::from(u32::MAX)).expect("32 bits");
    items.iter().map(|&item| low_half(item)).collect()
}

/// Lists, one for each number below a count, in one array.
#[derive(Clone, Debug)]
pub(crate) struct Lists {
    ends: Vec<u32>,
    items: Vec<u32>,
}

impl Lists {
    /// From pairs of a list and an item, in order.
    pub(crate) fn new(count: usize, pairs: impl Iterator<Item = (usize, u32)> + Clone) -> Self {
        let mut ends = vec![0u32; count + 1];
        pairs.clone().for_each(|(list, _)| ends[list + 1] += 1);
        for i in 0..count {
            ends[i + 1] += ends[i];
        }
        let mut next = ends.clone();
        let mut items = vec![0; ends[count] as usize];
        for (list, item) in pairs {
            items[next[list] as usize] = item;
            next[list] += 1;
        }
        Self { ends, items }
    }

    /// All items, list by list.
    pub(crate) fn into_items(self) -> Vec<u32> {
        self.items
    }

    /// A list.
    pub(crate) fn of(&self, list: usize) -> &[u32] {
        &self.items[self.ends[list] as usize..self.ends[list + 1] as usize]
    }
}

/// Disjoint sets of numbers, each with the least of its members as name.
#[derive(Clone, Debug)]
pub(crate) struct Sets {
    above: Vec<u32>,
}

impl Sets {
    /// Each number below `count` by itself.
    pub(crate) fn new(count: usize) -> Self {
        Self { above: (0..narrow(count)).collect() }
    }

    /// The least member of the set of `x`; paths are halved on the way.
    pub(crate) fn find(&mut self, mut x: u32) -> u32 {
        while self.above[x as usize] != x {
            let up = self.above[self.above[x as usize] as usize]; // strictly down, or a root: it ends
            self.above[x as usize] = up;
            x = up;
        }
        x
    }

    /// Unites two sets of different names; the greater name is gone.
    pub(crate) fn unite(&mut self, a: u32, b: u32) {
        debug_assert!(a != b && self.above[a as usize] == a && self.above[b as usize] == b);
        self.above[a.max(b) as usize] = a.min(b);
    }
}
