//! Membership and intersection, by the paper's search: binary search over the separators of the tiling of Q (Theorem
//! 5.2).
//!
//! # Statement
//! Input: a [`Query`] p and generators of R^D, D ≤ 3. Output: its [`Location`] relative to Z = { Σ δ_i v_i : |δ_i| ≤ 1
//! } with a proof. Z is closed: touching is [`Location::Boundary`], and so is every member of a flat Z. Zero, vertical,
//! level, parallel and coplanar generators and none at all are ordinary input.
//!
//! # Source
//! Section 5.1, Theorem 5.2. Departures:
//! - p − q is taken exactly; a rounded difference may turn "disjoint" into "touching".
//! - The paper draws one separator just right of the k-th vertex. Here each step compares p_0 with two: those just left
//!   and just right of the median vertex. Between them lie all tiles whose vertices share its abscissa, so ties and
//!   facets of coplanar generators are no special cases, and p_0 on a separator is found at once.
//! - A generator with y = 0 has a vertical line, which no L_k meets: it moves the whole chain when L_k passes it. If
//!   all projections are level, x and y are exchanged; if there are none, Z is a vertical segment.
//! - A vertical generator has no line; it only lifts the upper hull.
//! - "Is p_0 outside Q" is asked of the first and the last separator, the sides of Q.
//! - Below the upper and above the lower hull p may still lie on the boundary: on a vertical facet, where p_0 is on the
//!   boundary of Q.
//! - The answer comes with a proof, of which the paper does not speak.
//!
//! In the dual this is the search of Theorem 4.5 ([`lad::by_slope_selection`](crate::lad::by_slope_selection)) for the
//! least h(x, y, 1) − (x, y) · p_0: the edge at the height of p_0 is the minimum on a vertical line, the side of p_0
//! that of the descent. Both select and cut with the same code.
//!
//! # Method
//! 1. A body of R^1 or R^2 becomes a prism in space. The lines of the generators are sorted by slope.
//! 2. Compare p_0 with the sides of Q (`shadow`). Outside, the normal of a side separates.
//! 3. Select the median vertex of those left; sort the lines along the vertical line through it; compare p_0 with the
//!    chains just left and just right of it (`chain`); keep the half of the vertices on p_0's side, until p_0 is
//!    between the two chains (`footing`).
//! 4. The facet there has the normal (x, y, 1), (x, y) the point of the line where p_0's edge crosses it. If p is above
//!    it, that normal separates.
//! 5. The lower hull is the upper hull for −p.
//! 6. A member is a mean of the point above and the one below it, each a mean of four vertices of Z around it
//!    (`mixture`): the coefficients of the proof.
//!
//! # Complexity
//! n generators: expected O(n log² n), the paper's bound: at most 2 log₂ n steps for each hull, each O(n log n)
//! expected for the selection and the sort and O(n) for the comparison with the chains. Space O(n).
//!
//! # Shapes
//! `question`: n × D generators in two runs, any order, duplicates allowed.
//!
//! # Numerics
//! Every decision is exact: heights on a chain by sums of doubles with an error bound, then by exact sums; sides of an
//! edge and of a facet by exact dyadic numbers. A separating direction is rounded only if it still separates.
//!
//! # Checked by
//! [`brute_force`](super::brute_force), [`by_lad`](super::by_lad), and the crate `verifier` on every answer.
//!
//! # Example
//! ```
//! use zonotope::collision::{Query, Status, by_slope_selection};
//! // the octagonal prism of two squares and a unit of height; (3, 0, z) is outside, (2, 0, 1) on an edge
//! let prism = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let at = |point| Query::new([0.0; 3], point, &prism).unwrap();
//! assert_eq!(by_slope_selection::locate(&at([3.0, 0.0, 0.0]), 0, &mut ()).status(), Status::Outside);
//! assert_eq!(by_slope_selection::locate(&at([2.0, 1.0, 1.0]), 0, &mut ()).status(), Status::Boundary);
//! assert_eq!(by_slope_selection::locate(&at([1.0, 1.0, 0.5]), 0, &mut ()).status(), Status::Inside);
//! ```

mod chain;
mod footing;
mod mixture;
mod shadow;
mod trace;

#[cfg(test)]
mod tests;

use std::cmp::Ordering;

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

