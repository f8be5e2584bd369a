//! Proptest strategies for point sets of the plane: every way of being degenerate that the algorithms promise to
//! handle.

use std::f64::consts::TAU;

use proptest::collection::vec;
use proptest::prelude::*;

use super::numbers::{any_magnitude, lattice, moved_by_ulps, plain, power_of_two, scale};

/// A point of the plane.
pub type Point = [f64; 2];
/// A strategy for point sets.
pub type Points = BoxedStrategy<Vec<Point>>;

fn pair(number: fn() -> BoxedStrategy<f64>) -> impl Strategy<Value = Point> {
    [number(), number()]
}

/// No degeneracy but what chance brings.
pub fn generic() -> Points {
    vec(pair(plain), 1..=14).boxed()
}

/// Small integer coordinates: many equal, collinear and cocircular points, many parallel edges.
pub fn lattice_points() -> Points {
    vec(pair(lattice), 1..=16).boxed()
}

/// Points p + k d with small integers k: exactly on a line when p and d are integers, nearly so when not.
pub fn collinear() -> Points {
    let numbers = prop_oneof![(pair(lattice), pair(lattice)), (pair(plain), pair(plain))];
    (numbers, vec(-9..=9i32, 1..=10))
        .prop_map(|((p, d), steps)| {
            steps.into_iter().map(f64::from).map(|k| [p[0] + k * d[0], p[1] + k * d[1]]).collect()
        })
        .boxed()
}

/// A few points, each many times.
pub fn duplicates() -> Points {
    (vec(prop_oneof![pair(plain), pair(lattice)], 1..=5), vec(any::<prop::sample::Index>(), 1..=14))
        .prop_map(|(distinct, draws)| draws.into_iter().map(|draw| *draw.get(&distinct)).collect())
        .boxed()
}

/// Pairs c ± d, exactly symmetric about c.
pub fn symmetric() -> Points {
    let eighths = || (-40..=40i32).prop_map(|eighths| f64::from(eighths) / 8.0).boxed();
    (pair(eighths), vec(pair(eighths), 1..=7))
        .prop_map(|(c, halves)| {
            halves.into_iter().flat_map(|[x, y]| [[c[0] + x, c[1] + y], [c[0] - x, c[1] - y]]).collect()
        })
        .boxed()
}

/// Regular polygons of up to 16 vertices, as well as doubles can say, anywhere and of any size.
pub fn regular_polygons() -> Points {
    (3..=16u32, pair(plain), -30..=30i32, 0.0..TAU)
        .prop_map(|(n, [x, y], exponent, turn)| {
            let radius = power_of_two(exponent);
            let vertex = |k: u32| {
                let (sin, cos) = libm::sincos(turn + TAU * f64::from(k) / f64::from(n));
                [x + radius * cos, y + radius * sin]
            };
            (0..n).map(vertex).collect()
        })
        .boxed()
}

/// Edges whose directions differ by about 1e-12: a parabola pressed flat, along any direction.
pub fn near_parallel() -> Points {
    (vec(-50..=50i32, 2..=12), pair(plain), 1..=9i32)
        .prop_map(|(places, [dx, dy], flatness)| {
            let bend = 1e-12 * f64::from(flatness) / 100.0;
            places
                .into_iter()
                .map(f64::from)
                .map(|k| {
                    let height = bend * k * k;
                    [k * dx - height * dy, k * dy + height * dx]
                })
                .collect()
        })
        .boxed()
}

/// Any of the families above, multiplied by one power of two between 1e-300 and 1e300.
pub fn scaled() -> Points {
    let shapes = prop_oneof![generic(), lattice_points(), symmetric(), near_parallel()];
    (shapes, scale())
        .prop_map(|(points, scale)| points.into_iter().map(|point| point.map(|value| value * scale)).collect())
        .boxed()
}

/// Lattice points, symmetric points and points of a line, each coordinate moved by at most one unit in the last place.
pub fn one_ulp() -> Points {
    let shapes = prop_oneof![lattice_points(), symmetric(), collinear(), regular_polygons()];
    (shapes, vec([-1..=1i32, -1..=1i32], 20))
        .prop_map(|(points, steps)| {
            let moved = |(point, step): (Point, [i32; 2])| [0, 1].map(|axis| moved_by_ulps(point[axis], step[axis]));
            points.into_iter().zip(steps).map(moved).collect()
        })
        .boxed()
}

/// Coordinates of unrelated magnitudes, from 1e-300 to 1e300.
pub fn mixed_scales() -> Points {
    vec(pair(any_magnitude), 1..=9).boxed()
}

/// Coordinates whose magnitudes differ by up to 70 bits: their sums and differences lose digits that still matter.
pub fn staggered() -> Points {
    let number =
        || prop_oneof![plain(), (plain(), -70..=0i32).prop_map(|(part, exponent)| part * power_of_two(exponent))];
    vec([number(), number()], 1..=12).boxed()
}

/// Multiples of the smallest double, and numbers next to the largest.
pub fn ends_of_the_range() -> Points {
    let tiny = || (-6..=6i64).prop_map(|k| k as f64 * f64::from_bits(1)).boxed();
    let huge = || {
        (prop_oneof![Just(1.0), Just(-1.0), Just(0.5), Just(0.0)], 0..=2i32)
            .prop_map(|(part, step)| part * moved_by_ulps(f64::MAX, -step))
    };
    prop_oneof![
        vec(pair(tiny), 1..=9),
        vec([huge(), huge()], 1..=7),
        (vec(pair(tiny), 1..=4), vec([huge(), huge()], 1..=4)).prop_map(|(small, large)| [small, large].concat()),
    ]
    .boxed()
}
