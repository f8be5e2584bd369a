//! Points far inside and far outside, located and proved in few passes, on a sample first.
//!
//! | file | what it has |
//! |---|---|
//! | [`least_squares`] | small bodies: the coefficients of least size by one solve, or a direction that separates |
//! | [`huber_dual`] | the smooth problem whose solution gives clipped coefficients |
//! | [`clipped_steps`] | Newton steps on the smooth problem, for a sample or for all generators |
//! | [`combination`] | coefficients written, summed up and proved |
//! | [`correcting_basis`] | three generators that balance what is left |
//! | [`stratified_pass`] | many generators: coefficients in one pass, steered by a sample |
//! | [`known_sums`] | many generators of prepared bodies: what a sample of the least coefficients tells |
//! | [`scaled_products`] | that sample |
//!
//! The solution y of the smooth problem for a sample either separates, which one pass over all generators proves, or
//! steers the coefficients that are written for all. Where that fails, the sums of all generators at some y give
//! coefficients. Where the sample says that the point is near the boundary, nothing is tried.

mod clipped_steps;
pub(crate) mod combination;
pub(crate) mod correcting_basis;
pub(crate) mod huber_dual;
mod known_sums;
pub(crate) mod least_squares;
mod scaled_products;
pub(crate) mod stratified_pass;

use self::clipped_steps::{Effort, SAMPLE_STEPS, State, StepsEnd, inside, separates};

use crate::collision::by_lad::early::combination::Combination;
use crate::collision::by_lad::early::huber_dual::{Among, Lengths, hessian_at_zero};
use crate::collision::by_lad::early::least_squares::{Open, of_least, of_least_in_plane};
use crate::collision::by_lad::early::stratified_pass::StratifiedPass;
use crate::collision::{Location, Query};
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::span::flat::SimplePlane;
use crate::lad::of_generators::span::prism::Prism;
use crate::numeric::bounded::{self, BoundedVector};
use crate::numeric::lanes::bounded_sum;
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::dot;
use crate::tally::{Operation, Rung, Tally};
use crate::zonotope::location::Proof;
use crate::zonotope::pose::Standing;

/// With at most this many generators no sample is taken.
const WHOLE_LIMIT: usize = 320;

/// With at most this many generators, coefficients are in terms of each generator's own length.
const OWN_LENGTHS_LIMIT: usize = 16;

/// A point whose gauge seems to be between these is near the boundary.
pub(crate) const INSIDE_GAUGE: f64 = 0.9;
const OUTSIDE_GAUGE: f64 = 1.0;

/// Of a body of at most [`OWN_LENGTHS_LIMIT`] generators of even lengths, a point whose gauge is known to be above this
/// is left to the search at once. Its gauge is likely to be above [`INSIDE_GAUGE`], too, and the steps that would show
/// this take a third of the time of the search. Generators of uneven lengths tell less of the gauge.
const INSIDE_GAUGE_OF_SMALL_BODIES: f64 = 0.6;

/// Standard errors by which the sampled gauge must exceed 1 for a direction to be tried.
const OUTSIDE_DEVIATIONS: f64 = 1.0;

/// The status of p with its proof, if p is far from the boundary, and the entries of the matrices of poses are of
/// moderate size.
#[inline]
pub(crate) fn locate<P: Standing>(query: &Query<'_, 3, P>, tally: &mut dyn Tally) -> Option<Proof> {
    if !query.is_moderate() {
        return None;
    }
    let p = query.displacement_estimate();
    let n = query.len();
    if n > WHOLE_LIMIT {
        let locate = if known_sums::are_known(query) { known_sums::locate } else { locate_by_sample };
        return locate(query, &p, tally);
    }
    tally.add(Operation::GeneratorRead, n as u64);
    let proof = if n <= OWN_LENGTHS_LIMIT { of_least::<true>(query, &p) } else { of_least::<false>(query, &p) };
    proof.map_or_else(|open| locate_by_steps(query, &p, &open, tally), Some)
}

/// The proof that p is in a body that seems to be flat.
fn locate_flat(query: &impl KernelQuery, p: &BoundedVector, tally: &mut dyn Tally) -> Option<Proof> {
    let rows = query.in_doubles()?;
    let query = &rows.query();
    let plane = SimplePlane::of(query)?;
    tally.add(Operation::GeneratorRead, 2 * query.len() as u64);
    let open = match of_least_in_plane(query, p, &plane) {
        Ok(witness) => return Some(Proof::boundary(witness, Rung::LeastSquaresInPlane)),
        Err(open) => open,
    };
    if !(open.is_thick && open.gauge < INSIDE_GAUGE) {
        return None;
    }
    // clipped coefficients are those of the prism over what is left without a coordinate
    let prism = Prism::without(plane.axis(), query);
    let body = prism.query();
    let steps = State::new(&plane.projected(&open.y), open.gauge);
    let of_prism = steps.prove(&body, &body.displacement_estimate(), Lengths::Own, Among::First(WHOLE_LIMIT), tally)?;
    match of_prism.location.written(&body) {
        Location::Inside(witness) => Some(Proof::boundary(prism.lower_witness(witness), of_prism.rung)),
        Location::Boundary(_) | Location::Outside(_) => None,
    }
}

