//! A body seen from a point of the axis, over a power of two: no product of its numbers overflows.

use super::plane::Projection;
use crate::motion::scalar::Scalar;
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{difference, exact};
use crate::numeric::scaling::{PowerOfTwo, binary_exponent, largest_magnitude};
use crate::numeric::tolerance::SMALLEST;
use crate::zonotope::Zonotope;
use crate::zonotope::zonogon::rightward;

/// The centre seen from a point, and the generators, over 2^exponent.
#[derive(Debug)]
pub(in super::super) struct ScaledBody<'a> {
    pub(in super::super) exponent: i64,
    /// The vector from the point to the centre.
    pub(in super::super) arm: BoundedVector,
    generators: &'a [[f64; 3]],
    factor: PowerOfTwo,
}

impl<'a> ScaledBody<'a> {
    /// The body seen from a point.
    pub(in super::super) fn of(body: &'a Zonotope<3>, point: [f64; 3]) -> Self {
        let arm = difference(&exact(body.center()), &exact(point));
        let longest = binary_exponent(largest_magnitude(body.generators().as_flattened())).map(i64::from);
        let exponent = arm.iter().filter_map(Dyadic::binary_exponent).chain(longest).max().unwrap_or(0);
        let arm = arm.map(|c| Bounded::near(&c.scaled(-exponent)));
        Self { exponent, arm, generators: body.generators(), factor: PowerOfTwo::new(-exponent) }
    }

    /// The generators.
    pub(in super::super) fn generators(&self) -> impl ExactSizeIterator<Item = BoundedVector> + '_ {
        self.generators.iter().map(|g| {
            g.map(|c| {
                let value = self.factor.apply(c);
                let is_exact = c == 0.0 || value.abs() >= f64::MIN_POSITIVE;
                Bounded { value, error: if is_exact { 0.0 } else { SMALLEST } }
            })
        })
    }

    /// The generators that are not zero, projected and turned to the right, and a bound of the sum of the distances of
    /// all of them from the exact ones.
    pub(in super::super) fn projected(&self, projection: &Projection) -> (Vec<[f64; 2]>, f64) {
        let mut projected = Vec::with_capacity(self.generators.len());
        let mut magnitudes = [0.0; 3];
        let mut is_any_tiny = false;
        for g in self.generators {
            let v = g.map(|c| self.factor.apply(c));
            for k in 0..3 {
                magnitudes[k] += v[k].abs();
                is_any_tiny |= g[k] != 0.0 && v[k].abs() < f64::MIN_POSITIVE;
            }
            let shadow = rightward(projection.of(v));
            if shadow != [0.0; 2] {
                projected.push(shadow);
            }
        }
        let terms = self.generators.len() as f64;
        // in each of two coordinates three scaled ones and three products underflow, and three products of the bound
        let may_underflow = is_any_tiny || (!projection.is_exact() && magnitudes != [0.0; 3]);
        let underflow = if may_underflow { 16.0 * terms * SMALLEST } else { 0.0 };
        (projected, (projection.off(magnitudes) + underflow) * (1.0 + (terms + 4.0) * f64::EPSILON))
    }
}
