use super::*;

#[test]
fn a_point_of_either_byte_order() {
    let little = read_hex("0101000000000000000000F03F0000000000000040").unwrap();
    let big = read_hex("00000000013FF00000000000004000000000000000").unwrap();
    assert_eq!(little.points, [1.0, 2.0]);
    assert_eq!(big.points, [1.0, 2.0]);
}

#[test]
fn truncation_and_nonsense_are_refused() {
    let text = "010200000002000000000000000000F03F000000000000004000000000000000000000000000000000";
    assert_eq!(read_hex(text).unwrap().segments, [[0, 1]]);
    for end in 0..text.len() {
        assert!(read_hex(&text[..end]).is_err(), "cut at {end}");
    }
    assert!(read_hex("0203000000FFFFFFFF").is_err());
    assert!(read_hex("0103000000FFFFFFFF").is_err());
    assert!(read_hex(&"010700000001000000".repeat(1000)).is_err());
}
