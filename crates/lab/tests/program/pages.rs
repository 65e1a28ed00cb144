//! Pages in a browser: headless Chromium clicks, drags, and reads the numbers that the page tells. Skipped, and said so, where
//! there is none.

use std::path::Path;
use std::process::Command;

use super::{folder, run};

/// Chromium, if it is installed.
fn browser() -> Option<&'static str> {
    let names = ["chromium", "chromium-browser", "google-chrome"];
    let found = names.into_iter().find(|name| {
        Command::new(name).arg("--version").output().is_ok_and(|output| output.status.success())
    });
    if found.is_none() {
        say("skipped: there is no Chromium to look at pages with");
    }
    found
}

#[expect(clippy::print_stderr, reason = "a test tells what it did not do")]
fn say(text: &str) {
    eprintln!("{text}");
}

fn look(browser: &str, page: &Path, acts: &[&str], more: &[String]) -> String {
    let home = tempfile::tempdir().unwrap();
    let address = format!("file://{}#do={}", page.display(), acts.join("|"));
    let output = Command::new(browser)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--window-size=1000,1200"])
        .args(["--virtual-time-budget=3000", "--host-resolver-rules=MAP * ~NOTFOUND"])
        .arg(format!("--user-data-dir={}", home.path().display()))
        .args(more)
        .arg(address)
        .output()
        .unwrap();
    String::from_utf8(output.stdout).unwrap()
}

/// What the page's line of numbers says after these acts.
fn state(browser: &str, page: &Path, acts: &[&str]) -> String {
    let dom = look(browser, page, acts, &["--dump-dom".to_owned()]);
    let (_, rest) = dom.split_once("<output class=\"state\">").expect("the page has its numbers");
    rest.split_once("</output>").unwrap().0.to_owned()
}

const KITE: &str = "5 2 0 0\n1 0 0\n2 3 1\n3 6 0\n4 3 -1\n5 3 2\n1 0\n1 1 3\n0\n";

/// Steps forward and back, layers, moving and zooming: each is done, and its numbers are read.
#[test]
fn a_replay_is_stepped_through() {
    let Some(browser) = browser() else { return };
    let folder = folder();
    std::fs::write(folder.path().join("kite.poly"), KITE).unwrap();
    let (status, out, error) = run(folder.path(), &["replay", "kite.poly", "--html", "r.html"]);
    assert_eq!(status, 0, "{error}");
    assert!(out.starts_with("7 steps"), "{out}"); // nothing, five sites, one segment
    let page = folder.path().join("r.html");
    let state = |acts: &[&str]| state(browser, &page, acts);
    // 2n - 2 - h triangles of 5 sites, 4 on the hull; the segment is one edge that is not Delaunay.
    let last = state(&[]);
    assert!(last.starts_with("step 6 of 6: segment 0 2 comes"), "{last}");
    assert!(
        last.contains("5 sites, 4 triangles, 1 constraints, 1 not Delaunay, 4 ghosts"),
        "{last}"
    );
    let back = state(&["click;button[data-go=back]"]);
    assert!(
        back.starts_with("step 5 of 6: site 4 comes") && back.contains("0 constraints"),
        "{back}"
    );
    let first = state(&["click;button[data-go=first]"]);
    assert!(first.starts_with("step 0 of 6") && first.contains("0 triangles"), "{first}");
    let third = state(&[
        "click;button[data-go=first]",
        "click;button[data-go=next]",
        "key;canvas;n",
        "key;canvas;n",
    ]);
    assert!(
        third.starts_with("step 3 of 6: site 2 comes") && third.contains("1 triangles"),
        "{third}"
    );
    let moved = state(&["drag;canvas;30;-20"]);
    assert!(moved.contains("moved 30 -20") && moved.contains("zoom 1.00"), "{moved}");
    let zoomed = state(&["wheel;canvas;-300"]);
    assert!(zoomed.contains("zoom 2.00"), "{zoomed}");
    let middle = state(&["drag;canvas;0;0"]);
    assert!(middle.contains("at (3.0"), "the pointer is in the middle: {middle}");
    assert!(state(&["click;input[data-layer=circles]"]).contains("step 6"));
}

