//! The span of some vectors and the normals of their hyperplanes, exactly.

use super::Vector;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;

/// The span of vectors of R^D, as the rows of a reduced echelon form.
pub(in crate::collision) struct Span {
    /// Row k is 1 at `axes[k]` and 0 at the other axes.
    rows: Vec<Vec<Rational>>,
    axes: Vec<usize>,
    dimension: usize,
}

impl Span {
    pub(in crate::collision) fn of(vectors: &[Vector], dimension: usize) -> Self {
        let mut span = Self { rows: Vec::new(), axes: Vec::new(), dimension };
        for vector in vectors {
            let mut left = span.residual(vector);
            let Some(axis) = left.iter().position(|v| *v != Rational::ZERO) else { continue };
            let pivot = left[axis].clone();
            left.iter_mut().for_each(|v| *v /= &pivot);
            for row in &mut span.rows {
                let factor = row[axis].clone();
                row.iter_mut().zip(&left).for_each(|(a, b)| *a -= &factor * b);
            }
            span.rows.push(left);
            span.axes.push(axis);
        }
        span
    }

    pub(in crate::collision) fn rank(&self) -> usize {
        self.axes.len()
    }

    /// The vector minus the member of the span that agrees with it on the axes; zero just for members.
    fn residual(&self, vector: &Vector) -> Vec<Rational> {
        let mut left: Vec<Rational> = vector.iter().map(Dyadic::to_rational).collect();
        for (row, &axis) in self.rows.iter().zip(&self.axes) {
            let factor = left[axis].clone();
            left.iter_mut().zip(row).for_each(|(a, b)| *a -= &factor * b);
        }
        left
    }

    /// A direction orthogonal to the span whose product with the vector is positive; `None` for a member of the span.
    ///
    /// With j a coordinate of the residual that is not 0, e_j − Σ_k row_k[j] e_axis(k) is orthogonal to each row, and its product
    /// with the vector is that coordinate.
    pub(in crate::collision) fn direction_to(&self, vector: &Vector) -> Option<Vector> {
        let left = self.residual(vector);
        let j = left.iter().position(|v| *v != Rational::ZERO)?;
        let sign = if left[j] < Rational::ZERO { Rational::NEG_ONE } else { Rational::ONE };
        let mut direction = vec![Rational::ZERO; self.dimension];
        direction[j] = sign.clone();
        for (row, &axis) in self.rows.iter().zip(&self.axes) {
            direction[axis] = -(&sign * &row[j]);
        }
        let common =
            direction.iter().fold(Rational::ONE, |product, v| product * Rational::from(v.denominator().clone()));
        let integer = |v: Rational| Dyadic::new((v * &common).numerator().clone(), 0);
        Some(direction.into_iter().map(integer).collect())
    }

    /// The coordinates that the axes determine: the span holds no vector but 0 in which only these are not 0.
    pub(in crate::collision) fn other_axes(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.dimension).filter(|axis| !self.axes.contains(axis))
    }

    /// The coordinates on the axes: they determine a member of the span.
    pub(super) fn project(&self, vector: &Vector) -> Vector {
        self.axes.iter().map(|&axis| vector[axis].clone()).collect()
    }

    pub(super) fn project_all(&self, vectors: &[Vector]) -> Vec<Vector> {
        vectors.iter().map(|vector| self.project(vector)).collect()
    }

    /// A direction of the axes as one of the whole space: its products with members of the span stay what they are.
    pub(super) fn lift(&self, direction: &Vector) -> Vector {
        let mut lifted = vec![Dyadic::zero(); self.dimension];
        for (value, &axis) in direction.iter().zip(&self.axes) {
            lifted[axis] = value.clone();
        }
        lifted
    }
}

/// The normals of all hyperplanes spanned by r − 1 of the vectors of R^r; none for r = 0.
pub(super) fn normals(vectors: &[Vector], r: usize) -> Vec<Vector> {
    let mut found = Vec::new();
    if r > 0 {
        choose(vectors, r, &mut Vec::new(), &mut found);
    }
    found
}

fn choose<'a>(left: &'a [Vector], r: usize, chosen: &mut Vec<&'a Vector>, found: &mut Vec<Vector>) {
    if chosen.len() + 1 == r {
        let normal = cross(chosen, r);
        if normal.iter().any(|v| !v.is_zero()) {
            found.push(normal);
        }
        return;
    }
    for (position, vector) in left.iter().enumerate() {
        chosen.push(vector);
        choose(&left[position + 1..], r, chosen, found);
        chosen.pop();
    }
}

/// The generalised cross product: coordinate j is the signed minor without column j.
fn cross(vectors: &[&Vector], r: usize) -> Vector {
    (0..r)
        .map(|j| {
            let columns: Vec<usize> = (0..r).filter(|&column| column != j).collect();
            let minor = determinant(vectors, &columns);
            if j % 2 == 0 { minor } else { -minor }
        })
        .collect()
}

fn determinant(rows: &[&Vector], columns: &[usize]) -> Dyadic {
    let Some((first, others)) = rows.split_first() else { return Dyadic::from_f64(1.0) };
    let mut sum = Dyadic::zero();
    for (position, &column) in columns.iter().enumerate() {
        if first[column].is_zero() {
            continue;
        }
        let left: Vec<usize> = columns.iter().copied().filter(|&c| c != column).collect();
        let term = &first[column] * &determinant(others, &left);
        sum = if position % 2 == 0 { sum + term } else { sum - term };
    }
    sum
}

pub(super) fn dot(a: &[Dyadic], b: &[Dyadic]) -> Dyadic {
    a.iter().zip(b).fold(Dyadic::zero(), |sum, (a, b)| sum + a * b)
}
