//! `delone tree`.

use serde_json::Value;

use super::{folder, run};

/// A diamond in the square from (0, 0) to (4, 4).
const DIAMOND: &str = "4 2 0 0\n1 2 0\n2 4 2\n3 2 4\n4 0 2\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n";

#[test]
fn a_tree_is_built_measured_and_written_in_other_codes() {
    let folder = folder();
    std::fs::write(folder.path().join("diamond.poly"), DIAMOND).unwrap();
    let words = [
        "tree",
        "build",
        "diamond.poly",
        "--depth",
        "2",
        "--rule",
        "inner",
        "--json",
        "-o",
        "d.df",
    ];
    let (status, out, error) = run(folder.path(), &words);
    assert_eq!(status, 0, "{error}");
    let object: Value = serde_json::from_str(&out).unwrap();
    let number = |key: &str| object[key].as_u64().unwrap();
    assert_eq!(
        (number("black"), number("white"), number("gray"), number("leaves")),
        (4, 12, 5, 16)
    );
    assert_eq!((&object["area_cells"], &object["perimeter_sides"]), (&"4".into(), &"8".into()));
    assert_eq!((&object["side"], &object["resolution"]), (&4.0.into(), &1.0.into()));
    assert_eq!((number("euler"), number("components")), (1, 1));
    let df = std::fs::read_to_string(folder.path().join("d.df")).unwrap();
    assert_eq!(df, "((WWWB(WWBW(WBWW(BWWW\n");

    let encoded = |code: &str, order: &str| {
        run(folder.path(), &["tree", "encode", "d.df", "--as", code, "--order", order]).1
    };
    assert_eq!(encoded("pbm", "morton"), "P1\n4 4\n0000\n0110\n0110\n0000\n");
    assert_eq!(encoded("linear", "morton"), "03\n12\n21\n30\n");
    assert_eq!(encoded("df", "nw"), "((WWBW(WWWB(BWWW(WBWW\n");
    let (status, out, _) = run(folder.path(), &["tree", "stats", "d.df", "--json"]);
    assert_eq!(status, 0);
    assert_eq!(serde_json::from_str::<Value>(&out).unwrap()["area_cells"], "4");
}

#[test]
fn open_boundaries_and_broken_codes_are_refused() {
    let folder = folder();
    std::fs::write(folder.path().join("open.poly"), super::KITE).unwrap();
    let (status, out, error) = run(folder.path(), &["tree", "build", "open.poly"]);
    assert_eq!((status, out.as_str()), (2, ""));
    assert!(error.contains("the boundary is open"), "{error}");
    std::fs::write(folder.path().join("broken.df"), "(WB").unwrap();
    let (status, _, error) = run(folder.path(), &["tree", "stats", "broken.df"]);
    assert_eq!(status, 2);
    assert!(error.contains("ends at 3"), "{error}");
}