pub use footing::Side;
pub use trace::{FoundTile, Hull, SearchStep, Trace};

use self::chain::Target;
use self::footing::Footing;
use self::mixture::Mixture;
use self::shadow::Shadow;
use self::trace::{Course, Recorder};
use super::proof::separation::separation;
use super::{Location, Query, Separation, Witness};
use crate::arrangement::DualArrangement;
use crate::arrangement::dual::Upward;
use crate::lad::of_generators::seam::direction_signs::DirectionSigns;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::span::prism::Prism;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, exact, is_zero, negated};
use crate::numeric::exact_sum::ExactSum;
use crate::tally::Tally;

/// Where a displacement lies relative to the zonotope of its generators, with a proof; `seed` decides the time, never
/// the answer.
pub fn locate<const D: usize>(question: &Query<'_, D>, seed: u64, tally: &mut impl Tally) -> Location<D> {
    const { assert!(D <= 3, "the tiling of the plane answers up to three dimensions") }
    let prism = Prism::over(question);
    prism.lower(Search::new(&prism.query(), tally).locate(seed, tally, &mut ()))
}

/// [`locate`] in space, with every separator that is tried and the tiles that are found.
pub fn trace(question: &Query<'_, 3>, seed: u64) -> Trace {
    let search = Search::new(question, &mut ());
    let mut course = Course::default();
    let location = search.locate(seed, &mut (), &mut course);
    Trace { location, steps: course.steps, tiles: course.tiles, swapped: search.axes != UNCHANGED }
}

/// Where the upper hull is over the projection of p: how high, exactly, or a level direction u with u · p > h(u) where
/// it is not.
pub(super) fn height_of_upper_hull(
    question: &Query<'_, 3>,
    seed: u64,
    tally: &mut impl Tally,
) -> Result<Rational, [f64; 3]> {
    Search::new(question, tally).height(seed, tally)
}

const UNCHANGED: [usize; 3] = [0, 1, 2];
const SWAPPED: [usize; 3] = [1, 0, 2];

/// A question with the dual arrangement of its generators.
struct Search<'a> {
    question: &'a Query<'a, 3>,
    p: ExactVector,
    dual: DualArrangement<'a>,
    /// The coordinates of the question that serve as x, y and z.
    axes: [usize; 3],
}

impl<'a> Search<'a> {
    fn new(question: &'a Query<'a, 3>, tally: &mut impl Tally) -> Self {
        let mut axes = UNCHANGED;
        let mut dual = DualArrangement::of_runs(question.runs(), axes, tally);
        if dual.slanted.is_empty() && !dual.level.is_empty() {
            axes = SWAPPED;
            dual = DualArrangement::of_runs(question.runs(), axes, tally);
        }
        Self { question, p: question.exact(), dual, axes }
    }

    fn locate(&self, seed: u64, tally: &mut impl Tally, recorder: &mut impl Recorder) -> Location<3> {
        if self.dual.slanted.is_empty() {
            return self.locate_on_axis();
        }
        let target = self.target();
        let shadow = self.shadow();
        if let Shadow::Outside(u) = shadow {
            return Location::Outside(Separation::Rounded(u));
        }
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let mut footing = |hull, target: Target| {
            let mut record = |probe: &footing::Probe<'_>| recorder.probe(hull, probe, &self.dual);
            let footing = Footing::search(&target, &self.dual, &mut random, tally, &mut record);
            recorder.found(hull, &footing, &self.dual);
            footing
        };
        let upper = footing(Hull::Upper, target);
        match upper.depth.sign() {
            Ordering::Less => return Location::Outside(self.separation(&upper, false)),
            Ordering::Equal => return Location::Boundary(self.witness(&upper, None)),
            Ordering::Greater => {}
        }
        let lower = footing(Hull::Lower, target.opposite());
        if lower.depth.sign().is_lt() {
            return Location::Outside(self.separation(&lower, true));
        }
        let is_inside = lower.depth.sign().is_gt() && shadow == Shadow::Interior;
        let witness = self.witness(&upper, Some(&lower));
        if is_inside { Location::Inside(witness) } else { Location::Boundary(witness) }
    }

