use num_traits::{One, Zero};

use super::*;

/// A value of up to so many bits, of either sign, often with long runs of zeros or ones.
fn value(seed: &mut u64) -> Dyadic {
    let mut next = || {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        *seed >> 33
    };
    let mut value = Dyadic::from(0);
    for _ in 0..next() % 8 {
        let limb = [0, 1, 0xffff_ffff, next() & 0xffff_ffff][usize::try_from(next() % 4).unwrap()];
        let limb = Dyadic::from(limb.cast_signed());
        value = value * Dyadic::from(1 << 32) + if next() % 2 == 0 { limb } else { -limb };
    }
    value
}

/// The number as a dyadic one.
fn back<const N: usize>(value: &Narrow<N>) -> Option<Dyadic> {
    let base = Dyadic::from(1 << 32) * Dyadic::from(1 << 32);
    let limb = |limb: u64| {
        let [high, low] = [limb >> 32, limb & 0xffff_ffff].map(|x| Dyadic::from(x.cast_signed()));
        high * Dyadic::from(1 << 32) + low
    };
    let sum = value.limbs.iter().rfold(Dyadic::from(0), |sum, &x| sum * &base + limb(x));
    (!value.lost).then_some(if value.negative { -sum } else { sum })
}

#[test]
fn sums_and_products_are_those_of_dyadic_numbers_or_lost() {
    let (mut seed, mut lost, mut zeros) = (1, 0, 0);
    for _ in 0..20_000 {
        let (a, mut b) = (value(&mut seed), value(&mut seed));
        match seed >> 60 {
            0 => b = a.clone(),
            1 => b = -a.clone(),
            _ => {}
        }
        let (x, y) = (Narrow::<6>::aligned(&a, 0), Narrow::<6>::aligned(&b, 0));
        for (narrow, exact) in [
            (x, a.clone()),
            (-x, -a.clone()),
            (x + y, a.clone() + &b),
            (x - y, a.clone() - &b),
            (x * y, a.clone() * &b),
            (x * y - x, a.clone() * &b - &a),
        ] {
            let Some(narrow_value) = back(&narrow) else {
                lost += 1;
                assert_eq!(narrow.sign(), None);
                let bits = 64 * i64::try_from(exact.mantissa().len()).unwrap() + exact.exponent();
                assert!(bits > 4 * 64, "{exact:?} fits well");
                continue;
            };
            assert_eq!(narrow_value, exact);
            assert_eq!(narrow.sign(), Some(exact.sign()));
            assert_eq!(narrow.is_zero(), exact.sign() == Sign::Zero);
            assert!(!narrow.is_zero() || narrow == Narrow::ZERO, "one zero");
            zeros += usize::from(narrow.is_zero());
        }
    }
    assert!(lost > 1000 && zeros > 1000, "{lost} {zeros}");
}

#[test]
fn what_is_computed_from_a_lost_number_is_lost() {
    let big = Narrow::<2>::one() + Narrow::one();
    let lost = (0..8).fold(big, |power, _| power * power);
    for number in [lost, -lost, lost - lost, lost + Narrow::one(), lost * Narrow::zero()] {
        assert_eq!(number.sign(), None);
        assert!(number.is_lost() && !number.is_zero() && !number.is_one());
    }
}

#[test]
fn alignment_shifts_or_loses() {
    let value = Dyadic::from(-5.5);
    assert_eq!(back(&Narrow::<3>::aligned(&value, -1)), Some(Dyadic::from(-11)));
    let shifted = Narrow::<3>::aligned(&value, -60);
    assert_eq!(back(&shifted), Some(value.clone() * Dyadic::from(1 << 60)));
    assert_eq!(shifted.len, 1);
    assert_eq!(back(&Narrow::<3>::aligned(&value, -64)).map(|x| x.exponent()), Some(63));
    assert!(Narrow::<3>::aligned(&value, -2000).is_lost());
    assert!(Narrow::<3>::aligned(&Dyadic::ZERO, -2000).is_zero());
}
