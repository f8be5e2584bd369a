//! The point of a zonotope that is nearest to another point, exactly.
//!
//! # Method
//! After Wolfe (Finding the nearest point in a polytope, 1976). The nearest point x of the hull of some affinely
//! independent vertices is kept, of which each has a positive part in x. The vertex w that lies farthest along the
//! vector r from x to the point p either is no farther than x, and then x is nearest of all; or it joins the others.
//! If the nearest point of their affine hull has negative parts, the way to it ends where the first part is used up,
//! that vertex leaves, and the next affine hull is smaller. The distance decreases strictly, so no set of vertices
//! comes twice. All numbers are whole ones over a common denominator.

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use crate::exact::length::Length;
use crate::exact::linear::{Vector, dot, reduced, solve};
use crate::exact::proportion::Proportion;

/// The work of one round beside that of a generator.
const ROUND_WORK: u64 = 40;

/// The number of further bits of the numbers that make a step take as long again.
const BITS_A_STEP: usize = 400;

/// The place of a point relative to a distance from a zonotope.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reach {
    /// Some point of the zonotope is that near.
    Near,
    /// No point of the zonotope is that near.
    Far,
    /// The work that may be done is used up.
    Open,
}

/// Whether the zonotope Σ δ_i g_i, |δ_i| ≤ 1, comes as near to a point as a limit says. The work that is done is taken
/// from `work`.
pub(crate) fn reach(point: &Vector, generators: &[Vector], limit: &Proportion, work: &mut u64) -> Reach {
    let bits = point.iter().chain(generators.iter().flatten()).map(|c| c.bit_len()).max().unwrap_or(0);
    let round = (generators.len() as u64 + ROUND_WORK) * (1 + bits / BITS_A_STEP) as u64;
    let mut corral = Corral::at(difference(point, &farthest_vertex(generators, point)));
    loop {
        let Some(left) = work.checked_sub(round) else { return Reach::Open };
        *work = left;
        let (rest, denominator) = corral.nearest();
        let square = dot(&rest, &rest);
        let length = Proportion::new(square.clone(), &denominator * &denominator, 0);
        if Length::of_square(length).compare(limit) != Ordering::Greater {
            return Reach::Near;
        }
        let next = difference(point, &farthest_vertex(generators, &rest));
        let gap = dot(&rest, &next);
        // The plane through w orthogonal to r leaves the whole zonotope on the other side.
        if gap > IBig::ZERO
            && Length::along(&Proportion::whole(gap.clone(), 0), &rest)
                .is_some_and(|apart| apart.compare(limit) == Ordering::Greater)
        {
            return Reach::Far;
        }
        if gap * &denominator >= square {
            return Reach::Far;
        }
        if !corral.join(next) {
            return Reach::Open;
        }
    }
}

