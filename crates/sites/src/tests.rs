use super::*;

#[test]
fn duplicates_and_negative_zeros_are_one_site() {
    let sites =
        Sites::new(&[[1.0, 0.0], [0.0, 0.0], [1.0, -0.0], [-0.0, 0.0], [0.5, 2.0]]).unwrap();
    assert_eq!(sites.points(), [[1.0, 0.0], [0.0, 0.0], [0.5, 2.0]]);
    assert_eq!(sites.site_of(), [0, 1, 0, 1, 2]);
    assert_eq!(sites.input_of(), [0, 1, 4]);
    assert_eq!(sites.sorted(), [1, 2, 0]);
    assert_eq!(sites.ranks(), [2, 0, 1]);
    assert_eq!(sites.duplicate_count(), 2);
    let alone = Sites::new(&[[-0.0, -0.0]]).unwrap();
    assert!(alone.points()[0].iter().all(|c| c.is_sign_positive()));
    assert!(sites.points().iter().flatten().all(|c| c.is_sign_positive()));
}

#[test]
fn every_coordinate_that_is_not_finite_is_listed() {
    let error =
        Sites::new(&[[0.0, f64::NAN], [1.0, 1.0], [f64::INFINITY, f64::NEG_INFINITY]]).unwrap_err();
    let SitesError::NotFinite(all) = &error else { panic!("{error}") };
    let places: Vec<(usize, usize)> = all.iter().map(|fault| (fault.point, fault.axis)).collect();
    assert_eq!(places, [(0, 1), (2, 0), (2, 1)]);
    assert!(error.to_string().starts_with("point 0 has the coordinate NaN on axis 1"));
}

#[test]
fn the_curve_steps_to_neighbours() {
    fn check<const D: usize>(side: u32) {
        let count = (side as usize).pow(D as u32);
        let points: Vec<[f64; D]> = (0..count)
            .map(|i| {
                std::array::from_fn(|axis| {
                    (i / (side as usize).pow(axis as u32) % side as usize) as f64
                })
            })
            .collect();
        let order = Sites::new(&points).unwrap().hilbert_order();
        for pair in order.windows(2) {
            let [a, b] = [pair[0], pair[1]].map(|i| points[i as usize]);
            let steps: f64 = (0..D).map(|axis| (a[axis] - b[axis]).abs()).sum();
            assert_eq!(steps, 1.0, "{a:?} {b:?}");
        }
    }
    check::<2>(16);
    check::<3>(8);
    check::<4>(4);
}

#[test]
fn a_crowd_in_one_square_of_the_curve_has_its_own() {
    let unit = 2f64.powi(-80);
    let square = |i: u32| [f64::from(i / 16) * unit, f64::from(i % 16) * unit];
    let points: Vec<[f64; 2]> = (0..256).map(square).chain([[1.0, 1.0]]).collect();
    let order = Sites::new(&points).unwrap().hilbert_order();
    assert_eq!(order[256], 256);
    for pair in order[..256].windows(2) {
        let [[x, y], [z, w]] = [pair[0], pair[1]].map(|i| points[i as usize]);
        assert_eq!((x - z).abs() + (y - w).abs(), unit, "{pair:?}");
    }
}

#[test]
fn orders_are_permutations_and_do_not_depend_on_input_order() {
    let points: Vec<[f64; 2]> =
        (0..1000u32).map(|i| [f64::from(i * 7919 % 1009), f64::from(i * 104_729 % 997)]).collect();
    let reversed: Vec<[f64; 2]> = points.iter().rev().copied().collect();
    let (sites, mirror) = (Sites::new(&points).unwrap(), Sites::new(&reversed).unwrap());
    let order = sites.brio_order(7);
    let mut sorted = order.clone();
    sorted.sort_unstable();
    assert!(sorted.iter().enumerate().all(|(i, &site)| i == site as usize));
    let other = mirror.brio_order(7);
    assert!(
        order
            .iter()
            .zip(&other)
            .all(|(&a, &b)| sites.points()[a as usize] == mirror.points()[b as usize])
    );
    assert_ne!(order, sites.brio_order(8));
}

#[test]
fn orders_bear_the_full_range_of_doubles() {
    let points = [[f64::MAX, -f64::MAX], [-f64::MAX, f64::MAX], [5e-324, 0.0], [0.0, 5e-324]];
    assert_eq!(Sites::new(&points).unwrap().brio_order(0).len(), 4);
    let tiny = [[0.0, 0.0], [5e-324, 0.0], [0.0, 5e-324], [5e-324, 5e-324]];
    assert_eq!(Sites::new(&tiny).unwrap().hilbert_order().len(), 4);
    assert_eq!(Sites::<2>::new(&[]).unwrap().brio_order(0), []);
}

#[test]
fn a_site_inside_a_segment_cuts_it() {
    let pslg = Pslg::new(&[[0.0, 0.0], [3.0, 3.0], [1.0, 1.0], [2.0, 2.0]], &[[1, 0]]).unwrap();
    assert_eq!(pslg.subsegments(), [[0, 2], [1, 3], [2, 3]]);
    assert_eq!(pslg.chains().of(0), [1, 2, 0]);
}

