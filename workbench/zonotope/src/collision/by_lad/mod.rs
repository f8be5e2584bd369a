//! Membership, intersection and gauge, by the kernel: minimise the support function over the plane of directions u with u · p = 1.
//!
//! # Statement
//! Input: a [`Displacement`] p and generators of R^D, D ≤ 3. Output: its [`Location`] relative to Z = { Σ δ_i v_i : |δ_i| ≤ 1 } with a
//! proof, and the [`Gauge`] min { t ≥ 0 : p ∈ t Z }. Z is closed: touching is [`Location::Boundary`], and so is every
//! member of a flat Z. Zero, parallel and coplanar generators and none at all are ordinary input; p = 0 has the gauge 0.
//!
//! # Source
//! Beyond the paper, whose Theorem 5.2 needs O(n log² n) and general position: the gauge is 1 / min { h(u) : u · p = 1 } with
//! h(u) = Σ |v_i · u|, a least-absolute-deviations problem in the plane of those u. The paper's separate test for a point
//! beside the projection Q is not needed: no data are rotated, the plane may be any.
//!
//! # Method
//! 1. A body of R^1 or R^2 becomes a prism in space (`lift`).
//! 2. The generators as lines in exact coordinates of the plane (`plane`); the kernel finds the optimal u with coefficients
//!    δ_i in [−1, 1], Σ δ_i v_i = λ p, where 1 / λ is the gauge (`exit`).
//! 3. λ < 1: the direction u separates; it is rounded to doubles and checked exactly (`separation`).
//! 4. λ ≥ 1: the coefficients δ_i / λ are rounded such that three generators make up for it exactly (`witness`, `walk`).
//!
//! # Complexity
//! n generators: O(n) expected, space O(n).
//!
//! # Shapes
//! `question`: n × D generators in two runs, any order, duplicates allowed.
//!
//! # Numerics
//! Every decision is exact: status, optimality of u, validity of the proof. The gauge is rounded within `error`; a gauge beyond the range of
//! doubles is `f64::MAX` with infinite error.
//!
//! # Errors
//! None: the question was validated when it was made.
//!
//! # Panics
//! Never. More than three dimensions do not compile.
//!
//! # Checked by
//! The rational twin on every family, the degenerate ones included; an independent check of every proof.
//!
//! # Example
//! ```
//! use zonotope::collision::{Displacement, by_lad};
//! // the cube [−1, 1]³ and the point (2, 0, 0)
//! let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let question = Displacement::new([0.0; 3], [2.0, 0.0, 0.0], &cube).unwrap();
//! assert_eq!(by_lad::locate(&question).status(), "outside");
//! assert_eq!(by_lad::gauge(&question).value, 2.0);
//! ```

pub(super) mod basis;
mod exit;
pub(super) mod lift;
mod plane;
pub(super) mod separation;
pub(super) mod sums;
mod walk;
pub(super) mod witness;

#[cfg(test)]
mod tests;

use self::basis::Basis;
use self::exit::Exit;
use self::lift::Prism;
use super::{Displacement, Gauge, Location, Witness};
use crate::numeric::vector::is_zero;
use crate::tally::Tally;

/// Where a displacement lies relative to the zonotope of its generators, with a proof.
pub fn locate<const D: usize>(question: &Displacement<'_, D>) -> Location<D> {
    locate_counted(question, &mut ())
}

/// [`locate`], counting its operations.
pub fn locate_counted<const D: usize>(question: &Displacement<'_, D>, tally: &mut impl Tally) -> Location<D> {
    const { assert!(D <= 3, "the kernel in the plane answers up to three dimensions") }
    let prism = Prism::over(question);
    prism.lower(locate_in_space(&prism.question(), tally))
}

/// The gauge of a displacement and where it lies.
pub fn gauge<const D: usize>(question: &Displacement<'_, D>) -> Gauge<D> {
    gauge_counted(question, &mut ())
}

/// [`gauge`], counting its operations.
pub fn gauge_counted<const D: usize>(question: &Displacement<'_, D>, tally: &mut impl Tally) -> Gauge<D> {
    const { assert!(D <= 3, "the kernel in the plane answers up to three dimensions") }
    let prism = Prism::over(question);
    let Gauge { value, error, location } = gauge_in_space(&prism.question(), tally);
    Gauge { value, error, location: prism.lower(location) }
}

fn locate_in_space(question: &Displacement<'_, 3>, tally: &mut impl Tally) -> Location<3> {
    let p = question.exact();
    if is_zero(&p) {
        return locate_center(question);
    }
    Exit::find(question, &p, tally).location(question, &p)
}

fn gauge_in_space(question: &Displacement<'_, 3>, tally: &mut impl Tally) -> Gauge<3> {
    let p = question.exact();
    if is_zero(&p) {
        return Gauge { value: 0.0, error: 0.0, location: locate_center(question) };
    }
    let exit = Exit::find(question, &p, tally);
    exit.gauge(exit.location(question, &p))
}

/// The centre is a member with all coefficients 0, inside just when the generators span space.
fn locate_center(question: &Displacement<'_, 3>) -> Location<3> {
    let witness = Witness { coefficients: vec![0.0; question.len()], basis: Vec::new() };
    if Basis::spanning(question, Basis::new(Vec::new())).0.rank() == 3 {
        Location::Inside(witness)
    } else {
        Location::Boundary(witness)
    }
}
