//! Proptest strategies for questions of collision in any dimension: every way of being degenerate that the methods
//! promise to handle.
//!
//! A question is generators and the two ends of a displacement. Where the displacement ends is constructed from the
//! generators: on a vertex, an edge or a facet, a unit in the last place off it, well inside, well outside, in the
//! centre.

use proptest::collection::vec;
use proptest::prelude::*;
use zonotope::collision::Query;

use crate::numbers::{any_magnitude, lattice, moved_by_ulps, plain, power_of_two, scale};

/// Generators of R^D.
pub type Generators<const D: usize> = Vec<[f64; D]>;

/// The ends of a displacement and the generators that it is relative to.
#[derive(Clone, Debug)]
pub struct Asked<const D: usize> {
    /// The start of the displacement.
    pub from: [f64; D],
    /// The end of the displacement.
    pub to: [f64; D],
    /// The generators.
    pub generators: Generators<D>,
}

impl<const D: usize> Asked<D> {
    /// The question as the library takes it.
    pub fn displacement(&self) -> Query<'_, D> {
        Query::new(self.from, self.to, &self.generators).expect("the families make finite numbers")
    }
}

/// Every family of generators, by name, with at most `most` generators.
pub fn families<const D: usize>(most: usize) -> Vec<(&'static str, BoxedStrategy<Generators<D>>)> {
    vec![
        ("random", vectors(plain, most)),
        ("lattice", vectors(lattice, most)),
        ("scaled", scaled(most)),
        ("parallel", parallel(most)),
        ("coplanar", coplanar(most)),
        ("flat", flat(most)),
        ("boxes", boxes(most)),
        ("duplicates_and_zeros", duplicates_and_zeros(most)),
        ("nearly_parallel", nearly_parallel(most)),
        ("one_ulp", one_ulp(most)),
        ("mixed_scales", vectors(any_magnitude, most.min(6))),
        ("huge_and_tiny", huge_and_tiny(most)),
        ("ends_of_the_range", ends_of_the_range(most.min(6))),
    ]
}

/// Questions about generators of a family.
pub fn asked<const D: usize>(generators: BoxedStrategy<Generators<D>>) -> BoxedStrategy<Asked<D>> {
    let place = prop_oneof![
        3 => (0.0..3.0f64).prop_map(Place::Through),
        4 => Just(Place::Facet),
        2 => Just(Place::Edge),
        2 => Just(Place::Vertex),
        1 => Just(Place::Center),
        1 => Just(Place::Anywhere),
    ];
    let steps = prop_oneof![2 => Just(0i32).boxed(), 1 => (-2..=2i32).boxed()];
    let start = prop_oneof![3 => Just(Start::Origin), 2 => Just(Start::Tail), 1 => Just(Start::Far)];
    (
        generators,
        place,
        vec(-1.0..1.0f64, D),
        vec(0..5usize, D),
        vec(any::<prop::sample::Index>(), D),
        vec(steps, D),
        start,
    )
        .prop_map(|(generators, place, random, shares, chosen, steps, start)| {
            let exact = place.sums(&generators, &random, &shares, &chosen);
            let [sum, tail] = exact;
            let mut to: [f64; D] = std::array::from_fn(|k| moved_by_ulps(sum[k], steps[k]).clamp(-f64::MAX, f64::MAX));
            let from: [f64; D] = match start {
                Start::Origin => [0.0; D],
                Start::Tail => tail.map(|v| -v),
                Start::Far => {
                    to = std::array::from_fn(|k| (to[k] + 1e16).clamp(-f64::MAX, f64::MAX));
                    std::array::from_fn(|k| if shares[k] == 0 { -1.0 } else { 1e16 })
                }
            };
            Asked { from, to, generators }
        })
        .boxed()
}

#[derive(Clone, Copy, Debug)]
enum Start {
    /// The displacement starts at the origin, so that it is `to` itself.
    Origin,
    /// The displacement starts at what the rounding of `to` lost, so that the difference is exact.
    Tail,
    /// The displacement starts so far away that the difference of its ends loses digits.
    Far,
}

#[derive(Clone, Copy, Debug)]
enum Place {
    /// A multiple of a boundary point.
    Through(f64),
    Facet,
    Edge,
    Vertex,
    Center,
    Anywhere,
}

