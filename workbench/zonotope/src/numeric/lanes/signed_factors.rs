//! A factor with the sign of each vector's product with a direction: the coefficients of an extreme point, made
//! smaller.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::level::level;
use super::number::product;
use super::octet::{LANES, reordered, splat};
use super::rows::Rows;

/// Adds `factor` with the sign of v · direction to the end of a list, for each row v.
///
/// The list grows as the pass goes on, so that its memory is written once and not cleared before.
pub(crate) fn signed_factors(rows: Rows<'_>, direction: &[f64; 3], factor: f64, list: &mut Vec<f64>) {
    list.reserve(rows.len().next_multiple_of(LANES));
    let len = list.len() + rows.len();
    dispatch!(level(), simd => write(simd, rows, direction, factor, list));
    // what fills up the last eight
    list.truncate(len);
}

#[inline(always)]
fn write<S: Simd>(simd: S, rows: Rows<'_>, direction: &[f64; 3], factor: f64, list: &mut Vec<f64>) {
    let (wide, factor) = (splat(simd, direction), f64x8::splat(simd, factor));
    let octets = rows.octets();
    for k in 0..octets.len() {
        let mut factors = [0.0; LANES];
        reordered(simd, factor.copysign(product(&octets.load(simd, k), &wide))).store_slice(&mut factors);
        list.extend_from_slice(&factors);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::lanes::body_sums::laid_out;
    use crate::numeric::lanes::level::at_each_level;
    use crate::numeric::lanes::test_vectors::vectors;
    use crate::numeric::linear::dot;
    use proptest::prelude::*;

    properties! {
        #[test]
        fn signs_are_those_of_products((generators, direction) in vectors()) {
            let expected: Vec<f64> = generators.iter().map(|v| 0.5f64.copysign(dot(v, &direction))).collect();
            let known = laid_out(&generators);
            for rows in [Rows::new(&generators), Rows::laid_out(&generators, &known)] {
                let found = at_each_level(|| {
                    let mut list = vec![7.0];
                    signed_factors(rows, &direction, 0.5, &mut list);
                    list.split_off(1)
                });
                prop_assert!(found.iter().all(|places| *places == expected));
            }
        }
    }
}
