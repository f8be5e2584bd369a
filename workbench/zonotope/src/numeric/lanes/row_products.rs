//! Dot products of rows of any length, in partial sums side by side: most of the work of dense linear
//! algebra in doubles.

use wide::f64x2;

/// The dot product Σ a_k b_k in four partial sums, joined by halves: for rows of any length.
#[inline]
pub(crate) fn product_in_fours(a: &[f64], b: &[f64]) -> f64 {
    let ([p, q, r, s], rest) = partial_products(a, b);
    (p + r) + (q + s) + rest
}

/// The dot product Σ a_k b_k in eight partial sums, joined in order: for long rows, where the joining costs little.
#[inline]
pub(crate) fn product_in_eights(a: &[f64], b: &[f64]) -> f64 {
    let (sums, rest) = partial_products::<8>(a, b);
    sums.iter().sum::<f64>() + rest
}

/// The sums of every LANES-th product, as far as they come in full, and the sum of the other products.
#[inline(always)]
fn partial_products<const LANES: usize>(a: &[f64], b: &[f64]) -> ([f64; LANES], f64) {
    let ((a, rest_of_a), (b, rest_of_b)) = (a.as_chunks::<LANES>(), b.as_chunks::<LANES>());
    let mut sums = [0.0; LANES];
    for (a, b) in a.iter().zip(b) {
        for lane in 0..LANES {
            sums[lane] += a[lane] * b[lane];
        }
    }
    (sums, rest_of_a.iter().zip(rest_of_b).map(|(a, b)| a * b).sum())
}

/// The dot products of four rows with two others, all of the same even length: each load of a row serves two products.
pub(crate) fn products_of_four_rows([p, q, r, s]: [&[f64]; 4], [a, b]: [&[f64]; 2]) -> [[f64; 2]; 4] {
    let mut sums = [[f64x2::ZERO; 2]; 4];
    let [p, q, r, s, a, b] = [p, q, r, s, a, b].map(|row| row.as_chunks::<2>().0);
    for (((((p, q), r), s), a), b) in p.iter().zip(q).zip(r).zip(s).zip(a).zip(b) {
        let (a, b) = (f64x2::from(*a), f64x2::from(*b));
        for (sums, row) in sums.iter_mut().zip([p, q, r, s]) {
            let row = f64x2::from(*row);
            sums[0] += row * a;
            sums[1] += row * b;
        }
    }
    sums.map(|pair| pair.map(|sum| sum.to_array().iter().sum()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_whole_numbers_by_hand() {
        let row: Vec<f64> = (1..=11).map(f64::from).collect();
        // 1 + 4 + … + 121
        assert_eq!((product_in_fours(&row, &row), product_in_eights(&row, &row)), (506.0, 506.0));
        assert_eq!((product_in_fours(&[], &[]), product_in_eights(&[], &[])), (0.0, 0.0));
        let [one, two] = [[1.0, 1.0], [2.0, -3.0]];
        assert_eq!(
            products_of_four_rows([&one, &two, &one, &two], [&one, &two]),
            [[2.0, -1.0], [-1.0, 13.0], [2.0, -1.0], [-1.0, 13.0]]
        );
    }
}
