use super::*;
use crate::numeric::Rational;
use crate::numeric::scaling::power_of_two;
use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

type Fraction = (f64, f64);

fn exact((numerator, denominator): Fraction) -> Rational {
    Dyadic::from_f64(numerator).to_rational() / Dyadic::from_f64(denominator).to_rational()
}

fn approximate((numerator, denominator): Fraction) -> BoundedDoubleDouble {
    BoundedDoubleDouble::of_ratio(&Dyadic::from_f64(numerator), &Dyadic::from_f64(denominator))
}

fn holds(value: BoundedDoubleDouble, exact: &Rational) -> Result<(), TestCaseError> {
    if value.error == f64::INFINITY {
        return Ok(());
    }
    let rational = |v: f64| Dyadic::from_f64(v).to_rational();
    let (off, error) = (rational(value.high) + rational(value.low) - exact, rational(value.error));
    prop_assert!(off <= error && -off <= error, "{:?} is not {}", value, exact);
    let (low, high) = value.interval();
    prop_assert!(low == f64::NEG_INFINITY || rational(low) <= *exact, "{:?}", value);
    prop_assert!(high == f64::INFINITY || rational(high) >= *exact, "{:?}", value);
    Ok(())
}

fn fraction() -> impl Strategy<Value = Fraction> {
    let magnitude = prop_oneof![
        4 => -1.0..1.0f64,
        1 => -1e-300..1e-300f64,
        1 => -1e300..1e300f64,
        1 => (-3i32..4).prop_map(f64::from),
        1 => (-9i32..9).prop_map(|i| f64::from(i) * f64::from_bits(1)),
    ];
    let positive = magnitude.clone().prop_map(|v| if v == 0.0 { 1.0 } else { v.abs() });
    (magnitude, positive)
}

properties! {
    #![proptest_config(crate::property_cases::config(4000))]

    #[test]
    fn every_operation_keeps_its_bound(a in fraction(), b in fraction(), c in fraction()) {
        let (x, y, z) = (exact(a), exact(b), exact(c));
        let (p, q, r) = (approximate(a), approximate(b), approximate(c));
        holds(p, &x)?;
        holds(p + q, &(&x + &y))?;
        holds(p - q * r, &(&x - &y * &z))?;
        if y != z {
            holds((p - q) / (q - r), &((&x - &y) / (&y - &z)))?;
        }
        if let Some(sign) = (p * q - r).sign() {
            prop_assert_eq!(sign, (&x * &y).cmp(&z) as i8);
        }
        for exponent in [700, 3, 0, -1, -60, -890, -1500] {
            let numerator = Dyadic::from_f64(a.0).scaled(exponent).to_rational();
            holds(p.scaled(exponent), &(numerator / Dyadic::from_f64(a.1).to_rational()))?;
        }
        let number = Dyadic::from_f64(a.0) * Dyadic::from_f64(b.0) - Dyadic::from_f64(c.0);
        holds(BoundedDoubleDouble::of(&number), &number.to_rational())?;
        if let Some(order) = (p * q).certain_order(&(q * r)) {
            prop_assert_eq!(order, (&x * &y).cmp(&(&y * &z)));
        }
    }
}

#[test]
fn ordinary_values_are_good_to_90_bits() {
    let value = (approximate((1.0, 3.0)) - approximate((1.0, 7.0))) / approximate((5.0, 11.0));
    assert!(value.error < value.high * 2f64.powi(-90));
}

/// A number near 1, near 0, subnormal, large, or a small whole number, with an error that is none, a part of it, or
/// about as large.
fn operand(rng: &mut Pcg64Mcg) -> BoundedDoubleDouble {
    let exponent = match rng.random_range(0..8) {
        0 => rng.random_range(-1074..-960),
        1 => rng.random_range(300..490),
        2 => rng.random_range(-600..300),
        _ => rng.random_range(-4..4),
    };
    let high = match rng.random_range(0..6) {
        0 => f64::from(rng.random_range(-3i32..4)),
        _ => scale_by_power_of_two(rng.random_range(-2.0..2.0), exponent),
    };
    let low = if rng.random_ratio(1, 4) { 0.0 } else { high * UNIT * rng.random_range(-1.0..1.0) };
    let error = match rng.random_range(0..8) {
        0..3 => 0.0,
        3 => high.abs() * rng.random_range(0.5..1.5),
        _ => high.abs() * power_of_two(rng.random_range(-100..-2)),
    };
    BoundedDoubleDouble { high, low, error }
}

