//! The span of the directions, exactly: the coordinates that determine its vectors, and functionals that vanish on it.
//!
//! Elimination brings the directions to a basis in reduced echelon form: each basis vector is 1 in its own pivot
//! coordinate and 0 in the pivot coordinates of the others. So the pivot coordinates of a vector of the span determine
//! it, and each other coordinate is a fixed combination of them.

use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::sum_of_products;

/// A linear subspace of R^D.
pub(crate) struct Span<const D: usize> {
    /// In reduced echelon form.
    basis: Vec<[Rational; D]>,
    /// The pivot coordinate of each basis vector.
    pivots: Vec<usize>,
}

/// A point whose difference from the first point is not in the span. The functional proves it: it is zero on the span
/// and not zero on the difference.
pub(crate) struct Departure<const D: usize> {
    pub(crate) point: usize,
    pub(crate) functional: [Rational; D],
}

/// The exact value of a double.
pub(crate) fn rational(value: f64) -> Rational {
    Dyadic::from_f64(value).to_rational()
}

impl<const D: usize> Span<D> {
    /// The span of vectors, in O(k D²) exact operations; vectors after the whole space is spanned cost none.
    pub(crate) fn of(vectors: &[[f64; D]]) -> Self {
        let mut span = Self { basis: Vec::new(), pivots: Vec::new() };
        for vector in vectors {
            if span.dimension() == D {
                break;
            }
            span.extend(vector.map(rational));
        }
        span
    }

    /// Extends the span by a vector.
    fn extend(&mut self, mut vector: [Rational; D]) {
        for (basis, &pivot) in self.basis.iter().zip(&self.pivots) {
            subtract(&mut vector, basis, pivot);
        }
        let Some(pivot) = vector.iter().position(|c| !c.is_zero()) else { return };
        let head = vector[pivot].clone();
        let vector = vector.map(|c| c / &head);
        for basis in &mut self.basis {
            subtract(basis, &vector, pivot);
        }
        self.basis.push(vector);
        self.pivots.push(pivot);
    }

    pub(crate) fn dimension(&self) -> usize {
        self.basis.len()
    }

    /// The coordinates that determine a vector of the span.
    pub(crate) fn pivots(&self) -> &[usize] {
        &self.pivots
    }

    /// The vector of the span with given pivot coordinates.
    pub(crate) fn lift(&self, coordinates: &[Rational]) -> [Rational; D] {
        std::array::from_fn(|c| {
            self.basis.iter().zip(coordinates).fold(Rational::ZERO, |sum, (basis, x)| sum + &basis[c] * x)
        })
    }

    /// A basis of the functionals that vanish on the span.
    pub(crate) fn annihilators(&self) -> Vec<[Rational; D]> {
        let others = (0..D).filter(|c| !self.pivots.contains(c));
        others
            .map(|other| {
                let mut functional: [Rational; D] = std::array::from_fn(|_| Rational::ZERO);
                functional[other] = Rational::ONE;
                for (basis, &pivot) in self.basis.iter().zip(&self.pivots) {
                    functional[pivot] = -basis[other].clone();
                }
                functional
            })
            .collect()
    }

    /// The first point whose difference from point 0 is not in the span. O(n D²) exact operations, none if the span is
    /// the whole space.
    pub(crate) fn first_departure(&self, points: &[[f64; D]]) -> Option<Departure<D>> {
        let functionals = self.annihilators();
        let (first, others) = points.split_first()?;
        if functionals.is_empty() {
            return None;
        }
        let first = first.map(rational);
        others.iter().enumerate().find_map(|(i, point)| {
            let point = point.map(rational);
            let difference: [Rational; D] = std::array::from_fn(|c| &point[c] - &first[c]);
            let functional = functionals.iter().find(|f| !sum_of_products(*f, &difference).is_zero())?;
            Some(Departure { point: i + 1, functional: functional.clone() })
        })
    }
}

/// Subtracts the multiple of a basis vector that makes the pivot coordinate of a vector zero.
fn subtract<const D: usize>(vector: &mut [Rational; D], basis: &[Rational; D], pivot: usize) {
    let factor = vector[pivot].clone();
    if factor.is_zero() {
        return;
    }
    for (v, b) in vector.iter_mut().zip(basis) {
        *v -= &factor * b;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_of_space_by_hand() {
        let span = Span::of(&[[0.0, 2.0, 2.0], [0.0, -1.0, -1.0], [1.0, 1.0, 1.0]]);
        assert_eq!((span.dimension(), span.pivots()), (2, &[1, 0][..]));
        assert_eq!(span.lift(&[Rational::from(3), Rational::from(5)]), [5, 3, 3].map(Rational::from));
        let points = [[1.0, 1.0, 2.0], [7.0, 3.0, 4.0], [0.0, 0.0, 0.0]];
        let departure = span.first_departure(&points).expect("the origin leaves it");
        assert_eq!(departure.point, 2);
        assert!(sum_of_products(&departure.functional, &[0.0, 2.0, 2.0].map(rational)).is_zero());
    }

    #[test]
    fn no_directions_span_the_origin() {
        let span = Span::of(&[[0.0; 2]; 3]);
        assert_eq!(span.dimension(), 0);
        assert!(span.first_departure(&[[1.0, 2.0]; 4]).is_none());
        assert!(span.first_departure(&[[1.0, 2.0], [1.0, 2.0f64.next_up()]]).is_some());
    }
}
