//! `delone fuzz` and `delone shrink`.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::{folder, run};

fn json(folder: &Path, words: &[&str]) -> (i32, Value) {
    let (status, out, error) = run(folder, &[words, &["--json", "--quiet"]].concat());
    let value = serde_json::from_str(&out);
    (status, value.unwrap_or_else(|_| panic!("{words:?}: {status} {out} {error}")))
}

/// The triangulator of the examples, beside the tests' own programs.
fn buggy() -> PathBuf {
    let tests = std::env::current_exe().unwrap();
    let program = tests.ancestors().nth(2).unwrap().join("examples/buggy_cdt");
    assert!(
        program.is_file(),
        "cargo test -p delone-lab builds the examples, too; --test program alone does not"
    );
    program
}

#[test]
fn the_canary_dies_and_nothing_else_fails() {
    let folder = folder();
    let (status, object) = json(folder.path(), &["fuzz", "--cases", "5"]);
    assert_eq!(status, 0, "{object}");
    assert_eq!(object["schema"], "delone.fuzz/1");
    assert!(object["canary"].as_u64().unwrap() < 500);
    assert_eq!(
        object["executions"].as_u64().unwrap(),
        5 * object["targets"].as_array().unwrap().len() as u64
    );
    assert!(!folder.path().join("delone-failures").exists());
}

#[test]
fn failures_are_kept_small_and_fail_again() {
    let folder = folder();
    let (status, object) = json(folder.path(), &["fuzz", "canary", "--cases", "300"]);
    assert_eq!(status, 1);
    let failures = object["failures"].as_array().unwrap();
    assert!(!failures.is_empty());
    let first = &failures[0];
    assert_eq!(first["law"], "canary");
    assert!(first["points"].as_u64().unwrap() <= 4, "{first}");
    let file = first["file"].as_str().unwrap();
    let text = std::fs::read_to_string(folder.path().join(file)).unwrap();
    assert!(text.starts_with("# law: canary\n"), "{text}");
    let case = first["case"].to_string();
    let (status, again) = json(folder.path(), &["fuzz", "canary", "--case", &case]);
    assert_eq!((status, &again["ok"]), (1, &false.into()));
    let words = ["shrink", file, "--law", "canary", "--target", "canary", "-o", "less.node"];
    let (status, small) = json(folder.path(), &words);
    assert_eq!(status, 0, "{small}");
    assert!(folder.path().join("less.node").is_file());
}

#[test]
fn shards_in_processes_say_what_one_process_says() {
    let folder = folder();
    let words = ["fuzz", "canary", "predicates-2d", "--cases", "150", "--seed", "9"];
    let (_, whole) = json(folder.path(), &words);
    let split = [&words[..], &["--shards", "8", "--state", "runs"]].concat();
    let (status, merged) = json(folder.path(), &split);
    assert_eq!(status, 1);
    let digests = |object: &Value| -> Vec<(String, u64, String)> {
        let row = |t: &Value| {
            (t["target"].to_string(), t["executions"].as_u64().unwrap(), t["digest"].to_string())
        };
        object["targets"].as_array().unwrap().iter().map(row).collect()
    };
    assert_eq!(digests(&merged), digests(&whole));
    assert_eq!(merged["failures"], whole["failures"]);
    // Merged once more, from the files alone; then with one of them gone.
    let (_, again) =
        json(folder.path(), &["fuzz", "canary", "predicates-2d", "--merge", "runs", "--seed", "9"]);
    assert_eq!(digests(&again), digests(&whole));
    std::fs::remove_file(folder.path().join("runs/canary.seed-9.3-of-8.json")).unwrap();
    let (status, _, error) = run(folder.path(), &["fuzz", "canary", "--merge", "runs"]);
    assert!(status == 2 && error.contains("shard"), "{error}");
}

#[test]
fn a_campaign_goes_on_from_what_is_there() {
    let folder = folder();
    let run = |cases: &str, words: &[&str]| {
        let all = ["fuzz", "predicates-2d", "--cases", cases];
        json(folder.path(), &[&all[..], words].concat()).1["targets"][0]["digest"].clone()
    };
    let half = run("40", &["--state", "runs"]);
    assert_eq!(run("40", &["--state", "runs"]), half, "a finished shard is not run again");
    assert_eq!(run("90", &["--state", "runs"]), run("90", &[]));
}

