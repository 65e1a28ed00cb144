//! Commands that add Steiner points.

use std::path::Path;

use serde_json::Value;

use super::{CROSS, KITE, folder, run};

/// The kite with markers and an attribute: 10, 20, 30, 40.
const MARKED: &str = "4 2 1 1\n1 0 0 10 1\n2 3 1 20 2\n3 6 0 30 3\n4 3 -1 40 4\n1 1\n1 1 3 7\n0\n";

#[test]
fn conform_tells_the_keys_of_the_contract() {
    let folder = folder();
    std::fs::write(folder.path().join("kite.poly"), KITE).unwrap();
    for method in ["delaunay", "gabriel", "saalfeld"] {
        let words = ["conform", "kite.poly", "--method", method, "--json", "--check", "--counts"];
        let (status, out, error) = run(folder.path(), &words);
        assert_eq!(status, 0, "{error}");
        let object: Value = serde_json::from_str(&out).unwrap();
        assert_eq!(object["schema"], "delone.conform/1");
        assert_eq!(object["algorithm"], method);
        let steiner = object["steiner"].as_u64().unwrap();
        assert!(steiner >= 1, "the long diagonal is missing");
        assert_eq!(object["vertices"].as_u64().unwrap(), 4 + steiner);
        assert_eq!(object["counts"]["steiner_points"].as_u64().unwrap(), steiner);
        assert_eq!(object["check"]["level"], "conforming delaunay");
        assert_eq!((&object["complete"], &object["check"]["ok"]), (&true.into(), &true.into()));
        assert_eq!(object["rounding_keeps_validity"], true);
    }
}

#[test]
fn limits_leave_a_valid_partial_result() {
    let folder = folder();
    std::fs::write(folder.path().join("kite.poly"), KITE).unwrap();
    let words = ["conform", "kite.poly", "--vertices-max", "4", "--json", "--check", "-o", "a.ele"];
    let (status, out, error) = run(folder.path(), &words);
    assert_eq!(status, 3);
    assert!(error.contains("a limit was reached with 4 vertices"), "{error}");
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((&object["complete"], &object["check"]["ok"]), (&false.into(), &true.into()));
    assert_eq!(object["check"]["level"], "constrained delaunay");
    assert!(folder.path().join("a.ele").is_file());
    std::fs::write(folder.path().join("cross.poly"), CROSS).unwrap();
    let (status, _, error) = run(folder.path(), &["conform", "cross.poly"]);
    assert_eq!(status, 2);
    assert!(error.contains("cross"), "{error}");
}

#[test]
fn markers_and_attributes_are_carried() {
    let folder = folder();
    std::fs::write(folder.path().join("kite.poly"), MARKED).unwrap();
    let (status, _, error) = run(folder.path(), &["conform", "kite.poly", "-o", "out.poly"]);
    assert_eq!(status, 0, "{error}");
    let text = std::fs::read_to_string(folder.path().join("out.poly")).unwrap();
    let rows: Vec<Vec<&str>> = text
        .lines()
        .filter(|line| !line.starts_with('#') && !line.trim().is_empty())
        .map(|line| line.split_whitespace().collect())
        .collect();
    // The Steiner point is in the middle of the segment from 10 to 30, and has its marker, as both parts have.
    assert_eq!(rows[5], ["5", "3", "0", "20", "7"], "{text}");
    assert_eq!(rows[6], ["2", "1"], "{text}");
    assert_eq!([rows[7][3], rows[8][3]], ["7", "7"], "{text}");
}

/// A rectangle with a thin slit of a hole.
const HOLED: &str = "8 2 0 0\n1 0 0\n2 40 0\n3 40 20\n4 0 20\n5 10 9\n6 30 9\n7 30 10\n8 10 10\n8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n\
                     5 5 6\n6 6 7\n7 7 8\n8 8 5\n0\n";

