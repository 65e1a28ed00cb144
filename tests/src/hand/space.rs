//! Points of space.

use super::{HUGE, TINY, real};
use crate::case::Case;

/// All of them.
#[must_use]
pub fn space() -> Vec<Case<3>> {
    let mut cases = flat();
    cases.extend(cospherical());
    cases.extend(at_the_ends_of_the_range());
    cases
        .into_iter()
        .map(|(name, points)| Case::of_points(format!("hand {name}"), points))
        .collect()
}

type Named = (&'static str, Vec<[f64; 3]>);

/// Integer triples below `n`, mapped.
fn lattice(n: i32, f: impl Fn(i32, i32, i32) -> [i32; 3]) -> Vec<[f64; 3]> {
    (0..n * n * n).map(|i| f(i / (n * n), i / n % n, i % n).map(real)).collect()
}

fn flat() -> Vec<Named> {
    let plane = |f: fn(i32, i32) -> [i32; 3]| -> Vec<[f64; 3]> {
        (0..12).map(|i| f(i / 4, i % 4).map(real)).collect()
    };
    let mut one_off = plane(|x, y| [x, y, x + 2 * y]);
    one_off.push([1.0, 1.0, 7.0]);
    vec![
        ("no point in space", vec![]),
        ("one point in space, twice", vec![[1.0, 2.0, 3.0]; 2]),
        ("two points in space", vec![[1.0, 2.0, 3.0], [1.0, 2.0, -3.0]]),
        ("in line in space", [2, 0, 5, 1].map(|i| [i, -2 * i, 3 * i].map(real)).to_vec()),
        ("in line along z", [2, 0, 5, 1].map(|i| [4, 4, i].map(real)).to_vec()),
        ("in the plane z = 1", plane(|x, y| [x, y, 1])),
        ("in the plane x = 1", plane(|x, y| [1, x, y])),
        ("in a tilted plane", plane(|x, y| [x, y, x + 2 * y])),
        ("in a steep plane", plane(|x, y| [x, y, 1000 * x])),
        ("in a plane but one", one_off),
        ("a triangle in space", vec![[0.0; 3], [1.0, 0.0, 5.0], [0.0, 1.0, 7.0]]),
    ]
}

fn cospherical() -> Vec<Named> {
    let on_sphere = |square: i32| -> Vec<[f64; 3]> {
        let all = lattice(9, |x, y, z| [x - 4, y - 4, z - 4]).into_iter();
        all.filter(|p| p.iter().map(|x| x * x).sum::<f64>() == real(square)).collect()
    };
    let mut centred = lattice(2, |x, y, z| [2 * x, 2 * y, 2 * z]);
    centred.push([1.0; 3]);
    let prism = lattice(2, |x, y, z| [2 * x + y, 2 * y, 3 * z]);
    vec![
        ("a tetrahedron", vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
        ("a cube", lattice(2, |x, y, z| [x, y, z])),
        ("a cube and its centre", centred),
        ("a sheared cube", lattice(2, |x, y, z| [x + y, y + z, z])),
        ("27 lattice points", lattice(3, |x, y, z| [x, y, z])),
        ("an octahedron", on_sphere(1)),
        ("thirty cospherical points", on_sphere(9)),
        ("two concentric spheres", [on_sphere(3), on_sphere(5)].concat()),
        ("a prism", prism[..6].to_vec()),
    ]
}

fn at_the_ends_of_the_range() -> Vec<Named> {
    let cube = |s: f64| -> Vec<[f64; 3]> {
        lattice(2, |x, y, z| [x, y, z].map(|i| 2 * i - 1))
            .iter()
            .map(|p| p.map(|x| x * s))
            .collect()
    };
    vec![
        ("the largest cube", cube(HUGE)),
        ("the smallest cube", cube(TINY)),
        ("both cubes", [cube(HUGE), cube(TINY)].concat()),
        (
            "a tetrahedron of denormals",
            vec![[0.0; 3], [TINY, 0.0, 0.0], [0.0, TINY, 0.0], [0.0, 0.0, TINY]],
        ),
    ]
}
