//! The program as a user runs it: what it prints, writes, refuses, and how it exits.
#![expect(clippy::unwrap_used, reason = "tests")]

#[path = "program/bench.rs"]
mod bench;
#[path = "program/exercise.rs"]
mod exercise;
#[path = "program/fuzz.rs"]
mod fuzz;
#[path = "program/interrupt.rs"]
mod interrupt;
#[path = "program/pages.rs"]
mod pages;
#[path = "program/steiner.rs"]
mod steiner;
#[path = "program/tree.rs"]
mod tree;
#[path = "program/weights.rs"]
mod weights;

use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;

fn delone() -> Command {
    Command::new(env!("CARGO_BIN_EXE_delone"))
}

/// Runs in a folder; exit status, standard output, standard error.
fn run(folder: &Path, words: &[&str]) -> (i32, String, String) {
    let output = delone().current_dir(folder).args(words).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

const KITE: &str = "4 2 0 0\n1 0 0\n2 3 1\n3 6 0\n4 3 -1\n1 0\n1 1 3\n0\n";
const CROSS: &str = "4 2 0 0\n1 0 0\n2 2 2\n3 0 2\n4 2 0\n2 0\n1 1 2\n2 3 4\n0\n";

#[test]
fn a_reader_that_has_read_enough_is_no_fault() {
    let folder = folder();
    std::fs::write(folder.path().join("kite.poly"), KITE).unwrap();
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_delone"));
    command.args(["cdt", "kite.poly"]).current_dir(folder.path());
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader); // before a word is printed
    let output = command.stdout(writer).output().unwrap();
    assert_eq!(output.status.code(), Some(141));
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
}

#[test]
fn cdt_tells_the_keys_of_the_contract() {
    let folder = folder();
    std::fs::write(folder.path().join("kite.poly"), KITE).unwrap();
    let words =
        ["cdt", "kite.poly", "--json", "--check", "--counts", "-o", "out.ele", "--svg", "out.svg"];
    let (status, out, error) = run(folder.path(), &words);
    assert_eq!(status, 0, "{error}");
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(object["schema"], "delone.cdt/1");
    assert_eq!(object["input"]["sites"], 4);
    assert_eq!(object["input"]["segments"], 1);
    assert_eq!(object["input"]["duplicates"], 0);
    assert_eq!(
        (&object["vertices"], &object["cells"], &object["hull_facets"]),
        (&4.into(), &2.into(), &4.into())
    );
    assert_eq!(object["check"]["ok"], true);
    assert_eq!(object["check"]["level"], "constrained delaunay");
    assert_eq!(object["counts"]["subsegments"], 1);
    assert_eq!(object["fingerprint"].as_str().unwrap().len(), 32);
    for phase in ["read", "build", "check", "write"] {
        assert!(object["seconds"][phase].is_f64(), "{phase}");
    }
    // The long diagonal is in both triangles of the file written.
    let ele = std::fs::read_to_string(folder.path().join("out.ele")).unwrap();
    let rows: Vec<Vec<u32>> = ele
        .lines()
        .filter(|line| !line.starts_with('#') && !line.trim().is_empty())
        .map(|line| line.split_whitespace().map(|word| word.parse().unwrap()).collect())
        .collect();
    assert_eq!(rows[0][..2], [2, 3]);
    assert!(rows[1..].iter().all(|row| row[1..].contains(&1) && row[1..].contains(&3)), "{ele}");
    let svg = std::fs::read_to_string(folder.path().join("out.svg")).unwrap();
    assert!(roxmltree::Document::parse(&svg).is_ok());
}

#[test]
fn every_crossing_is_listed_and_nothing_is_written() {
    let folder = folder();
    std::fs::write(folder.path().join("cross.poly"), CROSS).unwrap();
    let (status, out, error) =
        run(folder.path(), &["cdt", "cross.poly", "-o", "out.ele", "--json"]);
    assert_eq!((status, out.as_str()), (2, ""));
    assert!(error.contains("segments 0 and 1 cross near (1, 1)"), "{error}");
    assert!(!folder.path().join("out.ele").exists());
}

