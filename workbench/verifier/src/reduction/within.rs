//! Whether a zonotope lies within a distance of another one: every vertex of it has a point of the other that near.
//!
//! The distance from a convex body is a convex function, so nowhere on a zonotope is it larger than at its farthest
//! vertex. Generators that both bodies have in common are left out before: they leave the distance as it is. A near
//! point of the other zonotope is sought in floating point with a bound of all rounding; where that leaves a doubt,
//! the nearest point is found exactly, and so is whether it is near enough.

use dashu_int::IBig;
use dashu_int::ops::{Abs, BitTest};

use super::difference::without_common_summands;
use super::nearest_point::{Reach, reach};
use super::rounded_search::RoundedBody;
use super::vertices::{is_of_half, point, vertices};
use crate::exact::length::Length;
use crate::exact::linear::{Vector, dot, is_zero};
use crate::exact::proportion::Proportion;
use crate::faces::normals::{Image, MOST_COORDINATES, images};
use crate::verdict::Stop;

/// Limit of the pairs of a vertex and a generator of the other zonotope that are gone through.
const MOST_PRODUCTS: usize = 12_000_000;

/// Limit of the steps for nearest points that are found exactly: some tenths of a microsecond each.
const MOST_EXACT_STEPS: u64 = 1_500_000;

/// Two zonotopes in whole numbers of a unit, the first to lie within a distance of the second.
pub(super) struct Within<'a> {
    /// From the centre of the second to that of the first.
    pub(super) offset: &'a Vector,
    pub(super) first: &'a [Vector],
    pub(super) second: &'a [Vector],
    /// The exponent of the unit.
    pub(super) exponent: i32,
}

impl Within<'_> {
    /// Proves that every point of the first zonotope is at most so far from the second. Nothing is beyond an infinite
    /// distance.
    pub(super) fn check(&self, distance: f64) -> Result<(), Stop> {
        if distance == f64::INFINITY {
            return Ok(());
        }
        let limit = Proportion::of_double(distance).times(&Proportion::whole(IBig::ONE, -self.exponent));
        let [first, second] = without_common_summands([self.first, self.second]);
        if self.is_small(&first, &limit) {
            return Ok(());
        }
        let too_many = || Stop::Unchecked("too many vertices to try".to_owned());
        let most = MOST_PRODUCTS / second.len().max(1);
        let signs = vertices(self.offset.len(), &first, most).ok_or_else(too_many)?;
        // Without an offset both bodies are symmetric about one point.
        let is_centred = is_zero(self.offset);
        let points: Vec<Vector> = signs
            .iter()
            .filter(|signs| !is_centred || is_of_half(signs))
            .map(|signs| point(self.offset, &first, signs))
            .collect();
        let doubtful = doubtful(&points, &second, &limit);
        let mut work = MOST_EXACT_STEPS;
        for point in doubtful {
            match reach(point, &second, &limit, &mut work) {
                Reach::Near => {}
                Reach::Far => return Err("the bodies are farther apart than the upper bound".into()),
                Reach::Open => {
                    return Err(Stop::Unchecked("the nearest points of all vertices take too long to find".to_owned()));
                }
            }
        }
        Ok(())
    }

    /// Whether even the centre of the second zonotope is near enough to every point of the first one: it is if the
    /// offset and all generators together are no longer than the limit.
    fn is_small(&self, first: &[Vector], limit: &Proportion) -> bool {
        let mut extent: Vector = self.offset.iter().map(|c| c.clone().abs()).collect();
        for generator in first {
            extent.iter_mut().zip(generator).for_each(|(sum, c)| *sum += c.clone().abs());
        }
        let square = Proportion::whole(dot(&extent, &extent), 0);
        Length::of_square(square).compare(limit).is_le()
    }
}

