//! Linear algebra over big integers: everything is exact, lengths of vectors do not matter.

use dashu_int::IBig;
use dashu_int::ops::{Abs, BitTest, Gcd};

/// A vector on some grid.
pub(crate) type Vector = Vec<IBig>;

/// Products of numbers of so many bits in all are taken as they are.
const SHORT_BITS: usize = 1_024;

/// The product. On a grid over many orders of magnitude a double is a short number before a long row of zeros, which
/// are left out of it.
pub(crate) fn product(a: &IBig, b: &IBig) -> IBig {
    if a.bit_len() + b.bit_len() <= SHORT_BITS {
        return a * b;
    }
    let [(a, zeros), (b, others)] = [a, b].map(|number| {
        let zeros = number.trailing_zeros().unwrap_or(0);
        (number >> zeros, zeros)
    });
    (a * b) << (zeros + others)
}

/// The inner product.
pub(crate) fn dot(u: &[IBig], v: &[IBig]) -> IBig {
    u.iter().zip(v).map(|(u, v)| product(u, v)).sum()
}

/// Whether every component is zero.
pub(crate) fn is_zero(v: &[IBig]) -> bool {
    v.iter().all(|component| *component == IBig::ZERO)
}

/// The vector divided by the greatest common divisor of its components.
pub(crate) fn reduced(v: Vector) -> Vector {
    let divisor = v.iter().filter(|component| **component != IBig::ZERO).fold(IBig::ZERO, |divisor, component| {
        if divisor == IBig::ZERO { component.clone().abs() } else { IBig::from(divisor.gcd(component)) }
    });
    if divisor <= IBig::ONE {
        return v;
    }
    v.into_iter().map(|component| component / &divisor).collect()
}

/// Vectors in echelon form: each has a pivot where all the others have zero.
#[derive(Debug, Clone, Default)]
pub(crate) struct Echelon {
    rows: Vec<(usize, Vector)>,
}

impl Echelon {
    /// The span of vectors of the given length; looks at no more of them than it needs.
    pub(crate) fn spanned<'a>(dimension: usize, vectors: impl IntoIterator<Item = &'a Vector>) -> Self {
        let mut echelon = Self::default();
        for vector in vectors {
            if echelon.rank() == dimension {
                break;
            }
            echelon.insert(vector);
        }
        echelon
    }

    /// The dimension of the span.
    pub(crate) fn rank(&self) -> usize {
        self.rows.len()
    }

    /// The columns of the pivots: the projection to these coordinates keeps vectors of the span apart.
    pub(crate) fn pivots(&self) -> Vec<usize> {
        let mut pivots: Vec<usize> = self.rows.iter().map(|(pivot, _)| *pivot).collect();
        pivots.sort_unstable();
        pivots
    }

    /// A multiple of the vector plus a combination of the rows: zero just when the vector lies in the span.
    fn remainder(&self, vector: &[IBig]) -> Vector {
        self.rows.iter().fold(vector.to_vec(), |rest, (pivot, row)| eliminated(rest, *pivot, row))
    }

    /// Whether the vector lies in the span.
    pub(crate) fn contains(&self, vector: &[IBig]) -> bool {
        is_zero(&self.remainder(vector))
    }

    /// Adds a vector; whether it enlarged the span.
    pub(crate) fn insert(&mut self, vector: &[IBig]) -> bool {
        let rest = reduced(self.remainder(vector));
        let Some(pivot) = rest.iter().position(|component| *component != IBig::ZERO) else {
            return false;
        };
        for (_, row) in &mut self.rows {
            *row = reduced(eliminated(std::mem::take(row), pivot, &rest));
        }
        self.rows.push((pivot, rest));
        true
    }

    /// Independent vectors that span everything orthogonal to the rows.
    pub(crate) fn complement(&self, dimension: usize) -> Vec<Vector> {
        let product: IBig = self.rows.iter().map(|(pivot, row)| &row[*pivot]).product();
        let free = (0..dimension).filter(|column| self.rows.iter().all(|(pivot, _)| pivot != column));
        free.map(|column| {
            let mut vector = vec![IBig::ZERO; dimension];
            vector[column] = product.clone();
            for (pivot, row) in &self.rows {
                vector[*pivot] = -(&row[column] * &product) / &row[*pivot];
            }
            reduced(vector)
        })
        .collect()
    }
}

/// row[pivot] · vector − vector[pivot] · row.
fn eliminated(vector: Vector, pivot: usize, row: &[IBig]) -> Vector {
    if vector[pivot] == IBig::ZERO {
        return vector;
    }
    let (keep, take) = (&row[pivot], &vector[pivot]);
    vector.iter().zip(row).map(|(v, r)| keep * v - take * r).collect()
}

