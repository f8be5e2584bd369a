//! A vertex of a reduced problem, proved to be the optimum, or so near to it that the gauge is known, by bounds on
//! every rounding error.
//!
//! Let u = ± v_a × v_b with u · p > 0, and g the sum of all other generators with the signs of v · u. Then g + δ_a
//! v_a + δ_b v_b = λ p with λ = g · u / p · u, δ_a = −g · (v_b × p) / p · (v_a × v_b), δ_b = −g · (p × v_a) / p ·
//! (v_a × v_b).
//!
//! - h(u) = g · u, or less than 2 Σ |v · u| more, summed over the generators v whose sign is not certain: the gauge
//!   is at least u · p / h(u).
//! - If δ_a and δ_b are within [−1, 1], λ p is in the body: the gauge is at most 1 / λ, and u is optimal. If they
//!   leave [−1, 1] by ε_a and ε_b, λ p less ε_a v_a + ε_b v_b is in the body, and the gauge is at most (1 + ε_a ‖v_a‖
//!   + ε_b ‖v_b‖) / λ, where ‖v‖ ≤ 1 is the gauge of v.
//! - For any δ_a and δ_b in [−1, 1] and any μ, μ p differs by a vector r from a point of the body, and the gauge is
//!   at most (1 + ‖r‖) / μ. Where v_a and v_b are nearly parallel, their coefficients are not known well, and r is
//!   small all the same.
//!
//! Hence where p is at an edge of a facet, or lines meet nearly in one point, it need not be known which of the
//! vertices is the optimum. Where many generators are parallel to the facet, or nearly so, the contribution of each is
//! chosen such that δ_a and δ_b have room (`shares`).
//!
//! The gauge is at least u · p / h(u), and at most 1 + `slack` times that, where the slack depends on how thick the
//! body is in its thinnest direction. The thickness costs a pass over the generators, so it is bounded from a part of
//! them first, and from all generators only where the part leaves a doubt on which side of the boundary p is.

use std::cmp::Ordering;

use super::near_generators::Near;
use super::residual::Rest;
use super::unit_gauge_bound::unit_gauge_bound;
use crate::lad::of_generators::cells::nested::NestedCells;
use crate::lad::of_generators::cells::reduced::Reduced;
use crate::lad::of_generators::goal::Goal;
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::sign_pass::Places;
use crate::numeric::bounded::{Bounded, BoundedVector, approximate, cross, exact};
use crate::numeric::exact_linear::{self, ExactVector};
use crate::numeric::linear::dot;
use crate::numeric::reused::{Reused, ReusedBox, keep_lists_of};
use crate::numeric::tolerance::{FIVE_ROUNDINGS, GAUGE_ACCURACY, UNIT};

/// A vertex that is the optimum or near it, with the quantities of its proof.
#[derive(Debug)]
pub(crate) struct RoundedOptimum {
    /// a and b, by their index in the query.
    pub(crate) basis: [usize; 2],
    pub(crate) vectors: [[f64; 3]; 2],
    /// Whether u is −(v_a × v_b).
    pub(crate) reversed: bool,
    pub(crate) direction: BoundedVector,
    /// g, without a and b.
    pub(crate) sum: BoundedVector,
    /// The other generators whose sign is not certain, by their index in the query in increasing order, each with its
    /// contribution to g, in [−1, 1].
    pub(crate) shares: Reused<(usize, f64)>,
    /// At least Σ |v|_1 over the generators of `shares`.
    pub(crate) shared: f64,
    /// g · u.
    pub(crate) reach: Bounded,
    /// p · u.
    pub(crate) along: Bounded,
    /// h(u) − g · u is at most this.
    pub(crate) missing: f64,
    /// By how much δ_a and δ_b may leave [−1, 1]; infinite where u is only near the vertex.
    pub(crate) excess: [f64; 2],
    /// The vector that is left of λ p when δ_a and δ_b are kept within [−1, 1].
    pub(crate) rest: Rest,
    /// At least Σ |v|.
    pub(crate) magnitude: f64,
    /// A bound of the error of each generator in doubles, in terms of its length.
    pub(crate) relative_error: f64,
}

/// A direction with a larger relative error than this is not taken for a vertex but for a point near one.
const BLURRED_VERTEX: f64 = 1e-12;

/// Mostly at most so many generators have no certain sign at a vertex, its own two among them.
const USUAL_NEAR: usize = 16;

/// The thickness of the body is bounded from one generator in 16 first, then from all.
const THICKNESS_SHARES: [usize; 2] = [16, 1];

/// Why a vertex is not proved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Unproved {
    /// The vertex is too near to other lines, or to a change of the basis, for doubles.
    Doubt,
    /// The vertex may be outside the cell of this problem; it is in the cells of all problems before it.
    Astray(usize),
    /// Many lines meet in the vertex, and the objective falls along this line of the level.
    Falls(usize),
}

