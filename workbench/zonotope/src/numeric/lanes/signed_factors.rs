//! A factor with the sign of each vector's product with a direction: the coefficients of an extreme point, made
//! smaller.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::level::level;
use super::number::product;
use super::octet::{LANES, reordered, splat, store_first};
use super::rows::Rows;

/// Writes `factor` with the sign of v · direction for each row v.
pub(crate) fn signed_factors(rows: Rows<'_>, direction: &[f64; 3], factor: f64, places: &mut [f64]) {
    dispatch!(level(), simd => write(simd, rows, direction, factor, places));
}

#[inline(always)]
fn write<S: Simd>(simd: S, rows: Rows<'_>, direction: &[f64; 3], factor: f64, places: &mut [f64]) {
    let (wide, factor) = (splat(simd, direction), f64x8::splat(simd, factor));
    let octets = rows.octets();
    let (whole, last) = places.as_chunks_mut::<LANES>();
    for (k, place) in whole.iter_mut().enumerate() {
        reordered(simd, factor.copysign(product(&octets.load(simd, k), &wide))).store_slice(place);
    }
    if !last.is_empty() {
        let value = product(&octets.load(simd, octets.len() - 1), &wide);
        store_first(reordered(simd, factor.copysign(value)), last);
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

    proptest! {
        #[test]
        fn signs_are_those_of_products((generators, direction) in vectors()) {
            let expected: Vec<f64> = generators.iter().map(|v| 0.5f64.copysign(dot(v, &direction))).collect();
            let known = laid_out(&generators);
            for rows in [Rows::new(&generators), Rows::laid_out(&generators, &known)] {
                let found = at_each_level(|| {
                    let mut places = vec![0.0; generators.len()];
                    signed_factors(rows, &direction, 0.5, &mut places);
                    places
                });
                prop_assert!(found.iter().all(|places| *places == expected));
            }
        }
    }
}
