//! The class exercise: a text, its outlines as a model, points inside, the alpha complex; joined by pipes.

use serde_json::Value;

use super::{delone, folder, run};

/// What a command prints, given this on standard input.
fn pipe(words: &[&str], text: &str) -> String {
    let output = delone().args(words).write_stdin(text.to_owned()).output().unwrap();
    assert!(output.status.success(), "{words:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn json(words: &[&str], text: &str) -> Value {
    serde_json::from_str(&pipe(words, text)).unwrap()
}

fn model() -> String {
    pipe(&["svg2lar", "-q"], &pipe(&["text", "\"Lar\""], ""))
}

fn sample(n: &str, method: &str) -> String {
    pipe(&["sample", "-n", n, "--seed", "1", "--method", method], &model())
}

#[test]
fn the_outlines_have_seven_components_and_a_hole() {
    let model: Value = serde_json::from_str(&model()).unwrap();
    let vertices = model["V"].as_array().unwrap();
    assert_eq!(vertices.len(), model["EV"].as_array().unwrap().len(), "rings");
    let object = json(&["triangulate2d", "-", "--fill", "even-odd", "--json"], &self::model());
    assert_eq!(object["betti"], serde_json::json!([7, 1, 0]), "{object}");
}

/// Rows of the signature: squared radius, b0, b1.
fn curve(n: &str) -> Vec<(f64, u64, u64)> {
    let object = json(&["alpha", "-", "--signature", "--json"], &sample(n, "uniform"));
    let rows = object["signature"].as_array().unwrap().iter();
    rows.map(|row| (row[0].as_f64().unwrap(), row[4].as_u64().unwrap(), row[5].as_u64().unwrap()))
        .collect()
}

/// The strokes of a quotation mark are 80 apart in units of 2^-12, and samples are inside: up to a radius of 40 at least
/// seven components are apart. From some radius on, the less the more points there are, each is in one piece without gaps.
#[test]
fn seven_components_and_a_hole_are_a_band() {
    for (n, from) in [("1000", 39.0), ("5000", 22.0), ("10000", 16.0)] {
        let curve = curve(n);
        let at = |radius: f64| {
            let square = (radius / 4096.0).powi(2);
            let last = curve.partition_point(|row| row.0 <= square);
            (curve[last - 1].1, curve[last - 1].2)
        };
        let mut radius: f64 = from;
        while radius < 40.0 {
            assert_eq!(at(radius), (7, 1), "n = {n}, radius {radius}");
            radius += 0.25;
        }
        assert!(curve.iter().filter(|row| row.0.sqrt() * 4096.0 < 40.0).all(|row| row.1 >= 7));
        assert!(at(60.0).0 < 7, "n = {n}");
    }
}

#[test]
fn all_conventions_name_one_complex() {
    let points = sample("300", "jittered");
    let ask = |flag: &str, value: &str| json(&["alpha", flag, value, "--json"], &points);
    let by_radius = ask("--radius", "0.0078125");
    for (flag, value) in [("--squared", "0.00006103515625"), ("--inverse", "128")] {
        assert_eq!(ask(flag, value)["simplices"], by_radius["simplices"], "{flag}");
        assert_eq!(ask(flag, value)["fingerprint"], by_radius["fingerprint"], "{flag}");
    }
    let rank = by_radius["rank"].as_f64().unwrap() / (by_radius["values"].as_f64().unwrap() - 1.0);
    assert_eq!(ask("--rank", &rank.to_string())["simplices"], by_radius["simplices"]);
    let betti = by_radius["betti"].as_array().unwrap();
    let critical = format!("betti={},{}", betti[0], betti[1]);
    assert_eq!(ask("--critical", &critical)["betti"], by_radius["betti"]);
}

#[test]
fn samplers_stay_inside_and_apart() {
    for (method, least, most) in [
        ("uniform", 400, 400),
        ("boundary", 400, 400),
        ("jittered", 300, 500),
        ("poisson", 250, 550),
    ] {
        let points = sample("400", method);
        let object = json(&["delaunay", "-", "--json"], &points);
        let count = object["input"]["sites"].as_u64().unwrap();
        assert!((least..=most).contains(&count), "{method}: {count}");
    }
}

#[test]
fn what_cannot_be_drawn_or_asked_is_refused() {
    for words in [
        &["text", "x"][..],
        &["alpha", "-", "--rank", "2"],
        &["alpha", "-", "--radius", "1", "--squared", "1"],
        &["alpha", "-"],
        &["alpha", "-", "--critical", "nothing"],
        &["alpha", "-", "--filtration", "--svg", "x.svg"],
    ] {
        let output = delone().args(words).write_stdin("0 0\n1 0\n0 1\n").output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{words:?}");
        assert!(!output.stderr.is_empty() && output.stdout.is_empty(), "{words:?}");
    }
}

#[test]
fn lists_are_ordered_and_exact() {
    let points = "0 0\n4 0\n0 3\n";
    let list = pipe(&["alpha", "-", "--format", "xyz", "--filtration", "--exact"], points);
    let rows: Vec<&str> = list.lines().skip(1).collect();
    let expected =
        ["0 0 0", "0 1 0", "0 2 0", "1 0 2 9/4", "1 0 1 4", "1 1 2 25/4", "2 0 1 2 25/4"];
    assert_eq!(rows, expected);
    let bars = pipe(&["alpha", "-", "--format", "xyz", "--persistence"], points);
    assert_eq!(bars.lines().skip(1).collect::<Vec<_>>(), ["0 0.0 inf", "0 0.0 2.25", "0 0.0 4.0"]);
}

#[test]
fn a_slider_holds_every_complex() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("lar.html");
    let page = path.to_str().unwrap();
    let object =
        json(&["alpha", "--unit", "0.01", "--html", page, "--json"], &sample("300", "uniform"));
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains(&format!("max=\"{}\"", object["values"])));
    assert!(text.contains(&format!("value=\"{}\"", object["rank"].as_u64().unwrap() + 1)));
    let output = delone()
        .args(["alpha", "--rank", "1", "--html", page])
        .write_stdin("0 0 1\n1 2 0\n0 3 1\n1 1 1\n")
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2), "space has no slider");
}