#[test]
fn overlaps_share_subsegments() {
    let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]];
    let pslg = Pslg::new(&points, &[[0, 2], [3, 1], [1, 2]]).unwrap();
    assert_eq!(pslg.subsegments(), [[0, 1], [1, 2], [2, 3]]);
    assert_eq!(pslg.chains(), &Chains::from_iter([vec![0, 1], vec![2, 1], vec![1]]));
}

#[test]
fn segments_of_no_length_are_dropped_and_listed() {
    let pslg =
        Pslg::new(&[[0.0, 0.0], [0.0, -0.0], [1.0, 0.0]], &[[0, 1], [2, 1], [2, 2]]).unwrap();
    assert_eq!(pslg.dropped(), [0, 2]);
    assert_eq!(pslg.chains(), &Chains::from_iter([vec![], vec![0], vec![]]));
}

#[test]
fn crossing_at_a_site_is_no_crossing() {
    let points = [[0.0, 0.0], [2.0, 2.0], [0.0, 2.0], [2.0, 0.0], [1.0, 1.0]];
    let pslg = Pslg::new(&points, &[[0, 1], [2, 3]]).unwrap();
    assert_eq!(pslg.subsegments().len(), 4);
    let refused = Pslg::new(&points[..4], &[[0, 1], [2, 3]]).unwrap_err();
    assert_eq!(refused.0, [PslgFault::Crossing(Crossing { segments: [0, 1], near: [1.0, 1.0] })]);
}

#[test]
fn every_crossing_of_a_grid_is_listed() {
    let k = 12usize;
    let mut points = Vec::new();
    let mut segments = Vec::new();
    for i in 0..k {
        let at = i as f64 + 0.5;
        for [a, b] in [[[at, 0.0], [at, k as f64]], [[0.0, at], [k as f64, at]]] {
            segments.push([points.len(), points.len() + 1]);
            points.extend([a, b]);
        }
    }
    let PslgError(faults) = Pslg::new(&points, &segments).unwrap_err();
    let mut pairs = Vec::new();
    for fault in &faults {
        let PslgFault::Crossing(Crossing { segments: [s, t], near }) = *fault else {
            panic!("{fault}")
        };
        assert_eq!((s + t) % 2, 1, "only a column crosses a row");
        let (column, row) = if s % 2 == 0 { (s, t) } else { (t, s) };
        assert_eq!(near, [f64::from(column / 2) + 0.5, f64::from(row / 2) + 0.5]);
        pairs.push([s, t]);
    }
    pairs.dedup();
    assert_eq!(pairs.len(), k * k);
}

#[test]
fn all_kinds_of_nonsense_are_named_at_once() {
    let PslgError(faults) = Pslg::new(&[[0.0, f64::NAN]], &[[0, 3], [7, 0]]).unwrap_err();
    assert_eq!(faults.len(), 3);
    assert!(matches!(faults[1], PslgFault::NoSuchPoint { segment: 0, point: 3, count: 1 }));
    assert!(matches!(faults[2], PslgFault::NoSuchPoint { segment: 1, point: 7, count: 1 }));
}

#[test]
fn the_sweep_agrees_with_all_pairs() {
    let mut state = 11u64;
    let mut next = |below: u64| {
        state = scatter(state);
        state % below
    };
    let (mut crossed, mut clean) = (0, 0);
    for _ in 0..4000 {
        let side = 2 + next(6);
        let points: Vec<[f64; 2]> =
            (0..2 + next(9)).map(|_| [next(side) as f64, next(side) as f64]).collect();
        let count = points.len() as u64;
        let segments: Vec<[usize; 2]> =
            (0..next(6)).map(|_| [next(count) as usize, next(count) as usize]).collect();
        // All pairs, by the same definition: noded pieces that cross.
        let noded = Pslg::noded_for_tests(&points, &segments);
        let at = |site: u32| noded.sites().points()[site as usize];
        let pieces = noded.subsegments();
        let mut any = false;
        for (i, &[a, b]) in pieces.iter().enumerate() {
            for &[c, d] in &pieces[..i] {
                let side =
                    |p: u32, q: u32, r: u32| delone_predicates::orient2d(at(p), at(q), at(r));
                let negative = delone_predicates::Sign::Negative;
                any |= side(a, b, c) * side(a, b, d) == negative
                    && side(c, d, a) * side(c, d, b) == negative;
            }
        }
        assert_eq!(Pslg::new(&points, &segments).is_err(), any, "{points:?} {segments:?}");
        *(if any { &mut crossed } else { &mut clean }) += 1;
    }
    assert!(crossed > 200 && clean > 200, "{crossed} {clean}");
}

