//! Laws of every kernel that is right, in two to six dimensions, on generated points: parity of permutations, scaling by
//! powers of two, exact translation, reflection, and duality: in_sphere is orient of the points lifted to the paraboloid.

use delone::predicates::{
    Adaptive, Checked, Constructed, Construction, Counting, Dyadic, Exact, ExactOver, Kernel,
    Projected, RobustCrate, Sign, Tally, Weighted,
};
use delone_tests::exact::{power_of_two, scaled, translated};
use delone_tests::generated::{coordinate, run};
use proptest::prelude::{Strategy, any};
use proptest::sample::SizeRange;

/// A kernel in any dimension.
trait Family {
    type Over<const D: usize>: Kernel<D>;

    /// Over these points, after a scaling by 2^k.
    fn over<const D: usize>(points: &[[f64; D]], k: i32) -> Self::Over<D>;

    /// The weight of a point by number.
    fn weight(_: usize) -> f64 {
        0.0
    }

    /// A point's height over the paraboloid's foot, exactly, for small integers.
    fn height(i: usize, p: &[f64]) -> f64 {
        p.iter().map(|x| x * x).sum::<f64>() - Self::weight(i)
    }

    /// Exponents of coordinates and of scalings that the kernel can bear: whether any, or only small ones.
    const ALL_EXPONENTS: bool = true;
}

macro_rules! families {
    ($($name:ident: $type:ty, |$points:ident| $make:expr;)*) => {$(
        struct $name;
        impl Family for $name {
            type Over<const D: usize> = $type;
            fn over<const D: usize>($points: &[[f64; D]], _: i32) -> Self::Over<D> {
                $make
            }
        }
    )*};
}

families! {
    OfAdaptive: Adaptive<Vec<[f64; D]>>, |p| Adaptive::new(p.to_vec());
    OfDynamic: Adaptive<Vec<[f64; D]>>, |p| Adaptive::dynamic(p.to_vec());
    OfExact: Exact<Vec<[f64; D]>>, |p| Exact::new(p.to_vec());
    OfDyadic: ExactOver<Dyadic, Vec<[f64; D]>>, |p| ExactOver::new(p.to_vec());
    OfInteger: ExactOver<rug::Integer, Vec<[f64; D]>>, |p| ExactOver::new(p.to_vec());
    OfRational: ExactOver<rug::Rational, Vec<[f64; D]>>, |p| ExactOver::new(p.to_vec());
    OfChecked: Checked<Adaptive<Vec<[f64; D]>>, ExactOver<rug::Integer, Vec<[f64; D]>>>,
        |p| Checked::new(Adaptive::new(p.to_vec()), ExactOver::new(p.to_vec()));
    OfConstructed: Constructed<D>, |p| constructed(p);
}

/// The points times a number of 80 bits near 1/3: constructed, and similar to them.
fn constructed<const D: usize>(points: &[[f64; D]]) -> Constructed<D> {
    let mut kernel = Constructed::new(points.to_vec());
    let origin = kernel.push_plain([0.0; D]);
    let t = Dyadic::from(1.0 / 3.0) + Dyadic::from(power_of_two(-80));
    let ids: Vec<u32> = (0..origin)
        .map(|b| {
            let third = Construction::SegmentPoint { a: origin, b, t: t.clone() };
            kernel.push(&third).expect("plain ends")
        })
        .collect();
    kernel.reordered(&ids)
}

struct OfCounting;

impl Family for OfCounting {
    type Over<const D: usize> = Counting<'static, Exact<Vec<[f64; D]>>>;
    fn over<const D: usize>(points: &[[f64; D]], _: i32) -> Self::Over<D> {
        Counting::new(Exact::new(points.to_vec()), Box::leak(Box::new(Tally::default())))
    }
}

struct OfRobust;

impl Family for OfRobust {
    type Over<const D: usize> = RobustCrate<Vec<[f64; D]>>;
    fn over<const D: usize>(points: &[[f64; D]], _: i32) -> Self::Over<D> {
        RobustCrate::new(points.to_vec())
    }
    const ALL_EXPONENTS: bool = false;
}

struct OfWeighted;

impl Family for OfWeighted {
    type Over<const D: usize> = Weighted<Vec<[f64; D]>, Vec<f64>>;
    fn over<const D: usize>(points: &[[f64; D]], k: i32) -> Self::Over<D> {
        let square = |i: usize| Self::weight(i) * power_of_two(k) * power_of_two(k);
        Weighted::new(points.to_vec(), (0..points.len()).map(square).collect())
    }
    fn weight(i: usize) -> f64 {
        [3.0, -2.0, 0.0, 7.0, 1.0, 0.0, -5.0, 2.0][i % 8]
    }
}

/// Points of a flat of R^7: the first coordinate stands in all places before the given ones too.
struct OfProjected;

impl Family for OfProjected {
    type Over<const D: usize> = Projected<7, D, Adaptive<Vec<[f64; 7]>>>;
    fn over<const D: usize>(points: &[[f64; D]], _: i32) -> Self::Over<D> {
        let place = |p: &[f64; D]| std::array::from_fn(|axis| p[(axis + D).saturating_sub(7)]);
        let base = Adaptive::new(points.iter().map(place).collect());
        Projected::new(base, std::array::from_fn(|axis| axis + 7 - D))
    }
    fn height(_: usize, p: &[f64]) -> f64 {
        let copies = f64::from(u32::try_from(7 - p.len()).expect("at most six"));
        copies * p[0] * p[0] + p.iter().map(|x| x * x).sum::<f64>()
    }
}

