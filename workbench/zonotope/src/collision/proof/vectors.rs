//! The generators of a query in doubles, with what the proofs in doubles need to know of their rounding and of that of
//! their sums, and the coefficients of three of them that make up for what all others leave. Bounds are in terms of
//! coordinates.
//!
//! A generator M v is off by less than 4 u |M| |v| in each coordinate, so that vector bounds its rounding and, in the
//! place of |v|, the terms of every product with it. At rest both are exact.

use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::part::{Part, of_row};
use crate::numeric::bounded::BoundedVector;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::linear::{cyclic_cross_products, dot};
use crate::numeric::tolerance::{
    CUBABLE_SIZES, DETERMINANT_OF_IMAGES, DETERMINANT_OF_ROWS, LONG_SUM, PRODUCT_UNDERFLOW, THIRTY_ROUNDINGS, UNIT,
};

/// The generators of a query, in the order of their indices.
pub(crate) struct Vectors<'a> {
    pub(crate) parts: [Part<'a>; 2],
    /// A determinant of three generators is off by less than this part of the sum of the magnitudes of its terms.
    pub(crate) determinant_error: f64,
}

/// Three coefficients as quotients.
struct Solved {
    numerators: [f64; 3],
    /// Bounds of the errors of the numerators.
    errors: [f64; 3],
    determinant: f64,
    /// The least magnitude that the determinant may have.
    least: f64,
}

/// A generator in doubles.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Vector {
    pub(crate) value: [f64; 3],
    /// At least |v|, coordinate by coordinate; of an image, |M| |v|.
    pub(crate) size: [f64; 3],
}

impl<'a> Vectors<'a> {
    /// The generators of a query; none where entries of a matrix are too large or small for products of doubles.
    #[inline]
    pub(crate) fn of(query: &'a dyn KernelQuery) -> Option<Self> {
        let parts = query.parts();
        if parts[0].frame.is_none() && parts[1].frame.is_none() {
            return Some(Self { parts, determinant_error: DETERMINANT_OF_ROWS });
        }
        let is_moderate = parts.iter().filter_map(|part| part.frame).all(|frame| frame.is_moderate());
        is_moderate.then_some(Self { parts, determinant_error: DETERMINANT_OF_IMAGES })
    }

    #[inline(always)]
    pub(crate) fn len(&self) -> usize {
        self.parts[0].rows.len() + self.parts[1].rows.len()
    }

    /// A generator by its index.
    #[inline(always)]
    pub(crate) fn value(&self, index: usize) -> [f64; 3] {
        of_row(&self.parts, index, Part::image)
    }

    /// A generator by its index, with its size.
    #[inline(always)]
    pub(crate) fn vector(&self, index: usize) -> Vector {
        of_row(&self.parts, index, Vector::of)
    }

    /// A generator to twice the digits of a double.
    #[inline]
    pub(crate) fn pairs(&self, index: usize) -> [BoundedDoubleDouble; 3] {
        of_row(&self.parts, index, Part::image_in_pairs)
    }

    /// All generators with their sizes.
    #[inline(always)]
    pub(crate) fn iter(&self) -> impl Iterator<Item = Vector> {
        self.parts.iter().flat_map(|part| part.rows.list().iter().map(move |v| Vector::of(part, v)))
    }

    /// The coefficients with which three generators make up a rest whose coordinates are off by at most `errors`: those
    /// that are certainly within (−1, 1). `None` if the three may be dependent.
    #[inline]
    pub(crate) fn coefficients(
        &self,
        basis: [usize; 3],
        rest: &[f64; 3],
        errors: &[f64; 3],
    ) -> Option<[Option<f64>; 3]> {
        let solved = self.solved(basis, rest, errors)?;
        // false for NaN as well
        let is_within = |k: usize| (solved.numerators[k].abs() + solved.errors[k]) * THIRTY_ROUNDINGS < solved.least;
        let coefficient = |k: usize| is_within(k).then(|| solved.numerators[k] / solved.determinant);
        Some([coefficient(0), coefficient(1), coefficient(2)])
    }

