//! The determinants of differences up to three axes, each product in exactly the limbs it needs.
//!
//! `L` is the width of a difference, `L2` .. `L5` its multiples. The head-room is proved in `exact.rs`.

use crate::int::Int;

/// `a d - b c`.
#[inline(always)]
pub(crate) fn minor<const L: usize, const L2: usize>(
    a: &Int<L>,
    b: &Int<L>,
    c: &Int<L>,
    d: &Int<L>,
) -> Int<L2> {
    a.times::<L, L2>(d) - b.times::<L, L2>(c)
}

/// `det[p; q]` in the plane.
#[inline(always)]
pub(crate) fn plane<const L: usize, const L2: usize>([p, q]: [&[Int<L>; 2]; 2]) -> Int<L2> {
    minor(&p[0], &p[1], &q[0], &q[1])
}

/// `det[p; q; r]` in space.
#[inline(always)]
pub(crate) fn space<const L: usize, const L2: usize, const L3: usize>(
    [p, q, r]: [&[Int<L>; 3]; 3],
) -> Int<L3> {
    let pq: Int<L2> = minor(&p[0], &p[1], &q[0], &q[1]);
    let qr: Int<L2> = minor(&q[0], &q[1], &r[0], &r[1]);
    let rp: Int<L2> = minor(&r[0], &r[1], &p[0], &p[1]);
    p[2].times::<L2, L3>(&qr) + q[2].times(&rp) + r[2].times(&pq)
}

/// `det[p h; q h]` on a line.
#[inline(always)]
pub(crate) fn interval<const L: usize, const L2: usize, const L3: usize>(
    [p, q]: [&Int<L>; 2],
    h: [&Int<L2>; 2],
) -> Int<L3> {
    p.times::<L2, L3>(h[1]) - q.times(h[0])
}

/// `det[p h; q h; r h]` in the plane.
#[inline(always)]
pub(crate) fn circle<const L: usize, const L2: usize, const L4: usize>(
    [p, q, r]: [&[Int<L>; 2]; 3],
    h: [&Int<L2>; 3],
) -> Int<L4> {
    let pq: Int<L2> = minor(&p[0], &p[1], &q[0], &q[1]);
    let qr: Int<L2> = minor(&q[0], &q[1], &r[0], &r[1]);
    let rp: Int<L2> = minor(&r[0], &r[1], &p[0], &p[1]);
    h[0].times::<L2, L4>(&qr) + h[1].times(&rp) + h[2].times(&pq)
}

/// `-det[p h; q h; r h; s h]` in space: the sign as [`crate::in_sphere`] has it.
#[inline(always)]
pub(crate) fn sphere<const L: usize, const L2: usize, const L3: usize, const L5: usize>(
    [p, q, r, s]: [&[Int<L>; 3]; 4],
    h: [&Int<L2>; 4],
) -> Int<L5> {
    let pq: Int<L2> = minor(&p[0], &p[1], &q[0], &q[1]);
    let qr: Int<L2> = minor(&q[0], &q[1], &r[0], &r[1]);
    let rs: Int<L2> = minor(&r[0], &r[1], &s[0], &s[1]);
    let sp: Int<L2> = minor(&s[0], &s[1], &p[0], &p[1]);
    let pr: Int<L2> = minor(&p[0], &p[1], &r[0], &r[1]);
    let qs: Int<L2> = minor(&q[0], &q[1], &s[0], &s[1]);
    let (p, q, r, s) = (&p[2], &q[2], &r[2], &s[2]);
    let pqr: Int<L3> = p.times(&qr) - q.times(&pr) + r.times(&pq);
    let qrs: Int<L3> = q.times(&rs) - r.times(&qs) + s.times(&qr);
    let rsp: Int<L3> = r.times(&sp) + s.times(&pr) + p.times(&rs);
    let spq: Int<L3> = s.times(&pq) + p.times(&qs) + q.times(&sp);
    (spq.times::<L2, L5>(h[2]) - pqr.times(h[3])) + (qrs.times(h[0]) - rsp.times(h[1]))
}

/// [`circle`] with the rows' squared lengths as heights.
#[inline(always)]
pub(crate) fn in_circle<const L: usize, const L2: usize, const L4: usize>(
    rows: [&[Int<L>; 2]; 3],
) -> Int<L4> {
    let height = |[x, y]: &[Int<L>; 2]| x.times::<L, L2>(x) + y.times(y);
    circle(rows, [&height(rows[0]), &height(rows[1]), &height(rows[2])])
}

/// [`sphere`] with the rows' squared lengths as heights.
#[inline(always)]
pub(crate) fn in_sphere<const L: usize, const L2: usize, const L3: usize, const L5: usize>(
    rows: [&[Int<L>; 3]; 4],
) -> Int<L5> {
    let height = |[x, y, z]: &[Int<L>; 3]| x.times::<L, L2>(x) + y.times(y) + z.times(z);
    let [p, q, r, s] = rows;
    sphere::<L, L2, L3, L5>(rows, [&height(p), &height(q), &height(r), &height(s)])
}