/// The proof of a point inside whose least coefficients are too large, by clipped ones.
fn locate_by_steps(query: &impl KernelQuery, p: &BoundedVector, open: &Open, tally: &mut dyn Tally) -> Option<Proof> {
    let is_small = query.len() <= OWN_LENGTHS_LIMIT;
    let is_below = |limit: f64| open.gauge < limit; // false for NaN as well
    if !is_below(INSIDE_GAUGE) {
        return None;
    }
    let is_even = || Lengths::of(query) != Lengths::Own;
    if is_small && open.is_thick && !is_below(INSIDE_GAUGE_OF_SMALL_BODIES) && is_even() {
        return None;
    }
    if !open.is_thick {
        return locate_flat(query, p, tally);
    }
    let (steps, among) = (State::new(&open.y, open.gauge), Among::First(WHOLE_LIMIT));
    if is_small {
        return steps.prove(query, p, Lengths::Own, among, tally);
    }
    match Lengths::of(query) {
        Lengths::Own => locate_by_all(query, p, tally),
        // products are taken as they are: y is in terms of any one length
        Lengths::Even(_) => steps.prove(query, p, Lengths::Even(1.0), among, tally),
    }
}

/// The proof from all generators where lengths are uneven, each coefficient in terms of the length of its generator.
fn locate_by_all(query: &impl KernelQuery, p: &BoundedVector, tally: &mut dyn Tally) -> Option<Proof> {
    tally.add(Operation::GeneratorRead, query.len() as u64);
    let own = p.map(|c| c.value);
    let (y, is_thick) = hessian_at_zero(query, Lengths::Own).solve(&own);
    let reach = query.support(&y);
    let along = dot(p, &bounded::exact(y));
    if (along - reach).is_positive() {
        return Some(Proof::outside(y, Rung::LeastSquares));
    }
    // a lower bound of the gauge of p; NaN fails every test below
    let gauge = along.value / reach.value;
    if !(is_thick && gauge < INSIDE_GAUGE) {
        return None;
    }
    let among = Among::First(WHOLE_LIMIT);
    let least = Combination::least(query, y, Lengths::Own, among, true);
    if let Some(witness) = least.and_then(|least| inside(query, p, &least, tally)) {
        return Some(Proof::inside(witness, Rung::LeastSquares));
    }
    State::new(&y, gauge).prove(query, p, Lengths::Own, among, tally)
}

