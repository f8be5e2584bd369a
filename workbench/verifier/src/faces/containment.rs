//! Whether a zonotope contains points: each is held against every facet.
//!
//! Every facet of { Σ δ_i g_i : |δ_i| ≤ 1 } is orthogonal to a normal u of d − 1 independent generators, so a vector p
//! of their span lies inside just when |u · p| ≤ Σ |u · g_i| for all these u. In floating point first, pencil by
//! pencil; what rounding leaves open, exactly.

use dashu_int::IBig;
use dashu_int::ops::Abs;

use super::pencils::Pencils;
use crate::exact::linear::{Echelon, Vector, dot, is_zero};
use crate::exact::subsets::{count_subsets, subsets};
use crate::faces::facets::reach;
use crate::faces::normals::{
    DOT_ERROR, Image, MOST_COORDINATES, Normal, TooMany, image_dot, image_size, images, normals, reach_bounds,
};

/// The number of pairs of a facet and a point that are gone through, and of an open facet and a generator.
const MOST_PAIRS: u64 = 4_000_000_000;

/// The number of exact products of a facet normal and a generator that are taken.
const MOST_EXACT_PRODUCTS: u64 = 3_000_000;

/// Finding a facet takes as long as this many points.
const POINTS_A_FACET: usize = 32;

/// A vector that does not lie in the zonotope of the generators around the origin, unless there are too many facets.
pub(crate) fn one_outside(
    dimension: usize,
    generators: &[Vector],
    vectors: &[Vector],
) -> Result<Option<usize>, TooMany> {
    let generators: Vec<Vector> = generators.iter().filter(|generator| !is_zero(generator)).cloned().collect();
    let span = Echelon::spanned(dimension, &generators);
    if let Some(beside) = vectors.iter().position(|vector| !span.contains(vector)) {
        return Ok(Some(beside));
    }
    let rank = span.rank();
    if rank == 0 {
        return Ok(None);
    }
    let pairs = count_subsets(generators.len(), rank - 1).saturating_mul((POINTS_A_FACET + vectors.len()) as u64);
    if rank > MOST_COORDINATES || pairs > MOST_PAIRS {
        return Err(TooMany);
    }
    // In coordinates that tell the vectors of the span apart, the zonotope has an interior.
    let pivots = span.pivots();
    let projected = |v: &Vector| -> Vector { pivots.iter().map(|&axis| v[axis].clone()).collect() };
    let all: Vec<Vector> = generators.iter().chain(vectors).map(projected).collect();
    let all_images = images(&all);
    let (exact_generators, exact_points) = all.split_at(generators.len());
    let (generator_images, point_images) = all_images.split_at(generators.len());
    let body = Body { generators: exact_generators, images: generator_images };
    let mut open_pairs = 0_u64;
    let pencils = Pencils::new(rank, generator_images, point_images);
    let mut beyond = |facet: &[usize]| {
        open_pairs += generators.len() as u64;
        if open_pairs > MOST_PAIRS {
            return Err(TooMany);
        }
        let normal = Normal::of(rank, facet, exact_generators);
        Ok(normal.and_then(|normal| body.first_beyond(&normal, exact_points, point_images)))
    };
    if rank == 1 {
        return beyond(&[]);
    }
    for mut facet in subsets(generators.len(), rank - 2) {
        for last in pencils.open(&facet) {
            facet.push(last);
            if let Some(outside) = beyond(&facet)? {
                return Ok(Some(outside));
            }
            facet.pop();
        }
    }
    Ok(None)
}

/// Whether the zonotope of the outer generators contains that of the inner ones, unless there are too many facets:
/// along each facet normal u of the outer one, Σ |u · inner| is at most Σ |u · outer|.
pub(crate) fn contains_body(dimension: usize, outer: &[Vector], inner: &[Vector]) -> Result<bool, TooMany> {
    let span = Echelon::spanned(dimension, outer);
    if inner.iter().any(|vector| !span.contains(vector)) {
        return Ok(false);
    }
    let (rank, pivots) = (span.rank(), span.pivots());
    if rank == 0 {
        return Ok(true);
    }
    let projected = |v: &Vector| -> Vector { pivots.iter().map(|&axis| v[axis].clone()).collect() };
    let [outer, inner] = [outer, inner].map(|list| list.iter().map(projected).collect::<Vec<Vector>>());
    let products = count_subsets(outer.len(), rank - 1).saturating_mul((outer.len() + inner.len()) as u64);
    if rank > MOST_COORDINATES {
        if products > MOST_EXACT_PRODUCTS {
            return Err(TooMany);
        }
        return Ok(subsets(outer.len(), rank - 1).all(|facet| {
            let normal = Echelon::spanned(rank, facet.iter().map(|&index| &outer[index])).complement(rank);
            !matches!(&normal[..], [u] if reach(&inner, u) > reach(&outer, u))
        }));
    }
    if products > MOST_PAIRS {
        return Err(TooMany);
    }
    let all = [outer.clone(), inner.clone()].concat();
    let all = images(&all);
    let (outer_images, inner_images) = all.split_at(outer.len());
    Ok(normals(rank, &outer).all(|normal| {
        let [[low, _], [_, high]] = [outer_images, inner_images].map(|images| reach_bounds(&normal, images));
        high < low || reach(&inner, &normal.exact) <= reach(&outer, &normal.exact)
    }))
}

