//! What the tests of this crate share: a generator of their own, inputs, and triangulations to
//! spoil.

use crate::{Complex, naive};

/// SplitMix64 (Steele, Lea, Flood 2014).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `n`.
    pub(crate) fn below(&mut self, n: u32) -> u32 {
        u32::try_from(self.bits() % u64::from(n)).unwrap()
    }

    /// A multiple of `2^-32` in `[0, 1)`.
    pub(crate) fn unit(&mut self) -> f64 {
        f64::from(self.below(u32::MAX)) / 4_294_967_296.0
    }

    /// Any finite double, all exponents alike.
    pub(crate) fn double(&mut self) -> f64 {
        loop {
            let x = f64::from_bits(self.bits());
            if x.is_finite() {
                return x;
            }
        }
    }

    /// `n` points on the grid `{0..side-1}^D`, perhaps with repetition.
    pub(crate) fn grid<const D: usize>(&mut self, n: usize, side: u32) -> Vec<[f64; D]> {
        (0..n).map(|_| std::array::from_fn(|_| f64::from(self.below(side)))).collect()
    }
}

/// Owned data for a [`Complex`].
#[derive(Clone)]
pub(crate) struct Owned<const D: usize> {
    pub(crate) points: Vec<[f64; D]>,
    pub(crate) dimension: Option<usize>,
    pub(crate) cells: Vec<u32>,
}

impl<const D: usize> Owned<D> {
    pub(crate) fn new(points: &[[f64; D]], dimension: usize, cells: &[u32]) -> Self {
        Self { points: points.to_vec(), dimension: Some(dimension), cells: cells.to_vec() }
    }

    /// From ascending cells of small-integer points; turned positive if they are full-dimensional.
    pub(crate) fn of_cells(points: &[[f64; D]], cells: &[Vec<u32>]) -> Self {
        let dimension = cells.first().map(|c| c.len() - 1);
        let mut flat = Vec::new();
        for cell in cells {
            let mut cell = cell.clone();
            let negative = match dimension {
                Some(1) => points[cell[0] as usize] > points[cell[1] as usize],
                Some(k) if k == D => volume(points, &cell) < 0.0,
                _ => false,
            };
            if negative {
                cell.swap(0, 1);
            }
            flat.extend(cell);
        }
        Self { points: points.to_vec(), dimension, cells: flat }
    }

    pub(crate) fn delaunay(points: &[[f64; D]]) -> Self {
        Self::of_cells(points, &naive::delaunay(points))
    }

    pub(crate) fn complex(&self) -> Complex<'_, D> {
        Complex { points: &self.points, dimension: self.dimension, cells: &self.cells }
    }
}

/// Six times, or twice, the volume of a simplex in space or the plane; exact for small integers.
pub(crate) fn volume<const D: usize>(points: &[[f64; D]], cell: &[u32]) -> f64 {
    let d = |i: usize, x: usize| points[cell[i] as usize][x] - points[cell[0] as usize][x];
    match D {
        1 => d(1, 0),
        2 => d(1, 0) * d(2, 1) - d(1, 1) * d(2, 0),
        _ => (0..3)
            .map(|x| {
                let (y, z) = ((x + 1) % 3, (x + 2) % 3);
                d(1, x) * (d(2, y) * d(3, z) - d(2, z) * d(3, y))
            })
            .sum(),
    }
}

/// The grid of `side * side` squares, all split along the diagonal that the perturbation selects.
pub(crate) fn square_grid(side: u32) -> Owned<2> {
    let points: Vec<[f64; 2]> =
        (0..=side).flat_map(|j| (0..=side).map(move |i| [f64::from(i), f64::from(j)])).collect();
    Owned { points, dimension: Some(2), cells: grid_cells(side) }
}

/// A skewed grid of nearly equilateral triangles, interior points moved a little: Delaunay without
/// ties.
pub(crate) fn jittered(side: u32, seed: u64) -> Owned<2> {
    let mut random = Random(seed);
    let mut points = Vec::new();
    for j in 0..=side {
        for i in 0..=side {
            let inner = i > 0 && i < side && j > 0 && j < side;
            let mut move_by = || if inner { (random.unit() - 0.5) / 16.0 } else { 0.0 };
            let (x, y) = (f64::from(i) + f64::from(j) / 2.0, f64::from(j) * 0.875);
            points.push([x + move_by(), y + move_by()]);
        }
    }
    Owned { points, dimension: Some(2), cells: grid_cells(side) }
}

fn grid_cells(side: u32) -> Vec<u32> {
    let at = |i, j| j * (side + 1) + i;
    let mut cells = Vec::new();
    for j in 0..side {
        for i in 0..side {
            cells.extend([at(i, j), at(i + 1, j), at(i, j + 1)]);
            cells.extend([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    cells
}

/// `side^3` cubes of six tetrahedra each, along the main diagonal (Kuhn): weakly Delaunay.
pub(crate) fn kuhn_grid(side: u32) -> Owned<3> {
    let n = side + 1;
    let points = (0..n * n * n)
        .map(|i| [f64::from(i % n), f64::from(i / n % n), f64::from(i / n / n)])
        .collect();
    let step = [1, n, n * n];
    let mut cells = Vec::new();
    for corner in (0..n * n * n).filter(|i| [i % n, i / n % n, i / n / n].iter().all(|&x| x < side))
    {
        for [x, y, z] in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]] {
            let path = [corner, corner + step[x], corner + step[x] + step[y]];
            let end = path[2] + step[z];
            let odd = (x + 1) % 3 != y;
            cells.extend([path[usize::from(odd)], path[usize::from(!odd)], path[2], end]);
        }
    }
    Owned { points, dimension: Some(3), cells }
}
