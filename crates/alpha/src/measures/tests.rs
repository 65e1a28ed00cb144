use crate::testing::of;

#[test]
fn a_square_with_a_hole_has_two_boundaries() {
    // A ring of 16 points of a 5 x 5 grid: squared values 0, 1/4 and, of the whole ring, that of the disk of radius sqrt 8.
    let ring = (0..25u8)
        .filter(|i| i / 5 % 4 == 0 || i % 5 % 4 == 0)
        .map(|i| [i / 5, i % 5].map(f64::from));
    let filtration = of(&ring.collect::<Vec<_>>());
    let measures = filtration.plane_measures().unwrap();
    assert_eq!(measures.len(), filtration.rank_count() + 1);
    assert_eq!(measures[0], [0.0, 0.0]);
    assert_eq!(measures[filtration.rank_count()], [16.0, 16.0]);
    // At each cut: the sums over what is there, by definition.
    for (ranks, [area, perimeter]) in measures.iter().enumerate() {
        let simplices = filtration.simplices();
        let is_in = |id: usize| (filtration.ranks()[id] as usize) < ranks;
        let triangles: Vec<usize> = simplices.of_dimension(2).filter(|&id| is_in(id)).collect();
        let sides = filtration.cells_beside_facets();
        let first = simplices.of_dimension(1).start;
        let bounds = |&id: &usize| {
            let there = sides[id - first].iter().flatten().filter(|&&cell| is_in(cell as usize));
            there.count() == 1
        };
        let regular = simplices.of_dimension(1).filter(bounds).count();
        assert_eq!(*area == 0.0, triangles.is_empty());
        assert_eq!(*perimeter == 0.0, regular == 0);
        assert!(*perimeter >= 4.0 * area.sqrt() * 0.88, "isoperimetry: {area} {perimeter}");
    }
}

#[test]
fn there_is_a_plane_only_in_two_axes() {
    assert_eq!(of(&[[0.0, 0.0, 1.0]]).plane_measures(), None);
    assert_eq!(of::<2>(&[]).plane_measures(), Some(vec![[0.0, 0.0]]));
    assert_eq!(of(&[[0.0, 0.0], [1.0, 1.0]]).plane_measures().unwrap().last(), Some(&[0.0, 0.0]));
}
