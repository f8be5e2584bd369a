//! Smallest zonotope along given directions, by the criss-cross method on all facet normals in rationals: the truth.
//!
//! # Statement
//! Input: points of R^D, directions, weights ≥ 0. Output: the least Σ w_i c_i over all zonotopes { p + Σ δ_i c_i v_i
//! : |δ_i| ≤ 1 } that contain the points, with a centre p, coefficients c ≥ 0 and multipliers that attain it, all
//! exact; `None` when no zonotope along the directions contains the points. Zero, parallel and repeated directions are
//! legal, and so are fewer than D of them.
//!
//! # Source
//! Section 4.2 for the problem. The linear program is the support form: a zonotope along the directions contains the
//! points just when Σ c_i |u · v_i| + u · p ≥ max_j u · p_j for every facet normal u, that is, for a normal of each
//! d − 1 independent directions, both ways. The criss-cross method is that of Terlaky (1985) with the least-index rule.
//!
//! # Method
//! 1. The span of the directions; a point off the affine span through the first point proves that there is no zonotope.
//! 2. In coordinates of the span, a normal of every (d − 1)-subset of the directions, both ways.
//! 3. A dictionary that expresses the slack of every normal by p and c. Each coordinate of p, which has no sign to
//!    keep, is exchanged for a slack and then stays expressed for good.
//! 4. Until the dictionary is feasible and optimal, the variable of least index that violates either is exchanged: a
//!    negative basic variable for the first one that can raise it, or a nonbasic one with negative cost for the first
//!    one that it lowers.
//!
//! # Complexity
//! n points, k directions spanning d dimensions: m = 2 C(k, d − 1) normals, each O(n + k) rational operations; then
//! exchanges of O(m (k + d)) each, whose number has no polynomial bound. For k up to about 8.
//!
//! # Shapes
//! `points`: n × D; `directions`: k × D; `coefficients`: half-lengths in units of their directions.
//!
//! # Numerics
//! Everything is exact rational arithmetic. Above the ground floor no code is shared with
//! [`rational`](super::rational), the method that the others fall back on: that one takes vectors of minors for normals
//! and solves the dual program by the simplex method.
//!
//! # Checked by
//! Weak duality: primal and dual solution are feasible and have the same value; hand-worked examples; the paper's own
//! program, in which no normal occurs.
//!
//! # Example
//! ```
//! use zonotope::enclosing::fixed_directions::{FixedDirections, brute_force::least_length};
//! let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
//! let axes = [[1.0, 0.0], [0.0, 1.0]];
//! let problem = FixedDirections::new(&points, &axes, &[1.0, 1.0])?;
//! assert_eq!(least_length(&problem).expect("the axes span the plane").value, 1.into());
//! # Ok::<(), zonotope::enclosing::fixed_directions::FixedDirectionsError>(())
//! ```

mod criss_cross;
#[cfg(test)]
mod tests;

use dashu_int::ops::Abs;

use super::answer::ExactOptimum;
use super::problem::FixedDirections;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{Span, rational, sum_of_products};
use crate::numeric::subsets::for_each_subset;
use criss_cross::{Constraint, Dictionary};

/// The least Σ w_i c_i and where it is taken; `None` when no zonotope along the directions contains the points.
#[inline(never)]
pub fn least_length<const D: usize>(problem: &FixedDirections<'_, D>) -> Option<ExactOptimum<D>> {
    let first = problem.points()[0].map(rational);
    let relative = |p: &[f64; D]| -> Vec<Rational> { p.iter().zip(&first).map(|(&a, b)| rational(a) - b).collect() };
    let points: Vec<Vec<Rational>> = problem.points().iter().map(relative).collect();
    let span = Span::of_doubles(problem.directions());
    if points.iter().any(|p| span.member(&span.project(p)) != *p) {
        return None;
    }
    let points: Vec<Vec<Rational>> = points.iter().map(|p| span.project(p)).collect();
    let directions: Vec<Vec<f64>> = problem.directions().iter().map(|v| span.project(v)).collect();
    let (constraints, farthest): (Vec<Constraint>, Vec<usize>) =
        constraints(&points, &directions, span.rank()).into_iter().unzip();
    let weights = problem.weights().iter().map(|&w| rational(w)).collect();
    let optimum = Dictionary::new(&constraints, weights, span.rank()).solve();
    let lifted = span.member(&optimum.center);
    let center = std::array::from_fn(|c| &first[c] + &lifted[c]);
    let used = constraints.iter().zip(farthest).zip(optimum.multipliers).filter(|(_, y)| !y.is_zero());
    let multipliers = used.map(|((constraint, point), y)| {
        let mut vector: [Rational; D] = std::array::from_fn(|_| Rational::ZERO);
        for (component, coordinate) in constraint.normal.iter().zip(span.pivots()) {
            vector[coordinate] = &y * component;
        }
        (point, vector)
    });
    let (value, multipliers) = (optimum.value, multipliers.collect());
    Some(ExactOptimum { value, center, coefficients: optimum.coefficients, multipliers })
}

/// The constraints of all normals, each followed by that of the opposite normal, with the point that reaches farthest.
fn constraints(points: &[Vec<Rational>], directions: &[Vec<f64>], rank: usize) -> Vec<(Constraint, usize)> {
    let mut found = Vec::new();
    let Some(size) = rank.checked_sub(1) else { return found };
    let exact: Vec<Vec<Rational>> = directions.iter().map(|v| v.iter().map(|&c| rational(c)).collect()).collect();
    for_each_subset(directions.len(), size, |subset| {
        let of_subset = Span::of(subset.iter().map(|&i| directions[i].iter().map(|&c| Dyadic::from_f64(c))), rank);
        let mut functionals = of_subset.annihilators();
        // more than one where the subset spans no hyperplane
        let Some(normal) = functionals.pop().filter(|_| functionals.is_empty()) else { return };
        let opposite = normal.iter().map(|c| -c.clone()).collect();
        for normal in [normal, opposite] {
            let widths = exact.iter().map(|v| sum_of_products(&normal, v).abs()).collect();
            let heights = points.iter().map(|p| sum_of_products(&normal, p)).enumerate();
            let (point, height) = heights.max_by(|a, b| a.1.cmp(&b.1)).expect("a problem has a point");
            found.push((Constraint { normal, widths, height }, point));
        }
    });
    found
}
