//! What a sweep of the plane asks: which arc of the beach line is ahead, and when arcs vanish.
//!
//! The line moves to the right. Behind it, the points nearer to a site than to the line are bounded by the site's *arc*, a
//! parabola; the beach line is made of the parts of arcs that are *ahead* of all others. An arc vanishes at a *circle event*,
//! when the line touches, on its right, the circle through the arc's site and those of its two neighbours.
//!
//! **Arcs.** With the line at p, the arc of a reaches, at the height of p, the centre of the circle through a that touches the line
//! at p, of radius |a - p|^2 / (2 (p - a).x). The smaller circle is ahead: a sign of degree 3.
//!
//! **Circle events.** With b and c relative to a, abc turning left, D = 2 b x c, N = |b|^2 c.y - |c|^2 b.y and
//! S = |b|^2 |c|^2 |b - c|^2, the circle's rightmost point is at a.x + (N + sqrt S) / D. To compare two of these is to find
//! the sign of X + sqrt P - sqrt Q, which takes two squarings and a look at signs.
//!
//! **Stages.** Arcs: doubles that carry their error bounds ([`Approximate`]), then dyadic numbers. Circle events: an interval
//! of doubles, rounded outwards, found once for each; where two overlap, dyadic numbers, which are kept. [`Exact`] has no first stage.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | two arcs meet at the height of p | zero | `arcs_that_meet_at_a_height_are_equal_there` |
//! | events of one circle, or of two that touch the line together | equal | `events_of_one_line_are_equal` |
//! | one root or both are whole, or vanish | the signs of what is left decide | `signs_with_roots_are_those_of_numbers` |
//! | sites far apart in the range of doubles | the interval is infinite | `all_doubles_are_ordered` |

use std::cell::OnceCell;
use std::cmp::Ordering;

use crate::formula::Signed;
use crate::kernel::Id;
use crate::metric::Metric;
use crate::ring::{Ring, dot, minor, minus, times};
use crate::{Adaptive, Approximate, Dyadic, Exact, Sign};

#[cfg(test)]
mod tests;

/// A kernel that also answers what a sweep of the plane to the right asks.
///
/// ```
/// use std::cmp::Ordering;
/// use delone_predicates::{Adaptive, Sign, SweepKernel};
/// let kernel = Adaptive::new([[5.0, 0.0], [0.0, 5.0], [-3.0, -4.0], [5.0, 7.0], [0.0, 7.0]]);
/// let event = kernel.circle_event([0usize, 1, 2]);
/// assert_eq!(kernel.compare_event_with_site(&event, 3), Ordering::Equal); // at x = 5, both
/// assert_eq!(kernel.arc_ahead(3usize, [4, 1]), Sign::Positive); // site 4 is nearer
/// ```
pub trait SweepKernel: Metric<2> {
    /// Of two arcs, with the line at `p` and at the height of `p`: positive if the first is ahead, zero if they meet. Their
    /// sites are strictly to the left of `p`.
    fn arc_ahead<V: Id>(&self, p: V, sites: [V; 2]) -> Sign {
        let near = [p, sites[0], sites[1]].map(|v| self.approximate_point(v).x);
        arc_ahead(&near).unwrap_or_else(|| {
            let exact = [p, sites[0], sites[1]].map(|v| self.exact_point(v).x);
            arc_ahead(&exact).expect("exact numbers have a sign")
        })
    }

    /// The event at which the circle through three sites, which turn left, touches the line from behind.
    fn circle_event<V: Id>(&self, sites: [V; 3]) -> CircleEvent<V> {
        let near = Circle::of(sites.map(|v| self.approximate_point(v).x));
        CircleEvent { sites, span: near.rightmost(), exact: OnceCell::new() }
    }

    /// The order in which the line comes to two circle events.
    fn compare_events<V: Id>(&self, e: &CircleEvent<V>, f: &CircleEvent<V>) -> Ordering {
        e.span.compare(f.span).unwrap_or_else(|| {
            let [e, f] = [e, f].map(|event| event.rightmost(self));
            e.compare(f)
        })
    }

    /// The order in which the line comes to a circle event and a site.
    fn compare_event_with_site<V: Id>(&self, event: &CircleEvent<V>, p: V) -> Ordering {
        let [near, _] = self.approximate_point(p).x;
        let [low, high] = near.bounds();
        event.span.compare(Span { low, high }).unwrap_or_else(|| {
            let [x, _] = self.exact_point(p).x;
            event.rightmost(self).compare_with(&x)
        })
    }
}

impl<P: AsRef<[[f64; 2]]>> SweepKernel for Adaptive<P> {}

impl<P: AsRef<[[f64; 2]]>> SweepKernel for Exact<P> {}

/// A circle event: three sites, and about where the line is when it comes to it.
#[derive(Clone, Debug, PartialEq)]
pub struct CircleEvent<V> {
    sites: [V; 3],
    span: Span,
    /// Exactly where, once that was asked: ties come in crowds.
    exact: OnceCell<Box<Rightmost>>,
}

impl<V: Copy> CircleEvent<V> {
    /// The sites, which turn left.
    pub const fn sites(&self) -> [V; 3] {
        self.sites
    }
}

