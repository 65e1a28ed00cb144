//! The determinants in plain doubles, without any bound. Signed as the predicates are.

/// `a d - b c`.
#[inline(always)]
pub(super) fn minor([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    a * d - b * c
}

/// The two products of an orientation.
#[inline(always)]
pub(super) fn orient2d_products(a: &[f64; 2], b: &[f64; 2], c: &[f64; 2]) -> [f64; 2] {
    [(a[0] - c[0]) * (b[1] - c[1]), (a[1] - c[1]) * (b[0] - c[0])]
}

/// The two products of `(b - a) x (d - c)`.
#[inline(always)]
pub(super) fn cross_products([a, b, c, d]: [&[f64; 2]; 4]) -> [f64; 2] {
    [(b[0] - a[0]) * (d[1] - c[1]), (b[1] - a[1]) * (d[0] - c[0])]
}

#[inline(always)]
pub(crate) fn orient2d(a: &[f64; 2], b: &[f64; 2], c: &[f64; 2]) -> f64 {
    let [left, right] = orient2d_products(a, b, c);
    left - right
}

#[inline(always)]
pub(crate) fn cross(points: [&[f64; 2]; 4]) -> f64 {
    let [left, right] = cross_products(points);
    left - right
}

/// Differences to the last point; those of the third coordinate negated, since the reference is not the first point.
#[inline(always)]
pub(super) fn orient3d_rows([a, b, c, d]: [&[f64; 3]; 4]) -> ([[f64; 2]; 3], [f64; 3]) {
    ([a, b, c].map(|v| [v[0] - d[0], v[1] - d[1]]), [a, b, c].map(|v| d[2] - v[2]))
}

#[inline(always)]
pub(crate) fn orient3d(points: [&[f64; 3]; 4]) -> f64 {
    let ([p, q, r], z) = orient3d_rows(points);
    z[0] * minor(q, r) + z[1] * minor(r, p) + z[2] * minor(p, q)
}

/// Differences to the last point and their squared lengths.
#[inline(always)]
pub(super) fn in_circle_rows([a, b, c, d]: [&[f64; 2]; 4]) -> ([[f64; 2]; 3], [f64; 3]) {
    let rows = [a, b, c].map(|v| [v[0] - d[0], v[1] - d[1]]);
    (rows, rows.map(|v| v[0] * v[0] + v[1] * v[1]))
}

/// Differences to the last point in two coordinates, and their squared lengths in all three.
pub(super) fn in_circle_of_space_rows([a, b, c, d]: [&[f64; 3]; 4]) -> ([[f64; 2]; 3], [f64; 3]) {
    let rows = [a, b, c].map(|v| [v[0] - d[0], v[1] - d[1]]);
    let z = [a, b, c].map(|v| v[2] - d[2]);
    let height = |i: usize| rows[i][0] * rows[i][0] + rows[i][1] * rows[i][1] + z[i] * z[i];
    (rows, [height(0), height(1), height(2)])
}

#[inline(always)]
pub(crate) fn in_circle(points: [&[f64; 2]; 4]) -> f64 {
    in_circle_and_heights(points).0
}

/// The same, and the squared lengths.
#[inline(always)]
pub(crate) fn in_circle_and_heights(points: [&[f64; 2]; 4]) -> (f64, [f64; 3]) {
    let ([p, q, r], h) = in_circle_rows(points);
    (h[0] * minor(q, r) + h[1] * minor(r, p) + h[2] * minor(p, q), h)
}

/// Differences to the last point: those of two coordinates, of the third, and their squared lengths.
#[inline(always)]
pub(super) fn in_sphere_rows(
    [a, b, c, d, e]: [&[f64; 3]; 5],
) -> ([[f64; 2]; 4], [f64; 4], [f64; 4]) {
    let rows = [a, b, c, d].map(|v| [v[0] - e[0], v[1] - e[1]]);
    let z = [a, b, c, d].map(|v| v[2] - e[2]);
    let height = |i: usize| rows[i][0] * rows[i][0] + rows[i][1] * rows[i][1] + z[i] * z[i];
    (rows, z, [height(0), height(1), height(2), height(3)])
}

#[inline(always)]
pub(crate) fn in_sphere(points: [&[f64; 3]; 5]) -> f64 {
    let ([p, q, r, s], [pz, qz, rz, sz], h) = in_sphere_rows(points);
    let (pq, qr, rs) = (minor(p, q), minor(q, r), minor(r, s));
    let (sp, pr, qs) = (minor(s, p), minor(p, r), minor(q, s));
    let pqr = pz * qr - qz * pr + rz * pq;
    let qrs = qz * rs - rz * qs + sz * qr;
    let rsp = rz * sp + sz * pr + pz * rs;
    let spq = sz * pq + pz * qs + qz * sp;
    (h[2] * spq - h[3] * pqr) + (h[0] * qrs - h[1] * rsp) // `exact::formulas::sphere`
}
