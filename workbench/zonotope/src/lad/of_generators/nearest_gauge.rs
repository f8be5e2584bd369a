//! The gauge to the last digits: a decision leaves it within a bound that is enough for the decision, while an answer
//! that is handed to others is compared, stored and subtracted.
//!
//! The gauge is u · p / h(u) at the optimal direction u, the exact product of two generators. One pass in pairs of
//! doubles knows that quotient far beyond a double: it sums up the generators with the signs of their products with u,
//! or, where rounding leaves a sign open, the products, with u in pairs or in integers; or a structure knows the sums.
//! The coefficients of the two generators of u, from the sum with signs, are in [−1, 1] where u is optimal. Where they
//! are ε beyond, as at an edge of a facet, the gauge is at most 1 + ε s times as large, and s bounds the gauges of the
//! two. The middle of that interval is returned. Where the interval is wide, exact arithmetic answers.

use super::certify::rounded_optimum::DecidedOptimum;
use super::certify::unit_gauge_bound::unit_gauge_bound;
use super::exact::solve::exact_gauge;
use super::ladder::exact_of;
use super::optimum::Optimum;
use super::seam::kernel_query::KernelQuery;
use super::seam::part::{Part, of_row};
use crate::numeric::combined_sum::combined_sum;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{self, ExactVector};
use crate::numeric::lanes::number::product;
use crate::numeric::lanes::{absolute_sum_in_pairs, extreme_sum_in_pairs};
use crate::numeric::linear::{cross, dot};
use crate::numeric::tolerance::{FIVE_ROUNDINGS, NARROW_SLACK, NEAREST_GAUGE, UNIT};
use crate::tally::{Operation, Tally};

/// The thickness of the body is bounded from one generator in 16 first, then from all.
const THICKNESS_SHARES: [usize; 2] = [16, 1];

/// Coefficients that are beyond ±1 by so much are not those of the facet in which the ray leaves the body.
const EXCESS_LIMIT: f64 = 1e-6;

/// A vector known by pairs of doubles.
type PairVector = [BoundedDoubleDouble; 3];

/// The gauge, with a bound for its error of at most [`NEAREST_GAUGE`] times its value, unless it is infinite or leaves
/// the range of normal doubles. At most two passes, rarely exact arithmetic for every generator.
pub(crate) fn nearest_gauge(query: &dyn KernelQuery, optimum: &Optimum, tally: &mut dyn Tally) -> (f64, f64) {
    match optimum {
        Optimum::Rounded(decided) => near_optimum(query, decided, tally)
            .unwrap_or_else(|| exact_of(query, &query.exact(), decided, tally).gauge()),
        Optimum::Flat(flat) => nearest_gauge(&flat.prism.query(), &flat.optimum, tally),
        Optimum::Center | Optimum::Separated(_) | Optimum::Ended | Optimum::Exact(_) => optimum.gauge(),
    }
}

/// The gauge from the direction of a rounded optimum, if it is known well enough: in pairs of doubles, and where these
/// do not know the direction, or whoever holds the generators knows exact sums of them, with the exact direction.
fn near_optimum(query: &dyn KernelQuery, decided: &DecidedOptimum, tally: &mut dyn Tally) -> Option<(f64, f64)> {
    if decided.optimum.is_near_vertex() {
        return None;
    }
    if !query.has_exact_sums() {
        let optimum = &decided.optimum;
        let is_usual = optimum.missing == 0.0 && optimum.shares.is_empty();
        let by_signs = if is_usual { gauge_by_pair(query, optimum.basis, tally) } else { None };
        if let Some(found) = by_signs.or_else(|| along_pairs(query, decided, tally)) {
            return Some(found);
        }
    }
    along_exact(query, decided, tally)
}

