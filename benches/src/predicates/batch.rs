//! Filters one by one and in batches: one simplex against many points, one point against many simplices.

use delone_predicates::{Sign, batch};

use super::Contestant;
use crate::random::Random;

type Columns<const D: usize> = [Vec<f64>; D];

fn columns<const D: usize>(count: usize, random: &mut Random) -> Columns<D> {
    std::array::from_fn(|_| (0..count).map(|_| random.unit()).collect())
}

fn cut<const D: usize>(columns: &Columns<D>) -> [&[f64]; D] {
    columns.each_ref().map(Vec::as_slice)
}

fn at<const D: usize>(columns: &Columns<D>, i: usize) -> [f64; D] {
    columns.each_ref().map(|column| column[i])
}

fn rows<const D: usize>(columns: &Columns<D>) -> Vec<[f64; D]> {
    (0..columns[0].len()).map(|i| at(columns, i)).collect()
}

fn contestant(name: &'static str, run: impl Fn() -> [usize; 2] + 'static) -> Contestant {
    Contestant { name, run: Box::new(run) }
}

/// The positive and the negative signs of a loop.
fn count_of(signs: impl Iterator<Item = Sign>) -> [usize; 2] {
    signs.fold([0; 2], |[positive, negative], sign| {
        [
            positive + usize::from(sign == Sign::Positive),
            negative + usize::from(sign == Sign::Negative),
        ]
    })
}

/// Those of a batch: on random points it is never uncertain.
fn batch_of(count: usize, fill: impl Fn(&mut [i8]) -> usize) -> [usize; 2] {
    let mut signs = vec![0; count];
    let uncertain = fill(&mut signs);
    let positive = signs.iter().filter(|&&sign| sign > 0).count();
    [positive, count - positive - uncertain]
}

/// The contestants of a predicate: points of D coordinates, N of them fixed or taken from columns.
macro_rules! contestants {
    ($name:ident, $d:literal: $($p:ident),*; $scalar:path, $many:path, $of:path) => {
        fn $name(count: usize) -> Vec<Contestant> {
            let mut random = Random::new(7);
            $(let $p: Columns<$d> = columns(count, &mut random);)*
            let q: Columns<$d> = columns(count, &mut random);
            let mut contestants = Vec::new();
            {
                $(let $p = at(&$p, 0);)*
                let (points, q) = (rows(&q), q.clone());
                contestants.push(contestant("one by one, many points", move || {
                    count_of(points.iter().map(|&q| $scalar($($p,)* q)))
                }));
                contestants.push(contestant("batch, many points", move || {
                    batch_of(count, |signs| $many($($p,)* cut(&q), signs))
                }));
            }
            let q = at(&q, 0);
            {
                $(let $p = rows(&$p);)*
                contestants.push(contestant("one by one, many simplices", move || {
                    count_of((0..count).map(|i| $scalar($($p[i],)* q)))
                }));
            }
            contestants.push(contestant("batch, many simplices", move || {
                batch_of(count, |signs| $of($(cut(&$p),)* q, signs))
            }));
            contestants
        }
    };
}

contestants!(orient2d, 2: a, b;
    delone_predicates::orient2d, batch::orient2d, batch::orient2d_of);
contestants!(in_circle, 2: a, b, c;
    delone_predicates::in_circle, batch::in_circle, batch::in_circle_of);
contestants!(orient3d, 3: a, b, c;
    delone_predicates::orient3d, batch::orient3d, batch::orient3d_of);
contestants!(in_sphere, 3: a, b, c, d;
    delone_predicates::in_sphere, batch::in_sphere, batch::in_sphere_of);

/// By predicate, contestants that do `count` calls on random points.
#[must_use]
pub fn batches(count: usize) -> Vec<(&'static str, Vec<Contestant>)> {
    vec![
        ("orient2d", orient2d(count)),
        ("in_circle", in_circle(count)),
        ("orient3d", orient3d(count)),
        ("in_sphere", in_sphere(count)),
    ]
}
