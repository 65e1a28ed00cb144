use super::{Kind, Meets, all, find, generate};
use crate::Points;

#[test]
fn names_are_unique_and_kebab_case() {
    let mut names: Vec<&str> = all().iter().map(|w| w.name).collect();
    let good = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    assert!(names.iter().all(|name| name.chars().all(good)));
    names.sort_unstable();
    assert!(names.is_sorted_by(|a, b| a < b), "{names:?}");
}

#[test]
fn an_unknown_name_is_refused_with_the_nearest() {
    let error = generate("unifrom", 3, 0).unwrap_err();
    assert_eq!(error.to_string(), "no workload is called `unifrom`; did you mean `uniform`?");
    assert!(find("").is_err());
}

/// Every n up to 40, and a thousand: finite coordinates, indices in range, no zero-length segment, and n as announced.
#[test]
fn every_workload_takes_every_n() {
    for workload in all() {
        for n in (0..40).chain([1000]) {
            let input = workload.generate(n, 5);
            let sites = input.points.len();
            let name = workload.name;
            let finite = match &input.points {
                Points::Plane(points) => points.iter().flatten().all(|x| x.is_finite()),
                Points::Space(points) => points.iter().flatten().all(|x| x.is_finite()),
            };
            assert!(finite, "{name} {n}");
            let good = |s: &[u32; 2]| s[0] != s[1] && s.iter().all(|&v| (v as usize) < sites);
            assert!(input.segments.iter().all(good), "{name} {n}");
            if workload.rounds.starts_with("n rounded") || workload.rounds.starts_with("2k") {
                assert!(sites <= n && (n < 4 || sites * 10 >= n * 3), "{name} {n} gives {sites}");
            } else {
                assert_eq!(sites, n, "{name}");
            }
            assert_eq!(workload.kind() == Kind::Points3d, input.points.space().is_some());
            assert!(workload.kind() == Kind::Pslg || input.segments.is_empty());
        }
    }
}

#[test]
fn seeds_matter_or_are_ignored_but_repeat() {
    for workload in all() {
        let print = |seed| workload.generate(50, seed).fingerprint();
        assert_eq!(print(1), print(1), "{}", workload.name);
    }
    assert_ne!(generate("uniform", 9, 1), generate("uniform", 9, 2));
}

#[test]
fn shuffling_keeps_the_segments() {
    let mut input = generate("ladder", 10, 0).unwrap();
    let ends = |input: &crate::Input| {
        let points = input.points.plane().unwrap();
        let place = |v: u32| points[v as usize].map(f64::to_bits);
        let mut ends: Vec<_> = input.segments.iter().map(|s| s.map(place)).collect();
        ends.sort_unstable();
        ends
    };
    let before = (input.clone(), ends(&input));
    input.shuffle(4);
    assert_ne!(input, before.0);
    assert_eq!(ends(&input), before.1);
}

#[test]
fn crossing_families_say_so() {
    let crossing: Vec<&str> = all().iter().filter(|w| w.crosses()).map(|w| w.name).collect();
    assert!(crossing.iter().all(|name| name.starts_with("crossing-")) && crossing.len() == 4);
    assert!(Meets::AtEnds < Meets::Along);
}