/// The exact values at both ends of the bound, and the sum of both doubles.
fn ends(x: &BoundedDoubleDouble) -> [Dyadic; 3] {
    [-x.error, 0.0, x.error].map(|off| x.to_dyadic() + Dyadic::from_f64(off))
}

/// All pairs of the exact values of two operands.
fn pairs<T>(
    x: &BoundedDoubleDouble,
    y: &BoundedDoubleDouble,
    operation: impl Fn(&Dyadic, &Dyadic) -> T + Copy,
) -> Vec<T> {
    let others = ends(y);
    ends(x).iter().flat_map(|x| others.iter().map(move |y| operation(x, y))).collect()
}

fn over_one(numerator: Dyadic) -> (Dyadic, Dyadic) {
    (numerator, Dyadic::one())
}

/// Holds a result to the exact fractions that it may be: each is within the bound, which is at most four times the
/// distance of the farthest one, the rounding of numbers of a size, and what may underflow.
fn is_good(result: &BoundedDoubleDouble, exact: &[(Dyadic, Dyadic)], size: &Dyadic) {
    let (value, error) = (result.to_dyadic(), Dyadic::from_f64(result.error));
    let off: Vec<_> = exact.iter().map(|(n, d)| ((n - &(&value * d)).abs(), d.clone().abs())).collect();
    assert!(off.iter().all(|(off, d)| *off <= &error * d), "{result:?}");
    let underflow = Dyadic::from_f64(UNDERFLOW);
    let rounding = &size.clone().scaled(-98) + &underflow;
    let is_explained = |(off, d): &(Dyadic, Dyadic)| &error * d <= (&(off + &(&rounding * d)) + &underflow).scaled(2);
    assert!(off.iter().any(is_explained), "{result:?}");
}

#[test]
fn bounds_are_at_most_four_times_what_the_operands_explain() {
    let mut rng = Pcg64Mcg::seed_from_u64(1);
    for _ in 0..3000 {
        let (x, y) = (operand(&mut rng), operand(&mut rng));
        let sizes = Dyadic::from_f64(x.high).abs() + Dyadic::from_f64(y.high).abs();
        is_good(&(x + y), &pairs(&x, &y, |x, y| over_one(x + y)), &sizes);
        is_good(&(x - y), &pairs(&x, &y, |x, y| over_one(x - y)), &sizes);
        let product = x * y;
        is_good(&product, &pairs(&x, &y, |x, y| over_one(x * y)), &product.to_dyadic().abs());
    }
}

#[test]
fn quotients_are_good_where_the_divisor_is_certainly_not_zero() {
    let mut rng = Pcg64Mcg::seed_from_u64(2);
    let mut known = 0;
    for _ in 0..3000 {
        let (x, y) = (operand(&mut rng), operand(&mut rng));
        let (quotient, [lowest, middle, highest]) = (x / y, ends(&y));
        let fractions = pairs(&x, &y, |x, y| (x.clone(), y.clone()));
        let may_be_zero = lowest.sign() != highest.sign() || middle.is_zero();
        if quotient.is_known() {
            known += 1;
            assert!(!may_be_zero, "{y:?}");
            is_good(&quotient, &fractions, &quotient.to_dyadic().abs());
        } else {
            let least = lowest.abs().min(highest.abs());
            let is_nearly_zero = may_be_zero || least < middle.abs().scaled(-30);
            assert!(is_nearly_zero || fractions.iter().any(|(n, d)| n.clone().abs() > d.clone().abs().scaled(990)));
        }
    }
    assert!(known > 1000);
}

