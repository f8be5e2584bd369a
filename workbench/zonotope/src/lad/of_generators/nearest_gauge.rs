//! The gauge to the last digits: a decision leaves it within a bound that is enough for the decision, while an answer
//! that is handed to others is compared, stored and subtracted.
//!
//! The gauge is u · p / h(u) at the optimal direction u, the exact product of two generators. One pass in pairs of
//! doubles knows that quotient far beyond a double, however much cancels in it, or the sums of a structure know it
//! exactly. Where the direction is only nearly optimal, the gauge is at most 1 + `slack` times as large; where that
//! leaves a doubt, or the pairs do, exact arithmetic answers.

use super::certify::gauge_interval::DecidedOptimum;
use super::exact::solve::exact_gauge;
use super::generators::KernelQuery;
use super::ladder::exact_of;
use super::optimum::Optimum;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, dot};
use crate::numeric::lanes::absolute_sum_in_pairs;
use crate::numeric::tolerance::{FIVE_ROUNDINGS, NEAREST_GAUGE};
use crate::tally::{Operation, Tally};

/// The gauge, with a bound for its error of at most [`NEAREST_GAUGE`] times its value, unless it is infinite or leaves
/// the range of normal doubles. One pass, rarely exact arithmetic for every generator.
pub(crate) fn nearest_gauge(query: &dyn KernelQuery, optimum: &Optimum, tally: &mut dyn Tally) -> (f64, f64) {
    match optimum {
        Optimum::Rounded(decided) => near_optimum(query, decided, tally)
            .unwrap_or_else(|| exact_of(query, &query.exact(), decided, tally).gauge()),
        Optimum::Flat(flat) => nearest_gauge(&flat.prism.query(), &flat.optimum, tally),
        Optimum::Centre | Optimum::Separated(_) | Optimum::Exact(_) => optimum.gauge(),
    }
}

/// The gauge from the direction of a rounded optimum, if it is known well enough.
fn near_optimum(query: &dyn KernelQuery, decided: &DecidedOptimum, tally: &mut dyn Tally) -> Option<(f64, f64)> {
    let slack = Some(decided.least_slack(query)).filter(|slack| *slack <= NEAREST_GAUGE / 4.0)?;
    let direction = scaled(decided.optimum.exact_direction(query));
    let p = query.exact();
    let along = dot(&p, &direction);
    let (value, error) = match query.exact_sum_along(&direction) {
        Some(sum) => exact_gauge(&along, &dot(&sum, &direction)),
        None => {
            tally.add(Operation::GeneratorRead, query.len() as u64);
            let reach = support(query, &direction);
            let quotient = (BoundedDoubleDouble::of(&along) / reach).rounded();
            (quotient.value, quotient.error)
        }
    };
    let error = (error + (value + error) * slack) * FIVE_ROUNDINGS;
    (error <= NEAREST_GAUGE * value).then_some((value, error))
}

/// h(u), to twice the digits of a double.
fn support(query: &dyn KernelQuery, direction: &ExactVector) -> BoundedDoubleDouble {
    query.parts().iter().fold(BoundedDoubleDouble::exact(0.0), |sum, part| {
        if part.rows.is_empty() {
            return sum;
        }
        let pulled = part.exact_pulled(direction).each_ref().map(BoundedDoubleDouble::of);
        sum + absolute_sum_in_pairs(part.rows, &pulled)
    })
}

/// A direction, not zero, times the power of two that makes its largest coordinate about 1.
fn scaled(direction: ExactVector) -> ExactVector {
    let exponent = direction.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
    direction.map(|c| c.scaled(-exponent))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lad::of_generators::exact::solve::ExactOptimum;
    use crate::lad::of_generators::goal::Goal;
    use crate::lad::of_generators::solve;
    use crate::numeric::exact_linear::exact;
    use crate::zonotope::query::Query;
    use proptest::prelude::*;

    /// The nearest double to the gauge, by exact arithmetic on all generators.
    fn truth(query: &Query<'_, 3>, p: [f64; 3]) -> f64 {
        ExactOptimum::of_whole(query, &exact(p), None, &mut ()).gauge().0
    }

    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![
            6 => -1.0..1.0f64,
            2 => (-3i32..=3).prop_map(f64::from),
            1 => (-1.0..1.0f64).prop_map(|x| x * 1e-9),
            1 => (-1.0..1.0f64).prop_map(|x| x * 1e12),
        ]
    }

    proptest! {
        #![proptest_config(crate::property_cases::config(400))]

        #[test]
        fn the_gauge_is_known_to_its_last_digits(
            mut body in proptest::collection::vec(proptest::array::uniform3(number()), 3..40),
            p in proptest::array::uniform3(number()),
            height in prop_oneof![2 => Just(1.0), 1 => Just(1e-6), 1 => Just(1e-13), 1 => Just(0.0)],
        ) {
            body.iter_mut().for_each(|v| v[2] *= height);
            let p = [p[0], p[1], p[2] * height];
            let query = Query::new([0.0; 3], p, &body).expect("finite");
            let (value, error) = nearest_gauge(&query, &solve(&query, Goal::Gauge, &mut ()), &mut ());
            let truth = truth(&query, p);
            if truth.is_finite() {
                prop_assert!((value - truth).abs() <= 2.0 * NEAREST_GAUGE * truth, "{value} ± {error:e}, not {truth}");
                prop_assert!(error <= NEAREST_GAUGE * value, "{value} ± {error:e}");
            } else {
                prop_assert_eq!(value, truth);
            }
        }
    }
}
