//! Whether any zonotope along the directions contains the points: one does just when all differences of points lie in
//! the span of the directions.

use crate::numeric::Rational;
use crate::numeric::exact_linear::{Span, rational, sum_of_products};

/// A point whose difference from the first point is not in the span. The functional proves it: it is zero on the span
/// and not zero on the difference.
pub(crate) struct Departure<const D: usize> {
    pub(crate) point: usize,
    pub(crate) functional: [Rational; D],
}

/// The first point whose difference from point 0 is not in a span. O(n D²) exact operations, none if the span is the
/// whole space.
pub(crate) fn first_departure<const D: usize>(span: &Span, points: &[[f64; D]]) -> Option<Departure<D>> {
    let functionals = span.annihilators();
    let (first, others) = points.split_first()?;
    if functionals.is_empty() {
        return None;
    }
    let first = first.map(rational);
    others.iter().enumerate().find_map(|(i, point)| {
        let point = point.map(rational);
        let difference: [Rational; D] = std::array::from_fn(|c| &point[c] - &first[c]);
        let functional = functionals.iter().find(|f| !sum_of_products(f, &difference).is_zero())?;
        Some(Departure { point: i + 1, functional: std::array::from_fn(|c| functional[c].clone()) })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_of_space_by_hand() {
        let span = Span::of_doubles(&[[0.0, 2.0, 2.0], [0.0, -1.0, -1.0], [1.0, 1.0, 1.0]]);
        let points = [[1.0, 1.0, 2.0], [7.0, 3.0, 4.0], [0.0, 0.0, 0.0]];
        let departure = first_departure(&span, &points).expect("the origin leaves it");
        assert_eq!(departure.point, 2);
        assert!(sum_of_products(&departure.functional, &[0.0, 2.0, 2.0].map(rational)).is_zero());
    }

    #[test]
    fn no_directions_hold_one_point_alone() {
        let span = Span::of_doubles(&[[0.0; 2]; 3]);
        assert!(first_departure(&span, &[[1.0, 2.0]; 4]).is_none());
        assert!(first_departure(&span, &[[1.0, 2.0], [1.0, 2.0f64.next_up()]]).is_some());
    }
}