/// A certified vertex, or why it is not proved.
pub(crate) type Certified = Result<ReusedBox<RoundedOptimum>, Unproved>;

keep_lists_of!(RoundedOptimum);

impl RoundedOptimum {
    /// Checks a vertex that is given by the positions of two generators in the last of some problems, each of which
    /// was reduced from the one before.
    pub(crate) fn at(levels: &[Reduced], p: &BoundedVector, [first, second]: [usize; 2]) -> Certified {
        let level = levels.last().ok_or(Unproved::Doubt)?;
        let vectors = [level.vectors[first], level.vectors[second]];
        let error = level.relative_error;
        let [a, b] = vectors.map(|v| approximate(v, error));
        let product = cross(&a, &b);
        let along = dot(&product, p);
        let reversed = along.sign().ok_or(Unproved::Doubt)? < 0;
        let own = if reversed { along.negated() } else { along };
        let vertex = if reversed { product.map(Bounded::negated) } else { product };
        let largest = |of: fn(&Bounded) -> f64| vertex.iter().map(of).fold(0.0f64, f64::max);
        // of the vertex of two lines that are nearly parallel less is known than of a point near it
        let is_rounded = largest(|c| c.error) > BLURRED_VERTEX * largest(|c| c.value.abs());
        let direction = if is_rounded { exact(between(&vectors, vertex.map(|c| c.value))) } else { vertex };
        let is_missed = |level: &Reduced| level.cell.is_some_and(|cell| !cell.contains(&direction, p));
        if let Some(place) = levels.iter().position(is_missed) {
            return Err(Unproved::Astray(place));
        }
        let along = if is_rounded { dot(&direction, p) } else { own };
        let least = (own.value - own.error) * (1.0 - 4.0 * UNIT);
        let cell = DirectionCone::around(&direction);
        let mut near = Places::with_capacity(USUAL_NEAR);
        let fixed = level.plus_fixed_in(&cell, &mut near);
        near.retain(|&place| place as usize != first && place as usize != second);
        let duals = [cross(&b, p), cross(p, &a)];
        let Near { sum, shares, shared, missing } =
            Near::new(level, [first, second], &near, &direction, &duals, &fixed).map_err(Unproved::Falls)?;
        let across = duals.map(|dual| dot(&sum, &dual));
        let sizes = across.map(|value| value.magnitude() / least * (1.0 + 4.0 * UNIT));
        let excess = if is_rounded { [f64::INFINITY; 2] } else { sizes.map(|size| (size - 1.0).max(0.0)) };
        let off = |v: &BoundedVector| dot(v, &direction).magnitude();
        let missing = if is_rounded { (missing + off(&a) + off(&b)) * FIVE_ROUNDINGS } else { missing };
        let reach = dot(&sum, &direction);
        // NaN is doubt as well
        let is_useful = least > 0.0
            && along.is_positive()
            && reach.is_positive()
            && (is_rounded || sizes.iter().all(|size| *size < 2.0))
            && missing < reach.value - reach.error;
        if !is_useful {
            return Err(Unproved::Doubt);
        }
        let basis = [first, second].map(|i| level.indices[i] as usize);
        let magnitude = fixed.magnitude;
        let divisor = if reversed { along.value } else { -along.value };
        let coefficients = across.map(|value| value.value / divisor);
        let rest = if missing == 0.0 && excess == [0.0; 2] {
            Rest::of_sure_optimum(coefficients)
        } else {
            Rest::new(&sum, &[a, b], coefficients, [reach, along], p)
        };
        Ok(ReusedBox::new(Self {
            basis,
            vectors,
            reversed,
            direction,
            sum,
            shares,
            shared,
            reach,
            along,
            missing,
            excess,
            rest,
            magnitude,
            relative_error: error,
        }))
    }

    /// Whether the vertex is the optimum for sure, not only nearly.
    pub(crate) fn is_vertex(&self) -> bool {
        self.missing == 0.0 && self.excess == [0.0; 2]
    }

    /// The two generators of the vertex in doubles, with a bound of each coordinate's error.
    pub(crate) fn bounded_vectors(&self) -> [BoundedVector; 2] {
        self.vectors.map(|v| approximate(v, self.relative_error))
    }

    /// u = ± v_a × v_b, exactly.
    pub(crate) fn exact_vertex(&self, query: &dyn KernelQuery) -> ExactVector {
        let [a, b] = self.basis.map(|index| query.exact_generator(index));
        if self.reversed { exact_linear::cross(&b, &a) } else { exact_linear::cross(&a, &b) }
    }

    /// Whether the direction is not the vertex itself but doubles near it, of two generators that are nearly parallel.
    pub(crate) fn is_near_vertex(&self) -> bool {
        self.excess[0] == f64::INFINITY
    }

