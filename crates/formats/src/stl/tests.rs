use super::*;

const TEXT: &str = "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 0\nendloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n";

#[test]
fn corners_are_merged() {
    let document = read(TEXT.as_bytes()).unwrap();
    assert_eq!(document.point_count(), 4);
    assert_eq!(document.triangles, [[0, 1, 2], [1, 3, 2]]);
}

#[test]
fn binary_counts_must_agree() {
    let mut bytes = vec![0; 80];
    bytes.extend(1_u32.to_le_bytes());
    for x in [0.0_f32, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0] {
        bytes.extend(x.to_le_bytes());
    }
    bytes.extend([0, 0]);
    assert_eq!(read(&bytes).unwrap().triangles, [[0, 1, 2]]);
    for end in 0..bytes.len() {
        assert!(read(&bytes[..end]).is_err(), "cut at {end}");
    }
    bytes[80] = 2;
    assert!(matches!(read(&bytes), Err(ReadError::CountDiffers { announced: 2, found: 1, .. })));
}

#[test]
fn text_must_end() {
    assert!(read(&TEXT.as_bytes()[..TEXT.len() - 12]).is_err());
    assert!(read(b"solid s\nvertex 0 0\n").is_err());
}