#[test]
fn bad_input_is_named_with_file_and_line() {
    let folder = folder();
    let cases = [
        ("nan.node", "2 2 0 0\n1 0 0\n2 nan 1\n", "point 1 has the coordinate NaN on axis 0"),
        ("word.node", "2 2 0 0\n1 0 0\n2 x 1\n", "word.node:3"),
        ("short.node", "3 2 0 0\n1 0 0\n", "short.node"),
        ("index.poly", "2 2 0 0\n1 0 0\n2 1 1\n1 0\n1 1 7\n0\n", "index.poly:5"),
    ];
    for (name, text, expected) in cases {
        std::fs::write(folder.path().join(name), text).unwrap();
        let (status, out, error) = run(folder.path(), &["delaunay", name, "-o", "out.ele"]);
        assert_eq!((status, out.as_str()), (2, ""), "{name}");
        assert!(error.contains(expected), "{name}: {error}");
        assert!(!folder.path().join("out.ele").exists());
    }
    for words in [
        &["delaunay", "absent.node"][..],
        &["cdt"],
        &["frobnicate"],
        &["gen", "cost"],
        &["compare", "--only", "chew,magic"],
        &["delaunay", "nan.node", "--algorithm", "magic"],
        &["gen", "grid", "-o", "no/such/folder.node"],
    ] {
        assert_eq!(run(folder.path(), words).0, 2, "{words:?}");
    }
}

/// A file of several documents: one is taken by its name, as reports have it.
#[test]
fn a_document_of_a_file_is_taken_by_its_name() {
    let folder = folder();
    let text = "POLYGON((0 0,4 0,4 3,0 0))\nPOLYGON((10 10,14 10,14 13,13 14,10 10))\n";
    std::fs::write(folder.path().join("two.wkt"), text).unwrap();
    let (status, _, error) = run(folder.path(), &["cdt", "two.wkt"]);
    assert!(status == 2 && error.contains("name one of two.wkt#1, two.wkt#2"), "{error}");
    let (status, out, error) = run(folder.path(), &["cdt", "two.wkt#2", "--json"]);
    assert_eq!(status, 0, "{error}");
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(object["input"]["sites"], 4, "{object}");
    let (status, _, error) = run(folder.path(), &["cdt", "two.wkt#3"]);
    assert!(status == 2 && error.contains("there is two.wkt#1, two.wkt#2"), "{error}");
    assert_eq!(run(folder.path(), &["cdt", "three.wkt#3"]).0, 2);
}

#[test]
fn the_judge_finds_a_planted_fault_and_exits_with_one() {
    let folder = folder();
    std::fs::write(folder.path().join("kite.poly"), KITE).unwrap();
    // The short diagonal: Delaunay, but the segment is missing.
    std::fs::write(folder.path().join("wrong.ele"), "2 3 0\n1 1 2 4\n2 2 3 4\n").unwrap();
    let words = ["check", "kite.poly", "wrong.ele", "--as", "cdt", "--json"];
    let (status, out, _) = run(folder.path(), &words);
    assert_eq!(status, 1);
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(object["check"]["ok"], false);
    assert!(!object["check"]["faults"].as_array().unwrap().is_empty());
    assert_eq!(run(folder.path(), &["check", "kite.poly", "wrong.ele", "--as", "delaunay"]).0, 0);
}

#[test]
fn what_is_written_is_what_the_judge_accepts() {
    let folder = folder();
    for (workload, command, kind) in [
        ("coast", "cdt", "cdt"),
        ("grid", "delaunay", "delaunay"),
        ("sphere", "delaunay", "delaunay"),
        ("collinear-3d", "delaunay", "delaunay"),
        ("line-vertical", "delaunay", "delaunay"),
        ("duplicates", "delaunay", "delaunay"),
    ] {
        let (status, _, error) =
            run(folder.path(), &["gen", workload, "-n", "200", "-o", "in.poly"]);
        assert_eq!(status, 0, "{error}");
        let (status, _, error) =
            run(folder.path(), &[command, "in.poly", "-q", "-o", "out.lar.json"]);
        assert_eq!(status, 0, "{workload}: {error}");
        let words = ["check", "in.poly", "out.lar.json", "--as", kind, "--strict"];
        let (status, out, error) = run(folder.path(), &words);
        assert_eq!(status, 0, "{workload}: {out} {error}");
    }
}

