//! Minimum total length zonotope over all directions, to any precision, by adding constraints of the dual program as
//! its solutions violate them.
//!
//! # Statement
//! Input: points of R^D, at least one, finite; a precision ε in (0, 1). Output: a zonotope in doubles that contains
//! every point exactly, its total length (the sum of the half-lengths of its generators), and a lower bound of the
//! total lengths of all zonotopes around the points. The ratio of the two is always proven. It is at most 1 + ε unless
//! the search ends before, and [`Outcome`] says whether it is. The search ends before in these cases:
//! - it has taken its work, which is limited by a number of operations, the same for all points and precisions. A small
//!   precision around hundreds of points on the zonotope's boundary, most of all in four dimensions, takes more; the
//!   ratio is that of a net of directions then in space, and in four dimensions that of the last step;
//! - the points are so far from the origin that rounding the centre to doubles costs more than ε;
//! - ε is below 1e-9, where rounding decides. At ε = 1e-9 this happens to some inputs with points nearer to each other
//!   than 1e-6 of the body.
//!
//! # Source
//! The problem of Section 4.3, over all directions where the paper takes a net of them. The dual program has a vector
//! λ_j for each point, with Σ λ_j = 0, and maximises Σ λ_j · p_j while Σ_j |λ_j · v| ≤ 1 for every unit vector v: the
//! zonotope Σ [−1, 1] λ_j has to lie in the unit ball. A vertex of that zonotope is 2 Σ_{j ∈ T} λ_j for a set T of
//! points, those whose multipliers lie on one side of a plane through the origin. So |2 Σ_{j ∈ T} λ_j| ≤ 1 is a
//! second-order cone constraint for each set T, and the multiplier of the constraint is a generator whose direction is
//! free. That is why constraints for sets are added here, where a method that adds directions would need ever more of
//! them near the best ones.
//!
//! # Method
//! 1. Leave out points that lie in a simplex of others: every zonotope around the others contains them.
//! 2. Take coordinates in the affine hull of the points. Two opposite multipliers at two points far apart are a first
//!    lower bound, nearly the best one for a thin body, and the best for points on a line, which are done then: the
//!    shortest segment of doubles contains them. In a plane, find the centre of the shortest zonogon by cutting
//!    planes; edges are the generators, turns of the boundary the multipliers. Then go to 6.
//! 3. Begin with the smallest box around the points as the zonotope. In space, begin with the points, multipliers and
//!    vertices that a coarse net of directions yields; in other dimensions with the farthest points along the axes,
//!    multipliers of zero, and a set for each point alone. Where ε is not far below the ratio that the coarse net
//!    proves, solve the programs along finer nets, and where these prove 1 + ε, go to 6: their cost hardly depends on
//!    the number of points on the boundary, and the zonotope has some hundred generators at most.
//! 4. Take a step of a primal–dual interior-point method (Nesterov and Todd's scaling, Mehrotra's predictor and
//!    corrector) for the sets so far. It yields multipliers, and generators of a zonotope that has every point with a
//!    multiplier as a vertex; residuals of the generators are shared out among them in proportion to their lengths.
//! 5. Find the vertices of Σ [−1, 1] λ_j. The farthest one, at distance ρ, proves the lower bound Σ λ_j · p_j / ρ.
//!    Vertices farther than 1, or nearer to 1 than the duality gap, add their sets. Find the points outside the
//!    zonotope: the generators lengthened to contain them are an upper bound, and some of these points get a
//!    multiplier. Of many points those are looked at that were outside or nearly, and a fourth of the others; all of
//!    them where the zonotope would close a tenth of the gap between the bounds. If the new constraints are violated
//!    by much more than the gap, widen the gap. Forget the sets whose generators fell shortest of their expected
//!    length. Repeat from 4 until the bounds are within ε. In space, take finer nets where the work ends before.
//! 6. Round the generators, and add along the axes the most that they miss of any point.
//! 7. If the ratio is still above 1 + ε, repeat steps 3 to 6 with pairs of doubles.
//!
//! # Complexity
//! n points, m of them with a multiplier, K sets (at most 4 d m, or 1000 if that is more). A step costs O((d m)³ + d² m
//! (K + Δ)), where Δ counts the points by which neighbouring sets differ, some ten for each set. The vertices cost
//! O(m^{d−1} log m), and each look at the points takes a search for a facet for each of them, O(K) and a few steps from
//! where the search before ended. There are some ten to hundred steps, at most 400. Steps, vertices, looks and the
//! programs along nets together end with the work: 3 · 10^9 entries and products of points around up to a thousand
//! points, and up to four times as many around more (`work`). In a plane the method takes O(n log n) for each of some
//! fifty centres. Leaving out points takes some passes over at most 500 points for each point. A step with pairs of
//! doubles costs a constant factor more.
//!
//! # Shapes
//! `points`: n × D, any order, duplicates allowed; `generators`: half-lengths.
//!
//! # Numerics
//! Containment is exact; `length` is rounded up, and `lower_bound` is rounded down after all rounding errors of the
//! vertices are accounted for. Points nearer to a subspace than a relative 1e-13 are treated as points of it, and the
//! generators along the axes make up for that.
//!
//! # Errors
//! [`NonFinite`](super::MinLengthError::NonFinite), [`Empty`](super::MinLengthError::Empty) ⇔ the points are not
//! finite, or none; [`BadEpsilon`](super::MinLengthError::BadEpsilon) ⇔ ε not in (0, 1);
//! [`OutOfRange`](super::MinLengthError::OutOfRange) ⇔ a length exceeds the largest double.
//!
//! # Checked by
//! [`in_the_plane`](super::in_the_plane) for D = 2; vertices of zonotopes, whose own length is the optimum; the check
//! of such answers in the crate `verifier`, which proves ratio and containment anew.
//!
//! # Example
//! ```
//! use zonotope::enclosing::min_total_length::by_vertex_sets::min_length_by_vertex_sets;
//! // a diamond is a zonotope: two generators of half-length sqrt(1/2)
//! let diamond = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];
//! let answer = min_length_by_vertex_sets(&diamond, 1e-9, &mut ())?;
//! assert!((answer.value - 2f64.sqrt()).abs() < 1e-8 && answer.ratio() <= 1.0 + 1e-9);
//! # Ok::<(), zonotope::enclosing::min_total_length::MinLengthError>(())
//! ```

