//! The hyperplanes that d − 1 of some vectors span, and how far others are from them: exactly, by floating point where
//! it leaves no doubt.

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use crate::exact::linear::{Vector, dot, is_zero, product};
use crate::exact::subsets::subsets;

/// The most coordinates that an image has.
pub(crate) const MOST_COORDINATES: usize = 4;

/// A vector in floating point: each component within a relative 2^-52 of the true one over a common power of two, or 0
/// for one that is below 2^-958 there.
pub(crate) type Image = [f64; MOST_COORDINATES];

/// Twice what the rounding of two images and of their inner product adds up to, relative to the sum of the absolute
/// products.
pub(crate) const DOT_ERROR: f64 = 1.0 / (1_u64 << 47) as f64;

/// The loss of an inner product by components that are left out of images, and by products below the normal doubles:
/// images are not larger than 1, so four components lose no more than 2^-955, and this is 2^11 times as much.
pub(crate) const UNDERFLOW: f64 = 1e-284;

/// The images of vectors of at most [`MOST_COORDINATES`] components, the largest component of all in [1/2, 1).
pub(crate) fn images(vectors: &[Vector]) -> Vec<Image> {
    let largest = vectors.iter().flatten().map(|x| x.bit_len()).max().unwrap_or(0);
    vectors.iter().map(|v| image(v, largest)).collect()
}

/// The image of one vector by itself.
fn own_image(v: &Vector) -> Image {
    image(v, v.iter().map(|x| x.bit_len()).max().unwrap_or(0))
}

fn image(v: &Vector, shift: usize) -> Image {
    let mut image = [0.0; MOST_COORDINATES];
    for (slot, x) in image.iter_mut().zip(v) {
        let dropped = x.bit_len().saturating_sub(64);
        let leading = if dropped == 0 { x.to_f64().value() } else { (x >> dropped).to_f64().value() };
        *slot = leading * power_of_two(dropped as i64 - shift as i64);
    }
    image
}

/// 2^exponent for exponents ≤ 0; zero far below the range of doubles.
fn power_of_two(exponent: i64) -> f64 {
    if exponent < -1022 { 0.0 } else { f64::from_bits(((exponent + 1023) as u64) << 52) }
}

/// The inner product of two images.
pub(crate) fn image_dot(u: &Image, v: &Image) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2] + u[3] * v[3]
}

/// The sum of the absolute products.
pub(crate) fn image_size(u: &Image, v: &Image) -> f64 {
    (u[0] * v[0]).abs() + (u[1] * v[1]).abs() + (u[2] * v[2]).abs() + (u[3] * v[3]).abs()
}

/// There are more facets, or vertices, than can be gone through.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct TooMany;

/// A vector orthogonal to a subset of the vectors of a set.
pub(crate) struct Normal {
    /// The subset, ascending: one vector less than there are dimensions.
    pub(crate) subset: Vec<usize>,
    pub(crate) exact: Vector,
    pub(crate) image: Image,
}

/// The normal of every independent subset of `dimension` − 1 of the vectors, which have `dimension` components.
pub(crate) fn normals(dimension: usize, vectors: &[Vector]) -> impl Iterator<Item = Normal> {
    subsets(vectors.len(), dimension - 1).filter_map(move |subset| Normal::of(dimension, &subset, vectors))
}

impl Normal {
    /// That of a subset, unless it is dependent.
    pub(crate) fn of(dimension: usize, subset: &[usize], vectors: &[Vector]) -> Option<Self> {
        let rows: Vec<&Vector> = subset.iter().map(|&index| &vectors[index]).collect();
        let exact = orthogonal(dimension, &rows);
        (!is_zero(&exact)).then(|| Self { image: own_image(&exact), subset: subset.to_vec(), exact })
    }
}

/// The signed minors of dimension − 1 rows.
fn orthogonal(dimension: usize, rows: &[&Vector]) -> Vector {
    (0..dimension)
        .map(|left_out| {
            let columns: Vec<usize> = (0..dimension).filter(|&column| column != left_out).collect();
            let minor = determinant(rows, &columns);
            if left_out % 2 == 0 { minor } else { -minor }
        })
        .collect()
}

/// By expansion along the first row: there are at most three.
fn determinant(rows: &[&Vector], columns: &[usize]) -> IBig {
    let Some((first, rest)) = rows.split_first() else {
        return IBig::ONE;
    };
    if let ([second], [a, b]) = (rest, columns) {
        return product(&first[*a], &second[*b]) - product(&first[*b], &second[*a]);
    }
    let mut sum = IBig::ZERO;
    for (position, &column) in columns.iter().enumerate() {
        let others: Vec<usize> = columns.iter().copied().filter(|&other| other != column).collect();
        let term = product(&first[column], &determinant(rest, &others));
        sum = if position % 2 == 0 { sum + term } else { sum - term };
    }
    sum
}

