use crate::*;

/// Numbers between -1 and 1, the same ones each time.
fn numbers() -> impl FnMut() -> f64 {
    let mut state = 7u64;
    move || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(state >> 32).unwrap()) / 2_147_483_648.0 - 1.0
    }
}

fn sight(kernel: &impl Kernel<3>, vertex: usize, q: usize) -> Sight {
    let mut sight = Sight::default();
    kernel.see(&mut sight, vertex, q);
    sight
}

fn outlook(kernel: &impl Kernel<3>, [a, b, c, d]: &[Sight; 4]) -> Outlook {
    let mut outlook = Outlook::default();
    kernel.look(&mut outlook, [a, b, c, d]);
    outlook
}

/// Whether the tests beyond all facets of some cells are right where they are sure: how many are, and how many there are.
fn sure(points: &[[f64; 3]]) -> (usize, usize) {
    let (kernel, exact) = (Adaptive::new(points), Exact::new(points));
    let (mut sure, mut all) = (0, 0);
    for six in 0..points.len() / 6 {
        let ids: [usize; 6] = std::array::from_fn(|i| 6 * six + i);
        let (cell, apex, q) = ([ids[0], ids[1], ids[2], ids[3]], ids[4], ids[5]);
        let rows = cell.map(|corner| sight(&kernel, corner, q));
        let outlook = outlook(&kernel, &rows);
        for corner in 0..4 {
            all += 1;
            let mut beyond = cell;
            beyond[corner] = apex;
            beyond.swap(0, 1); // the apex is on the other side: so it is the cell beyond that turns the right way
            if let Some(sign) =
                kernel.lifted_beyond(&outlook, corner, &rows[corner ^ 1], &sight(&kernel, apex, q))
            {
                assert_eq!(sign, exact.lifted(&beyond, q), "corner {corner} of {six}");
                sure += 1;
            }
        }
    }
    (sure, all)
}

#[test]
fn tests_beyond_facets_are_those_of_the_cells_there() {
    let mut number = numbers();
    for scale in [1.0, 1e-50, 1e50, 1e-100] {
        let points: Vec<[f64; 3]> =
            (0..6000).map(|_| std::array::from_fn(|_| number() * scale)).collect();
        let (sure, all) = sure(&points);
        // Products of five below the least double decide nothing.
        let floor = if scale < 1e-60 { 0 } else { all * 9 / 10 };
        assert!(sure >= floor && (floor > 0 || sure == 0), "{sure} of {all} at {scale}");
    }
}

#[test]
fn nearly_cospherical_tests_beyond_facets_are_right_or_unsure() {
    let mut number = numbers();
    let mut near = || {
        let v: [f64; 3] = std::array::from_fn(|_| number());
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        v.map(|x| x / length + number() * 2e-16)
    };
    let points: Vec<[f64; 3]> = (0..6000).map(|_| near()).collect();
    let (sure, all) = sure(&points);
    assert!(sure < all / 2, "{sure} of {all}");
}

#[test]
fn on_a_small_lattice_tests_beyond_facets_are_all_sure() {
    let mut number = numbers();
    let points: Vec<[f64; 3]> =
        (0..6000).map(|_| std::array::from_fn(|_| (number() * 3.0).round())).collect();
    let (sure, all) = sure(&points);
    assert_eq!(sure, all);
}

#[test]
fn what_is_not_seen_decides_nothing() {
    let ends = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let points: Vec<_> = ends.into_iter().chain([[1.0; 3], [9.0; 3]]).collect();
    let kernel = Adaptive::new(points); // exact, so that any number would decide
    let seen = [0, 1, 2, 3, 4].map(|vertex| sight(&kernel, vertex, 5));
    let open = outlook(&kernel, &[seen[0], seen[1], seen[2], seen[3]]);
    let (blind, dark) = (Outlook::default(), Sight::default());
    let ask = |outlook, end, apex| Kernel::<3>::lifted_beyond(&kernel, outlook, 0, end, apex);
    assert_eq!(ask(&open, &seen[1], &seen[4]), Some(Sign::Negative)); // far outside of both spheres
    assert_eq!(ask(&blind, &seen[1], &seen[4]), None);
    assert_eq!(ask(&open, &dark, &seen[4]), None);
    assert_eq!(ask(&open, &seen[1], &dark), None);
}
