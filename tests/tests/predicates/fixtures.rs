//! The fixtures of `robust-predicates` (JavaScript), where the collected files are: their signs, re-verified by those who
//! collected them, up to the one factor by which that package's convention differs from ours.

use delone::predicates::{Sign, in_circle, in_sphere, orient2d, orient3d};
use delone_tests::data::files;
use delone_tests::say;

/// The points and the sign of each line: number, coordinates, sign.
fn cases<const D: usize>(text: &str) -> impl Iterator<Item = (Vec<[f64; D]>, Sign)> {
    text.lines().filter(|line| !line.trim().is_empty()).map(|line| {
        let numbers: Vec<f64> =
            line.split_whitespace().map(|word| word.parse().expect("a number")).collect();
        let (sign, rest) = numbers.split_last().expect("a line has a sign");
        (rest[1..].as_chunks::<D>().0.to_vec(), Sign::of(*sign))
    })
}

fn check<const D: usize>(text: &str, ours: impl Fn(&[[f64; D]]) -> Sign) -> usize {
    let all: Vec<(Vec<[f64; D]>, Sign)> = cases(text).collect();
    let factors = all.iter().map(|(points, sign)| (ours(points), *sign));
    let mut factor = None;
    for (number, (ours, theirs)) in factors.enumerate() {
        assert_eq!(ours == Sign::Zero, theirs == Sign::Zero, "case {number}");
        if ours != Sign::Zero {
            let this = ours * theirs;
            assert_eq!(*factor.get_or_insert(this), this, "case {number}");
        }
    }
    all.len()
}

#[test]
fn fixtures_have_their_signs() {
    for path in files("predicates") {
        let text = std::fs::read_to_string(&path).expect("a fixture can be read");
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned());
        let name = name.unwrap_or_default();
        let count = match name.split('.').next() {
            Some("orient2d") => check(&text, |p| orient2d(p[0], p[1], p[2])),
            Some("orient3d") => check(&text, |p| orient3d(p[0], p[1], p[2], p[3])),
            Some("incircle") => check(&text, |p| in_circle(p[0], p[1], p[2], p[3])),
            Some("insphere") => check(&text, |p| in_sphere(p[0], p[1], p[2], p[3], p[4])),
            _ => continue,
        };
        say(format!("{name}: {count}"));
    }
}
