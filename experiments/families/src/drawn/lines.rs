//! Proptest strategies for the kernel: weighted lines with a linear term, degenerate in every way that a promise names.

use std::f64::consts::TAU;
use std::ops::RangeInclusive;

use proptest::collection::vec;
use proptest::prelude::*;

use super::numbers::{any_magnitude, lattice, moved_by_ulps, plain, scale};

/// The term w |a·x + b|.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term {
    /// The vector a.
    pub a: [f64; 2],
    /// The offset b.
    pub b: f64,
    /// The weight w, not negative.
    pub weight: f64,
}

/// The problem of minimising c·x + Σ w |a·x + b|.
#[derive(Clone, Debug, PartialEq)]
pub struct Instance {
    /// The terms.
    pub terms: Vec<Term>,
    /// The vector c.
    pub linear: [f64; 2],
}

/// A strategy for instances.
pub type Instances = BoxedStrategy<Instance>;

/// The number of terms that an instance may have.
pub type Sizes = RangeInclusive<usize>;

fn weight() -> BoxedStrategy<f64> {
    prop_oneof![4 => Just(1.0), 4 => 0.0..2.0f64, 1 => Just(0.0), 1 => Just(3.0)].boxed()
}

/// A linear term that is often absent and, when present, of the size that the weights can just balance or not.
fn linear(number: fn() -> BoxedStrategy<f64>) -> BoxedStrategy<[f64; 2]> {
    prop_oneof![Just([0.0, 0.0]), [number(), number()]].boxed()
}

fn instances(
    sizes: Sizes,
    a: impl Strategy<Value = [f64; 2]> + 'static,
    b: impl Strategy<Value = f64> + 'static,
    linear: BoxedStrategy<[f64; 2]>,
) -> Instances {
    let term = (a, b, weight()).prop_map(|(a, b, weight)| Term { a, b, weight });
    (vec(term, sizes), linear).prop_map(|(terms, linear)| Instance { terms, linear }).boxed()
}

/// No degeneracy but what chance brings.
pub fn generic(sizes: Sizes) -> Instances {
    instances(sizes, [plain(), plain()], plain(), linear(plain))
}

/// Small integers: few directions, many parallel, equal and concurrent lines, zero vectors.
pub fn lattice_lines(sizes: Sizes) -> Instances {
    instances(sizes, [lattice(), lattice()], lattice(), linear(lattice))
}

/// All lines through one lattice point.
pub fn concurrent(sizes: Sizes) -> Instances {
    (lattice_lines(sizes), [lattice(), lattice()])
        .prop_map(|(mut instance, [x, y])| {
            for term in &mut instance.terms {
                term.b = -(term.a[0] * x + term.a[1] * y);
            }
            instance
        })
        .boxed()
}

/// All lines parallel, exactly.
pub fn parallel(sizes: Sizes) -> Instances {
    (lattice_lines(sizes.clone()), [lattice(), lattice()], vec(lattice(), *sizes.end()), any::<bool>())
        .prop_map(|(mut instance, a, factors, along)| {
            for (term, factor) in instance.terms.iter_mut().zip(&factors) {
                term.a = [a[0] * factor, a[1] * factor];
            }
            if along {
                instance.linear = [a[0] * factors[0], a[1] * factors[0]];
            }
            instance
        })
        .boxed()
}

/// Vertical and horizontal lines only.
pub fn axis_parallel(sizes: Sizes) -> Instances {
    let a = (any::<bool>(), prop_oneof![Just(1.0), Just(-2.0), plain()])
        .prop_map(|(vertical, size)| if vertical { [size, 0.0] } else { [0.0, size] });
    instances(sizes, a, lattice(), linear(lattice))
}

/// Directions that differ by about 1e-12.
pub fn near_parallel(sizes: Sizes) -> Instances {
    let a = (-5..=5i32, any::<bool>()).prop_map(|(k, steep)| {
        let small = 1e-12 * f64::from(k);
        if steep { [1.0, 1.0 + small] } else { [1.0, small] }
    });
    instances(sizes, a, plain(), linear(|| (-9..=9i32).prop_map(|k| 1e-12 * f64::from(k)).boxed()))
}

/// Equal lines and lines equal up to sign, with different weights.
pub fn duplicates(sizes: Sizes) -> Instances {
    (generic(sizes), vec((any::<prop::sample::Index>(), weight(), any::<bool>()), 1..=5))
        .prop_map(|(mut instance, copies)| {
            for (index, weight, flipped) in copies {
                let term = *index.get(&instance.terms);
                let sign = if flipped { -1.0 } else { 1.0 };
                instance.terms.push(Term { a: term.a.map(|value| sign * value), b: sign * term.b, weight });
            }
            instance
        })
        .boxed()
}