/// The points for which floating point finds no near point of a zonotope.
fn doubtful<'a>(points: &'a [Vector], generators: &[Vector], limit: &Proportion) -> Vec<&'a Vector> {
    if points.first().is_none_or(|point| point.len() > MOST_COORDINATES) {
        return points.iter().collect();
    }
    let all: Vec<Vector> = points.iter().chain(generators).cloned().collect();
    let largest = all.iter().flatten().map(|c| c.bit_len()).max().unwrap_or(0);
    let all = images(&all);
    let (point_images, generator_images) = all.split_at(points.len());
    // Images are in units of the power of two above all components.
    let shift = -i32::try_from(largest).expect("numbers of a check fit into memory");
    let rounded = limit.times(&Proportion::whole(IBig::ONE, shift)).nearest().next_down();
    let body = RoundedBody::new(generator_images);
    let is_open = |image: &Image| !body.is_near(image, rounded);
    points.iter().zip(point_images).filter(|(_, image)| is_open(image)).map(|(point, _)| point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vectors(rows: &[&[i64]]) -> Vec<Vector> {
        rows.iter().map(|row| row.iter().copied().map(IBig::from).collect()).collect()
    }

    fn check(offset: &[i64], first: &[&[i64]], second: &[&[i64]], distance: f64) -> Result<(), Stop> {
        let (offset, first, second) = (vectors(&[offset]).remove(0), vectors(first), vectors(second));
        Within { offset: &offset, first: &first, second: &second, exponent: 0 }.check(distance)
    }

    fn is_wrong(outcome: Result<(), Stop>) -> bool {
        matches!(outcome, Err(Stop::Wrong(_)))
    }

    #[test]
    fn squares_and_cubes_by_hand() {
        let [small, large]: [[&[i64]; 2]; 2] = [[&[1, 0], &[0, 1]], [&[2, 0], &[0, 2]]];
        let root = 2.0_f64.sqrt();
        assert!(check(&[0, 0], &large, &small, root).is_ok(), "the double is above the root");
        assert!(is_wrong(check(&[0, 0], &large, &small, root.next_down())));
        assert!(check(&[0, 0], &small, &large, 0.0).is_ok(), "it is inside");
        assert!(check(&[3, 0], &small, &large, 2.0).is_ok());
        assert!(is_wrong(check(&[3, 0], &small, &large, 1.9)));
        let cube: [&[i64]; 3] = [&[1, 0, 0], &[0, 1, 0], &[0, 0, 1]];
        let diagonal = 3.0_f64.sqrt();
        assert!(check(&[0, 0, 0], &cube, &[], diagonal.next_up()).is_ok(), "a corner of the cube");
        assert!(is_wrong(check(&[0, 0, 0], &cube, &[], 1.73)));
        assert!(check(&[0, 0, 0], &cube, &[], f64::INFINITY).is_ok());
    }

    #[test]
    fn a_body_is_at_no_distance_from_itself() {
        let moment: [&[i64]; 3] = [&[1, 1, 1], &[1, 2, 4], &[1, 3, 9]];
        assert!(check(&[0, 0, 0], &moment, &moment, 0.0).is_ok());
        assert!(is_wrong(check(&[0, 0, 1], &moment, &moment, 0.5)));
        // of another one a generator, of three parallel ones, is longer by a unit
        let longer: [&[i64]; 5] = [&[1, 3, 9], &[-1, -1, -1], &[1, 2, 4], &[1, 1, 1], &[0, 0, 0]];
        assert!(check(&[0, 0, 0], &longer, &moment, 3.0_f64.sqrt().next_up()).is_ok());
        assert!(check(&[0, 0, 0], &moment, &longer, 0.0).is_ok(), "it is inside");
        let six: [&[i64]; 2] = [&[1, 2, 0, 1, 0, 1], &[1, 1, 0, 2, 0, 1]];
        assert!(
            check(&[0; 6], &six[..1], &six[1..], 1.4).is_ok() && is_wrong(check(&[0; 6], &six[..1], &six[1..], 1.3))
        );
    }

    #[test]
    fn facets_of_several_generators_and_flat_bodies() {
        // a hexagonal prism around its axis: the corners of the hexagon are at (2, 2), (2, 0), (0, 2), …
        let prism: [&[i64]; 4] = [&[1, 0, 0], &[0, 1, 0], &[1, 1, 0], &[0, 0, 5]];
        let axis: [&[i64]; 1] = [&[0, 0, 5]];
        assert!(check(&[0, 0, 0], &prism, &axis, 8.0_f64.sqrt().next_up()).is_ok());
        assert!(is_wrong(check(&[0, 0, 0], &prism, &axis, 2.8)));
        let segment: [&[i64]; 2] = [&[1, 1, 0], &[2, 2, 0]];
        assert!(check(&[0, 0, 1], &segment, &segment, 1.0).is_ok());
        assert!(is_wrong(check(&[0, 0, 1], &segment, &segment, 0.99)));
        assert!(check(&[0, 3], &[], &[&[0, 1]], 2.0).is_ok());
    }

    /// Generators of so many coordinates, in general position.
    fn in_general_position(dimension: usize, count: usize) -> Vec<Vector> {
        let mut state = 9_u64;
        let mut component = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            IBig::from((state >> 33) as i64 - (1 << 30))
        };
        (0..count).map(|_| (0..dimension).map(|_| component()).collect()).collect()
    }

    /// The manual names these sizes; the second one is told by the products of its vertices and generators.
    #[test]
    fn bounds_are_checked_up_to_the_stated_sizes() {
        for (dimension, count) in [(2, 1_000), (3, 200)] {
            let first = in_general_position(dimension, count);
            let offset = vec![IBig::ZERO; dimension];
            let second = &first[..1];
            let within = Within { offset: &offset, first: &first[1..], second, exponent: 0 };
            assert!(is_wrong(within.check(1.0)), "{dimension}");
            assert!(count_of_vertices(dimension, count) * count <= MOST_PRODUCTS, "{dimension}");
        }
    }

    /// The number of vertices of a zonotope in general position.
    fn count_of_vertices(dimension: usize, count: usize) -> usize {
        if dimension == 2 { 2 * count } else { count * (count - 1) + 2 }
    }

    #[test]
    fn what_takes_too_long_is_left_open() {
        let many: Vec<Vector> = (0..3000).map(|i| vec![IBig::from(i), IBig::from(i * i), IBig::ONE]).collect();
        let offset = vec![IBig::ZERO; 3];
        let within = Within { offset: &offset, first: &many, second: &many[..1], exponent: 0 };
        assert!(matches!(within.check(1.0), Err(Stop::Unchecked(_))));
        assert!(within.check(1e14).is_ok(), "all generators together are shorter");
        // fourteen independent generators have 16384 vertices, each to be tried with a thousand generators
        let axes: Vec<Vector> =
            (0..14).map(|row| (0..14).map(|column| IBig::from(i32::from(row == column))).collect()).collect();
        let others: Vec<Vector> = (1..=1_000).map(|x| [vec![IBig::from(x); 13], vec![IBig::ONE]].concat()).collect();
        let within = Within { offset: &vec![IBig::ZERO; 14], first: &axes, second: &others, exponent: 0 };
        let outcome = within.check(1.0);
        assert!(matches!(outcome, Err(Stop::Unchecked(reason)) if reason == "too many vertices to try"));
    }

    #[test]
    fn distances_are_in_lengths_and_components_in_units() {
        // a segment of four units around a point twelve units away: its far end is at sixteen
        let [offset, first] = [vec![IBig::from(12)], vec![IBig::from(4)]];
        for (exponent, distance) in [(-2, 4.0_f64), (0, 16.0), (3, 128.0)] {
            let within = Within { offset: &offset, first: std::slice::from_ref(&first), second: &[], exponent };
            assert!(within.check(distance).is_ok(), "{exponent}");
            assert!(is_wrong(within.check(distance.next_down())), "{exponent}");
        }
    }

    #[test]
    fn of_a_moved_body_each_end_counts() {
        let segment: [&[i64]; 1] = [&[1, 0]];
        for offset in [[3, 0], [-3, 0]] {
            assert!(check(&offset, &segment, &[], 4.0).is_ok());
            assert!(is_wrong(check(&offset, &segment, &[], 3.0)), "the other end is at two: {offset:?}");
        }
    }

    #[test]
    fn every_coordinate_of_a_long_vector_counts() {
        let (segment, offset): ([&[i64]; 1], _) = ([&[1, 0, 0, 0, 0, 0]], [0, 0, 0, 0, 0, 7]);
        assert!(check(&offset, &segment, &[&[0, 1, 0, 0, 0, 0]], 7.1).is_ok());
        assert!(is_wrong(check(&offset, &segment, &[&[0, 1, 0, 0, 0, 0]], 7.0)));
    }

    #[test]
    fn floating_point_leaves_no_doubt_of_points_well_within_the_limit() {
        let points = vectors(&[&[3, 0, 0, 0], &[0, 0, 0, 3], &[2, 2, 0, 1]]);
        let square = vectors(&[&[2, 0, 0, 0], &[0, 2, 0, 0]]);
        let limit = Proportion::of_double(1.5);
        assert_eq!(doubtful(&points, &square, &limit), [&points[1]], "it is at a distance of three");
        let flat = vectors(&[&[3, 0], &[0, 3]]);
        assert!(doubtful(&flat, &vectors(&[&[2, 0], &[0, 2]]), &limit).is_empty());
    }
}
