//! Stage: generators in doubles along directions, and the proof that they contain every point, without a generator for
//! the sake of rounding.
//!
//! Products of coefficients and directions are rounded to doubles, so what is proved of the exact products does not
//! hold of them. Generators along the axes could make up for that, as short as rounding errors. Here the rounded
//! generators are taken as directions of their own, with coefficients a little below 1; what the proof adds to these
//! coefficients, rounding errors again, then leaves them at most 1. So the generators contain the points as they are.
//!
//! Directions in doubles do not span a plane of space exactly unless it is a plane of the axes. For points that span
//! less than the space, axes off their plane are directions too, with generators as short as the distance of the points
//! from what the others span; most often that is zero, and there is no such generator.

use super::along::{Along, unit};
use crate::enclosing::fixed_directions::{FixedDirections, contained};
use crate::enclosing::min_total_length::frame::Frame;
use crate::numeric::scaling::scale_by_power_of_two;
use crate::zonotope::Zonotope;

/// Generators are made longer than the linear program has them by the share 16^k · 2^−52, with the least k from 1 to
/// this one that is enough; thin bodies need more than others.
const LAST_POWER: i32 = 8;

/// A zonotope in doubles with the generators of a zonotope of the frame that contains the points exactly, and an upper
/// bound of its total length. `None` if rounding costs more than the last of the shares allows, or a number leaves the
/// range of doubles.
pub(super) fn exactly_around<const D: usize>(
    points: &[[f64; D]],
    frame: &Frame<D>,
    found: &Along<D>,
) -> Option<(Zonotope<D>, f64)> {
    let center = frame.point(&found.center);
    let (directions, coefficients) = found.used();
    let mut vectors: Vec<[f64; D]> = directions.iter().map(|v| frame.outside(v)).collect();
    let mut guess: Vec<f64> = coefficients.iter().map(|c| scale_by_power_of_two(*c, frame.exponent)).collect();
    vectors.extend(axes_off(frame));
    guess.resize(vectors.len(), 0.0);
    let unweighted = |count: usize| vec![1.0; count];
    let weights = unweighted(vectors.len());
    let coefficients = contained(&FixedDirections::new(points, &vectors, &weights).ok()?, center, &guess)?;
    (1..=LAST_POWER).find_map(|power| {
        let share = 16f64.powi(power) * f64::EPSILON;
        let used = vectors.iter().zip(&coefficients).filter(|(_, c)| **c > 0.0);
        let longer = used.map(|(v, c)| v.map(|x| x * (c * (1.0 + share))));
        let generators: Vec<[f64; D]> = longer.filter(|g| g.iter().any(|x| *x != 0.0)).collect();
        let weights = unweighted(generators.len());
        let problem = FixedDirections::new(points, &generators, &weights).ok()?;
        let needed = contained(&problem, center, &vec![1.0 - share / 2.0; generators.len()])?;
        let body = Zonotope::new(center, generators).ok()?;
        let length = body.total_length();
        (needed.iter().all(|c| *c <= 1.0) && length.is_finite()).then_some((body, length))
    })
}

/// As many axes as the frame lacks for all space, those that are farthest from its span.
fn axes_off<const D: usize>(frame: &Frame<D>) -> Vec<[f64; D]> {
    let unit_vector = |axis: usize| std::array::from_fn(|c| f64::from(u8::from(c == axis)));
    let mut span: Vec<[f64; D]> = (0..frame.rank()).map(|axis| frame.outside(&unit_vector(axis))).collect();
    let mut axes = Vec::new();
    while span.len() < D {
        let off = |axis: usize| {
            let rest = |rest: [f64; D], v: &[f64; D]| std::array::from_fn(|c| rest[c] - v[axis] * v[c]);
            span.iter().fold(unit_vector(axis), rest)
        };
        // What is left of an axis off orthonormal vectors has its own coordinate as the square of its length.
        let Some(axis) = (0..D).max_by(|&a, &b| off(a)[a].total_cmp(&off(b)[b])) else { break };
        let Some(next) = unit(&off(axis)) else { break };
        axes.push(unit_vector(axis));
        span.push(next);
    }
    axes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enclosing::min_total_length::few_generators::along::Programs;

    #[test]
    fn a_square_in_a_plane_of_space_has_two_generators_without_rounding() {
        let points = [[0.0, 0.0, 0.1], [1.0, 0.0, 0.1], [0.0, 1.0, 0.1], [1.0, 1.0, 0.1]];
        let frame = Frame::new(&points);
        let along = Programs::new(&frame, 1e-14, u64::MAX).along(&frame.long).expect("they span");
        let (body, length) = exactly_around(&points, &frame, &along).expect("a square");
        assert_eq!(axes_off(&frame), [[0.0, 0.0, 1.0]]);
        assert_eq!(body.generators().len(), 2);
        // along its diagonals: two halves of them
        assert!((length - 2f64.sqrt()).abs() < 1e-12);
        assert!(points.iter().all(|&point| body.contains(point) == Ok(true)));
    }
}
