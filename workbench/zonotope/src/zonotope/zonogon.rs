//! Zonogons: zonotopes of the plane, whose boundary the generators trace in the order of their angles.

use std::cmp::Ordering;

use super::Zonotope;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::orientation::{Turn, cross_sign};

type Exact = [Dyadic; 2];

impl Zonotope<2> {
    /// The generators turned into the half-plane of directions from (0, −1) (exclusive) counter-clockwise to (0, 1),
    /// sorted by angle, parallel ones added up, zero ones dropped; exact sums. O(n log n).
    pub fn sorted_generators(&self) -> Vec<Exact> {
        let generators: Vec<[f64; 2]> =
            self.generators().iter().filter(|g| **g != [0.0, 0.0]).map(|&g| rightward(g)).collect();
        let mut sorted: Vec<Exact> = Vec::with_capacity(generators.len());
        let mut last = None;
        for generator in sorted_by_angle(&generators, &mut 0) {
            let exact = generator.map(Dyadic::from_f64);
            match (last, sorted.last_mut()) {
                (Some(previous), Some(sum)) if turn(previous, generator) == Ordering::Equal => {
                    *sum = [&sum[0] + &exact[0], &sum[1] + &exact[1]];
                }
                _ => {
                    sorted.push(exact);
                    last = Some(generator);
                }
            }
        }
        sorted
    }

    /// The vertices, exactly, counter-clockwise from the lowest of the leftmost ones: 2n for n directions of
    /// generators, 2 for a segment, 1 for a point. O(n log n).
    pub fn exact_vertices(&self) -> Vec<Exact> {
        let generators = self.sorted_generators();
        let center = self.center().map(Dyadic::from_f64);
        let start = generators.iter().fold(center, |[x, y], g| [x - g[0].clone(), y - g[1].clone()]);
        let mut vertices = vec![start];
        for sign in [1, -1] {
            for g in &generators {
                let [x, y] = vertices.last().expect("the start is there");
                let step = |c: &Dyadic, g: &Dyadic| {
                    let double = g.clone().scaled(1);
                    if sign > 0 { c + &double } else { c - &double }
                };
                vertices.push([step(x, &g[0]), step(y, &g[1])]);
            }
        }
        if vertices.len() > 1 {
            vertices.pop();
        }
        vertices
    }

    /// The vertices rounded, in the order of [`exact_vertices`](Self::exact_vertices).
    pub fn vertices(&self) -> Vec<[f64; 2]> {
        self.exact_vertices().iter().map(|[x, y]| [x.to_f64(), y.to_f64()]).collect()
    }

    /// The area, exactly: 4 Σ |g_i × g_j| over pairs of generators. O(n log n).
    pub fn exact_area(&self) -> Dyadic {
        let mut sum = [Dyadic::zero(), Dyadic::zero()];
        let mut area = Dyadic::zero();
        for [x, y] in self.sorted_generators() {
            area = area + (&sum[0] * &y - &sum[1] * &x);
            sum = [&sum[0] + &x, &sum[1] + &y];
        }
        area.scaled(2)
    }
}

/// The generator or its opposite, whichever points to the right, or upwards if it is vertical.
pub(crate) fn rightward([x, y]: [f64; 2]) -> [f64; 2] {
    if x < 0.0 || (x == 0.0 && y < 0.0) { [-x, -y] } else { [x, y] }
}

/// Vectors that point [`rightward`], none of them zero, in the order of their angles. O(n log n); the comparisons are
/// counted.
///
/// A quotient y/x in doubles never falls where the slope rises, so wherever two quotients differ, their order is the
/// exact one. Whole numbers are sorted in their place, as a processor compares them without a branch: the first bits of
/// each quotient and the place of its vector. The exact turn decides among vectors with the same first bits alone.
pub(crate) fn sorted_by_angle(vectors: &[[f64; 2]], comparisons: &mut u64) -> Vec<[f64; 2]> {
    let bits = usize::BITS - vectors.len().leading_zeros();
    let places = (1 << bits) - 1;
    let key = |[x, y]: [f64; 2]| {
        // an abscissa of −0 would turn the slope of an upward vector over
        let slope = (y / (x + 0.0)).to_bits();
        let rising = if slope >> 63 == 1 { !slope } else { slope | 1 << 63 };
        rising & !places
    };
    let mut keys: Vec<u64> = (0..).zip(vectors).map(|(place, &v)| key(v) | place).collect();
    keys.sort_unstable_by(|a, b| {
        *comparisons += 1;
        a.cmp(b)
    });
    let mut sorted: Vec<[f64; 2]> = keys.iter().map(|key| vectors[(key & places) as usize]).collect();
    let mut start = 0;
    for alike in keys.chunk_by(|a, b| a >> bits == b >> bits) {
        let end = start + alike.len();
        if alike.len() > 1 {
            sorted[start..end].sort_unstable_by(|&a, &b| {
                *comparisons += 1;
                turn(b, a)
            });
        }
        start = end;
    }
    sorted
}

