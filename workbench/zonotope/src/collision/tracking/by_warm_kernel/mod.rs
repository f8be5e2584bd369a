//! Tracking two bodies under any motion, by the kernel, which in each frame begins with what the last one found.
//!
//! # Statement
//! Input: two bodies of space, and frame by frame a pose for each. Output: for each frame how the bodies meet
//! ([`Tracked`]): inside, touching or disjoint, the same as [`Placed::intersection`] says, with a proof on
//! request. No frame must be near the one before: a jump costs as much as a first query, and the status does not depend
//! on the frames before. Flat, empty, parallel and touching bodies are ordinary input, and so is any matrix.
//!
//! # Source
//! Beyond the paper, whose Section 5.2 tracks closest features (Lemma 5.6). A feature of a zonotope of n generators is
//! as small as 1 / n², and a motion passes over many of them in a frame; the kernel passes over all of them at once.
//!
//! # Method
//! 1. The last proof is held against the new poses (`kept`): a direction that separated with room to spare, or a gauge
//!    well below 1, still tells after a small motion, in O(1). Of bodies that only translate, a direction is asked
//!    about again without any loss, and so is the facet through which the ray left (`exit_facet`).
//! 2. Where the gap has become too narrow for that, the next optimum is predicted (`prediction`), and the sums of the
//!    generators near the predicted direction are brought up to date, for each body in its own frame (`local_sums`).
//!    The direction is tried as a separating one first.
//! 3. Then the kernel searches a cell around it (`query`), a few times as wide as predictions were off lately. All its
//!    rungs are behind that: where the optimum is not in the cell, it answers as it answers a query without a past.
//! 4. Where frames have nothing in common, attempts to use the last one become rare (`pace`), and the frames between
//!    are fresh queries.
//!
//! # Complexity
//! n generators, of which k ≪ n cross the cell that the motion of a frame makes necessary: O(1) while the last proof
//! holds, else O(k) and, with an optimum that turns by ω a frame, about 8 ω n reads for each of log_8 n cells. A frame
//! with nothing to go by is a fresh query, O(n) expected, and the sums take another pass. At most 128 generators are
//! searched all at once. Space O(n) beside the bodies.
//!
//! # Shapes
//! `bodies`: prepared or not; generators in any order, duplicates allowed.
//!
//! # Numerics
//! The status is exact for the poses as they are given. Sums are in doubles with a bound of their error, and what they
//! leave open is decided by the kernel's exact rungs.
//!
//! # Checked by
//! [`brute_force`](crate::collision::brute_force) and fresh queries, on frames of all families of bodies that drift,
//! slide, touch, jump and spin; the verifier, on their proofs.
//!
//! # Example
//! ```
//! use zonotope::collision::Status;
//! use zonotope::collision::tracking::WarmTracker;
//! use zonotope::zonotope::{PreparedBody, Zonotope};
//! use zonotope::Pose;
//! // the cube [−1, 1]³ passes over another one
//! let axes = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let cube = PreparedBody::new(Zonotope::new([0.0; 3], axes).unwrap());
//! let mut tracker = WarmTracker::new(&cube, &cube);
//! for (x, status) in [(3.0, Status::Outside), (2.0, Status::Boundary), (1.0, Status::Inside)] {
//!     let pose = Pose::from_translation([x, 0.0, 0.5]).unwrap();
//!     assert_eq!(tracker.frame(&Pose::IDENTITY, &pose, &mut ()).status(), status);
//! }
//! ```
//!
//! [`Placed::intersection`]: crate::Placed::intersection

mod answer;
mod exit_facet;
mod extent;
mod kept;
mod local_sums;
mod pace;
mod prediction;
mod query;

#[cfg(test)]
mod tests;

pub use answer::Tracked;

use self::answer::Certificate;
use self::extent::Extent;
use self::kept::{Kept, gauge_bound};
use self::local_sums::{LocalSums, WIDEST_RADIUS};
use self::pace::{COPY_CHARGE, Pace};
use self::prediction::{Expected, Prediction};
use self::query::WarmQuery;
use crate::collision::by_lad::early;
use crate::collision::{Location, Separation};
use crate::lad::of_generators::goal::Goal;
use crate::lad::of_generators::optimum::Optimum;
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::generators::Generators;
use crate::lad::of_generators::solve;
use crate::numeric::bounded;
use crate::numeric::exact_linear::rounded_direction;
use crate::numeric::linear::dot;
use crate::tally::{Operation, Reads, Rung, Tally};
use crate::zonotope::pose::Pose;
use crate::zonotope::query::{Placed, Query};

