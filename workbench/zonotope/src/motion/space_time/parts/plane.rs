//! The axis of a rotation and two directions that span the plane orthogonal to it.

use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, exact};
use crate::numeric::linear::euclidean_norm;
use crate::numeric::tolerance::{FIVE_ROUNDINGS, ROUNDED_UNIT_VECTOR, SMALLEST, UNIT};

/// The axis a, and f and g = a × f orthogonal to it: a right-handed frame.
#[derive(Debug, Clone)]
pub(in super::super) struct Plane {
    /// f and g, exactly.
    pub(in super::super) directions: [ExactVector; 2],
    /// Lower bounds of their lengths.
    pub(in super::super) lengths: [f64; 2],
    /// The unit vectors of a, f and g; a coordinate that is exactly zero has no error.
    units: [BoundedVector; 3],
}

impl Plane {
    /// The plane orthogonal to an axis that is not zero.
    pub(in super::super) fn orthogonal_to(axis: [f64; 3]) -> Self {
        let axis = shortened(&exact(axis));
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &k| axis[k].clone().abs().cmp(&axis[i].clone().abs()));
        // (a_i, a_k) turned by a quarter, of the two largest coordinates: no coordinate of g cancels
        let mut first = [const { None }; 3];
        first[order[0]] = Some(-axis[order[1]].clone());
        first[order[1]] = Some(axis[order[0]].clone());
        let first = shortened(&first.map(|c| c.unwrap_or_else(Dyadic::zero)));
        let second = shortened(&cross(&axis, &first));
        let [a, f, g] = [&axis, &first, &second].map(unit);
        Self { directions: [first, second], lengths: [f.1, g.1], units: [a.0, f.0, g.0] }
    }

    /// The coordinates of a vector along a, f and g.
    pub(in super::super) fn coordinates(&self, v: &BoundedVector) -> [Bounded; 3] {
        self.units.each_ref().map(|unit| products([0, 1, 2].map(|k| (unit[k], v[k]))))
    }

    /// The coordinates along f and g alone, for vectors of doubles.
    pub(in super::super) fn projection(&self) -> Projection {
        let [_, f, g] = &self.units;
        let rounding = |unit: &Bounded| (unit.error + 3.0 * UNIT * unit.value.abs()) * FIVE_ROUNDINGS;
        // the product with a coordinate that is 0, 1 or −1 is exact, and so is the sum with the products that are 0
        let is_exact = |unit: &BoundedVector| unit.iter().all(|c| c.error == 0.0 && c.value.abs().fract() == 0.0);
        let weights = |unit: &BoundedVector| unit.each_ref().map(|c| if is_exact(unit) { 0.0 } else { rounding(c) });
        let (of_f, of_g) = (weights(f), weights(g));
        Projection {
            units: [f, g].map(|unit| unit.map(|c| c.value)),
            weights: [0, 1, 2].map(|k| (of_f[k] + of_g[k]) * FIVE_ROUNDINGS),
        }
    }

    /// The vector of coordinates.
    pub(in super::super) fn vector(&self, coordinates: &[Bounded; 3]) -> BoundedVector {
        [0, 1, 2].map(|k| products([0, 1, 2].map(|i| (self.units[i][k], coordinates[i]))))
    }
}

/// The projection of vectors of doubles onto the plane, in doubles, and a bound of what rounding takes from a sum of
/// many: one bound for all of them costs three additions a vector, bounds of their own a product for each coordinate.
#[derive(Debug)]
pub(in super::super) struct Projection {
    units: [[f64; 3]; 2],
    /// The parts of each coordinate's magnitude by which the two coordinates in the plane are off together.
    weights: [f64; 3],
}

impl Projection {
    /// The coordinates in the plane.
    #[inline]
    pub(in super::super) fn of(&self, v: [f64; 3]) -> [f64; 2] {
        self.units.map(|u| u[0] * v[0] + u[1] * v[1] + u[2] * v[2])
    }

    /// A bound of the sum of |x − x'| + |y − y'| over vectors projected to (x', y') in place of (x, y), but for what
    /// underflows, by the sums of the magnitudes of their coordinates.
    pub(in super::super) fn off(&self, magnitudes: [f64; 3]) -> f64 {
        (0..3).map(|k| self.weights[k] * magnitudes[k]).sum::<f64>() * FIVE_ROUNDINGS
    }

