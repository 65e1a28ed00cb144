//! Chains of regions whose boundary is the input, and depths: breadth-first over the regions.

use std::collections::VecDeque;

use delone_sites::{Coverage, Noded};

use super::{Fill, FillError, OpenVertex, Role};
use crate::regions::Regions;

/// The fewest subsegments on any way from the exterior into each region.
pub(super) fn depths(regions: &Regions) -> Vec<u32> {
    spread(regions, |depth: u32, _, _| depth + 1)
}

/// The chain that a rule asks for, if it asks for one.
pub(super) fn of_rule(
    regions: &Regions,
    graph: &impl Noded,
    fill: &Fill,
) -> Result<Option<Vec<i64>>, FillError> {
    match fill {
        Fill::EvenOdd => parity(regions, graph, &graph.coverage()).map(Some),
        Fill::Tagged(roles) => {
            let segments = graph.segments().len();
            if roles.len() != segments {
                return Err(FillError::Roles { segments, roles: roles.len() });
            }
            let bounds = |segment: u32| roles[segment as usize] == Role::Boundary;
            parity(regions, graph, &graph.coverage_where(bounds)).map(Some)
        }
        Fill::NonZero | Fill::Positive => winding(regions, graph, &graph.coverage()).map(Some),
        Fill::Hull | Fill::Nesting | Fill::Exterior | Fill::Seeds(_) => Ok(None),
    }
}

fn parity(
    regions: &Regions,
    graph: &impl Noded,
    coverage: &[Coverage],
) -> Result<Vec<i64>, FillError> {
    let times = |subsegment: usize| i64::from(coverage[subsegment].times);
    let open = excesses(regions, graph, |subsegment| [times(subsegment); 2], |sum| sum % 2 != 0);
    if !open.is_empty() {
        return Err(FillError::OddVertices(open));
    }
    let chain = spread(regions, |parity, subsegment, _| (parity + times(subsegment)) % 2);
    check(regions, |subsegment, [left, right]| (left + right + times(subsegment)) % 2 == 0, &chain);
    Ok(chain)
}

fn winding(
    regions: &Regions,
    graph: &impl Noded,
    coverage: &[Coverage],
) -> Result<Vec<i64>, FillError> {
    let net = |subsegment: usize| coverage[subsegment].net;
    let open = excesses(regions, graph, |s| [-net(s), net(s)], |sum| sum != 0);
    if !open.is_empty() {
        return Err(FillError::Unbalanced(open));
    }
    let chain = spread(regions, |winding: i64, subsegment, leftwards| {
        winding + if leftwards { net(subsegment) } else { -net(subsegment) }
    });
    check(regions, |subsegment, [left, right]| left - right == net(subsegment), &chain);
    Ok(chain)
}

/// The vertices where what the separating subsegments bring, to their smaller and larger ends, adds up to what `is_open`.
fn excesses(
    regions: &Regions,
    graph: &impl Noded,
    brought: impl Fn(usize) -> [i64; 2],
    is_open: impl Fn(i64) -> bool,
) -> Vec<OpenVertex> {
    let mut sums = vec![0; graph.positions().len()];
    for (subsegment, ends) in graph.subsegments().iter().enumerate() {
        if regions.separates(subsegment) {
            for (&end, value) in ends.iter().zip(brought(subsegment)) {
                sums[end as usize] += value;
            }
        }
    }
    let vertices = graph.names().into_iter().zip(graph.positions()).zip(sums);
    let open = vertices.filter(|&(_, sum)| is_open(sum));
    open.map(|((point, &at), excess)| OpenVertex { point, at, excess }).collect()
}

/// Spreads values from the exterior, which has the zero as has what it meets at the hull, into all regions, breadth first. `step` is given the value, the
/// subsegment crossed, and whether from its right to its left.
fn spread<T: Copy + Default>(regions: &Regions, step: impl Fn(T, usize, bool) -> T) -> Vec<T> {
    let neighbours = regions.neighbours();
    let mut values: Vec<Option<T>> = vec![None; regions.count()];
    let mut queue = VecDeque::new();
    for &start in [0].iter().chain(regions.shore()) {
        values[start as usize] = Some(T::default());
        queue.push_back((start as usize, T::default()));
    }
    while let Some((region, value)) = queue.pop_front() {
        for next in &neighbours[region] {
            let there = next.to as usize;
            if values[there].is_none() {
                let value = step(value, next.subsegment, next.leftwards);
                values[there] = Some(value);
                queue.push_back((there, value));
            }
        }
    }
    let found = values.into_iter();
    found.map(|value| value.expect("a way leads from infinity into every region")).collect()
}

/// The certificate: across every separating subsegment the chain changes as the input says.
fn check(regions: &Regions, fits: impl Fn(usize, [i64; 2]) -> bool, chain: &[i64]) {
    for (subsegment, sides) in regions.sides().iter().enumerate() {
        if regions.separates(subsegment) {
            let values = sides.map(|region| chain[region as usize]);
            assert!(fits(subsegment, values), "a closed chain on a disk is a boundary");
        }
    }
}
