//! The interval in which a rounded optimum puts the gauge, and so on which side of the boundary the displacement ends.
//!
//! With λ = h(u) / u · p at an optimal u, the gauge is 1 / λ. At a u that is only nearly optimal the gauge is at
//! least u · p / h(u), and at most 1 + `slack` times that, where the slack depends on how thick the body is in its
//! thinnest direction. The thickness costs a pass over the generators, so it is bounded from a part of them first,
//! and from all generators only where the part leaves a doubt.

use std::cmp::Ordering;

use super::rounded_optimum::RoundedOptimum;
use super::unit_gauge_bound::unit_gauge_bound;
use crate::lad::of_generators::cells::nested::NestedCells;
use crate::lad::of_generators::goal::Goal;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::numeric::bounded::Bounded;
use crate::numeric::reused::ReusedBox;
use crate::numeric::tolerance::{FIVE_ROUNDINGS, GAUGE_ACCURACY};

/// The thickness of the body is bounded from one generator in 16 first, then from all.
const THICKNESS_SHARES: [usize; 2] = [16, 1];

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
