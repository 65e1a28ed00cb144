use super::{ALIGNED, read};
use crate::document::Document;
use crate::format::Format;
use crate::write::write;

/// A file with a header, as NumPy's documentation describes it.
fn file(version: u8, header: &str, numbers: &[f64]) -> Vec<u8> {
    let mut bytes = b"\x93NUMPY".to_vec();
    bytes.extend([version, 0]);
    let length = u32::try_from(header.len()).unwrap().to_le_bytes();
    bytes.extend(if version == 1 { &length[..2] } else { &length[..] });
    bytes.extend(header.bytes());
    bytes.extend(numbers.iter().flat_map(|x| x.to_le_bytes()));
    bytes
}

const PLANE: &str = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), }  \n";

fn refusal(header: &str, numbers: &[f64]) -> String {
    read(&file(1, header, numbers)).unwrap_err().to_string()
}

#[test]
fn tables_of_either_version() {
    for version in [1, 2, 3] {
        let document = read(&file(version, PLANE, &[0.5, -0.0, 5e-324, 1e300])).unwrap();
        assert_eq!((document.dimension, document.point_count()), (2, 2));
        assert_eq!(document.points[1].to_bits(), (-0.0_f64).to_bits());
    }
    let space = "{'shape':(1,3),'fortran_order':False,'descr':'<f8'}";
    assert_eq!(read(&file(1, space, &[1.0, 2.0, 3.0])).unwrap().points, [1.0, 2.0, 3.0]);
}

#[test]
fn what_is_not_supported_is_named() {
    let with = |from: &str, to: &str| refusal(&PLANE.replace(from, to), &[0.0; 4]);
    assert!(with("<f8", "<f4").contains("descr '<f8', found `<f4`"));
    assert!(with("<f8", ">f8").contains("found `>f8`"));
    assert!(with("'<f8'", "[('x', '<f8')]").contains("found `[("));
    assert!(with("False", "True").contains("C order"));
    assert!(with("False", "Maybe").contains("True or False"));
    assert!(with("(2, 2)", "(4,)").contains("two or three columns"));
    assert!(with("(2, 2)", "(2, 4)").contains("found `[2, 4]`"));
    assert!(with("(2, 2)", "(2, -2)").contains("a shape"));
    assert!(with("'shape'", "'form'").contains("'shape'"));
    assert!(with("(2, 2)", "(3, 2)").contains("announces 6 coordinates, 4 follow"));
    assert!(with("(2, 2)", "(18446744073709551615, 2)").contains("4 follow"));
    assert!(read(&file(9, PLANE, &[])).unwrap_err().to_string().contains("version 1, 2 or 3"));
    assert!(read(b"NUMPY").unwrap_err().to_string().contains("NUMPY"));
    let whole = file(1, PLANE, &[0.0; 4]);
    for end in 0..whole.len() {
        assert!(read(&whole[..end]).is_err(), "cut at {end}");
    }
}

#[test]
fn written_tables_are_read_again() {
    for (dimension, numbers) in
        [(2, vec![0.1, -0.0, f64::MAX, f64::NAN]), (3, vec![1.0; 6]), (2, vec![])]
    {
        let document = Document { points: numbers, ..Document::new(dimension) };
        let mut bytes = Vec::new();
        assert!(write(&document, Format::Npy, &mut bytes).unwrap().is_empty());
        assert_eq!((bytes.len() - 8 * document.points.len()) % ALIGNED, 0);
        let again = read(&bytes).unwrap();
        assert_eq!(again.dimension, dimension);
        let bits = |d: &Document| d.points.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&again), bits(&document));
    }
    let document = Document { points: vec![0.0; 4], segments: vec![[0, 1]], ..Document::new(2) };
    assert_eq!(write(&document, Format::Npy, &mut Vec::new()).unwrap(), ["1 segments not written"]);
}

#[test]
fn the_magic_tells_the_format() {
    let bytes = file(1, PLANE, &[0.0; 4]);
    assert_eq!(Format::detect("data", &bytes), Some(Format::Npy));
    assert_eq!(Format::detect("cloud.npy", b""), Some(Format::Npy));
    assert!(Format::Npy.is_written());
}
