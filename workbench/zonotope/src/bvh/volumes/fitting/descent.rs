//! All generators of a covering moved at once, by linear programs of small steps.
//!
//! The covering with the least value of its aim among all directions is a nonlinear program: the facet through
//! generators v_a and v_b has the normal N = v_a × v_b, and each point q has to fulfil
//! F = Σ |v_i · N| + N · p − N · q ≥ 0. With r = Σ sgn(v_i · N) v_i + p − q its differential is
//! dF = dv_a · (v_b × r) + dv_b · (r × v_a) + N · dp + Σ sgn(v_i · N) N · dv_i, the last sum over the other
//! generators. A step solves the program with both F and the aim replaced by their differentials, each generator moved
//! by at most a share of its length, then the half-lengths along the new directions. A step that gains nothing makes
//! the share smaller.

use super::covering::{Aim, Covering, unit};
use super::normals::{Normal, normals_of_pairs};
use super::program::Program;
use crate::numeric::linear::{cross, dot, euclidean_norm};

/// The first share of its length by which a generator may move.
const FIRST_SHARE: f64 = 0.5;

/// A search ends below this share.
const LEAST_SHARE: f64 = 0.02;

/// A gain below this, relative to the aim, is none.
const LEAST_GAIN: f64 = 1e-4;

/// Generators count as at least this long, relative to the points' size 1, so that all of them have a direction.
const LEAST_LENGTH: f64 = 1e-3;

/// Points of a facet that the differentials watch: those that are farthest along its normal.
const POINTS_OF_A_FACET: usize = 4;

/// The covering after a number of steps, or after fewer where no small step of all generators makes it better.
pub(super) fn descend(points: &[[f64; 3]], mut best: Covering, steps: usize) -> Covering {
    let mut value = best.value();
    let mut share = FIRST_SHARE;
    for _ in 0..steps {
        let next = step(points, &best, share).filter(|next| next.value() < value * (1.0 - LEAST_GAIN));
        if let Some(next) = next {
            (value, best) = (next.value(), next);
        } else {
            share *= 0.35;
            if share < LEAST_SHARE {
                break;
            }
        }
    }
    best
}

/// The covering along the directions that the linear program of a step finds.
fn step(points: &[[f64; 3]], covering: &Covering, share: f64) -> Option<Covering> {
    let count = covering.directions.len();
    let lengths = covering.half_lengths.iter().map(|c| c.max(LEAST_LENGTH));
    let generators: Vec<[f64; 3]> =
        covering.directions.iter().zip(lengths.clone()).map(|(d, c)| d.map(|x| x * c)).collect();
    // unknowns from 0 to 2: moves of the generators and of the centre, in units of the largest ones, plus 1; where the
    // aim falls with a move, its opposite, so that no cost is negative
    let gradient = gradient(covering.aim, &generators);
    let reaches = lengths.flat_map(|c| [share * c; 3]).chain([share; 3]);
    let slopes = gradient.iter().flatten().copied().chain([0.0; 3]);
    let units: Vec<f64> = reaches.zip(slopes).map(|(reach, slope)| if slope < 0.0 { -reach } else { reach }).collect();
    let mut costs: Vec<f64> = gradient.iter().flatten().copied().chain([0.0; 3]).collect();
    costs.iter_mut().zip(&units).for_each(|(cost, unit)| *cost *= unit);
    let largest = costs.iter().fold(0.0, |m: f64, c| m.max(*c));
    if !largest.is_normal() {
        return None;
    }
    costs.iter_mut().for_each(|cost| *cost /= largest);

    let normals = normals_of_pairs(&covering.directions);
    let mut rows: Vec<(Vec<f64>, f64)> = Vec::new();
    for normal in &normals {
        for side in [1.0, -1.0] {
            for point in farthest(points, &normal.unit.map(|c| c * side), share) {
                rows.push(row(&generators, covering, normal, side, &point, &units));
            }
        }
    }
    let unknowns = units.len();
    let mut program = Program::with_room(unknowns, rows.len() + unknowns);
    rows.into_iter().for_each(|(coefficients, right)| program.add_inequality(coefficients, right));
    for bounded in 0..unknowns {
        program.add_inequality((0..unknowns).map(|k| if k == bounded { -1.0 } else { 0.0 }), -2.0);
    }
    let found = program.minimize(&costs)?;
    let moved = |k: usize, axis: usize| generators[k][axis] + units[3 * k + axis] * (found[3 * k + axis] - 1.0);
    let moved: Vec<[f64; 3]> = (0..count).map(|k| [0, 1, 2].map(|axis| moved(k, axis))).collect();
    let directions: Vec<[f64; 3]> = moved.iter().map(unit).collect::<Option<_>>()?;
    let half_lengths = moved.iter().map(euclidean_norm).collect();
    let guess = Covering { directions, half_lengths, ..*covering };
    Covering::with_weights(covering.aim, points, &guess.directions, guess.weights())
}