/// The sign of the cross product of two vectors.
pub(crate) fn turn(a: [f64; 2], b: [f64; 2]) -> Ordering {
    let origin = [0.0, 0.0];
    Turn::sign(cross_sign(origin, a, origin, b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn lattice_zonogon() -> impl Strategy<Value = Zonotope<2>> {
        let coordinate = || (-3i8..4).prop_map(f64::from);
        ([coordinate(), coordinate()], proptest::collection::vec([coordinate(), coordinate()], 0..6))
            .prop_map(|(center, generators)| Zonotope::new(center, generators).expect("finite"))
    }

    /// Whether a point lies in the closed zonogon, exactly, by the vertices in order: nothing of the kernel behind
    /// `contains`.
    fn contains_by_vertices(zonogon: &Zonotope<2>, point: [f64; 2]) -> bool {
        let vertices = zonogon.exact_vertices();
        let point = point.map(Dyadic::from_f64);
        let along = |from: &Exact, to: &Exact| [&to[0] - &from[0], &to[1] - &from[1]];
        match &vertices[..] {
            [only] => *only == point,
            [a, b] => {
                let (edge, to_point, back) = (along(a, b), along(a, &point), along(b, &point));
                let dot = &to_point[0] * &back[0] + &to_point[1] * &back[1];
                (&edge[0] * &to_point[1]) == (&edge[1] * &to_point[0]) && !dot.sign().is_gt()
            }
            _ => vertices.iter().zip(vertices.iter().cycle().skip(1)).all(|(a, b)| {
                let (edge, to_point) = (along(a, b), along(a, &point));
                &edge[0] * &to_point[1] >= &edge[1] * &to_point[0]
            }),
        }
    }

    #[test]
    fn a_hexagon_by_hand() {
        let hexagon = Zonotope::new([1.0, 1.0], vec![[1.0, 0.0], [0.0, -1.0], [-1.0, -1.0]]).expect("finite");
        assert_eq!(hexagon.vertices(), [[-1.0, -1.0], [1.0, -1.0], [3.0, 1.0], [3.0, 3.0], [1.0, 3.0], [-1.0, 1.0]]);
        assert_eq!(hexagon.exact_area().to_f64(), 12.0);
        for (y, is_inside) in [(0.0, true), (0f64.next_down(), false)] {
            assert_eq!(contains_by_vertices(&hexagon, [2.0, y]), is_inside);
            assert_eq!(hexagon.contains([2.0, y]), Ok(is_inside));
        }
    }

    /// Coordinates between which quotients tie, overflow and underflow.
    fn coordinate() -> impl Strategy<Value = f64> {
        let sizes =
            prop_oneof![4 => Just(1.0), 1 => Just(5e-324), 1 => Just(1e-310), 1 => Just(1e-160), 1 => Just(5e307)];
        ((-3i8..4).prop_map(f64::from), sizes, 0..4u64).prop_map(|(number, size, ulps)| {
            let moved = f64::from_bits((number * size).to_bits() + ulps);
            if ulps == 3 { number * size } else { moved }
        })
    }

    properties! {
        #[test]
        fn vectors_are_sorted_by_exact_turns(drawn in proptest::collection::vec([coordinate(), coordinate()], 0..40)) {
            let vectors: Vec<[f64; 2]> = drawn.into_iter().filter(|v| *v != [0.0; 2]).map(rightward).collect();
            let sorted = sorted_by_angle(&vectors, &mut 0);
            for pair in sorted.windows(2) {
                prop_assert_ne!(turn(pair[0], pair[1]), Ordering::Less);
            }
            let bits = |list: &[[f64; 2]]| {
                let mut bits: Vec<[u64; 2]> = list.iter().map(|v| v.map(f64::to_bits)).collect();
                bits.sort_unstable();
                bits
            };
            prop_assert_eq!(bits(&sorted), bits(&vectors));
        }

        #[test]
        fn area_is_the_sum_over_pairs(zonogon in lattice_zonogon()) {
            let g = zonogon.generators();
            let pairs = (0..g.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
            let sum: f64 = pairs.map(|(i, j)| (g[i][0] * g[j][1] - g[i][1] * g[j][0]).abs()).sum();
            prop_assert_eq!(zonogon.exact_area().to_f64(), 4.0 * sum);
        }

        #[test]
        fn vertices_are_extreme_and_members_satisfy_the_support_function(
            zonogon in lattice_zonogon(),
            point in [-9i8..10, -9i8..10],
        ) {
            let point = point.map(f64::from);
            for vertex in zonogon.vertices() {
                prop_assert!(contains_by_vertices(&zonogon, vertex));
                prop_assert_eq!(zonogon.contains(vertex), Ok(true));
            }
            let normals = zonogon.generators().iter().flat_map(|&[x, y]| [[-y, x], [y, -x], [x, y], [-x, -y]]);
            let axes = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];
            let inside = normals.chain(axes).all(|u| u[0] * point[0] + u[1] * point[1] <= zonogon.support(u).value());
            prop_assert_eq!(contains_by_vertices(&zonogon, point), inside);
            prop_assert_eq!(zonogon.contains(point), Ok(inside));
        }
    }
}
