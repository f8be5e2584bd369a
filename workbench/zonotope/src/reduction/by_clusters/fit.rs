//! The fit of a few generators to a body: the largest difference of the support functions is made small.
//!
//! The support functions are compared along sampled directions and along facet normals of the fitted zonotope, which is
//! where it is narrowest beside its neighbourhood. A zonotope that reaches farther than the body by between 0 and ε
//! everywhere is within ε of it; so the difference should be near ε / 2 everywhere. The sum of powers of
//! |difference − ε / 2| is smooth but for kinks that average out, and with a rising power it turns from the mean of the
//! squares to the largest difference. Between minimisations ε, the power and the normals are taken anew.

use super::super::containment::Facets;
use super::comparison::{Comparison, Measure};
use super::quasi_newton::minimize;
use super::sampled_directions::SampledDirections;
use crate::numeric::lanes::absolute_sum;
use crate::numeric::lanes::octet::LANES;
use crate::numeric::linear::dot;

/// Sampled directions for each generator, and as many facet normals: the difference changes over the width of a
/// cluster, which some directions have to cover.
const DIRECTIONS_PER_GENERATOR: usize = 32;

/// Facet normals among which those of a stage are chosen: at most this many, and at most this many generators of the
/// body are read for them.
const NORMAL_LIMIT: u64 = 1 << 17;
const READ_LIMIT: u64 = 1 << 31;

/// Minimisations one after the other; after some of them all facet normals are looked at again.
const STAGES: usize = 20;
const STAGES_PER_CHOICE: usize = 4;

/// Steps of a minimisation, and the number of generators for which one more is taken.
const STEPS_PER_STAGE: usize = 15;
const GENERATORS_PER_STEP: usize = 32;

/// The last power.
const LARGEST_POWER: u32 = 16;

/// A difference below this part of the body's width is rounding.
const NEGLIGIBLE_ERROR: f64 = 1e-12;

/// Generators whose zonotope reaches as far as that of `body` along the directions that were compared, and little
/// farther. Both are 0 beyond the first `rank` coordinates.
pub(super) fn fitted<const D: usize>(body: &[[f64; D]], rank: usize, start: Vec<[f64; D]>) -> Vec<[f64; D]> {
    let count = (DIRECTIONS_PER_GENERATOR * start.len()).next_multiple_of(LANES);
    let sampled = Comparison::new(body, SampledDirections::new(rank, count));
    let steps = STEPS_PER_STAGE + start.len() / GENERATORS_PER_STEP;
    let mut generators = start;
    let mut best = (f64::INFINITY, generators.clone());
    let mut hyperplanes = Vec::new();
    for stage in 0..=STAGES {
        if stage % STAGES_PER_CHOICE == 0 {
            hyperplanes = narrowest_hyperplanes(body, rank, &generators, count, (stage / STAGES_PER_CHOICE) as u64);
        }
        let compared = sampled.with(&normals(body, rank, &generators, &hyperplanes));
        let range = compared.range(&generators);
        if range.error < best.0 && range.growth.is_finite() {
            best = (range.error, generators.iter().map(|b| b.map(|c| c * range.growth)).collect());
        }
        if stage == STAGES || range.half_width <= NEGLIGIBLE_ERROR * sampled.largest() || !range.error.is_finite() {
            break;
        }
        let measure = Measure {
            middle: if stage == 0 { 0.0 } else { range.error / 2.0 },
            half_width: range.half_width,
            power: LARGEST_POWER.min(2 + 2 * (stage as u32 * 3 / 5)),
        };
        let mut point = generators.as_flattened().to_vec();
        minimize(&mut point, steps, 0.1 * range.half_width, |point, gradient| {
            compared.objective(point.as_chunks().0, measure, gradient)
        });
        generators = point.as_chunks().0.to_vec();
    }
    best.1
}

/// The hyperplanes of the zonotope along whose normals it reaches least beyond the body, by their generators.
fn narrowest_hyperplanes<const D: usize>(
    body: &[[f64; D]],
    rank: usize,
    generators: &[[f64; D]],
    count: usize,
    turn: u64,
) -> Vec<Vec<usize>> {
    let Some(facets) = Facets::new(generators, rank) else { return Vec::new() };
    let limit = NORMAL_LIMIT.min(READ_LIMIT / body.len().max(1) as u64).max(count as u64);
    let sets = facets.sampled_hyperplanes(limit, turn);
    let gap = |set: &Vec<usize>| {
        let (normal, reach) = along_normal(body, &facets, set)?;
        Some(absolute_sum(generators, &normal) - reach)
    };
    let mut gaps: Vec<(f64, usize)> =
        sets.iter().enumerate().filter_map(|(index, set)| Some((gap(set)?, index))).collect();
    gaps.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    gaps.iter().take(count).map(|(_, index)| sets[*index].clone()).collect()
}

/// The unit normals of hyperplanes, with the body's support function.
fn normals<const D: usize>(
    body: &[[f64; D]],
    rank: usize,
    generators: &[[f64; D]],
    hyperplanes: &[Vec<usize>],
) -> Vec<([f64; D], f64)> {
    let facets = Facets::new(generators, rank);
    facets
        .map_or_else(Vec::new, |facets| hyperplanes.iter().filter_map(|set| along_normal(body, &facets, set)).collect())
}

/// The unit normal of the hyperplane that some generators span, with the body's support function; `None` if they are
/// dependent.
fn along_normal<const D: usize>(body: &[[f64; D]], facets: &Facets<'_, D>, set: &[usize]) -> Option<([f64; D], f64)> {
    let normal = facets.normal(set);
    let unit = normal.map(|c| c / dot(&normal, &normal).sqrt());
    unit.iter().all(|c| c.is_finite()).then(|| (unit, absolute_sum(body, &unit)))
}
