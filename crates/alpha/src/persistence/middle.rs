//! Classes of the dimensions between the first and the last, by cohomology: columns of cofaces, reduced from the last simplex on.
//!
//! **Paper.** [SMV11], [BKR14]: a column's pivot is the first coface; the columns of simplices that are deaths are zero (clearing),
//! and rows of simplices that are births of the next dimension's classes, known by the union-find, never become pivots: they are
//! left out (compression).

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::{Order, Pair};
use crate::{AlphaFiltration, SimplexId};

/// The pairs of dimension k, those of dimension k - 1 being known, and perhaps those of k + 1.
pub(super) fn pairs<const D: usize>(
    filtration: &AlphaFiltration<D>,
    order: &Order,
    k: usize,
    known: &[Vec<Pair>],
) -> Vec<Pair> {
    let simplices = filtration.simplices();
    let (rows, columns) = (simplices.of_dimension(k + 1), simplices.of_dimension(k));
    let mut is_death = vec![false; columns.len()];
    for pair in &known[k - 1] {
        if let Some(death) = pair.death {
            is_death[death.index() - columns.start] = true;
        }
    }
    let mut is_birth = vec![false; rows.len()];
    known
        .get(k + 1)
        .into_iter()
        .flatten()
        .for_each(|pair| is_birth[pair.birth.index() - rows.start] = true);
    let (start, cofaces) = filtration.cofaces(k);
    let column = |id: u32| {
        let of_it = cofaces.of(id as usize - start).iter();
        of_it
            .filter(|&&row| !is_birth[row as usize - rows.start])
            .map(|&row| order.places[row as usize])
    };
    // By row: the reduced column that has its pivot there. A column that took no other is looked up again.
    let mut owners: Vec<Option<u32>> = vec![None; rows.len()];
    let mut reduced: Vec<Option<Vec<u32>>> = vec![None; rows.len()];
    let mut pairs = Vec::new();
    let mut sum = BinaryHeap::new();
    for id in order.within(&columns).rev() {
        if is_death[id as usize - columns.start] {
            continue;
        }
        sum.extend(column(id).map(Reverse));
        let mut was_added_to = false;
        // Each round takes a pivot, and adds only what comes after it: pivots increase, so it ends.
        while let Some(pivot) = pop_pivot(&mut sum) {
            let row = order.simplices[pivot as usize];
            let slot = row as usize - rows.start;
            let Some(owner) = owners[slot] else {
                owners[slot] = Some(id);
                sum.push(Reverse(pivot));
                if was_added_to {
                    reduced[slot] = Some(drain(&mut sum));
                }
                let [birth, death] = [id, row].map(|id| SimplexId::new(id as usize));
                pairs.push(Pair { birth, death: Some(death) });
                break;
            };
            was_added_to = true;
            sum.push(Reverse(pivot)); // cancelled by the owner's
            match &reduced[slot] {
                Some(rows) => sum.extend(rows.iter().copied().map(Reverse)),
                None => sum.extend(column(owner).map(Reverse)),
            }
        }
        sum.clear();
    }
    pairs
}

/// Takes the least row that is there an odd number of times.
fn pop_pivot(sum: &mut BinaryHeap<Reverse<u32>>) -> Option<u32> {
    loop {
        let Reverse(row) = sum.pop()?;
        if sum.peek() != Some(&Reverse(row)) {
            return Some(row);
        }
        sum.pop();
    }
}

/// All rows of a sum.
fn drain(sum: &mut BinaryHeap<Reverse<u32>>) -> Vec<u32> {
    std::iter::from_fn(|| pop_pivot(sum)).collect()
}
