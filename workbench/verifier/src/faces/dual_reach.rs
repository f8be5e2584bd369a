//! The reach of the zonotope Σ [−1, 1] λ_j from the origin: the distance of its farthest vertex, squared and exact.
//!
//! A vertex is Σ ± λ_j with the signs that some direction in general position gives. The signs change only where a
//! direction is orthogonal to a vector, so each choice of signs that occurs does so next to a direction u orthogonal
//! to d − 1 independent vectors: the vectors that are not orthogonal to u have their signs from u, and those that are
//! form the same problem in one dimension less. Every choice that is looked at is a point of the zonotope, so none
//! reaches too far; floating point only puts off those that are certainly not the farthest.

use dashu_int::IBig;

use crate::exact::linear::{Echelon, Vector, dot, is_zero};
use crate::exact::subsets::count_subsets;
use crate::faces::normals::{Image, MOST_COORDINATES, TooMany, image_dot, images, normals, side};

/// The number of pairs of a direction and a vector that are gone through.
const MOST_PAIRS: u64 = 2_000_000_000;

/// Choices of signs that fall short of the farthest vertex so far by more than this part are passed over.
///
/// A rounded sum of m vectors errs by (m + 4) 2^-52 Σ |λ_j|, and the farthest vertex is not nearer than 0.4 Σ |λ_j| in
/// at most four dimensions: that is the mean of Σ |λ_j · u| over all unit vectors u. For a million vectors the error
/// is below 10^-9.
const SKIPPED_SHORTFALL: f64 = 1e-8;

const MOST_VECTORS: usize = 1_000_000;

/// A climb to a far vertex ends after so many steps.
const MOST_CLIMBS: usize = 32;

/// max |Σ ± λ_j|² over all choices of signs, unless there are too many vertices.
pub(crate) fn farthest_squared(dimension: usize, vectors: &[Vector]) -> Result<IBig, TooMany> {
    let vectors: Vec<Vector> = vectors.iter().filter(|vector| !is_zero(vector)).cloned().collect();
    let rank = Echelon::spanned(dimension, &vectors).rank();
    let pairs = count_subsets(vectors.len(), rank.saturating_sub(1)).saturating_mul(vectors.len() as u64);
    if dimension > MOST_COORDINATES || pairs > MOST_PAIRS || vectors.len() > MOST_VECTORS {
        return Err(TooMany);
    }
    let mut search = Search {
        images: images(&vectors),
        signs: vec![0; vectors.len()],
        vectors: &vectors,
        farthest: IBig::ZERO,
        rounded: 0.0,
    };
    let all: Vec<usize> = (0..vectors.len()).collect();
    search.explore(&all, vectors.clone(), [0.0; MOST_COORDINATES], true);
    Ok(search.farthest)
}

/// |Σ ± λ_j|² for choices of signs that are found by climbing: never more than that of the farthest vertex, and mostly
/// as much.
///
/// From a point v the climb goes to the vertex that lies farthest along v, which is farther from the origin.
pub(crate) fn far_vertex_squared(dimension: usize, vectors: &[Vector]) -> IBig {
    let axes = (0..dimension).map(|axis| (0..dimension).map(|other| IBig::from(u8::from(other == axis))).collect());
    let longest = vectors.iter().max_by_key(|vector| dot(vector, vector)).cloned();
    let mut farthest = IBig::ZERO;
    for start in axes.chain(longest) {
        let mut direction: Vector = start;
        let mut reached = IBig::ZERO;
        for _ in 0..MOST_CLIMBS {
            let mut vertex = vec![IBig::ZERO; dimension];
            for vector in vectors {
                let is_against = dot(vector, &direction) < IBig::ZERO;
                for (sum, x) in vertex.iter_mut().zip(vector) {
                    if is_against { *sum -= x } else { *sum += x }
                }
            }
            let squared = dot(&vertex, &vertex);
            if squared <= reached {
                break;
            }
            (reached, direction) = (squared, vertex);
        }
        farthest = farthest.max(reached);
    }
    farthest
}

