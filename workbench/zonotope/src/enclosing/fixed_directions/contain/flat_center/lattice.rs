//! An integer solution of linear equations that is near a target, in the norm of a linear image: nearly the nearest.
//!
//! Column operations as in Euclid's algorithm yield one integer solution and a basis of the lattice of the differences.
//! The basis is reduced (Lenstra, Lenstra, Lovász) in integers, for the norm of the image. Then the solution is moved
//! to the nearest plane of each basis vector in turn (Babai). The factor between the distance found and the least one
//! grows exponentially with the dimension, which is small here.

use dashu_int::IBig;
use dashu_int::ops::{DivEuclid, UnsignedAbs};

use crate::numeric::linear::sum_of_products;

/// An integer vector of the lattice with its image, whose length is the vector's norm.
#[derive(Debug, Clone)]
struct LatticeVector {
    coordinates: Vec<IBig>,
    image: Vec<IBig>,
}

impl LatticeVector {
    /// Subtracts a multiple of another vector.
    fn subtract(&mut self, factor: &IBig, other: &Self) {
        let own = self.coordinates.iter_mut().chain(&mut self.image);
        for (v, o) in own.zip(other.coordinates.iter().chain(&other.image)) {
            *v -= factor * o;
        }
    }
}

/// An integer vector x with row · (x, 1) = 0 for every row, whose image is near a target; `None` if no integer vector
/// solves the equations.
///
/// The image must be linear, and zero for no nonzero difference of two solutions.
pub(super) fn near(
    dimension: usize,
    rows: &[Vec<IBig>],
    image: impl Fn(&[IBig]) -> Vec<IBig>,
    target: &[IBig],
) -> Option<Vec<IBig>> {
    let unit = |i: usize| (0..=dimension).map(|k| IBig::from(u8::from(k == i))).collect();
    let mut columns: Vec<Vec<IBig>> = (0..=dimension).map(unit).collect();
    for row in rows {
        split_off(&mut columns, |column| sum_of_products(row, column));
    }
    let mut origin = split_off(&mut columns, |column| column[dimension].clone())?;
    if origin[dimension] < IBig::ZERO {
        origin.iter_mut().for_each(|v| *v *= IBig::NEG_ONE);
    }
    if origin[dimension] != IBig::ONE {
        return None;
    }
    let with_image = |mut coordinates: Vec<IBig>| {
        coordinates.truncate(dimension);
        LatticeVector { image: image(&coordinates), coordinates }
    };
    let mut vectors: Vec<LatticeVector> = columns.into_iter().map(with_image).collect();
    reduce(&mut vectors);
    let mut origin = with_image(origin);
    origin.image.iter_mut().zip(target).for_each(|(v, t)| *v -= t);
    let last = vectors.len();
    vectors.push(origin);
    shorten(&mut vectors, last);
    vectors.pop().map(|nearest| nearest.coordinates)
}

/// Combines columns until a functional is zero on all but one of them, and takes that one out; `None` if it is zero on
/// all.
fn split_off(columns: &mut Vec<Vec<IBig>>, functional: impl Fn(&[IBig]) -> IBig) -> Option<Vec<IBig>> {
    let mut values: Vec<IBig> = columns.iter().map(|column| functional(column)).collect();
    loop {
        let nonzero = (0..values.len()).filter(|&i| values[i] != IBig::ZERO);
        let least = nonzero.min_by_key(|&i| values[i].clone().unsigned_abs())?;
        let (divisor, column) = (values[least].clone(), columns[least].clone());
        for i in (0..values.len()).filter(|&i| i != least) {
            let factor = (&values[i]).div_euclid(&divisor);
            values[i] -= &factor * &divisor;
            columns[i].iter_mut().zip(&column).for_each(|(v, c)| *v -= &factor * c);
        }
        if values.iter().filter(|value| **value != IBig::ZERO).count() == 1 {
            return Some(columns.swap_remove(least));
        }
    }
}

/// Reduces independent vectors, so that they become short and nearly orthogonal.
fn reduce(vectors: &mut [LatticeVector]) {
    let mut k = 1;
    while k < vectors.len() {
        let rows = shorten(vectors, k);
        let before = if k < 2 { IBig::ONE } else { rows[k - 2][k - 2].clone() };
        let (own, last) = (&rows[k], &rows[k - 1][k - 1]);
        if IBig::from(4) * (&own[k] * before + &own[k - 1] * &own[k - 1]) < IBig::from(3) * last * last {
            vectors.swap(k - 1, k);
            k = (k - 1).max(1);
        } else {
            k += 1;
        }
    }
}