/// Switching a layer changes the picture, and nothing else does.
#[test]
fn layers_are_seen() {
    let Some(browser) = browser() else { return };
    let folder = folder();
    let words = ["gen", "coast", "-n", "60", "-o", "coast.poly"];
    assert_eq!(run(folder.path(), &words).0, 0);
    let words = ["cdt", "coast.poly", "--html", "cdt.html", "--check", "-q"];
    let (status, _, error) = run(folder.path(), &words);
    assert_eq!(status, 0, "{error}");
    let page = folder.path().join("cdt.html");
    let shot = |acts: &[&str], name: &str| {
        let file = folder.path().join(name);
        look(browser, &page, acts, &[format!("--screenshot={}", file.display())]);
        std::fs::read(file).expect("a screenshot was taken")
    };
    let plain = shot(&[], "plain.png");
    assert!(plain.len() > 5000, "{}", plain.len());
    assert_eq!(plain, shot(&[], "again.png"));
    for layer in ["sites", "edges", "constraints", "circles", "ghosts"] {
        let act = format!("click;input[data-layer={layer}]");
        assert_ne!(plain, shot(&[&act], &format!("{layer}.png")), "{layer}");
    }
    let twice = ["click;input[data-layer=edges]", "click;input[data-layer=edges]"];
    assert_eq!(plain, shot(&twice, "twice.png"));
}

/// Algorithms from inside: their last step is the mesh that insertion makes, and those before it show blocks, events, strips.
#[test]
fn algorithms_are_seen_from_inside() {
    let Some(browser) = browser() else { return };
    let folder = folder();
    std::fs::write(folder.path().join("kite.poly"), KITE).unwrap();
    let page = folder.path().join("r.html");
    for (algorithm, steps, first, merged) in [
        ("divide-conquer", 4, "2 sites by themselves", "merged"),
        ("sweep", 7, "site event of", "circle event of"),
        ("chew", 3, "the strips", "come"),
    ] {
        let words = ["replay", "kite.poly", "--algorithm", algorithm, "--html", "r.html", "--json"];
        let (status, out, error) = run(folder.path(), &words);
        assert_eq!(status, 0, "{algorithm}: {error}");
        assert!(out.contains("\"agree\":true"), "{out}");
        let state = |acts: &[&str]| state(browser, &page, acts);
        let last = state(&[]);
        assert!(last.contains("the mesh is handed over") && last.contains("4 triangles"), "{last}");
        let at: usize = last.split_whitespace().nth(1).unwrap().parse().unwrap();
        assert!(at >= steps, "{algorithm}: {last}");
        let second = state(&["click;button[data-go=first]", "click;button[data-go=next]"]);
        assert!(second.contains(first), "{second}");
        let before = state(&["click;button[data-go=back]"]);
        assert!(before.contains(merged), "{before}");
    }
}

/// The table of a comparison fits into a window of common width.
#[test]
fn tables_fit() {
    let Some(browser) = browser() else { return };
    let folder = folder();
    assert_eq!(run(folder.path(), &["gen", "coast", "-n", "2000", "-o", "coast.poly"]).0, 0);
    let words = ["compare", "coast.poly", "--html", "c.html", "-q"];
    assert_eq!(run(folder.path(), &words).0, 0);
    let more = ["--dump-dom".to_owned(), "--window-size=1300,900".to_owned()];
    let dom = look(browser, &folder.path().join("c.html"), &["measure;.scroll"], &more);
    assert!(dom.contains("class=\"scroll\" data-beyond=\"0\""), "it runs off the page");
}

/// A click on a column's head sorts the table.
#[test]
fn tables_sort() {
    let Some(browser) = browser() else { return };
    let folder = folder();
    std::fs::write(folder.path().join("a.poly"), KITE).unwrap();
    assert_eq!(run(folder.path(), &["gen", "grid", "-n", "30", "-o", "b.node"]).0, 0);
    let words = ["compare", ".", "--html", "c.html", "-q"];
    let (status, _, error) = run(folder.path(), &words);
    assert_eq!(status, 0, "{error}");
    let first_row = |acts: &[&str]| {
        let dom = look(browser, &folder.path().join("c.html"), acts, &["--dump-dom".to_owned()]);
        let body = dom.split_once("<tbody>").expect("there is a table").1;
        body.split_once("</tr>").unwrap().0.to_owned()
    };
    let column = "click;th:nth-child(2) button"; // sites
    assert!(first_row(&[column]).contains("data-key=\"5\""));
    assert!(!first_row(&[column, column]).contains("data-key=\"5\""));
}