/// The sign of the inner product of a normal with a vector: −1, 0 or 1.
pub(crate) fn side(normal: &Normal, exact: &Vector, image: &Image) -> i8 {
    let rounded = image_dot(&normal.image, image);
    if rounded.abs() > DOT_ERROR * image_size(&normal.image, image) + UNDERFLOW {
        return if rounded > 0.0 { 1 } else { -1 };
    }
    match dot(&normal.exact, exact).cmp(&IBig::ZERO) {
        std::cmp::Ordering::Less => -1,
        std::cmp::Ordering::Equal => 0,
        std::cmp::Ordering::Greater => 1,
    }
}

/// Bounds of Σ |u · g_i| for a normal u and the images of generators.
pub(crate) fn reach_bounds(normal: &Normal, images: &[Image]) -> [f64; 2] {
    let (mut reach, mut size) = (0.0, 0.0);
    for image in images {
        reach += image_dot(&normal.image, image).abs();
        size += image_size(&normal.image, image);
    }
    let count = images.len() as f64;
    let doubt = size * (DOT_ERROR + count * f64::EPSILON) + (count + 1.0) * UNDERFLOW;
    [(reach - doubt).next_down(), (reach + doubt).next_up()]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vector(components: &[i64]) -> Vector {
        components.iter().copied().map(IBig::from).collect()
    }

    #[test]
    fn normals_are_orthogonal_to_their_subsets() {
        let vectors = [
            vector(&[2, 0, 1, 5]),
            vector(&[0, 3, -1, 1]),
            vector(&[7, 1, 1, 0]),
            vector(&[4, 0, 2, 10]),
            vector(&[1, 1, 9, -4]),
        ];
        let mut found = 0;
        for normal in normals(4, &vectors) {
            assert!(normal.subset.iter().all(|&index| dot(&normal.exact, &vectors[index]) == IBig::ZERO));
            found += 1;
        }
        assert_eq!(found, 7, "of ten subsets those with both parallel vectors have none");
        let plane = [vector(&[3, 4]), vector(&[0, 0])];
        let found: Vec<Vector> = normals(2, &plane).map(|normal| normal.exact).collect();
        assert_eq!(found, [vector(&[4, -3])]);
        assert_eq!(normals(1, &plane[..1]).next().map(|normal| normal.exact), Some(vector(&[1])));
    }

    #[test]
    fn images_keep_proportions() {
        let wide = vec![IBig::from(3) << 3000, IBig::from(-1) << 2998, IBig::from(1)];
        let [image] = images(&[wide])[..] else { panic!("one vector, one image") };
        assert_eq!(image, [0.75, -0.0625, 0.0, 0.0]);
        let one = Normal { subset: vec![], exact: vector(&[1, 1]), image: own_image(&vector(&[1, 1])) };
        let close = vec![(IBig::ONE << 200) + 1, -(IBig::ONE << 200)];
        assert_eq!(side(&one, &close, &images(std::slice::from_ref(&close))[0]), 1, "decided exactly");
    }

    #[test]
    fn the_smallest_normal_double_is_kept_in_an_image() {
        let far_apart = vec![IBig::ONE << 1021, IBig::ONE];
        assert_eq!(own_image(&far_apart), [0.5, f64::MIN_POSITIVE, 0.0, 0.0]);
    }

    fn with_image(exact: Vector) -> Normal {
        Normal { subset: vec![], image: own_image(&exact), exact }
    }

    #[test]
    fn bounds_of_a_reach_hold_for_no_generator_and_for_many() {
        let diagonal = with_image(vector(&[1, 1]));
        let [low, high] = reach_bounds(&diagonal, &[]);
        assert!(low <= 0.0 && high >= 0.0, "{low} {high}");
        // The products are exact: a half of 3/4 and of 1/4.
        let [low, high] = reach_bounds(&diagonal, &images(&vec![vector(&[3, 1]); 100]));
        assert!(low <= 50.0 && high >= 50.0, "{low} {high}");
        // A component of 2^-962 of the largest one is lost; its product is 2^-963.
        let lost = images(&[vec![IBig::ONE << 2000, IBig::ONE << 1039]]);
        let [low, high] = reach_bounds(&with_image(vector(&[0, 1])), &lost);
        assert!(lost[0][1] == 0.0 && low <= 0.0 && high >= 0.5_f64.powi(963), "{low} {high}");
    }

    /// A product that is above 0 as far as images tell, and below it by a component that they leave out.
    #[test]
    fn a_component_that_is_left_out_of_an_image_decides_the_side() {
        let normal = with_image(vec![IBig::ONE, IBig::ONE << 500, IBig::ZERO]);
        for (sign, side_of_it) in [(IBig::ONE, -1), (IBig::NEG_ONE, 1)] {
            let v = vec![&sign * (IBig::ONE << 1130), -&sign * (IBig::ONE << 640), IBig::ONE << 1599];
            let image = images(std::slice::from_ref(&v))[0];
            assert!(image[1] == 0.0 && image_dot(&normal.image, &image) * f64::from(side_of_it) < 0.0);
            assert_eq!(side(&normal, &v, &image), side_of_it);
        }
    }
}
