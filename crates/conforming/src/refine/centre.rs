//! Circumcentres and off-centres in doubles: places for vertices, which rounding may move.

use super::Centre;

/// By how much an off-centre stays short of the place where the angle just keeps the bound: rounding must not undo it.
const SHORT: f64 = 0.95;

/// The centre of a triangle whose shortest edge is from `p` to `q`; `cotangent` is that of half the least angle asked for.
/// `None` if doubles cannot say.
pub(super) fn centre([p, q, r]: [[f64; 2]; 3], kind: Centre, cotangent: f64) -> Option<[f64; 2]> {
    let (u, v) = ([q[0] - p[0], q[1] - p[1]], [r[0] - p[0], r[1] - p[1]]);
    let area = 2.0 * (u[0] * v[1] - u[1] * v[0]);
    let (uu, vv) = (u[0] * u[0] + u[1] * u[1], v[0] * v[0] + v[1] * v[1]);
    let to_centre = [(v[1] * uu - u[1] * vv) / area, (u[0] * vv - v[0] * uu) / area];
    let mut to = to_centre;
    if kind == Centre::OffCentre {
        // On the bisector of pq, on the side of r, which is on its left.
        let factor = SHORT * 0.5 * cotangent;
        let off = [0.5 * u[0] - factor * u[1], 0.5 * u[1] + factor * u[0]];
        let nearer = |a: [f64; 2]| {
            let (x, y) = (a[0] - 0.5 * u[0], a[1] - 0.5 * u[1]);
            x * x + y * y
        };
        // The circumcentre may be beyond pq, as seen from r.
        let along = to_centre[1] * u[0] - to_centre[0] * u[1];
        if along > 0.0 && nearer(off) < nearer(to_centre) {
            to = off;
        }
    }
    let centre = [p[0] + to[0], p[1] + to[1]];
    centre.iter().all(|x| x.is_finite()).then_some(centre)
}
