//! The proofs of the library's answers of Sections 4.2 and 4.3, checked from their definition.

use dashu_ratio::RBig;
use zonotope::enclosing::fixed_directions::{DirectedZonotope, FixedDirections};
use zonotope::enclosing::min_total_length::MinLengthZonotope;

use crate::definitions::enclosing::{Row, absolute, dot, exact_rows, first_outside, root_above};
use crate::definitions::ratio::{exactly, fraction, integer};
use crate::definitions::space::{Body, Vector};

/// The relative excess that the sum of rounded lengths may have over the exact one.
fn rounding() -> RBig {
    fraction(1, 1_000_000_000_000)
}

/// Whether a zonotope along given directions contains every point, costs what it says, and has forces that prove its
/// lower bound.
pub(crate) fn check_directed<const D: usize>(
    problem: &FixedDirections<'_, D>,
    answer: &DirectedZonotope<D>,
) -> Result<(), String> {
    let (points, directions) = (exact_rows(problem.points()), exact_rows(problem.directions()));
    let coefficients: Row = answer.coefficients.iter().copied().map(exactly).collect();
    let weights: Row = problem.weights().iter().copied().map(exactly).collect();
    let value = dot(&weights, &coefficients);
    if coefficients.iter().any(|c| *c < RBig::ZERO) || exactly(answer.value) < value {
        return Err(format!("the value {} is not that of the coefficients", answer.value));
    }
    let generators: Vec<Row> =
        directions.iter().zip(&coefficients).map(|(v, c)| v.iter().map(|x| x * c).collect()).collect();
    let center: Row = answer.center.iter().copied().map(exactly).collect();
    if let Some(point) = first_outside(&center, &generators, &points) {
        return Err(format!("point {point} is outside"));
    }
    let forces: Vec<(usize, Row)> =
        answer.multipliers.iter().map(|force| (force.point, force.vector.to_vec())).collect();
    let gain = balanced_gain(&forces, &points, D)?;
    for (v, weight) in directions.iter().zip(&weights) {
        let load = forces.iter().fold(RBig::ZERO, |sum, (_, force)| sum + absolute(dot(force, v)));
        if load > *weight {
            return Err("a direction is loaded beyond its weight".to_owned());
        }
    }
    if exactly(answer.lower_bound) > gain {
        return Err(format!("the lower bound {} is above what the forces prove", answer.lower_bound));
    }
    Ok(())
}

/// Σ λ_j · p_j of forces that add up to zero.
fn balanced_gain(forces: &[(usize, Row)], points: &[Row], dimension: usize) -> Result<RBig, String> {
    let mut sum = vec![RBig::ZERO; dimension];
    let mut gain = RBig::ZERO;
    for (point, force) in forces {
        gain += dot(force, points.get(*point).ok_or("a force pulls at no point")?);
        sum.iter_mut().zip(force).for_each(|(sum, c)| *sum += c);
    }
    if sum.iter().any(|c| *c != RBig::ZERO) {
        return Err("the forces do not add up to zero".to_owned());
    }
    Ok(gain)
}

/// Whether a zonotope contains every point, its length is what it says, and its forces prove the lower bound for all
/// directions: the farthest vertex of Σ [−1, 1] λ_j, found by looking at every vertex, divides Σ λ_j · p_j. In the
/// plane and in space.
pub(crate) fn check_shortest<const D: usize>(points: &[[f64; D]], answer: &MinLengthZonotope<D>) -> Result<(), String> {
    let points = exact_rows(points);
    let generators = exact_rows(answer.body.generators());
    let center: Row = answer.body.center().iter().copied().map(exactly).collect();
    if let Some(point) = first_outside(&center, &generators, &points) {
        return Err(format!("point {point} is outside"));
    }
    if exactly(answer.value) * (RBig::ONE + rounding()) < length(&generators) {
        return Err(format!("the generators are longer than {}", answer.value));
    }
    let forces: Vec<(usize, Row)> = answer
        .proof
        .multipliers
        .iter()
        .map(|force| (force.point, force.vector.iter().copied().map(exactly).collect()))
        .collect();
    let gain = balanced_gain(&forces, &points, D)?;
    let vectors: Vec<Row> = forces.into_iter().map(|(_, force)| force).collect();
    let farthest = farthest_vertex_squared(&vectors, D).ok_or("the forces do not span")?;
    let lower = exactly(answer.lower_bound);
    if &lower * &lower * farthest > &gain * &gain || (gain < RBig::ZERO && lower > RBig::ZERO) {
        return Err(format!("the lower bound {} is above what the forces prove", answer.lower_bound));
    }
    let ratio = exactly(answer.value) / lower;
    if ratio > exactly(answer.ratio()) {
        return Err(format!("the ratio is above {}", answer.ratio()));
    }
    Ok(())
}

/// Σ |g_i|, rounded up.
pub(crate) fn length(generators: &[Row]) -> RBig {
    generators.iter().fold(RBig::ZERO, |sum, g| sum + root_above(&dot(g, g)))
}

/// The square of the distance of the farthest vertex of Σ [−1, 1] λ_j from the origin; `None` when the vectors of space
/// do not span it.
fn farthest_vertex_squared(vectors: &[Row], dimension: usize) -> Option<RBig> {
    if dimension == 2 {
        let vertices = vectors.iter().flat_map(|own| {
            let across = [-&own[1], own[0].clone()];
            let mut ends = [[RBig::ZERO, RBig::ZERO], [RBig::ZERO, RBig::ZERO]];
            for v in vectors {
                // Across the vector itself its own sign, and that of parallel ones, is free: two vertices.
                let side = dot(&across, v);
                let along = dot(own, v);
                let sign = |free: i64| {
                    let decides = if side == RBig::ZERO { &along * integer(free) } else { side.clone() };
                    integer(if decides < RBig::ZERO { -1 } else { 1 })
                };
                for (end, free) in ends.iter_mut().zip([1, -1]) {
                    let sign = sign(free);
                    end.iter_mut().zip(v).for_each(|(sum, c)| *sum += &sign * c);
                }
            }
            ends
        });
        return vertices.map(|vertex| dot(&vertex, &vertex)).max();
    }
    let generators = vectors.iter().map(|v| Vector(std::array::from_fn(|c| v[c].clone()))).collect();
    let body = Body { center: Vector::at([0; 3]), generators };
    body.vertices().iter().map(|vertex| vertex.dot(vertex)).max()
}