    /// The cell of all directions within the rounding error of the vertex.
    pub(crate) fn cell(&self) -> DirectionCone {
        DirectionCone::around(&self.direction)
    }

    /// h(u).
    pub(crate) fn support(&self) -> Bounded {
        Bounded { value: self.reach.value, error: self.reach.error + self.missing }
    }

    /// A bound of the gauge times λ less 1, where |x|_1 times `size` bounds the gauge of a vector x.
    pub(crate) fn slack(&self, size: f64) -> f64 {
        let longer = 1.0 + 2.0 * self.relative_error;
        let gauge = |v: &[f64; 3]| (size * longer * v.iter().map(|c| c.abs()).sum::<f64>()).min(1.0);
        let terms = self.excess.iter().zip(&self.vectors).map(|(excess, v)| excess * gauge(v));
        let by_ends = terms.sum::<f64>() * FIVE_ROUNDINGS;
        let by_rest = (size * self.rest.size + (1.0 + size * self.rest.size) * self.rest.stretch) * FIVE_ROUNDINGS;
        // the minimum with a NaN is the other bound
        by_ends.min(by_rest)
    }
}

/// A direction nearly orthogonal to two vectors, made more nearly so by subtracting what it has along each.
fn between(vectors: &[[f64; 3]; 2], direction: [f64; 3]) -> [f64; 3] {
    vectors.iter().fold(direction, |u, v| {
        let part = dot(v, &u) / dot(v, v);
        [0, 1, 2].map(|k| u[k] - part * v[k])
    })
}

/// An optimum in doubles of which it is certain on which side of the boundary the displacement ends.
#[derive(Debug)]
pub(crate) struct DecidedOptimum {
    pub(crate) optimum: ReusedBox<RoundedOptimum>,
    /// The cells that fixed the signs of the generators.
    pub(crate) cells: NestedCells,
    /// The gauge times λ exceeds 1 by at most this.
    slack: f64,
    /// The order of the gauge and 1; never equal, which doubles cannot prove.
    pub(crate) order: Ordering,
}

impl DecidedOptimum {
    /// The decision, or the optimum and its cells back where doubles leave a doubt.
    pub(crate) fn new(
        query: &dyn KernelQuery,
        optimum: ReusedBox<RoundedOptimum>,
        cells: NestedCells,
        goal: Goal,
    ) -> Result<Self, (ReusedBox<RoundedOptimum>, NestedCells)> {
        match compare(query, &optimum, goal) {
            Some((order, slack)) => Ok(Self { optimum, cells, slack, order }),
            None => Err((optimum, cells)),
        }
    }

    /// The gauge with a bound for its error.
    pub(crate) fn gauge(&self) -> (f64, f64) {
        gauge(&self.optimum, self.slack)
    }
}

/// The order of the gauge and 1, with the slack that decides it; `None` where doubles leave a doubt, or where the goal
/// is the gauge and its error is above [`GAUGE_ACCURACY`].
pub(crate) fn compare(query: &dyn KernelQuery, optimum: &RoundedOptimum, goal: Goal) -> Option<(Ordering, f64)> {
    let mut slack = optimum.slack(f64::INFINITY);
    let mut order = order(optimum, slack, goal);
    for share in THICKNESS_SHARES {
        if order.is_none() && slack > 0.0 {
            slack = optimum.slack(unit_gauge_bound(query, share));
            order = self::order(optimum, slack, goal);
        }
    }
    order.map(|order| (order, slack))
}

fn order(optimum: &RoundedOptimum, slack: f64, goal: Goal) -> Option<Ordering> {
    let (value, error) = gauge(optimum, slack);
    let inside = optimum.along * (Bounded::exact(1.0) + Bounded::exact(slack));
    let order = if (optimum.along - optimum.support()).is_positive() {
        Ordering::Greater
    } else if (optimum.reach - inside).is_positive() {
        Ordering::Less
    } else {
        return None;
    };
    (goal == Goal::Location || error <= value * GAUGE_ACCURACY).then_some(order)
}

/// `along` / `reach` with a bound for its distance from the gauge.
fn gauge(optimum: &RoundedOptimum, slack: f64) -> (f64, f64) {
    let (value, error) = quotient(optimum.along, optimum.support());
    (value, error + (value + error) * slack * FIVE_ROUNDINGS)
}

/// a / b for a and b positive, with a bound for its error; infinite where b may be zero.
fn quotient(a: Bounded, b: Bounded) -> (f64, f64) {
    let value = a.value / b.value;
    let least = b.value - b.error;
    if least.is_nan() || least <= 0.0 {
        return (value, f64::INFINITY);
    }
    let error = (a.error + value * b.error) / least + value * f64::EPSILON;
    (value, error * (1.0 + 8.0 * f64::EPSILON) + f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests;