#[test]
fn refine_tells_the_keys_of_the_contract() {
    let folder = folder();
    std::fs::write(folder.path().join("holed.poly"), HOLED).unwrap();
    std::fs::write(folder.path().join("sizes.txt"), "0, 0, 1\n40 20 9 # far\n").unwrap();
    let refined = |words: &[&str]| -> Value {
        let words = [&["refine", "holed.poly", "--json", "--check"], words].concat();
        let (status, out, error) = run(folder.path(), &words);
        assert_eq!(status, 0, "{error}");
        serde_json::from_str(&out).unwrap()
    };
    let mut counts = Vec::new();
    for method in ["off-centre", "chew", "ruppert"] {
        let object = refined(&["--method", method, "--angle-min", "28", "--fill", "nesting"]);
        assert_eq!(
            (&object["schema"], &object["algorithm"]),
            (&"delone.refine/1".into(), &method.into())
        );
        assert_eq!((&object["check"]["ok"], &object["complete"]), (&true.into(), &true.into()));
        assert!(object["angle_deg_min"].as_f64().unwrap() >= 28.0 - 1e-9, "{object}");
        assert_eq!(object["left_alone"], Value::Array(Vec::new()));
        assert_eq!(object["vertices"].as_u64().unwrap(), 8 + object["steiner"].as_u64().unwrap());
        counts.push(object["cells_inside"].as_u64().unwrap());
    }
    // Bounds on size take more.
    let fine = refined(&["--area-max", "2", "--fill", "nesting"]);
    assert!(fine["cells_inside"].as_u64().unwrap() >= 390, "an area of 780 by 2");
    let graded = refined(&["--size", "sizes.txt"]);
    assert!(graded["cells_inside"].as_u64().unwrap() > counts[0]);
    for words in [["--angle-min", "60"], ["--area-max", "-1"], ["--size", "none"], ["--size", "0"]]
    {
        let words = [&["refine", "holed.poly"][..], &words[..]].concat();
        assert_eq!(run(folder.path(), &words).0, 2, "{words:?}");
    }
}

