//! A list that grows without asking: items are written one after the other, and of each it is added to a length whether it stays.
//!
//! What is found about cells and vertices in a cavity is as good as random. A mispredicted branch for each would cost
//! more than all the rest.

/// A list of small things.
#[derive(Clone, Debug)]
pub(super) struct Pile<T> {
    /// Those on the list, and worthless ones after them.
    slots: Vec<T>,
    len: usize,
}

impl<T> Default for Pile<T> {
    fn default() -> Self {
        Self { slots: Vec::new(), len: 0 }
    }
}

impl<T: Copy> Pile<T> {
    /// Slots after the list, for `count` items or for one at least: whoever writes an item that does not stay writes the next
    /// in its place.
    #[inline(always)]
    pub(super) fn room(&mut self, count: usize, filler: T) -> &mut [T] {
        let end = self.len + count + 1;
        if end > self.slots.len() {
            self.grow(end, filler);
        }
        &mut self.slots[self.len..end]
    }

    /// Takes in the first `count` items of the room.
    #[inline(always)]
    pub(super) fn keep(&mut self, count: usize) {
        self.len += count;
    }

    /// Adds an item.
    #[inline(always)]
    pub(super) fn push(&mut self, item: T) {
        self.room(1, item)[0] = item;
        self.keep(1);
    }

    #[cold]
    #[inline(never)]
    fn grow(&mut self, end: usize, filler: T) {
        self.slots.resize(2 * end, filler);
    }

    #[inline(always)]
    pub(super) fn len(&self) -> usize {
        self.len
    }

    #[inline(always)]
    pub(super) fn clear(&mut self) {
        self.len = 0;
    }

    #[inline(always)]
    pub(super) fn as_slice(&self) -> &[T] {
        &self.slots[..self.len]
    }
}
