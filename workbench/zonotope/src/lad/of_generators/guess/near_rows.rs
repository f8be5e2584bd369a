//! The generators near a direction, by one pass over all, with the sum of the others with their signs.
//!
//! The lines of the others pass far from the point of the direction, so that they are one linear function around it.
//! That is as much as a guess needs, and no bound of a rounding error is kept: a pass of
//! [`sign_pass`](crate::lad::of_generators::seam::sign_pass), of which proofs are made, takes four times as long.

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};

use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::part::Part;
use crate::lad::of_generators::seam::sign_pass::Places;
use crate::numeric::lanes::bit_places::{WORD, places_of};
use crate::numeric::lanes::level::level;
use crate::numeric::lanes::number::product;
use crate::numeric::lanes::octet::{LANES, in_order_of_rows, splat, totals, turned};
use crate::numeric::lanes::rows::Rows;
use crate::numeric::reused::Reused;

/// Near generators, their indices in the query, and the sum of the others with the signs of their products with the
/// direction.
#[derive(Debug)]
pub(crate) struct NearRows {
    pub(crate) vectors: Reused<[f64; 3]>,
    pub(crate) indices: Places,
    pub(crate) sum: [f64; 3],
}

impl NearRows {
    /// The generators v with |v · u| below `band` |v|_1, and of a generator under a matrix perhaps some more. One pass.
    pub(crate) fn of(query: &dyn KernelQuery, u: &[f64; 3], band: f64) -> Self {
        let expected = query.len().isqrt() * 8;
        let (mut vectors, mut indices) = (Reused::with_capacity(expected), Places::with_capacity(expected));
        let (mut sum, mut offset) = ([0.0; 3], 0);
        for part in query.parts() {
            let first = indices.len();
            let own = of_part(&part, u, band, &mut indices);
            sum = [0, 1, 2].map(|k| sum[k] + own[k]);
            part.gather(first, offset, &mut vectors, &mut indices);
            offset += part.rows.len();
        }
        Self { vectors, indices, sum }
    }
}

fn of_part(part: &Part<'_>, u: &[f64; 3], band: f64, places: &mut Places) -> [f64; 3] {
    match part.frame {
        None => of_rows(part.rows, u, band, places),
        Some(frame) => frame.image(&of_rows(part.rows, &frame.pulled(u), band * frame.magnitude(), places)),
    }
}

/// Adds the places of near rows to a list; the sum of the others.
fn of_rows(rows: Rows<'_>, u: &[f64; 3], band: f64, places: &mut Places) -> [f64; 3] {
    let mut words = Reused::with_capacity(rows.len().div_ceil(WORD));
    words.resize(rows.len().div_ceil(WORD), 0u64);
    let sum = dispatch!(level(), simd => split(simd, rows, u, band, &mut words));
    let mut room = [0; WORD];
    for (start, &word) in (0..rows.len()).step_by(WORD).zip(words.iter()) {
        places.extend_from_slice(places_of(word, start as u32, &mut room));
    }
    sum
}

/// Writes a bit for each row that is near; the sum of the others.
#[inline(always)]
fn split<S: Simd>(simd: S, rows: Rows<'_>, u: &[f64; 3], band: f64, words: &mut [u64]) -> [f64; 3] {
    let (wide, zero) = (splat(simd, u), f64x8::splat(simd, 0.0));
    let mut sum = [zero; 3];
    for (word, bits) in rows.chunks(WORD).zip(words) {
        let octets = word.octets();
        let mut near = 0;
        for k in 0..octets.len() {
            let v = octets.load(simd, k);
            let value = product(&v, &wide);
            let is_near = value.abs().simd_lt((v[0].abs() + v[1].abs() + v[2].abs()) * band);
            for (sum, c) in sum.iter_mut().zip(&v) {
                *sum += is_near.select(zero, turned(simd, *c, value));
            }
            near |= is_near.to_bitmask() << (LANES * k);
        }
        *bits = in_order_of_rows(near);
    }
    totals(&sum)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::linear::{dot, sum_norm};
    use crate::zonotope::Zonotope;
    use crate::zonotope::pose::Pose;
    use crate::zonotope::prepared::PreparedBody;
    use crate::zonotope::query::Query;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    #[test]
    fn near_rows_and_the_sum_of_the_others_are_those_of_all() {
        let random = &mut Pcg64Mcg::seed_from_u64(40);
        for [m, n] in [[0, 1], [5, 0], [8, 64], [63, 130], [65, 200]] {
            let mut vector = || [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64));
            let bodies = [m, n].map(|count| {
                let generators = (0..count).map(|_| vector()).collect();
                PreparedBody::new(Zonotope::new([0.0; 3], generators).expect("finite"))
            });
            let (u, turn) = (vector(), Pose::from_axis_angle(vector(), 0.7, vector()).expect("finite"));
            let [first, second] = bodies.each_ref();
            let at_rest = Query::of_placed(first.body().into(), second.placed());
            let posed = Query::of_placed(first.at(&turn), second.at(&Pose::IDENTITY));
            for band in [0.0, 0.1, 0.4] {
                for query in [&at_rest as &dyn KernelQuery, &posed] {
                    let near = NearRows::of(query, &u, band);
                    let mut sum = near.sum;
                    for (&index, v) in near.indices.iter().zip(near.vectors.iter()) {
                        assert_eq!(*v, query.generator(index as usize));
                        sum = [0, 1, 2].map(|k| sum[k] + v[k] * f64::copysign(1.0, dot(v, &u)));
                    }
                    let mut whole = [0.0; 3];
                    for (index, v) in query.generators().enumerate() {
                        whole = [0, 1, 2].map(|k| whole[k] + v[k] * f64::copysign(1.0, dot(&v, &u)));
                        let is_listed = near.indices.contains(&(index as u32));
                        assert!(is_listed || dot(&v, &u).abs() >= band * sum_norm(&v) * (1.0 - 1e-9), "{index} {band}");
                    }
                    assert!((0..3).all(|k| (sum[k] - whole[k]).abs() < 1e-9), "{m} {n} {band}");
                    assert!(near.indices.is_sorted() && (band > 0.0 || near.indices.is_empty()));
                }
            }
        }
    }
}
