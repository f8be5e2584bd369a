//! Every method against the truth on generated points and directions.

use proptest::prelude::*;

use super::*;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;

fn rational(value: f64) -> Rational {
    Dyadic::from_f64(value).to_rational()
}

/// The answer is proven, infeasible just when the truth is, and within a relative 1e-12 of it if `is_tight`.
fn check<const D: usize>(
    points: &[[f64; D]],
    directions: &[[f64; D]],
    weights: &[f64],
    is_tight: bool,
) -> Result<(), TestCaseError> {
    let problem = FixedDirections::new(points, directions, weights).expect("valid");
    let truth = brute_force::least_length(&problem);
    let answer = match least_enclosing(&problem) {
        Err(error) => {
            prop_assert_eq!(error, FixedDirectionsError::OutOfRange);
            return Ok(());
        }
        Ok(answer) => answer,
    };
    prop_assert!(verify::verify(&problem, &answer).is_ok(), "{:?} {:?}", verify::verify(&problem, &answer), answer);
    prop_assert_eq!(answer.optimal().is_some(), truth.is_some());
    if let (Some(answer), Some(truth)) = (answer.optimal(), truth) {
        let excess = rational(answer.value) - &truth.value;
        let allowed = &truth.value * rational(1e-12);
        prop_assert!(
            !is_tight || excess <= allowed,
            "{} of {:e} {:?}",
            answer.value,
            truth.value.to_f64_fast(),
            answer
        );
        prop_assert!(rational(answer.lower_bound) <= truth.value);
        let short = &truth.value - rational(answer.lower_bound);
        prop_assert!(
            !is_tight || short <= allowed,
            "{} of {:e} {:?}",
            answer.lower_bound,
            truth.value.to_f64_fast(),
            answer
        );
    }
    Ok(())
}

fn lattice<const D: usize>(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[f64; D]>> {
    proptest::collection::vec(proptest::array::uniform((-3i8..4).prop_map(f64::from)), count)
}

fn real<const D: usize>(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[f64; D]>> {
    proptest::collection::vec(proptest::array::uniform(-1.0..1.0f64), count)
}

const WEIGHTS: [f64; 8] = [1.0, 2.0, 1.0, 0.5, 1.0, 3.0, 1.0, 1.0];

macro_rules! dimensions {
    ($($name:ident: $d:literal, $least:literal, $most:literal;)*) => {$(
        mod $name {
            use super::*;

            proptest! {
                #![proptest_config(ProptestConfig::with_cases(150))]

                #[test]
                fn real_points_and_directions(points in real::<$d>(1..12), directions in real::<$d>($least..$most)) {
                    check(&points, &directions, &WEIGHTS[..directions.len()], true)?;
                }

                #[test]
                fn lattices(points in lattice::<$d>(1..9), directions in lattice::<$d>(0..$most)) {
                    check(&points, &directions, &WEIGHTS[..directions.len()], true)?;
                }

                #[test]
                fn weights_may_be_zero(
                    points in lattice::<$d>(1..5), directions in lattice::<$d>(0..5), free in any::<[bool; 5]>(),
                ) {
                    let weights: Vec<f64> = free.iter().take(directions.len()).map(|f| f64::from(u8::from(!f))).collect();
                    check(&points, &directions, &weights, true)?;
                }

                #[test]
                fn scales(
                    points in real::<$d>(1..7), directions in real::<$d>($least..$most),
                    s in prop_oneof![Just(1e-200), Just(1e200), Just(1e-300), Just(1e300), Just(1e-3)],
                    t in prop_oneof![Just(1e-100), Just(1e100), Just(1.0)],
                ) {
                    let points: Vec<[f64; $d]> = points.iter().map(|p| p.map(|c| c * s)).collect();
                    let directions: Vec<[f64; $d]> = directions.iter().map(|p| p.map(|c| c * t)).collect();
                    let is_normal = s / t > 1e-290;
                    check(&points, &directions, &WEIGHTS[..directions.len()], is_normal)?;
                }

                #[test]
                fn the_smallest_doubles(points in lattice::<$d>(1..7), directions in lattice::<$d>($least..$most), fine in 1i8..9) {
                    let tiny = |v: [f64; $d]| v.map(|c| c * f64::from(fine) * f64::from_bits(1));
                    let points: Vec<[f64; $d]> = points.into_iter().map(tiny).collect();
                    let directions: Vec<[f64; $d]> = directions.into_iter().map(tiny).collect();
                    check(&points, &directions, &WEIGHTS[..directions.len()], false)?;
                }

                #[test]
                fn all_scales_at_once(
                    points in lattice::<$d>(1..6), directions in lattice::<$d>($least..5),
                    s in proptest::collection::vec(prop_oneof![Just(1e-150), Just(1e150), Just(1e-9), Just(1.0)], 12),
                ) {
                    let points: Vec<[f64; $d]> = points.iter().zip(&s).map(|(p, s)| p.map(|c| c * s)).collect();
                    let directions: Vec<[f64; $d]> = directions.iter().zip(&s[6..]).map(|(p, s)| p.map(|c| c * s)).collect();
                    check(&points, &directions, &WEIGHTS[..directions.len()], false)?;
                }
            }
        }
    )*};
}

dimensions! {
    on_the_line: 1, 1, 5;
    in_the_plane: 2, 2, 8;
    in_space: 3, 3, 7;
    in_four_dimensions: 4, 4, 7;
}

#[test]
fn flat_zonotopes_and_points_off_them_by_rounding() {
    let points = [[0.0, 3.0, -2.0, 3.0], [0.0, 2.0, 3.0, -3.0], [1.0, 1.0, 1.0, -2.0]];
    let directions = [[0.0, 0.0, 1.0, 0.0], [-1.0, 0.0, -1.0, 1.0], [3.0, 0.0, 0.0, 0.0], [0.0, 3.0, 1.0, 2.0]];
    check(&points, &directions, &[0.0, 1.0, 1.0, 1.0], true).expect("the three others hold a triangle");
    let points = [[3.0, -2.0, -2.0], [0.0, 0.0, 0.0], [3.0, 0.0, -2.0]];
    let directions = [[-3.0, 1.0, 2.0], [0.0, 0.0, 1.0], [3.0, 2.0, -2.0]];
    check(&points, &directions, &[1.0; 3], true).expect("two of the three hold a triangle");
}

#[test]
fn what_free_directions_reach_costs_nothing() {
    let points = [[1.0, 3.0, -3.0], [-3.0, -3.0, 3.0]];
    check(&points, &[[2.0, 3.0, -3.0], [-3.0, 0.0, -2.0]], &[0.0, 1.0], true).expect("the first one holds both");
}