mod cone;
mod finer_nets;
mod interior;
mod members;
mod outer_points;
mod point_set;
mod scalar;
mod set_generation;
mod start;
mod vertex_sets;
mod work;

use super::answer::{MinLengthError, MinLengthZonotope, Outcome};
use super::box_coordinates::BoxCoordinates;
use super::conclude::{around_equal_points, conclude, proven, validate};
use super::frame::Frame;
use super::in_the_plane::min_length_in_plane;
use super::lower_bound::BestBound;
use super::on_a_line::segment_around;
use crate::numeric::double_double::DoubleDouble;
use crate::numeric::linear::dot;
use crate::tally::Tally;
pub(super) use outer_points::outer_points;
use scalar::Scalar;
use set_generation::min_length_by_set_generation;
use work::Work;
pub(super) use work::limit_around;

/// A zonotope around the points whose total length is within 1 + ε of the least possible, counting operations: points
/// read and rounds.
///
/// # Errors
/// When the points or ε are refused.
pub fn min_length_by_vertex_sets<const D: usize>(
    points: &[[f64; D]],
    epsilon: f64,
    tally: &mut dyn Tally,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    validate(points, epsilon)?;
    let outer = outer_points(points);
    let kept: Vec<[f64; D]> = outer.iter().map(|&j| points[j]).collect();
    let mut answer = around_outer(&kept, epsilon, tally)?;
    for multiplier in &mut answer.proof.multipliers {
        multiplier.point = outer[multiplier.point];
    }
    Ok(answer)
}

