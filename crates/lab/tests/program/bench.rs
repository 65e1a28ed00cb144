//! `delone bench`: a wrong answer has no time.

use std::path::Path;

use serde_json::Value;

use super::{folder, run};

/// Engines of which one is right, one loses a triangle, one is not there, one refuses, one has the pinned answer wrong.
const ENGINES: &str = r#"
[[engine]]
name = "ours"
command = "{self} engine {task} {in} {out} {times}"
ours = true
[[engine]]
name = "liar"
command = "sh -c '{self} engine {task} {in} {out}.all.ele 1 > /dev/null; echo seconds 1e-9; awk \"NR == 1 {print \\$1 - 1, \\$2, \\$3} NR > 2\" {out}.all.ele > {out}'"
[[engine]]
name = "absent"
command = "no-such-engine {in} {out}"
build = "make absent"
[[engine]]
name = "shy"
command = "sh -c 'echo seconds 1e-9; echo no thanks >&2; exit 4'"
"#;

fn definition(answer: &str) -> String {
    format!(
        "name = \"d\"\nanalysis = \"a\"\ntask = \"cdt\"\nrounds = 2\ntimes = 3\n\
         engines = [\"ours\", \"liar\", \"absent\", \"shy\"]\n\
         [[input]]\nworkload = \"coast\"\nanswers = {{ 60 = \"{answer}\", 200 = \"\" }}\n"
    )
}

fn bench(folder: &Path, answer: &str) -> (i32, Value) {
    std::fs::write(folder.join("engines.toml"), ENGINES).unwrap();
    std::fs::write(folder.join("d.toml"), definition(answer)).unwrap();
    let words = [
        "bench",
        "d.toml",
        "--engines",
        "engines.toml",
        "--json",
        "--csv",
        "r.csv",
        "--html",
        "r.html",
        "--latex",
        "r.tex",
    ];
    let (status, out, error) = run(folder, &words);
    (status, serde_json::from_str(&out).unwrap_or_else(|_| panic!("{status} {error}")))
}

fn rows<'o>(object: &'o Value, engine: &str, sites: u64) -> Vec<&'o Value> {
    let rows = object["records"].as_array().unwrap().iter();
    rows.filter(|row| row["engine"] == engine && row["sites"] == sites).collect()
}

#[test]
fn a_wrong_engine_posts_no_time() {
    let folder = folder();
    let (status, object) = bench(folder.path(), "");
    assert_eq!(status, 0, "a peer that is wrong has no time, and is no fault of ours");
    let ours = rows(&object, "ours", 60);
    assert_eq!(ours.len(), 6, "two rounds, three times each");
    assert!(ours.iter().all(|row| row["verdict"] == "ok" && row["time"].as_f64().unwrap() > 0.0));
    assert!(ours[0]["counts"].as_str().unwrap().contains("subsegments=60"), "{}", ours[0]);
    for (engine, word) in [
        ("liar", "WRONG"),
        ("absent", "absent: make absent"),
        ("shy", "refused: exit status: 4: no thanks"),
    ] {
        let rows = rows(&object, engine, 60);
        assert_eq!(rows.len(), 1, "{engine}: one row says why");
        assert!(rows[0]["time"].is_null());
        assert!(rows[0]["verdict"].as_str().unwrap().starts_with(word), "{}", rows[0]);
    }
    let tex = std::fs::read_to_string(folder.path().join("r.tex")).unwrap();
    assert!(tex.contains("\\toprule") && tex.contains("& wrong & -- & --"), "{tex}");
    let words = ["bench", "d.toml", "--engines", "engines.toml", "--strict", "--rounds", "1"];
    assert_eq!(run(folder.path(), &words).0, 1, "but for those who ask");
    let html = std::fs::read_to_string(folder.path().join("r.html")).unwrap();
    assert!(html.contains(", n^"), "exponents are fitted");
    assert!(roxmltree::Document::parse(html.trim_start_matches("<!DOCTYPE html>\n")).is_ok());
}

/// Who takes too long has no time, and no turn on more sites.
#[test]
fn a_slow_engine_is_stopped() {
    let folder = folder();
    let engines =
        format!("{ENGINES}[[engine]]\nname = \"sloth\"\ncommand = \"sleep 60 # {{in}} {{out}}\"\n");
    std::fs::write(folder.path().join("engines.toml"), engines).unwrap();
    let text = definition("").replace("\"liar\", \"absent\", \"shy\"", "\"sloth\"");
    std::fs::write(folder.path().join("d.toml"), format!("limit = 1.5\n{text}")).unwrap();
    let words = ["bench", "d.toml", "--engines", "engines.toml", "--json"];
    let (status, out, _) = run(folder.path(), &words);
    assert_eq!(status, 0);
    let object: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(rows(&object, "sloth", 60)[0]["verdict"], "slow: more than 1.5 s");
    let larger = rows(&object, "sloth", 200)[0]["verdict"].as_str().unwrap();
    assert_eq!(larger, "slow: it was too slow on fewer sites");
    assert_eq!(rows(&object, "ours", 200).len(), 6);
}