/// Subtracts from vector k integer multiples of the vectors before it, the last one first, so that its coefficients
/// with respect to the orthogonalised vectors are at most 1/2. Returns the [`gram`] rows after that.
fn shorten(vectors: &mut [LatticeVector], k: usize) -> Vec<Vec<IBig>> {
    let mut rows = gram(&vectors[..=k]);
    for j in (0..k).rev() {
        let twice = IBig::from(2) * &rows[j][j];
        let factor = (IBig::from(2) * &rows[k][j] + &rows[j][j]).div_euclid(&twice);
        if factor != IBig::ZERO {
            let (others, own) = vectors.split_at_mut(k);
            own[0].subtract(&factor, &others[j]);
            rows = gram(&vectors[..=k]);
        }
    }
    rows
}

/// Gram and Schmidt's coefficients without fractions. Let d_j be the determinant of the inner products of the first
/// j + 1 vectors. Entry j of row i is d_i for j = i; for j < i it is d_j times the coefficient of orthogonalised vector
/// j in vector i, which is an integer, too.
fn gram(vectors: &[LatticeVector]) -> Vec<Vec<IBig>> {
    let mut rows: Vec<Vec<IBig>> = Vec::with_capacity(vectors.len());
    for (i, vector) in vectors.iter().enumerate() {
        let mut row: Vec<IBig> = Vec::with_capacity(i + 1);
        for j in 0..=i {
            let mut entry = sum_of_products(&vector.image, &vectors[j].image);
            for k in 0..j {
                let other = if j == i { &row[k] } else { &rows[j][k] };
                let divisor = if k == 0 { IBig::ONE } else { rows[k - 1][k - 1].clone() };
                entry = (&rows[k][k] * entry - &row[k] * other) / divisor;
            }
            row.push(entry);
        }
        rows.push(row);
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    fn whole(numbers: &[i64]) -> Vec<IBig> {
        numbers.iter().map(|&v| IBig::from(v)).collect()
    }

    #[test]
    fn the_nearest_of_all_whole_points() {
        let thrice = |x: &[IBig]| x.iter().map(|v| v * IBig::from(3)).collect();
        assert_eq!(near(2, &[], thrice, &whole(&[7, -4])), Some(whole(&[2, -1])));
    }

    #[test]
    fn the_nearest_on_a_line() {
        // The solutions of 3 x + 5 y = 1 are (2, −1) + t (5, −3).
        let same = |x: &[IBig]| x.to_vec();
        assert_eq!(near(2, &[whole(&[3, 5, -1])], same, &whole(&[100, -60])), Some(whole(&[102, -61])));
        assert_eq!(near(2, &[whole(&[6, 10, -1])], same, &whole(&[0, 0])), None);
        assert_eq!(near(2, &[whole(&[3, 5, -1]), whole(&[1, 0, -2])], same, &whole(&[9, 9])), Some(whole(&[2, -1])));
    }

    #[test]
    fn a_norm_that_is_far_from_even() {
        // The image (2 x − 2001 y, y) of the lattice of all points: points far along x have short images.
        let image = |x: &[IBig]| vec![&x[0] * IBig::from(2) - &x[1] * IBig::from(2001), x[1].clone()];
        let found = near(2, &[], image, &whole(&[1, 7])).expect("all points solve no equations");
        let [a, b] = [0, 1].map(|k| &image(&found)[k] - &whole(&[1, 7])[k]);
        assert!(a.clone() * &a + b.clone() * &b <= IBig::from(2), "{found:?}");
    }

    #[test]
    fn reduced_vectors_are_short() {
        let vectors =
            [[1, 1, 1], [-1, 0, 2], [3, 5, 6]].map(|v| LatticeVector { coordinates: whole(&v), image: whole(&v) });
        let mut vectors = vectors.to_vec();
        reduce(&mut vectors);
        let lengths: Vec<IBig> = vectors.iter().map(|m| sum_of_products(&m.image, &m.image)).collect();
        assert_eq!(lengths, whole(&[1, 2, 5]));
    }
}
