//! Triangles that do not keep the bounds, by urgency.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use delone_mesh::{CellId, VertexId};

/// A triangle as it was when it was queued.
type Entry = (CellId, [VertexId; 3]);

/// See the module's text.
#[derive(Debug, Default)]
pub(super) struct Queue {
    heap: BinaryHeap<Reverse<(u64, u32, Entry)>>,
    /// Entries so far, which tell equal keys apart.
    count: u32,
}

impl Queue {
    /// Queues a triangle: less is more urgent.
    pub(super) fn push(&mut self, urgency: u64, cell: CellId, corners: [VertexId; 3]) {
        self.count = self.count.wrapping_add(1);
        self.heap.push(Reverse((urgency, self.count, (cell, corners))));
    }

    pub(super) fn pop(&mut self) -> Option<Entry> {
        self.heap.pop().map(|Reverse((_, _, entry))| entry)
    }

    pub(super) fn is_empty(&self) -> bool {
        self.heap.is_empty()
    }
}
