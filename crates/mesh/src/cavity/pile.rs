//! A list that grows without asking: whether an item stays is added to the length, and no branch has to be guessed.
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
    /// Adds the item if it is to be kept.
    #[inline(always)]
    pub(super) fn push_if(&mut self, keep: bool, item: T) {
        if let Some(slot) = self.slots.get_mut(self.len) {
            *slot = item;
        } else {
            self.grow(item);
        }
        self.len += usize::from(keep);
    }

    #[cold]
    #[inline(never)]
    fn grow(&mut self, item: T) {
        self.slots.resize(2 * self.slots.len() + 8, item);
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