struct Search<'a> {
    vectors: &'a [Vector],
    images: Vec<Image>,
    /// The choice that is being made.
    signs: Vec<i8>,
    farthest: IBig,
    /// The farthest so far, squared, among the images.
    rounded: f64,
}

impl Search<'_> {
    /// Goes through the choices of signs for the vectors named by `open`; `seen` are these vectors in coordinates that
    /// keep them apart, `sum` the rounded sum of those whose sign is chosen. `half` leaves out opposite choices.
    fn explore(&mut self, open: &[usize], seen: Vec<Vector>, sum: Image, half: bool) {
        let span = Echelon::spanned(seen.first().map_or(0, Vec::len), &seen);
        let rank = span.rank();
        if rank == open.len() {
            self.choose_freely(open, sum);
            return;
        }
        let pivots = span.pivots();
        let seen: Vec<Vector> = seen.iter().map(|v| pivots.iter().map(|&axis| v[axis].clone()).collect()).collect();
        let seen_images = images(&seen);
        for normal in normals(rank, &seen) {
            let sides: Vec<i8> =
                seen.iter().zip(&seen_images).map(|(exact, image)| side(&normal, exact, image)).collect();
            let orthogonal: Vec<usize> = (0..open.len()).filter(|&place| sides[place] == 0).collect();
            // A direction that several subsets are orthogonal to is looked at once.
            if orthogonal.len() >= rank && first_basis(rank - 1, &orthogonal, &seen) != normal.subset {
                continue;
            }
            let rest: Vec<usize> = orthogonal.iter().map(|&place| open[place]).collect();
            let rest_seen: Vec<Vector> = orthogonal.iter().map(|&place| seen[place].clone()).collect();
            let opposites: &[i8] = if half { &[1] } else { &[1, -1] };
            for &opposite in opposites {
                let mut sum = sum;
                for (&index, side) in open.iter().zip(&sides) {
                    let sign = side * opposite;
                    self.signs[index] = sign;
                    add(&mut sum, &self.images[index], sign);
                }
                self.explore(&rest, rest_seen.clone(), sum, false);
            }
        }
    }

    /// Independent vectors take every choice of signs.
    fn choose_freely(&mut self, open: &[usize], sum: Image) {
        let Some((&first, others)) = open.split_first() else {
            self.look_at(&sum);
            return;
        };
        for sign in [1, -1] {
            self.signs[first] = sign;
            let mut sum = sum;
            add(&mut sum, &self.images[first], sign);
            self.choose_freely(others, sum);
        }
    }

    fn look_at(&mut self, sum: &Image) {
        let rounded = image_dot(sum, sum);
        if rounded < self.rounded * (1.0 - SKIPPED_SHORTFALL) {
            return;
        }
        self.rounded = self.rounded.max(rounded);
        let mut exact = vec![IBig::ZERO; self.vectors.first().map_or(0, Vec::len)];
        for (vector, &sign) in self.vectors.iter().zip(&self.signs) {
            for (sum, x) in exact.iter_mut().zip(vector) {
                if sign > 0 { *sum += x } else { *sum -= x }
            }
        }
        let squared = dot(&exact, &exact);
        if squared > self.farthest {
            self.farthest = squared;
        }
    }
}

fn add(sum: &mut Image, image: &Image, sign: i8) {
    for (sum, x) in sum.iter_mut().zip(image) {
        *sum += f64::from(sign) * x;
    }
}