impl Place {
    /// The point as the sum of two vectors, exactly unless its digits do not fit.
    fn sums<const D: usize>(
        self,
        generators: &[[f64; D]],
        random: &[f64],
        shares: &[usize],
        chosen: &[prop::sample::Index],
    ) -> [[f64; D]; 2] {
        let on_face = match self {
            Self::Center => return [[0.0; D]; 2],
            Self::Anywhere => return [std::array::from_fn(|k| 2.0 * random[k]), [0.0; D]],
            Self::Facet | Self::Through(_) => D - 1,
            Self::Edge => 1,
            Self::Vertex => 0,
        };
        let count = on_face.min(generators.len());
        let face: Vec<usize> = (0..count).map(|k| chosen[k].index(generators.len())).collect();
        let normal = normal_of(generators, &face, random);
        let mut total = [[0.0; D]; 2];
        for (i, generator) in generators.iter().enumerate() {
            let along: f64 = generator.iter().zip(&normal).map(|(a, b)| a * b).sum();
            let coefficient = match face.iter().position(|&f| f == i) {
                Some(k) => [-1.0, -0.5, 0.0, 0.5, 1.0][shares[k]],
                None => along.signum(),
            };
            for k in 0..D {
                // The rounded sum and, in the second vector, what is lost.
                let [sum, lost] = [total[0][k], coefficient * generator[k]];
                let next = sum + lost;
                let back = next - sum;
                total[0][k] = next;
                total[1][k] += (sum - (next - back)) + (lost - back);
            }
        }
        let factor = if let Self::Through(factor) = self { factor } else { 1.0 };
        total.map(|part| part.map(|v| if v.is_nan() { 0.0 } else { (v * factor).clamp(-f64::MAX, f64::MAX) }))
    }
}

/// A direction near orthogonal to the generators of a face: a random one with their shares taken out.
fn normal_of<const D: usize>(generators: &[[f64; D]], face: &[usize], random: &[f64]) -> [f64; D] {
    let largest = generators.iter().flatten().fold(f64::MIN_POSITIVE, |m, v| m.max(v.abs()));
    let mut normal: [f64; D] = std::array::from_fn(|k| random[k]);
    let mut axes: Vec<[f64; D]> = Vec::new();
    let dot = |a: &[f64; D], b: &[f64; D]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    for &f in face {
        let mut axis = generators[f].map(|v| v / largest);
        for other in &axes {
            let along = dot(&axis, other);
            axis = std::array::from_fn(|k| axis[k] - along * other[k]);
        }
        let length = dot(&axis, &axis).sqrt();
        if length > 0.0 {
            axes.push(axis.map(|v| v / length));
        }
    }
    for _ in 0..2 {
        for axis in &axes {
            let along = dot(&normal, axis);
            normal = std::array::from_fn(|k| normal[k] - along * axis[k]);
        }
    }
    normal.map(|v| v / largest.sqrt())
}

fn vector<const D: usize>(number: fn() -> BoxedStrategy<f64>) -> BoxedStrategy<[f64; D]> {
    vec(number(), D).prop_map(|v| v.try_into().expect("D numbers were drawn")).boxed()
}

fn vectors<const D: usize>(number: fn() -> BoxedStrategy<f64>, most: usize) -> BoxedStrategy<Generators<D>> {
    vec(vector(number), 0..=most).boxed()
}

/// Any of the shapes below times one power of two.
fn scaled<const D: usize>(most: usize) -> BoxedStrategy<Generators<D>> {
    let shapes = prop_oneof![vectors(plain, most), vectors(lattice, most), parallel(most), coplanar(most)];
    (shapes, scale()).prop_map(|(shape, scale)| shape.into_iter().map(|g| g.map(|v| v * scale)).collect()).boxed()
}

/// Multiples of a few directions, exactly.
fn parallel<const D: usize>(most: usize) -> BoxedStrategy<Generators<D>> {
    let directions = prop_oneof![vec(vector(plain), 1..=D + 1), vec(vector(lattice), 1..=D + 1)];
    (directions, vec((any::<prop::sample::Index>(), -8..=8i32, any::<bool>()), 0..=most))
        .prop_map(|(directions, draws)| {
            let multiple = |(index, exponent, minus): (prop::sample::Index, i32, bool)| {
                let factor = if minus { -power_of_two(exponent) } else { power_of_two(exponent) };
                index.get(&directions).map(|v| v * factor)
            };
            draws.into_iter().map(multiple).collect()
        })
        .boxed()
}

/// Generators in a few coordinate planes and others: facets with more sides than they need.
fn coplanar<const D: usize>(most: usize) -> BoxedStrategy<Generators<D>> {
    vec((vector(plain), 0..D, any::<bool>()), 0..=most)
        .prop_map(|draws| {
            let flatten = |(mut g, axis, keep): ([f64; D], usize, bool)| {
                if !keep {
                    g[axis] = 0.0;
                }
                g
            };
            draws.into_iter().map(flatten).collect()
        })
        .boxed()
}

