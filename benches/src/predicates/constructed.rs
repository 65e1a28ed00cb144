//! Constructed points: beside plain ones, where filters decide, and where they cannot.

use delone_predicates::{Adaptive, Constructed, Construction, Kernel, Metric, Sign};

use super::Contestant;
use crate::random::Random;

fn contestant(
    name: &'static str,
    count: usize,
    sign: impl Fn(usize) -> Sign + 'static,
) -> Contestant {
    let run = move || {
        (0..count).map(&sign).fold([0; 2], |[positive, negative], sign| match sign {
            Sign::Positive => [positive + 1, negative],
            Sign::Zero => [positive, negative],
            Sign::Negative => [positive, negative + 1],
        })
    };
    Contestant { name, run: Box::new(run) }
}

/// Five plain points and a construction from them in each group of six.
fn kernel<const D: usize>(
    count: usize,
    construction: impl Fn(u32) -> Construction,
) -> Constructed<D> {
    let mut random = Random::new(3);
    let mut kernel = Constructed::new(Vec::new());
    for _ in 0..count {
        let first = kernel.push_plain(std::array::from_fn(|_| random.unit()));
        (0..4).for_each(|_| {
            kernel.push_plain(std::array::from_fn(|_| random.unit()));
        });
        kernel.push(&construction(first)).expect("random points are in general position");
    }
    kernel
}

/// A third along the first two points, nearly.
fn third(i: u32) -> Construction {
    Construction::SegmentPoint { a: i, b: i + 1, t: (1.0 / 3.0).into() }
}

fn plane(count: usize) -> Vec<Contestant> {
    let kernel =
        kernel::<2>(count, |i| Construction::Crossing { a: i, b: i + 1, c: i + 2, d: i + 3 });
    let plain = Adaptive::new(kernel.positions().to_vec());
    let [random, degenerate, within, circle] = [0; 4].map(|_| kernel.clone());
    let segment = self::kernel::<2>(count, third);
    let on_segment = segment.clone();
    vec![
        contestant("orient2d, plain kernel", count, move |i| {
            plain.orient(&[6 * i, 6 * i + 1, 6 * i + 2])
        }),
        contestant("orient2d, plain points", count, move |i| {
            within.orient(&[6 * i, 6 * i + 1, 6 * i + 2])
        }),
        contestant("orient2d, segment point", count, move |i| {
            segment.orient(&[6 * i, 6 * i + 2, 6 * i + 5])
        }),
        contestant("orient2d, segment point, zero", count, move |i| {
            on_segment.orient(&[6 * i, 6 * i + 1, 6 * i + 5])
        }),
        contestant("orient2d, crossing", count, move |i| {
            random.orient(&[6 * i, 6 * i + 2, 6 * i + 5])
        }),
        contestant("orient2d, crossing, zero", count, move |i| {
            degenerate.orient(&[6 * i, 6 * i + 1, 6 * i + 5])
        }),
        contestant("in_circle, crossing", count, move |i| {
            circle.lifted(&[6 * i, 6 * i + 2, 6 * i + 4], 6 * i + 5)
        }),
        contestant("in_circle, crossing, zero", count, move |i| {
            kernel.lifted(&[6 * i, 6 * i + 1, 6 * i + 5], 6 * i)
        }),
    ]
}

fn space(count: usize) -> Vec<Contestant> {
    let line_plane = kernel::<3>(count, |i| Construction::LinePlane {
        a: i,
        b: i + 1,
        plane: [i + 2, i + 3, i + 4],
    });
    let planes = |i| [[i, i + 1, i + 2], [i, i + 3, i + 4], [i + 1, i + 2, i + 4]];
    let planes = kernel::<3>(count, |i| Construction::ThreePlanes { planes: planes(i) });
    let segment = kernel::<3>(count, third);
    let on_segment = segment.clone();
    let [random, degenerate] = [0; 2].map(|_| line_plane.clone());
    let random_planes = planes.clone();
    let radii = Adaptive::new(line_plane.positions().to_vec());
    let equal = Adaptive::new(line_plane.positions().to_vec());
    vec![
        contestant("orient3d, segment point", count, move |i| {
            segment.orient(&[6 * i, 6 * i + 2, 6 * i + 3, 6 * i + 5])
        }),
        contestant("orient3d, segment point, zero", count, move |i| {
            on_segment.orient(&[6 * i, 6 * i + 1, 6 * i + 2, 6 * i + 5])
        }),
        contestant("orient3d, line and plane", count, move |i| {
            random.orient(&[6 * i, 6 * i + 2, 6 * i + 3, 6 * i + 5])
        }),
        contestant("orient3d, line and plane, zero", count, move |i| {
            degenerate.orient(&[6 * i + 2, 6 * i + 3, 6 * i + 4, 6 * i + 5])
        }),
        contestant("orient3d, three planes", count, move |i| {
            random_planes.orient(&[6 * i, 6 * i + 2, 6 * i + 3, 6 * i + 5])
        }),
        contestant("orient3d, three planes, zero", count, move |i| {
            planes.orient(&[6 * i, 6 * i + 1, 6 * i + 2, 6 * i + 5])
        }),
        contestant("radii of tetrahedra", count, move |i| {
            let tetrahedron = [6 * i, 6 * i + 1, 6 * i + 2, 6 * i + 3];
            radii.compare_radii(&tetrahedron, &[6 * i, 6 * i + 1, 6 * i + 2, 6 * i + 4]).into()
        }),
        contestant("radii of tetrahedra, equal", count, move |i| {
            let tetrahedron = [6 * i, 6 * i + 1, 6 * i + 2, 6 * i + 3];
            equal.compare_radii(&tetrahedron, &[6 * i + 3, 6 * i, 6 * i + 1, 6 * i + 2]).into()
        }),
    ]
}

/// By dimension, contestants that do `count` calls.
#[must_use]
pub fn constructions(count: usize) -> Vec<(&'static str, Vec<Contestant>)> {
    vec![("plane", plane(count)), ("space", space(count))]
}
