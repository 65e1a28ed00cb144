//! `.neigh`, written only: `n corners`, then per cell its number and the cell opposite each corner, -1 for none.
//!
//! A facet that more than two cells share has no neighbour in this format: -1.

use std::collections::BTreeMap;
use std::io::{self, Write};

use super::ele::cells;
use crate::document::Document;

pub(crate) fn write(document: &Document, out: &mut impl Write) -> io::Result<()> {
    let cells = cells(document);
    let mut sides: BTreeMap<Vec<u32>, Vec<usize>> = BTreeMap::new();
    for (i, cell) in cells.iter().enumerate() {
        for corner in 0..cell.len() {
            sides.entry(facet(cell, corner)).or_default().push(i);
        }
    }
    let first = usize::from(document.first_index == 1);
    writeln!(out, "{} {}", cells.len(), document.dimension + 1)?;
    for (i, cell) in cells.iter().enumerate() {
        write!(out, "{}", i + first)?;
        for corner in 0..cell.len() {
            match sides.get(&facet(cell, corner)).map(Vec::as_slice) {
                Some(&[a, b]) => write!(out, " {}", if a == i { b } else { a } + first)?,
                _ => write!(out, " -1")?,
            }
        }
        writeln!(out)?;
    }
    Ok(())
}

fn facet(cell: &[u32], opposite: usize) -> Vec<u32> {
    let mut facet = cell.to_vec();
    facet.remove(opposite);
    facet.sort_unstable();
    facet
}
