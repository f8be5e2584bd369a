//! Proptest strategies for generators of any dimension: every way of being degenerate that the methods promise to
//! handle.

use proptest::collection::vec;
use proptest::prelude::*;

use super::numbers::{any_magnitude, lattice, moved_by_ulps, plain, power_of_two, scale};

/// Generators of R^D.
pub type Generators<const D: usize> = Vec<[f64; D]>;

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
        ("near_copies", near_copies(most)),
        ("mixed_scales", vectors(any_magnitude, most.min(6))),
        ("huge_and_tiny", huge_and_tiny(most)),
        ("ends_of_the_range", ends_of_the_range(most.min(6))),
    ]
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

/// Lattice generators, copies of them and opposite ones, one coordinate of most copies moved by 2^-52 to 2^-30.
fn near_copies<const D: usize>(most: usize) -> BoxedStrategy<Generators<D>> {
    let copies = vec((any::<prop::sample::Index>(), any::<bool>(), 0..D.max(1), -53..=-30i32), 0..=most.div_ceil(2));
    (vec(vector::<D>(lattice), 1..=most.div_ceil(2).max(1)), copies)
        .prop_map(|(mut generators, copies)| {
            for (original, is_opposite, place, exponent) in copies {
                let mut copy = *original.get(&generators);
                if is_opposite {
                    copy = copy.map(|v| -v);
                }
                if let (Some(v), true) = (copy.get_mut(place), exponent > -53) {
                    *v += power_of_two(exponent);
                }
                generators.push(copy);
            }
            generators
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