#[test]
fn compare_judges_the_suite_and_writes_a_report() {
    let folder = folder();
    let (status, out, error) =
        run(folder.path(), &["compare", "-n", "200", "--html", "report.html", "--json"]);
    assert_eq!(status, 0, "{error}");
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(object["agree"], true);
    let results = object["results"].as_array().unwrap();
    assert!(results.len() > 60);
    for result in results {
        assert_eq!(result["check"]["ok"], true, "{result}");
        for key in ["input", "algorithm", "fingerprint", "seconds", "counts"] {
            assert!(!result[key].is_null(), "{key}");
        }
    }
    let html = std::fs::read_to_string(folder.path().join("report.html")).unwrap();
    assert!(html.contains("coast") && html.ends_with("</html>\n"));
    assert!(
        !html.contains("http://")
            || html.matches("http://").count() == html.matches("http://www.w3.org").count()
    );
}

#[test]
fn compare_refuses_all_or_goes_on() {
    let folder = folder();
    std::fs::write(folder.path().join("cross.poly"), CROSS).unwrap();
    std::fs::write(folder.path().join("kite.poly"), KITE).unwrap();
    let (status, out, error) = run(folder.path(), &["compare", ".", "--html", "r.html"]);
    assert_eq!((status, out.as_str()), (2, ""));
    assert!(error.contains("cross near (1, 1)") && !folder.path().join("r.html").exists());
    let (status, out, _) = run(folder.path(), &["compare", ".", "--keep-going", "--json"]);
    assert_eq!(status, 0);
    let object: Value = serde_json::from_str(&out).unwrap();
    let algorithms = delone_cdt::algorithms().len();
    assert_eq!(object["results"].as_array().unwrap().len(), algorithms);
    assert_eq!(object["refused"].as_array().unwrap().len(), 1);
    for way in ["split", "snap"] {
        let words = ["compare", ".", "--crossings", way, "--json", "--html", "r.html"];
        let (status, out, error) = run(folder.path(), &words);
        assert_eq!(status, 0, "{error}");
        let object: Value = serde_json::from_str(&out).unwrap();
        let results = object["results"].as_array().unwrap();
        assert_eq!(results.len(), 2 * algorithms);
        let path = |result: &Value| result["input"]["path"].as_str().unwrap().to_owned();
        let is_crossed = |result: &&Value| path(result).ends_with("cross.poly");
        let crossed = results.iter().find(is_crossed).unwrap();
        assert_eq!(
            crossed["vertices"],
            crossed["input"]["sites"].as_u64().unwrap() + 1 - u64::from(way == "snap")
        );
        assert_eq!(crossed["check"]["ok"], true);
        std::fs::remove_file(folder.path().join("r.html")).unwrap();
    }
}

#[test]
fn pipes_work() {
    let folder = folder();
    let poly = delone().args(["gen", "comb", "-n", "100"]).output().unwrap().stdout;
    let output =
        delone().args(["cdt", "-", "--check", "--json"]).write_stdin(poly).output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let (status, svg, _) = run(folder.path(), &["gen", "--list"]);
    assert!(status == 0 && svg.contains("coast"));
    assert_eq!(run(folder.path(), &["completions", "bash"]).0, 0);
    assert_eq!(run(folder.path(), &["man"]).0, 0);
    assert!(run(folder.path(), &["cite"]).1.contains("SB15"));
}

#[test]
fn convert_says_what_is_lost() {
    let folder = folder();
    std::fs::write(folder.path().join("kite.poly"), KITE).unwrap();
    let (status, _, error) =
        run(folder.path(), &["convert", "kite.poly", "-o", "kite.csv", "-o", "kite.lar.json"]);
    assert_eq!(status, 0);
    assert!(error.contains("kite.csv") && error.contains("segment"), "{error}");
    let (status, svg, _) = run(folder.path(), &["draw", "kite.lar.json", "--numbered"]);
    assert!(status == 0 && roxmltree::Document::parse(&svg).is_ok());
}

/// A square of side 4 with a square hole of side 2, as LAR.
const HOLED: &str = "{\"V\":[[0,0],[4,0],[4,4],[0,4],[1,1],[3,1],[3,3],[1,3]],\
    \"EV\":[[0,1],[1,2],[2,3],[3,0],[4,5],[5,6],[6,7],[7,4]]}";

fn json_of(folder: &Path, words: &[&str]) -> Value {
    let (status, out, error) = run(folder, words);
    assert_eq!(status, 0, "{words:?}: {error}");
    serde_json::from_str(&out).unwrap()
}

