//! Regular triangulations, their diagrams, and runs that a time limit stops.

use serde_json::Value;

use super::{KITE, folder, run};

/// A square of five points of the plane with the weight of the one in the middle.
fn square(weight: f64) -> String {
    format!("x,y,w\n0,0,0\n4,0,0\n4,4,0\n0,4,0\n2,2,{weight}\n2,2,-9\n")
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

#[test]
fn weights_make_a_regular_triangulation_and_name_what_is_hidden() {
    let folder = folder();
    // The corners are lifted to the plane 4 x + 4 y, which is at 16 over the middle; that is lifted to 8 - w.
    for (weight, cells, hidden) in [(1.0, 4, vec![5]), (-20.0, 2, vec![4, 5])] {
        std::fs::write(folder.path().join("in.csv"), square(weight)).unwrap();
        let words = ["delaunay", "in.csv", "--json", "--check", "-o", "out.lar.json"];
        let (status, out, error) = run(folder.path(), &words);
        assert_eq!(status, 0, "{out} {error}");
        let object = json(&out);
        assert_eq!(
            (&object["cells"], &object["vertices"]),
            (&cells.into(), &(cells / 2 + 3).into())
        );
        assert_eq!(object["hidden"], Value::from(hidden));
        assert_eq!(
            (&object["check"]["level"], &object["check"]["ok"]),
            (&"regular".into(), &true.into())
        );
        let check = |kind| {
            run(folder.path(), &["check", "in.csv", "out.lar.json", "--as", kind, "--strict"])
        };
        assert_eq!(check("regular").0, 0, "{}", check("regular").1);
        assert_eq!(
            check("delaunay").0,
            i32::from(weight < 0.0),
            "without the middle it is not Delaunay"
        );
        // Judged with other weights it is wrong.
        std::fs::write(
            folder.path().join("w.txt"),
            format!("0 0 0,0 # corners\n{}\n-99\n", -weight * 30.0),
        )
        .unwrap();
        let words = ["check", "in.csv", "out.lar.json", "--as", "regular", "--weights", "w.txt"];
        assert_eq!(run(folder.path(), &words).0, 1);
    }
}

#[test]
fn weights_come_from_a_file_and_are_refused_by_number_and_place() {
    let folder = folder();
    std::fs::write(folder.path().join("kite.poly"), KITE).unwrap();
    let words = ["delaunay", "kite.poly", "--weights", "w.txt", "--json", "-o", "out.ele"];
    let refused = [
        ("1 2 3", "4 points have 3 weights"),
        ("1 2\n3 four", "w.txt:2: four"),
        ("1 2 3 inf", "point 3"),
    ];
    for (text, expected) in refused {
        std::fs::write(folder.path().join("w.txt"), text).unwrap();
        let (status, out, error) = run(folder.path(), &words);
        assert!(status == 2 && out.is_empty() && error.contains(expected), "{error}");
        assert!(!folder.path().join("out.ele").exists());
    }
    // The second point is a corner of the hull, which no weight can hide.
    std::fs::write(folder.path().join("w.txt"), "0 -100 0 0").unwrap();
    let (status, out, error) = run(folder.path(), &words);
    assert_eq!(status, 0, "{error}");
    assert_eq!((&json(&out)["cells"], &json(&out)["vertices"]), (&2.into(), &4.into()));
    let words = ["check", "kite.poly", "out.ele", "--as", "regular"];
    let (status, _, error) = run(folder.path(), &words);
    assert!(status == 2 && error.contains("--weights"), "{error}");
}

#[test]
fn one_position_with_weights_is_its_heaviest() {
    let folder = folder();
    for dimension in ["x,y,w\n1,1,0\n1,1,5\n1,1,2\n", "x,y,z,w\n1,1,1,0\n1,1,1,5\n1,1,1,2\n"] {
        std::fs::write(folder.path().join("in.csv"), dimension).unwrap();
        let (status, out, error) =
            run(folder.path(), &["delaunay", "in.csv", "--json", "-o", "out.lar.json"]);
        assert_eq!(status, 0, "{error}");
        assert_eq!(json(&out)["hidden"], Value::from(vec![0, 2]));
        let words = ["check", "in.csv", "out.lar.json", "--as", "regular", "--strict"];
        let (status, out, error) = run(folder.path(), &words);
        assert_eq!(status, 0, "{out} {error}");
    }
}

#[test]
fn a_time_limit_stops_with_three_and_writes_nothing() {
    let folder = folder();
    run(folder.path(), &["gen", "uniform", "-n", "500", "-o", "plane.csv"]);
    run(folder.path(), &["gen", "sphere", "-n", "500", "-o", "space.csv"]);
    let plane = std::fs::read_to_string(folder.path().join("plane.csv")).unwrap();
    let weighted = plane
        .lines()
        .map(|line| if line == "x,y" { "x,y,w".to_owned() } else { format!("{line},0") });
    std::fs::write(folder.path().join("weighted.csv"), weighted.collect::<Vec<_>>().join("\n"))
        .unwrap();
    for input in ["plane.csv", "space.csv", "weighted.csv"] {
        let with = |limit| {
            run(
                folder.path(),
                &["delaunay", input, "--time-limit", limit, "--json", "-o", "out.csv"],
            )
        };
        let (status, out, error) = with("0");
        assert_eq!((status, out.as_str()), (3, ""), "{error}");
        assert!(
            error.contains("time limit of 0 s") && error.contains("nothing was written"),
            "{error}"
        );
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 3, "no file more");
        let (status, limited, error) = with("1000");
        assert_eq!(status, 0, "{error}");
        let (_, free, _) = run(folder.path(), &["delaunay", input, "--json"]);
        assert_eq!(json(&limited)["fingerprint"], json(&free)["fingerprint"]);
        std::fs::remove_file(folder.path().join("out.csv")).unwrap();
    }
    for words in [&["--time-limit=-1"][..], &["--time-limit", "9", "--algorithm", "divide-conquer"]]
    {
        let (status, out, error) =
            run(folder.path(), &[&["delaunay", "plane.csv"], words].concat());
        assert!(status == 2 && out.is_empty() && error.contains("time-limit"), "{error}");
    }
}