/// A list of a filtration is judged by definition; a value that is off by its last bit is found.
#[test]
fn filtrations_are_judged() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    for workload in ["grid", "uniform", "uniform-3d"] {
        let points = path("points.node");
        pipe(&["gen", workload, "-n", "30", "-o", &points], "");
        for form in [&["--exact"][..], &["--json"], &[]] {
            let words = [&["alpha", &points, "--filtration"], form].concat();
            let list = pipe(&words, "");
            let (right, wrong) = (path("right"), path("wrong"));
            std::fs::write(&right, &list).unwrap();
            let object = json(&["check", &points, &right, "--as", "alpha", "--json"], "");
            assert_eq!(object["check"]["level"], "alpha filtration", "{object}");
            // Some vertex's value, which is zero.
            let (zero, other) = match form {
                ["--exact"] => (" 0\n", " 1\n"),
                ["--json"] => ("],0.0]", "],5e-324]"),
                _ => (" 0.0\n", " 5e-324\n"),
            };
            assert!(list.contains(zero), "{list}");
            std::fs::write(&wrong, list.replacen(zero, other, 1)).unwrap();
            delone().args(["check", &points, &wrong, "--as", "alpha"]).assert().code(1);
        }
    }
}

/// Pictures of a filtration, and of an alpha hull with its arcs.
#[test]
fn filtrations_are_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let sample = sample("300", "uniform");
    let draw = |words: &[&str]| {
        let file = path("picture.svg");
        pipe(&[&["alpha", "-"], words, &["--svg", &file]].concat(), &sample);
        std::fs::read_to_string(&file).unwrap()
    };
    assert_eq!(draw(&["--signature"]).matches("class=\"betti\"").count(), 2);
    assert!(draw(&["--persistence"]).matches("class=\"bar\"").count() > 100);
    let hull = draw(&["--radius", "0.02", "--hull"]);
    assert!(
        hull.contains("class=\"arc\"") && !draw(&["--radius", "0.02"]).contains("class=\"arc\"")
    );
    delone()
        .args(["alpha", "-", "--filtration", "--svg", &path("no.svg")])
        .write_stdin(sample)
        .assert()
        .code(2);
}

/// A square with a square hole: each step is a picture, with what belongs to it and no more.
#[test]
fn each_step_is_explained_by_a_picture() {
    let folder = folder();
    let ring = "8 2 0 0\n1 0 0\n2 9 0\n3 9 9\n4 0 9\n5 3 3\n6 6 3\n7 6 6\n8 3 6\n8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n0\n";
    std::fs::write(folder.path().join("ring.poly"), ring).unwrap();
    let words = ["triangulate2d", "ring.poly", "--explain", "steps/ring", "-q"];
    let (status, _, error) = run(folder.path(), &words);
    assert_eq!(status, 0, "{error}");
    let steps = ["1-soup", "2-cdt", "3-edges", "4-regions", "5-inside"];
    let files = std::fs::read_dir(folder.path().join("steps/ring")).unwrap();
    assert_eq!(files.count(), steps.len());
    // Lines by kind, and triangles that have a number.
    let drawn = steps.map(|step| {
        let path = folder.path().join("steps/ring").join(step).with_extension("svg");
        let svg = std::fs::read_to_string(path).unwrap();
        let document = roxmltree::Document::parse(&svg).unwrap();
        let nodes = |tag, class| {
            let of_class = move |node: &roxmltree::Node<'_, '_>| {
                node.has_tag_name(tag) && node.attribute("class") == Some(class)
            };
            document.descendants().filter(of_class)
        };
        let lines = |class| -> usize {
            nodes("path", class)
                .filter_map(|n| n.attribute("d"))
                .map(|d| d.matches('M').count())
                .sum()
        };
        let texts = nodes("g", "cellnumber").flat_map(|group| group.descendants());
        let numbers = texts.filter(|node| node.has_tag_name("text")).count();
        [lines("segment"), lines("highlight"), numbers]
    });
    // Eight sites, four on the hull: ten triangles, two of them in the hole; of the eight inside, eight edges have two, eight have one.
    assert_eq!(drawn, [[8, 0, 0], [8, 0, 10], [8, 8, 0], [8, 0, 10], [8, 0, 8]]);
    let word = ["triangulate2d", "ring.poly", "--explain", "ring.poly"];
    assert_eq!(run(folder.path(), &word).0, 2, "a file is no folder");
}
