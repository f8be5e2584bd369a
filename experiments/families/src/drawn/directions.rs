//! Proptest strategies for points, directions and weights of any dimension: every way of being degenerate that Section
//! 4.2 allows.

use proptest::array::uniform;
use proptest::collection::vec;
use proptest::prelude::*;

use super::numbers::{any_magnitude, lattice, moved_by_ulps, plain, power_of_two};

/// Points, directions and weights.
#[derive(Debug, Clone)]
pub struct Instance<const D: usize> {
    /// The points, at least one.
    pub points: Vec<[f64; D]>,
    /// The directions; they may be zero, parallel, repeated, and too few.
    pub directions: Vec<[f64; D]>,
    /// The weight of each direction, none of them negative.
    pub weights: Vec<f64>,
}

/// A strategy for instances.
pub type Instances<const D: usize> = BoxedStrategy<Instance<D>>;
type Vectors<const D: usize> = BoxedStrategy<Vec<[f64; D]>>;

/// By how many the directions outnumber the dimensions at most.
const SURPLUS_LIMIT: usize = 3;

fn vector<const D: usize>(number: BoxedStrategy<f64>) -> BoxedStrategy<[f64; D]> {
    uniform(number).boxed()
}

fn vectors<const D: usize>(number: fn() -> BoxedStrategy<f64>, count: std::ops::RangeInclusive<usize>) -> Vectors<D> {
    vec(vector(number()), count).boxed()
}

fn weighted<const D: usize>(points: Vectors<D>, directions: Vectors<D>) -> Instances<D> {
    let weights = vec(prop_oneof![3 => Just(1.0), 2 => 0.25..4.0f64], D + 2 * SURPLUS_LIMIT);
    (points, directions, weights)
        .prop_map(|(points, directions, mut weights)| {
            weights.truncate(directions.len());
            Instance { points, directions, weights }
        })
        .boxed()
}

/// No degeneracy: directions that span, points anywhere.
pub fn generic<const D: usize>() -> Instances<D> {
    weighted(vectors(plain, 1..=9), vectors(plain, D..=D + SURPLUS_LIMIT))
}

/// Small integers: equal points, zero, parallel and repeated directions, directions that do not span, none at all.
pub fn lattices<const D: usize>() -> Instances<D> {
    weighted(vectors(lattice, 1..=7), vectors(lattice, 0..=D + SURPLUS_LIMIT))
}

/// Multiples of one another, of either sign, and repetitions.
pub fn parallel<const D: usize>() -> Instances<D> {
    let factors =
        vec((any::<prop::sample::Index>(), prop::sample::select(vec![1.0, -1.0, 2.0, -3.0, 0.5, 0.0])), 0..=4);
    let directions = (vectors::<D>(lattice, D..=D + 1), factors).prop_map(|(bases, factors)| {
        let multiples = factors.iter().map(|(base, factor)| base.get(&bases).map(|c| c * factor)).collect();
        [bases, multiples].concat()
    });
    weighted(vectors(lattice, 1..=6), directions.boxed())
}

/// Sums of integer multiples of fewer vectors than there are dimensions.
fn combinations<const D: usize>(bases: &[[f64; D]], factors: &[Vec<i32>]) -> Vec<[f64; D]> {
    let sum = |factors: &Vec<i32>| {
        bases.iter().zip(factors).fold([0.0; D], |sum: [f64; D], (base, &factor)| {
            std::array::from_fn(|c| sum[c] + f64::from(factor) * base[c])
        })
    };
    factors.iter().map(sum).collect()
}

/// Directions of a subspace, points of one of its translates; in half of the cases one point is moved off it, by much
/// or by little.
pub fn flat<const D: usize>() -> Instances<D> {
    let factors = |count| vec(vec(-3..=3i32, D - 1), count);
    let off = prop_oneof![Just(0.0), Just(0.0), Just(1.0), Just(1e-300)];
    (vectors::<D>(lattice, D - 1..=D - 1), factors(0..=D + 1), factors(1..=6), vector::<D>(lattice()), off, 0..D)
        .prop_map(|(bases, directions, points, shift, off, axis)| {
            let mut points: Vec<[f64; D]> = combinations(&bases, &points);
            for point in &mut points {
                *point = std::array::from_fn(|c| point[c] + shift[c]);
            }
            points[0][axis] += off;
            let directions = combinations(&bases, &directions);
            Instance { points, weights: vec![1.0; directions.len()], directions }
        })
        .boxed()
}

/// Fewer directions than dimensions.
pub fn too_few<const D: usize>() -> Instances<D> {
    weighted(vectors(lattice, 1..=4), vectors(lattice, 0..=D - 1))
}

/// One point, any number of times.
pub fn one_point<const D: usize>() -> Instances<D> {
    let points = (vector::<D>(prop_oneof![plain(), lattice()].boxed()), 1..=4usize)
        .prop_map(|(point, times)| vec![point; times]);
    weighted(points.boxed(), vectors(plain, 0..=D + 1))
}

/// A few points, each many times.
pub fn duplicates<const D: usize>() -> Instances<D> {
    let points = (vectors::<D>(plain, 1..=4), vec(any::<prop::sample::Index>(), 1..=12))
        .prop_map(|(distinct, draws)| draws.iter().map(|draw| *draw.get(&distinct)).collect());
    weighted(points.boxed(), vectors(plain, D..=D + 2))
}

/// Points of one size and directions of another, between 1e-300 and 1e300, with coefficients that are normal doubles.
pub fn scaled<const D: usize>() -> Instances<D> {
    (generic::<D>(), -996..=996i32, -996..=996i32)
        .prop_map(|(instance, points, directions)| {
            let directions = directions.clamp(points - 900, points + 900);
            let by = |vectors: Vec<[f64; D]>, exponent| -> Vec<[f64; D]> {
                vectors.into_iter().map(|v| v.map(|c| c * power_of_two(exponent))).collect()
            };
            Instance {
                points: by(instance.points, points),
                directions: by(instance.directions, directions),
                weights: instance.weights,
            }
        })
        .boxed()
}

/// Some of the weights zero.
pub fn zero_weights<const D: usize>() -> Instances<D> {
    (lattices::<D>(), vec(prop::sample::select(vec![0.0, 1.0, 2.0]), D + SURPLUS_LIMIT))
        .prop_map(|(instance, mut weights)| {
            weights.truncate(instance.directions.len());
            Instance { weights, ..instance }
        })
        .boxed()
}

/// Small integers, each coordinate moved by at most one unit in the last place: nearly parallel, nearly flat.
pub fn one_ulp<const D: usize>() -> Instances<D> {
    let steps = || vec(uniform::<_, D>(-1..=1i32), 12);
    let moved = |vectors: Vec<[f64; D]>, steps: Vec<[i32; D]>| -> Vec<[f64; D]> {
        vectors.iter().zip(steps).map(|(v, s)| std::array::from_fn(|c| moved_by_ulps(v[c], s[c]))).collect()
    };
    (lattices::<D>(), steps(), steps())
        .prop_map(move |(instance, points, directions)| Instance {
            points: moved(instance.points, points),
            directions: moved(instance.directions, directions),
            weights: instance.weights,
        })
        .boxed()
}

/// Coordinates of unrelated magnitudes.
pub fn mixed_scales<const D: usize>() -> Instances<D> {
    weighted(vectors(any_magnitude, 1..=4), vectors(any_magnitude, 0..=D + 1))
}
