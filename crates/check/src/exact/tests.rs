use super::ball::Balls;
use super::determinant::determinant;
use super::lattice::{Span, decode};
use super::word::fits;
use super::*;
use crate::testing::Random;

/// The determinant of differences `matrix[i] - base[i]`, over any numbers.
fn value<A: Arithmetic>(arithmetic: &A, n: usize, entries: &[[f64; 2]]) -> A::Number {
    let rows: Vec<A::Number> = entries.iter().map(|[a, b]| arithmetic.difference(*a, *b)).collect();
    determinant(n, &rows)
}

/// The sign by every arithmetic there is; the filter may abstain, and says whether it did.
fn signs_agree(n: usize, entries: &[[f64; 2]]) -> (Sign, bool) {
    let span = Span::of(entries.iter().flatten().copied()).unwrap_or(Span { low: 0, high: 0 });
    let pure = value(&Lattice::<Pure>::new(span.low), n, entries).exact_sign();
    #[cfg(feature = "rug")]
    {
        let gmp = value(&Lattice::<Gmp>::new(span.low), n, entries).exact_sign();
        assert_eq!(pure, gmp, "backends differ on {entries:?}");
    }
    let ball = value(&Balls, n, entries).sign();
    if let Some(sign) = ball {
        assert_eq!(sign, pure, "the filter is wrong on {entries:?}");
    }
    if fits(span.bits(), n, n) {
        let word = value(&Lattice::<i128>::new(span.low), n, entries).exact_sign();
        assert_eq!(word, pure, "128 bits are wrong on {entries:?}");
    }
    (pure, ball.is_some())
}

#[test]
fn decoding_is_exact() {
    assert_eq!(decode(0.0), (0, 0));
    assert_eq!(decode(-0.0), (0, 0));
    assert_eq!(decode(5e-324), (1, -1074));
    assert_eq!(decode(-6.0), (-3, 1));
    assert_eq!(decode(f64::MAX), ((1 << 53) - 1, 971));
    assert_eq!(decode(f64::MIN_POSITIVE), (1, -1022));
    let mut random = Random(1);
    for _ in 0..20_000 {
        let x = random.double();
        let (mantissa, exponent) = decode(x);
        assert_eq!(mantissa & 1, 1);
        let size = u32::try_from(mantissa.unsigned_abs() >> 32).unwrap();
        let low = u32::try_from(mantissa.unsigned_abs() & 0xffff_ffff).unwrap();
        let m = f64::from(size) * 4_294_967_296.0 + f64::from(low);
        // In two steps, as 2^-1074 times 2^53 must not overflow or underflow on the way.
        let half = exponent / 2;
        let back = m * 2f64.powi(half) * 2f64.powi(exponent - half);
        assert_eq!(back, x.abs());
        assert_eq!(mantissa < 0, x < 0.0);
    }
}

#[test]
fn signs_agree_over_the_whole_range_of_doubles() {
    let mut random = Random(2);
    for round in 0..3000 {
        let n = 1 + round % 4;
        let entries: Vec<[f64; 2]> =
            (0..n * n).map(|_| [random.double(), random.double()]).collect();
        signs_agree(n, &entries);
    }
}

#[test]
fn signs_agree_on_the_worst_numbers() {
    let worst = [
        0.0,
        5e-324,
        -5e-324,
        f64::MIN_POSITIVE,
        -f64::MIN_POSITIVE,
        1.0,
        1.0 + f64::EPSILON,
        -1.0,
        1e-160,
        -1e154,
        1.3e154,
        1.7e308,
        f64::MAX,
        -f64::MAX,
    ];
    let mut random = Random(3);
    let mut zeros = 0;
    for round in 0..20_000 {
        let n = 1 + round % 4;
        let pick = |random: &mut Random| worst[random.below(14) as usize];
        let entries: Vec<[f64; 2]> =
            (0..n * n).map(|_| [pick(&mut random), pick(&mut random)]).collect();
        zeros += usize::from(signs_agree(n, &entries).0 == Sign::Zero);
    }
    assert!(zeros > 100, "the degenerate case was reached: {zeros}");
}

#[test]
fn signs_agree_one_ulp_from_singular() {
    let mut random = Random(4);
    let (mut zeros, mut unsure) = (0, 0);
    for round in 0..4000 {
        let scale = 2f64.powi(i32::try_from(random.below(1400)).unwrap() - 700);
        let mut rows: Vec<[f64; 2]> =
            (0..9).map(|_| [f64::from(random.below(1 << 20)) * scale, 0.0]).collect();
        for j in 0..3 {
            rows[6 + j][0] = rows[j][0] * 3.0 - rows[3 + j][0] * 2.0; // exact
        }
        let nudged = rows[8][0];
        rows[8][0] = match round % 3 {
            0 => nudged,
            1 => nudged.next_up(),
            _ => nudged.next_down(),
        };
        let (sign, known) = signs_agree(3, &rows);
        zeros += usize::from(sign == Sign::Zero);
        unsure += usize::from(!known);
    }
    assert!(zeros >= 1300 && unsure >= 3000, "{zeros} zeros, {unsure} unsure");
}

#[test]
fn the_filter_decides_ordinary_cases() {
    let mut random = Random(5);
    let known = (0..1000)
        .filter(|_| {
            let entries: Vec<[f64; 2]> = (0..9).map(|_| [random.unit(), random.unit()]).collect();
            signs_agree(3, &entries).1
        })
        .count();
    assert!(known > 990, "{known} of 1000");
}

/// Corners of the cube of coordinates, where the numbers are largest, with the bits that just fit.
#[test]
fn word_is_exact_at_its_limit() {
    for (k, ambient) in [(1, 1), (2, 2), (3, 3), (2, 3), (1, 3)] {
        let bits = (1..127).rev().find(|&b| fits(b, k, ambient)).unwrap();
        assert!(!fits(bits + 1, k, ambient));
        let limit = (1i64 << bits.min(52)) - 1;
        let mut random = Random(6);
        let n = k + 1;
        for _ in 0..500 {
            let coordinates: Vec<i64> = (0..n * ambient)
                .map(|_| if random.bits().is_multiple_of(2) { limit } else { -limit })
                .collect();
            // Rows of differences to the opposite corner, and their squares: as in the lifted
            // determinant.
            let numbers = |square: bool, x: i64| {
                if square { 4 * i128::from(x).pow(2) } else { 2 * i128::from(x) }
            };
            let mut word = Vec::new();
            for row in coordinates.chunks(ambient) {
                word.extend(row[..k].iter().map(|&x| numbers(false, x)));
                word.push(row.iter().map(|&x| numbers(true, x)).sum());
            }
            let pure: Vec<Pure> = word.iter().map(|&x| Pure::from(x)).collect();
            assert_eq!(Pure::from(determinant(n, &word)), determinant(n, &pure));
        }
    }
}

#[test]
fn orders_of_determinants_agree() {
    let mut random = Random(7);
    for n in 1..6 {
        let m: Vec<i128> = (0..n * n).map(|_| i128::from(random.below(2000)) - 1000).collect();
        // Bordered by a unit row and column, the determinant is the same.
        let mut bordered = Vec::new();
        for row in m.chunks(n) {
            bordered.extend(row);
            bordered.push(0);
        }
        bordered.extend(vec![0; n]);
        bordered.push(1);
        assert_eq!(determinant(n, &m), determinant(n + 1, &bordered), "order {n}");
    }
}
