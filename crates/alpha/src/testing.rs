//! What several tests need: a filtration of points, and the definition of its values.

use delone_delaunay::{Options, delaunay};
use delone_sites::Sites;

use crate::{AlphaFiltration, SimplexId, Simplices};

pub(crate) fn of<const D: usize>(points: &[[f64; D]]) -> AlphaFiltration<D> {
    let sites = Sites::new(points).unwrap();
    AlphaFiltration::of(&sites, &delaunay(&sites, &Options::default(), &mut ()))
}

/// A rational number: numerator and positive denominator.
type Ratio = (i128, i128);

/// The values by definition, of distinct points with small integers as coordinates and weights: the least squared radius of all
/// orthogonal spheres of affinely independent subsets of *all* points that contain the simplex, and to which no point has a
/// power below its weight.
pub(crate) fn naive_values<const D: usize>(
    points: &[[f64; D]],
    weights: Option<&[f64]>,
    simplices: &Simplices,
) -> Vec<Ratio> {
    let p: Vec<[i128; D]> = points.iter().map(|p| p.map(|x| x as i128)).collect();
    let w: Vec<i128> = (0..p.len()).map(|i| weights.map_or(0, |w| w[i] as i128)).collect();
    let mut empty: Vec<(u32, Ratio)> = Vec::new();
    for set in 1u32..1 << p.len() {
        if set.count_ones() as usize > D + 1 {
            continue;
        }
        let chosen: Vec<usize> = (0..p.len()).filter(|&i| set >> i & 1 == 1).collect();
        if let Some(radius) = empty_sphere(&p, &w, &chosen) {
            empty.push((set, radius));
        }
    }
    (0..simplices.len())
        .map(|id| {
            let vertices = simplices.vertices(SimplexId::new(id));
            let set = vertices.iter().fold(0u32, |set, &v| set | 1 << v);
            let spheres =
                empty.iter().filter(|(all, _)| all & set == set).map(|&(_, radius)| radius);
            spheres.min_by(|a, b| (a.0 * b.1).cmp(&(b.0 * a.1))).expect("every simplex has a value")
        })
        .collect()
}

/// The squared radius of the smallest sphere orthogonal to some points, if they are independent and no point is inside.
fn empty_sphere<const D: usize>(p: &[[i128; D]], w: &[i128], chosen: &[usize]) -> Option<Ratio> {
    let origin = chosen[0];
    let from = |i: usize| std::array::from_fn::<i128, D, _>(|x| p[i][x] - p[origin][x]);
    let dot = |a: &[i128; D], b: &[i128; D]| (0..D).map(|x| a[x] * b[x]).sum::<i128>();
    let edges: Vec<[i128; D]> = chosen[1..].iter().map(|&i| from(i)).collect();
    let gram: Vec<Vec<i128>> =
        edges.iter().map(|a| edges.iter().map(|b| dot(a, b)).collect()).collect();
    let g = determinant(&gram);
    if g == 0 {
        return None;
    }
    let height = |i: usize| dot(&from(i), &from(i)) + w[origin] - w[i];
    let heights: Vec<i128> = chosen[1..].iter().map(|&i| height(i)).collect();
    // 2 G l = h: l = lambda / 2g.
    let lambda: Vec<i128> = (0..edges.len())
        .map(|column| {
            let mut replaced = gram.clone();
            for (row, h) in replaced.iter_mut().zip(&heights) {
                row[column] = *h;
            }
            determinant(&replaced)
        })
        .collect();
    // The centre, from the origin, times 2g.
    let centre: [i128; D] =
        std::array::from_fn(|x| edges.iter().zip(&lambda).map(|(edge, l)| edge[x] * l).sum());
    let radius = (dot(&centre, &centre) - 4 * g * g * w[origin], 4 * g * g);
    let is_outside = |j: usize| {
        let away = from(j).map(|x| 2 * g * x);
        let away: [i128; D] = std::array::from_fn(|x| centre[x] - away[x]);
        dot(&away, &away) - 4 * g * g * w[j] >= radius.0
    };
    (0..p.len()).all(is_outside).then_some(radius)
}

/// By Laplace's expansion along the first row.
fn determinant(rows: &[Vec<i128>]) -> i128 {
    let Some((first, rest)) = rows.split_first() else { return 1 };
    let minor = |column: usize| -> Vec<Vec<i128>> {
        rest.iter()
            .map(|row| {
                row.iter().enumerate().filter(|(j, _)| *j != column).map(|(_, x)| *x).collect()
            })
            .collect()
    };
    (0..first.len())
        .map(|j| if j % 2 == 0 { 1 } else { -1 } * first[j] * determinant(&minor(j)))
        .sum()
}
