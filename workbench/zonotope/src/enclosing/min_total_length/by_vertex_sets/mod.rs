//! Minimum total length zonotope, by adding the directions that the dual zonotope names, to any precision.
//!
//! # Statement
//! Input: points of R^D, at least one, finite; a precision ε in (0, 1). Output: a zonotope in doubles that contains every point exactly, its total
//! length (the sum of the half-lengths of its generators), and a lower bound for all zonotopes around the points, whose ratio is
//! at most 1 + ε unless the search ends before (half a minute of work: in space more than about 500 points that the zonotope touches; a centre in doubles for points far from the
//! origin; rounding below 1e-9, and at 1e-9 now and then where points are nearer to each other than 1e-6 of the body): the ratio is always proven and told, and so is
//! whether it is at most 1 + ε ([`Outcome`]).
//!
//! # Source
//! The problem of Section 4.3, over all directions rather than a net. The dual: vectors λ_j at the points with Σ λ_j = 0 that maximise Σ λ_j · p_j while
//! Σ_j |λ_j · v| ≤ 1 for every unit vector v, that is, while the zonotope Σ [−1, 1] λ_j lies in the unit ball. A vertex of it is 2 Σ_{j ∈ T} λ_j for a set T of points on one
//! side of a plane; |2 Σ_{j ∈ T} λ_j| ≤ 1 is a round constraint, and its multiplier a generator whose direction is free. So columns are sets, not directions.
//!
//! # Method
//! 1. Points in a simplex of others are left out: what contains those contains them.
//! 2. The affine hull of the points. In a plane: the centre O with the shortest zonogon, by cutting off half-planes; edges give the generators, turns of the boundary the multipliers.
//! 3. Else begin with a box around the points and two opposite multipliers, which are nearly the answer for a thin body; then with a coarse net (space) or the farthest points along
//!    the axes, their multipliers, and some sets T.
//! 4. A step of an interior point method (primal and dual at once, scaled after Nesterov and Todd, corrected after Mehrotra) for the sets so far, which may begin beyond their
//!    limits; it yields multipliers, and generators for which every point with a multiplier is a vertex, after what they still miss is shared out among them in proportion to their lengths.
//! 5. The vertices of Σ [−1, 1] λ_j: the farthest one, at distance ρ, proves the lower bound Σ λ_j · p_j / ρ; those farther than 1, or nearer to it than the gap, are sets to add.
//!    The generator of a new set begins no longer than the body is along it and than the points that it parts are near each other. Points outside the zonotope are added; one
//!    near another joins its sets. Where vertices are far beyond 1 then, the gap is widened. Lengthened until it contains all points the zonotope is an upper bound. Sets that bear
//!    least of what they were expected to are forgotten. Again from 4 until the bounds are within ε.
//! 6. Generators rounded; what they miss of any point is added along the axes.
//! 7. Where the ratio is still above 1 + ε: all of that anew in pairs of doubles.
//!
//! # Complexity
//! With m points that have a multiplier and K sets (at most 4 d m): a step costs O((d m)³ + d² m Δ), Δ the number of points by which neighbouring sets differ, some ten for
//! each set; the vertices O(m^{d−1} log m), a look at all n points a facet search each. Some ten to hundred steps. In a plane O(n log n) for each of some fifty centres. Leaving out
//! points: some passes over at most 500 points for each. Pairs of doubles make a step some fifty times as dear. The number of steps has no useful bound.
//!
//! # Shapes
//! `points`: n × D, any order, duplicates allowed; `generators`: half-lengths.
//!
//! # Numerics
//! Containment is exact; `length` is rounded up, `lower_bound` down with all rounding errors of the vertices accounted for. Points nearer to a subspace than
//! a relative 1e-13 are treated as flat.
//!
//! # Errors
//! [`NonFinite`](super::MinLengthError::NonFinite), [`Empty`](super::MinLengthError::Empty) ⇔ the points are not finite, or none; [`BadEpsilon`](super::MinLengthError::BadEpsilon) ⇔ ε not in (0, 1);
//! [`OutOfRange`](super::MinLengthError::OutOfRange) ⇔ a length is no double.
//!
//! # Panics
//! Never.
//!
//! # Checked by
//! [`in_the_plane`](super::in_the_plane) for D = 2; [`verify`](super::verify) on answers; vertices of zonotopes, whose own length is the optimum; the ratio proves itself.
//!
//! # Example
//! ```
//! use zonotope::enclosing::min_total_length::min_length_enclosing;
//! // a diamond is a zonotope: two generators of half-length sqrt(1/2)
//! let diamond = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];
//! let answer = min_length_enclosing(&diamond, 1e-9)?;
//! assert!((answer.length - 2f64.sqrt()).abs() < 1e-8 && answer.ratio <= 1.0 + 1e-9);
//! # Ok::<(), zonotope::enclosing::min_total_length::MinLengthError>(())
//! ```

