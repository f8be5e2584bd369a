//! Membership, intersection and gauge, by the kernel: minimise the support function over the plane of directions u
//! with u · p = 1.
//!
//! # Statement
//! Input: a [`Query`] p and generators of R^D, D ≤ 4. Output: its [`Location`] relative to Z = { Σ δ_i v_i : |δ_i| ≤
//! 1 } with a proof, and the [`Gauge`] min { t ≥ 0 : p ∈ t Z }. Z is closed: touching is [`Location::Boundary`], and
//! so is every member of a flat Z. Zero, parallel and coplanar generators and none at all are ordinary input; p = 0
//! has the gauge 0.
//!
//! # Source
//! Beyond the paper, whose Theorem 5.2 needs O(n log² n) and general position: the gauge is 1 / min { h(u) : u · p =
//! 1 } with h(u) = Σ |v_i · u|, a least-absolute-deviations problem in the plane of those u. The paper's separate
//! test for a point beside the projection Q is not needed: no data are rotated, the plane may be any.
//!
//! # Method
//! 1. A body of R^1 or R^2 becomes a prism in space (`lad::of_generators::span`); one of R^4 goes to
//!    [`by_lad_in_r4`]. A question of extreme size is multiplied by a power of two (`scaled`).
//! 2. Where all that is asked is the location, `ladder` says what is tried before the optimum: a point far inside or
//!    far outside is proved first (`early`).
//! 3. Of a few hundred generators, a vertex that doubles find proves the location by itself, nearly always
//!    (`proof::at_vertex`).
//! 4. Otherwise the kernel (`lad::of_generators`) finds the optimum; its `ladder` says which methods it tries, and in
//!    which order.
//! 5. Let 1 / λ be the gauge. Where λ < 1, the optimal direction u separates; it is rounded to doubles, which is
//!    proved to be enough (`proof::separation`).
//! 6. Where λ ≥ 1, the coefficients δ_i / λ are rounded such that three generators balance the rest exactly
//!    (`proof::of_optimum`: `in_doubles`, and `exactly` and `pivot` where doubles leave a doubt).
//!
//! # Complexity
//! n generators: O(n) expected, with one pass over the generators and one for the proof of a member; space O(n).
//!
//! # Shapes
//! `query`: n × D generators in two runs, any order, duplicates allowed.
//!
//! # Numerics
//! Every decision is exact: status, validity of the proof. The gauge is within `error`, at most 2^-36 of it, that of
//! [`nearest_gauge`] within four units in the last place; a gauge beyond the range of doubles is `f64::MAX` with
//! infinite error.
//!
//! # Checked by
//! The rational twin on every family, the degenerate ones included; an independent check of every proof.
//!
//! # Example
//! ```
//! use zonotope::collision::{Query, Status, by_lad};
//! // the cube [−1, 1]³ and the point (2, 0, 0)
//! let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let query = Query::new([0.0; 3], [2.0, 0.0, 0.0], &cube).unwrap();
//! assert_eq!(by_lad::locate(&query, &mut ()).status(), Status::Outside);
//! assert_eq!(by_lad::gauge(&query, &mut ()).value, 2.0);
//! ```

pub(super) mod early;
mod facet;
mod ladder;
mod likely_vertex;
mod scaled;

pub use facet::Facet;

#[cfg(test)]
pub(in crate::collision) mod tests;

use self::scaled::Scaled;
use super::{Gauge, Location, Query, by_lad_in_r4};
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::span::prism::Prism;
use crate::tally::Tally;
use crate::zonotope::location::Coefficients;
use crate::zonotope::pose::Standing;

/// Whether the kernel answers in a dimension.
const fn is_answered(dimension: usize) -> bool {
    1 <= dimension && dimension <= 4
}

/// The location of a displacement relative to the zonotope of its generators, with a proof whose coefficients are those
/// of the generators as they are stored.
///
/// Under poses the proof holds for the poses as the exact numbers that they are: Σ δ_i M g_i = p, or u · p > Σ |u · M
/// g_i|.
pub fn locate<const D: usize, P: Standing>(query: &Query<'_, D, P>, tally: &mut dyn Tally) -> Location<D> {
    decide(query, tally).written_for(query)
}

/// [`locate`] with the proof of a member as it was found, for callers who read the status alone, or have the
/// coefficients written later.
#[inline]
pub(crate) fn decide<const D: usize, P: Standing>(
    query: &Query<'_, D, P>,
    tally: &mut dyn Tally,
) -> Location<D, Coefficients> {
    const { assert!(is_answered(D), "the kernel answers up to four dimensions") }
    located(query, tally).expect("the kernel answers up to four dimensions")
}