/// The coefficients x with Σ x_j columns_j = target, as numerators over one positive denominator; `None` if the
/// columns are dependent or do not reach the target.
pub(crate) fn solve(columns: &[&Vector], target: &[IBig]) -> Option<(Vector, IBig)> {
    let count = columns.len();
    let mut rows: Vec<Vector> = (0..target.len())
        .map(|axis| columns.iter().map(|column| column[axis].clone()).chain([target[axis].clone()]).collect())
        .collect();
    for step in 0..count {
        let found = (step..rows.len()).find(|&row| rows[row][step] != IBig::ZERO)?;
        rows.swap(step, found);
        let pivot = rows[step].clone();
        for (index, row) in rows.iter_mut().enumerate() {
            if index != step {
                *row = reduced(eliminated(std::mem::take(row), step, &pivot));
            }
        }
    }
    if rows[count..].iter().any(|row| row[count] != IBig::ZERO) {
        return None;
    }
    let denominator: IBig = (0..count).map(|step| &rows[step][step]).product();
    let numerators = (0..count)
        .map(|step| {
            let others = &denominator / &rows[step][step];
            &rows[step][count] * others
        })
        .map(|numerator: IBig| if denominator < IBig::ZERO { -numerator } else { numerator })
        .collect();
    Some((numerators, denominator.abs()))
}

/// |det| of as many vectors as they have components.
pub(crate) fn absolute_determinant(mut rows: Vec<Vector>) -> IBig {
    // Bareiss: every division is exact.
    let mut last = IBig::ONE;
    for step in 0..rows.len() {
        let Some(found) = (step..rows.len()).find(|&row| rows[row][step] != IBig::ZERO) else {
            return IBig::ZERO;
        };
        rows.swap(step, found);
        let pivot = rows[step].clone();
        for row in &mut rows[step + 1..] {
            let take = row[step].clone();
            for (value, above) in row.iter_mut().zip(&pivot) {
                *value = (&*value * &pivot[step] - &take * above) / &last;
            }
        }
        last = pivot[step].clone();
    }
    last.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vector(components: &[i64]) -> Vector {
        components.iter().copied().map(IBig::from).collect()
    }

    #[test]
    fn spans_and_complements() {
        let vectors = [vector(&[2, 4, 6]), vector(&[1, 2, 3]), vector(&[0, 0, 5])];
        let echelon = Echelon::spanned(3, &vectors);
        assert_eq!((echelon.rank(), echelon.pivots()), (2, vec![0, 2]));
        assert!(echelon.contains(&vector(&[1, 2, -7])) && !echelon.contains(&vector(&[1, 0, 0])));
        let complement = echelon.complement(3);
        assert_eq!(complement.len(), 1);
        assert!(vectors.iter().all(|v| dot(v, &complement[0]) == IBig::ZERO) && !is_zero(&complement[0]));
        assert_eq!(Echelon::default().complement(2).len(), 2);
    }

    #[test]
    fn systems_by_hand() {
        let columns = [vector(&[2, 0, 2]), vector(&[0, -3, 3])];
        let columns: Vec<&Vector> = columns.iter().collect();
        let (x, denominator) = solve(&columns, &vector(&[1, 1, 0])).expect("solvable");
        assert_eq!((x[0].clone() * 2, x[1].clone() * -3), (denominator.clone(), denominator));
        assert!(solve(&columns, &vector(&[1, 1, 1])).is_none());
        assert!(solve(&[columns[0], columns[0]], &vector(&[2, 0, 2])).is_none());
        assert!(solve(&[], &vector(&[0, 0])).is_some());
    }

    #[test]
    fn products_of_long_numbers_are_exact() {
        let long = (IBig::from(-3) << 4_000) + (IBig::from(5) << 2_100);
        for (a, b) in [(long.clone(), IBig::from(7) << 900), (long.clone(), long), (IBig::ZERO, IBig::ONE << 9_000)] {
            assert_eq!(product(&a, &b), &a * &b);
        }
    }

    #[test]
    fn determinants() {
        assert_eq!(absolute_determinant(vec![vector(&[0, 2]), vector(&[3, 5])]), IBig::from(6));
        let singular = vec![vector(&[1, 2, 3]), vector(&[4, 5, 6]), vector(&[7, 8, 9])];
        assert_eq!(absolute_determinant(singular), IBig::ZERO);
        let rows = vec![vector(&[2, 0, 1]), vector(&[1, 3, 2]), vector(&[1, 1, 1])];
        assert_eq!(absolute_determinant(rows), IBig::ZERO);
        let rows = vec![vector(&[2, 0, 1]), vector(&[1, 3, 2]), vector(&[1, 1, 4])];
        assert_eq!(absolute_determinant(rows), IBig::from(18));
    }
}