#[test]
fn a_soup_with_a_hole_becomes_a_complex_with_a_hole() {
    let folder = folder();
    std::fs::write(folder.path().join("holed.lar.json"), HOLED).unwrap();
    let words = [
        "triangulate2d",
        "holed.lar.json",
        "--json",
        "-o",
        "out.lar.json",
        "-o",
        "out.poly",
        "--operators",
        "d",
        "--svg",
        "out.svg",
    ];
    let object = json_of(folder.path(), &words);
    assert_eq!(object["schema"], "delone.triangulate2d/1");
    assert_eq!((&object["fill"], &object["area_exact"]), (&"nesting".into(), &"12".into()));
    assert_eq!((&object["edges"], &object["triangles"]), (&16.into(), &8.into()));
    assert_eq!(object["betti"], serde_json::json!([1, 1, 0]));
    assert_eq!(object["certificate"]["holds"], true);
    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    let lar: Value = serde_json::from_str(&read("out.lar.json")).unwrap();
    let lengths = ["V", "EV", "FV"].map(|key| lar[key].as_array().unwrap().len());
    assert_eq!(lengths, [8, 16, 8]);
    assert!(read("d.1.mtx").contains("\n8 16 32\n") && read("d.2.mtx").contains("\n16 8 24\n"));
    assert!(roxmltree::Document::parse(&read("out.svg")).is_ok());
    // The hole's point, as a seed, gives the same.
    let words = ["cdt", "out.poly", "--fill", "seeds", "--json", "--check", "-o", "kept.ele"];
    let object = json_of(folder.path(), &words);
    assert_eq!((&object["area_exact"], &object["check"]["ok"]), (&"12".into(), &true.into()));
    assert_eq!(read("kept.ele").lines().filter(|line| !line.starts_with('#')).count(), 9);
}

#[test]
fn fills_are_judged_and_refusals_named() {
    let folder = folder();
    std::fs::write(folder.path().join("holed.lar.json"), HOLED).unwrap();
    for (fill, area) in [("none", "16"), ("even-odd", "12"), ("nonzero", "16"), ("exterior", "16")]
    {
        let words = ["cdt", "holed.lar.json", "--fill", fill, "--json", "--check"];
        let object = json_of(folder.path(), &words);
        assert_eq!(
            (&object["area_exact"], &object["check"]["ok"]),
            (&area.into(), &true.into()),
            "{fill}"
        );
        assert_eq!(object["regions"].as_array().unwrap().len(), 2);
        let proved = object["check"]["proved"].to_string();
        assert_eq!(proved.contains("F2: each region"), fill != "none", "{proved}");
    }
    let open = HOLED.replace(",[7,4]]}", "]}");
    std::fs::write(folder.path().join("open.lar.json"), open.replace("[3,0],", "[3,0],[0,2],"))
        .unwrap();
    let (status, out, error) = run(folder.path(), &["cdt", "open.lar.json", "--fill", "even-odd"]);
    assert_eq!((status, out.as_str()), (2, ""));
    assert!(error.contains("3 segments end at point 0 (0, 0)"), "{error}");
    std::fs::write(folder.path().join("strict.lar.json"), HOLED.replace("]]}", "],[1,0]]}"))
        .unwrap();
    assert_eq!(run(folder.path(), &["cdt", "strict.lar.json"]).0, 0);
    let (status, _, error) = run(folder.path(), &["cdt", "strict.lar.json", "--strict"]);
    assert_eq!(status, 2);
    assert!(error.contains("segments 0 and 8 are the same"), "{error}");
}

#[test]
fn crossings_become_vertices() {
    let folder = folder();
    std::fs::write(folder.path().join("cross.poly"), CROSS).unwrap();
    let mut prints = Vec::new();
    for algorithm in ["cavity", "chew", "flips", "naive"] {
        let words = [
            "cdt",
            "cross.poly",
            "--crossings",
            "split",
            "--check",
            "--json",
            "--algorithm",
            algorithm,
        ];
        let object = json_of(folder.path(), &words);
        assert_eq!(
            (&object["steiner"], &object["vertices"], &object["cells"]),
            (&1.into(), &5.into(), &4.into())
        );
        assert_eq!(object["check"]["level"], "constrained delaunay");
        assert_eq!(object["rounding_keeps_validity"], true);
        prints.push(object["fingerprint"].clone());
    }
    assert!(prints.windows(2).all(|pair| pair[0] == pair[1]));
}