/// The gauge of a displacement whose ray leaves the body through the facet that two generators span, of which nothing
/// has to be known beforehand; none where it does not, or another generator is so nearly parallel to the facet that its
/// sign is not certain. One pass.
pub(crate) fn gauge_by_pair(query: &dyn KernelQuery, basis: [usize; 2], tally: &mut dyn Tally) -> Option<(f64, f64)> {
    let (parts, p) = (query.parts(), query.displacement_pairs());
    let pair = basis.map(|index| of_row(&parts, index, Part::image_in_pairs));
    let normal = cross(&pair[0], &pair[1]);
    let direction = if dot(&p, &normal).sign()? < 0 { normal.map(BoundedDoubleDouble::negated) } else { normal };
    tally.add(Operation::GeneratorRead, query.len() as u64);
    let of_part = |part: &Part<'_>| extreme_sum_in_pairs(part.rows, &part.pair_pulled(&direction));
    let sums = parts.each_ref().map(of_part);
    // the two themselves are orthogonal to the direction
    if sums[0].doubtful + sums[1].doubtful > basis.len() {
        return None;
    }
    let [own, others] = [0, 1].map(|k| parts[k].pair_image(&sums[k].sum));
    let rounded = |part: &Part<'_>| part.pair_pulled(&direction).map(|c| c.high);
    let sign = |index| of_row(&parts, index, |part, v| product(v, &rounded(part)).signum());
    let signs = basis.map(|index| BoundedDoubleDouble::exact(sign(index)));
    let sum = [0, 1, 2].map(|k| own[k] + others[k] - pair[0][k] * signs[0] - pair[1][k] * signs[1]);
    let reach = dot(&sum, &direction);
    let quotient = (dot(&p, &direction) / reach).rounded();
    within(quotient.value, quotient.error, Beyond::new(&sum, &pair, &p, &direction, reach).narrow_slack(query))
}

/// The gauge from the direction in pairs of doubles. One pass, and a second one where the vertex is not certain.
fn along_pairs(query: &dyn KernelQuery, decided: &DecidedOptimum, tally: &mut dyn Tally) -> Option<(f64, f64)> {
    let optimum = &decided.optimum;
    let pair = optimum.basis.map(|index| of_row(&query.parts(), index, Part::image_in_pairs));
    let normal = cross(&pair[0], &pair[1]);
    let direction = if optimum.reversed { normal.map(BoundedDoubleDouble::negated) } else { normal };
    let p = query.displacement_pairs();
    tally.add(Operation::GeneratorRead, query.len() as u64);
    let reach = support(query, |part| part.pair_pulled(&direction));
    let quotient = (dot(&p, &direction) / reach).rounded();
    let slack = if optimum.is_vertex() {
        0.0
    } else {
        tally.add(Operation::GeneratorRead, query.len() as u64);
        Beyond::new(&signed_sum(query, decided), &pair, &p, &direction, reach).narrow_slack(query)
    };
    within(quotient.value, quotient.error, slack)
}

/// The gauge from the exact direction.
fn along_exact(query: &dyn KernelQuery, decided: &DecidedOptimum, tally: &mut dyn Tally) -> Option<(f64, f64)> {
    let optimum = &decided.optimum;
    let direction = scaled(optimum.exact_vertex(query));
    let p = query.exact();
    let along = exact_linear::dot(&p, &direction);
    let summed = query.exact_sum_along(&direction);
    let (value, error, reach) = match &summed {
        Some(sum) => {
            let reach = exact_linear::dot(sum, &direction);
            let (value, error) = exact_gauge(&along, &reach);
            (value, error, BoundedDoubleDouble::of(&reach))
        }
        None => {
            tally.add(Operation::GeneratorRead, query.len() as u64);
            let reach = support(query, |part| in_pairs(&part.exact_pulled(&direction)));
            let quotient = (BoundedDoubleDouble::of(&along) / reach).rounded();
            (quotient.value, quotient.error, reach)
        }
    };
    let slack = if optimum.is_vertex() {
        0.0
    } else {
        let sum = match summed {
            Some(sum) => in_pairs(&sum),
            None => {
                tally.add(Operation::GeneratorRead, query.len() as u64);
                signed_sum(query, decided)
            }
        };
        let pair = optimum.basis.map(|index| in_pairs(&query.exact_generator(index)));
        Beyond::new(&sum, &pair, &in_pairs(&p), &in_pairs(&direction), reach).narrow_slack(query)
    };
    within(value, error, slack)
}

/// The gauge and a bound of its error, from a value within an error that the gauge exceeds by at most the part `slack`
/// of it: the middle of what the slack leaves open, if that is known well enough.
fn within(value: f64, error: f64, slack: f64) -> Option<(f64, f64)> {
    let half = if slack > NARROW_SLACK { slack / 2.0 } else { 0.0 };
    let middle = value * (1.0 + half);
    let error = (error + (value + error) * (slack - half) + middle * UNIT) * FIVE_ROUNDINGS;
    // false for NaN as well
    (error <= NEAREST_GAUGE * middle).then_some((middle, error))
}