/// A square of four units in the last place: no triangle whose corners are doubles is as small as is asked for. In exact numbers they are; in doubles
/// the result is no triangulation, which is said.
#[test]
fn triangles_are_smaller_than_doubles_can_tell() {
    let folder = folder();
    let (ulp, high) = (f64::EPSILON, 1.0 + 4.0 * f64::EPSILON);
    let corners = format!("1 1 1\n2 {high:?} 1\n3 {high:?} {high:?}\n4 1 {high:?}\n");
    let text = format!("4 2 0 0\n{corners}4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
    let area = format!("{:e}", ulp * ulp / 8.0);
    std::fs::write(folder.path().join("tiny.poly"), text).unwrap();
    let words = ["refine", "tiny.poly", "--area-max", &area, "--json", "--check"];
    let (status, out, error) = run(folder.path(), &words);
    assert_eq!(status, 0, "{error}");
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((&object["complete"], &object["check"]["ok"]), (&true.into(), &true.into()));
    assert_eq!(object["left_alone"].as_array().unwrap().len(), 0, "{object}");
    assert!(object["rounded_vertices"].as_u64().unwrap() > 0, "{object}");
    assert_eq!(object["rounding_keeps_validity"], false);
}

/// Points alone: what is inside is the hull, its edges are segments then, and are split where an angle asks for it.
#[test]
fn the_hull_is_refined_as_a_whole() {
    let folder = folder();
    std::fs::write(folder.path().join("flat.xyz"), "0 0\n10 0\n5 1\n").unwrap();
    let words = ["refine", "flat.xyz", "--fill", "none", "--json", "--check"];
    let (status, out, error) = run(folder.path(), &words);
    assert_eq!(status, 0, "{error}");
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(object["check"]["ok"], true, "{object}");
    assert_eq!(object["input"]["segments"], 3, "{object}");
    assert!(object["steiner"].as_u64().unwrap() > 2, "{object}");
    assert!(object["angle_deg_min_elsewhere"].as_f64().unwrap() > 20.69, "{object}");
    assert!(error.contains("edges of the hull that became segments: 3"), "{error}");
}

/// A slot takes as many triangles as its width goes into its length; what a limit stops is told so.
#[test]
fn a_narrow_gap_is_told_where_a_limit_stops() {
    let folder = folder();
    let corners = "1 0 0\n2 1e6 0\n3 1e6 1e-3\n4 0 1e-3\n";
    let text = format!("4 2 0 0\n{corners}4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
    std::fs::write(folder.path().join("slot.poly"), text).unwrap();
    let words = ["refine", "slot.poly", "--vertices-max", "500", "--json"];
    let (status, out, error) = run(folder.path(), &words);
    assert_eq!(status, 3, "{error}");
    assert!(error.contains("segments 0 and 2 run along each other"), "{error}");
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(object["gap"]["segments"], serde_json::json!([0, 2]), "{object}");
    assert!(object["gap"]["triangles_min"].as_f64().unwrap() > 1e8, "{object}");
    std::fs::write(folder.path().join("holed.poly"), HOLED).unwrap();
    let (_, _, error) = run(folder.path(), &["refine", "holed.poly", "--vertices-max", "9"]);
    assert!(error.contains("limit") && !error.contains("run along"), "{error}");
}

#[test]
fn crossings_are_rounded_if_asked_to() {
    let folder = folder();
    std::fs::write(folder.path().join("cross.poly"), CROSS).unwrap();
    for command in ["conform", "refine"] {
        let words = [command, "cross.poly", "--crossings", "snap", "--json", "--check"];
        let (status, out, error) = run(folder.path(), &words);
        assert_eq!(status, 0, "{error}");
        let object: Value = serde_json::from_str(&out).unwrap();
        assert_eq!((&object["complete"], &object["check"]["ok"]), (&true.into(), &true.into()));
    }
}

fn json(folder: &Path, words: &[&str], expected: i32) -> Value {
    let (status, out, error) = run(folder, words);
    assert_eq!(status, expected, "{out} {error}");
    serde_json::from_str(&out).unwrap()
}

/// Methods are compared if they are named, each judged by its own promise: the segment is an edge of the Delaunay triangulation, and
/// (3, 2) is in its diametral disk.
#[test]
fn methods_are_compared_by_their_own_promises() {
    let folder = folder();
    let near = "4 2 0 0\n1 0 0\n2 6 0\n3 3 2\n4 3 -40\n1 0\n1 1 2\n0\n";
    std::fs::write(folder.path().join("near.poly"), near).unwrap();
    std::fs::write(folder.path().join("cross.poly"), CROSS).unwrap();
    std::fs::write(folder.path().join("points.node"), "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n").unwrap();
    let words =
        ["compare", "near.poly", "--only", "cavity,conforming", "--json", "--html", "r.html"];
    let object = json(folder.path(), &words, 0);
    assert_eq!((&object["agree"], &object["proved"]), (&true.into(), &true.into()));
    let results = object["results"].as_array().unwrap();
    let names: Vec<&str> = results.iter().map(|row| row["algorithm"].as_str().unwrap()).collect();
    assert_eq!(names, ["cavity", "delaunay", "gabriel", "saalfeld"]);
    assert!(
        results[0]["steiner"].is_null() && results[0]["check"]["level"] == "constrained delaunay"
    );
    for row in &results[1..] {
        assert_eq!(
            (&row["complete"], &row["ignores_order"]),
            (&true.into(), &true.into()),
            "{row}"
        );
        assert_eq!(row["check"]["level"], "conforming delaunay");
        let empties_disks =
            row["check"]["proved"].to_string().contains("S4: the closed diametral disks");
        assert_eq!(empties_disks, row["algorithm"] != "delaunay", "{row}");
        let added = row["vertices"].as_u64().unwrap() - 4;
        assert_eq!(row["steiner"].as_u64().unwrap(), added);
        assert_eq!(added > 0, empties_disks, "{row}");
    }
    assert_ne!(results[1]["fingerprint"], results[2]["fingerprint"], "and yet nothing disagrees");
    let page = std::fs::read_to_string(folder.path().join("r.html")).unwrap();
    for row in &results[1..] {
        let caption =
            format!("{}: {} Steiner points", row["algorithm"].as_str().unwrap(), row["steiner"]);
        assert!(page.contains(&format!("<figcaption>{caption}</figcaption>")), "{caption}");
    }
    // What none of them takes is said; what crosses can be cut.
    let (status, out, _) = run(folder.path(), &["compare", "points.node", "--only", "gabriel"]);
    assert!(status == 0 && out.contains("none of the algorithms asked for"), "{out}");
    let words = ["compare", "cross.poly", "--only", "gabriel", "--crossings", "snap", "--json"];
    assert_eq!(json(folder.path(), &words, 0)["results"].as_array().unwrap().len(), 1);
    for more in [&["--scaling", "50"][..], &["--time-limit", "-1"]] {
        let words = [&["compare", "--only", "gabriel"], more].concat();
        assert_eq!(run(folder.path(), &words).0, 2, "{more:?}");
    }
}

/// A method that a limit stops has a row that says so, with what is proved of it all the same. That is no failure.
#[test]
fn a_method_that_is_stopped_is_a_row() {
    let folder = folder();
    std::fs::write(folder.path().join("kite.poly"), KITE).unwrap();
    let words = ["compare", "kite.poly", "--only", "delaunay,saalfeld", "--vertices-max", "4"];
    let (status, out, error) = run(folder.path(), &words);
    assert_eq!(status, 0, "{error}");
    assert_eq!(out.matches("  stopped: constrained delaunay\n").count(), 2, "{out}");
    assert!(out.contains("2 results, 2 proved, 2 stopped by a limit"), "{out}");
    let object = json(folder.path(), &[&words[..], &["--json"]].concat(), 0);
    let row = &object["results"][0];
    assert_eq!((&row["complete"], &row["steiner"]), (&false.into(), &0.into()));
    assert!(row["ignores_order"].is_null() && row["check"]["ok"] == true, "{row}");
}

/// Another program's conforming triangulation, its Steiner points in doubles: on the segment, a little off it, and with none.
#[test]
fn the_judge_takes_steiner_points_in_doubles() {
    let folder = folder();
    std::fs::write(folder.path().join("kite.poly"), KITE).unwrap();
    let output = |middle: &str, edges: &str| {
        let text = format!(
            r#"{{"V": [[0,0],[3,1],[6,0],[3,-1],{middle}], "EV": {edges}, "FV": [[0,1,4],[4,1,2],[0,4,3],[4,2,3]]}}"#
        );
        std::fs::write(folder.path().join("out.lar.json"), text).unwrap();
        let words = ["check", "kite.poly", "out.lar.json", "--as", "conforming", "--json"];
        let (status, out, error) = run(folder.path(), &words);
        assert!(error.is_empty(), "{error}");
        (status, serde_json::from_str::<Value>(&out).unwrap()["check"].take())
    };
    for edges in ["[[0,4],[4,2]]", "[]"] {
        let (status, check) = output("[3,0]", edges);
        assert_eq!((status, &check["level"]), (0, &"weakly conforming delaunay".into()), "{check}");
    }
    let (status, check) = output("[3,1e-30]", "[[0,4],[4,2]]");
    assert_eq!((status, &check["fault_counts"]), (1, &serde_json::json!({ "off-segment": 1 })));
    assert!(check["faults"][0].as_str().unwrap().contains("is 1e-30 off segment 0"), "{check}");
    assert_eq!(check["level"], "weakly delaunay", "of its own points");
    let (status, check) = output("[3,1e-30]", "[]");
    assert_eq!((status, &check["fault_counts"]), (1, &serde_json::json!({ "broken-segment": 1 })));
    // A point of the input that is left out is no Steiner point's affair.
    std::fs::write(
        folder.path().join("more.poly"),
        KITE.replace("4 2 0 0\n", "5 2 0 0\n").replace("1 0\n1 1 3", "5 3 0.5\n1 0\n1 1 3"),
    )
    .unwrap();
    let words = ["check", "more.poly", "out.lar.json", "--as", "conforming", "--json"];
    assert_eq!(json(folder.path(), &words, 1)["check"]["fault_counts"]["unused-point"], 1);
}

/// What we write is accepted where rounding moved nothing off its segment; else the judge names each point, as many as we count.
#[test]
fn what_conform_writes_is_judged() {
    let folder = folder();
    for workload in ["coast", "comb", "random-segments"] {
        let words = ["gen", workload, "-n", "60", "-o", "in.poly"];
        assert_eq!(run(folder.path(), &words).0, 0, "{workload}");
        let told = json(folder.path(), &["conform", "in.poly", "-o", "out.lar.json", "--json"], 0);
        let words = ["check", "in.poly", "out.lar.json", "--as", "conforming", "--json"];
        let expected = i32::from(told["rounded_vertices"] != 0);
        let check = &json(folder.path(), &words, expected)["check"];
        let off = check["fault_counts"]["off-segment"].as_u64().unwrap_or(0);
        assert!(off <= told["rounded_vertices"].as_u64().unwrap(), "{workload}: {check}");
        assert_eq!(off > 0, expected == 1, "{workload}: {check}");
    }
}
