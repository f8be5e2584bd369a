//! The whole solution of linear equations that is nearest to a place, but for a small factor.
//!
//! Column operations of Euclid's kind bring the whole solutions to a basis; the basis is reduced (Lenstra, Lenstra, Lovász), in whole numbers, for the norm of an
//! image; then the nearest plane of each of its vectors is taken in turn (Babai). A few dimensions only.

use dashu_int::IBig;
use dashu_int::ops::{DivEuclid, UnsignedAbs};

use crate::numeric::linear::sum_of_products;

/// A whole vector with the image that its length is measured by.
#[derive(Debug, Clone)]
struct Member {
    place: Vec<IBig>,
    image: Vec<IBig>,
}

impl Member {
    fn subtract(&mut self, factor: &IBig, other: &Self) {
        let own = self.place.iter_mut().chain(&mut self.image);
        for (v, o) in own.zip(other.place.iter().chain(&other.image)) {
            *v -= factor * o;
        }
    }
}

/// A whole x with row · (x, 1) = 0 for every row whose linear image is near a target; `None` if no whole x solves the equations.
///
/// No vector of the solutions' lattice may have the image 0.
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
    let member = |mut place: Vec<IBig>| {
        place.truncate(dimension);
        Member { image: image(&place), place }
    };
    let mut members: Vec<Member> = columns.into_iter().map(member).collect();
    reduce(&mut members);
    let mut origin = member(origin);
    origin.image.iter_mut().zip(target).for_each(|(v, t)| *v -= t);
    let last = members.len();
    members.push(origin);
    shorten(&mut members, last);
    members.pop().map(|nearest| nearest.place)
}

/// Combines columns until a functional vanishes on all but one, which is taken out; `None` if it vanishes on all.
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

/// Makes independent vectors short and nearly orthogonal.
fn reduce(members: &mut [Member]) {
    let mut k = 1;
    while k < members.len() {
        let rows = shorten(members, k);
        let before = if k < 2 { IBig::ONE } else { rows[k - 2][k - 2].clone() };
        let (own, last) = (&rows[k], &rows[k - 1][k - 1]);
        if IBig::from(4) * (&own[k] * before + &own[k - 1] * &own[k - 1]) < IBig::from(3) * last * last {
            members.swap(k - 1, k);
            k = (k - 1).max(1);
        } else {
            k += 1;
        }
    }
}

/// Takes from a vector the whole multiples of those before it that leave it shortest; the determinants of [`gram`] after that.
fn shorten(members: &mut [Member], k: usize) -> Vec<Vec<IBig>> {
    let mut rows = gram(&members[..=k]);
    for j in (0..k).rev() {
        let twice = IBig::from(2) * &rows[j][j];
        let factor = (IBig::from(2) * &rows[k][j] + &rows[j][j]).div_euclid(&twice);
        if factor != IBig::ZERO {
            let (others, own) = members.split_at_mut(k);
            own[0].subtract(&factor, &others[j]);
            rows = gram(&members[..=k]);
        }
    }
    rows
}

/// In row i, place j ≤ i: the coefficient of orthogonalised vector j in vector i, times the determinant of the products of the first j + 1
/// vectors; that determinant itself for j = i. All whole.
fn gram(members: &[Member]) -> Vec<Vec<IBig>> {
    let mut rows: Vec<Vec<IBig>> = Vec::with_capacity(members.len());
    for (i, member) in members.iter().enumerate() {
        let mut row: Vec<IBig> = Vec::with_capacity(i + 1);
        for j in 0..=i {
            let mut entry = sum_of_products(&member.image, &members[j].image);
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
        // 3 x + 5 y = 1: (2, −1) + t (5, −3)
        let same = |x: &[IBig]| x.to_vec();
        assert_eq!(near(2, &[whole(&[3, 5, -1])], same, &whole(&[100, -60])), Some(whole(&[102, -61])));
        assert_eq!(near(2, &[whole(&[6, 10, -1])], same, &whole(&[0, 0])), None);
        assert_eq!(near(2, &[whole(&[3, 5, -1]), whole(&[1, 0, -2])], same, &whole(&[9, 9])), Some(whole(&[2, -1])));
    }

    #[test]
    fn a_norm_that_is_far_from_even() {
        // the lattice of all points, its distances by x + 1000 y and 1000 y: near (0, 1/2) are points far along x
        let image = |x: &[IBig]| vec![&x[0] * IBig::from(2) - &x[1] * IBig::from(2001), x[1].clone()];
        let found = near(2, &[], image, &whole(&[1, 7])).expect("all points solve no equations");
        let [a, b] = [0, 1].map(|k| &image(&found)[k] - &whole(&[1, 7])[k]);
        assert!(a.clone() * &a + b.clone() * &b <= IBig::from(2), "{found:?}");
    }

    #[test]
    fn reduced_vectors_are_short() {
        let members = [[1, 1, 1], [-1, 0, 2], [3, 5, 6]].map(|v| Member { place: whole(&v), image: whole(&v) });
        let mut members = members.to_vec();
        reduce(&mut members);
        let lengths: Vec<IBig> = members.iter().map(|m| sum_of_products(&m.image, &m.image)).collect();
        assert_eq!(lengths, whole(&[1, 2, 5]));
    }
}
