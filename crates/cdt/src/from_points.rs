//! From points and segments to the CDT, noding on the way.
//!
//! Segment insertion walks along each segment anyway: it comes upon every site inside it, and upon every segment that it
//! crosses. So the door's own search for these, which costs as much as the triangulation, is left out; it is asked only
//! to name what is wrong.

use delone_delaunay::{Options, divide_conquer};
use delone_predicates::{Adaptive, Kernel};
use delone_probe::Probe;
use delone_sites::{Pslg, PslgError, Unnoded, sweep};

use crate::cavity::node_and_insert;
use crate::{Cdt, chain, chew};

/// The noded PSLG of points and segments (pairs of point indices), and its CDT: what [`Pslg::new`] and [`crate::cavity()`] make of
/// them, in half the time.
///
/// ```
/// use delone_cdt::from_points;
///
/// let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [1.0, 1.0]];
/// let (pslg, cdt) = from_points(&points, &[[0, 1]], &mut ()).unwrap();
/// assert_eq!(pslg.subsegments(), [[0, 2], [1, 2]]);
/// assert_eq!(cdt.constrained_edges(), pslg.subsegments());
/// ```
///
/// # Errors
/// As [`Pslg::new`].
pub fn from_points(
    points: &[[f64; 2]],
    segments: &[[usize; 2]],
    probe: &mut impl Probe,
) -> Result<(Pslg, Cdt), PslgError> {
    let graph = Unnoded::new(points, segments)?;
    let kernel = Adaptive::new(graph.sites().points());
    let mesh = divide_conquer(&kernel, graph.sites(), probe);
    if mesh.dimension() != Some(2) {
        let pslg = Pslg::new(points, segments)?;
        let constrained = chain::constrained_cells(&mesh, pslg.subsegments());
        return Ok((pslg, Cdt::new(mesh, constrained)));
    }
    match node_and_insert(mesh, &kernel, graph.sites().len(), graph.segments(), probe) {
        Ok((mesh, constrained, pieces)) => Ok((graph.noded(&pieces), Cdt::new(mesh, constrained))),
        Err(_) => Err(Pslg::new(points, segments)
            .expect_err("segments cross: the walk along one met another")),
    }
}

/// [`from_points`] by Chew's algorithm: one sweep over the segments nodes them and finds what is next below and above each site.
///
/// # Errors
/// As [`Pslg::new`].
pub fn chew_from_points(
    points: &[[f64; 2]],
    segments: &[[usize; 2]],
    probe: &mut impl Probe,
) -> Result<(Pslg, Cdt), PslgError> {
    let graph = Unnoded::new(points, segments)?;
    let sites = graph.sites();
    let kernel = Adaptive::new(sites.points()).reordered(sites.sorted());
    let swept = sweep(&kernel, sites.len(), &graph.ranked());
    let meshed = swept.and_then(|mut swept| {
        let rings = chew::chew(&kernel, &mut swept, sites.sorted(), probe);
        Some((chew::hand_over(rings, &kernel, sites.sorted())?, swept))
    });
    if let Some(((mesh, constrained), swept)) = meshed {
        return Ok((graph.swept(&swept), Cdt::new(mesh, constrained)));
    }
    // Segments cross, at least at sites, or all sites are in line.
    let pslg = Pslg::new(points, segments)?;
    let cdt = chew(&pslg, &Options::default(), probe);
    Ok((pslg, cdt))
}

#[cfg(test)]
mod tests;
