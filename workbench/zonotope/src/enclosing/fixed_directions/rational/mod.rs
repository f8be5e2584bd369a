//! Smallest zonotope along given directions, by the simplex method in rationals on the dual program of all facet
//! normals.
//!
//! # Statement
//! Input: points of R^D, directions, weights ≥ 0. Output: the least Σ w_i c_i over all zonotopes { p + Σ δ_i c_i v_i
//! : |δ_i| ≤ 1 } that contain the points, with p and c ≥ 0 where it is attained, exactly; `None` when no zonotope along
//! the directions contains them. Zero, parallel and repeated directions are legal, and so are fewer than D of them.
//!
//! # Source
//! Section 4.2, in k + d unknowns. Every facet normal of a zonotope along the directions is, up to sign, a normal of
//! d − 1 of them. So the points are inside just when Σ c_i |u · v_i| + u · p ≥ max_j u · p_j for all these u and −u.
//!
//! # Method
//! 1. Find the span of the directions in rationals; a point off the affine span proves that there is no zonotope.
//! 2. In coordinates of the span, compute the normals of all (d − 1)-subsets as vectors of minors, with both signs.
//! 3. Solve the dual program, maximise Σ y_u h(u) with Σ y_u |u · v_i| ≤ w_i and Σ y_u u = 0, by the simplex method
//!    with Bland's rule, which cannot cycle. Its prices are c and p.
//!
//! # Complexity
//! n points, k directions spanning d dimensions: C(k, d − 1) normals, each O(n + k) rational operations; then the
//! pivots, O(k · C(k, d − 1)) each. The other methods fall back on it for up to some hundred normals.
//!
//! # Shapes
//! `points`: n × D; `directions`: k × D; `coefficients`: half-lengths in units of their directions.
//!
//! # Numerics
//! Everything is exact rational arithmetic.
//!
//! # Checked by
//! [`brute_force`](super::brute_force), another method on the primal program, on every family of points and directions.
//!
//! # Example
//! ```
//! use zonotope::enclosing::fixed_directions::{FixedDirections, rational::min_length_in_rationals};
//! let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
//! let axes = [[1.0, 0.0], [0.0, 1.0]];
//! let problem = FixedDirections::new(&points, &axes, &[1.0, 1.0])?;
//! assert_eq!(min_length_in_rationals(&problem).expect("the axes span the plane").value, 1.into());
//! # Ok::<(), zonotope::enclosing::fixed_directions::FixedDirectionsError>(())
//! ```

use dashu_int::ops::Abs;

use super::answer::ExactOptimum;
use super::problem::FixedDirections;
use crate::enclosing::fixed_directions::departure::first_departure;
use crate::numeric::Rational;
use crate::numeric::exact_linear::simplex::{ANY_WORK, Column, NoOptimum, WORK_PER_CHANGE, maximize};
use crate::numeric::exact_linear::{Span, hyperplane_normal, rational, sum_of_products};
use crate::numeric::subsets::for_each_subset;

/// The least Σ w_i c_i with a centre, coefficients and multipliers that attain it; `None` when no zonotope along the
/// directions contains the points.
#[inline(never)]
pub fn min_length_in_rationals<const D: usize>(problem: &FixedDirections<'_, D>) -> Option<ExactOptimum<D>> {
    optimum_within(problem, &mut ANY_WORK.clone())
}

/// The same if pivots take no more than the work that is left, in products of words; `None` as well if they take more.
pub(super) fn optimum_within<const D: usize>(
    problem: &FixedDirections<'_, D>,
    work: &mut u64,
) -> Option<ExactOptimum<D>> {
    let span = Span::of_doubles(problem.directions());
    if first_departure(&span, problem.points()).is_some() {
        return None;
    }
    let inside = |vectors: &[[f64; D]]| -> Vec<Vec<Rational>> {
        vectors.iter().map(|v| span.pivots().map(|c| rational(v[c])).collect()).collect()
    };
    let (points, directions) = (inside(problem.points()), inside(problem.directions()));
    let weights: Vec<Rational> = problem.weights().iter().map(|&w| rational(w)).collect();
    let half = normals(&directions, span.rank());
    let both: Vec<Vec<Rational>> = half.into_iter().flat_map(|u| [u.iter().map(|c| -c.clone()).collect(), u]).collect();
    let mut farthest = Vec::with_capacity(both.len());
    let columns: Vec<Column> = both
        .iter()
        .map(|u| {
            let heights: Vec<Rational> = points.iter().map(|p| sum_of_products(u, p)).collect();
            let far = (0..points.len()).max_by_key(|&j| &heights[j]).expect("there is a point");
            farthest.push(far);
            Column {
                inequalities: directions.iter().map(|v| sum_of_products(u, v).abs()).collect(),
                equalities: u.clone(),
                gain: heights[far].clone(),
            }
        })
        .collect();
    let vectors = points.len() as u64 + directions.len() as u64;
    let products = both.len() as u64 * vectors * span.rank() as u64;
    *work = work.saturating_sub(WORK_PER_CHANGE * products);
    let optimum = match maximize(&columns, &weights, span.rank(), work) {
        Ok(optimum) => optimum,
        Err(NoOptimum::TooMuchWork) => return None,
        Err(NoOptimum::Unbounded) => unreachable!("a zonotope along the directions holds the points"),
    };
    let first = problem.points()[0].map(rational);
    let shift: Vec<Rational> = optimum.equality_prices.iter().zip(&points[0]).map(|(p, first)| p - first).collect();
    let lifted = span.member(&shift);
    let center = std::array::from_fn(|c| &first[c] + &lifted[c]);
    let multipliers = farthest.into_iter().zip(both.iter().zip(&optimum.solution)).filter(|(_, (_, y))| !y.is_zero());
    let multipliers = multipliers
        .map(|(point, (u, y))| {
            let mut multiplier: [Rational; D] = std::array::from_fn(|_| Rational::ZERO);
            for (component, coordinate) in u.iter().zip(span.pivots()) {
                multiplier[coordinate] = y * component;
            }
            (point, multiplier)
        })
        .collect();
    Some(ExactOptimum { value: optimum.value, center, coefficients: optimum.inequality_prices, multipliers })
}

/// A normal of each (dimension − 1)-subset of the directions that has one, up to sign.
fn normals(directions: &[Vec<Rational>], dimension: usize) -> Vec<Vec<Rational>> {
    let mut found = Vec::new();
    let Some(size) = dimension.checked_sub(1) else { return found };
    for_each_subset(directions.len(), size, |subset| {
        let rows: Vec<&[Rational]> = subset.iter().map(|&i| &directions[i][..]).collect();
        let normal = hyperplane_normal(&rows);
        if normal.iter().any(|c| !c.is_zero()) {
            found.push(normal);
        }
    });
    found
}
