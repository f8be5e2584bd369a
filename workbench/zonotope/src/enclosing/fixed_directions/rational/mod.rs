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
//! # Errors
//! None: the problem is valid by construction.
//!
//! # Panics
//! Never.
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

mod refine;
pub(super) mod simplex;

use super::answer::ExactOptimum;
use super::problem::FixedDirections;
use super::span::{Span, rational};
use crate::numeric::Rational;
use simplex::{Column, maximize};

pub(super) use refine::refine;

/// The least Σ w_i c_i with a centre, coefficients and multipliers that attain it; `None` when no zonotope along the
/// directions contains the points.
pub fn min_length_in_rationals<const D: usize>(problem: &FixedDirections<'_, D>) -> Option<ExactOptimum<D>> {
    let span = Span::of(problem.directions());
    if span.first_departure(problem.points()).is_some() {
        return None;
    }
    let inside = |vectors: &[[f64; D]]| -> Vec<Vec<Rational>> {
        vectors.iter().map(|v| span.pivots().iter().map(|&c| rational(v[c])).collect()).collect()
    };
    let (points, directions) = (inside(problem.points()), inside(problem.directions()));
    let weights: Vec<Rational> = problem.weights().iter().map(|&w| rational(w)).collect();
    let half = normals(&directions, span.dimension());
    let both: Vec<Vec<Rational>> = half.into_iter().flat_map(|u| [u.iter().map(|c| -c.clone()).collect(), u]).collect();
    let mut farthest = Vec::with_capacity(both.len());
    let columns: Vec<Column> = both
        .iter()
        .map(|u| {
            let heights: Vec<Rational> = points.iter().map(|p| product(u, p)).collect();
            let far = (0..points.len()).max_by_key(|&j| &heights[j]).expect("there is a point");
            farthest.push(far);
            Column {
                inequalities: directions.iter().map(|v| absolute(product(u, v))).collect(),
                equalities: u.clone(),
                gain: heights[far].clone(),
            }
        })
        .collect();
    let optimum =
        maximize(&columns, &weights, span.dimension()).expect("a zonotope along the directions holds the points");
    let first = problem.points()[0].map(rational);
    let shift: Vec<Rational> = optimum.equality_prices.iter().zip(&points[0]).map(|(p, first)| p - first).collect();
    let lifted = span.lift(&shift);
    let center = std::array::from_fn(|c| &first[c] + &lifted[c]);
    let multipliers = farthest.into_iter().zip(both.iter().zip(&optimum.solution)).filter(|(_, (_, y))| !y.is_zero());
    let multipliers = multipliers
        .map(|(point, (u, y))| {
            let mut multiplier: [Rational; D] = std::array::from_fn(|_| Rational::ZERO);
            for (component, &coordinate) in u.iter().zip(span.pivots()) {
                multiplier[coordinate] = y * component;
            }
            (point, multiplier)
        })
        .collect();
    Some(ExactOptimum { value: optimum.value, center, coefficients: optimum.inequality_prices, multipliers })
}

/// A normal of each (dimension − 1)-subset of the directions that has one, up to sign.
fn normals(directions: &[Vec<Rational>], dimension: usize) -> Vec<Vec<Rational>> {
    let Some(size) = dimension.checked_sub(1) else { return Vec::new() };
    let mut found = Vec::new();
    let mut subset: Vec<usize> = (0..size).collect();
    while subset.last().is_none_or(|&last| last < directions.len()) {
        let rows: Vec<&[Rational]> = subset.iter().map(|&i| &directions[i][..]).collect();
        let normal: Vec<Rational> = (0..dimension)
            .map(|c| {
                let others: Vec<usize> = (0..dimension).filter(|&other| other != c).collect();
                let minor = determinant(&rows, &others);
                if c % 2 == 0 { minor } else { -minor }
            })
            .collect();
        if normal.iter().any(|c| !c.is_zero()) {
            found.push(normal);
        }
        let Some(moving) = (0..size).rev().find(|&i| subset[i] + size - i < directions.len()) else { break };
        subset[moving] += 1;
        for i in moving + 1..size {
            subset[i] = subset[i - 1] + 1;
        }
    }
    found
}

/// The determinant of the given columns of some rows, along the first row.
fn determinant(rows: &[&[Rational]], columns: &[usize]) -> Rational {
    let Some((row, rest)) = rows.split_first() else { return Rational::ONE };
    columns.iter().enumerate().fold(Rational::ZERO, |sum, (i, &column)| {
        if row[column].is_zero() {
            return sum;
        }
        let others: Vec<usize> = columns.iter().copied().filter(|&other| other != column).collect();
        let term = &row[column] * determinant(rest, &others);
        if i % 2 == 0 { sum + term } else { sum - term }
    })
}

fn product(a: &[Rational], b: &[Rational]) -> Rational {
    a.iter().zip(b).fold(Rational::ZERO, |sum, (x, y)| sum + x * y)
}

fn absolute(value: Rational) -> Rational {
    if value < Rational::ZERO { -value } else { value }
}