/// In a table of calls, too: wrong signs have no time, and those of ours fail.
#[test]
fn a_table_is_read_by_its_marks() {
    let folder = folder();
    let table = "[[engine]]\nname = \"table\"\ncommand = \"printf '| a | ours: 2.5 (2..3) | peer: 1.0 (1..1) (x) |\\n'\"\n";
    std::fs::write(folder.path().join("engines.toml"), table).unwrap();
    let definition = "name = \"t\"\nanalysis = \"a\"\ntask = \"table\"\nengines = [\"table\"]\n";
    let status = |ours: &str| {
        std::fs::write(folder.path().join("t.toml"), format!("{definition}ours = [\"{ours}\"]\n"))
            .unwrap();
        let (status, out, error) =
            run(folder.path(), &["bench", "t.toml", "--engines", "engines.toml", "--json"]);
        let object: Value = serde_json::from_str(&out).unwrap_or_else(|_| panic!("{error}"));
        assert_eq!(rows(&object, "ours", 0)[0]["time"], 2.5);
        assert!(rows(&object, "peer", 0)[0]["time"].is_null());
        status
    };
    assert_eq!([status("ours"), status("peer")], [0, 1]);
}

#[test]
fn a_pinned_answer_binds_ours() {
    let folder = folder();
    let (_, object) = bench(folder.path(), "");
    let answer = rows(&object, "ours", 60)[0]["fingerprint"].as_str().unwrap().to_owned();
    assert_eq!(rows(&bench(folder.path(), &answer).1, "ours", 60).len(), 6);
    let other = answer.chars().rev().collect::<String>();
    let (status, object) = bench(folder.path(), &other);
    assert_eq!(status, 1);
    let row = rows(&object, "ours", 60)[0];
    assert!(
        row["time"].is_null() && row["verdict"].as_str().unwrap().starts_with("WRONG"),
        "{row}"
    );
    assert_eq!(rows(&object, "ours", 200).len(), 6, "other inputs are timed");
}

#[test]
fn records_compare() {
    let folder = folder();
    bench(folder.path(), "");
    let record = std::fs::read_to_string(folder.path().join("r.csv")).unwrap();
    assert!(record.lines().next().unwrap().ends_with("commit,cpu"));
    let (status, out, _) = run(folder.path(), &["bench", "compare", "r.csv", "r.csv", "--json"]);
    assert_eq!(status, 0);
    let object: Value = serde_json::from_str(&out).unwrap();
    let rows = object["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 2, "only what was timed is compared");
    assert!(rows.iter().all(|row| row["ratio"] == 1.0));
    std::fs::write(folder.path().join("x.csv"), "no record\n").unwrap();
    assert_eq!(run(folder.path(), &["bench", "compare", "r.csv", "x.csv"]).0, 2);
}

/// Files are run as workloads are, and a workload may lose segments.
#[test]
fn files_and_fewer_segments_are_run() {
    let folder = folder();
    run(folder.path(), &["gen", "coast", "-n", "60", "-o", "lake.poly"]);
    let text = definition("")
        .replace("[[input]]", "[[file]]\npath = \"lake.poly\"\n[[input]]\nsegments = 7");
    std::fs::write(folder.path().join("engines.toml"), ENGINES).unwrap();
    std::fs::write(folder.path().join("d.toml"), text).unwrap();
    let words = ["bench", "d.toml", "--engines", "engines.toml", "--only", "ours", "--json"];
    let (status, out, error) = run(folder.path(), &words);
    assert_eq!(status, 0, "{error}");
    let object: Value = serde_json::from_str(&out).unwrap();
    let told = |row: &&Value| (row["input"].as_str().unwrap().to_owned(), row["segments"].as_u64());
    let mut inputs: Vec<_> = rows(&object, "ours", 60).iter().map(told).collect();
    inputs.dedup();
    let expected = [("coast, 7 segments", 7), ("lake.poly", 60)];
    assert_eq!(inputs, expected.map(|(name, count)| (name.to_owned(), Some(count))));
}

#[test]
fn bad_definitions_are_named() {
    let folder = folder();
    std::fs::write(folder.path().join("engines.toml"), ENGINES).unwrap();
    for (text, expected) in [
        ("name = 3", "d.toml"),
        (
            "name = \"d\"\nanalysis = \"\"\ntask = \"cdt\"\nengines = [\"x\"]\n",
            "no engine is called x",
        ),
        ("name = \"d\"\nanalysis = \"\"\ntask = \"cdt\"\nengines = []\nspeed = 3\n", "speed"),
        (
            "name = \"d\"\nanalysis = \"\"\ntask = \"cdt\"\nengines = []\n[[input]]\nworkload = \"cost\"\nanswers = {}\n",
            "coast",
        ),
        (
            "name = \"d\"\nanalysis = \"\"\ntask = \"cdt\"\nengines = []\n[[file]]\npath = \"lake.poly\"\n",
            "lake.poly",
        ),
    ] {
        std::fs::write(folder.path().join("d.toml"), text).unwrap();
        let (status, _, error) =
            run(folder.path(), &["bench", "d.toml", "--engines", "engines.toml"]);
        assert!(status == 2 && error.contains(expected), "{text}: {error}");
    }
}

/// The project's own definitions are read, and what is small in them is run: the pinned answers are the answers.
#[test]
fn the_definitions_of_the_project_hold() {
    let folder = folder();
    let words =
        ["bench", "--sites-max", "1000", "--rounds", "1", "--only", "chew,cavity", "--json"];
    let (status, out, error) = run(folder.path(), &words);
    assert_eq!(status, 0, "{error}");
    let object: Value = serde_json::from_str(&out).unwrap();
    let (chew, cavity) = (rows(&object, "chew", 1000), rows(&object, "cavity", 1000));
    assert_eq!((chew.len(), cavity.len()), (2, 2), "the ladder, twice in one turn");
    assert!(chew.iter().chain(&cavity).all(|row| row["verdict"] == "ok"), "{object}");
}
