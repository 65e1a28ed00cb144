//! Ctrl-C: nothing is left half-written, whatever the program was at.
#![cfg(unix)]

use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use super::{folder, run};

/// A command in a group of its own, as a shell starts it.
fn start(folder: &Path, words: &[&str]) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_delone"));
    command.current_dir(folder).args(words).process_group(0);
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

/// What a terminal sends at Ctrl-C, to the whole group; the exit status.
fn interrupt(mut child: Child) -> i32 {
    let group = format!("-{}", child.id());
    assert!(Command::new("kill").args(["-INT", "--", &group]).status().unwrap().success());
    let patience = Instant::now();
    loop {
        if let Some(status) = child.try_wait().unwrap() {
            return status.code().unwrap_or(-1);
        }
        assert!(patience.elapsed() < Duration::from_secs(60), "it does not end");
        std::thread::sleep(Duration::from_millis(10));
    }
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap().flatten();
    let mut names: Vec<String> =
        entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// Starts a command, waits until it writes, and interrupts it.
fn interrupted_in_writing(folder: &Path, words: &[&str]) -> i32 {
    let child = start(folder, words);
    let patience = Instant::now();
    while !names(folder).iter().any(|name| name.ends_with(".part")) {
        assert!(patience.elapsed() < Duration::from_secs(120), "{words:?} does not write");
        std::thread::sleep(Duration::from_millis(1));
    }
    interrupt(child)
}

#[test]
fn a_file_is_whole_or_not_there() {
    let folder = folder();
    let words = ["gen", "uniform", "-n", "400000", "-o", "big.node"];
    let status = interrupted_in_writing(folder.path(), &words);
    // On a slow machine it may just have ended.
    assert!(status == 130 || names(folder.path()) == ["big.node"], "{status}");
    assert_eq!(run(folder.path(), &words).0, 0);
    let status = interrupted_in_writing(folder.path(), &["convert", "big.node", "-o", "big.csv"]);
    let left = names(folder.path());
    assert!(status == 130 && left == ["big.node"] || left == ["big.csv", "big.node"], "{left:?}");
}

#[test]
fn what_was_not_done_is_not_there() {
    let folder = folder();
    let wait = || std::thread::sleep(Duration::from_millis(700));
    let child = start(folder.path(), &["compare", "-n", "30000", "--html", "c.html"]);
    wait();
    assert_eq!(interrupt(child), 130);
    let engine = "[[engine]]\nname = \"slow\"\ncommand = \"sleep 30\"\n";
    std::fs::write(folder.path().join("e.toml"), engine).unwrap();
    let definition = "name = \"d\"\nanalysis = \"a\"\ntask = \"cdt\"\nengines = [\"slow\"]\n\
                      [[input]]\nworkload = \"coast\"\nanswers = { 60 = \"\" }\n";
    std::fs::write(folder.path().join("d.toml"), definition).unwrap();
    let child = start(folder.path(), &["bench", "d.toml", "--engines", "e.toml", "--csv", "r.csv"]);
    wait();
    assert_eq!(interrupt(child), 3, "what was run until then is told");
    let record = std::fs::read_to_string(folder.path().join("r.csv")).unwrap();
    assert_eq!(record.lines().count(), 1, "an interrupted turn says nothing: {record}");
    let child = start(folder.path(), &["fuzz", "cdt", "--seconds", "60", "--state", "runs"]);
    wait();
    assert_eq!(interrupt(child), 3);
    assert_eq!(names(folder.path()), ["d.toml", "e.toml", "r.csv", "runs"]);
    assert_eq!(names(&folder.path().join("runs")), ["cdt.seed-1.0-of-1.json"]);
    let (status, _, error) = run(folder.path(), &["fuzz", "cdt", "--merge", "runs"]);
    assert_eq!(status, 0, "the state is whole: {error}");
}