/// The first independent vectors among those at the places, as many as span a hyperplane.
fn first_basis(size: usize, places: &[usize], vectors: &[Vector]) -> Vec<usize> {
    let mut span = Echelon::default();
    let independent = places.iter().copied().filter(|&place| span.rank() < size && span.insert(&vectors[place]));
    independent.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn by_all_signs(vectors: &[Vector]) -> IBig {
        let dimension = vectors[0].len();
        let choices = (0..1_u32 << vectors.len()).map(|choice| {
            let mut sum = vec![IBig::ZERO; dimension];
            for (index, vector) in vectors.iter().enumerate() {
                for (sum, x) in sum.iter_mut().zip(vector) {
                    if choice >> index & 1 == 0 { *sum += x } else { *sum -= x }
                }
            }
            dot(&sum, &sum)
        });
        choices.max().expect("there is a choice")
    }

    #[test]
    fn the_farthest_of_all_choices_of_signs() {
        let mut state = 7_u64;
        let mut next = |range: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 33) % range) as i64 - (range / 2) as i64
        };
        for dimension in 1..=4 {
            for count in 1..9 {
                // Small numbers make coplanar and parallel vectors.
                for range in [3, 5, 1 << 30] {
                    let vectors: Vec<Vector> = (0..count)
                        .map(|_| (0..dimension).map(|_| IBig::from(next(range))).collect::<Vector>())
                        .collect();
                    let farthest = by_all_signs(&vectors);
                    assert_eq!(farthest_squared(dimension, &vectors), Ok(farthest.clone()), "{vectors:?}");
                    let far = far_vertex_squared(dimension, &vectors);
                    assert!(far <= farthest && &far * 4 >= farthest, "{far} {farthest} {vectors:?}");
                }
            }
        }
    }

    #[test]
    fn nothing_reaches_nowhere() {
        assert_eq!(farthest_squared(3, &[]), Ok(IBig::ZERO));
        assert_eq!(farthest_squared(2, &[vec![IBig::ZERO, IBig::ZERO]]), Ok(IBig::ZERO));
    }

    fn vectors(rows: &[&[i64]]) -> Vec<Vector> {
        rows.iter().map(|row| row.iter().copied().map(IBig::from).collect()).collect()
    }

    #[test]
    fn as_many_vectors_are_taken_as_the_limits_say() {
        let ones = vec![vec![IBig::ONE]; MOST_VECTORS + 1];
        assert_eq!(farthest_squared(1, &ones), Err(TooMany));
        let sum = IBig::from(MOST_VECTORS);
        assert_eq!(farthest_squared(1, &ones[1..]), Ok(&sum * &sum));
        assert_eq!(farthest_squared(5, &vectors(&[&[1, 0, 0, 0, 0]])), Err(TooMany), "five dimensions");
    }

    /// The signs (+, +) come first, and (+, −) lead farther by a part of 2^-39.
    #[test]
    fn a_vertex_that_is_hardly_farther_than_one_before_is_not_passed_over() {
        let long = 1_i64 << 40;
        let pair = vectors(&[&[long, 0], &[-1, long]]);
        let farther = IBig::from(long + 1) * IBig::from(long + 1) + IBig::from(long) * IBig::from(long);
        assert_eq!((farthest_squared(2, &pair), by_all_signs(&pair)), (Ok(farther.clone()), farther));
    }

    /// Bodies of which climbs from other starts, or with other signs of orthogonal vectors, end at nearer vertices.
    #[test]
    fn climbs_from_the_axes_and_the_longest_vector_end_at_the_farthest_vertex_of_small_bodies() {
        let bodies: [(&[&[i64]], i64); 6] = [
            (&[&[1, 1, 0], &[0, 1, -2], &[-1, 1, 2]], 21),
            (&[&[-1, 2, -2], &[1, 0, -1], &[-2, -1, -2], &[2, 1, 2]], 65),
            (&[&[1, 0], &[0, 2], &[1, 1]], 13),
            (&[&[-2, -2, 0], &[0, 1, -2], &[-2, 2, 2]], 33),
            (&[&[-1, -1], &[2, 0], &[0, 2]], 18),
            (&[&[0, 2, 0], &[-1, 0, 2], &[1, 1, 1]], 18),
        ];
        for (rows, farthest) in bodies {
            let body = vectors(rows);
            let found = far_vertex_squared(body[0].len(), &body);
            assert_eq!((found, by_all_signs(&body)), (IBig::from(farthest), IBig::from(farthest)), "{rows:?}");
        }
    }
}