    /// Whether one of the first two of these coefficients is certainly beyond [−1, 1].
    pub(crate) fn are_beyond(&self, basis: [usize; 3], rest: &[f64; 3], errors: &[f64; 3]) -> bool {
        self.solved(basis, rest, errors).is_some_and(|solved| {
            let most = solved.determinant.abs() + (solved.determinant.abs() - solved.least);
            (0..2).any(|k| solved.numerators[k].abs() - solved.errors[k] > most * THIRTY_ROUNDINGS)
        })
    }

    /// The solution by Cramer's rule; `None` if the three may be dependent.
    #[inline]
    fn solved(&self, basis: [usize; 3], rest: &[f64; 3], errors: &[f64; 3]) -> Option<Solved> {
        let [a, b, c] = &basis.map(|i| self.vector(i));
        let normals = cyclic_cross_products(&a.value, &b.value, &c.value);
        let areas = [cross_terms(b, c), cross_terms(c, a), cross_terms(a, b)];
        let determinant = dot(&c.value, &normals[2]);
        let least = determinant.abs() - self.determinant_error * dot(&c.size, &areas[2]) - PRODUCT_UNDERFLOW;
        // false for NaN as well
        let is_spanning = least > CUBABLE_SIZES.start * CUBABLE_SIZES.start * CUBABLE_SIZES.start;
        if !is_spanning {
            return None;
        }
        // each term of the product of the rest with a normal goes through seven roundings, and images bring eight more
        let off = [0, 1, 2].map(|k| errors[k] + 16.0 * UNIT * rest[k].abs());
        Some(Solved {
            numerators: [0, 1, 2].map(|k| dot(rest, &normals[k])),
            errors: [0, 1, 2].map(|k| dot(&off, &areas[k]) * LONG_SUM + PRODUCT_UNDERFLOW),
            determinant,
            least,
        })
    }
}

impl Vector {
    #[inline(always)]
    fn of(part: &Part<'_>, v: &[f64; 3]) -> Self {
        Self { value: part.image(v), size: part.image_of_sizes(&v.map(f64::abs)) }
    }
}

/// A sum less a multiple of a vector.
#[inline]
pub(crate) fn minus(sum: [f64; 3], factor: f64, v: &[f64; 3]) -> [f64; 3] {
    [sum[0] - factor * v[0], sum[1] - factor * v[1], sum[2] - factor * v[2]]
}

/// The sums of the magnitudes of the terms of a cross product, with room for what underflows.
#[inline]
pub(crate) fn cross_terms(Vector { size: a, .. }: &Vector, Vector { size: b, .. }: &Vector) -> [f64; 3] {
    let terms = |i: usize, j: usize| a[i] * b[j] + a[j] * b[i] + PRODUCT_UNDERFLOW;
    [terms(1, 2), terms(2, 0), terms(0, 1)]
}

/// The first place of the largest value, if one is positive.
#[inline]
pub(crate) fn first_of_largest(values: impl Iterator<Item = (f64, usize)>) -> Option<usize> {
    let (largest, place) = values.fold((0.0, 0), |best, own| if own.0 > best.0 { own } else { best });
    (largest > 0.0).then_some(place)
}

/// The error in doubles of a sum of generators with coefficients in [−1, 1] that is taken from p.
pub(crate) struct SumErrors<'a> {
    pub(crate) p: &'a BoundedVector,
    /// Σ |v| + |p|, coordinate by coordinate.
    pub(crate) sizes: [f64; 3],
    /// The number of generators.
    pub(crate) count: usize,
}

