//! Stage: directions move where that shortens the zonotope, their number being kept.
//!
//! Every direction gets neighbours at a small angle around it, and the linear program is solved along all of them. The
//! generators of one direction and its neighbours are added up: the sum is the generator's next direction. A step that
//! does not shorten the zonotope is taken back, and the angle is halved. The linear program sees all directions at
//! once, which is why such a step gets on where a step of one direction after the other is stuck.

use super::along::{Along, Programs, unit};
use crate::numeric::linear::dot;

/// The angle of the first step, beside the mean angle between neighbouring directions.
const FIRST_SHARE_OF_SPACING: f64 = 0.25;

/// A step is repeated with the same angle if it shortens the zonotope by more than this share of what it could gain.
const LEAST_SHARE_OF_GAIN: f64 = 0.1;

/// The steps end at this angle, beside the first one.
const LEAST_RELATIVE_ANGLE: f64 = 0.02;

/// How many steps are taken, and how short the zonotope has to be for them to end.
#[derive(Clone, Copy)]
pub(super) struct Aim {
    /// The steps end once the total length is at most this.
    pub(super) length: f64,
    /// The steps end after so many.
    pub(super) steps: usize,
}

/// The zonotope after its directions have moved, never longer than before and with no more generators.
pub(super) fn moved<const D: usize>(programs: &Programs<'_, D>, start: Along<D>, aim: Aim) -> Along<D> {
    let rank = programs.frame.rank();
    let mut best = start;
    if rank < 2 {
        return best;
    }
    let spacing = libm::pow(best.count().max(1) as f64, -1.0 / (rank as f64 - 1.0));
    let first = FIRST_SHARE_OF_SPACING * spacing;
    let mut angle = first;
    for _ in 0..aim.steps {
        if best.length <= aim.length || angle < LEAST_RELATIVE_ANGLE * first {
            break;
        }
        let centers: Vec<[f64; D]> = best.generators().iter().filter_map(unit).collect();
        let Some(spread) = programs.along(&around(rank, &centers, angle)) else { break };
        let sums = sums_of_neighbours(rank, &spread);
        let possible = best.length - spread.length;
        match programs.along(&sums) {
            Some(next) if next.length < best.length && next.count() <= best.count() => {
                let gain = best.length - next.length;
                best = next;
                if gain < LEAST_SHARE_OF_GAIN * possible {
                    angle /= 2.0;
                }
            }
            _ => angle /= 2.0,
        }
    }
    best
}

/// For each of some unit vectors, itself and its neighbours at an angle, one to either side along every axis orthogonal
/// to it: 2 `rank` − 1 vectors.
pub(super) fn around<const D: usize>(rank: usize, centers: &[[f64; D]], angle: f64) -> Vec<[f64; D]> {
    let mut around = Vec::with_capacity(centers.len() * (2 * rank - 1));
    for center in centers {
        around.push(*center);
        for across in orthogonal_directions(rank, center) {
            for sign in [angle, -angle] {
                around.push(std::array::from_fn(|c| center[c] + sign * across[c]));
            }
        }
    }
    around
}

/// For each unit vector that neighbours were given by [`around`], the sum of its generator and those of its neighbours.
pub(super) fn sums_of_neighbours<const D: usize>(rank: usize, spread: &Along<D>) -> Vec<[f64; D]> {
    let size = 2 * rank - 1;
    let groups = spread.directions.chunks(size).zip(spread.coefficients.chunks(size));
    let sum = |(directions, coefficients): (&[[f64; D]], &[f64])| {
        let terms = directions.iter().zip(coefficients);
        terms.fold([0.0; D], |sum, (v, x)| std::array::from_fn(|c| sum[c] + x * v[c]))
    };
    groups.map(sum).collect()
}

/// Orthonormal vectors orthogonal to a unit vector of the first `rank` coordinates: its axes after a reflection that
/// takes the first axis to the vector.
fn orthogonal_directions<const D: usize>(rank: usize, unit: &[f64; D]) -> Vec<[f64; D]> {
    let largest = (0..rank).max_by(|&a, &b| unit[a].abs().total_cmp(&unit[b].abs())).unwrap_or(0);
    let sign = if unit[largest] < 0.0 { -1.0 } else { 1.0 };
    let mut normal = unit.map(|c| c * sign);
    normal[largest] += 1.0;
    let square = dot(&normal, &normal);
    (0..rank)
        .filter(|&axis| axis != largest)
        .map(|axis| {
            let along = 2.0 * normal[axis] / square;
            std::array::from_fn(|c| f64::from(u8::from(c == axis)) - along * normal[c])
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enclosing::min_total_length::frame::Frame;

    #[test]
    fn neighbours_are_orthogonal_to_their_direction() {
        let unit = [0.6, 0.0, -0.8];
        let across = orthogonal_directions(3, &unit);
        assert_eq!(across.len(), 2);
        assert!(across.iter().all(|v| dot(v, &unit).abs() < 1e-15 && (dot(v, v) - 1.0).abs() < 1e-15));
        assert!(dot(&across[0], &across[1]).abs() < 1e-15);
    }

    #[test]
    fn two_directions_turn_to_the_sides_of_a_square() {
        let frame = Frame::new(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]);
        let programs = Programs::new(&frame, 1e-9, u64::MAX);
        let start = programs.along(&[[1.0, 0.2], [-0.2, 1.0]]).expect("they span");
        let least = programs.along(&[[1.0, 0.0], [0.0, 1.0]]).expect("they span").length;
        let end = moved(&programs, start.clone(), Aim { length: 0.0, steps: 40 });
        assert!(end.length < start.length && end.length < 1.01 * least && end.count() == 2);
    }
}