/// The gauge of a displacement and where it lies.
pub fn gauge<const D: usize, P: Standing>(query: &Query<'_, D, P>, tally: &mut dyn Tally) -> Gauge<D> {
    const { assert!(is_answered(D), "the kernel answers up to four dimensions") }
    let gauge = measured(query, tally).expect("the kernel answers up to four dimensions");
    gauge.map(|location| location.written_for(query))
}

/// The gauge as answers of bodies have it: within four units in the last place, its proof with the doubles nearest to
/// the coefficients of the basis ([`Witness::with_nearest_basis`](super::Witness::with_nearest_basis)).
///
/// [`gauge`] is enough for decisions and takes less: here are up to two passes more, which are slower ones.
pub fn nearest_gauge<const D: usize, P: Standing>(query: &Query<'_, D, P>, tally: &mut dyn Tally) -> Gauge<D> {
    const { assert!(is_answered(D), "the kernel answers up to four dimensions") }
    let gauge = nearly_measured(query, tally).expect("the kernel answers up to four dimensions");
    gauge.map(|location| location.written_for(query).with_nearest_basis(query))
}

/// [`decide`] for callers of any dimension; `None` where the kernel does not answer.
#[inline(never)]
pub(crate) fn located<const D: usize, P: Standing>(
    query: &Query<'_, D, P>,
    tally: &mut dyn Tally,
) -> Option<Location<D, Coefficients>> {
    let own = query.len();
    if !is_answered(D) {
        return None;
    }
    if let Some(query) = query.at_rest() {
        if let Some(query) = query.in_dimension::<4>() {
            return Some(by_lad_in_r4::locate(&query, &mut &mut *tally).lowered(own).map(Coefficients::from));
        }
        if let Some(scaled) = Scaled::of(&query) {
            // products with the rows themselves may leave the range of doubles
            let query = scaled.query();
            return Some(located(&query, tally)?.written_for(&query).map(Coefficients::from));
        }
        if D < 3 {
            let prism = Prism::over(&query);
            let query = prism.query();
            let location = ladder::from_optimum(&query, None, tally).counted(tally).written(&query);
            return Some(location.lowered(own).map(Coefficients::from));
        }
    }
    Some(Location::of_space(ladder::locate(&query.in_dimension::<3>()?, tally)))
}

/// [`gauge`] for callers of any dimension, the proof as it was found; `None` where the kernel does not answer.
pub(crate) fn measured<const D: usize, P: Standing>(
    query: &Query<'_, D, P>,
    tally: &mut dyn Tally,
) -> Option<Gauge<D, Location<D, Coefficients>>> {
    read_off(query, |query, tally| Facet::find(query, tally).measured(tally), tally)
}

/// [`nearest_gauge`] for callers of any dimension, the proof as it was found; `None` where the kernel does not answer.
#[inline(never)]
pub(crate) fn nearly_measured<const D: usize, P: Standing>(
    query: &Query<'_, D, P>,
    tally: &mut dyn Tally,
) -> Option<Gauge<D, Location<D, Coefficients>>> {
    read_off(query, ladder::nearest_gauge, tally)
}

/// A gauge of space, as a function reads it off the facet in which the ray along the displacement leaves the body.
type GaugeOfSpace = fn(&dyn KernelQuery, &mut dyn Tally) -> Gauge<3, Location<3, Coefficients>>;

/// The gauge of a displacement by a function for those of space; one of R^4 as [`by_lad_in_r4`] has it.
fn read_off<const D: usize, P: Standing>(
    query: &Query<'_, D, P>,
    of: GaugeOfSpace,
    tally: &mut dyn Tally,
) -> Option<Gauge<D, Location<D, Coefficients>>> {
    let own = query.len();
    if !is_answered(D) {
        return None;
    }
    let as_found = |location: Location<D>| location.map(Coefficients::from);
    if let Some(query) = query.at_rest() {
        if let Some(query) = query.in_dimension::<4>() {
            return Some(by_lad_in_r4::gauge(&query, &mut &mut *tally).lowered(own).map(as_found));
        }
        if let Some(scaled) = Scaled::of(&query) {
            // products with the rows themselves may leave the range of doubles
            let query = scaled.query();
            return Some(read_off(&query, of, tally)?.map(|location| as_found(location.written_for(&query))));
        }
        if D < 3 {
            let prism = Prism::over(&query);
            let query = prism.query();
            let gauge = of(&query, tally);
            return Some(gauge.map(|location| as_found(location.written(&query).lowered(own))));
        }
    }
    Some(of(&query.in_dimension::<3>()?, tally).map(Location::of_space))
}

/// The facet in which the ray along a displacement leaves the zonotope: the gauge and the status without the O(n)
/// proof.
pub fn facet<'q, P: Standing>(query: &'q Query<'q, 3, P>, tally: &mut dyn Tally) -> Facet<'q> {
    Facet::find(query, tally)
}