#[test]
fn powers_of_two_scale_bounds_and_leave_only_an_error_of_what_vanishes() {
    let mut rng = Pcg64Mcg::seed_from_u64(3);
    for round in 0..2000 {
        let x = operand(&mut rng);
        let exponent = [-1500, -901, -900, -899, -60, 0, 3, 500][round % 8];
        let scaled = x.scaled(exponent);
        let exact = ends(&x).map(|end| over_one(end.scaled(exponent)));
        if exponent >= VANISHING {
            is_good(&scaled, &exact, &scaled.to_dyadic().abs());
        } else {
            let reach = ((Dyadic::from_f64(x.high).abs() + Dyadic::from_f64(x.error)).scaled(-900), Dyadic::one());
            is_good(&scaled, &[exact.as_slice(), &[reach]].concat(), &Dyadic::zero());
        }
    }
    let large = BoundedDoubleDouble::exact(power_of_two(900));
    for (exponent, sign) in [(VANISHING + 1, Some(1)), (VANISHING, Some(1)), (VANISHING - 1, None)] {
        assert_eq!(large.scaled(exponent).sign(), sign, "{exponent}");
    }
}

#[test]
fn magnitudes_and_doubles_of_a_number_are_good() {
    let mut rng = Pcg64Mcg::seed_from_u64(4);
    for _ in 0..3000 {
        let x = operand(&mut rng);
        let [lowest, middle, highest] = ends(&x);
        let most = lowest.clone().abs().max(highest.clone().abs());
        let largest = x.largest();
        assert_eq!((largest.low, largest.error), (0.0, 0.0));
        assert!(most <= largest.to_dyadic() && largest.to_dyadic() <= &most + &most.clone().scaled(-30), "{x:?}");
        assert_eq!(x.abs().to_dyadic(), middle.clone().abs());
        assert_eq!(x.negated().to_dyadic(), -middle);

        let rounded = x.rounded();
        let value = Dyadic::from_f64(rounded.value);
        let farthest = (&lowest - &value).abs().max((&highest - &value).abs());
        let error = Dyadic::from_f64(rounded.error);
        assert!(farthest <= error && error <= &farthest + &farthest.clone().scaled(-30), "{x:?}");

        let (low, high) = x.interval();
        let (low, high) = (Dyadic::from_f64(low), Dyadic::from_f64(high));
        assert!(low <= lowest && highest <= high, "{x:?}");
        let width = farthest + Dyadic::from_f64(x.high).abs().scaled(-53) + Dyadic::from_f64(f64::from_bits(1));
        assert!(&high - &low <= width.scaled(3), "{x:?}");
    }
}

#[test]
fn signs_are_told_where_zero_is_out_of_reach() {
    let mut rng = Pcg64Mcg::seed_from_u64(5);
    for round in 0..3000 {
        let mut x = operand(&mut rng);
        if round % 3 == 0 {
            x.error = x.high.abs() * (1.0 + rng.random_range(-1.0..1.0) * power_of_two(rng.random_range(-52..-20)));
        }
        let [lowest, _, highest] = ends(&x);
        match x.sign() {
            Some(sign) => assert_eq!([lowest, highest].map(|end| end.sign() as i8), [sign; 2], "{x:?}"),
            None => assert!(x.error >= x.high.abs() * (1.0 - power_of_two(-30)), "{x:?}"),
        }
    }
    assert_eq!([0.0, -0.0].map(|zero| BoundedDoubleDouble::exact(zero).sign()), [None; 2]);
    assert!(BoundedDoubleDouble::exact(0.0).abs().high.is_sign_positive());
}

#[test]
fn the_nearest_double_is_told_where_the_bounds_leave_one() {
    let mut rng = Pcg64Mcg::seed_from_u64(6);
    for round in 0..4000 {
        let high = if round % 2 == 0 { 1.0 } else { rng.random_range(1.0..2.0) };
        let high = if rng.random() { high } else { -high };
        let [part, share] = [(); 2].map(|()| rng.random_range(0.0..1.2f64));
        let low = if rng.random() { part.min(1.0) * UNIT } else { -part.min(0.5) * UNIT };
        let error = if round % 5 == 0 { 0.0 } else { share * UNIT };
        let x = BoundedDoubleDouble { high, low: low * high.signum(), error };
        let [lowest, _, highest] = ends(&x);
        let exact = |v: f64| Dyadic::from_f64(v);
        let [below, above] = [high.next_down(), high.next_up()].map(|other| (exact(high) + exact(other)).scaled(-1));
        match x.nearest_double() {
            Some(nearest) => assert!(nearest == high && below <= lowest && highest <= above, "{x:?}"),
            None => {
                // The bounds reach to the middle between neighbours, up or down, but for their rounding.
                let reach = exact(low).abs() + exact(error);
                let room = (exact(high) - below).min(above - exact(high));
                assert!(error > 0.0 && &reach + &reach.clone().scaled(-30) >= room, "{x:?}");
            }
        }
        if x.is_no_double() {
            assert!(highest < exact(high) || exact(high) < lowest, "{x:?}");
        }
    }
}

