//! The minimum of a smooth function of many variables: the quasi-Newton method with limited memory (L-BFGS).
//!
//! The matrix of second derivatives is not formed; the last steps with the changes of the gradient stand for it. A step
//! is halved until the function falls as much as its slope promises.

use crate::numeric::lanes::product_in_eights;
use crate::numeric::linear::add_multiple;

/// Steps that are remembered.
const MEMORY: usize = 12;

/// The share of the fall that the slope promises which a step has to reach.
const LEAST_FALL: f64 = 1e-4;

/// The factor by which a step is shortened, and how often at most.
const SHORTENING: f64 = 0.4;
const SHORTENING_LIMIT: usize = 12;

/// A step, the change of the gradient along it, and the inverse of their product.
struct Step {
    change: Vec<f64>,
    gradient: Vec<f64>,
    inverse_product: f64,
}

/// Moves a point downhill, at most `steps` times; `evaluate` writes the gradient and returns the value. The first step
/// has the length `first`.
pub(super) fn minimize(
    point: &mut Vec<f64>,
    steps: usize,
    first: f64,
    mut evaluate: impl FnMut(&[f64], &mut [f64]) -> f64,
) {
    let mut gradient = vec![0.0; point.len()];
    let mut value = evaluate(point, &mut gradient);
    let mut memory: Vec<Step> = Vec::with_capacity(MEMORY + 1);
    let mut next_gradient = gradient.clone();
    for _ in 0..steps {
        let direction = newton_direction(&memory, &gradient, first);
        let slope = product_in_eights(&gradient, &direction);
        if !slope.is_finite() || slope <= 0.0 {
            return;
        }
        let mut length = 1.0;
        let mut next = None;
        for _ in 0..SHORTENING_LIMIT {
            let mut tried = point.clone();
            add_multiple(&mut tried, -length, &direction);
            let there = evaluate(&tried, &mut next_gradient);
            if there <= value - LEAST_FALL * length * slope {
                next = Some((tried, there));
                break;
            }
            length *= SHORTENING;
        }
        let Some((tried, there)) = next else { return };
        let difference = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a - b).collect::<Vec<f64>>();
        let (change, turned) = (difference(&tried, point), difference(&next_gradient, &gradient));
        let product = product_in_eights(&change, &turned);
        if product > 0.0 {
            memory.push(Step { change, gradient: turned, inverse_product: 1.0 / product });
            if memory.len() > MEMORY {
                memory.remove(0);
            }
        }
        (*point, value) = (tried, there);
        std::mem::swap(&mut gradient, &mut next_gradient);
    }
}

/// The gradient times an estimate of the inverse of the second derivatives.
fn newton_direction(memory: &[Step], gradient: &[f64], first: f64) -> Vec<f64> {
    let mut direction = gradient.to_vec();
    let mut shares = Vec::with_capacity(memory.len());
    for step in memory.iter().rev() {
        let share = product_in_eights(&step.change, &direction) * step.inverse_product;
        add_multiple(&mut direction, -share, &step.gradient);
        shares.push(share);
    }
    let factor = match memory.last() {
        Some(step) => 1.0 / (step.inverse_product * product_in_eights(&step.gradient, &step.gradient)),
        None => first / product_in_eights(gradient, gradient).sqrt(),
    };
    direction.iter_mut().for_each(|c| *c *= factor);
    for (step, share) in memory.iter().zip(shares.iter().rev()) {
        let other = product_in_eights(&step.gradient, &direction) * step.inverse_product;
        add_multiple(&mut direction, share - other, &step.change);
    }
    direction
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bottom_of_a_valley() {
        let mut point = vec![-1.2, 1.0];
        minimize(&mut point, 100, 0.1, |x, gradient| {
            let (a, b) = (1.0 - x[0], x[1] - x[0] * x[0]);
            gradient.copy_from_slice(&[-2.0 * a - 400.0 * x[0] * b, 200.0 * b]);
            a * a + 100.0 * b * b
        });
        assert!((point[0] - 1.0).abs() < 1e-5 && (point[1] - 1.0).abs() < 1e-5, "{point:?}");
    }
}