/// The search takes all generators at once if there are no more than these: no sums are kept of them.
const WHOLE_LIMIT: usize = 128;

/// The radius of the first cell of a search in terms of the drift of predictions.
const CELL_DRIFTS: f64 = 4.0;

/// Of evenly spread generators about twice so many cross the smallest cell of a search.
const LEAST_CROSSING: f64 = 8.0;

/// The radius of the smallest cell with sums in terms of that of the cell of a search, which is made wider by the
/// coordinates of the plane of directions, by at most √3, and where the optimum is just beyond it.
const ROOM_AROUND: f64 = 4.0;

/// Two bodies whose motion is followed; references to them, and what the last frame leaves.
#[derive(Debug)]
pub struct WarmTracker<'b> {
    bodies: [Placed<'b>; 2],
    extents: [Extent; 2],
    sums: [LocalSums; 2],
    kept: Option<Kept>,
    prediction: Option<Prediction>,
    pace: Pace,
}

impl<'b> WarmTracker<'b> {
    /// A tracker of two bodies, prepared or not. O(n).
    pub fn new(first: impl Into<Placed<'b>>, second: impl Into<Placed<'b>>) -> Self {
        let bodies = [first.into(), second.into()];
        Self {
            bodies,
            extents: bodies.map(|body| Extent::of(body.generators())),
            sums: Default::default(),
            kept: None,
            prediction: None,
            pace: Pace::default(),
        }
    }

