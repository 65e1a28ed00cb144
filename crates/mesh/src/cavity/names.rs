//! Small numbers for the vertices of a cavity in space: what is known of a vertex is then found in a small table.
//!
//! **Invariants.** 1. Between two calls no vertex has a name. 2. Who has none though it asked is called 0, and then there were too many.

use crate::VertexId;

/// Names are 1 to 63; 0 is nobody's.
pub(super) const NAMES: usize = 64;

/// The names given.
#[derive(Clone, Debug)]
pub(super) struct Names {
    /// By vertex, as [`VertexId::place`] has them.
    of: Vec<u8>,
    /// By name: the places of the vertices that have one.
    named: [usize; NAMES],
    /// How many asked and had none; at most 255.
    asked: u8,
}

impl Default for Names {
    fn default() -> Self {
        Self { of: Vec::new(), named: [0; NAMES], asked: 0 }
    }
}

impl Names {
    /// The name of a vertex, which gets one if it has none.
    #[inline(always)]
    pub(super) fn give(&mut self, vertex: VertexId) -> u8 {
        let place = vertex.place();
        if place >= self.of.len() {
            self.grow(place);
        }
        let next = if usize::from(self.asked) < NAMES - 1 { self.asked + 1 } else { 0 };
        let known = self.of[place];
        let name = if known == 0 { next } else { known };
        self.named[usize::from(next) % NAMES] = place; // of no consequence unless the name is given
        self.asked = self.asked.saturating_add(u8::from(known == 0));
        self.of[place] = name;
        name
    }

    /// The name of a vertex that asked before.
    #[inline(always)]
    pub(super) fn of(&self, vertex: VertexId) -> u8 {
        self.of[vertex.place()]
    }

    /// Whether everyone who asked has one. Inv 2
    #[inline(always)]
    pub(super) fn suffice(&self) -> bool {
        usize::from(self.asked) < NAMES
    }

    /// Takes all names back. Inv 1
    pub(super) fn forget(&mut self) {
        for &place in &self.named[1..=usize::from(self.asked).min(NAMES - 1)] {
            self.of[place] = 0;
        }
        self.asked = 0;
    }

    #[cold]
    #[inline(never)]
    fn grow(&mut self, place: usize) {
        self.of.resize(2 * place + 1, 0);
    }
}
