//! Spheres: rational and rounded, and exactly cospherical integers.

use super::Space;
use crate::Rng;
use crate::num::{int, signed};

/// Rational points of the unit sphere, rounded: (2u, 2v, 1 - u^2 - v^2) / (1 + u^2 + v^2), mirrored half the time.
pub(crate) fn sphere(n: usize, rng: &mut Rng) -> Space {
    (0..n)
        .map(|_| {
            let [u, v, w] = loop {
                let [u, v] = [rng.between(-1.0, 1.0), rng.between(-1.0, 1.0)];
                if u * u + v * v <= 1.0 {
                    break [u, v, u * u + v * v];
                }
            };
            let z = (1.0 - w) / (1.0 + w);
            [2.0 * u / (1.0 + w), 2.0 * v / (1.0 + w), if rng.coin() { z } else { -z }]
        })
        .collect()
}

/// Exactly cospherical integers of radius p, the smallest odd prime that gives `n` of them.
///
/// A quaternion q = a + bi + cj + dk of norm p sends i to q i q', an integer point at distance p (Euler, Rodrigues).
/// By Jacobi there are 8(p + 1) such q, and four of them, q times a unit 1, i, -1, -i, give the same point: 2(p + 1) in all.
/// The one with (a, b) in a half-open quarter plane stands for the four; if a = b = 0, the one with (c, d) in it.
pub(crate) fn cospherical(n: usize, rng: &mut Rng) -> Space {
    let p = prime_from(int(n) / 2);
    let by_norm = pairs_by_norm(p);
    let mut points: Space = Vec::with_capacity(n);
    for (norm, &(start, end)) in by_norm.ranges.iter().enumerate() {
        let rest = by_norm.ranges[by_norm.ranges.len() - 1 - norm];
        for &[a, b] in &by_norm.pairs[start..end] {
            for &[c, d] in &by_norm.pairs[rest.0..rest.1] {
                if in_quarter(a, b) || (a == 0 && b == 0 && in_quarter(c, d)) {
                    points.push(image_of_i([a, b, c, d]).map(signed));
                }
            }
        }
    }
    rng.shuffle(&mut points);
    points.truncate(n);
    points
}

fn in_quarter(a: i64, b: i64) -> bool {
    a > 0 && b >= 0
}

fn image_of_i([a, b, c, d]: [i64; 4]) -> [i64; 3] {
    [a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)]
}

/// The smallest odd prime that is at least `from`.
fn prime_from(from: i64) -> i64 {
    let is_prime = |m: i64| (3..).step_by(2).take_while(|d| d * d <= m).all(|d| m % d != 0);
    let mut m = from.max(3) | 1;
    while !is_prime(m) {
        m += 2; // Bertrand: a prime comes before 2m
    }
    m
}

/// All integer pairs with a^2 + b^2 <= p, grouped by norm (a counting sort).
struct Pairs {
    pairs: Vec<[i64; 2]>,
    ranges: Vec<(usize, usize)>,
}

fn pairs_by_norm(p: i64) -> Pairs {
    let all = || {
        let r = p.isqrt();
        (-r..=r).flat_map(move |a| {
            let h = (p - a * a).isqrt();
            (-h..=h).map(move |b| [a, b])
        })
    };
    let norm = |[a, b]: [i64; 2]| usize::try_from(a * a + b * b).expect("a sum of squares");
    let mut ranges = vec![(0, 0); usize::try_from(p).expect("a prime") + 1];
    all().for_each(|pair| ranges[norm(pair)].1 += 1);
    let mut start = 0;
    for range in &mut ranges {
        let size = range.1;
        *range = (start, start);
        start += size;
    }
    let mut pairs = vec![[0, 0]; start];
    for pair in all() {
        let end = &mut ranges[norm(pair)].1;
        pairs[*end] = pair;
        *end += 1;
    }
    Pairs { pairs, ranges }
}
