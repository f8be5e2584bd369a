use super::*;
use crate::numeric::scaling::binary_exponent;
use proptest::prelude::*;

#[test]
fn roots_worked_out_by_hand() {
    let root = |v: f64| Dyadic::from_f64(v).root_above();
    assert_eq!(root(0.0), Dyadic::zero());
    assert_eq!(root(12.25), Dyadic::from_f64(3.5));
    assert!(root(8.0) * root(8.0) > Dyadic::from_f64(8.0));
    assert_eq!(root(2.0).to_f64(), 2.0f64.sqrt());
    // of the square of the least double, which is no double
    let least = Dyadic::from_f64(f64::from_bits(1));
    assert_eq!((&least * &least).root_above(), least);
}

#[test]
fn extremes_are_exact() {
    let tiny = Dyadic::from_f64(f64::from_bits(1));
    let huge = Dyadic::from_f64(f64::MAX);
    assert_eq!(&(&huge + &tiny) - &huge, tiny);
    assert_eq!(tiny.to_f64(), f64::from_bits(1));
    assert!(((&huge * &huge).ratio(&huge) / f64::MAX - 1.0).abs() < 1e-15);
    assert_eq!((&huge * &huge).to_f64(), f64::INFINITY);
    assert!(tiny.ratio(&Dyadic::zero()).is_nan());
}

#[test]
fn ratios_outlive_the_common_factor() {
    let mut numbers = [0.0, -0.75, 1.5, 9e-300].map(Dyadic::from_f64);
    let ratio = numbers[3].ratio(&numbers[1]);
    remove_common_factor(&mut numbers);
    assert!(numbers[0].is_zero() && numbers[2] == -(&numbers[1] + &numbers[1]));
    assert_eq!(numbers[3].ratio(&numbers[1]), ratio);
    let mut few = [6.0, -9.0].map(Dyadic::from_f64);
    remove_common_factor(&mut few);
    assert_eq!(few, [2.0, -3.0].map(Dyadic::from_f64));
}

properties! {
    #[test]
    fn doubles_go_round(bits in any::<u64>()) {
        let value = f64::from_bits(bits);
        prop_assume!(value.is_finite());
        prop_assert_eq!(Dyadic::from_f64(value).binary_exponent(), binary_exponent(value).map(i64::from));
        let error = (Dyadic::from_f64(value).to_f64() - value).abs();
        prop_assert!(error <= value.abs() * 2f64.powi(-50) + f64::from_bits(1));
    }

    #[test]
    fn agrees_with_rationals(a in -1e300..1e300f64, b in -1e-300..1e-300f64, c in -10.0..10.0f64) {
        let [a, b, c] = [a, b, c].map(Dyadic::from_f64);
        for number in [&a * &b, -(&a * &b), &a * &a * c.clone(), &(&a * &a) - &b, &b - &(&a * &(&a * &a))] {
            let (head, exponent) = number.leading();
            let bits = number.mantissa.clone().unsigned_abs().to_string().len();
            let by_shift = number.mantissa.clone() >> (exponent - number.exponent) as usize;
            prop_assert_eq!(i64::try_from(by_shift).expect("63 bits") as f64, head);
            prop_assert!(bits < 20 || head.abs() >= 2f64.powi(62));
        }
        prop_assert_eq!(a.cmp(&c), a.to_rational().cmp(&c.to_rational()));
        let scaled = c.clone().scaled(900);
        prop_assert_eq!(a.cmp(&scaled), a.to_rational().cmp(&scaled.to_rational()));
        let exact = (&(&a * &b) - &c).to_rational();
        prop_assert_eq!(exact, a.to_rational() * b.to_rational() - c.to_rational());
    }
}

#[test]
fn numbers_are_equal_where_their_values_are() {
    let double = Dyadic::from_f64;
    let numbers = [double(-3.0), double(-1.0), Dyadic::zero(), double(1.0), double(1.5), double(3.0)];
    for (i, a) in numbers.iter().enumerate() {
        for (k, b) in numbers.iter().enumerate() {
            assert!((a == b) == (i == k) && a.cmp(b) == i.cmp(&k));
        }
    }
    assert_eq!(Dyadic::new(12.into(), -1), Dyadic::new(3.into(), 1));
    assert_eq!((Dyadic::zero().binary_exponent(), Dyadic::one().binary_exponent()), (None, Some(0)));
}

