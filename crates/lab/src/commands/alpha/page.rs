//! The page with a slider over all complexes of a filtration.

use delone_alpha::{AlphaFiltration, Cut, SimplexId};
use delone_draw::Slider;

use super::Task;
use crate::result::describe;

pub(super) fn slider<const D: usize>(
    task: &Task<'_>,
    filtration: &AlphaFiltration<D>,
    cut: Cut,
) -> String {
    let simplices = filtration.simplices();
    let names = task.subject.names();
    let all = |k: usize| {
        simplices.of_dimension(k).map(SimplexId::new).map(|simplex| {
            let vertices = simplices.vertices(simplex).iter().map(|&v| names[v as usize]);
            (vertices.collect::<Vec<u32>>(), filtration.rank(simplex))
        })
    };
    let (edges, edge_ranks): (Vec<_>, Vec<_>) =
        all(1).map(|(v, rank)| ([v[0], v[1]], rank)).unzip();
    let (triangles, triangle_ranks): (Vec<_>, Vec<_>) =
        all(2).map(|(v, rank)| ([v[0], v[1], v[2]], rank)).unzip();
    let betti = filtration.betti_curves();
    let ranks = filtration.whole().ranks();
    let number = |ranks: u32| {
        betti.at(Cut::new(ranks)).iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
    };
    let values =
        filtration.spectrum().map(|value| format!("{:.6}", super::figures::radius(&value)));
    Slider {
        title: &describe(task.subject),
        points: task.subject.document.points.as_chunks::<2>().0,
        edges: &edges,
        edge_ranks: &edge_ranks,
        triangles: &triangles,
        triangle_ranks: &triangle_ranks,
        values: &values.collect::<Vec<_>>(),
        numbers: &(0..=ranks).map(number).collect::<Vec<_>>(),
        start: cut.ranks() as usize,
        figures: &[
            super::figures::betti_numbers(filtration),
            super::figures::persistence(filtration),
        ],
    }
    .html()
}
