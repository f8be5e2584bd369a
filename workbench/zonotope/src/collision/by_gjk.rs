//! Whether a zonotope holds a displacement, by the algorithm of Gilbert, Johnson and Keerthi in floating point: may be
//! wrong, may give up.
//!
//! # Statement
//! Input: a displacement p and generators g_i of R^D, 1 ≤ D ≤ 7. Output: [`GjkAnswer`], a belief without proof.
//! Touching, flat and narrowly missing questions are where it fails; the library's other methods are exact, this one is
//! what they are measured against.
//!
//! # Source
//! None in the paper. The method of physics engines, on the support function of the implicit zonotope.
//!
//! # Method
//! 1. Z − p holds the origin just when p ∈ Z. Keep a simplex of at most D + 1 of its extreme points and the simplex's
//!    point v nearest to the origin; start with the extreme point w in the direction p.
//! 2. The extreme point w in the direction −v: if even w · v > 0, the plane between separates.
//! 3. Add w to the simplex and find the nearest point of the new simplex, dropping vertices that it does not need
//!    (`nearest`).
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
//! None: failures are answers.
//!
//! # Panics
//! Never. More than seven dimensions do not compile.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) on questions that are far from touching; its failures elsewhere are counted, not
//! hidden.
//!
//! # Example
//! ```
//! use zonotope::collision::{Query, by_gjk, by_gjk::GjkAnswer};
//! let square = [[1.0, 0.0], [0.0, 1.0]];
//! let question = Query::new([0.0, 0.0], [0.5, 0.25], &square).unwrap();
//! assert_eq!(by_gjk::locate(&question), GjkAnswer::Intersecting);
//! ```

pub(crate) mod nearest;

use nearest::Simplex;

use crate::numeric::lanes::extreme_sum;
use crate::numeric::linear::dot;
use crate::numeric::tolerance::NEAREST_POINT_ROUNDING;
use crate::tally::{Operation, Tally};
use crate::zonotope::query::Query;

/// The most steps before giving up.
pub const STEPS: u32 = 128;

/// What the method believes.
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

/// What the method believes about a displacement.
pub fn locate<const D: usize>(question: &Query<'_, D>) -> GjkAnswer<D> {
    locate_counted(question, &mut ())
}

/// [`locate`], counting a step for each evaluation of the support function.
pub fn locate_counted<const D: usize>(question: &Query<'_, D>, tally: &mut impl Tally) -> GjkAnswer<D> {
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
    let mut simplex = Simplex::new();
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        let vertex = extreme(&direction);
        if dot(&vertex, &direction) < 0.0 {
            return GjkAnswer::Disjoint { direction };
        }
        let Some(nearest) = simplex.add(vertex) else { return GjkAnswer::GaveUp };
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::brute_force;
    use crate::tally::OperationCounts;
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = [f64; 3]> {
        [-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64]
    }

    proptest! {
        #![proptest_config(crate::property_cases::config(2000))]

        #[test]
        fn far_from_touching_it_is_right(
            generators in proptest::collection::vec(vector(), 3..9),
            p in vector(),
            size in 0.1..6.0f64,
        ) {
            let question = Query::new([0.0; 3], p.map(|v| v * size), &generators).expect("finite");
            let gauge = brute_force::gauge(&question).value;
            prop_assume!(!(0.999..1.001).contains(&gauge));
            let mut counts = OperationCounts::default();
            match locate_counted(&question, &mut counts) {
                GjkAnswer::Intersecting => prop_assert!(gauge < 1.0),
                GjkAnswer::Disjoint { direction } => {
                    let reach: f64 = generators.iter().map(|g| dot(g, &direction).abs()).sum();
                    prop_assert!(gauge > 1.0 && dot(&question.to(), &direction) > reach);
                }
                GjkAnswer::GaveUp => prop_assert!(false, "gave up at a gauge of {}", gauge),
            }
            prop_assert!(counts.get(Operation::SearchStep) <= u64::from(STEPS));
        }
    }

    #[test]
    fn other_dimensions_and_degenerate_bodies() {
        let ask = |to, generators: &[[f64; 2]]| locate(&Query::new([0.0; 2], to, generators).expect("finite"));
        assert_eq!(ask([0.0, 0.0], &[]), GjkAnswer::Intersecting);
        assert!(matches!(ask([1e-9, 0.0], &[[0.0; 2]]), GjkAnswer::Disjoint { .. }));
        assert_eq!(ask([0.5, 0.0], &[[1.0, 0.0]]), GjkAnswer::Intersecting);
        let huge = [[f64::MAX; 2]; 3];
        assert_eq!(ask([1.0, 0.0], &huge), GjkAnswer::GaveUp);
        let line = Query::new([0.0], [1.5], &[[1.0], [0.25]]).map(|q| locate(&q));
        assert!(matches!(line, Ok(GjkAnswer::Disjoint { .. })));
    }
}