/// The part that the proof of a vertex of doubles lacks: with S the sum of all generators but a and b with their signs
/// at u = ±a × b, and λ = S · u / p · u, coefficients δ_a and δ_b make S + δ_a a + δ_b b = λ p. So the gauge of λ p is
/// at most 1 and the gauges of what the coefficients exceed ±1 by.
struct Beyond {
    /// The excess of each coefficient over 1, times |v|_1 of its generator, and beside it the excess alone.
    terms: [[f64; 2]; 2],
    /// h(u) over S · u, less 1.
    missing: f64,
}

impl Beyond {
    fn new(
        sum: &PairVector,
        [a, b]: &[PairVector; 2],
        p: &PairVector,
        u: &PairVector,
        reach: BoundedDoubleDouble,
    ) -> Self {
        let volume = dot(p, &cross(a, b)).abs();
        let excess = |dual: &PairVector| ((dot(sum, dual).abs() - volume) / volume).interval().1.max(0.0);
        let length = |v: &PairVector| v.iter().map(|c| c.high.abs()).sum::<f64>();
        let term = |v: &PairVector, excess: f64| [excess * length(v) * FIVE_ROUNDINGS, excess];
        let signed = dot(sum, u);
        Self {
            terms: [term(a, excess(&cross(b, p))), term(b, excess(&cross(p, a)))],
            missing: ((reach - signed) / signed).interval().1.max(0.0),
        }
    }

    /// A bound of the gauge over u · p / h(u), less 1, where that of any x is at most `size` times |x|_1; that of a
    /// generator is at most 1.
    fn slack(&self, size: f64) -> f64 {
        let beyond: f64 = self.terms.iter().map(|[length, alone]| (length * size).min(*alone)).sum();
        (beyond + self.missing + beyond * self.missing) * FIVE_ROUNDINGS
    }

    /// The slack, with a bound of the gauge of any x where that is needed to make it narrow.
    fn narrow_slack(&self, query: &dyn KernelQuery) -> f64 {
        let mut slack = self.slack(1.0);
        for share in THICKNESS_SHARES {
            // two roundings are within the error of an answer, and what is far beyond is so with every bound
            if (2.0 * UNIT..EXCESS_LIMIT).contains(&slack) {
                slack = slack.min(self.slack(unit_gauge_bound(query, share)));
            }
        }
        slack
    }
}

/// The sum of all generators but the two of the vertex, with their signs or shares. One pass.
fn signed_sum(query: &dyn KernelQuery, decided: &DecidedOptimum) -> PairVector {
    let optimum = &decided.optimum;
    let mut coefficients = decided.cells.coefficients(query, &optimum.cell(), 1.0);
    for &(index, share) in &optimum.shares {
        coefficients[index] = share;
    }
    for &index in &optimum.basis {
        coefficients[index] = 0.0;
    }
    let mut rest = &coefficients[..];
    query.parts().iter().fold([BoundedDoubleDouble::exact(0.0); 3], |sum, part| {
        let (own, others) = rest.split_at(part.rows.len());
        rest = others;
        let own = part.pair_image(&combined_sum(part.rows, own));
        [0, 1, 2].map(|k| sum[k] + own[k])
    })
}

fn in_pairs(v: &ExactVector) -> PairVector {
    v.each_ref().map(BoundedDoubleDouble::of)
}

/// h(u) to twice the digits of a double, of a direction that is given as each part takes it.
fn support(query: &dyn KernelQuery, pulled: impl Fn(&Part<'_>) -> PairVector) -> BoundedDoubleDouble {
    query.parts().iter().fold(BoundedDoubleDouble::exact(0.0), |sum, part| {
        if part.rows.is_empty() {
            return sum;
        }
        sum + absolute_sum_in_pairs(part.rows, &pulled(part))
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

    properties! {
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
                prop_assert!((value - truth).abs() <= NEAREST_GAUGE * truth, "{value} ± {error:e}, not {truth}");
                prop_assert!(error <= NEAREST_GAUGE * value, "{value} ± {error:e}");
            } else {
                prop_assert_eq!(value, truth);
            }
        }
    }
}