/// A newcomer's path: somebody's triangulator is found out, with an input of at most eight vertices.
#[test]
fn a_buggy_program_is_found_out() {
    let folder = folder();
    let command = format!("'{}' {{in}} {{out}}", buggy().display());
    let words = ["fuzz", "cdt", "--program", &command, "--cases", "300", "--first"];
    let (status, object) = json(folder.path(), &words);
    assert_eq!(status, 1, "{object}");
    let failure = &object["failures"][0];
    assert!(failure["points"].as_u64().unwrap() <= 8, "{failure}");
    // The file fails again under shrink, and passes with a program that is right.
    let file = failure["file"].as_str().unwrap();
    assert_eq!(
        json(folder.path(), &["shrink", file, "--program", &command, "-o", "less.poly"]).0,
        0
    );
    let right = format!("'{}' cdt {{in}} -q -o {{out}}", env!("CARGO_BIN_EXE_delone"));
    let (status, out, error) = run(folder.path(), &["shrink", file, "--program", &right]);
    assert_eq!(status, 2, "{out} {error}");
    assert!(error.contains("nothing fails"), "{error}");
}

#[test]
fn programs_that_hang_crash_or_are_not_there_are_told() {
    let folder = folder();
    let law = |command: &str| {
        let words =
            ["fuzz", "cdt", "--program", command, "--cases", "40", "--first", "--timeout", "0.2"];
        let (status, object) = json(folder.path(), &words);
        assert_eq!(status, 1);
        object["failures"][0]["place"].as_str().unwrap().to_owned()
    };
    assert_eq!(law("sh -c 'exit 3 # {in} {out}'"), "exit status: 3");
    assert_eq!(law("sh -c 'true # {in} {out}'"), "read");
    assert_eq!(law("no-such-program {in} {out}"), "start");
    assert!(law("sh -c 'kill -9 $$ # {in} {out}'").contains("signal"));
    assert_eq!(law("sh -c 'exec sleep 5 # {in} {out}'"), "time limit");
    let (status, _, error) = run(folder.path(), &["fuzz", "cdt", "--program", "mycdt in out"]);
    assert!(status == 2 && error.contains("{in}"), "{error}");
    let words = [
        "fuzz",
        "cdt",
        "--program",
        "sh -c 'exit 3 # {in} {out}'",
        "--cases",
        "20",
        "--accept-refusal",
    ];
    assert_eq!(json(folder.path(), &words).0, 0);
}

/// Cases with pieces of the user's files: others than without, the same in shards, made again by number; another folder, another
/// campaign.
#[test]
fn a_corpus_takes_part() {
    let folder = folder();
    let corpus = folder.path().join("mine");
    std::fs::create_dir(&corpus).unwrap();
    std::fs::write(corpus.join("a.xyz"), "12345.5 1\n2 3\n12345.5 9\n").unwrap();
    std::fs::write(corpus.join("notes"), "nothing to read\n").unwrap();
    let words = ["fuzz", "predicates-2d", "--cases", "60"];
    let digest = |more: &[&str]| {
        let (status, object) = json(folder.path(), &[&words[..], more].concat());
        assert_eq!(status, 0, "{object}");
        object["targets"][0]["digest"].clone()
    };
    let with = digest(&["--corpus", "mine"]);
    assert_ne!(with, digest(&[]));
    assert_eq!(with, digest(&["--corpus", "mine", "--shards", "3", "--state", "runs"]));
    let merge = ["fuzz", "predicates-2d", "--merge", "runs"];
    assert_eq!(run(folder.path(), &merge).0, 2, "those shards are of another campaign");
    let merge = [&merge[..], &["--corpus", "mine"]].concat();
    assert_eq!(json(folder.path(), &merge).1["targets"][0]["digest"], with);
    std::fs::write(corpus.join("a.xyz"), "12345.5 1\n").unwrap();
    assert_ne!(with, digest(&["--corpus", "mine"]));
    std::fs::remove_file(corpus.join("a.xyz")).unwrap();
    assert_eq!(run(folder.path(), &[&words[..], &["--corpus", "mine"]].concat()).0, 2);
}

/// Shards that were given a time are brought level: together they are one process.
#[test]
fn shards_by_time_are_brought_level() {
    let folder = folder();
    let words = ["fuzz", "predicates-2d", "--seconds", "0.4", "--shards", "2", "--state", "runs"];
    let (status, object) = json(folder.path(), &words);
    assert_eq!(status, 0, "{object}");
    let target = &object["targets"][0];
    assert!(target["per_second"].as_f64().unwrap() > 0.0);
    let cases = target["executions"].to_string();
    let (_, one) = json(folder.path(), &["fuzz", "predicates-2d", "--cases", &cases]);
    assert_eq!(one["targets"][0]["digest"], target["digest"]);
}

#[test]
fn bad_words_are_refused() {
    let folder = folder();
    for words in [
        &["fuzz", "no-such-target"][..],
        &["fuzz", "cdt", "--shard", "8/8", "--state", "x"],
        &["fuzz", "cdt", "--shard", "1/8"],
        &["fuzz", "--program", "x {in} {out}"],
        &["fuzz", "--case", "3"],
        &["fuzz", "--merge", "nowhere"],
        &["shrink", "absent.poly", "--law", "valid"],
    ] {
        assert_eq!(run(folder.path(), words).0, 2, "{words:?}");
    }
}
