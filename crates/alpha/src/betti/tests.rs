use delone_workloads::Rng;

use super::*;
use crate::SimplexId;
use crate::testing::of;

/// The rank over Z/2 of rows, each a list of columns.
fn rank(rows: Vec<Vec<usize>>) -> usize {
    let mut reduced: Vec<Vec<usize>> = Vec::new();
    for mut row in rows {
        row.sort_unstable();
        while let Some(other) = reduced.iter().find(|other| other.last() == row.last()) {
            let mut sum: Vec<usize> = row.iter().chain(other).copied().collect();
            sum.sort_unstable();
            row = sum.chunk_by(|a, b| a == b).filter(|s| s.len() == 1).map(|s| s[0]).collect();
            if row.is_empty() {
                break;
            }
        }
        if !row.is_empty() {
            reduced.push(row);
        }
    }
    reduced.len()
}

/// b_k = n_k - rank of the boundary of k-simplices - that of (k+1)-simplices.
fn by_matrices<const D: usize>(filtration: &AlphaFiltration<D>, cut: Cut, k: usize) -> usize {
    let simplices = filtration.simplices();
    let present =
        |k: usize| simplices.of_dimension(k).filter(|&id| cut.holds(filtration.ranks()[id]));
    let boundary = |k: usize| {
        let facets =
            |id| simplices.facets(SimplexId::new(id)).iter().map(|&f| f as usize).collect();
        rank(present(k).map(facets).filter(|row: &Vec<usize>| !row.is_empty()).collect())
    };
    present(k).count() - boundary(k) - boundary(k + 1)
}

fn check<const D: usize>(points: &[[f64; D]]) {
    let filtration = of(points);
    let curves = filtration.betti_curves();
    assert_eq!(curves, filtration.betti_of(&filtration.persistence()));
    let counts = filtration.simplex_curves();
    for ranks in 0..=narrow(filtration.rank_count()) {
        let cut = Cut::new(ranks);
        let betti = curves.at(cut);
        for (k, &number) in betti.iter().enumerate() {
            assert_eq!(number, by_matrices(&filtration, cut, k), "b{k} at {ranks} of {points:?}");
        }
        let sign = |k: usize| if k.is_multiple_of(2) { 1i64 } else { -1 };
        let alternate = |numbers: &[usize]| -> i64 {
            numbers.iter().enumerate().map(|(k, &n)| sign(k) * i64::from(narrow(n))).sum()
        };
        assert_eq!(alternate(&betti), alternate(&counts.at(cut)), "Euler");
    }
}

#[test]
fn betti_numbers_are_those_of_the_matrices() {
    let mut rng = Rng::new(8);
    let mut points = |count: usize| -> Vec<[f64; 4]> {
        (0..count).map(|_| [0; 4].map(|_| rng.below(6) as f64)).collect()
    };
    for _ in 0..4 {
        check(&points(20).iter().map(|p| [p[0], p[1]]).collect::<Vec<_>>());
        check(&points(14).iter().map(|p| [p[0], p[1], p[2]]).collect::<Vec<_>>());
    }
    check(&points(9));
    check(&[[1.0, 2.0]]);
    check::<2>(&[]);
}

#[test]
fn an_octahedron_encloses_a_void() {
    let octahedron: Vec<[f64; 3]> = (0..6)
        .map(|i| std::array::from_fn(|x| if x == i / 2 { f64::from([1, -1][i % 2]) } else { 0.0 }))
        .collect();
    let filtration = of(&octahedron);
    let curves = filtration.betti_curves();
    // 0, edges at 1/2, triangles at 2/3, the ball at 1.
    assert_eq!(
        filtration.spectrum().map(|v| v.to_f64()).collect::<Vec<_>>(),
        [0.0, 0.5, 2.0 / 3.0, 1.0]
    );
    let betti: Vec<Vec<usize>> = (0..5).map(|ranks| curves.at(Cut::new(ranks))).collect();
    assert_eq!(betti, [[0, 0, 0], [6, 0, 0], [1, 7, 0], [1, 0, 1], [1, 0, 0]]);
}
