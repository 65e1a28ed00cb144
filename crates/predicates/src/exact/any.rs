//! Determinants in more than three axes: all minors of the first columns, by subsets of rows.
//!
//! The minor of the first j columns and a set S of j rows is the sum over i in S of `+- entry(i, j) * minor(S - i)`: 2^n
//! minors and n 2^(n-1) products in all, where cofactors without sharing would take n!.
//!
//! **Head-room.** With differences of at most 2^b, a minor of j columns is at most j! 2^(jb), and a height at most
//! 7 * 2^(2b) + 2^(2b+2) < 2^(2b+4). So an orientation in k axes takes k b + bits(k!) + 1 bits with its sign, a lifted
//! determinant (k+2) b + bits((k+1)!) + 5.

use crate::Sign;
use crate::int::Int;

/// Bits of `n!`, rounded up.
const FACTORIAL_BITS: [usize; 9] = [0, 0, 1, 3, 5, 7, 10, 13, 16];

/// Bits of the determinant of k columns of differences of b bits, and of a column of heights if there is one.
fn bits_of(k: usize, lifted: bool, b: usize) -> usize {
    if lifted { (k + 2) * b + FACTORIAL_BITS[k + 1] + 5 } else { k * b + FACTORIAL_BITS[k] + 1 }
}

/// The sign of the determinant of k columns, and of `heights` as the last column if there are any; b <= 62.
pub(crate) fn determinant<const D: usize, const R: usize>(
    rows: &[[Int<1>; D]; R],
    heights: &[Int<2>],
    k: usize,
) -> Sign {
    let n = if heights.is_empty() { k } else { k + 1 };
    let entry = |row: usize, column: usize| rows[row][column].low();
    let bits = bits_of(k, n > k, 62);
    match () {
        () if n <= 4 && bits <= 256 => minors::<4, 16>(n, k, &entry, heights),
        () if n <= 5 && bits <= 384 => minors::<6, 32>(n, k, &entry, heights),
        () if n <= 6 && bits <= 512 => minors::<8, 64>(n, k, &entry, heights),
        () => minors::<10, 256>(n, k, &entry, heights), // 9 * 62 + 16 + 5 = 579 bits
    }
}

/// As [`determinant`], b <= 254.
pub(crate) fn wide_determinant<const D: usize, const R: usize>(
    rows: &[[Int<4>; D]; R],
    heights: &[Int<8>],
    k: usize,
) -> Sign {
    const N: usize = 37; // 9 * 254 + 16 + 5 = 2307 bits
    let n = if heights.is_empty() { k } else { k + 1 };
    let mut minors = [Int::<N>::ZERO; 256];
    minors[0] = Int::ONE;
    let product = |row: usize, column: usize, minor: &Int<N>| {
        if column < k {
            minor.wrapping_times(&rows[row][column].extended())
        } else {
            minor.wrapping_times(&heights[row].extended())
        }
    };
    all_minors(n, &mut minors, product).sign()
}

fn minors<const N: usize, const M: usize>(
    n: usize,
    k: usize,
    entry: &impl Fn(usize, usize) -> i64,
    heights: &[Int<2>],
) -> Sign {
    let mut minors = [Int::<N>::ZERO; M];
    minors[0] = Int::ONE;
    let product = |row: usize, column: usize, minor: &Int<N>| {
        if column < k {
            minor.scaled(entry(row, column))
        } else {
            minor.wrapping_times(&heights[row].extended())
        }
    };
    all_minors(n, &mut minors, product).sign()
}

/// Fills in the minors by subsets, given the empty one; the last is the determinant of n rows and n columns.
///
/// Subsets are bit sets, and each comes after those it contains.
#[inline(always)]
fn all_minors<const N: usize>(
    n: usize,
    minors: &mut [Int<N>],
    product: impl Fn(usize, usize, &Int<N>) -> Int<N>,
) -> Int<N> {
    let all = (1usize << n) - 1;
    for set in 1..=all {
        let column = set.count_ones() as usize - 1;
        let mut sum = Int::ZERO;
        let mut rest = set;
        // The row at place i of the set, the last column at place `column`: the cofactor's sign is (-1)^(i + column).
        let mut negative = column % 2 == 1;
        while rest != 0 {
            let row = rest.trailing_zeros() as usize;
            rest &= rest - 1;
            let term = product(row, column, &minors[set ^ 1 << row]);
            sum = if negative { sum - term } else { sum + term };
            negative = !negative;
        }
        minors[set] = sum;
    }
    minors[all]
}
