use super::*;

#[test]
fn edges_are_mapped_to_their_pieces() {
    let v = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 0.0], [3.0, 0.0], [9.0, 9.0]];
    let ev = [[1, 0], [1, 2], [2, 0], [5, 1]];
    let interior = triangulate2d(&v, &ev, &Fill::EvenOdd).unwrap();
    let named = |piece: &u32| interior.ev[*piece as usize];
    let pieces: Vec<Vec<[u32; 2]>> =
        interior.pieces.iter().map(|pieces| pieces.iter().map(named).collect()).collect();
    assert_eq!(pieces, [vec![[1, 4], [3, 4], [0, 3]], vec![[1, 2]], vec![[0, 2]], vec![]]);
    let added = interior.kinds.iter().filter(|kind| kind.is_none()).count();
    assert_eq!((interior.fv.len(), interior.ev.len(), added), (3, 7, 2));
    assert!(interior.kinds.iter().flatten().all(|&kind| kind == EdgeKind::Shell));
}

#[test]
fn the_first_of_equal_vertices_is_named() {
    let v = [[9.0, 9.0], [0.0, 0.0], [0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]];
    let interior = triangulate2d(&v, &[[2, 3], [3, 4], [4, 5]], &Fill::Nesting).unwrap();
    assert_eq!(interior.fv, [[1, 3, 4]]);
    assert_eq!(interior.ev, [[1, 3], [1, 4], [3, 4]]);
}

#[test]
fn what_is_wrong_is_told() {
    let v = [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]];
    let crossed = triangulate2d(&v, &[[0, 1], [2, 3]], &Fill::Nesting).unwrap_err();
    assert_eq!(
        crossed.to_string(),
        "segments 0 and 1 cross near (0.5, 0.5): split them at a common vertex"
    );
    let open = triangulate2d(&v, &[[0, 3], [3, 1], [1, 0], [1, 2], [2, 0]], &Fill::EvenOdd);
    assert!(open.unwrap_err().to_string().contains("3 segments end at point 0 (0, 0)"));
}
