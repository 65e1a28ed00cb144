use super::*;
use crate::format::Format;
use crate::testing::{read_named, refusal};

const HEADER: &str = "element vertex 3\nproperty float x\nproperty uchar c\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nelement edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n";

#[test]
fn ascii() {
    let text = format!(
        "ply\nformat ascii 1.0\ncomment c\n{HEADER}0 7 0 0\n1 7 0 0\n0 7 1 0.1\n3 0 1 2\n2 0\n"
    );
    let document = read_named("a.ply", &text);
    assert_eq!(document.points, [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.1]);
    assert_eq!(document.triangles, [[0, 1, 2]]);
    assert_eq!(document.segments, [[2, 0]]);
}

fn binary(big: bool) -> Vec<u8> {
    let order = if big { "big" } else { "little" };
    let mut bytes = format!("ply\nformat binary_{order}_endian 1.0\n{HEADER}").into_bytes();
    let mut push = |mut word: Vec<u8>| {
        if big {
            word.reverse();
        }
        bytes.extend(word);
    };
    for point in [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.1]] {
        push(point[0].to_le_bytes().to_vec());
        push(vec![7]);
        push(point[1].to_le_bytes().to_vec());
        push(point[2].to_le_bytes().to_vec());
    }
    push(vec![3]);
    for word in [0_i32, 1, 2, 2, 0] {
        push(word.to_le_bytes().to_vec());
    }
    bytes
}

#[test]
fn binary_of_both_orders() {
    for big in [false, true] {
        let document = read(&binary(big)).unwrap();
        assert_eq!(document.points[8], f64::from(0.1_f32));
        assert_eq!(document.triangles, [[0, 1, 2]]);
        assert_eq!(document.segments, [[2, 0]]);
    }
}

#[test]
fn every_truncation_is_refused() {
    let bytes = binary(false);
    for end in 0..bytes.len() {
        assert!(read(&bytes[..end]).is_err(), "cut at {end}");
    }
}

#[test]
fn announced_counts_allocate_nothing() {
    let huge = "ply\nformat binary_little_endian 1.0\nelement vertex 18446744073709551615\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
    assert!(refusal(Format::Ply, huge).contains("file ends"));
    let empty = "ply\nformat ascii 1.0\nelement nothing 18446744073709551615\nend_header\n";
    assert!(read(empty.as_bytes()).is_ok());
    let list = "ply\nformat ascii 1.0\nelement face 1\nproperty list uint int vertex_indices\nend_header\n4294967295 1\n";
    assert_eq!(refusal(Format::Ply, list), "t:6: file ends before the next value");
}