/// D + 2 points, and what to do with them.
#[derive(Clone, Debug)]
struct Input<const D: usize> {
    points: Vec<[f64; D]>,
    order: [u64; 8],
    k: i32,
    offset: [i32; D],
    axis: usize,
}

fn inputs<const D: usize>() -> impl Strategy<Value = Input<D>> {
    let points = proptest::collection::vec(
        proptest::array::uniform::<_, D>(coordinate()),
        SizeRange::from(D + 2),
    );
    let offset = proptest::array::uniform::<_, D>(-9..=9i32);
    (points, any::<[u64; 8]>(), -490..=490i32, offset, 0..D)
        .prop_map(|(points, order, k, offset, axis)| Input { points, order, k, offset, axis })
}

/// The orientation of the first D+1, and the lifted determinant of all, in this order.
fn signs<const D: usize>(kernel: &impl Kernel<D>, order: &[usize]) -> [Sign; 2] {
    [kernel.orient(&order[..=D]), kernel.lifted(&order[..=D], order[D + 1])]
}

/// The order that sorts these keys, and whether it is an odd permutation.
fn permutation(keys: &[u64]) -> (Vec<usize>, usize) {
    let mut order: Vec<usize> = (0..keys.len()).collect();
    order.sort_by_key(|&i| keys[i]);
    let before = |j: usize| order[..j].iter().filter(|&&i| i > order[j]).count();
    let inversions = (0..order.len()).map(before).sum();
    (order, inversions)
}

fn obeys<F: Family, const D: usize>(input: Input<D>) {
    let Input { mut points, order, k, offset, axis } = input;
    if !F::ALL_EXPONENTS {
        let small = |x: &f64| *x == 0.0 || (1e-9..1e9).contains(&x.abs());
        points.iter_mut().flatten().filter(|x| !small(x)).for_each(|x| *x = 1.5);
    }
    let ids: Vec<usize> = (0..D + 2).collect();
    let kernel = F::over(&points, 0);
    let [orient, lifted] = signs(&kernel, &ids);
    // Permutations: of the simplex, and of all, the query among them.
    let (simplex, parity) = permutation(&order[..=D]);
    let turned = [orient, lifted].map(|sign| sign.times_minus_one_to(parity));
    assert_eq!(signs(&kernel, &[&simplex[..], &[D + 1]].concat()), turned, "{simplex:?}");
    let (all, parity) = permutation(&order[..D + 2]);
    assert_eq!(signs(&kernel, &all)[1], lifted.times_minus_one_to(parity), "{all:?}");
    // Scaling.
    let k = if F::ALL_EXPONENTS { k } else { k / 20 };
    if let Some(image) = scaled(&points, k) {
        assert_eq!(signs(&F::over(&image, k), &ids), [orient, lifted], "times 2^{k}");
    }
    // Translation.
    if let Some(image) = translated(&points, offset.map(f64::from)) {
        assert_eq!(signs(&F::over(&image, 0), &ids), [orient, lifted], "moved by {offset:?}");
    }
    // Reflection.
    let mut image = points.clone();
    image.iter_mut().for_each(|p| p[axis] = -p[axis]);
    assert_eq!(signs(&F::over(&image, 0), &ids), [-orient, -lifted], "axis {axis} reflected");
}

/// In E = D + 1 dimensions the points with their heights, where these are integers that doubles hold.
fn is_dual<F: Family, const D: usize, const E: usize>(input: &Input<D>) {
    let integers: Vec<[f64; D]> = input
        .points
        .iter()
        .map(|p| p.map(|x| if x.abs() < 1e6 { x.round() } else { 3.0 }))
        .collect();
    let lift = |(i, p): (usize, &[f64; D])| -> [f64; E] {
        let height = F::height(i, p);
        std::array::from_fn(|axis| p.get(axis).copied().unwrap_or(height))
    };
    let raised: Vec<[f64; E]> = integers.iter().enumerate().map(lift).collect();
    let ids: Vec<usize> = (0..D + 2).collect();
    let lifted = F::over(&integers, 0).lifted(&ids[..=D], D + 1);
    // Over the lifted hyperplane is outside.
    let turned = F::over(&raised, 0).orient(&ids);
    assert_eq!(lifted, -turned, "{integers:?}");
}

fn laws<F: Family, const D: usize, const E: usize>(cases: u32) {
    run(cases, &inputs::<D>(), |input| {
        is_dual::<F, D, E>(&input);
        obeys::<F, D>(input);
    });
}

fn in_all_dimensions<F: Family>() {
    laws::<F, 2, 3>(150);
    laws::<F, 3, 4>(100);
    laws::<F, 4, 5>(40);
    laws::<F, 5, 6>(20);
    laws::<F, 6, 7>(10);
}

macro_rules! tests {
    ($($name:ident: $family:ty;)*) => {$(
        #[test]
        fn $name() {
            in_all_dimensions::<$family>();
        }
    )*};
}

tests! {
    laws_of_the_adaptive_kernel: OfAdaptive;
    laws_of_the_adaptive_kernel_without_static_filters: OfDynamic;
    laws_of_the_exact_kernel: OfExact;
    laws_of_the_kernel_over_dyadic_numbers: OfDyadic;
    laws_of_the_kernel_over_integers: OfInteger;
    laws_of_the_kernel_over_rationals: OfRational;
    laws_of_a_checked_kernel: OfChecked;
    laws_of_a_counting_kernel: OfCounting;
    laws_of_constructed_points: OfConstructed;
    laws_of_weighted_sites: OfWeighted;
    laws_of_points_of_a_flat: OfProjected;
    laws_of_the_crate_robust: OfRobust;
}