impl<V: Id> CircleEvent<V> {
    fn rightmost(&self, kernel: &(impl Metric<2> + ?Sized)) -> &Rightmost {
        self.exact.get_or_init(|| {
            let Circle { x, n, squares: [p, q, r], d } =
                Circle::of(self.sites.map(|v| kernel.exact_point(v).x));
            Box::new(Rightmost { x, n, s: p * q * r, d })
        })
    }
}

/// Between two doubles, which may be infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Span {
    low: f64,
    high: f64,
}

impl Span {
    const ALL: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// The order of two numbers that are in these spans, if these decide.
    fn compare(self, other: Self) -> Option<Ordering> {
        if self.high < other.low {
            Some(Ordering::Less)
        } else if self.low > other.high {
            Some(Ordering::Greater)
        } else {
            None
        }
    }
}

fn arc_ahead<T: Signed>([p, a, b]: &[[T; 2]; 3]) -> Option<Sign> {
    let (a, b) = (from(a, p), from(b, p));
    minor(&dot(&a, &a), &dot(&b, &b), &a[0], &b[0]).known_sign()
}

fn from<T: Ring>(a: &[T; 2], origin: &[T; 2]) -> [T; 2] {
    std::array::from_fn(|axis| minus(a[axis].clone(), &origin[axis]))
}

/// The circle through three points, by the numbers of the module's text: those under the root one by one.
struct Circle<T> {
    x: T,
    n: T,
    squares: [T; 3],
    d: T,
}

impl<T: Ring> Circle<T> {
    fn of([a, b, c]: [[T; 2]; 3]) -> Self {
        let (ab, ac, bc) = (from(&b, &a), from(&c, &a), from(&c, &b));
        let squares = [&ab, &ac, &bc].map(|side| dot(side, side));
        let cross = minor(&ab[0], &ab[1], &ac[0], &ac[1]);
        let n = minor(&squares[0], &squares[1], &ab[1], &ac[1]);
        let [x, _] = a;
        Self { x, n, squares, d: cross.clone() + cross }
    }
}

impl Circle<Approximate> {
    /// A span of the rightmost point: each operation rounded to nearest, and then one double further out.
    fn rightmost(&self) -> Span {
        let [mut low, mut high] = [1.0f64; 2];
        for square in &self.squares {
            let [least, most] = square.bounds();
            low = (low * least.max(0.0).sqrt().next_down()).next_down().max(0.0);
            high = (high * most.sqrt().next_up()).next_up();
        }
        let ([n_low, n_high], [d_low, d_high]) = (self.n.bounds(), self.d.bounds());
        let [low, high] = [(n_low + low).next_down(), (n_high + high).next_up()];
        let [x_low, x_high] = self.x.bounds();
        let low = (low / d_low).min(low / d_high).next_down() + x_low;
        let high = (high / d_low).max(high / d_high).next_up() + x_high;
        let known = d_low > 0.0 && !low.is_nan() && !high.is_nan();
        if known { Span { low: low.next_down(), high: high.next_up() } } else { Span::ALL }
    }
}

/// Exactly x + (n + sqrt s) / d.
#[derive(Clone, Debug, PartialEq)]
struct Rightmost {
    x: Dyadic,
    n: Dyadic,
    s: Dyadic,
    d: Dyadic,
}

impl Rightmost {
    /// The order of this point and of x: the sign of (self.x - x) d + n + sqrt s.
    fn compare_with(&self, x: &Dyadic) -> Ordering {
        let rational = times(&minus(self.x.clone(), x), &self.d) + &self.n;
        sign_with_root(&rational, &self.s).cmp(&Sign::Zero)
    }

    /// The order of two such points.
    fn compare(&self, other: &Self) -> Ordering {
        if (&self.n, &self.s, &self.d) == (&other.n, &other.s, &other.d) {
            return self.x.cmp(&other.x); // one triangle, moved: what grids are made of
        }
        let apart = minus(self.x.clone(), &other.x) * &(&self.d * &other.d);
        let rational = minor(&self.n, &other.n, &self.d, &other.d) + &apart;
        let [p, q] = [(self, other), (other, self)].map(|(a, b)| &a.s * &(&b.d * &b.d));
        sign_with_roots(&rational, &p, &q).cmp(&Sign::Zero)
    }
}

/// The sign of x + sqrt p.
fn sign_with_root(x: &Dyadic, p: &Dyadic) -> Sign {
    match x.sign() {
        Sign::Positive => Sign::Positive,
        Sign::Zero => p.sign(),
        Sign::Negative => minus(p.clone(), &(x * x)).sign(),
    }
}

/// The sign of x + sqrt p - sqrt q.
///
/// If x + sqrt p is positive, both sides are squared: y + 2 x sqrt p is left, y being x^2 + p - q; and squared once more if
/// its two terms have opposite signs.
fn sign_with_roots(x: &Dyadic, p: &Dyadic, q: &Dyadic) -> Sign {
    match sign_with_root(x, p) {
        Sign::Negative => return Sign::Negative,
        Sign::Zero => return -q.sign(),
        Sign::Positive => {}
    }
    let square = x * x;
    let y = minus(square.clone() + p, q);
    let (sign, root) = (y.sign(), x.sign() * p.sign());
    if sign == Sign::Zero || root == Sign::Zero || sign == root {
        return if sign == Sign::Zero { root } else { sign };
    }
    sign * minus(&y * &y, &(square * p * Dyadic::from(4))).sign()
}
