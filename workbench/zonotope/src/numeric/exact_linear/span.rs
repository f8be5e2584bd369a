//! The span of vectors, exactly: its rank, coordinates that tell its vectors apart, functionals that vanish on it.
//!
//! Elimination brings the vectors to a basis in reduced echelon form: each basis vector has a pivot, a coordinate that
//! is 0 in all others. So a vector of the span is known by its pivot coordinates, and each other coordinate is a fixed
//! combination of them. Rows are not divided by their heads, so that all numbers stay dyadic; what they have in common
//! is taken out.

use crate::numeric::Rational;
use crate::numeric::dyadic::{Dyadic, remove_common_factor};

/// A linear subspace of R^d.
#[derive(Debug, Clone)]
pub(crate) struct Span {
    dimension: usize,
    rows: Vec<Row>,
}

/// A basis vector: positive in its pivot, 0 in the pivots of the others.
#[derive(Debug, Clone)]
struct Row {
    pivot: usize,
    vector: Vec<Dyadic>,
}

impl Row {
    fn head(&self) -> &Dyadic {
        &self.vector[self.pivot]
    }

    /// A positive multiple of a vector minus a multiple of this one: 0 in the pivot.
    fn cleared(&self, vector: Vec<Dyadic>) -> Vec<Dyadic> {
        let factor = &vector[self.pivot];
        if factor.is_zero() {
            return vector;
        }
        vector.iter().zip(&self.vector).map(|(v, own)| v * self.head() - own * factor).collect()
    }

    /// The coordinate as a multiple of that in the pivot.
    fn rate(&self, coordinate: usize) -> Rational {
        self.vector[coordinate].to_rational() / self.head().to_rational()
    }
}

impl Span {
    /// The span of vectors of d coordinates. O(n d²) exact operations, none once it is the whole space.
    pub(crate) fn of<V: IntoIterator<Item = Dyadic>>(vectors: impl IntoIterator<Item = V>, dimension: usize) -> Self {
        let mut span = Self { dimension, rows: Vec::with_capacity(dimension) };
        let mut vectors = vectors.into_iter();
        while span.rank() < dimension {
            let Some(vector) = vectors.next() else { break };
            span.extend(vector.into_iter().collect());
        }
        span
    }

    /// The span of vectors of doubles.
    pub(crate) fn of_doubles<const D: usize>(vectors: &[[f64; D]]) -> Self {
        Self::of(vectors.iter().map(|v| v.map(Dyadic::from_f64)), D)
    }

    fn extend(&mut self, vector: Vec<Dyadic>) {
        let mut vector = self.residual(vector);
        let Some(pivot) = vector.iter().position(|c| !c.is_zero()) else { return };
        if vector[pivot].sign().is_lt() {
            vector = vector.into_iter().map(|c| -c).collect();
        }
        remove_common_factor(&mut vector);
        let new = Row { pivot, vector };
        for row in &mut self.rows {
            row.vector = new.cleared(std::mem::take(&mut row.vector));
            remove_common_factor(&mut row.vector);
        }
        self.rows.push(new);
    }

    /// A positive multiple of the vector minus the member of the span that agrees with it in the pivots: 0 just for
    /// members.
    fn residual(&self, vector: Vec<Dyadic>) -> Vec<Dyadic> {
        self.rows.iter().fold(vector, |rest, row| row.cleared(rest))
    }

    /// The dimension of the span.
    pub(crate) fn rank(&self) -> usize {
        self.rows.len()
    }

