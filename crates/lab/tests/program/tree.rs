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

#[test]
fn inputs_without_a_boundary_are_refused() {
    let folder = folder();
    std::fs::write(folder.path().join("points.xyz"), "0 0\n1 0\n0 1\n").unwrap();
    let (status, out, error) = run(folder.path(), &["tree", "build", "points.xyz"]);
    assert_eq!((status, out.as_str()), (2, ""));
    assert!(error.contains("there are no segments"), "{error}");
    let (status, out, error) =
        run(folder.path(), &["tree", "divide", "points.xyz", "--by", "pr", "--json"]);
    assert_eq!(status, 0, "{error}");
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((&object["leaves"], &object["crowded"]), (&4.into(), &0.into()));
}

/// A cube of side 2 at a corner of one of side 4: quadrilaterals, so that fans are made.
const CUBES: &str = "OFF\n12 9 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n\
    4 4 4\n3 4 4\n4 3 4\n4 4 3\n4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n\
    3 8 9 10\n3 8 10 9\n3 8 9 10\n";

#[test]
fn a_solid_has_an_octree() {
    let folder = folder();
    // Three coincident triangles are one under the even-odd rule, and open.
    std::fs::write(folder.path().join("open.off"), CUBES).unwrap();
    let (status, _, error) = run(folder.path(), &["tree", "build", "open.off"]);
    assert_eq!(status, 2);
    assert!(error.contains("the boundary is open"), "{error}");
    let closed = CUBES.replacen("12 9 0", "12 8 0", 1).replacen(
        "3 8 9 10\n3 8 10 9\n3 8 9 10\n",
        "3 8 9 10\n3 8 10 9\n",
        1,
    );
    std::fs::write(folder.path().join("cube.off"), closed).unwrap();
    let words = ["tree", "build", "cube.off", "--depth", "2", "--json", "-o", "cube.df"];
    let (status, out, error) = run(folder.path(), &words);
    assert_eq!(status, 0, "{error}");
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((&object["side"], &object["volume_cells"]), (&2.0.into(), &"64".into()));
    let (status, svg, _) = run(folder.path(), &["tree", "figure", "octree", "cube.off"]);
    assert_eq!((status, svg.matches("moved apart").count()), (0, 1));
    let (status, _, error) = run(folder.path(), &["tree", "figure", "labelled", "cube.off"]);
    assert_eq!(status, 2, "{error}");
}

#[test]
fn a_quadtree_is_drawn_bounded_and_triangulated() {
    let folder = folder();
    std::fs::write(folder.path().join("diamond.poly"), DIAMOND).unwrap();
    let with = |words: &[&str]| {
        let (status, out, error) = run(folder.path(), words);
        assert_eq!(status, 0, "{error}");
        out
    };
    let svg =
        with(&["tree", "figure", "labelled", "diamond.poly", "--depth", "2", "--rule", "inner"]);
    assert!(svg.contains("4 black and 12 white leaves") && svg.contains("((WWBW(WWWB(BWWW(WBWW"));
    let svg = with(&["tree", "figure", "2", "diamond.poly", "--depth", "2", "--rule", "inner"]);
    assert!(svg.contains("quadtree: 5 gray nodes, 16 leaves"));
    let words = [
        "tree",
        "polygons",
        "diamond.poly",
        "--depth",
        "2",
        "--rule",
        "inner",
        "--json",
        "-o",
        "ring.lar.json",
    ];
    let object: Value = serde_json::from_str(&with(&words)).unwrap();
    assert_eq!((&object["rings"], &object["corners"]), (&1.into(), &4.into()));
    let words = ["tree", "mesh", "diamond.poly", "--depth", "3", "--json", "-o", "mesh.off"];
    let object: Value = serde_json::from_str(&with(&words)).unwrap();
    let triangles = object["triangles"].as_u64().unwrap();
    let off = std::fs::read_to_string(folder.path().join("mesh.off")).unwrap();
    // nOFF, the dimension, counts, vertices, faces.
    let counts: Vec<usize> =
        off.lines().nth(2).unwrap().split(' ').map(|word| word.parse().unwrap()).collect();
    assert_eq!(counts[1] as u64, triangles);
    let faces = off.lines().skip(3 + counts[0]);
    assert_eq!(faces.filter(|line| line.starts_with("3 ")).count() as u64, triangles);
    let rows = with(&["tree", "growth", "diamond.poly", "--from", "2", "--to", "5", "--json"]);
    assert_eq!(rows.lines().count(), 4);
    with(&["tree", "build", "diamond.poly", "--depth", "2", "--rule", "area", "-o", "a.df"]);
    with(&["tree", "build", "diamond.poly", "--depth", "2", "--rule", "inner", "-o", "i.df"]);
    assert_eq!(with(&["tree", "op", "difference", "i.df", "a.df"]), "W\n");
    assert_eq!(
        with(&["tree", "op", "union", "i.df", "a.df"]),
        std::fs::read_to_string(folder.path().join("a.df")).unwrap()
    );
}
