//! Many generators of which Σ v vᵀ is known from before, as it is of bodies that were prepared.
//!
//! The least coefficients v · y, with (Σ v vᵀ) y = p, are then to be had without a pass, and a sample of them says what
//! is worth a pass. Where it says that all are within (−1, 1), they are written. Where it says that p is farther out
//! but not near the boundary, they are scaled up and clipped: at once for three octets in four, whose sum is then off
//! by what the estimate of the scale is off. Every fourth octet makes up for that by Newton steps, each of which needs
//! the sums of a quarter of the generators. A step on all of them would cost as much as all of this.

use super::clipped_steps::{Effort, State, StepsEnd, inside, separates};
use super::combination::{Combination, Stretches};
use super::huber_dual::{Among, Lengths, SAMPLE_MARGIN, WELL_WITHIN, hessian_at_zero};
use super::scaled_products::ScaledProducts;
use super::{INSIDE_GAUGE, OUTSIDE_DEVIATIONS, OUTSIDE_GAUGE, locate_by_sample};
use crate::lad::of_generators::seam::generators::Generators;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::part::Part;
use crate::numeric::bounded::BoundedVector;
use crate::numeric::lanes::octet::LANES;
use crate::tally::{Operation, Rung, Tally};
use crate::zonotope::location::Proof;

/// Of more generators than this, coefficients are steered by a sample: that takes one pass over memory and not one and
/// a half.
const TWO_PARTS_LIMIT: usize = 1 << 13;

/// The most Newton steps of the fourth octets.
const QUARTER_STEPS: usize = 4;

/// The generators by which the largest coefficient is estimated.
const AMONG: Among<'static> = Among::First(64);

/// Products with the vectors here are coefficients as they stand.
const LENGTHS: Lengths = Lengths::Even(1.0);

/// Whether the sums of all generators are known, and no generator is so long that it needs a coefficient of its own.
#[inline]
pub(super) fn are_known(query: &impl KernelQuery) -> bool {
    let is_known = query.rows().iter().all(|rows| rows.is_empty() || rows.sums().is_some());
    is_known && Lengths::of(query) != Lengths::Own
}

/// The status of p with its proof, if p is far from the boundary.
pub(super) fn locate(query: &impl KernelQuery, p: &BoundedVector, tally: &mut dyn Tally) -> Option<Proof> {
    let (y, is_thick) = hessian_at_zero(query, LENGTHS).solve(&p.map(|c| c.value));
    if !is_thick {
        return locate_by_sample(query, p, tally);
    }
    let products = ScaledProducts::of(query, &y);
    tally.add(Operation::GeneratorRead, products.count() as u64);
    let gauge = products.gauge();
    if gauge > OUTSIDE_GAUGE + OUTSIDE_DEVIATIONS / (products.count() as f64).sqrt() {
        return separates(query, p, &y, tally).then(|| Proof::outside(y, Rung::SampledDirection));
    }
    if SAMPLE_MARGIN * products.largest() <= WELL_WITHIN
        && let Some(witness) = inside(query, p, &Combination::linear(y, LENGTHS), tally)
    {
        return Some(Proof::inside(witness, Rung::LeastSquares));
    }
    // false for NaN as well
    let is_well_inside = gauge < INSIDE_GAUGE;
    if !is_well_inside {
        return None;
    }
    if query.len() > TWO_PARTS_LIMIT {
        return locate_by_sample(query, p, tally);
    }
    let beyond = (1.0 + 1.0 / gauge) / 2.0;
    let factor = products.factor(beyond);
    let state = State::at(y.map(|c| factor * c), gauge);
    locate_in_two_parts(query, p, state, beyond, tally).or_else(|| state.prove(query, p, LENGTHS, AMONG, tally))
}

/// The proof of a member, from a y whose clipped coefficients sum up to about `beyond` p.
fn locate_in_two_parts(
    query: &impl KernelQuery,
    p: &BoundedVector,
    mut state: State,
    beyond: f64,
    tally: &mut dyn Tally,
) -> Option<Proof> {
    let n = query.len();
    tally.add(Operation::GeneratorRead, n as u64);
    let [first, last] = [0..3 * LANES, 3 * LANES..4 * LANES].map(|range| Stretches { period: 4 * LANES, range });
    let mut coefficients = vec![0.0; n];
    // (1 / beyond) clip(v · y) in one product
    let steady = Combination::clipped(&state.y().map(|c| c / beyond), LENGTHS, 1.0 / beyond);
    let written = steady.write_all(query, &first, &mut coefficients);
    let rest = [0, 1, 2].map(|k| p[k].value - written.sum[k]);
    let effort = Effort { steps: QUARTER_STEPS, exact: true };
    let StepsEnd::Inside(exact) = state.coefficients(&Quarter(query), LENGTHS, &rest, AMONG, effort) else {
        return None;
    };
    let written = written.with(&exact.write_all(query, &last, &mut coefficients));
    let witness = written.witness(query, p, coefficients)?;
    Some(Proof::inside(witness, Rung::StratifiedPass))
}

/// The generators of a query of which sums read the fourth octet of each four, a quarter of all.
#[derive(Debug)]
struct Quarter<'a, Q>(&'a Q);

impl<Q: KernelQuery> Generators for Quarter<'_, Q> {
    #[inline(always)]
    fn parts(&self) -> [Part<'_>; 2] {
        self.0.parts()
    }

    #[inline(always)]
    fn is_fixed() -> bool {
        Q::is_fixed()
    }

    #[inline(always)]
    fn share() -> usize {
        4
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::{Query, by_lad};
    use crate::interop::verifier::check_location;
    use crate::tally::OperationCounts;
    use crate::zonotope::{PreparedBody, Zonotope};
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    #[test]
    fn points_far_from_the_boundary_of_prepared_bodies_are_proved_in_few_passes() {
        let random = &mut Pcg64Mcg::seed_from_u64(3);
        for n in [330, 1100, 5000, 9000] {
            let mut counts = OperationCounts::default();
            let factors = [0.05, 0.3, 0.5, 0.6, 0.7, 0.75, 1.2, 3.0];
            for factor in factors {
                let mut vector = || [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
                let (body, direction) = ((0..n).map(|_| vector()).collect::<Vec<_>>(), vector());
                let gauge = by_lad::gauge(&Query::new([0.0; 3], direction, &body).expect("finite"), &mut ()).value;
                let p = direction.map(|c| factor / gauge * c);
                let halves = body.split_at(n / 3);
                let prepared = |center, half: &[[f64; 3]]| {
                    PreparedBody::new(Zonotope::new(center, half.to_vec()).expect("finite"))
                };
                let [a, b] = [prepared([0.0; 3], halves.0), prepared(p, halves.1)];
                let query = Query::of_placed(a.placed(), b.placed());
                assert!(are_known(&query));
                let displacement = query.displacement_estimate();
                let location = locate(&query, &displacement, &mut counts)
                    .expect("it is far from the boundary")
                    .counted(&mut counts)
                    .written(&query);
                assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()));
                assert_eq!(location.status().name(), if factor < 1.0 { "inside" } else { "outside" });
            }
            let reads = counts.get(Operation::GeneratorRead);
            assert!(reads <= (2 * factors.len() * n) as u64, "{n}: {reads}");
            // of those that are neither outside nor well inside, most take no step on all generators
            assert!(counts.answers_of(Rung::StratifiedPass) >= 3, "{n}: {counts:?}");
        }
    }
}