    /// Coordinates that determine a vector of the span, one a basis vector, in the order in which they were found.
    pub(crate) fn pivots(&self) -> impl Iterator<Item = usize> + '_ {
        self.rows.iter().map(|row| row.pivot)
    }

    /// The pivots in increasing order: coordinates in which the vectors have the same linear dependences as in all.
    pub(crate) fn independent_coordinates(&self) -> Vec<usize> {
        let mut coordinates: Vec<usize> = self.pivots().collect();
        coordinates.sort_unstable();
        coordinates
    }

    /// The coordinates that the pivots determine: the span holds no vector but 0 in which only these are not 0.
    pub(crate) fn other_coordinates(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.dimension).filter(|axis| self.pivots().all(|pivot| pivot != *axis))
    }

    /// The pivot coordinates of a vector: they determine a member of the span.
    pub(crate) fn project<T: Clone>(&self, vector: &[T]) -> Vec<T> {
        self.pivots().map(|pivot| vector[pivot].clone()).collect()
    }

    /// A direction of the pivot coordinates as one of the whole space, 0 in the others: its products with members of
    /// the span stay what they are.
    pub(crate) fn embed(&self, direction: &[Dyadic]) -> Vec<Dyadic> {
        let mut embedded = vec![Dyadic::zero(); self.dimension];
        for (value, pivot) in direction.iter().zip(self.pivots()) {
            embedded[pivot] = value.clone();
        }
        embedded
    }

    /// The member of the span with given pivot coordinates.
    pub(crate) fn member(&self, coordinates: &[Rational]) -> Vec<Rational> {
        let coordinate = |c: usize| {
            let terms = self.rows.iter().zip(coordinates).map(|(row, x)| row.rate(c) * x);
            terms.fold(Rational::ZERO, |sum, term| sum + term)
        };
        (0..self.dimension).map(coordinate).collect()
    }

    /// A basis of the functionals that vanish on the span, one for each of the
    /// [`other_coordinates`](Self::other_coordinates) and 1 there.
    ///
    /// e_j − Σ_k (row_k[j] / head_k) e_pivot(k) is orthogonal to each row.
    pub(crate) fn annihilators(&self) -> Vec<Vec<Rational>> {
        self.other_coordinates().map(|other| self.annihilator(other)).collect()
    }

    fn annihilator(&self, other: usize) -> Vec<Rational> {
        let mut functional = vec![Rational::ZERO; self.dimension];
        functional[other] = Rational::ONE;
        for row in &self.rows {
            functional[row.pivot] = -row.rate(other);
        }
        functional
    }

    /// A direction orthogonal to the span whose product with the vector is positive, of whole numbers; `None` for a
    /// member of the span.
    pub(crate) fn direction_to(&self, vector: &[Dyadic]) -> Option<Vec<Dyadic>> {
        let rest = self.residual(vector.to_vec());
        let other = rest.iter().position(|c| !c.is_zero())?;
        let direction = self.annihilator(other);
        let common =
            direction.iter().fold(Rational::ONE, |product, v| product * Rational::from(v.denominator().clone()));
        let common = if rest[other].sign().is_lt() { -common } else { common };
        let whole = |v: Rational| Dyadic::new((v * &common).numerator().clone(), 0);
        Some(direction.into_iter().map(whole).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::linear::sum_of_products;
    use proptest::prelude::*;

    #[test]
    fn a_plane_of_space_by_hand() {
        let span = Span::of_doubles(&[[0.0, 2.0, 2.0], [0.0, -1.0, -1.0], [1.0, 1.0, 1.0]]);
        assert_eq!((span.rank(), span.pivots().collect::<Vec<_>>()), (2, vec![1, 0]));
        assert_eq!((span.independent_coordinates(), span.other_coordinates().collect()), (vec![0, 1], vec![2]));
        assert_eq!(span.member(&[Rational::from(3), Rational::from(5)]), [5, 3, 3].map(Rational::from));
        assert_eq!(span.annihilators(), [[0, -1, 1].map(Rational::from)]);
        let exact = |v: [f64; 3]| v.map(Dyadic::from_f64);
        assert_eq!(span.direction_to(&exact([7.0, 3.0, 3.0])), None);
        assert_eq!(span.direction_to(&exact([0.0, 3.0, 1.0])), Some(exact([0.0, 1.0, -1.0]).to_vec()));
        assert_eq!(span.project(&[1, 2, 3]), [2, 1]);
        assert_eq!(span.embed(&exact([1.0, 2.0, 0.0])[..2]), exact([2.0, 1.0, 0.0]));
    }

    #[test]
    fn no_vector_is_read_after_the_whole_space_is_spanned() {
        let mut read = 0;
        let vectors = [[1.0, 2.0], [2.0, 4.0], [0.0, 1.0], [5.0, 3.0], [1.0, 0.0]];
        let span = Span::of(vectors.into_iter().inspect(|_| read += 1).map(|v| v.map(Dyadic::from_f64)), 2);
        assert_eq!((span.rank(), read), (2, 3));
    }

    #[test]
    fn no_vectors_span_the_origin() {
        let span = Span::of_doubles(&[[0.0; 2]; 3]);
        assert_eq!((span.rank(), span.annihilators().len()), (0, 2));
    }

    properties! {
        #[test]
        fn members_are_told_from_others(
            vectors in proptest::collection::vec(proptest::array::uniform4(-3i32..4), 0..4),
            other in proptest::array::uniform4(-3i32..4),
            weights in proptest::array::uniform4(-3i32..4),
        ) {
            let exact = |v: &[i32; 4]| v.map(|c| Dyadic::from_f64(f64::from(c)));
            let vectors: Vec<[Dyadic; 4]> = vectors.iter().map(exact).collect();
            let span = Span::of(vectors.iter().cloned(), 4);
            let member = vectors.iter().zip(weights).fold(exact(&[0; 4]), |sum, (v, w)| {
                std::array::from_fn(|k| &sum[k] + &(&v[k] * &Dyadic::from_f64(f64::from(w))))
            });
            prop_assert_eq!(span.direction_to(&member), None);
            let rational = |v: &[Dyadic]| v.iter().map(Dyadic::to_rational).collect::<Vec<_>>();
            prop_assert_eq!(span.member(&rational(&span.project(&member))), rational(&member));
            prop_assert_eq!(span.annihilators().len() + span.rank(), 4);
            match span.direction_to(&exact(&other)) {
                Some(direction) => {
                    prop_assert!(sum_of_products(&direction, &exact(&other)).sign().is_gt());
                    prop_assert!(vectors.iter().all(|v| sum_of_products(&direction, v).is_zero()));
                }
                None => {
                    let extended = Span::of(vectors.iter().cloned().chain([exact(&other)]), 4);
                    prop_assert_eq!(extended.rank(), span.rank());
                }
            }
        }
    }
}
