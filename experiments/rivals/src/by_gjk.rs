//! Whether a zonotope holds a displacement, by the algorithm of Gilbert, Johnson and Keerthi in floating point: may be
//! wrong, may give up.
//!
//! # Statement
//! Input: a displacement p and generators g_i of R^D, 1 ≤ D ≤ 7. Output: [`GjkAnswer`], a belief without proof.
//! Touching, flat and narrowly missing questions are where it fails; the library's methods are exact, this one is what
//! they are measured against.
//!
//! # Source
//! None in the paper. The method of physics engines, on the support function of the implicit zonotope.
//!
//! # Method
//! 1. Z − p holds the origin just when p ∈ Z. Keep a simplex of at most D + 1 of its extreme points and the simplex's
//!    point v nearest to the origin; start with the extreme point w in the direction p.
//! 2. The extreme point w in the direction −v: if even w · v > 0, the plane between separates.
//! 3. Add w to the simplex and find the nearest point of the new simplex, dropping vertices that it does not need
//!    ([`NearestSimplex`]).
//! 4. A simplex around the origin, or a v that is nothing against the simplex, is a hit; a v that comes no nearer is
//!    given up.
//!
//! # Complexity
//! One pass over the n generators for each step, at most [`STEPS`] steps; space O(D²).
//!
//! # Shapes
//! generators: n × D, any order, zero and parallel ones allowed.
//!
//! # Numerics
//! Plain doubles and a relative tolerance, not exact, not scaled: products that overflow end in giving up.
//!
//! # Errors
//! None: failures are answers. More than seven dimensions do not compile.
//!
//! # Checked by
//! [`brute_force`](zonotope::collision::brute_force) on questions that are far from touching; its failures elsewhere
//! are counted, not hidden.
//!
//! # Example
//! ```
//! use rivals::by_gjk::{self, GjkAnswer};
//! use zonotope::collision::Query;
//! let square = [[1.0, 0.0], [0.0, 1.0]];
//! let question = Query::new([0.0, 0.0], [0.5, 0.25], &square).unwrap();
//! assert_eq!(by_gjk::locate(&question, &mut ()), GjkAnswer::Intersecting);
//! ```

use zonotope::collision::Query;
use zonotope::collision::distance::NearestSimplex;
use zonotope::numeric::tolerance::NEAREST_POINT_ROUNDING;
use zonotope::tally::{Operation, Tally};
use zonotope::zonotope::passes::extreme_sum;

use crate::products::dot;

/// The most steps before giving up.
pub const STEPS: u32 = 128;

/// A belief about a displacement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GjkAnswer<const D: usize> {
    /// The zonotope holds the displacement.
    Intersecting,
    /// It does not.
    Disjoint {
        /// A direction that separates, as far as floating point can tell.
        direction: [f64; D],
    },
    /// The steps ran out, came no nearer or left the range of doubles.
    GaveUp,
}

/// One step: the extreme point of Z − p in a direction, and the point of the simplex nearest to the origin with it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step<const D: usize> {
    /// The direction.
    pub direction: [f64; D],
    /// The extreme point.
    pub vertex: [f64; D],
    /// The nearest point; none in the step that ends with a plane between, or that gives up.
    pub nearest: Option<[f64; D]>,
}

/// The belief about a displacement; a step is counted for each evaluation of the support function.
pub fn locate<const D: usize>(question: &Query<'_, D>, tally: &mut dyn Tally) -> GjkAnswer<D> {
    traced(question, tally, &mut |_| ())
}

/// The belief about a displacement, with each step told as it is done.
pub fn traced<const D: usize>(
    question: &Query<'_, D>,
    tally: &mut dyn Tally,
    told: &mut dyn FnMut(Step<D>),
) -> GjkAnswer<D> {
    let [first, second] = question.runs();
    let point: [f64; D] = std::array::from_fn(|i| question.to()[i] - question.from()[i]);
    let mut extreme = |direction: &[f64; D]| -> [f64; D] {
        tally.add(Operation::SearchStep, 1);
        tally.add(Operation::LineEvaluation, question.len() as u64);
        let mut vertex = extreme_sum(first, direction);
        if !second.is_empty() {
            let more = extreme_sum(second, direction);
            vertex.iter_mut().zip(more).for_each(|(sum, v)| *sum += v);
        }
        std::array::from_fn(|i| vertex[i] - point[i])
    };
    let mut direction = point;
    let mut simplex = NearestSimplex::new();
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        let vertex = extreme(&direction);
        let separates = dot(&vertex, &direction) < 0.0;
        let nearest = if separates { None } else { simplex.add(vertex) };
        told(Step { direction, vertex, nearest });
        if separates {
            return GjkAnswer::Disjoint { direction };
        }
        let Some(nearest) = nearest else { return GjkAnswer::GaveUp };
        let distance = dot(&nearest, &nearest);
        if !distance.is_finite() {
            return GjkAnswer::GaveUp;
        }
        if simplex.is_full() || distance <= NEAREST_POINT_ROUNDING * NEAREST_POINT_ROUNDING * simplex.largest_square() {
            return GjkAnswer::Intersecting;
        }
        if distance >= last {
            return GjkAnswer::GaveUp;
        }
        last = distance;
        direction = nearest.map(|v| -v);
    }
    GjkAnswer::GaveUp
}