/// The answer for points none of which is known to lie in a simplex of others.
fn around_outer<const D: usize>(
    points: &[[f64; D]],
    epsilon: f64,
    tally: &mut dyn Tally,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    let frame = Frame::new(points);
    let mut best = BestBound::none();
    if let Some(longest) = frame.long.first() {
        best.improve(frame.rank(), &frame.points, opposite_multipliers(&frame.points, longest), f64::INFINITY);
    }
    match frame.rank() {
        0 => around_equal_points(points),
        1 => on_a_line(points, &frame, &best, epsilon),
        2 if const { D >= 2 } => {
            let (inner, progress) = min_length_in_plane(&frame, epsilon, &mut best);
            let directions = inner.generators.len();
            conclude(points, &frame, inner, &best, progress, directions, epsilon)
        }
        // the condition leaves out of the line and of the plane what is compiled for space alone
        _ if const { D >= 3 } => {
            let mut work = Work::none();
            let answer = around_by_set_generation::<f64, D>(points, &frame, epsilon, &mut best, &mut work, tally)?;
            // Pairs of doubles help where rounding ended the search, not where its work was used up.
            if answer.proof.outcome == Outcome::WithinEpsilon || work.is_used_up(frame.rank()) {
                return Ok(answer);
            }
            work.renew();
            let other =
                around_by_set_generation::<DoubleDouble, D>(points, &frame, epsilon, &mut best, &mut work, tally)?;
            let directions = answer.effort.rows + other.effort.rows;
            let shorter = if other.value < answer.value { other } else { answer };
            let around = (shorter.body, shorter.value);
            Ok(proven(points, &frame, around, &best, shorter.effort.progress, directions, epsilon))
        }
        rank => unreachable!("points of R^{D} span a space of {rank} dimensions"),
    }
}

/// The answer for points on a line: a segment of doubles, if one is within 1 + ε of the least length; else the box
/// around the points in the frame, which is the segment but for rounding.
fn on_a_line<const D: usize>(
    points: &[[f64; D]],
    frame: &Frame<D>,
    best: &BestBound<D>,
    epsilon: f64,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    if let Some(segment) = segment_around(points) {
        let answer = proven(points, frame, segment, best, Vec::new(), 1, epsilon);
        if answer.proof.outcome == Outcome::WithinEpsilon {
            return Ok(answer);
        }
    }
    conclude(points, frame, BoxCoordinates::of(frame).boxed(), best, Vec::new(), 1, epsilon)
}

/// The answer by set generation, for points that span three dimensions or more, with steps in the scalar `R`.
fn around_by_set_generation<R: Scalar, const D: usize>(
    points: &[[f64; D]],
    frame: &Frame<D>,
    epsilon: f64,
    best: &mut BestBound<D>,
    work: &mut Work,
    tally: &mut dyn Tally,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    let found = min_length_by_set_generation::<R, D>(frame, epsilon, best, work, tally);
    conclude(points, frame, found.inner, best, found.progress, found.sets, epsilon)
}

/// Two opposite multipliers, at the two points that are farthest apart along a direction. They prove that half the
/// distance of these points is a lower bound, and for a thin body that is nearly the least total length.
fn opposite_multipliers<const D: usize>(points: &[[f64; D]], direction: &[f64; D]) -> Vec<(usize, [f64; D])> {
    let height = |j: &usize| dot(&points[*j], direction);
    let ends = (0..points.len()).fold((0, 0), |(low, high), j| {
        (if height(&j) < height(&low) { j } else { low }, if height(&j) > height(&high) { j } else { high })
    });
    let apart: [f64; D] = std::array::from_fn(|c| points[ends.1][c] - points[ends.0][c]);
    let twice = 2.0 * dot(&apart, &apart).sqrt();
    vec![(ends.1, apart.map(|c| c / twice)), (ends.0, apart.map(|c| -c / twice))]
}