#[test]
fn costs_are_plotted_as_they_grow() {
    let folder = folder();
    let words = ["compare", "--scaling", "50,100,200", "--workloads", "grid,ladder"];
    let object = json_of(folder.path(), &[&words[..], &["--json", "--html", "g.html"]].concat());
    assert_eq!((&object["schema"], &object["ok"]), (&"delone.scaling/1".into(), &true.into()));
    let results = object["results"].as_array().unwrap();
    let steps = |algorithm: &str| -> Vec<f64> {
        let rows = results.iter().filter(|row| row["algorithm"] == algorithm);
        rows.map(|row| row["steps"].as_f64().unwrap()).collect()
    };
    for algorithm in ["divide-conquer", "bowyer-watson", "chew", "cavity"] {
        assert!(steps(algorithm).is_sorted() && steps(algorithm).len() == 3, "{algorithm}");
    }
    let page = std::fs::read_to_string(folder.path().join("g.html")).unwrap();
    let smallest = results.iter().filter(|row| row["sites"].as_f64().unwrap() < 60.0);
    assert_eq!(page.matches("<polyline").count(), 2 * smallest.count(), "a curve each, twice");
    assert_eq!(run(folder.path(), &["compare", "--scaling", "--workloads", "gird"]).0, 2);
    assert_eq!(run(folder.path(), &["compare", "--workloads", "grid"]).0, 2);
}

#[test]
fn figures_are_drawn() {
    let folder = folder();
    std::fs::write(folder.path().join("kite.poly"), KITE).unwrap();
    for words in [
        &["draw", "kite.poly", "--panels"][..],
        &["draw", "kite.poly", "--explode", "1.5", "--numbered", "--edges"],
    ] {
        let (status, svg, error) = run(folder.path(), words);
        assert_eq!(status, 0, "{error}");
        assert!(roxmltree::Document::parse(&svg).is_ok());
        let panels = svg.contains("Delaunay: 1 of 1 subsegments missing")
            && svg.contains("conforming Delaunay: 1 Steiner points")
            && svg.contains("1 edges not Delaunay");
        assert_eq!(panels, words.contains(&"--panels"));
    }
    assert_eq!(run(folder.path(), &["draw", "kite.poly", "--explode", "nan"]).0, 2);
}

#[test]
fn classroom_draws_three_lines_twice() {
    let folder = folder();
    let (status, out, error) = run(folder.path(), &["classroom", "-o", "maps.svg"]);
    assert_eq!((status, out.as_str(), error.as_str()), (0, "", ""));
    let svg = std::fs::read_to_string(folder.path().join("maps.svg")).unwrap();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let named = |name: &'static str| document.descendants().filter(move |n| n.has_tag_name(name));
    assert_eq!(named("g").count(), 6);
    // The squares of a map are all drawn, each once.
    for map in named("g") {
        let strokes = map.children().filter_map(|path| path.attribute("d"));
        let lengths = strokes.flat_map(|d| d.split('M').filter_map(|run| run.split('h').nth(1)));
        assert_eq!(lengths.map(|length| length.parse::<u32>().unwrap()).sum::<u32>(), 256 * 256);
    }
    // The first and the third line pass through the corner of their square: in line are 256 points, in one run each.
    let diagonal = |map: usize| {
        let map = named("g").nth(map).unwrap();
        map.children().filter_map(|n| n.attribute("d")).any(|d| d.matches("h1").count() == 256)
    };
    assert_eq!([0, 1, 2, 3, 4, 5].map(diagonal), [false, true, false, false, false, true]);
    assert_eq!(run(folder.path(), &["classroom"]).1, svg);
}

/// The comparison as tables: a row for each algorithm, and rules around them.
#[test]
fn a_comparison_is_written_as_tables() {
    let folder = folder();
    std::fs::write(folder.path().join("kite_1.poly"), KITE).unwrap();
    let words =
        ["compare", "kite_1.poly", "--only", "chew,cavity", "--csv", "t.csv", "--latex", "t.tex"];
    assert_eq!(run(folder.path(), &words).0, 0);
    let csv = std::fs::read_to_string(folder.path().join("t.csv")).unwrap();
    let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!((rows.len(), rows.iter().all(|row| row.len() == 11)), (3, true), "{csv}");
    assert_eq!(rows[1][4], "constrained delaunay");
    let tex = std::fs::read_to_string(folder.path().join("t.tex")).unwrap();
    assert!(
        tex.starts_with("\\begin{tabular}") && tex.contains("\\midrule\nkite\\_1.poly & "),
        "{tex}"
    );
}
