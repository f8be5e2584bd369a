//! Whether two triangles meet, by a linear program in rationals.
//!
//! # Statement
//! Input: two triangles with exact corners, in any position. Output: whether they have a point in common, closed.
//!
//! # Source
//! No part of the paper: triangles meet just when the origin is in the hull of the nine differences of their corners.
//!
//! # Method
//! Maximise Σ λ_ij over λ ≥ 0 with Σ λ_ij ≤ 1 and Σ λ_ij (a_i − b_j) = 0: the optimum is 1 if the origin is in the
//! hull, else 0.
//!
//! # Complexity
//! O(1): a simplex method with nine unknowns and four rows, in rationals.
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
use crate::numeric::exact_linear::{ExactVector, difference};

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