    /// How the bodies meet under the poses of a frame.
    pub fn frame(&mut self, first: &Pose, second: &Pose, tally: &mut dyn Tally) -> Tracked<'b> {
        let query = Query::of_placed(self.bodies[0].at(first), self.bodies[1].at(second));
        if let Some(kept) = self.kept.as_ref().filter(|kept| kept.holds(&query, &self.extents)) {
            self.pace.told();
            return Tracked::new(
                query,
                match kept {
                    Kept::Outside { direction, .. } => Certificate::outside(*direction),
                    Kept::Inside(_) => Certificate::Near,
                },
            );
        }
        if !self.pace.is_due() {
            let certificate = self.fresh(&query, tally);
            return Tracked::new(query, certificate);
        }
        let mut reads = Reads { tally, generators: 0 };
        let expected = self.prediction.as_ref().filter(|_| query.len() > WHOLE_LIMIT).map(|p| p.expected(&query));
        let expected = expected.filter(|expected| ROOM_AROUND * CELL_DRIFTS * expected.drift <= WIDEST_RADIUS);
        let (certificate, charge) = match expected {
            Some(expected) => (self.warm(&query, expected, &mut reads), COPY_CHARGE),
            None => (self.cold(&query, &mut reads), 1.0),
        };
        self.pace.attempted(charge * reads.generators as f64 / query.len().max(1) as f64);
        Tracked::new(query, certificate)
    }

    /// A frame like a first query, in a pause: what can be learnt and kept of it without a pass is all but free.
    fn fresh(&mut self, query: &Query<'_, 3, Pose>, tally: &mut dyn Tally) -> Certificate {
        self.kept = None;
        if let Some(proof) = early::locate(query, tally) {
            return Certificate::Written(proof.counted(tally).written(query));
        }
        let optimum = solve(query, Goal::Location, tally);
        self.learn(query, &optimum);
        self.kept = Kept::of_optimum(query, &optimum, &self.extents);
        Certificate::of_optimum(query, optimum)
    }

    /// A frame that has a prediction to go by.
    fn warm(&mut self, query: &Query<'_, 3, Pose>, expected: Expected, tally: &mut dyn Tally) -> Certificate {
        let Expected { direction, drift } = expected;
        let radius = (CELL_DRIFTS * drift).max(LEAST_CROSSING / query.len() as f64);
        let mut sums = std::mem::take(&mut self.sums);
        for (part, sums) in Generators::parts(query).iter().zip(&mut sums) {
            let own = part.frame.map_or(direction, |frame| frame.pulled(&direction));
            let read = sums.center_on(part.rows, own, ROOM_AROUND * radius);
            tally.add(Operation::GeneratorRead, read as u64);
        }
        let p = query.rounded_displacement();
        let along = dot(&direction, &p.map(|c| c.value));
        let cell = DirectionCone { center: direction.map(|c| c / along), axes: None, ball: radius / along };
        let cell = Some(cell).filter(|cell| along > 0.0 && cell.is_finite());
        let warm = WarmQuery { query, sums, cell, gauge_bound: gauge_bound(query, &self.extents) };
        let was_outside = matches!(self.kept, Some(Kept::Outside { .. }));
        let support = warm.local_support(&direction).filter(|_| was_outside);
        let separating = support.filter(|&support| (dot(&p, &bounded::exact(direction)) - support).is_positive());
        let certificate = if let Some(support) = separating {
            tally.answered_by(Rung::RoundedDirection);
            self.kept = Some(Kept::outside(query, direction, support));
            self.prediction.iter_mut().for_each(Prediction::confirm);
            Certificate::outside(direction)
        } else {
            let optimum = solve(&warm, Goal::Location, tally);
            self.learn(&warm, &optimum);
            if matches!(optimum, Optimum::Separated(_)) {
                // the cell was missed by far
                self.prediction = None;
            }
            self.kept = self.proof_of(&optimum, query, tally);
            Certificate::of_optimum(query, optimum)
        };
        self.sums = warm.sums;
        certificate
    }

    /// A frame like a first query, of which more is kept than the answer.
    ///
    /// A direction that tells what is clear is kept as it is. Where the last one did not hold for long, the optimum,
    /// which leaves more room, is worth a search.
    fn cold(&mut self, query: &Query<'_, 3, Pose>, tally: &mut dyn Tally) -> Certificate {
        let clear = early::locate(query, tally).map(|proof| proof.counted(tally).written(query));
        let has_failed = matches!(self.kept.take(), Some(Kept::Outside { .. })) && query.len() > WHOLE_LIMIT;
        match clear {
            Some(Location::Outside(Separation::Rounded(direction))) if !has_failed => {
                self.kept = Some(Self::separating(query, direction, tally));
                return Certificate::outside(direction);
            }
            Some(flat @ Location::Boundary(_)) => return Certificate::Written(flat),
            _ => {}
        }
        // who asks for the location alone may be given any direction that separates
        let goal = if has_failed { Goal::Gauge } else { Goal::Location };
        let optimum = solve(query, goal, tally);
        self.learn(query, &optimum);
        self.kept = self.proof_of(&optimum, query, tally);
        match clear {
            Some(clear) => Certificate::Written(clear),
            None => Certificate::of_optimum(query, optimum),
        }
    }

    /// What is kept of an optimum. O(1), but for a direction that was found without an optimum.
    fn proof_of(&self, optimum: &Optimum, query: &Query<'_, 3, Pose>, tally: &mut dyn Tally) -> Option<Kept> {
        match optimum {
            Optimum::Separated(direction) => Some(Self::separating(query, *direction, tally)),
            _ => Kept::of_optimum(query, optimum, &self.extents),
        }
    }

    /// A direction that separates, with its support value. One pass.
    fn separating(query: &Query<'_, 3, Pose>, direction: [f64; 3], tally: &mut dyn Tally) -> Kept {
        tally.add(Operation::GeneratorRead, query.len() as u64);
        Kept::outside(query, direction, query.support(&direction))
    }

    /// Takes note of an optimum, for predictions.
    fn learn(&mut self, generators: &dyn Generators, optimum: &Optimum) {
        let Some((direction, basis)) = vertex_of(optimum) else { return };
        match &mut self.prediction {
            Some(prediction) => prediction.learn(generators, direction, basis),
            None => self.prediction = Prediction::new(direction, basis),
        }
    }
}

/// The direction of an optimum with its two generators, if it has any.
fn vertex_of(optimum: &Optimum) -> Option<([f64; 3], Option<[usize; 2]>)> {
    match optimum {
        Optimum::Rounded(decided) => Some((decided.optimum.direction.map(|c| c.value), Some(decided.optimum.basis))),
        Optimum::Exact(exact) => Some((rounded_direction(&exact.direction), exact.basis[..].try_into().ok())),
        Optimum::Center | Optimum::Separated(_) | Optimum::Ended | Optimum::Flat(_) => None,
    }
}