#[test]
fn spokes_with_a_common_end_do_not_cross() {
    // Enough of them that looking at all pairs would be felt.
    let spokes = 20_000;
    let mut points = vec![[0.0, 0.0]];
    points.extend((0..spokes).map(|i| [f64::from(i) - 10_000.0, 1.0 + f64::from(i * i % 101)]));
    let segments: Vec<[usize; 2]> = (1..points.len()).map(|i| [0, i]).collect();
    let pslg = Pslg::new(&points, &segments).unwrap();
    assert!(pslg.subsegments().len() >= 19_000);
}

#[test]
fn sites_are_sorted_as_coordinates_compare() {
    let values =
        [f64::MIN, -2.0, -1.0, -f64::MIN_POSITIVE, -5e-324, 0.0, 5e-324, 1.0, 1.5, 2.0, f64::MAX];
    assert!(values.is_sorted_by_key(|&value| sortable(value)));
    // Every triple of them, scattered, each twice.
    let mut points: Vec<[f64; 3]> = values
        .iter()
        .flat_map(|&x| values.map(|y| values.map(|z| [x, y, z])).into_iter().flatten())
        .collect();
    points
        .sort_by_key(|point| scatter(point.iter().fold(0, |hash, c| scatter(hash ^ c.to_bits()))));
    let distinct = Sites::new(&points).unwrap();
    points.extend_from_within(..);
    let sites = Sites::new(&points).unwrap();
    assert_eq!((sites.len(), sites.duplicate_count()), (1331, 1331));
    assert_eq!((distinct.len(), distinct.sorted()), (1331, sites.sorted()));
    let sorted: Vec<[f64; 3]> =
        sites.sorted().iter().map(|&site| sites.points()[site as usize]).collect();
    assert!(sorted.is_sorted());
    assert!((0..1331u32).eq(sites.site_of()[1331..].iter().copied()));
}

#[test]
fn of_equal_points_the_heaviest_is_the_site() {
    let points = [[0.0], [1.0], [0.0], [-0.0], [1.0]];
    let sites = WeightedSites::new(&points, &[1.0, 5.0, 2.0, 2.0, -0.0]).unwrap();
    assert_eq!((sites.weights(), sites.input_of()), (&[2.0, 5.0][..], &[2, 1][..]));
    assert_eq!(sites.sites().site_of(), [0, 1, 0, 0, 1]);
}

#[test]
fn weights_that_are_none_are_refused_with_their_points() {
    let refused = |weights: &[f64]| WeightedSites::new(&[[0.0], [1.0]], weights).unwrap_err();
    assert_eq!(refused(&[1.0]), WeightsError::Count { points: 2, weights: 1 });
    assert_eq!(refused(&[f64::INFINITY, 0.0]), WeightsError::NotFinite(vec![(0, f64::INFINITY)]));
    assert!(refused(&[0.0, f64::NAN]).to_string().starts_with("point 1 has the weight NaN"));
    let nan = WeightedSites::new(&[[f64::NAN]], &[0.0]).unwrap_err();
    assert!(matches!(nan, WeightsError::Sites(_)));
}

#[test]
fn sites_on_threads_are_those_of_one() {
    // 40,000 points: spread, in few columns with repeats, all on one vertical line, and far beyond one scale.
    let number = |i: u64, below: u64| (scatter(i) % below) as f64;
    let spread = |i: u64| [number(i, 1 << 50), number(!i, 1 << 50)];
    let columns = |i: u64| [number(i, 100), number(!i, 300)];
    let line = |i: u64| [1.0, -number(i, 1 << 40)];
    let scales = |i: u64| {
        [
            number(i, 9) * 2f64.powf(number(!i, 1900) - 950.0),
            if i.is_multiple_of(2) { f64::MAX } else { -f64::MAX },
        ]
    };
    let makes: [&dyn Fn(u64) -> [f64; 2]; 4] = [&spread, &columns, &line, &scales];
    for make in makes {
        let points: Vec<[f64; 2]> = (0..40_000).map(make).collect();
        let sites = Sites::new(&points).unwrap();
        let position = |&site: &u32| sites.points()[site as usize];
        assert!(sites.sorted().is_sorted_by(|a, b| position(a) < position(b)), "strictly");
        let threads = std::num::NonZeroUsize::new(3).unwrap();
        assert_eq!(Sites::new_in_parallel(&points, threads).unwrap(), sites);
    }
}

#[test]
fn bad_coordinates_are_found_on_any_thread() {
    let bad = [3usize, 25_000, 39_999];
    let points: Vec<[f64; 2]> = (0..40_000u32).map(|i| [f64::from(i), 0.0]).collect();
    for chosen in [&bad[..1], &bad[1..2], &bad[2..], &bad[..]] {
        let mut points = points.clone();
        chosen.iter().for_each(|&i| points[i][1] = f64::NAN);
        let threads = std::num::NonZeroUsize::new(3).unwrap();
        let refused = Sites::new_in_parallel(&points, threads).unwrap_err();
        let SitesError::NotFinite(faults) = refused else { panic!("{refused}") };
        assert!(faults.iter().map(|fault| fault.point).eq(chosen.iter().copied()));
    }
}