#[test]
fn units_are_counted_downwards() {
    let number = Dyadic::new((-7).into(), 3);
    let units = |exponent| number.units(exponent);
    assert_eq!([units(0), units(3), units(4), units(5), units(9)], [-56, -7, -4, -2, -1].map(IBig::from));
    assert_eq!(Dyadic::new(7.into(), 3).units(4), IBig::from(3));
    assert_eq!(Dyadic::zero().units(-5), IBig::ZERO);
}

#[test]
fn roots_are_rounded_up_by_less_than_a_unit_of_64_bits() {
    for (bits, exponent) in (1..200usize).flat_map(|bits| [-1075, -2, -1, 0, 1, 776].map(|exponent| (bits, exponent))) {
        let power = IBig::ONE << (bits - 1);
        for mantissa in [power.clone(), &power + IBig::ONE, (power << 1) - IBig::ONE] {
            let square = Dyadic::new(mantissa, exponent);
            let root = square.root_above();
            let unit = Dyadic::one().scaled(root.exponent());
            let shorter = &root - &unit;
            assert!(&shorter * &shorter < square && square <= &root * &root, "{square:?}");
            let most = if square.bits() <= 128 { 65 } else { square.bits().div_euclid(2) + 2 };
            assert!((64..=most).contains(&root.bits()), "{square:?}");
        }
    }
}

#[test]
fn leading_bits_are_cut_downwards_before_they_are_rounded() {
    // 63 bits in the middle of two doubles, which a cut below zero moves away from it
    let middle = (IBig::ONE << 62) + IBig::from(1 << 9);
    let [even, next] = [0, 1 << 10].map(|more| ((1i64 << 62) + more) as f64);
    for shift in [0, 1, 3, 64, 65, 66, 129, 200] {
        let number = &middle << shift;
        let exponent = shift as i64;
        assert_eq!(Dyadic::new(number.clone(), 0).leading(), (even, exponent));
        assert_eq!(Dyadic::new(-&number, 0).leading(), (-even, exponent));
        if shift > 0 {
            assert_eq!(Dyadic::new(&number + IBig::ONE, 0).leading(), (even, exponent));
            assert_eq!(Dyadic::new(-(&number + IBig::ONE), 0).leading(), (-next, exponent));
        }
    }
}

#[test]
fn rounded_ratios_reach_the_largest_double() {
    let mut beyond = 0;
    let mut divisor = 1.0;
    for _ in 0..200 {
        divisor = (divisor * 1.37) % 8.0 + 0.1;
        let exact = Dyadic::from_f64(divisor) * Dyadic::from_f64(1.0 / divisor);
        let number = Dyadic::from_f64(f64::MAX) * exact.clone();
        beyond += usize::from(number.ratio(&exact).is_infinite());
        assert_eq!(number.rounded_ratio(&exact), f64::MAX);
        assert_eq!((-number.clone()).rounded_ratio(&exact), -f64::MAX);
        assert_eq!(number.scaled(1).rounded_ratio(&exact), f64::INFINITY);
    }
    assert!(beyond > 10, "{beyond}");
    assert!(Dyadic::one().rounded_ratio(&Dyadic::zero()).is_nan());
}

properties! {
    #[test]
    fn rounded_ratios_are_off_by_little_more_than_half_a_unit(
        a in -1e100..1e100f64, b in -1e-90..1e100f64, c in 1e-100..1e-90f64, digits in any::<i64>(),
    ) {
        let [a, b, c] = [a, b, c].map(Dyadic::from_f64);
        let divisor = &b * &c + Dyadic::new(digits.into(), -500);
        let ratio = a.rounded_ratio(&divisor);
        let unit = Dyadic::from_f64(ratio.abs().next_up()) - Dyadic::from_f64(ratio.abs());
        let left = (&a - &(&divisor * &Dyadic::from_f64(ratio))).abs();
        prop_assert!(left <= (unit * divisor.abs()).scaled(-1) * Dyadic::from_f64(1.0 + 1e-10));
    }
}
