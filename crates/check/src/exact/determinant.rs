//! Determinants without division, over any numbers.
//!
//! Laplace expansion, with the 2x2 minors shared up to order 4 (28 products), by cofactors beyond.
//! Every partial sum is bounded by the permanent of the absolute values, which `word` relies on.

use super::Number;

/// The determinant of the `n`x`n` matrix `m`, row by row. Order 0 does not occur: there is no
/// number to return.
pub(crate) fn determinant<N: Number>(n: usize, m: &[N]) -> N {
    match n {
        0 | 1 => m[0].clone(),
        2 => minor(m, 2, [0, 1], [0, 1]),
        3 => order_three(m),
        4 => order_four(m),
        _ => by_cofactors(n, m),
    }
}

fn minor<N: Number>(m: &[N], n: usize, [r, s]: [usize; 2], [a, b]: [usize; 2]) -> N {
    m[r * n + a].times(&m[s * n + b]).minus(&m[r * n + b].times(&m[s * n + a]))
}

fn order_three<N: Number>(m: &[N]) -> N {
    let rows = [1, 2];
    let a = m[0].times(&minor(m, 3, rows, [1, 2]));
    let b = m[1].times(&minor(m, 3, rows, [0, 2]));
    let c = m[2].times(&minor(m, 3, rows, [0, 1]));
    a.minus(&b).plus(&c)
}

/// Six pairs of complementary minors: the upper two rows times the lower two.
fn order_four<N: Number>(m: &[N]) -> N {
    let pair = |a: usize, b: usize, c: usize, d: usize| {
        minor(m, 4, [0, 1], [a, b]).times(&minor(m, 4, [2, 3], [c, d]))
    };
    pair(0, 1, 2, 3)
        .minus(&pair(0, 2, 1, 3))
        .plus(&pair(0, 3, 1, 2))
        .plus(&pair(1, 2, 0, 3))
        .minus(&pair(1, 3, 0, 2))
        .plus(&pair(2, 3, 0, 1))
}

fn by_cofactors<N: Number>(n: usize, m: &[N]) -> N {
    let cofactor = |column: usize| {
        let rest: Vec<N> = m[n..]
            .iter()
            .enumerate()
            .filter(|(i, _)| i % n != column)
            .map(|(_, x)| x.clone())
            .collect();
        m[column].times(&determinant(n - 1, &rest))
    };
    (1..n).fold(cofactor(0), |sum, j| {
        if j % 2 == 0 { sum.plus(&cofactor(j)) } else { sum.minus(&cofactor(j)) }
    })
}
