//! Whether two triangles meet, and how far apart they are, by the nine differences of their corners, in rationals.
//!
//! # Statement
//! Input: two triangles with exact corners, in any position. Output: whether they have a point in common, closed; the
//! square of their distance.
//!
//! # Source
//! No part of the paper: triangles meet just when the origin is in the hull of the nine differences of their corners.
//!
//! # Method
//! Maximise Σ λ_ij over λ ≥ 0 with Σ λ_ij ≤ 1 and Σ λ_ij (a_i − b_j) = 0: the optimum is 1 if the origin is in the
//! hull, else 0. The point of the hull that is nearest to the origin is that of a simplex of at most three differences
//! if the origin is outside: of all of them, the nearest point of the plane, the line or the point counts if its
//! weights are not negative.
//!
//! # Complexity
//! O(1): a simplex method with nine unknowns and four rows, 129 simplices, in rationals.
//!
//! # Shapes
//! `a`, `b`: three corners, in any order, equal ones allowed.
//!
//! # Numerics
//! Exact throughout.
//!
//! # Checked by
//! The two methods beside it, which share nothing with it.
//!
//! # Example
//! ```
//! use zonotope::bvh::brute_force::all_pairs;
//! use zonotope::bvh::Mesh;
//! let segment = |y: f64| Mesh::new(vec![[0.0, y, 0.0], [1.0, 0.0, 0.0]], vec![[0, 1, 1]]);
//! assert_eq!(all_pairs(&segment(0.0)?, &segment(1.0)?), [[0, 0]]); // they share an end
//! # Ok::<(), zonotope::bvh::MeshError>(())
//! ```

use crate::numeric::Rational;
use crate::numeric::exact_linear::simplex::{ANY_WORK, Column, maximize};
use crate::numeric::exact_linear::{ExactVector, difference, dot, solve};

/// Whether two triangles meet.
pub(crate) fn meet(a: &[ExactVector; 3], b: &[ExactVector; 3]) -> bool {
    let column = |p: &ExactVector, q: &ExactVector| Column {
        inequalities: vec![Rational::ONE],
        equalities: difference(p, q).iter().map(|c| c.to_rational()).collect(),
        gain: Rational::ONE,
    };
    let columns: Vec<Column> = a.iter().flat_map(|p| b.iter().map(move |q| column(p, q))).collect();
    let optimum = maximize(&columns, &[Rational::ONE], 3, &mut ANY_WORK.clone());
    optimum.is_ok_and(|optimum| optimum.value == Rational::ONE)
}

/// The square of the distance of two triangles.
pub(crate) fn square_of_distance(a: &[ExactVector; 3], b: &[ExactVector; 3]) -> Rational {
    if meet(a, b) {
        return Rational::ZERO;
    }
    let differences: Vec<[Rational; 3]> =
        a.iter().flat_map(|p| b.iter().map(|q| difference(p, q).map(|c| c.to_rational()))).collect();
    let mut best: Option<Rational> = None;
    for (k, r) in differences.iter().enumerate() {
        for (j, q) in differences[..=k].iter().enumerate() {
            for p in &differences[..=j] {
                // equal ones make a simplex of fewer corners
                let mut corners = vec![p, q, r];
                corners.dedup();
                let square = square_at_nearest(&corners);
                if let Some(square) = square.filter(|square| best.as_ref().is_none_or(|best| square < best)) {
                    best = Some(square);
                }
            }
        }
    }
    best.expect("each corner is a simplex")
}

/// The square of the distance of the origin from the affine hull of corners, if the nearest point is in their simplex.
fn square_at_nearest(corners: &[&[Rational; 3]]) -> Option<Rational> {
    let (first, others) = corners.split_first()?;
    let edges: Vec<[Rational; 3]> = others.iter().map(|corner| [0, 1, 2].map(|k| &corner[k] - &first[k])).collect();
    let columns: Vec<Vec<Rational>> =
        edges.iter().map(|edge| edges.iter().map(|other| dot(edge, other)).collect()).collect();
    let right: Vec<Rational> = edges.iter().map(|edge| -dot(edge, first)).collect();
    let weights = solve(&columns, &right)?;
    let sum = weights.iter().fold(Rational::ZERO, |sum, weight| sum + weight);
    let is_inside = weights.iter().all(|weight| *weight >= Rational::ZERO) && sum <= Rational::ONE;
    let heights = edges.iter().zip(&weights).map(|(edge, weight)| dot(edge, first) * weight);
    is_inside.then(|| heights.fold(dot(first, first), |square, height| square + height))
}