/// Pairs a·x ± b: symmetric about the origin, with vertices that share an x.
pub fn symmetric(sizes: Sizes) -> Instances {
    let most = *sizes.end();
    instances(sizes, [lattice(), lattice()], lattice(), Just([0.0, 0.0]).boxed())
        .prop_map(move |mut instance| {
            let mirrored: Vec<Term> = instance.terms.iter().map(|term| Term { b: -term.b, ..*term }).collect();
            instance.terms.truncate(most.div_ceil(2));
            instance.terms.extend(&mirrored[..instance.terms.len()]);
            instance
        })
        .boxed()
}

/// The sides of a regular polygon.
pub fn regular_polygons(sizes: Sizes) -> Instances {
    (sizes.start().max(&3).to_owned()..=sizes.end().to_owned(), linear(plain), prop_oneof![Just(1.0), plain()])
        .prop_map(|(n, linear, b)| {
            let term = |k: usize| {
                let (sin, cos) = libm::sincos(TAU * k as f64 / n as f64);
                Term { a: [cos, sin], b, weight: 1.0 }
            };
            Instance { terms: (0..n).map(term).collect(), linear }
        })
        .boxed()
}

/// A linear term that the lines exactly balance towards infinity: c = Σ ± w a, in integers.
pub fn barely_bounded(sizes: Sizes) -> Instances {
    (lattice_lines(sizes.clone()), vec(any::<bool>(), *sizes.end()))
        .prop_map(|(mut instance, signs)| {
            instance.linear = [0.0, 0.0];
            for (term, positive) in instance.terms.iter_mut().zip(signs) {
                term.weight = libm::round(term.weight);
                let sign = if positive { term.weight } else { -term.weight };
                instance.linear[0] += sign * term.a[0];
                instance.linear[1] += sign * term.a[1];
            }
            instance
        })
        .boxed()
}

/// Other families with the vectors, offsets, weights and the linear term each multiplied by a power of two.
pub fn scaled(sizes: Sizes) -> Instances {
    (
        prop_oneof![generic(sizes.clone()), lattice_lines(sizes.clone()), concurrent(sizes)],
        -900..=900i32,
        -90..=90i32,
        -90..=90i32,
    )
        .prop_map(|(mut instance, base, of_a, of_weight)| {
            let scale = |value: f64, exponent: i32| libm::ldexp(value, exponent);
            for term in &mut instance.terms {
                term.a = term.a.map(|value| scale(value, base + of_a));
                term.b = scale(term.b, base);
                term.weight = scale(term.weight, of_weight);
            }
            instance.linear = instance.linear.map(|value| scale(value, base + of_a + of_weight));
            instance
        })
        .prop_filter("a factor overflows", |instance| instance.linear.iter().all(|value| value.is_finite()))
        .boxed()
}

/// Lattice lines, concurrent and symmetric ones, each number moved by at most one unit in the last place.
pub fn one_ulp(sizes: Sizes) -> Instances {
    let most = *sizes.end();
    let shapes = prop_oneof![
        lattice_lines(sizes.clone()),
        concurrent(sizes.clone()),
        symmetric(sizes.clone()),
        parallel(sizes.clone()),
        regular_polygons(sizes)
    ];
    (shapes, vec([-1..=1i32, -1..=1i32, -1..=1i32], most + 1))
        .prop_map(move |(mut instance, steps)| {
            for (term, step) in instance.terms.iter_mut().zip(&steps) {
                term.a = [0, 1].map(|axis| moved_by_ulps(term.a[axis], step[axis]));
                term.b = moved_by_ulps(term.b, step[2]);
            }
            let step = steps[most];
            instance.linear = [0, 1].map(|axis| moved_by_ulps(instance.linear[axis], step[axis]));
            instance
        })
        .boxed()
}

/// Numbers of unrelated magnitudes, from 1e-300 to 1e300.
pub fn mixed_scales(sizes: Sizes) -> Instances {
    let weights = prop_oneof![Just(1.0), scale()];
    let term =
        ([any_magnitude(), any_magnitude()], any_magnitude(), weights).prop_map(|(a, b, weight)| Term { a, b, weight });
    (vec(term, sizes), linear(any_magnitude)).prop_map(|(terms, linear)| Instance { terms, linear }).boxed()
}
