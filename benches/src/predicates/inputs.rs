//! The inputs of the cells.

use super::Predicate;
use crate::random::{Random, power_of_two};

/// A kind of input. See the module above.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// Uniform.
    R,
    /// Near-degenerate.
    N,
    /// Degenerate on a grid.
    G,
    /// Degenerate, wide exponents.
    W,
    /// As W, exponents in +-350.
    Z,
    /// Exponents in +-350.
    V,
    /// Exponents in +-950.
    X,
}

impl Input {
    /// All kinds.
    pub const ALL: [Self; 7] = [Self::R, Self::N, Self::G, Self::W, Self::Z, Self::V, Self::X];

    /// Its name in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::R => "R",
            Self::N => "N",
            Self::G => "G",
            Self::W => "W",
            Self::Z => "Z",
            Self::V => "V",
            Self::X => "X",
        }
    }

    /// A full mantissa of an input that is degenerate by construction.
    fn wide(self, random: &mut Random) -> f64 {
        let range = if self == Self::Z { 350 } else { 20 };
        random.scaled(-range, range)
    }
}

/// `count` calls' points one after the other, padded to three coordinates.
#[must_use]
pub fn tuples(predicate: Predicate, input: Input, count: usize) -> Vec<[f64; 3]> {
    let mut random = Random::new(0x64_65_6c_6f_6e_65);
    let mut points = Vec::new();
    for _ in 0..count {
        let random = &mut random;
        match (input, predicate) {
            (Input::R, _) => points.extend(each(predicate, || point(|| random.unit()))),
            (Input::V, _) => points.extend(each(predicate, || point(|| random.scaled(-350, 350)))),
            (Input::X, _) => points.extend(each(predicate, || point(|| random.scaled(-950, 950)))),
            (_, Predicate::Orient2d) => points.extend(line(input, random)),
            (_, Predicate::InCircle) => points.extend(circle(input, random)),
            (_, Predicate::Orient3d) => points.extend(plane(input, random)),
            (_, Predicate::InSphere) => points.extend(sphere(input, random)),
        }
    }
    points
}

fn each(predicate: Predicate, mut point: impl FnMut() -> [f64; 3]) -> Vec<[f64; 3]> {
    let count = match predicate {
        Predicate::Orient2d => 3,
        Predicate::InCircle | Predicate::Orient3d => 4,
        Predicate::InSphere => 5,
    };
    (0..count).map(|_| point()).collect()
}

fn point(mut coordinate: impl FnMut() -> f64) -> [f64; 3] {
    std::array::from_fn(|_| coordinate())
}

fn line(input: Input, random: &mut Random) -> [[f64; 3]; 3] {
    match input {
        Input::N => {
            let ulps = |n: f64| 0.5 + n * power_of_two(-53);
            let p = [ulps(random.whole(0, 256)), ulps(random.whole(0, 256)), 0.0];
            [p, [12.0, 12.0, 0.0], [24.0, 24.0, 0.0]]
        }
        Input::G => {
            let [x, y, dx, dy] = [0; 4].map(|_| random.whole(-300, 300));
            [1.0, 2.0, 3.0].map(|t| [x + t * dx, y + t * dy, 0.0])
        }
        _ => [0; 3].map(|_| input.wide(random)).map(|x| [x, 2.0 * x, 0.0]),
    }
}

fn circle(input: Input, random: &mut Random) -> [[f64; 3]; 4] {
    match input {
        Input::N => {
            let [x, y, r] = [random.unit(), random.unit(), 0.5 + random.unit()];
            [0; 4].map(|_| {
                let (sin, cos) = (random.unit() * std::f64::consts::TAU).sin_cos();
                [x + r * cos, y + r * sin, 0.0]
            })
        }
        Input::G => {
            let [x, y, a, b] = [0; 4].map(|_| random.whole(-500, 500));
            [[a, b], [-b, a], [-a, -b], [a, -b]].map(|[dx, dy]| [x + dx, y + dy, 0.0])
        }
        _ => {
            let [x, y] = [input.wide(random), input.wide(random)];
            [[x, y], [-y, x], [-x, -y], [y, x]].map(|[x, y]| [x, y, 0.0])
        }
    }
}

fn plane(input: Input, random: &mut Random) -> [[f64; 3]; 4] {
    match input {
        Input::N => {
            let [a, b, c] = [random.unit(), random.unit(), random.unit()];
            [0; 4].map(|_| {
                let (x, y) = (random.unit(), random.unit());
                [x, y, a * x + b * y + c]
            })
        }
        Input::G => {
            let [p, u, v] = [0; 3].map(|_| [0; 3].map(|_| random.whole(-100, 100)));
            [[0.0, 0.0], [1.0, 2.0], [3.0, 1.0], [-2.0, 2.0]]
                .map(|[s, t]| std::array::from_fn(|axis| p[axis] + s * u[axis] + t * v[axis]))
        }
        _ => [0; 4].map(|_| {
            let (x, y) = (input.wide(random), input.wide(random));
            [x, y, 2.0 * x]
        }),
    }
}

fn sphere(input: Input, random: &mut Random) -> [[f64; 3]; 5] {
    match input {
        Input::N => {
            let centre = [random.unit(), random.unit(), random.unit()];
            let r = 0.5 + random.unit();
            [0; 5].map(|_| {
                let (z, angle) = (2.0 * random.unit() - 1.0, random.unit() * std::f64::consts::TAU);
                let (sin, cos) = angle.sin_cos();
                let flat = (1.0 - z * z).sqrt();
                let unit = [flat * cos, flat * sin, z];
                std::array::from_fn(|axis| centre[axis] + r * unit[axis])
            })
        }
        Input::G => {
            let [x, y, z, a, b, c] = [0; 6].map(|_| random.whole(-500, 500));
            turned(a, b, c).map(|[dx, dy, dz]| [x + dx, y + dy, z + dz])
        }
        _ => turned(input.wide(random), input.wide(random), input.wide(random)),
    }
}

/// Five points at one distance from the origin.
fn turned(a: f64, b: f64, c: f64) -> [[f64; 3]; 5] {
    [[a, b, c], [-b, a, c], [c, -a, -b], [-a, -c, b], [b, c, -a]]
}
