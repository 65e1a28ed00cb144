//! Black leaves by themselves, without the tree above them.

use std::fmt::Write;

use crate::{Cell, CodeFault, Colour, DEPTH_MAX, OrthTree};

impl<const N: usize> OrthTree<N> {
    /// The tree whose black cells are these: disjoint, in Morton's order. [`OrthTree::black`] is the way back.
    ///
    /// ```
    /// use delone_trees::OrthTree;
    ///
    /// let tree = OrthTree::<3>::from_text("(BWWWWWW(WBBWWWWW")?;
    /// let keys: Vec<_> = tree.black().map(|cell| (cell.level(), cell.key())).collect();
    /// assert_eq!(keys, [(1, 0), (2, 0o71), (2, 0o72)]);
    /// assert_eq!(OrthTree::from_black(&tree.black().collect::<Vec<_>>())?, tree);
    /// # Ok::<(), delone_trees::CodeFault>(())
    /// ```
    ///
    /// # Errors
    /// At the first cell that overlaps one before it or should have come before it.
    pub fn from_black(cells: &[Cell<N>]) -> Result<Self, CodeFault> {
        let mut next = 0;
        let tree = Self::grown(|cell| match cells.get(next) {
            Some(&black) if black == cell => {
                next += 1;
                Colour::Black
            }
            Some(&black) if cell.holds(black) => Colour::Gray,
            _ => Colour::White,
        });
        if next == cells.len() { Ok(tree) } else { Err(CodeFault::Disorder { at: next }) }
    }

    /// Linear codes: for each black leaf a line of `depth` digits, the sons on the way to it, and `X` below. \[Gar82\]
    ///
    /// ```
    /// use delone_trees::OrthTree;
    ///
    /// let tree = OrthTree::<2>::from_text("(BWW(WBBW")?;
    /// assert_eq!(tree.to_linear(), "0X\n31\n32\n");
    /// # Ok::<(), delone_trees::CodeFault>(())
    /// ```
    #[must_use]
    pub fn to_linear(&self) -> String {
        let depth = self.depth();
        let mut text = String::new();
        for cell in self.black() {
            for level in 0..cell.level() {
                write!(text, "{:x}", cell.branch(level)).expect("strings take everything");
            }
            text.extend((cell.level()..depth).map(|_| 'X'));
            text.push('\n');
        }
        text
    }

    /// The tree of linear codes, sorted, one a line.
    ///
    /// # Errors
    /// At the first line that is no code of a cell, overlaps one before it or should have come before it.
    pub fn from_linear(text: &str) -> Result<Self, CodeFault> {
        let cell = |(at, line)| cell_of(line).ok_or(CodeFault::Symbol { at });
        let cells = text.lines().enumerate().map(cell).collect::<Result<Vec<_>, _>>()?;
        Self::from_black(&cells)
    }
}

fn cell_of<const N: usize>(line: &str) -> Option<Cell<N>> {
    let digits = line.trim().trim_end_matches('X');
    digits.chars().try_fold(Cell::ROOT, |cell, digit| {
        let which = usize::try_from(digit.to_digit(16)?).ok()?;
        (which < OrthTree::<N>::ARITY && cell.level() < DEPTH_MAX).then(|| cell.son(which))
    })
}