/// Holds the order of two numbers to that of the exact values that they may be.
fn is_well_ordered(x: &BoundedDoubleDouble, y: &BoundedDoubleDouble) {
    match x.certain_order(y) {
        Some(order) => assert!(pairs(x, y, |x, y| x.cmp(y)).iter().all(|other| *other == order), "{x:?} {y:?}"),
        None => {
            let distance = (x.to_dyadic() - y.to_dyadic()).abs();
            let reach = (Dyadic::from_f64(x.error) + Dyadic::from_f64(y.error)).scaled(1);
            let size = (Dyadic::from_f64(x.high).abs() + Dyadic::from_f64(y.high).abs()).scaled(-100);
            assert!(distance <= reach + size, "{x:?} {y:?}");
        }
    }
}

#[test]
fn orders_hold_for_all_exact_values_and_are_told_of_values_apart() {
    let mut rng = Pcg64Mcg::seed_from_u64(7);
    for round in 0..4000 {
        let x = operand(&mut rng);
        let mut y = operand(&mut rng);
        if round % 3 > 0 {
            y.high = if round % 3 == 1 { x.high } else { x.high.next_up() };
            y.low = x.high * UNIT * rng.random_range(-1.0..1.0);
            y.error = x.high.abs() * power_of_two(rng.random_range(-110..-50));
        }
        is_well_ordered(&x, &y);
        is_well_ordered(&y, &x);
    }
    for equal in [[0.0, 0.0], [-0.0, 0.0], [1.0, 1.0]] {
        let [x, y] = equal.map(BoundedDoubleDouble::exact);
        assert_eq!(x.certain_order(&y), None);
    }
}

#[test]
fn the_rounding_of_lower_doubles_is_in_the_bound_of_an_order() {
    // The lower doubles are nearly half a unit each, of the next double and of the one before.
    let place = UNIT * UNIT;
    for (a, b, quarters) in (0..8).flat_map(|a| (0..8).flat_map(move |b| (0..12).map(move |q| (a, b, q)))) {
        let lower = |places: i32| UNIT - f64::from(places) * place;
        let x = BoundedDoubleDouble { high: 1.0, low: lower(a), error: f64::from(quarters) * place / 2.0 };
        let y = BoundedDoubleDouble { high: 1.0 + 2.0 * UNIT, low: -lower(b), error: 0.0 };
        is_well_ordered(&x, &y);
        is_well_ordered(&y, &x);
    }
}

#[test]
fn nothing_is_known_where_doubles_end() {
    let exact = BoundedDoubleDouble::exact;
    let most = BoundedDoubleDouble { high: f64::MAX, low: 0.0, error: f64::MAX };
    let doubt = BoundedDoubleDouble { high: 1.0, low: 0.0, error: f64::MAX };
    let beyond = [
        most + most,
        doubt + doubt,
        most.largest(),
        exact(f64::MAX) * exact(1.0),
        exact(f64::MAX) * exact(2.0),
        exact(1.0) / exact(0.0),
        exact(0.0) / exact(0.0),
        exact(1.0).scaled(1500),
        BoundedDoubleDouble::of_parts(f64::MAX, f64::MAX, 0.0),
    ];
    for (place, value) in beyond.into_iter().enumerate() {
        assert!(!value.is_known() && value.high.is_nan(), "{place}: {value:?}");
        assert_eq!((value.sign(), value.certain_order(&exact(0.0)), value.nearest_double()), (None, None, None));
        assert_eq!(value.interval(), (f64::NEG_INFINITY, f64::INFINITY));
    }
}

#[test]
fn numbers_without_error_and_rest_are_doubles() {
    let [high, low] = [1.0, UNIT * UNIT];
    for (low, error, is_double) in [(0.0, 0.0, true), (low, 0.0, false), (0.0, low, false), (low, low, false)] {
        let number = BoundedDoubleDouble { high, low, error };
        assert!(number.is_known());
        assert_eq!(number.is_exactly_double(), is_double);
    }
}
