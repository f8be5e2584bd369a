//! A body whose extreme vertices are told in doubles, in pairs of doubles or exactly.

use super::number::Number;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::bounded::{self, Bounded};
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, is_zero, negated};
use crate::numeric::lanes::rows::Rows;
use crate::numeric::lanes::{Extents, bounded_sum, extreme_sum};
use crate::numeric::linear::dot;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::{LONG_SUM, UNDERFLOW};

/// What a body says along a direction.
pub(super) struct Look<N> {
    /// A vertex of the body that is extreme in the direction, but for rounding of the choice: a point of the body in
    /// any case.
    pub(super) vertex: [N; 3],
    /// At least the distance of p from the plane of support in the direction.
    pub(super) distance: f64,
    /// The direction in doubles.
    pub(super) direction: [f64; 3],
}

/// A body around the origin and a point p in it, in numbers of one precision.
pub(super) trait Precision {
    type Number: Number;

    /// The point p.
    fn end(&self) -> [Self::Number; 3];

    /// The extreme vertex along a direction that is not zero, and the distance of the plane there. One pass.
    fn look(&self, direction: &[Self::Number; 3]) -> Look<Self::Number>;
}

/// A body in doubles.
pub(super) struct InDoubles {
    generators: Vec<[f64; 3]>,
    end: [Bounded; 3],
    /// At least the error of each coordinate of an extreme sum.
    point_error: [f64; 3],
    /// At least Σ |g − rounded g|_1.
    rounded_off: f64,
}

impl InDoubles {
    /// The body of a query times a power of two that gives it an ordinary size, and the exponent of the power by which
    /// bounds of that body become bounds of the query's.
    pub(super) fn new(query: &dyn KernelQuery) -> (Self, i64) {
        let magnitude = query.generators().flatten().fold(0.0f64, |largest, c| largest.max(c.abs()));
        let exponent = binary_exponent(magnitude).map_or(0, i64::from);
        let scaled = |v: [f64; 3]| v.map(|c| scale_by_power_of_two(c, -exponent));
        let generators: Vec<[f64; 3]> = query.generators().map(|v| turned(scaled(v))).collect();
        let extents = Extents::new(&generators);
        let total: f64 = extents.sums().iter().sum();
        // a product with a power of two is exact unless it is subnormal
        let rounded_off = (query.relative_error() * total + generators.len() as f64 * UNDERFLOW) * LONG_SUM;
        let point_error = extents.point_error().map(|error| (error + rounded_off) * LONG_SUM);
        let end = bounded::leading(&query.exact().map(|c| c.scaled(-exponent)));
        (Self { generators, end, point_error, rounded_off }, exponent)
    }
}

/// The generators of a query that are not zero and its point, exactly, times the power of two with the opposite
/// exponent.
pub(super) fn exact_body(query: &dyn KernelQuery, exponent: i64) -> (Vec<ExactVector>, ExactVector) {
    let scaled = |v: ExactVector| v.map(|c| c.scaled(-exponent));
    let upward = |v: ExactVector| {
        let first = v.iter().find(|c| !c.is_zero());
        if first.is_some_and(|c| c.sign().is_lt()) { negated(v) } else { v }
    };
    let generators = (0..query.len()).map(|index| query.exact_generator(index)).filter(|v| !is_zero(v));
    (generators.map(|v| upward(scaled(v))).collect(), scaled(query.exact()))
}

/// A generator or its opposite, whichever has a positive coordinate before all others that are not 0.
///
/// A generator that is orthogonal to a direction is added as it stands; so parallel ones are added alike, and the sum
/// is a vertex of their facet.
fn turned(v: [f64; 3]) -> [f64; 3] {
    if v.iter().find(|c| **c != 0.0).is_some_and(|c| *c < 0.0) { v.map(|c| -c) } else { v }
}

impl Precision for InDoubles {
    type Number = Bounded;

    fn end(&self) -> [Bounded; 3] {
        self.end
    }

    fn look(&self, direction: &[Bounded; 3]) -> Look<Bounded> {
        let u = Bounded::direction(direction);
        let sum = extreme_sum(&self.generators, &u);
        let vertex = std::array::from_fn(|k| Bounded { value: sum[k], error: self.point_error[k] });
        let reach = bounded_sum(Rows::new(&self.generators), &u);
        let largest = u.iter().fold(0.0f64, |largest, c| largest.max(c.abs()));
        let reach = Bounded { error: (reach.error + self.rounded_off * largest) * LONG_SUM, ..reach };
        let exact = bounded::exact(u);
        let [_, distance] = Bounded::over_length(&(reach - dot(&exact, &self.end)), &exact);
        Look { vertex, distance, direction: u }
    }
}

/// A body as a list of generators in numbers of one kind.
pub(super) struct Listed<N> {
    generators: Vec<[N; 3]>,
    end: [N; 3],
}

impl Listed<BoundedDoubleDouble> {
    /// The body in pairs of doubles.
    pub(super) fn in_pairs(generators: &[ExactVector], end: &ExactVector) -> Self {
        let pair = |v: &ExactVector| v.each_ref().map(BoundedDoubleDouble::of);
        Self { generators: generators.iter().map(pair).collect(), end: pair(end) }
    }
}

impl Listed<Dyadic> {
    /// The body in exact numbers.
    pub(super) fn exactly(generators: Vec<ExactVector>, end: ExactVector) -> Self {
        Self { generators, end }
    }
}

impl<N: Number> Precision for Listed<N> {
    type Number = N;

    fn end(&self) -> [N; 3] {
        self.end.clone()
    }

    fn look(&self, direction: &[N; 3]) -> Look<N> {
        let mut vertex = [N::ZERO; 3];
        let mut reach = N::ZERO.minus(&dot(direction, &self.end));
        for generator in &self.generators {
            let along = dot(direction, generator);
            reach = reach.plus(&along.magnitude());
            vertex = std::array::from_fn(|k| {
                if along.is_certainly_negative() {
                    vertex[k].minus(&generator[k])
                } else {
                    vertex[k].plus(&generator[k])
                }
            });
        }
        let [_, distance] = N::over_length(&reach, direction);
        Look { vertex, distance, direction: N::direction(direction) }
    }
}
