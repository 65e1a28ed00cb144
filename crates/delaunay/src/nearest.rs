//! The nearest site of each of many points.
//!
//! **Paper.** [DPT02] has the walk over vertices among its variants: go to any neighbour nearer to the goal. **Why.** A
//! vertex of a Delaunay mesh with no nearer neighbour is a nearest site: if another site were nearer, the point would be
//! outside the vertex's Voronoi region, whose sides are given by its neighbours. In a flat this holds for points off the
//! flat as well: distances from those order as from their feet.
//! **Cost.** The neighbours of all sites are listed once; then O(1) steps for each of many evenly spread points. Distances
//! are compared exactly.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | several sites at one distance | the least in lexicographic order | `ties_go_to_the_least_site` |
//! | all sites in a flat, the point off it | the nearest all the same | `in_a_flat_and_off_it` |

use std::cmp::Ordering;
use std::num::NonZeroUsize;

use delone_mesh::Mesh;
use delone_sites::{Sites, SitesError};

use crate::Delaunay;
use crate::numbers::compare_distances;
use crate::queries::Queries;
use crate::result::id_of;

/// The nearest site of each point, on up to `threads` threads, which make no difference; `None` if there are no sites.
///
/// ```
/// use std::num::NonZeroUsize;
/// use delone_delaunay::{Options, delaunay, nearest_sites};
/// use delone_sites::Sites;
///
/// let sites = Sites::new(&[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]]).unwrap();
/// let triangulation = delaunay(&sites, &Options::default(), &mut ());
/// let found = nearest_sites(&triangulation, &sites, &[[3.0, 9.0], [9.0, -1.0]], NonZeroUsize::MIN);
/// assert_eq!(found.unwrap(), [Some(2), Some(1)]);
/// ```
///
/// # Errors
/// If a coordinate is not finite.
pub fn nearest_sites<const D: usize>(
    delaunay: &Delaunay<D>,
    sites: &Sites<D>,
    points: &[[f64; D]],
    threads: NonZeroUsize,
) -> Result<Vec<Option<u32>>, SitesError> {
    let queries = Queries::new(sites, points)?;
    if sites.is_empty() {
        return Ok(vec![None; points.len()]);
    }
    let graph = Graph::of(delaunay.mesh(), sites.len());
    let ranks = sites.ranks();
    Ok(queries.answer(threads, |queries, hint: &mut u32, query| {
        let (q, _) = queries.get(query);
        let order = |u: u32, v: u32| {
            let (p, r) = (&sites.points()[u as usize], &sites.points()[v as usize]);
            compare_distances(&q, p, r)
        };
        *hint = descend(&graph, *hint, order);
        Some(least_of_ties(&graph, *hint, |u, v| order(u, v) == Ordering::Equal, &ranks))
    }))
}

/// The neighbours of each site, one after the other.
struct Graph {
    first: Vec<u32>,
    to: Vec<u32>,
}

impl Graph {
    fn of<const D: usize>(mesh: &Mesh<D>, sites: usize) -> Self {
        let mut pairs = Vec::new();
        for cell in mesh.solid_cells() {
            let corners = mesh.corners(cell);
            for &u in corners {
                pairs.extend(corners.iter().filter(|&&v| v != u).map(|&v| (id_of(u), id_of(v))));
            }
        }
        pairs.sort_unstable();
        pairs.dedup();
        let ends = (0u32..).take(sites + 1);
        let first = ends.map(|site| pairs.partition_point(|&(u, _)| u < site));
        let first = first.map(|place| u32::try_from(place).expect("fewer than 2^32 edges"));
        Self { first: first.collect(), to: pairs.iter().map(|&(_, v)| v).collect() }
    }

    fn neighbours(&self, site: u32) -> &[u32] {
        let (start, end) = (self.first[site as usize], self.first[site as usize + 1]);
        &self.to[start as usize..end as usize]
    }
}

/// From neighbour to nearer neighbour, until there is none.
fn descend(graph: &Graph, start: u32, order: impl Fn(u32, u32) -> Ordering) -> u32 {
    let mut at = start;
    for _ in 0..graph.first.len() {
        let nearer = graph.neighbours(at).iter().find(|&&next| order(next, at) == Ordering::Less);
        match nearer {
            Some(&next) => at = next,
            None => return at,
        }
    }
    panic!("each step is nearer, so no site comes twice")
}

/// The least in rank of the sites at the distance of `site`: they are the corners of one Delaunay cell, before ties are
/// broken, and so a connected part of the mesh.
fn least_of_ties(
    graph: &Graph,
    site: u32,
    is_tie: impl Fn(u32, u32) -> bool,
    ranks: &[u32],
) -> u32 {
    let mut ties = vec![site];
    let mut seen = 0;
    while let Some(&at) = ties.get(seen) {
        seen += 1;
        for &next in graph.neighbours(at) {
            if !ties.contains(&next) && is_tie(next, site) {
                ties.push(next);
            }
        }
    }
    ties.into_iter().min_by_key(|&site| ranks[site as usize]).expect("the site itself is one")
}

#[cfg(test)]
mod tests;
