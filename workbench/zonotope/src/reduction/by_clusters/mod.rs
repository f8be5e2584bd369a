//! Order reduction, by cluster sums that are fitted to the body and scaled by the exact factor: the default.
//!
//! # Statement
//! Input: a zonotope A in R^D and a count k ≥ D. Output: a zonotope B with the same centre and at most k generators
//! that contains A exactly. The proof is the check of all facet normals of B. A body of at most k generators is its own
//! answer. Flat and thin bodies, zero and parallel generators are ordinary input.
//!
//! # Source
//! Not in the paper. Adding up clusters of generators gives a zonotope inside A, whose error falls about as 1 / k where
//! Lemma 5.5 has 1 / √k; scaled until it contains A it is a bounding volume. Two things bring it nearer to the optimal
//! k^(−5/4) in space (Bourgain and Lindenstrauss; Matoušek; Siegel): clusters count with the sum of their lengths, so
//! that no mean difference is left to the factor, and the generators are fitted to the body's support function.
//!
//! # Method
//! 1. Leave out coordinates that are nearly functions of the others (`chart`): a thin body is reduced in the plane
//!    along which it lies, and a generator along each axis left out makes up for its thickness. All such charts are
//!    tried.
//! 2. Cluster the generators by direction, by Lloyd's rounds from directions far from each other (`k_means`).
//! 3. Fit the generators to the body along sampled directions and the facet normals of the zonotope where it is
//!    narrowest (`fit`), by quasi-Newton steps on a rising power of the differences.
//! 4. Multiply by the covering factor, the largest h_A(u) / h_B(u) over all facet normals u of B, and by a little more.
//! 5. Prove at every facet normal of the rounded generators that B reaches as far as A, exactly.
//! 6. Of the charts, take the one with the least error along sampled directions. Where no chart has an answer, as for
//!    bodies of few digits at the ends of the range of doubles, Girard's rule has.
//!
//! # Complexity
//! n generators: O(n k) for each Lloyd round; 32 k directions and up to 2^17 facet normals five times, each a pass over
//! the generators; some 400 evaluations of the fit along 64 k directions at O(k) each; 2 C(k, D − 1) passes for factor
//! and proof. Of more than 2^15 generators all but the proof see sums over cells of directions instead. At most
//! [`NORMAL_LIMIT`] facet normals are proved and at most [`CLUSTER_LIMIT`] clusters made, so beyond that B has fewer
//! generators than asked for. O(n + k²) space.
//!
//! # Shapes
//! `generators`: n × D, half-segments, any order.
//!
//! # Numerics
//! Clusters, fit and factor are rounded. That B contains A is decided by doubles with a bound on their errors, exactly
//! where these leave a doubt; the factor's margin of 2^-30 is what makes doubts rare.
//!
//! # Errors
//! [`OutOfRange`](super::ReductionError::OutOfRange) ⇔ a generator of B exceeds the largest double.
//!
//! # Checked by
//! [`brute_force`](super::brute_force), in rationals.
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, reduction::{Problem, brute_force::contains, by_clusters::clusters}};
//! let body = Zonotope::new([0.0, 0.0], vec![[3.0, 0.0], [0.0, 2.0], [2.0, 0.0]])?;
//! let reduced = clusters(&Problem::new(&body, 2)?)?;
//! assert!(contains(&reduced.body, &body) && reduced.body.generators().len() == 2);
//! // the box of half-sides 5 and 2 is the body itself, but for the margin of the factor
//! assert!(reduced.body.bounding_box().high[0] < 5.0 + 1e-7 && reduced.body.bounding_box().high[1] < 2.0 + 1e-7);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod chart;
mod comparison;
mod condensed;
mod fit;
mod k_means;
mod quasi_newton;
mod sampled_directions;

use super::answer::{Containment, Problem, Reduced, ReductionError};
use super::containment::Facets;
use super::keeping::by_girard::girard;
use super::keeping::order::scaled;
use crate::numeric::lanes::absolute_sum;
use crate::numeric::scaling::{binary_exponent, largest_magnitude, scale_by_power_of_two};
use crate::zonotope::Zonotope;
use chart::{Chart, charts};
use condensed::condensed;
use fit::fitted;
use k_means::cluster_sums;
use sampled_directions::SampledDirections;

/// At most this many facet normals are looked at for a proof.
pub const NORMAL_LIMIT: u64 = 1 << 20;

/// At most this many clusters are made.
pub const CLUSTER_LIMIT: usize = 1024;

/// The factor's first margin, and the factor by which a margin grows that was not enough.
const FIRST_MARGIN: f64 = 1.0 / 1_073_741_824.0;
const MARGIN_GROWTH: f64 = 16.0;

