//! Points on which predicates go wrong: the generators of the soak, and one round of it.

use delone_predicates::{Adaptive, Exact, Kernel, PlaneKernel, Sign, Weighted};

use crate::oracle;
use crate::random::{Random, power_of_two};

mod constructed;
mod metric;

pub use constructed::round_of_constructed;
pub use metric::round_of_metric;

/// Kinds of points.
const KINDS: u64 = 10;

/// A kind's points for one call: `N` of them.
#[must_use]
pub fn points<const D: usize, const N: usize>(random: &mut Random) -> [[f64; D]; N] {
    let (kind, turns) = (random.bits() % KINDS, random.bits());
    let mut points = match kind {
        0 => each(|_, _| random.unit()),
        1 => each(|_, _| random.whole(-8, 9)),
        2 => each(|_, _| random.whole(-1000, 1001)),
        3 => at_one_distance(|| random.unit(), turns),
        4 => at_one_distance(|| random.scaled(-20, 20), turns),
        5 => in_a_flat(random, 20),
        6 => each(|_, _| random.scaled(-1000, 1000)),
        7 => each(|_, _| finite(random.bits())),
        8 => few_bits(random),
        _ => in_a_flat(random, 0),
    };
    if random.once_in(3) {
        nudge(&mut points, random);
    }
    if random.once_in(4) {
        rescale(&mut points, random);
    }
    if random.once_in(8) {
        copies(&mut points, random);
    }
    points
}

fn each<const D: usize, const N: usize>(
    mut coordinate: impl FnMut(usize, usize) -> f64,
) -> [[f64; D]; N] {
    std::array::from_fn(|i| std::array::from_fn(|axis| coordinate(i, axis)))
}

/// Any bits as a finite double: one bit of an exponent of ones is cleared.
fn finite(bits: u64) -> f64 {
    let value = f64::from_bits(bits);
    if value.is_finite() { value } else { f64::from_bits(bits & !(1 << 62)) }
}

/// One vector with its coordinates permuted and their signs changed: all at one distance from the origin, in a cube.
fn at_one_distance<const D: usize, const N: usize>(
    mut coordinate: impl FnMut() -> f64,
    mut turns: u64,
) -> [[f64; D]; N] {
    let vector: [f64; D] = std::array::from_fn(|_| coordinate());
    let mut points = [vector; N];
    for point in &mut points {
        point.rotate_left(usize::try_from(turns % 7).expect("small") % D);
        turns /= 7;
        for x in point {
            *x = if turns & 1 == 1 { -*x } else { *x };
            turns = turns.rotate_right(1);
        }
    }
    points
}

/// Points whose last coordinate is a power of two times the first, or that lie on a line of small integers.
fn in_a_flat<const D: usize, const N: usize>(random: &mut Random, exponents: i32) -> [[f64; D]; N] {
    if exponents == 0 {
        let [from, step]: [[f64; D]; 2] = each(|_, _| random.whole(-100, 101));
        let times: [f64; N] = std::array::from_fn(|_| random.whole(-100, 101));
        return each(|i, axis| from[axis] + times[i] * step[axis]);
    }
    let factor = if D == 1 { 1.0 } else { power_of_two(random.exponent(-30, 30)) };
    let mut points: [[f64; D]; N] = each(|_, _| random.scaled(-exponents, exponents));
    for point in &mut points {
        point[D - 1] = factor * point[0];
    }
    points
}

/// Sums of one or two powers of two, over widths around those of the tiers.
fn few_bits<const D: usize, const N: usize>(random: &mut Random) -> [[f64; D]; N] {
    let widths = [20, 30, 31, 40, 53, 59, 60, 61, 62, 63, 64, 65, 90, 122, 123, 124, 125, 126, 127];
    let more = [128, 180, 188, 190, 192, 250, 251, 252, 253, 254, 255, 256, 400, 900];
    let pick = usize::try_from(random.integer(0, 33)).expect("small");
    let width = *widths.iter().chain(&more).nth(pick).expect("33 widths");
    each(|_, _| {
        let mut value = 0.0;
        for _ in 0..random.integer(1, 3) {
            let exponent = if random.once_in(3) { width - 1 } else { random.exponent(0, width) };
            let exponent = if random.once_in(4) { 0 } else { exponent };
            let power = power_of_two(exponent);
            value += if random.once_in(2) { power } else { -power };
        }
        value
    })
}

/// Moves some coordinates by a few ulps.
fn nudge<const D: usize>(points: &mut [[f64; D]], random: &mut Random) {
    for x in points.iter_mut().flatten().filter(|x| x.abs() < f64::MAX / 2.0) {
        for _ in 0..random.integer(0, 3) {
            *x = if random.once_in(2) { x.next_up() } else { x.next_down() };
        }
    }
}

