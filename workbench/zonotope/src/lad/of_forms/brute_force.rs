//! The kernel in three variables, by all vertices: the truth, in exact rationals.
//!
//! # Statement
//! Input: weighted planes and a linear term. Output: the minimum of linear · x + Σ w_i |a_i · x + b_i|, or `None` if it
//! falls without end.
//!
//! # Source
//! None: the definition.
//!
//! # Method
//! 1. The planes x = 0, y = 0 and z = 0 join with weight 0, so that every face of the arrangement has a vertex.
//! 2. The slope at infinity is linear on the cones between planes through the origin: it is tried along the lines in
//!    which two meet.
//! 3. The objective is linear on every face, so that its minimum is taken at a vertex: all are tried.
//!
//! # Complexity
//! O(n⁴) exact operations.
//!
//! # Shapes
//! planes: n × (3 + 1 + 1), any order, duplicates allowed.
//!
//! # Numerics
//! Exact rationals throughout.
//!
//! # Checked by
//! Examples by hand; it checks the others.
//!
//! # Example
//! ```
//! use zonotope::lad::of_forms::{SpaceLadProblem, WeightedPlane, brute_force};
//! let plane = WeightedPlane { normal: [1.0, 0.0, 0.0], offset: -2.0, weight: 3.0 };
//! let problem = SpaceLadProblem::new(vec![plane], [1.0, 0.0, 0.0]).unwrap();
//! assert_eq!(brute_force::minimum(&problem), Some(2.into()));
//! ```

use dashu_int::ops::Abs;

use super::problem::SpaceLadProblem;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{cross, dot};

type Vector = [Rational; 3];

/// The minimum; `None` when the objective falls without end.
pub fn minimum(problem: &SpaceLadProblem) -> Option<Rational> {
    let rational = |v: f64| Dyadic::from_f64(v).to_rational();
    let linear = problem.linear().map(rational);
    let mut planes: Vec<(Vector, Rational)> = problem
        .planes()
        .iter()
        .map(|plane| {
            let weight = rational(plane.weight);
            (plane.normal.map(|v| rational(v) * &weight), rational(plane.offset) * &weight)
        })
        .collect();
    let weighted = planes.len();
    for axis in 0..3 {
        let unit = std::array::from_fn(|k| if k == axis { Rational::ONE } else { Rational::ZERO });
        planes.push((unit, Rational::ZERO));
    }
    let slope = |u: &Vector| planes[..weighted].iter().fold(dot(&linear, u), |sum, (a, _)| sum + dot(a, u).abs());
    let value = |x: &Vector, w: &Rational| {
        planes[..weighted].iter().fold(dot(&linear, x), |sum, (a, b)| sum + (dot(a, x) + b * w).abs()) / w
    };
    let mut best: Option<Rational> = None;
    for (i, (a, d)) in planes.iter().enumerate() {
        for (j, (b, e)) in planes[..i].iter().enumerate() {
            let line = cross(a, b);
            if slope(&line) < Rational::ZERO || slope(&line.clone().map(|v| -v)) < Rational::ZERO {
                return None;
            }
            for (c, f) in &planes[..j] {
                let weight = dot(&line, c);
                if weight == Rational::ZERO {
                    continue;
                }
                // Cramer's rule for a · x = −d, b · x = −e, c · x = −f, times the determinant, with a positive weight.
                let (first, second) = (cross(b, c), cross(c, a));
                let turn = if weight < Rational::ZERO { Rational::ONE } else { Rational::NEG_ONE };
                let x: Vector = std::array::from_fn(|k| (&first[k] * d + &second[k] * e + &line[k] * f) * &turn);
                let value = value(&x, &weight.abs());
                best = Some(best.map_or(value.clone(), |best| best.min(value)));
            }
        }
    }
    best
}