/// The largest margin: rounding generators to doubles of few digits may take off as much.
const LARGEST_MARGIN: f64 = 8.0;

/// Limit of the products of a facet normal and a generator in exact arithmetic, of all charts and margins together.
/// Where doubles leave more in doubt, as they do of very thin bodies, the next margin is tried, which leaves less.
const EXACT_PRODUCT_LIMIT: u64 = 1 << 18;

/// Directions along which the answers of charts are compared.
const COMPARED_DIRECTIONS: usize = 1024;

/// The reduction by fitted cluster sums.
///
/// # Errors
/// [`ReductionError::OutOfRange`] if a generator leaves the range of doubles.
pub fn clusters<const D: usize>(problem: &Problem<'_, D>) -> Result<Reduced<D>, ReductionError> {
    if let Some(same) = problem.unreduced() {
        return Ok(same);
    }
    let own = problem.body().generators();
    let vectors = scaled(own);
    let mut exact_products = EXACT_PRODUCT_LIMIT;
    let in_chart = |chart| in_chart(problem, &vectors, chart, &mut exact_products);
    let answers: Vec<Vec<[f64; D]>> = charts(&vectors).iter().filter_map(in_chart).collect();
    let directions = SampledDirections::<D>::new(D, COMPARED_DIRECTIONS);
    let exponent = exponent_of(own);
    let error = |answer: &[[f64; D]]| {
        let answer = times_power_of_two(answer, -exponent);
        directions.iter().fold(0.0f64, |error, u| error.max(absolute_sum(&answer, &u) - absolute_sum(&vectors, &u)))
    };
    let best = answers.into_iter().map(|answer| (error(&answer), answer)).min_by(|a, b| a.0.total_cmp(&b.0));
    let Some((_, generators)) = best else { return girard(problem) };
    let body = Zonotope::new(problem.body().center(), generators).map_err(|_| ReductionError::OutOfRange)?;
    Ok(Reduced { body, proof: Containment::FacetNormals })
}

/// The generators of an enclosing zonotope by way of a chart; `None` if they are too many, or do not enclose.
fn in_chart<const D: usize>(
    problem: &Problem<'_, D>,
    vectors: &[[f64; D]],
    chart: &Chart<D>,
    exact_products: &mut u64,
) -> Option<Vec<[f64; D]>> {
    let own = problem.body().generators();
    let rank = chart.rank();
    let is_provable = |count: &usize| Facets::<D>::count(*count, rank, NORMAL_LIMIT).is_some();
    let most = (problem.count() - chart.left_out()).min(CLUSTER_LIMIT);
    let count = (rank..=most).rev().find(is_provable)?;
    let seen = condensed(vectors.iter().map(|v| chart.projected(v)).collect(), rank);
    let generators = fitted(&seen, rank, cluster_sums(&seen, count));
    let generators = times_power_of_two(&generators, exponent_of(own));
    let projected: Vec<[f64; D]> = own.iter().map(|v| chart.projected(v)).collect();
    let enclosing = enclosing(&projected, rank, generators, exact_products)?;
    chart.lifted(&enclosing, own)
}

/// The generators times the covering factor and a margin, so that they enclose the body exactly.
fn enclosing<const D: usize>(
    body: &[[f64; D]],
    rank: usize,
    generators: Vec<[f64; D]>,
    exact_products: &mut u64,
) -> Option<Vec<[f64; D]>> {
    let factor = Facets::new(&generators, rank)?.growth(body);
    let mut margin = FIRST_MARGIN;
    while margin <= LARGEST_MARGIN && factor.is_finite() {
        let grown: Vec<[f64; D]> = generators.iter().map(|b| b.map(|c| c * (factor * (1.0 + margin)))).collect();
        if grown.as_flattened().iter().all(|c| c.is_finite())
            && Facets::new(&grown, rank).and_then(|facets| facets.contain(body, exact_products)) == Some(true)
        {
            return Some(grown);
        }
        margin *= MARGIN_GROWTH;
    }
    None
}

/// The exponent of the power of two by which [`scaled`] divides.
fn exponent_of<const D: usize>(generators: &[[f64; D]]) -> i64 {
    i64::from(binary_exponent(largest_magnitude(generators.as_flattened())).unwrap_or(0))
}

fn times_power_of_two<const D: usize>(generators: &[[f64; D]], exponent: i64) -> Vec<[f64; D]> {
    generators.iter().map(|g| g.map(|c| scale_by_power_of_two(c, exponent))).collect()
}
