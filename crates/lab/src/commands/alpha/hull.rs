//! The alpha hull, by the arcs that bound it.

use std::any::Any;

use delone_alpha::{AlphaFiltration, AlphaParam, Cut};
use delone_draw::Arc;

use super::{Task, figures};

/// The arcs of a complex of the plane, by the input's points; none in other dimensions.
pub(super) fn arcs<const D: usize>(
    task: &Task<'_>,
    param: AlphaParam,
    cut: Cut,
    filtration: &AlphaFiltration<D>,
) -> Vec<Arc> {
    let filtration: &dyn Any = filtration;
    let Some(filtration) = filtration.downcast_ref::<AlphaFiltration<2>>() else {
        return Vec::new();
    };
    let last = cut.ranks().checked_sub(1).map(|rank| filtration.value_of_rank(rank));
    let radius = match param {
        AlphaParam::Radius(radius) => radius,
        AlphaParam::Squared(square) => square.sqrt(),
        AlphaParam::Inverse(inverse) => 1.0 / inverse,
        _ => last.map_or(0.0, |value| figures::radius(&value)),
    };
    let names = task.subject.names();
    let arc = |ends: [u32; 2]| Arc { ends: ends.map(|v| names[v as usize]), radius };
    filtration.polygons(cut).hull_arcs().into_iter().map(arc).collect()
}