fn difference(a: &[IBig], b: &[IBig]) -> Vector {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// Σ ± g_i with the signs of a direction.
fn farthest_vertex(generators: &[Vector], direction: &[IBig]) -> Vector {
    let mut vertex = vec![IBig::ZERO; direction.len()];
    for generator in generators {
        let is_against = dot(generator, direction) < IBig::ZERO;
        for (sum, c) in vertex.iter_mut().zip(generator) {
            if is_against { *sum -= c } else { *sum += c }
        }
    }
    vertex
}

/// Affinely independent points, and the point of their hull that is nearest to the origin.
struct Corral {
    points: Vec<Vector>,
    /// The part of each point, positive, over their sum.
    parts: Vector,
}

impl Corral {
    fn at(point: Vector) -> Self {
        Self { points: vec![point], parts: vec![IBig::ONE] }
    }

    /// The nearest point: a vector over a denominator.
    fn nearest(&self) -> (Vector, IBig) {
        (combined(&self.points, &self.parts), self.parts.iter().sum())
    }

    /// Takes one more point, which lies nearer to the origin than the plane of the others; whether that was so.
    fn join(&mut self, point: Vector) -> bool {
        self.points.push(point);
        self.parts.push(IBig::ZERO);
        loop {
            let Some(wanted) = affine_parts(&self.points) else { return false };
            if wanted.iter().all(|part| *part > IBig::ZERO) {
                self.parts = reduced(wanted);
                return true;
            }
            self.walk(&wanted);
            let is_kept: Vec<bool> = self.parts.iter().map(|part| *part > IBig::ZERO).collect();
            if is_kept.iter().all(|kept| *kept) {
                return false;
            }
            let mut kept = is_kept.iter();
            self.points.retain(|_| kept.next().is_some_and(|kept| *kept));
            self.parts.retain(|part| *part > IBig::ZERO);
        }
    }

    /// Goes from the parts at hand towards the wanted ones until the first is used up.
    fn walk(&mut self, wanted: &[IBig]) {
        let [own, others]: [IBig; 2] = [self.parts.iter().sum(), wanted.iter().sum()];
        // Both over one denominator.
        let from: Vector = self.parts.iter().map(|part| part * &others).collect();
        let to: Vector = wanted.iter().map(|part| part * &own).collect();
        // The share θ = from / (from − to) of the way, the least one.
        let mut share: Option<(IBig, IBig)> = None;
        for (from, to) in from.iter().zip(&to).filter(|(_, to)| **to <= IBig::ZERO) {
            let all = from - to;
            let is_less = share.as_ref().is_none_or(|(least, of)| from * of < least * &all);
            if is_less && all > IBig::ZERO {
                share = Some((from.clone(), all));
            }
        }
        let Some((share, all)) = share else { return };
        let rest = &all - &share;
        self.parts = reduced(from.iter().zip(&to).map(|(from, to)| from * &rest + to * &share).collect());
    }
}

fn combined(points: &[Vector], parts: &[IBig]) -> Vector {
    let mut sum = vec![IBig::ZERO; points.first().map_or(0, Vec::len)];
    for (point, part) in points.iter().zip(parts) {
        sum.iter_mut().zip(point).for_each(|(sum, c)| *sum += c * part);
    }
    sum
}

/// The parts, over their positive sum, of the point of the affine hull that is nearest to the origin; `None` if the
/// points are dependent.
fn affine_parts(points: &[Vector]) -> Option<Vector> {
    let (first, others) = points.split_first()?;
    let edges: Vec<Vector> = others.iter().map(|point| difference(point, first)).collect();
    let products = |v: &Vector| -> Vector { edges.iter().map(|edge| dot(edge, v)).collect() };
    let gram: Vec<Vector> = edges.iter().map(products).collect();
    let target = products(first).into_iter().map(|c| -c).collect::<Vector>();
    let (solved, denominator) = solve(&gram.iter().collect::<Vec<_>>(), &target)?;
    let taken: IBig = solved.iter().sum();
    let parts = [vec![denominator - taken], solved].concat();
    // Over a positive denominator their sum is that denominator.
    Some(parts)
}

#[cfg(test)]
mod tests {
    use dashu_int::ops::Abs;

    use super::*;

    fn vectors(rows: &[&[i64]]) -> Vec<Vector> {
        rows.iter().map(|row| row.iter().copied().map(IBig::from).collect()).collect()
    }

    fn found(point: &[i64], generators: &[&[i64]], limit: f64) -> Reach {
        let point = vectors(&[point]).remove(0);
        reach(&point, &vectors(generators), &Proportion::of_double(limit), &mut 100_000)
    }

    #[test]
    fn points_of_a_cube_and_beside_it() {
        let cube: [&[i64]; 3] = [&[2, 0, 0], &[0, 2, 0], &[0, 0, 2]];
        assert_eq!(found(&[2, 1, -2], &cube, 0.0), Reach::Near);
        assert_eq!(found(&[3, 3, 0], &cube, 2.0_f64.sqrt()), Reach::Near, "the double is above the root");
        assert_eq!(found(&[3, 3, 0], &cube, 2.0_f64.sqrt().next_down()), Reach::Far);
        assert_eq!(found(&[5, 6, 1], &cube, 5.0), Reach::Near);
        assert_eq!(found(&[5, 6, 1], &cube, 5.0_f64.next_down()), Reach::Far);
        assert_eq!(found(&[1, 2, 2], &[], 3.0), Reach::Near);
        assert_eq!(found(&[1, 2, 2], &[], 2.5), Reach::Far);
        assert_eq!(found(&[1, 2, 2], &[&[0, 0, 0]], 2.5), Reach::Far);
        let point = vectors(&[&[5, 6, 1]]).remove(0);
        assert_eq!(reach(&point, &vectors(&cube), &Proportion::of_double(1.0), &mut 10), Reach::Open);
    }

    /// The nearest coefficients of all, by trying for each generator whether it is at one of its ends or free.
    fn squared_by_all_faces(point: &Vector, generators: &[Vector]) -> Proportion {
        let mut least: Option<Proportion> = None;
        for choice in 0..3_usize.pow(generators.len() as u32) {
            let of = |index: usize| choice / 3_usize.pow(index as u32) % 3;
            let (mut rest, mut free) = (point.clone(), Vec::new());
            for (index, generator) in generators.iter().enumerate() {
                match of(index) {
                    2 => free.push(generator),
                    sign => rest.iter_mut().zip(generator).for_each(|(r, c)| if sign == 0 { *r -= c } else { *r += c }),
                }
            }
            let products = |v: &Vector| -> Vector { free.iter().map(|g| dot(g, v)).collect() };
            let gram: Vec<Vector> = free.iter().map(|g| products(g)).collect();
            let Some((solved, whole)) = solve(&gram.iter().collect::<Vec<_>>(), &products(&rest)) else { continue };
            if solved.iter().any(|x| x.clone().abs() > whole) {
                continue;
            }
            let left: Vector = (0..point.len())
                .map(|axis| &rest[axis] * &whole - free.iter().zip(&solved).map(|(g, x)| &g[axis] * x).sum::<IBig>())
                .collect();
            let square = Proportion::new(dot(&left, &left), &whole * &whole, 0);
            if least.as_ref().is_none_or(|least| square.compare(least).is_lt()) {
                least = Some(square);
            }
        }
        least.expect("corners are tried as well")
    }

    #[test]
    fn the_nearest_of_all_faces() {
        let mut state = 11_u64;
        let mut next = |range: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 33) % range) as i64 - (range / 2) as i64
        };
        for dimension in 1..=4 {
            for count in 0..6 {
                for range in [3, 7, 1 << 24] {
                    let mut vector =
                        |scale: i64| -> Vector { (0..dimension).map(|_| IBig::from(next(range) * scale)).collect() };
                    let generators: Vec<Vector> = (0..count).map(|_| vector(1)).collect();
                    let point = vector(3);
                    let square = squared_by_all_faces(&point, &generators);
                    let root = square.root();
                    let [low, high] =
                        [1.0 - 1e-12, 1.0 + 1e-12].map(|factor| root.times(&Proportion::of_double(factor)));
                    let at = |limit: &Proportion| reach(&point, &generators, limit, &mut 100_000);
                    assert_eq!(at(&high), Reach::Near, "{point:?} {generators:?}");
                    if square.compare(&Proportion::of_double(0.0)).is_gt() {
                        assert_eq!(at(&low), Reach::Far, "{point:?} {generators:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn each_round_takes_the_work_of_the_generators_and_more_for_long_numbers() {
        let square = vectors(&[&[2, 0], &[0, 2]]);
        let left = |bits: usize, work: u64| {
            let [point, square] = [&vectors(&[&[2, 2]]), &square]
                .map(|list| list.iter().map(|v| v.iter().map(|c| c << bits).collect()).collect::<Vec<Vector>>());
            let mut work = work;
            (reach(&point[0], &square, &Proportion::of_double(0.0), &mut work), work)
        };
        // a corner is found in the first round: 2 generators, and 40 for the round itself
        assert_eq!(left(0, 1_000), (Reach::Near, 1_000 - 42));
        assert_eq!(left(0, 42), (Reach::Near, 0));
        assert_eq!(left(0, 41), (Reach::Open, 41));
        // numbers of 800 bits have two times 400 further ones, and a round takes three times as long
        assert_eq!(left(798, 1_000), (Reach::Near, 1_000 - 3 * 42));
    }

    #[test]
    fn the_farthest_vertex_has_the_signs_of_the_direction_and_a_generator_across_it_as_it_is() {
        let generators = vectors(&[&[1, 2], &[-3, 1], &[0, -5]]);
        assert_eq!(farthest_vertex(&generators, &vectors(&[&[1, 0]])[0]), vectors(&[&[4, -4]])[0]);
        assert_eq!(farthest_vertex(&generators, &vectors(&[&[-1, 0]])[0]), vectors(&[&[-4, -6]])[0]);
    }

    #[test]
    fn a_point_that_has_no_part_leaves_the_others() {
        // the point (1, 0) is the nearest one to the origin of the line through it and (1, 1)
        let mut corral = Corral::at(vectors(&[&[1, 1]]).remove(0));
        assert!(corral.join(vectors(&[&[1, 0]]).remove(0)));
        assert_eq!((corral.points, corral.parts), (vectors(&[&[1, 0]]), vectors(&[&[1]])[0].clone()));
    }

    /// Numbers from −range / 2 to range / 2 that come in the same order each time.
    fn numbers(mut state: u64) -> impl FnMut(u64) -> i64 {
        move |range| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 33) % (range + 1)) as i64 - (range / 2) as i64
        }
    }

    #[test]
    fn every_point_of_a_zonotope_is_at_no_distance_from_it() {
        let mut next = numbers(5);
        for round in 0..600 {
            let (dimension, count) = (2 + round % 3, 1 + round / 3 % 7);
            let mut vector = || -> Vector { (0..dimension).map(|_| IBig::from(next(8))).collect() };
            let generators: Vec<Vector> = (0..count).map(|_| vector()).collect();
            // the generators are four times as long, and the point has at most four times the short ones
            let factors: Vector = (0..count).map(|_| IBig::from(next(8))).collect();
            let point = combined(&generators, &factors);
            let generators: Vec<Vector> = generators.iter().map(|v| v.iter().map(|c| c * 4).collect()).collect();
            let outcome = reach(&point, &generators, &Proportion::of_double(0.0), &mut 100_000);
            assert_eq!(outcome, Reach::Near, "{point:?} {generators:?}");
        }
    }

    /// The way to these nearest points is one on which vertices leave again, one at a time or two at once.
    #[test]
    fn nearest_points_are_found_in_few_rounds_where_vertices_leave() {
        // a point, generators and the number of rounds
        type Case<'a> = (&'a [i64], &'a [&'a [i64]], u64);
        let cases: [Case; 6] = [
            (&[2, 0], &[&[0, 2], &[1, 2]], 3),
            (&[1, 2], &[&[-4, -2], &[1, 0]], 3),
            (&[2, 3], &[&[1, -2], &[-1, 0], &[-2, 1]], 3),
            (&[-1, 3], &[&[3, -3], &[3, -2], &[-2, 1]], 4),
            (&[23, 22], &[&[-3, 17], &[-6, 6], &[-5, 14], &[-10, 9], &[7, -5], &[7, -11]], 3),
            (&[-58, -42, 30], &[&[-14, 20, 8], &[-17, -8, 3], &[17, -1, 17], &[-16, 12, -13], &[1, 13, 6]], 4),
        ];
        for (point, generators, rounds) in cases {
            let (point, generators) = (vectors(&[point]).remove(0), vectors(generators));
            let square = squared_by_all_faces(&point, &generators);
            let limit = square.root().times(&Proportion::of_double(1.0 + 1e-12));
            let mut work = rounds * (generators.len() as u64 + ROUND_WORK);
            assert_eq!(reach(&point, &generators, &limit, &mut work), Reach::Near, "{point:?}");
            assert_eq!(work, 0, "{point:?}");
        }
    }
}
