//! Near ties: what floating point passes over is held to whole numbers, for points on facets and a unit beside them.

use dashu_int::IBig;
use dashu_int::ops::{Abs, BitTest};

use super::containment::{contains_body, one_outside};
use super::facets::{Facets, reach};
use super::normals::{Image, Normal, image_size, images, normals, reach_bounds, side};
use super::pencils::Pencils;
use crate::exact::length::Length;
use crate::exact::linear::{Echelon, Vector, dot, is_zero};
use crate::exact::proportion::Proportion;
use crate::exact::subsets::subsets;
use crate::exact::wide::Wide;

/// Numbers in a fixed order without any pattern.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, range: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % range
    }

    /// A whole number of some bits, of either sign.
    fn whole(&mut self, bits: usize) -> IBig {
        let magnitude = (IBig::from(self.below(1 << 31)) << 31) + IBig::from(self.below(1 << 31));
        let magnitude = magnitude >> (62 - bits);
        if self.below(2) == 0 { magnitude } else { -magnitude }
    }

    fn vectors(&mut self, count: usize, dimension: usize, bits: usize) -> Vec<Vector> {
        (0..count).map(|_| (0..dimension).map(|_| self.whole(bits)).collect()).collect()
    }
}

/// A vertex of the zonotope that lies farthest along u.
fn vertex(generators: &[Vector], u: &[IBig]) -> Vector {
    let mut sum = vec![IBig::ZERO; u.len()];
    for generator in generators {
        let is_against = dot(generator, u) < IBig::ZERO;
        for (sum, x) in sum.iter_mut().zip(generator) {
            if is_against { *sum -= x } else { *sum += x }
        }
    }
    sum
}

/// A vector with the unit added along an axis.
fn moved(vector: &[IBig], axis: usize, unit: i32) -> Vector {
    vector.iter().enumerate().map(|(at, x)| if at == axis { x + IBig::from(unit) } else { x.clone() }).collect()
}

/// The normals of all facets, of any dimension, exactly.
fn all_normals(dimension: usize, generators: &[Vector]) -> Vec<Vector> {
    let spans = subsets(generators.len(), dimension - 1)
        .map(|facet| Echelon::spanned(dimension, facet.iter().map(|&index| &generators[index])).complement(dimension));
    spans.filter(|complement| complement.len() == 1).flatten().collect()
}

fn is_outside(generators: &[Vector], p: &[IBig]) -> bool {
    all_normals(p.len(), generators).iter().any(|u| dot(u, p).abs() > reach(generators, u))
}

/// Bodies of some dimensions with an interior; their numbers have more digits than doubles.
fn bodies(dimensions: std::ops::RangeInclusive<usize>) -> Vec<(usize, Vec<Vector>)> {
    let mut numbers = Numbers(7);
    let mut bodies = Vec::new();
    for dimension in dimensions {
        for count in dimension..dimension + 4 {
            for bits in [3, 54, 60] {
                let generators = numbers.vectors(count, dimension, bits);
                if Echelon::spanned(dimension, &generators).rank() == dimension {
                    bodies.push((dimension, generators));
                }
            }
        }
    }
    bodies
}

/// Vertices of a body and their neighbours, a unit away along every axis.
fn points_near_the_boundary(dimension: usize, generators: &[Vector]) -> Vec<Vector> {
    let mut points = Vec::new();
    for u in all_normals(dimension, generators).iter().take(6) {
        let vertex = vertex(generators, u);
        for axis in 0..dimension {
            points.extend([1, -1].map(|unit| moved(&vertex, axis, unit)));
        }
        points.push(vertex);
    }
    points
}

#[test]
fn points_on_the_boundary_are_not_outside_and_a_unit_beyond_it_are() {
    let mut counts = [0; 2];
    for (dimension, generators) in bodies(1..=4) {
        for point in points_near_the_boundary(dimension, &generators) {
            let found =
                one_outside(dimension, &generators, std::slice::from_ref(&point)).expect("there are few facets");
            let is_outside = is_outside(&generators, &point);
            assert_eq!(found, is_outside.then_some(0), "{generators:?} {point:?}");
            counts[usize::from(is_outside)] += 1;
        }
    }
    assert!(counts.iter().all(|&count| count > 300), "{counts:?}");
}

#[test]
fn bodies_that_touch_from_inside_are_contained_and_others_by_a_unit_are_not() {
    for (dimension, outer) in bodies(2..=5) {
        let normals = all_normals(dimension, &outer);
        let contains = |outer: &[Vector], inner: &[Vector]| contains_body(dimension, outer, inner);
        for changed in 0..outer.len() {
            for (axis, unit) in (0..dimension).flat_map(|axis| [(axis, 1), (axis, -1)]) {
                let mut inner = outer.clone();
                inner[changed] = moved(&outer[changed], axis, unit);
                let is_contained = normals.iter().all(|u| reach(&inner, u) <= reach(&outer, u));
                assert_eq!(contains(&outer, &inner), Ok(is_contained), "{outer:?} {inner:?}");
            }
            // A generator that is shorter or longer by a part that doubles hardly see.
            let times = |factor: IBig| move |v: &Vector| -> Vector { v.iter().map(|x| x * &factor).collect() };
            let parts: Vec<Vector> = outer.iter().map(times(IBig::ONE << 48)).collect();
            let is_nothing = is_zero(&outer[changed]);
            for (unit, is_contained) in [(1, is_nothing), (-1, true)] {
                let mut inner = parts.clone();
                inner[changed] = times((IBig::ONE << 48) + IBig::from(unit))(&outer[changed]);
                assert_eq!(contains(&parts, &inner), Ok(is_contained), "{outer:?} {inner:?}");
            }
        }
        assert_eq!(contains(&outer, &outer), Ok(true));
        // One generator is left out, or stands there in two halves.
        assert_eq!(contains(&outer, &outer[1..]), Ok(true));
        let doubled: Vec<Vector> = outer.iter().map(|v| v.iter().map(|x| x * 2).collect()).collect();
        let halves = [&doubled[1..], &outer[..1], &outer[..1]].concat();
        assert_eq!(contains(&doubled, &halves), Ok(true));
        assert_eq!(contains(&outer, &doubled), Ok(false));
    }
}