/// The differential of F for a point on one side of a facet, and the right side of its inequality.
fn row(
    generators: &[[f64; 3]],
    covering: &Covering,
    normal: &Normal,
    side: f64,
    point: &[f64; 3],
    units: &[f64],
) -> (Vec<f64>, f64) {
    let u = normal.unit.map(|c| c * side);
    let [a, b] = normal.pair;
    let mut rest: [f64; 3] = std::array::from_fn(|k| covering.center[k] - point[k]);
    let mut coefficients = vec![0.0; units.len()];
    for (i, v) in generators.iter().enumerate().filter(|(i, _)| *i != a && *i != b) {
        let sign = if dot(v, &u) < 0.0 { -1.0 } else { 1.0 };
        for k in 0..3 {
            rest[k] += sign * v[k];
            coefficients[3 * i + k] = sign * u[k];
        }
    }
    let value = dot(&rest, &u);
    // the normal in units of length: |v_a × v_b|
    let length = side * normal.sine * euclidean_norm(&generators[a]) * euclidean_norm(&generators[b]);
    let (of_a, of_b) = (cross(&generators[b], &rest), cross(&rest, &generators[a]));
    for k in 0..3 {
        coefficients[3 * a + k] = of_a[k] / length;
        coefficients[3 * b + k] = of_b[k] / length;
        coefficients[3 * generators.len() + k] = u[k];
    }
    coefficients.iter_mut().zip(units).for_each(|(c, unit)| *c *= unit);
    // a little more room than there is: rounding must not leave the present place outside
    let right = coefficients.iter().sum::<f64>() - value.max(0.0) - 1e-12;
    (coefficients, right)
}

/// The points that are farthest along a direction: no farther from the last of them than a share of the size.
fn farthest(points: &[[f64; 3]], direction: &[f64; 3], share: f64) -> impl Iterator<Item = [f64; 3]> {
    let mut found = [(f64::NEG_INFINITY, [0.0; 3]); POINTS_OF_A_FACET];
    for point in points {
        let height = dot(point, direction);
        if height > found[POINTS_OF_A_FACET - 1].0 {
            found[POINTS_OF_A_FACET - 1] = (height, *point);
            for k in (1..POINTS_OF_A_FACET).rev() {
                if found[k].0 > found[k - 1].0 {
                    found.swap(k, k - 1);
                }
            }
        }
    }
    let least = found[0].0 - share;
    found.into_iter().filter(move |(height, _)| *height >= least).map(|(_, point)| point)
}

/// The derivatives of an aim by the coordinates of the generators.
fn gradient(aim: Aim, generators: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let (mut length, mut area) = (0.0, 0.0);
    let mut of_area = vec![[0.0; 3]; generators.len()];
    let mut of_volume = vec![[0.0; 3]; generators.len()];
    let add = |to: &mut [f64; 3], factor: f64, v: &[f64; 3]| (0..3).for_each(|k| to[k] += factor * v[k]);
    for (k, c) in generators.iter().enumerate() {
        length += 2.0 * euclidean_norm(c);
        for (j, b) in generators[..k].iter().enumerate() {
            let normal = cross(b, c);
            area += 4.0 * euclidean_norm(&normal);
            if let Some(u) = unit(&normal) {
                add(&mut of_area[k], 4.0, &cross(&u, b));
                add(&mut of_area[j], 4.0, &cross(c, &u));
            }
            for (i, a) in generators[..j].iter().enumerate() {
                let sign = if dot(a, &normal) < 0.0 { -8.0 } else { 8.0 };
                add(&mut of_volume[i], sign, &normal);
                add(&mut of_volume[j], sign, &cross(c, a));
                add(&mut of_volume[k], sign, &cross(a, b));
            }
        }
    }
    let of_generator = |(k, v): (usize, &[f64; 3])| -> [f64; 3] {
        let along = 2.0 * area / euclidean_norm(v);
        std::array::from_fn(|i| {
            aim.of_surface * (along * v[i] + length * of_area[k][i]) + aim.of_volume * of_volume[k][i]
        })
    };
    generators.iter().enumerate().map(of_generator).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gradient_is_the_slope_of_the_aim() {
        let generators = [[1.0, 0.25, 0.0], [0.0, 2.0, 0.5], [0.5, 0.0, 3.0], [1.0, -1.0, 0.5]];
        let aim = |generators: &[[f64; 3]]| crate::bvh::volume::expected_overlaps_of_generators(generators);
        for (k, slopes) in gradient(Aim::EXPECTED_OVERLAPS, &generators).iter().enumerate() {
            for (axis, slope) in slopes.iter().enumerate() {
                let moved = |by: f64| {
                    let mut moved = generators;
                    moved[k][axis] += by;
                    aim(&moved)
                };
                let measured = (moved(1e-4) - moved(-1e-4)) / 2e-4;
                assert!((slope - measured).abs() < 1e-5 * measured.abs().max(1.0), "{slope} {measured}");
            }
        }
    }
}