mod interior;
mod members;
mod outer_points;
mod point_set;
mod set_generation;
mod start;
mod vertex_sets;

use super::answer::{MinLengthError, MinLengthZonotope, Outcome};
use super::conclude::{around_equal_points, conclude, proven, validate};
use super::frame::Frame;
use super::in_the_plane::least_in_plane;
use super::lower_bound::Best;
use crate::numeric::double_double::DoubleDouble;
use crate::tally::Tally;
use crate::zonotope::ray_exit::dot;
use interior::scalar::Scalar;
use outer_points::outer_points;
use set_generation::least_by_vertex_sets;

/// A zonotope around the points whose total length is within 1 + ε of the least possible.
///
/// # Errors
/// When the points or ε are refused.
pub fn min_length_enclosing<const D: usize>(
    points: &[[f64; D]],
    epsilon: f64,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    min_length_enclosing_counted(points, epsilon, &mut ())
}

/// As [`min_length_enclosing`], counting operations: points read and rounds.
///
/// # Errors
/// When the points or ε are refused.
pub fn min_length_enclosing_counted<const D: usize>(
    points: &[[f64; D]],
    epsilon: f64,
    tally: &mut impl Tally,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    validate(points, epsilon)?;
    let outer = outer_points(points);
    let kept: Vec<[f64; D]> = outer.iter().map(|&j| points[j]).collect();
    let mut answer = around_outer(&kept, epsilon, tally)?;
    for multiplier in &mut answer.multipliers {
        multiplier.point = outer[multiplier.point];
    }
    Ok(answer)
}

fn around_outer<const D: usize>(
    points: &[[f64; D]],
    epsilon: f64,
    tally: &mut impl Tally,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    let frame = Frame::new(points);
    let mut best = Best::none();
    if let Some(pull) = frame.long.first() {
        best.improve(frame.rank(), &frame.points, opposite_pulls(&frame.points, pull), f64::INFINITY);
    }
    match frame.rank() {
        0 => around_equal_points(points),
        2 => {
            let (inner, progress) = least_in_plane(&frame, epsilon, &mut best);
            let directions = inner.generators.len();
            conclude(points, &frame, inner, &best, progress, directions, epsilon)
        }
        _ => {
            let mut work = 0.0;
            let answer = around_hull::<f64, D>(points, &frame, epsilon, &mut best, &mut work, tally)?;
            if answer.outcome == Outcome::WithinEpsilon {
                return Ok(answer);
            }
            let other = around_hull::<DoubleDouble, D>(points, &frame, epsilon, &mut best, &mut work, tally)?;
            let directions = answer.directions + other.directions;
            let shorter = if other.length < answer.length { other } else { answer };
            let around = (shorter.zonotope, shorter.length);
            Ok(proven(points, &frame, around, &best, shorter.progress, directions, epsilon))
        }
    }
}

/// Around points that span three dimensions or more, with steps in numbers of some precision.
fn around_hull<R: Scalar, const D: usize>(
    points: &[[f64; D]],
    frame: &Frame<D>,
    epsilon: f64,
    best: &mut Best<D>,
    work: &mut f64,
    tally: &mut impl Tally,
) -> Result<MinLengthZonotope<D>, MinLengthError> {
    let found = least_by_vertex_sets::<R, D>(frame, epsilon, best, work, tally);
    conclude(points, frame, found.inner, best, found.progress, found.sets, epsilon)
}

/// Multipliers that pull the two points farthest along a direction apart: they prove half the distance of these, which is nearly all of a thin body's length.
fn opposite_pulls<const D: usize>(points: &[[f64; D]], direction: &[f64; D]) -> Vec<(usize, [f64; D])> {
    let height = |j: &usize| dot(&points[*j], direction);
    let ends = (0..points.len()).fold((0, 0), |(low, high), j| {
        (if height(&j) < height(&low) { j } else { low }, if height(&j) > height(&high) { j } else { high })
    });
    let apart: [f64; D] = std::array::from_fn(|c| points[ends.1][c] - points[ends.0][c]);
    let twice = 2.0 * dot(&apart, &apart).sqrt();
    vec![(ends.1, apart.map(|c| c / twice)), (ends.0, apart.map(|c| -c / twice))]
}