    fn target(&self) -> Target {
        let (start, end) = (self.question.from(), self.question.to());
        Target { start: self.axes.map(|axis| start[axis]), end: self.axes.map(|axis| end[axis]) }
    }

    /// Where p_0 lies relative to Q, when some generator has a line.
    fn shadow(&self) -> Shadow {
        match Shadow::of(&self.target(), &self.dual) {
            Shadow::Outside(u) => Shadow::Outside(self.axes.map(|axis| u[axis])),
            inner => inner,
        }
    }

    fn height(&self, seed: u64, tally: &mut impl Tally) -> Result<Rational, [f64; 3]> {
        if self.dual.slanted.is_empty() {
            return match (0..2).find(|&axis| !self.p[axis].is_zero()) {
                Some(side) => Err(self.toward(side)),
                None => Ok(self.half_length_on_axis().to_rational()),
            };
        }
        if let Shadow::Outside(u) = self.shadow() {
            return Err(u);
        }
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let footing = Footing::search(&self.target(), &self.dual, &mut random, tally, &mut |_| ());
        Ok(self.p[2].to_rational() + footing.depth.to_rational() / footing.normal[2].to_rational())
    }

    fn half_length_on_axis(&self) -> Dyadic {
        let mut length = ExactSum::default();
        self.dual.poles.iter().for_each(|pole| length.add(pole.vector[2]));
        length.value()
    }

    /// The answer when no generator has a line: Z is a vertical segment, or the origin.
    fn locate_on_axis(&self) -> Location<3> {
        let Some(side) = (0..2).find(|&axis| !self.p[axis].is_zero()) else {
            let (length, z) = (self.half_length_on_axis(), &self.p[2]);
            if z.clone().abs() > length {
                return Location::Outside(Separation::Rounded(self.toward(2)));
            }
            let mut mixture = Mixture::new(self.question.len());
            mixture.add(&length + z, self.dual.poles.iter().map(|pole| (pole, 1)), false);
            mixture.add(&length - z, self.dual.poles.iter().map(|pole| (pole, 1)), true);
            return Location::Boundary(mixture.witness(self.question, &self.p));
        };
        Location::Outside(Separation::Rounded(self.toward(side)))
    }

    /// The direction of an axis, on p's side.
    fn toward(&self, axis: usize) -> [f64; 3] {
        let mut u = [0.0; 3];
        u[axis] = if self.p[axis].sign().is_lt() { -1.0 } else { 1.0 };
        u
    }

    /// The proof by the normal of a facet that p is beyond.
    fn separation(&self, footing: &Footing, opposite: bool) -> Separation<3> {
        let normal = self.axes.map(|axis| footing.normal[axis].clone());
        let normal = if opposite { negated(normal) } else { normal };
        let (_, facet) = footing.facet(&self.dual);
        let independent = |upward: &&&Upward| !is_zero(&cross(&exact(upward.vector), &exact(facet[0].vector)));
        let span: Vec<usize> =
            facet.iter().take(1).chain(facet.iter().find(independent)).map(|v| v.generator as usize).collect();
        let question: &dyn KernelQuery = self.question;
        let signs = DirectionSigns::new(question, &normal).all(&normal);
        separation(question, &self.p, &normal, &span, &question.signed_sum(&signs))
    }

    /// The proof from the facet above p, which it is in, or is above the facet below it.
    fn witness(&self, upper: &Footing, lower: Option<&Footing>) -> Witness {
        let mut mixture = Mixture::new(self.question.len());
        let corners = upper.corners(&self.dual);
        let total = |corners: &[(&chain::Chain, usize, Dyadic); 4]| {
            corners.iter().fold(Dyadic::zero(), |total, (.., weight)| total + weight.clone())
        };
        match lower {
            None => mixture.add_corners(corners, &Dyadic::from_f64(1.0), false, &self.dual),
            Some(lower) => {
                // p is the mean of the points above and below it, each weighted by the height over or under the other
                let below = lower.corners(&self.dual);
                let upper_factor = &lower.depth * &upper.normal[2] * total(&below);
                let lower_factor = &upper.depth * &lower.normal[2] * total(&corners);
                mixture.add_corners(corners, &upper_factor, false, &self.dual);
                mixture.add_corners(below, &lower_factor, true, &self.dual);
            }
        }
        mixture.witness(self.question, &self.p)
    }
}
