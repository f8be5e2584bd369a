//! An extreme vertex of a centred zonotope of space to about twice the digits of a double, in one pass over its
//! generators.
//!
//! A generator is taken with the sign of its product with the direction, and no digit of it is lost: that is a third of
//! the arithmetic of products in pairs. The support function is the product of the direction and the sum, as long as
//! every sign is certain, so the same pass counts the generators of which that may not be so.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use super::super::level::level;
use super::super::number::product;
use super::super::octet::{splat, total, turned};
use super::super::octets::Octets;
use super::super::rows::Rows;
use super::pair_lanes::{BLOCK, Lanes, Sum};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::tolerance::{PRODUCT_UNDERFLOW, SIGN_OF_ROUNDED_DIRECTION};

/// A sum of vectors with signs.
#[derive(Debug, Clone)]
pub(crate) struct ExtremeSum {
    /// Σ ± v.
    pub(crate) sum: [BoundedDoubleDouble; 3],
    /// The number of vectors whose sign is not certainly that of the product with the direction.
    pub(crate) doubtful: usize,
}

/// Σ ± v with the signs of the products with the large parts of a direction. O(n).
pub(crate) fn extreme_sum_in_pairs(rows: Rows<'_>, direction: &[BoundedDoubleDouble; 3]) -> ExtremeSum {
    let parts = direction.map(|c| c.parts());
    let off = parts.iter().fold(0.0f64, |m, (_, error)| m.max(*error));
    let (sums, doubtful) = dispatch!(level(), simd => sums(simd, rows, &parts.map(|(pair, _)| pair.high), off));
    ExtremeSum { sum: sums.map(|sum| sum.in_pairs(0.0)), doubtful }
}

#[inline(always)]
fn sums<S: Simd>(simd: S, rows: Rows<'_>, direction: &[f64; 3], off: f64) -> ([Sum; 3], usize) {
    let (mut sums, mut doubtful) = ([Sum::default(); 3], 0.0);
    for block in rows.chunks(BLOCK) {
        let (lanes, own) = sum_of_block(simd, block.octets(), direction, off);
        // places that fill up the last eight hold zeros, of which nothing is certain
        doubtful += own - (block.octets().len() * 8 - block.len()) as f64;
        for (sum, lanes) in sums.iter_mut().zip(&lanes) {
            sum.add(lanes.joined());
        }
    }
    (sums, doubtful as usize)
}

/// The sums of a block, and the number of doubtful places.
#[inline(always)]
fn sum_of_block<S: Simd>(simd: S, octets: Octets<'_>, direction: &[f64; 3], off: f64) -> ([Lanes<S>; 3], f64) {
    let (u, sizes) =
        (splat(simd, direction), splat(simd, &direction.map(|c| SIGN_OF_ROUNDED_DIRECTION * c.abs() + off)));
    let [zero, one, least] = [0.0, 1.0, PRODUCT_UNDERFLOW].map(|c| f64x8::splat(simd, c));
    let mut lanes = [Lanes::new(simd); 3];
    let mut doubtful = zero;
    for place in 0..octets.len() {
        let v = octets.load(simd, place);
        let along = product(&v, &u);
        let error = product(&[v[0].abs(), v[1].abs(), v[2].abs()], &sizes) + least;
        // true for NaN as well
        doubtful += along.abs().simd_gt(error).select(zero, one);
        for k in 0..3 {
            lanes[k].add_exact(turned(simd, v[k], along));
        }
    }
    (lanes, total(doubtful))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::dyadic::Dyadic;
    use crate::numeric::lanes::body_sums::laid_out;
    use crate::numeric::lanes::level::at_each_level;
    use crate::numeric::lanes::test_vectors::vectors;
    use crate::numeric::scaling::power_of_two;
    use proptest::prelude::*;

    fn along(v: &[f64; 3], u: &[Dyadic; 3]) -> Dyadic {
        (0..3).fold(Dyadic::zero(), |sum, k| sum + Dyadic::from_f64(v[k]) * u[k].clone())
    }

    properties! {
        /// The product of the sum and the direction is the support function where no sign is in doubt.
        #[test]
        fn sums_are_extreme_and_the_same_at_each_level(
            (generators, direction) in vectors(), low in -1.0..1.0f64, exponent in -60..60i32,
        ) {
            let generators: Vec<[f64; 3]> =
                generators.iter().map(|g| g.map(|c| c * power_of_two(exponent))).collect();
            let pair = direction.map(|c| BoundedDoubleDouble::of_parts(c, low * c * power_of_two(-54), 0.0));
            let u = pair.map(BoundedDoubleDouble::to_dyadic);
            let known = laid_out(&generators);
            let of = |rows| at_each_level(|| extreme_sum_in_pairs(rows, &pair));
            let found = [of(Rows::new(&generators)), of(Rows::laid_out(&generators, &known))].concat();
            let bits = |found: &ExtremeSum| found.sum.map(|sum| {
                let (pair, error) = sum.parts();
                [pair.high, pair.low, error].map(f64::to_bits)
            });
            prop_assert!(found.iter().all(|own| bits(own) == bits(&found[0]) && own.doubtful == found[0].doubtful));
            let orthogonal = generators.iter().filter(|g| along(g, &u) == Dyadic::zero()).count();
            prop_assert!(found[0].doubtful >= orthogonal);
            let is_known = found[0].sum.iter().all(BoundedDoubleDouble::is_known);
            if found[0].doubtful > orthogonal || !is_known {
                return Ok(());
            }
            let support = generators.iter().fold(Dyadic::zero(), |sum, g| sum + along(g, &u).abs());
            let sum = found[0].sum.map(|c| c.parts());
            let value = (0..3).fold(Dyadic::zero(), |total, k| {
                total + (Dyadic::from_f64(sum[k].0.high) + Dyadic::from_f64(sum[k].0.low)) * u[k].clone()
            });
            let off = (0..3).fold(Dyadic::zero(), |total, k| total + Dyadic::from_f64(sum[k].1) * u[k].clone().abs());
            prop_assert!((support - value).abs() <= off);
        }
    }

    /// (1, 1, 0) is orthogonal to the direction (1, −1, 0), and (1, 1 + 2^-52, 0) nearly so.
    #[test]
    fn orthogonal_vectors_and_nearly_orthogonal_ones_are_doubtful() {
        let direction = [1.0, -1.0, 0.0].map(BoundedDoubleDouble::exact);
        let mut vectors = vec![[1.0, 0.5, 3.0]; 21];
        let of = |vectors: &[[f64; 3]]| extreme_sum_in_pairs(Rows::new(vectors), &direction);
        assert_eq!(of(&vectors).doubtful, 0);
        assert_eq!(of(&vectors).sum.map(|c| c.parts().0.high), [21.0, 10.5, 63.0]);
        vectors.extend([[1.0, 1.0, 0.0], [1.0, 1.0f64.next_up(), 0.0], [-1.0, 1.0, 1e-20]]);
        assert_eq!(of(&vectors).doubtful, 2);
        assert_eq!(of(&[[f64::NAN; 3]]).doubtful, 1);
    }
}
