//! The direction to a point from the nearest point of the zonotope of a few generators, in doubles, by an active set:
//! nothing but speed depends on it.
//!
//! Least squares with bounds: all coefficients are 1 or −1 but for those of the active set, at most three, which leave
//! the shortest rest. The generator along which the rest becomes shorter most joins the set, and one whose coefficient
//! comes to its bound leaves it, until there is none. Where bodies nearly touch, the rest is small and the extreme
//! vertices are far away, so that simplices of them are flat to rounding; coefficients and the rest are not.

use crate::numeric::linear::{cross, dot, euclidean_norm, sum_norm};
use crate::numeric::tolerance::UNIT;

/// The most generators that join the set.
const STEP_LIMIT: usize = 64;

/// Roundings by which the rest may be off, in terms of the sum of all lengths.
const ROUNDINGS: f64 = 16.0;

/// Vectors whose determinant is below this part of the product of their lengths are taken for dependent.
const DEPENDENT: f64 = 1e-13;

/// A direction of length 1 and the angle by which rounding may have turned it.
pub(super) struct Guess {
    pub(super) direction: [f64; 3],
    pub(super) doubt: f64,
}

/// The direction to a point outside of the zonotope of some generators, from a vertex that is extreme near another
/// direction; `None` where rounding hides it. O(m) a step.
pub(super) fn direction(generators: &[[f64; 3]], point: [f64; 3], near: &[f64; 3]) -> Option<Guess> {
    let mut coefficients: Vec<f64> = generators.iter().map(|v| 1f64.copysign(dot(v, near))).collect();
    let mut rest = point;
    for (v, c) in generators.iter().zip(&coefficients) {
        take(&mut rest, *c, v);
    }
    let rounding = ROUNDINGS * UNIT * (sum_norm(&point) + generators.iter().map(sum_norm).sum::<f64>());
    let mut active: Vec<usize> = Vec::with_capacity(4);
    for _ in 0..STEP_LIMIT {
        let length = euclidean_norm(&rest);
        // false for NaN as well
        let is_known = length > rounding;
        is_known.then_some(())?;
        let doubt = rounding / length;
        let gain = |i: usize| {
            let v = &generators[i];
            -coefficients[i] * dot(v, &rest) / euclidean_norm(v)
        };
        let waiting = (0..generators.len()).filter(|i| !active.contains(i));
        let best = waiting.map(|i| (gain(i), i)).fold(
            (0.0, None),
            |best, (gain, i)| {
                if gain > best.0 { (gain, Some(i)) } else { best }
            },
        );
        let Some(joining) = best.1.filter(|_| best.0 > doubt * length) else {
            return Some(Guess { direction: rest.map(|c| c / length), doubt });
        };
        active.push(joining);
        settle(generators, &mut active, &mut coefficients, &mut rest)?;
    }
    None
}

/// Moves the coefficients of the active set to where they leave the shortest rest; those that come to a bound on the
/// way leave the set. `None` if its generators are dependent but for rounding, or leave no rest.
fn settle(
    generators: &[[f64; 3]],
    active: &mut Vec<usize>,
    coefficients: &mut [f64],
    rest: &mut [f64; 3],
) -> Option<()> {
    while !active.is_empty() {
        let steps = least_squares(active.iter().map(|&i| generators[i]), rest)?;
        let (mut share, mut leaving) = (1.0, None);
        for (place, (&i, step)) in active.iter().zip(steps).enumerate() {
            let room = (step.signum() - coefficients[i]) / step;
            if (coefficients[i] + step).abs() > 1.0 && room < share {
                (share, leaving) = (room, Some(place));
            }
        }
        for (&i, step) in active.iter().zip(steps) {
            coefficients[i] += share * step;
            take(rest, share * step, &generators[i]);
        }
        let Some(place) = leaving else { break };
        let i = active.remove(place);
        coefficients[i] = coefficients[i].signum();
    }
    (active.len() < 3).then_some(())
}

/// The factors of up to three vectors that leave the shortest rest of a vector.
fn least_squares(mut vectors: impl Iterator<Item = [f64; 3]>, rest: &[f64; 3]) -> Option<[f64; 3]> {
    let (first, second, third) = (vectors.next()?, vectors.next(), vectors.next());
    let square = dot(&first, &first);
    let Some(second) = second else { return Some([dot(&first, rest) / square, 0.0, 0.0]) };
    let normal = cross(&first, &second);
    let area = dot(&normal, &normal);
    let sizes = square * dot(&second, &second);
    let are_independent = area > DEPENDENT * sizes;
    are_independent.then_some(())?;
    let Some(third) = third else {
        let [a, b] = [cross(rest, &second), cross(&first, rest)].map(|c| dot(&c, &normal) / area);
        return Some([a, b, 0.0]);
    };
    let volume = dot(&normal, &third);
    let are_independent = volume * volume > DEPENDENT * sizes * dot(&third, &third);
    are_independent.then_some(())?;
    let [a, b] = [cross(&second, &third), cross(&third, &first)].map(|c| dot(&c, rest) / volume);
    Some([a, b, dot(&normal, rest) / volume])
}

/// Takes a multiple of a vector away from another one.
fn take(rest: &mut [f64; 3], factor: f64, v: &[f64; 3]) {
    *rest = [0, 1, 2].map(|k| rest[k] - factor * v[k]);
}