/// All generators in the span of D − 1 lattice vectors, exactly; in R^1 the zero vector.
fn flat<const D: usize>(most: usize) -> BoxedStrategy<Generators<D>> {
    (vec(vector::<D>(lattice), D - 1), vec(vec(-3..=3i32, D - 1), 0..=most))
        .prop_map(|(span, draws)| {
            let combine = |shares: Vec<i32>| {
                std::array::from_fn(|k| span.iter().zip(&shares).map(|(v, &s)| f64::from(s) * v[k]).sum::<f64>())
            };
            draws.into_iter().map(combine).collect()
        })
        .boxed()
}

/// Two boxes, one with the axes and one with exactly orthogonal edges of small integers: D generators each.
fn boxes<const D: usize>(most: usize) -> BoxedStrategy<Generators<D>> {
    let half_length = || prop_oneof![(1..=6i32).prop_map(f64::from).boxed(), (0.01..2.0f64).boxed()];
    (vec(half_length(), 2 * D), any::<bool>())
        .prop_map(move |(half_lengths, turned)| {
            let axis = |k: usize| -> [f64; D] { std::array::from_fn(|l| if l == k { 1.0 } else { 0.0 }) };
            let mut second: Vec<[f64; D]> = (0..D).map(axis).collect();
            if turned && D >= 2 {
                (second[0][0], second[0][1], second[1][0], second[1][1]) = (3.0, 4.0, -4.0, 3.0);
            }
            let edges = (0..D).map(axis).chain(second);
            edges.zip(half_lengths).map(|(edge, h)| edge.map(|v| v * h)).take(most).collect()
        })
        .boxed()
}

/// A few vectors, each many times and in both orientations, with zero vectors among them.
fn duplicates_and_zeros<const D: usize>(most: usize) -> BoxedStrategy<Generators<D>> {
    (vec(vector(plain), 1..=D), vec((any::<prop::sample::Index>(), -1..=1i32), 0..=most))
        .prop_map(|(distinct, draws)| {
            draws.into_iter().map(|(draw, sign)| draw.get(&distinct).map(|v| v * f64::from(sign))).collect()
        })
        .boxed()
}

/// One or two directions with noise of about 1e-13.
fn nearly_parallel<const D: usize>(most: usize) -> BoxedStrategy<Generators<D>> {
    (vec(vector::<D>(plain), 2), vec((any::<bool>(), vector::<D>(lattice)), 0..=most))
        .prop_map(|(directions, draws)| {
            let noisy = |(first, noise): (bool, [f64; D])| {
                let direction = directions[usize::from(first)];
                std::array::from_fn(|k| direction[k] + noise[k] * 2.5e-14)
            };
            draws.into_iter().map(noisy).collect()
        })
        .boxed()
}

/// Lattice and coplanar generators, each coordinate moved by at most one unit in the last place.
fn one_ulp<const D: usize>(most: usize) -> BoxedStrategy<Generators<D>> {
    let shapes = prop_oneof![vectors(lattice, most), coplanar(most), flat(most)];
    (shapes, vec(vec(-1..=1i32, D), most))
        .prop_map(|(shape, steps)| {
            let moved = |(g, s): ([f64; D], Vec<i32>)| std::array::from_fn(|k| moved_by_ulps(g[k], s[k]));
            shape.into_iter().zip(steps).map(moved).collect()
        })
        .boxed()
}

/// Generators of one size and generators of another, far apart.
fn huge_and_tiny<const D: usize>(most: usize) -> BoxedStrategy<Generators<D>> {
    (vec((vector(plain), any::<bool>()), 0..=most), 20..=600i32)
        .prop_map(|(draws, exponent)| {
            let factor = power_of_two(-exponent);
            draws.into_iter().map(|(g, tiny)| if tiny { g.map(|v: f64| v * factor) } else { g }).collect()
        })
        .boxed()
}

/// Multiples of the smallest double, and numbers next to the largest.
fn ends_of_the_range<const D: usize>(most: usize) -> BoxedStrategy<Generators<D>> {
    let tiny = || (-6..=6i64).prop_map(|k| k as f64 * f64::from_bits(1)).boxed();
    let huge = || {
        (prop_oneof![Just(1.0), Just(-1.0), Just(0.5), Just(0.0)], 0..=2i32)
            .prop_map(|(part, step)| part * moved_by_ulps(f64::MAX, -step))
            .boxed()
    };
    prop_oneof![vectors(tiny, most), vectors(huge, most)].boxed()
}