/// The proof from a sample of many generators: its least coefficients steer those of all, or give a direction.
fn locate_by_sample(query: &impl KernelQuery, p: &BoundedVector, tally: &mut dyn Tally) -> Option<Proof> {
    let n = query.len();
    let pass = StratifiedPass::of(n);
    let few = pass.last(query);
    let sample = Rows::new(&few);
    tally.add(Operation::GeneratorRead, few.len() as u64);
    let part = few.len() as f64 / n as f64;
    let own = p.map(|c| c.value * part);
    let lengths = Lengths::of(&sample);
    let least = hessian_at_zero(&sample, lengths);
    let (y, is_thick) = least.solve(&own);
    let gauge = dot(&own, &y) / bounded_sum(sample, &y).value;
    if gauge > OUTSIDE_GAUGE + OUTSIDE_DEVIATIONS / (few.len() as f64).sqrt() && separates(query, p, &y, tally) {
        return Some(Proof::outside(y, Rung::SampledDirection));
    }
    if lengths == Lengths::Own {
        // the longest are not in the sample
        return locate_by_all(query, p, tally);
    }
    if !is_thick && gauge < INSIDE_GAUGE {
        return locate_flat(query, p, tally);
    }
    if !(is_thick && gauge < INSIDE_GAUGE) {
        return None;
    }
    let start = State::new(&y, gauge);
    let (mut state, mut is_linear) = (start, true);
    let steer = |target: &[f64; 3], exact: bool| {
        if is_linear {
            let (z, _) = least.solve(target);
            let combination = Combination::least(&sample, z, lengths, Among::Sample(&few), exact);
            is_linear = combination.is_some();
            if is_linear {
                return combination;
            }
        }
        match state.coefficients(&sample, lengths, target, Among::Sample(&few), Effort { steps: SAMPLE_STEPS, exact }) {
            StepsEnd::Inside(combination) => Some(combination),
            StepsEnd::Outside(_) | StepsEnd::Neither => None,
        }
    };
    tally.add(Operation::GeneratorRead, n as u64);
    if let Some(witness) = pass.witness(query, p, few.len(), steer) {
        return Some(Proof::inside(witness, Rung::StratifiedPass));
    }
    start.prove(query, p, lengths, Among::Sample(&few), tally)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::brute_force;
    use crate::interop::verifier::check_location;
    use crate::tally::OperationCounts;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// Generators of three kinds: even, of lengths from 1 to thousands, nearly all nearly in a plane.
    fn body(kind: usize, n: usize, random: &mut Pcg64Mcg) -> Vec<[f64; 3]> {
        let mut vector = || {
            let [x, y, z] = [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
            match kind {
                0 => [x, y, z],
                1 => [x, y, z].map(|c| c / (1.0 - random.random_range(0.0..1.0f64))),
                _ => [x, y, if random.random_range(0..10) == 0 { z } else { 1e-6 * z }],
            }
        };
        (0..n).map(|_| vector()).collect()
    }

    /// A multiple of the vertex that is extreme along u.
    fn point(body: &[[f64; 3]], u: [f64; 3], factor: f64) -> [f64; 3] {
        let p = body.iter().fold([0.0; 3], |sum, v| {
            let sign = f64::copysign(1.0, dot(v, &u));
            [0, 1, 2].map(|k| sum[k] + sign * v[k])
        });
        p.map(|c| factor * c)
    }

    #[test]
    fn points_far_from_the_boundary_are_proved_mostly_at_once() {
        let random = &mut Pcg64Mcg::seed_from_u64(5);
        for kind in 0..3 {
            for n in [6, 15, 40, 129, 1100] {
                let (mut proved, mut reads) = (0, 0);
                for i in 0..20 {
                    let body = body(kind, n, random);
                    let u = [0, 1, 2].map(|_| random.random_range(-1.0..1.0));
                    let factor = [0.0, 0.2, 0.6, 1.6, 9.0][i % 5];
                    let query = Query::new([0.0; 3], point(&body, u, factor), &body).expect("finite");
                    let mut counts = OperationCounts::default();
                    let Some(proof) = locate(&query, &mut counts) else { continue };
                    let location = proof.location.written(&query);
                    assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()));
                    assert_eq!(location.status().name(), if factor < 1.0 { "inside" } else { "outside" });
                    (proved, reads) = (proved + 1, reads + counts.get(Operation::GeneratorRead));
                }
                assert!(proved >= 14 && reads <= 4 * proved * n as u64, "{kind} {n}: {proved}, {reads}");
            }
        }
    }

    #[test]
    fn every_proof_is_right() {
        let random = &mut Pcg64Mcg::seed_from_u64(7);
        for i in 0..300 {
            let body = body(i % 3, 3 + i % 7, random);
            let u = [0, 1, 2].map(|_| random.random_range(-1.0..1.0));
            let p = point(&body, u, random.random_range(0.7..1.4));
            let query = Query::new([0.0; 3], p, &body).expect("finite");
            if let Some(proof) = locate(&query, &mut ()) {
                let location = proof.location.written(&query);
                assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()));
                assert_eq!(location.status(), brute_force::locate(&query).status());
            }
        }
    }

    #[test]
    fn extreme_bodies_are_left_to_others_and_so_are_most_flat_ones() {
        let is_proved = |size: f64, body: &[[f64; 3]]| {
            let (p, body) = ([0.2, 0.3, 0.0].map(|c| size * c), body.iter().map(|v| v.map(|c| size * c)));
            let body: Vec<[f64; 3]> = body.collect();
            locate(&Query::new([0.0; 3], p, &body).expect("finite"), &mut ()).is_some()
        };
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert!(is_proved(1.0, &cube) && is_proved(1e60, &cube) && is_proved(1e-60, &cube));
        assert!(!is_proved(f64::MAX, &cube) && !is_proved(1e-200, &cube));
        // the plane's normal is (3, −2, 0)
        assert!(!is_proved(1.0, &[]) && !is_proved(1.0, &[[2.0, 3.0, 0.0], [2.0, 3.0, 1.0], [0.0, 0.0, 1.0]]));
        let square = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
        for p in [[0.9, -0.2, 0.0], [-1.2, -1.3, 0.0]] {
            let query = Query::new([0.0; 3], p, &square).expect("finite");
            let location = locate(&query, &mut ()).expect("it is in a simple plane").location.written(&query);
            assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()));
            assert_eq!(location.status().name(), "boundary");
        }
        // beside a flat body a direction separates all the same
        let square = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let query = Query::new([0.0; 3], [0.5, 0.0, 1e-3], &square).expect("finite");
        assert!(locate(&query, &mut ()).is_some_and(|proof| proof.direction().is_some()));
    }
}
