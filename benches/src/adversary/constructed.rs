//! Constructed points against projective geometry over integers: lines and planes are joins of points, crossings are meets.

use delone_predicates::{Constructed, Construction, Dyadic, Kernel};
use rug::Integer;

use super::{Tally, judge, points};
use crate::oracle;
use crate::random::{Random, power_of_two};

/// `[w, x, y, ..]`.
type Vector = Vec<Integer>;

/// Plain points of a round.
const PLAIN: usize = 6;

/// Orientations and in-sphere tests of plain and constructed points, against the oracle.
///
/// # Panics
/// If a construction is accepted that is no point, or refused that is one.
pub fn round_of_constructed<const D: usize>(random: &mut Random, tally: &mut Tally) {
    let plain: [[f64; D]; PLAIN] = points(random);
    let unit = Integer::from(1);
    let mut vectors: Vec<Vector> = oracle::shifted(&plain)
        .into_iter()
        .map(|point| [unit.clone()].into_iter().chain(point).collect())
        .collect();
    let mut kernel = Constructed::new(plain.to_vec());
    for _ in 0..4 {
        let (construction, vector) = construction::<D>(random, &vectors);
        let is_point = vector[0] != 0;
        assert_eq!(kernel.push(&construction).is_ok(), is_point, "{construction:?} of {plain:?}");
        if is_point {
            vectors.push(vector);
        }
    }
    for _ in 0..4 {
        let ids: Vec<usize> = (0..D + 2).map(|_| random.index(vectors.len())).collect();
        let (simplex, q) = (&ids[..=D], ids[D + 1]);
        let all: [usize; D] = std::array::from_fn(|axis| axis);
        let expected = [orient(&ids[..=D], &vectors), in_sphere(&ids, &vectors)];
        tally.zeros += u64::from(expected[0] == 0) + u64::from(expected[1] == 0);
        let positions = kernel.positions();
        judge(tally, kernel.orient(simplex), expected[0], positions);
        judge(tally, kernel.orient_on(&all, simplex), expected[0], positions);
        judge(tally, kernel.lifted(simplex, q), expected[1], positions);
        judge(tally, kernel.lifted_on(&all, simplex, q), expected[1], positions);
    }
}

/// A construction from plain points, and its homogeneous coordinates.
fn construction<const D: usize>(random: &mut Random, plain: &[Vector]) -> (Construction, Vector) {
    let mut id = || u32::try_from(random.index(PLAIN)).expect("small");
    let [a, b, c, d, e, f, g, h, i] = [0; 9].map(|_| id());
    let at = |id: u32| &plain[id as usize];
    let join = |ids: &[u32]| meet(&ids.iter().map(|&id| at(id)).collect::<Vec<_>>());
    match (D, random.bits() % 3) {
        (2, 1 | 2) => {
            let crossing = Construction::Crossing { a, b, c, d };
            (crossing, meet(&[&join(&[a, b]), &join(&[c, d])]))
        }
        (3, 1) => {
            let plane = join(&[c, d, e]);
            let (times_a, times_b) = (dot(&plane, at(b)), dot(&plane, at(a)));
            let mix = |(a, b): (&Integer, &Integer)| {
                Integer::from(a * &times_a) - Integer::from(b * &times_b)
            };
            let crossing = Construction::LinePlane { a, b, plane: [c, d, e] };
            (crossing, at(a).iter().zip(at(b)).map(mix).collect())
        }
        (3, 2) => {
            let planes = [[a, b, c], [d, e, f], [g, h, i]];
            let [l, m, n] = planes.map(|plane| join(&plane));
            (Construction::ThreePlanes { planes }, meet(&[&l, &m, &n]))
        }
        _ => {
            let (numerator, zeros) = (random.integer(-3, 1 << 20), random.exponent(0, 90));
            let t = (0..zeros).fold(Dyadic::from(numerator), |t, _| t.half());
            let t = if random.once_in(2) { t + Dyadic::from(power_of_two(-90)) } else { t };
            let whole: Integer = Integer::from(1) << 90;
            // t times 2^90, from the dyadic number's own digits.
            let shift = u32::try_from(t.exponent() + 90).expect("a multiple of 2^-90");
            let digits = t.mantissa().iter().rev();
            let digits = digits.fold(Integer::new(), |sum, &limb| (sum << 64) + limb) << shift;
            let times = if (t.sign() as i8) < 0 { -digits } else { digits };
            let mut rest = whole.clone();
            rest -= &times;
            let mix =
                |(a, b): (&Integer, &Integer)| Integer::from(a * &rest) + Integer::from(b * &times);
            (Construction::SegmentPoint { a, b, t }, at(a).iter().zip(at(b)).map(mix).collect())
        }
    }
}

/// The vector orthogonal to all of these, one fewer than their length: a join of points, a meet of hyperplanes.
fn meet(vectors: &[&Vector]) -> Vector {
    (0..=vectors.len())
        .map(|dropped| {
            let without = |vector: &&Vector| {
                let kept = vector.iter().enumerate().filter(|(column, _)| *column != dropped);
                kept.map(|(_, x)| x.clone()).collect()
            };
            let minor = oracle::cofactors(&vectors.iter().map(without).collect::<Vec<_>>());
            if dropped % 2 == 1 { -minor } else { minor }
        })
        .collect()
}

fn dot(a: &Vector, b: &Vector) -> Integer {
    a.iter().zip(b).map(|(a, b)| Integer::from(a * b)).sum()
}

/// The sign of `det[w x]`, each row's w made positive.
fn orient(ids: &[usize], vectors: &[Vector]) -> i8 {
    let rows: Vec<Vector> = ids.iter().map(|&id| vectors[id].clone()).collect();
    rows.iter().map(|row| oracle::sign(&row[0])).product::<i8>()
        * oracle::sign(&oracle::cofactors(&rows))
}

/// The sign of `-det[w^2 wx x.x]`.
fn in_sphere(ids: &[usize], vectors: &[Vector]) -> i8 {
    let row = |&id: &usize| {
        let (w, x) = vectors[id].split_first().expect("a weight");
        let mut row = vec![Integer::from(w * w)];
        row.extend(x.iter().map(|x| Integer::from(x * w)));
        row.push(x.iter().map(|x| Integer::from(x * x)).sum());
        row
    };
    -oracle::sign(&oracle::cofactors(&ids.iter().map(row).collect::<Vec<_>>()))
}
