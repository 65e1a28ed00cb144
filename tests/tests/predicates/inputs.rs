//! Points on which predicates are hard, by class.

use delone::workloads::Rng;
use delone_tests::exact::{nudged, power_of_two};

/// How the points of one call are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Class {
    /// Uniform: the filter decides.
    Random,
    /// Points of a line, plane or sphere of doubles, off by ULPs.
    Ulps,
    /// Small integers: many exact zeros.
    Grid,
    /// The last point completes the others exactly to a degenerate set.
    Completed,
    /// Exponents within 40 of each other.
    Wide,
    /// Exponents to 1000 either way, denormals, zeros of both signs, copies, the largest doubles.
    Wild,
}

pub(crate) const CLASSES: [Class; 6] =
    [Class::Random, Class::Ulps, Class::Grid, Class::Completed, Class::Wide, Class::Wild];

/// `n` points.
pub(crate) fn points<const D: usize>(class: Class, n: usize, rng: &mut Rng) -> Vec<[f64; D]> {
    match class {
        Class::Random => many(n, rng, |rng| rng.between(-1.0, 1.0)),
        Class::Ulps => ulps(n, rng),
        Class::Grid => many(n, rng, |rng| small(rng, 3)),
        Class::Completed => completed(n, rng),
        Class::Wide => many(n, rng, |rng| real(rng, -20, 20)),
        Class::Wild => wild(n, rng),
    }
}

fn many<const D: usize>(
    n: usize,
    rng: &mut Rng,
    mut x: impl FnMut(&mut Rng) -> f64,
) -> Vec<[f64; D]> {
    (0..n).map(|_| std::array::from_fn(|_| x(rng))).collect()
}

fn int(rng: &mut Rng, max: i64) -> i32 {
    i32::try_from(rng.integer(-max, max)).expect("small")
}

fn small(rng: &mut Rng, max: i64) -> f64 {
    f64::from(int(rng, max))
}

/// A random mantissa of random length at a random exponent.
fn real(rng: &mut Rng, low: i64, high: i64) -> f64 {
    let k = i32::try_from(rng.integer(low, high)).expect("small");
    let bits = i32::try_from(rng.integer(1, 53)).expect("small");
    let x = (rng.between(-1.0, 1.0) * power_of_two(bits)).round() * power_of_two(-bits);
    x * power_of_two(k)
}

/// On a common circle or sphere about a random centre, or on a line through it, rounded, then nudged.
fn ulps<const D: usize>(n: usize, rng: &mut Rng) -> Vec<[f64; D]> {
    let centre: [f64; D] = std::array::from_fn(|_| rng.between(-2.0, 2.0));
    let direction: [f64; D] = std::array::from_fn(|_| rng.between(-1.0, 1.0));
    let round = rng.coin();
    (0..n)
        .map(|_| {
            let t = rng.between(-9.0, 9.0);
            let ray: [f64; D] = std::array::from_fn(|_| rng.gauss());
            let length = ray.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-9);
            std::array::from_fn(|axis| {
                let off = if round { ray[axis] / length } else { t * direction[axis] };
                nudged(centre[axis] + off, int(rng, 2))
            })
        })
        .collect()
}

/// Integers, the last point an integer combination of the others or a reflection that keeps it on their sphere.
fn completed<const D: usize>(n: usize, rng: &mut Rng) -> Vec<[f64; D]> {
    let scale = power_of_two(int(rng, 300));
    let centre: [f64; D] = std::array::from_fn(|_| small(rng, 1 << 20));
    let mut points: Vec<[f64; D]> = many(n, rng, |rng| small(rng, 1 << 20));
    if rng.coin() {
        // All points are sign changes and permutations of one offset: exactly cospherical about the centre.
        let offset: [f64; D] = std::array::from_fn(|_| small(rng, 1 << 20));
        for p in &mut points {
            let mut image = offset;
            rng.shuffle(&mut image);
            *p = std::array::from_fn(|x| centre[x] + if rng.coin() { image[x] } else { -image[x] });
        }
    } else {
        // The last is on the line of the first two, or in the plane of the first three.
        let (s, t) = (small(rng, 9), if n > 3 { small(rng, 9) } else { 0.0 });
        let [a, b, c] = [points[0], points[1], points[2 % n]];
        let last = points.last_mut().expect("there are points");
        *last = std::array::from_fn(|x| a[x] + s * (b[x] - a[x]) + t * (c[x] - a[x]));
    }
    points.into_iter().map(|p| p.map(|x| x * scale)).collect()
}

fn wild<const D: usize>(n: usize, rng: &mut Rng) -> Vec<[f64; D]> {
    let mut seen: Vec<f64> = Vec::new();
    let mut coordinate = |rng: &mut Rng| {
        let copied = rng.index(seen.len().max(1));
        let x = match rng.below(12) {
            0 => 0.0,
            1 => -0.0,
            2 => 5e-324 * small(rng, 4),
            3 => nudged(f64::MAX, int(rng, 3)) * if rng.coin() { 1.0 } else { -1.0 },
            4..=6 if !seen.is_empty() => seen[copied],
            7 if !seen.is_empty() => nudged(seen[copied], int(rng, 1)),
            8 => f64::from_bits(rng.next_u64() & 0x800f_ffff_ffff_ffff), // a denormal
            _ => real(rng, -1000, 1000),
        };
        seen.push(x);
        x
    };
    (0..n).map(|_| std::array::from_fn(|_| coordinate(rng))).collect()
}
