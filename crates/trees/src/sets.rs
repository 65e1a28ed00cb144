//! Set operations: one pass over both codes.
//!
//! **Paper.** \[HS79\] (union and intersection in time linear in the trees).
//!
//! **In / Out.** Two trees over the same root; the tree of the result, in normal form.
//!
//! **Cost.** O(n + m). Where one tree has a leaf, the other's subtree is read once and its colours mapped.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | the result is all or nothing | one leaf | `set_algebra_holds` |

use crate::{Colour, OrthTree};

#[cfg(test)]
mod tests;

impl<const N: usize> OrthTree<N> {
    /// What is in either.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        self.combine(other, |a, b| a | b)
    }

    /// What is in both.
    #[must_use]
    pub fn intersection(&self, other: &Self) -> Self {
        self.combine(other, |a, b| a & b)
    }

    /// What is in this and not in the other.
    #[must_use]
    pub fn difference(&self, other: &Self) -> Self {
        self.combine(other, |a, b| a & !b)
    }

    /// What is in one of them only.
    #[must_use]
    pub fn symmetric_difference(&self, other: &Self) -> Self {
        self.combine(other, |a, b| a ^ b)
    }

    /// What is not in it.
    #[must_use]
    pub fn complement(&self) -> Self {
        Self::of_normal(self.colours().iter().map(|colour| colour.complement()).collect())
    }

    /// What the operation says of being inside the one and the other.
    ///
    /// ```
    /// use delone_trees::OrthTree;
    ///
    /// let (a, b) = (OrthTree::<1>::from_text("(WB")?, OrthTree::<1>::from_text("((WBB")?);
    /// assert_eq!(a.combine(&b, |a, b| b & !a).to_text(), "((WBW");
    /// # Ok::<(), delone_trees::CodeFault>(())
    /// ```
    #[must_use]
    pub fn combine(&self, other: &Self, op: impl Fn(bool, bool) -> bool) -> Self {
        let mut writer = Self::writer();
        let (mut left, mut right) = (self.colours(), other.colours());
        // Both are at the same cell.
        while let (Some((&a, rest_a)), Some((&b, rest_b))) =
            (left.split_first(), right.split_first())
        {
            let (black_a, black_b) = (a == Colour::Black, b == Colour::Black);
            match (a, b) {
                (Colour::Gray, Colour::Gray) => {
                    writer.push(Colour::Gray);
                    (left, right) = (rest_a, rest_b);
                }
                (Colour::Gray, _) => {
                    let (subtree, rest) = left.split_at(Self::subtree_len(left));
                    let map = |black| op(black, black_b);
                    subtree.iter().for_each(|&colour| writer.push(mapped(colour, map)));
                    (left, right) = (rest, rest_b);
                }
                _ => {
                    let (subtree, rest) = right.split_at(Self::subtree_len(right));
                    let map = |black| op(black_a, black);
                    subtree.iter().for_each(|&colour| writer.push(mapped(colour, map)));
                    (left, right) = (rest_a, rest);
                }
            }
        }
        Self::written(writer)
    }

    /// How many nodes the subtree has that a code begins with.
    fn subtree_len(code: &[Colour]) -> usize {
        let mut missing = 1;
        let mut len = 0;
        while missing > 0 {
            missing =
                if code[len] == Colour::Gray { missing + Self::ARITY - 1 } else { missing - 1 };
            len += 1;
        }
        len
    }
}

fn mapped(colour: Colour, map: impl Fn(bool) -> bool) -> Colour {
    match colour {
        Colour::Gray => Colour::Gray,
        leaf => Colour::of(map(leaf == Colour::Black)),
    }
}