#[test]
fn diagrams_are_drawn_to_the_edge_of_the_picture() {
    let folder = folder();
    std::fs::write(folder.path().join("in.csv"), square(1.0)).unwrap();
    std::fs::write(folder.path().join("kite.poly"), KITE).unwrap();
    std::fs::write(folder.path().join("line.csv"), "x,y\n0,0\n1,1\n2,2\n").unwrap();
    for (words, regions) in [
        (&["draw", "in.csv", "--voronoi", "-o", "out.svg"][..], 5),
        (&["draw", "kite.poly", "--voronoi", "-o", "out.svg"], 4),
        (&["draw", "kite.poly", "-o", "out.svg"], 0),
        (&["draw", "line.csv", "--voronoi", "-o", "out.svg"], 0),
        (&["delaunay", "in.csv", "--voronoi", "--svg", "out.svg"], 5),
        (&["delaunay", "in.csv", "--voronoi", "--html", "out.svg"], 5),
    ] {
        let (status, _, error) = run(folder.path(), words);
        assert_eq!(status, 0, "{words:?}: {error}");
        let text = std::fs::read_to_string(folder.path().join("out.svg")).unwrap();
        let svg = &text[text.find("<svg").unwrap()..=text.find("</svg>").unwrap() + 5];
        let document = roxmltree::Document::parse(svg).unwrap();
        let region = document.descendants().find(|node| node.attribute("class") == Some("region"));
        let d = region.and_then(|node| node.attribute("d")).unwrap_or("");
        assert_eq!(d.matches('Z').count(), regions, "{words:?}");
    }
    std::fs::write(folder.path().join("space.csv"), "x,y,z\n0,0,0\n1,0,0\n").unwrap();
    assert_eq!(run(folder.path(), &["draw", "space.csv", "--voronoi"]).0, 2);
}