/// The zonotope of some generators, exactly and as images.
struct Body<'a> {
    generators: &'a [Vector],
    images: &'a [Image],
}

impl Body<'_> {
    /// The first point that is beyond one of the two facets with a normal.
    fn first_beyond(&self, normal: &Normal, points: &[Vector], images: &[Image]) -> Option<usize> {
        let [least, _] = reach_bounds(normal, self.images);
        let is_open = |image: &Image| {
            let certain = (least - image_size(&normal.image, image) * DOT_ERROR).next_down();
            image_dot(&normal.image, image).abs() >= certain
        };
        let open: Vec<usize> = (0..points.len()).filter(|&index| is_open(&images[index])).collect();
        if open.is_empty() {
            return None;
        }
        let exact_reach: IBig = self.generators.iter().map(|generator| dot(&normal.exact, generator).abs()).sum();
        open.into_iter().find(|&index| dot(&normal.exact, &points[index]).abs() > exact_reach)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vectors(rows: &[&[i64]]) -> Vec<Vector> {
        rows.iter().map(|row| row.iter().copied().map(IBig::from).collect()).collect()
    }

    fn outside(generators: &[&[i64]], points: &[&[i64]]) -> Option<usize> {
        one_outside(points[0].len(), &vectors(generators), &vectors(points)).expect("few facets")
    }

    #[test]
    fn a_box_and_its_boundary_by_hand() {
        let cube: [&[i64]; 3] = [&[2, 0, 0], &[0, 2, 0], &[0, 0, 2]];
        assert_eq!(outside(&cube, &[&[2, -2, 2], &[0, 0, 0], &[1, 2, -1]]), None);
        assert_eq!(outside(&cube, &[&[2, -2, 2], &[0, 3, 0], &[2, 2, 2]]), Some(1));
        let huge = 1_i64 << 60;
        assert_eq!(outside(&[&[huge, 0], &[0, 1]], &[&[huge, 1]]), None);
        assert_eq!(outside(&[&[huge, 0], &[0, 1]], &[&[huge + 1, 1]]), Some(0), "one unit beyond");
    }

    #[test]
    fn flat_bodies_and_points() {
        let segment: [&[i64]; 2] = [&[1, 2, 3], &[2, 4, 6]];
        assert_eq!(outside(&segment, &[&[3, 6, 9], &[-1, -2, -3]]), None);
        assert_eq!(outside(&segment, &[&[3, 6, 9], &[4, 8, 12]]), Some(1));
        assert_eq!(outside(&segment, &[&[1, 2, 4]]), Some(0), "beside its line");
        assert_eq!(outside(&[], &[&[0, 0], &[0, 1]]), Some(1));
        assert_eq!(outside(&[&[0, 0]], &[&[0, 0]]), None);
    }

    #[test]
    fn too_many_facets_are_not_begun() {
        let many: Vec<Vector> = (0..20_000).map(|i| vec![IBig::from(i), IBig::from(i * i), IBig::ONE]).collect();
        assert_eq!(one_outside(3, &many, &many[..1]), Err(TooMany));
    }

    #[test]
    fn a_body_of_four_dimensions() {
        let cross: [&[i64]; 5] = [&[1, 0, 0, 0], &[0, 1, 0, 0], &[0, 0, 1, 0], &[0, 0, 0, 1], &[1, 1, 1, 1]];
        assert_eq!(outside(&cross, &[&[2, 2, 2, 2], &[2, 2, 2, 0]]), None);
        assert_eq!(outside(&cross, &[&[2, 2, 2, 2], &[2, -1, 2, 0]]), Some(1));
    }

    /// Generators of the plane of which no two are parallel: a facet each.
    fn fan(count: usize) -> Vec<Vector> {
        (0..count).map(|k| vec![IBig::ONE, IBig::from(k)]).collect()
    }

    fn repeated(row: &[i64], count: usize) -> Vec<Vector> {
        std::iter::repeat_n(vectors(&[row]), count).flatten().collect()
    }

    /// A point far away tells at the first facet, so that the limit alone takes time.
    #[test]
    fn as_many_facets_and_points_are_gone_through_as_the_limit_says() {
        let points = [repeated(&[1 << 40, 0], 1), repeated(&[0, 0], 64_000 - POINTS_A_FACET - 1)].concat();
        assert_eq!(62_500 * (points.len() + POINTS_A_FACET) as u64, MOST_PAIRS);
        assert_eq!(one_outside(2, &fan(62_500), &points), Ok(Some(0)));
        assert_eq!(one_outside(2, &fan(62_501), &points), Err(TooMany));
    }

    /// Parallel generators span no facet, but they are taken for one that is open. Of 46 generators along the first
    /// axis each is paired with all that follow it along this axis, before a facet comes that the point is beyond.
    #[test]
    fn open_facets_are_gone_through_up_to_the_limit() {
        let search = |along: usize| {
            let (first, second, third) = (|n| repeated(&[1, 0, 0], n), [0, 1, 0], [0, 0, 1]);
            let generators =
                [first(46), repeated(&second, 1), first(along - 46), repeated(&third, 12_499 - along)].concat();
            let open_ones: usize = (1..=46).map(|taken| along - taken).sum();
            let point = vectors(&[&[along as i64 + 1, 0, 0]]);
            (((open_ones + 1) * generators.len()) as u64, one_outside(3, &generators, &point))
        };
        assert_eq!(search(6_980), (MOST_PAIRS, Ok(Some(0))));
        assert_eq!(search(6_981), (46 * 12_500 + MOST_PAIRS, Err(TooMany)));
    }

    #[test]
    fn bodies_are_held_against_each_other_up_to_the_limits() {
        let long = repeated(&[1 << 40, 0], 1_500);
        assert_eq!(62_500 * (62_500 + long.len()) as u64, MOST_PAIRS);
        assert_eq!(contains_body(2, &fan(62_500), &long), Ok(false));
        assert_eq!(contains_body(2, &fan(62_501), &long), Err(TooMany));
        // Six generators have fifteen subsets of four.
        let six = vectors(&[
            &[1, 0, 0, 0, 0],
            &[0, 1, 0, 0, 0],
            &[0, 0, 1, 0, 0],
            &[0, 0, 0, 1, 0],
            &[0, 0, 0, 0, 1],
            &[1, 1, 1, 1, 1],
        ]);
        let inner = |count: usize| [repeated(&[0, 0, 0, 0, 9], 1), repeated(&[0; 5], count - 1)].concat();
        let most = (MOST_EXACT_PRODUCTS / 15) as usize - six.len();
        assert_eq!(contains_body(5, &six, &inner(most)), Ok(false));
        assert_eq!(contains_body(5, &six, &inner(most + 1)), Err(TooMany));
        // Four dimensions are gone through in floating point, where more products are taken.
        let curve: Vec<Vector> = (0..60).map(|t: i64| (0..4).map(|power| IBig::from(t.pow(power))).collect()).collect();
        assert!(count_subsets(60, 3) * 61 < MOST_EXACT_PRODUCTS && count_subsets(60, 3) * 120 > MOST_EXACT_PRODUCTS);
        assert_eq!(contains_body(4, &curve, &repeated(&[0, 0, 0, 1 << 40], 60)), Ok(false));
    }

    /// The point (2^60 + 3, −2^60) is three beyond the origin along (1, 1), less than its rounding.
    #[test]
    fn a_far_point_that_is_hardly_beyond_a_facet_is_found_there() {
        let all = vectors(&[&[1, -1], &[1, 1], &[(1 << 60) + 3, -(1 << 60)], &[(1 << 60) + 2, -(1 << 60)]]);
        let all_images = images(&all);
        let body = Body { generators: &all[..2], images: &all_images[..2] };
        let normal = Normal::of(2, &[0], &all).expect("one vector of the plane has a normal");
        let beyond = |at: usize| body.first_beyond(&normal, &all[at..=at], &all_images[at..=at]);
        assert_eq!((beyond(2), beyond(3)), (Some(0), None), "the facet is two from the origin");
    }
}