    /// Whether the coordinates in the plane are coordinates of the vectors or their opposites.
    pub(in super::super) fn is_exact(&self) -> bool {
        self.weights == [0.0; 3]
    }
}

/// The vector over a power of two, so that its largest coordinate is about 1; one along a coordinate axis over its
/// length.
fn shortened(v: &ExactVector) -> ExactVector {
    let exponent = v.iter().filter_map(Dyadic::binary_exponent).max().unwrap_or(0);
    if v.iter().filter(|c| !c.is_zero()).count() == 1 {
        return v.each_ref().map(|c| match c.sign() {
            std::cmp::Ordering::Less => -Dyadic::one(),
            std::cmp::Ordering::Equal => Dyadic::zero(),
            std::cmp::Ordering::Greater => Dyadic::one(),
        });
    }
    v.each_ref().map(|c| c.clone().scaled(-exponent))
}

/// The unit vector of a vector with a largest coordinate of about 1, and a lower bound of its length.
fn unit(v: &ExactVector) -> (BoundedVector, f64) {
    let values = v.each_ref().map(Dyadic::to_f64);
    if v.iter().filter(|c| !c.is_zero()).count() == 1 {
        return (values.map(Bounded::exact), 1.0);
    }
    let length = euclidean_norm(&values);
    let coordinate = |k: usize| {
        let value = values[k] / length;
        let error = if v[k].is_zero() { 0.0 } else { ROUNDED_UNIT_VECTOR * value.abs() + SMALLEST };
        Bounded { value, error }
    };
    ([0, 1, 2].map(coordinate), length * (1.0 - ROUNDED_UNIT_VECTOR))
}

/// The sum of products, in which factors that are exactly zero leave no error.
fn products(factors: [(Bounded, Bounded); 3]) -> Bounded {
    let is_zero = |number: &Bounded| number.value == 0.0 && number.error == 0.0;
    let terms = factors.into_iter().filter(|(a, b)| !is_zero(a) && !is_zero(b)).map(|(a, b)| a * b);
    terms.reduce(|sum, term| sum + term).unwrap_or(Bounded::exact(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::exact_linear::dot;
    use proptest::prelude::*;

    #[test]
    fn a_coordinate_axis_has_an_exact_frame() {
        let plane = Plane::orthogonal_to([0.0, 0.0, -3e-200]);
        let [a, f, g] = plane.units.map(|unit| unit.map(|c| (c.value, c.error)));
        let zero = (0.0, 0.0);
        assert_eq!((a[2], plane.lengths), ((-1.0, 0.0), [1.0, 1.0]));
        assert!([f, g].iter().all(|unit| unit[2] == zero && unit.iter().filter(|c| **c == zero).count() == 2));
    }

    properties! {
        #[test]
        fn directions_are_orthogonal_and_units_are_near(
            axis in [-1.0..1.0f64, -1.0..1.0f64, 1.0..2.0f64], exponents in [-300i32..300, -300i32..300, -300i32..300]
        ) {
            let axis = [0, 1, 2].map(|k| axis[k] * libm::exp2(f64::from(exponents[k])));
            let plane = Plane::orthogonal_to(axis);
            let [f, g] = &plane.directions;
            let a = exact(axis);
            prop_assert!(dot(&a, f).is_zero() && dot(&a, g).is_zero() && dot(f, g).is_zero());
            for (direction, length) in [(f, plane.lengths[0]), (g, plane.lengths[1])] {
                let below = Dyadic::from_f64(length);
                let square = dot(direction, direction);
                prop_assert!(&below * &below <= square);
                prop_assert!(square.to_f64() <= length * length * (1.0 + 1e-13));
            }
            for (unit, direction) in plane.units.iter().skip(1).zip(&plane.directions) {
                // |unit·|d| − d| ≤ error·|d|, checked by squares
                let square = dot(direction, direction);
                for k in 0..3 {
                    let [low, high] = [unit[k].value - unit[k].error, unit[k].value + unit[k].error];
                    let squared = &direction[k] * &direction[k];
                    let [low, high] = [low.abs(), high.abs()];
                    let near = Dyadic::from_f64(low.min(high).next_down().max(0.0));
                    let far = Dyadic::from_f64(low.max(high).next_up());
                    prop_assert!(&(&near * &near) * &square <= squared && squared <= &(&far * &far) * &square);
                }
            }
        }
    }
}