#[test]
fn sides_of_vectors_that_are_almost_orthogonal_are_exact() {
    for (dimension, generators) in bodies(2..=4) {
        for normal in normals(dimension, &generators) {
            let mut near: Vec<Vector> = Vec::new();
            for &index in &normal.subset {
                near.push(generators[index].clone());
                for axis in 0..dimension {
                    near.extend([1, -1].map(|unit| moved(&generators[index], axis, unit)));
                }
            }
            let exact = |v: &Vector| match dot(&normal.exact, v) {
                product if product > IBig::ZERO => 1,
                product if product < IBig::ZERO => -1,
                _ => 0,
            };
            for (v, image) in near.iter().zip(images(&near)) {
                assert_eq!(side(&normal, v, &image), exact(v), "{:?} {v:?}", normal.exact);
            }
        }
    }
}

#[test]
fn bounds_of_a_reach_hold_and_are_narrow() {
    assert_eq!(image_size(&[1.0, -2.0, 3.0, -4.0], &[5.0, 6.0, -7.0, -8.0]), 70.0);
    for (dimension, generators) in bodies(2..=4) {
        let images = images(&generators);
        let bits = generators.iter().flatten().map(|x| x.bit_len()).max().expect("there are generators");
        for normal in normals(dimension, &generators) {
            let own_bits = normal.exact.iter().map(|x| x.bit_len()).max().expect("there are coordinates");
            let unit = i64::try_from(bits + own_bits).expect("numbers are short");
            let exact = Wide::of_whole(&reach(&generators, &normal.exact));
            let [low, high] = reach_bounds(&normal, &images);
            let slack = 4.0 * f64::EPSILON;
            assert!(low <= 0.0 || Wide::new(low, unit).moved(-slack).compare(exact).is_le(), "{generators:?}");
            assert!(exact.compare(Wide::new(high, unit).moved(slack)).is_le(), "{generators:?}");
            let size: f64 = images.iter().map(|image| image_size(&normal.image, image)).sum();
            assert!(high - low <= 1e-13 * size + 1e-280, "{low} {high} {size}");
        }
    }
}

#[test]
fn facets_with_a_point_on_them_are_open_and_few_others() {
    let (mut open_ones, mut all) = (0, 0);
    for (dimension, generators) in bodies(2..=4) {
        for point in points_near_the_boundary(dimension, &generators) {
            let together = [generators.clone(), vec![point.clone()]].concat();
            let together_images: Vec<Image> = images(&together);
            let (own, points) = together_images.split_at(generators.len());
            let pencils = Pencils::new(dimension, own, points);
            for fixed in subsets(generators.len(), dimension - 2) {
                let open = pencils.open(&fixed);
                for k in fixed.last().map_or(0, |last| last + 1)..generators.len() {
                    let facet = [fixed.clone(), vec![k]].concat();
                    let Some(normal) = Normal::of(dimension, &facet, &generators) else { continue };
                    let is_inside = dot(&normal.exact, &point).abs() < reach(&generators, &normal.exact);
                    assert!(is_inside || open.contains(&k), "{generators:?} {point:?} {facet:?}");
                    all += 1;
                    open_ones += usize::from(open.contains(&k));
                }
            }
        }
    }
    assert!(3 * open_ones < 2 * all, "{open_ones} of {all}");
}

#[test]
fn gauges_and_depths_are_those_of_the_facet_that_decides() {
    let mut numbers = Numbers(11);
    for (dimension, generators) in bodies(2..=5) {
        let mut points = points_near_the_boundary(dimension, &generators);
        points.truncate(8);
        points.extend(numbers.vectors(4, dimension, 50));
        let facets = Facets::of(dimension, &generators, &points).expect("there are few facets");
        let normals = all_normals(dimension, &generators);
        for (at, point) in points.iter().enumerate() {
            let quotient = |u: &Vector| Proportion::new(dot(u, point).abs(), reach(&generators, u), 0);
            let gauge = normals.iter().map(quotient).max_by(|a, b| a.compare(b)).expect("there are facets");
            assert!(facets.gauge(at).compare(&gauge).is_eq(), "{generators:?} {point:?}");
            if let Some([low, high]) = facets.gauge_bounds(at) {
                assert!(low.compare(&gauge).is_le() && high.compare(&gauge).is_ge(), "{generators:?} {point:?}");
                assert!(high.nearest() <= low.nearest() * (1.0 + 1e-10), "{generators:?} {point:?}");
            } else {
                assert!(!(3..=4).contains(&dimension), "bounds are known where facets are many");
            }
            if gauge.compare(&Proportion::of_double(1.0)).is_gt() {
                continue;
            }
            let depth =
                |u: &Vector| Length::along(&Proportion::whole(reach(&generators, u) - dot(u, point).abs(), 0), u);
            let least =
                normals.iter().filter_map(depth).reduce(|a, b| if b.compare_length(&a).is_lt() { b } else { a });
            let found = facets.depth(at).zip(least);
            assert!(
                found.is_some_and(|(found, least)| found.compare_length(&least).is_eq()),
                "{generators:?} {point:?}"
            );
        }
    }
}