impl SumErrors<'_> {
    /// The bound for each coordinate of a sum of the pass from which so many generators, beside a few, were taken off
    /// one by one, or to which they were put back: each of these is one more addition for every term before it.
    pub(crate) fn after(&self, additions: usize) -> [f64; 3] {
        let roundings = UNIT * (self.count / 2 + 32 + additions) as f64;
        let lost = (self.count + additions) as f64 * PRODUCT_UNDERFLOW;
        [0, 1, 2].map(|k| (self.p[k].error + roundings * self.sizes[k]) * LONG_SUM + lost)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::bounded::{self, Bounded};
    use crate::numeric::dyadic::Dyadic;
    use crate::numeric::exact_linear::{self, ExactVector, exact};
    use crate::zonotope::Zonotope;
    use crate::zonotope::pose::Pose;
    use crate::zonotope::query::Query;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// The sizes of generators in these tests, from those whose cubes are far below 1 to long ones.
    const SCALES: [f64; 3] = [1.0, 1.0 / (1u128 << 100) as f64, (1u64 << 60) as f64];

    /// The coefficients of three vectors of doubles, if they are certainly within (−1, 1).
    fn given(basis: &[[f64; 3]; 3], rest: [f64; 3], errors: [f64; 3]) -> Option<[Option<f64>; 3]> {
        let query = Query::new([0.0; 3], [0.0; 3], basis).expect("finite");
        Vectors::of(&query).expect("it has no matrix").coefficients([0, 1, 2], &rest, &errors)
    }

    #[test]
    fn a_coefficient_of_the_first_two_is_certainly_beyond_one() {
        let axes = [[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let query = Query::new([0.0; 3], [0.0; 3], &axes).expect("finite");
        let vectors = Vectors::of(&query).expect("it has no matrix");
        let are_beyond = |rest, error| vectors.are_beyond([0, 1, 2], &rest, &[error; 3]);
        assert!(are_beyond([2.1, 0.0, 0.0], 0.0) && are_beyond([0.0, -1.1, 0.0], 0.0));
        assert!(!are_beyond([2.0, -1.0, 0.0], 0.0) && !are_beyond([1.9, 0.9, 5.0], 0.0));
        // what is in doubt is not certain, nor is anything of dependent vectors
        assert!(!are_beyond([2.1, 0.0, 0.0], 0.2) && are_beyond([2.1, 0.0, 0.0], 0.01));
        assert!(!vectors.are_beyond([0, 1, 1], &[9.0; 3], &[0.0; 3]) && !are_beyond([f64::NAN; 3], 0.0));
    }

    fn combined(basis: &[[f64; 3]; 3], coefficients: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| (0..3).map(|i| coefficients[i] * basis[i][k]).sum())
    }

    /// Asserts that given coefficients are within (−1, 1) for all rests that are off by at most the errors, and that
    /// they are those of the rest; counts them.
    fn counted(basis: &[ExactVector; 3], rest: [f64; 3], errors: [f64; 3], own: Option<[Option<f64>; 3]>) -> usize {
        let [a, b, c] = basis;
        let normals = exact_linear::cyclic_cross_products(a, b, c);
        let determinant = exact_linear::dot(a, &normals[0]);
        let own = own.unwrap_or_default();
        for (value, normal) in own.iter().zip(&normals) {
            let Some(value) = value else { continue };
            let numerator = exact_linear::dot(&exact(rest), normal);
            let worst = (0..3)
                .fold(numerator.clone().abs(), |sum, k| sum + &Dyadic::from_f64(errors[k]) * &normal[k].clone().abs());
            assert!(worst < determinant.clone().abs(), "{basis:?} {rest:?} {errors:?} {value}");
            let off = (&Dyadic::from_f64(*value) * &determinant - numerator).abs();
            assert!(off <= &Dyadic::from_f64(1e-6) * &determinant.clone().abs(), "{basis:?} {rest:?} {value}");
        }
        own.iter().flatten().count()
    }

    #[test]
    fn coefficients_that_are_given_are_within_their_ends_whatever_rounding_and_errors_do() {
        let random = &mut Pcg64Mcg::seed_from_u64(21);
        let mut count = 0;
        for round in 0..1500 {
            let scale = SCALES[round % 3];
            let basis = [0, 1, 2].map(|_| [0, 1, 2].map(|_| scale * random.random_range(-1.0..1.0f64)));
            let part = if round % 2 == 0 { 0.0 } else { 64.0 * UNIT };
            let errors = [0, 1, 2].map(|_| part * scale * random.random_range(0.0..1.0));
            // at an end but for some roundings, and for what the errors may be
            let near = f64::from(random.random_range(-8_i32..9)) * (UNIT + part);
            let others = [random.random_range(-1.0..1.0), 1.0 - 4.0 * near];
            let rest = combined(&basis, [1.0 + near, others[0], others[1]]);
            count += counted(&basis.map(exact), rest, errors, given(&basis, rest, errors));
        }
        assert!(count > 1000, "{count}");
    }

    #[test]
    fn coefficients_with_a_little_room_are_given() {
        let random = &mut Pcg64Mcg::seed_from_u64(22);
        for round in 0..300 {
            let scale = SCALES[round % 3];
            let basis = [0, 1, 2]
                .map(|i| [0, 1, 2].map(|k| scale * (random.random_range(-0.2..0.2) + if i == k { 1.0 } else { 0.0 })));
            for part in [0.0, 1e-9] {
                let end = f64::copysign(1.0 - 500.0 * UNIT - 8.0 * part, random.random_range(-1.0..1.0));
                let rest = combined(&basis, [0.5, end, random.random_range(-0.9..0.9)]);
                let errors = [part * scale; 3];
                let own = given(&basis, rest, errors);
                assert_eq!(counted(&basis.map(exact), rest, errors, own), 3, "{basis:?} {rest:?} {part}");
            }
        }
    }

    #[test]
    fn generators_that_may_be_dependent_have_no_coefficients() {
        let random = &mut Pcg64Mcg::seed_from_u64(23);
        for round in 0..300 {
            // the sum of two vectors of thirty digits is exact, and the determinant in doubles is not
            let [a, b] = [0, 1].map(|_| [0, 1, 2].map(|_| f64::from(random.random_range(-(1 << 30)..1 << 30))));
            let sum = [0, 1, 2].map(|k| a[k] + b[k]);
            let basis = [[a, b, sum], [sum, a, b], [b, sum, a]][round % 3];
            assert_eq!(given(&basis, [0.0; 3], [0.0; 3]), None, "{basis:?}");
            assert_eq!(given(&[a, a, b], [0.0; 3], [0.0; 3]), None, "{a:?} {b:?}");
        }
        assert_eq!(given(&[[1e-80, 0.0, 0.0], [0.0, 1e-80, 0.0], [0.0, 0.0, 1e-80]], [0.0; 3], [0.0; 3]), None);
    }

    #[test]
    fn coefficients_of_images_are_within_their_ends() {
        let random = &mut Pcg64Mcg::seed_from_u64(24);
        let mut count = 0;
        for round in 0..300 {
            let mut rows = || [0, 1, 2].map(|_| [0, 1, 2].map(|_| random.random_range(-1.0..1.0f64)));
            let (body, matrix) = (Zonotope::new([0.0; 3], rows().to_vec()).expect("finite"), rows());
            let pose = Pose::new(matrix, [0.0; 3]).expect("finite");
            let query = Query::of_placed(body.at(&pose), body.at(&Pose::IDENTITY));
            let vectors = Vectors::of(&query).expect("the matrix is moderate");
            let near = f64::from(round % 33 - 16) * UNIT;
            let images = [0, 1, 2].map(|i| vectors.value(i));
            let rest = combined(&images, [0.7, -0.8, 1.0 + near]);
            let own = vectors.coefficients([0, 1, 2], &rest, &[0.0; 3]);
            let query: &dyn KernelQuery = &query;
            count += counted(&[0, 1, 2].map(|i| query.exact_generator(i)), rest, [0.0; 3], own);
        }
        assert!(count > 500, "{count}");
    }

    #[test]
    fn a_matrix_of_either_body_counts() {
        let body = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).expect("finite");
        let single = Zonotope::new([0.0; 3], vec![[0.0, 0.0, 1.0]]).expect("finite");
        let turned = Pose::from_axis_angle([1.0, 2.0, 3.0], 0.5, [0.0; 3]).expect("an axis");
        let long = Pose::new([[1e30, 0.0, 0.0], [0.0, 1e30, 0.0], [0.0, 0.0, 1e30]], [0.0; 3]).expect("finite");
        let still = Pose::IDENTITY;
        for (first, second) in
            [(&still, &turned), (&turned, &still), (&still, &still), (&still, &long), (&long, &still)]
        {
            let query = Query::of_placed(body.at(first), single.at(second));
            let vectors = Vectors::of(&query);
            if [first, second].contains(&&long) {
                assert!(vectors.is_none());
                continue;
            }
            let vectors = vectors.expect("the matrices are moderate");
            let is_image = [first, second].contains(&&turned);
            assert_eq!(vectors.determinant_error, if is_image { DETERMINANT_OF_IMAGES } else { DETERMINANT_OF_ROWS });
            assert_eq!((vectors.len(), vectors.iter().count()), (3, 3));
            for (i, v) in vectors.iter().enumerate() {
                assert_eq!((v.value, v.size), (vectors.value(i), vectors.vector(i).size));
                assert!((0..3).all(|k| v.size[k] >= v.value[k].abs()), "{v:?}");
            }
        }
    }

    #[test]
    fn terms_of_a_cross_product_are_at_least_its_magnitudes_and_hardly_more() {
        let random = &mut Pcg64Mcg::seed_from_u64(25);
        for scale in [1.0, 1e-3, 1e3, 1e-100, 1e-160, 0.0] {
            let mut vector = || {
                let value = [0, 1, 2].map(|_| scale * random.random_range(-1.0..1.0f64));
                Vector { value, size: value.map(f64::abs) }
            };
            let (a, b) = (vector(), vector());
            let of = |v: &Vector, k: usize| Dyadic::from_f64(v.size[k]);
            for (k, terms) in cross_terms(&a, &b).into_iter().enumerate() {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                let exact = of(&a, i) * of(&b, j) + of(&a, j) * of(&b, i);
                let lost = Dyadic::from_f64(2.0 * PRODUCT_UNDERFLOW);
                let terms = Dyadic::from_f64(terms);
                // room for what underflows, which is off by a unit of the least double
                assert!(&terms * &Dyadic::from_f64(1.0 + 8.0 * UNIT) >= &exact + &Dyadic::from_f64(2.0 * 5e-324));
                assert!(terms <= &(&exact * &Dyadic::from_f64(1.0 + 8.0 * UNIT)) + &lost, "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn the_first_of_the_largest_is_taken_and_none_of_nothing() {
        let first = |values: &[f64]| first_of_largest(values.iter().copied().zip(0..));
        assert_eq!(first(&[1.0, 3.0, 2.0, 3.0]), Some(1));
        assert_eq!(first(&[0.5, 0.5, 0.5]), Some(0));
        assert_eq!(first(&[0.0, 0.0]), None);
        assert_eq!(first(&[]), None);
        assert_eq!(first(&[f64::NAN, 1e-300]), Some(1));
    }

    #[test]
    fn a_sum_may_be_off_by_a_rounding_for_each_addition_that_a_term_goes_through() {
        let none = bounded::exact([0.0; 3]);
        let known = [1.0, 2.0, 3.0].map(|value| Bounded { value, error: 1e-3 * value });
        for (count, additions) in [(0, 0), (3, 0), (10, 100), (1000, 0), (1000, 2000), (5, 5)] {
            for scale in [1.0, 1e-3, 1e6] {
                for p in [&none, &known] {
                    let sizes = [scale, 2.0 * scale, 0.0];
                    let own = SumErrors { p, sizes, count }.after(additions);
                    for k in 0..3 {
                        let roundings = |of: usize| of as f64 * UNIT * sizes[k];
                        // eight lanes are added side by side, then joined, with some terms beside
                        let least = p[k].error + roundings(count / 8 + 19 + additions);
                        let most = (p[k].error + roundings(count + 64 + additions)) * 1.001 + 1e-250;
                        assert!(own[k] >= least && own[k] <= most, "{own:?} {count} {additions} {scale}");
                    }
                }
            }
            let tiny = SumErrors { p: &none, sizes: [0.0; 3], count }.after(additions);
            assert!(tiny.iter().all(|&c| c >= (count + additions) as f64 * 5e-324), "{tiny:?}");
        }
    }
}