/// Multiplies all by a power of two, often to the ends of the range.
fn rescale<const D: usize>(points: &mut [[f64; D]], random: &mut Random) {
    let k = random.exponent(-1074, 1020);
    for x in points.iter_mut().flatten() {
        let scaled = *x * power_of_two(k / 2) * power_of_two(k - k / 2);
        *x = if scaled.is_finite() { scaled } else { *x };
    }
}

/// Copies points and coordinates, and puts zeros of both signs.
fn copies<const D: usize, const N: usize>(points: &mut [[f64; D]; N], random: &mut Random) {
    let at = Random::index;
    for _ in 0..random.integer(1, 4) {
        let (i, j, axis, other) = (at(random, N), at(random, N), at(random, D), at(random, D));
        match random.bits() % 4 {
            0 => points[i] = points[j],
            1 => points[i][axis] = points[j][other],
            2 => points[i][axis] = 0.0,
            _ => points[i][axis] = -0.0,
        }
    }
}

/// What a round found.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    /// Calls of our predicates.
    pub calls: u64,
    /// Calls that the oracle said are exactly degenerate.
    pub zeros: u64,
    /// Wrong signs.
    pub wrong: u64,
}

/// Orientations and in-sphere tests of one tuple of points by every door, against the oracle.
///
/// `N` is D + 2. Each answer is asked in two orders of the points, which must differ as the permutation does.
pub fn round<const D: usize, const N: usize>(random: &mut Random, tally: &mut Tally) {
    let points: [[f64; D]; N] = points(random);
    let ids: [usize; N] = std::array::from_fn(|i| i);
    let (simplex, q) = (&ids[..=D], D + 1);
    let mut swapped = ids;
    swapped.swap(0, D);
    let expected = [oracle::orient(&points[..=D]), oracle::in_sphere(&points)];
    tally.zeros += u64::from(expected[0] == 0) + u64::from(expected[1] == 0);
    let adaptive = Adaptive::new(points);
    let dynamic = Adaptive::dynamic(points);
    let exact = Exact::new(points);
    let all: [usize; D] = std::array::from_fn(|axis| axis);
    let answers = [
        (adaptive.orient(simplex), 0, 1),
        (dynamic.orient(simplex), 0, 1),
        (exact.orient(simplex), 0, 1),
        (exact.orient(&swapped[..=D]), 0, -1),
        (exact.orient_on(&all, simplex), 0, 1),
        (adaptive.lifted(simplex, q), 1, 1),
        (dynamic.lifted(simplex, q), 1, 1),
        (exact.lifted(simplex, q), 1, 1),
        (exact.lifted(&swapped[..=D], q), 1, -1),
        (exact.lifted_on(&all, simplex, q), 1, 1),
    ];
    for (sign, predicate, parity) in answers {
        judge(tally, sign, expected[predicate] * parity, &points);
    }
}

/// Power tests of one tuple of weighted points, against the oracle. Half of the weights are such that the query is
/// orthogonal, as nearly as doubles can say.
pub fn round_of_power<const D: usize, const N: usize>(random: &mut Random, tally: &mut Tally) {
    let points: [[f64; D]; N] = points(random);
    let [weights]: [[f64; N]; 1] = crate::adversary::points(random);
    let near = random.once_in(2);
    let square = |p: &[f64; D]| p.iter().map(|x| x * x).sum::<f64>();
    let weights: [f64; N] = std::array::from_fn(|i| {
        let square = square(&points[i]);
        if near && square.is_finite() { square } else { weights[i] }
    });
    let expected = oracle::power(&points, &weights);
    tally.zeros += u64::from(expected == 0);
    let ids: [usize; N] = std::array::from_fn(|i| i);
    let (simplex, q) = (&ids[..=D], D + 1);
    let kernel = Weighted::new(points, weights);
    judge(tally, kernel.lifted(simplex, q), expected, &points);
    let all: [usize; D] = std::array::from_fn(|axis| axis);
    judge(tally, kernel.lifted_on(&all, simplex, q), expected, &points);
    let mut swapped = ids;
    swapped.swap(0, D);
    judge(tally, kernel.lifted(&swapped[..=D], q), -expected, &points);
}

/// Cross products of four points in the plane, against the oracle.
pub fn round_of_cross(random: &mut Random, tally: &mut Tally) {
    let points: [[f64; 2]; 4] = points(random);
    let expected = oracle::cross(&points);
    tally.zeros += u64::from(expected == 0);
    judge(tally, Adaptive::new(points).cross([0usize, 1, 2, 3]), expected, &points);
    judge(tally, Adaptive::dynamic(points).cross([2usize, 3, 0, 1]), -expected, &points);
    judge(tally, Exact::new(points).cross([1usize, 0, 2, 3]), -expected, &points);
}

#[expect(clippy::print_stderr, reason = "a wrong sign must be seen at once")]
fn judge<const D: usize>(tally: &mut Tally, sign: Sign, expected: i8, points: &[[f64; D]]) {
    tally.calls += 1;
    if sign as i8 != expected {
        tally.wrong += 1;
        eprintln!("{sign:?}, not {expected}: {points:?}");
    }
}
