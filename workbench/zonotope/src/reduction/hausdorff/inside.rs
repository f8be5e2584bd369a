//! Whether one body lies in the interior of another one, or reaches out of it, by cones of directions.
//!
//! A cone at whose corners the linear bound of the difference is below 0 has no direction in which the inner body
//! reaches as far as the outer one; a middle along which the difference is above 0 has one in which it reaches farther.
//! Bodies that touch are told by neither, so the work is limited.

use super::cone::Cone;
use super::difference::ScaledBodies;
use super::exact_difference::ExactDifference;

/// Whether the first body of a difference lies in the interior of the second one, which is proven either way; none
/// where about so many products of a direction and a vector, beside those of the cones of whole faces, do not tell.
pub(in crate::reduction) fn lies_inside<const D: usize>(
    difference: &ExactDifference<D>,
    most_products: u64,
) -> Option<bool> {
    let difference = ScaledBodies::new(difference).difference(0);
    let rounding = difference.rounding();
    let mut cones = Cone::faces(&difference, &rounding);
    let mut products = 0;
    while let Some(cone) = cones.pop() {
        if cone.lower > 0.0 {
            return Some(false);
        }
        if cone.is_below {
            continue;
        }
        products += 2 * cone.products();
        if products > most_products {
            return None;
        }
        cones.extend(cone.halves(&difference, &rounding)?);
    }
    Some(true)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::zonotope::Zonotope;

    #[test]
    fn a_square_in_a_square() {
        let square = |side: f64, x: f64| Zonotope::new([x, 0.0], vec![[side, 0.0], [0.0, side]]).expect("finite");
        let lies = |side: f64, x: f64| lies_inside(&ExactDifference::new(&square(side, x), &square(1.0, 0.0)), 10_000);
        assert_eq!([lies(0.5, 0.25), lies(0.5, 0.75), lies(1.5, 0.0)], [Some(true), Some(false), Some(false)]);
        assert_eq!(lies(0.5, 0.5), None, "they touch");
    }
}
