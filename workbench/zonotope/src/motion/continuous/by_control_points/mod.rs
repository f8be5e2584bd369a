//! The first contact of two moving bodies, by the control points of the gap between them.
//!
//! # Statement
//! Input: two zonotopes of space, a motion of each, a resolution. Output: when they meet first, as [`FirstContact`]
//! has it, proved. Sets are closed: bodies that touch meet. Bodies that only graze each other, or touch along a stretch
//! of time, are grazing from where the doubt begins.
//!
//! # Source
//! Section 6 halves the step until the bodies that enclose both swept volumes are disjoint, or a collision is found.
//! Here, too, the step is halved, but a stretch of time is free by a direction along which there is a gap at every time
//! of it: of swept volumes, the time of each point is forgotten. The bound of the gap by Bernstein coefficients is that
//! of curves by their control polygons, for rotations by quaternions that are linear in time.
//!
//! # Method
//! 1. Take the first stretch that is not decided. Try, in turn: the directions that separate the bodies at its ends,
//!    and the direction that proved the stretch before it; a direction fixed in space, in the first body, in the second
//!    body, each searched for over the control zonotopes.
//! 2. A direction proves the stretch if the six coefficients of the gap are positive: in doubles with bounds, exactly
//!    where these are in doubt.
//! 3. Else ask the bodies as they stand at the middle. The normals of the edges that are most nearly orthogonal to the
//!    direction that separates them there may prove the whole stretch; else its halves are stretches of their own.
//!    Where they meet, and coefficients prove it for the exact placements, everything after the middle is dropped.
//! 4. A stretch at the end of which the bodies meet is a contact when it is as short as the resolution. Till then the
//!    next question is asked shortly before the gap along the last separating direction vanishes, each third time at
//!    the middle.
//! 5. A stretch that is shorter than [`SHORTEST_STRETCH`] and not decided is grazing; so is one that is shorter than
//!    [`SHORT_STRETCH`] if the bodies are as near at its middle as [`GRAZING_DISTANCE`] says.
//!
//! # Complexity
//! O(n) for each stretch and each step of a search; a clearance ε takes some 1/√ε stretches at worst, and one or few
//! for most motions. At most [`STRETCH_LIMIT`] stretches; then the rest is grazing with the distance at that time.
//!
//! # Shapes
//! `bodies`: two zonotopes of space with any number of generators; times in [0, 1]; angles in radians.
//!
//! # Numerics
//! Directions are guesses; a free stretch and a contact are decided exactly. The distance of a grazing is rounded up.
//!
//! # Errors
//! None: motions are finite and their times go from 0 to 1.
//!
//! # Panics
//! Never.
//!
//! # Checked by
//! [`brute_force`](super::brute_force): the gap at rational times in exact numbers; dense sampling with exact queries.
//!
//! # Example
//! ```
//! use zonotope::Zonotope;
//! use zonotope::motion::{Motion, continuous::{FirstContact, first_contact}};
//! let cube = Zonotope::new([0.0; 3], vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).expect("finite");
//! let other = cube.translated([6.0, 0.0, 0.0]).expect("finite");
//! let right = Motion::translation([8.0, 0.0, 0.0]).expect("finite");
//! // faces that are 4 apart meet when half of 8 is gone
//! match first_contact([&cube, &other], [&right, &Motion::rest()]) {
//!     FirstContact::Contact { time: [before, met], .. } => assert!(before < 0.5 && 0.5 <= met),
//!     answer => panic!("{answer:?}"),
//! }
//! ```

mod approach;
mod control_zonotopes;
mod edges;

use self::control_zonotopes::ControlZonotopes;
use super::gap::Stretch;
use super::scene::Scene;
use super::{FirstContact, FreeStretch, SeparatingDirection, ordinary_sizes};
use crate::collision::Witness;
use crate::motion::Motion;
use crate::numeric::bounded::Bounded;
use crate::tally::{Operation, Tally};
use crate::zonotope::Zonotope;

/// A stretch that is this short and not decided ends the search.
pub const SHORTEST_STRETCH: f64 = 1.0 / (1u64 << 36) as f64;

/// A stretch that is this short and not decided is looked at for grazing.
pub const SHORT_STRETCH: f64 = 1.0 / (1u64 << 18) as f64;

/// The distance at which bodies graze each other, beside the sizes of both.
pub const GRAZING_DISTANCE: f64 = 1.0 / (1u64 << 36) as f64;

/// The resolution of a contact where none is asked for.
pub const DEFAULT_RESOLUTION: f64 = 1.0 / (1u64 << 30) as f64;

/// The finest resolution: times from 0 to 1 that are so far apart are doubles, and so is what lies half-way.
pub const FINEST_RESOLUTION: f64 = 1.0 / (1u64 << 50) as f64;

/// The number of stretches that are looked at.
pub const STRETCH_LIMIT: usize = 1 << 14;

/// When two moving bodies meet first during the time from 0 to 1, a contact between two times that are not farther
/// apart than 2^-30.
pub fn first_contact(bodies: [&Zonotope<3>; 2], motions: [&Motion; 2]) -> FirstContact {
    first_contact_within(bodies, motions, DEFAULT_RESOLUTION)
}

/// The same with another resolution, at least [`FINEST_RESOLUTION`].
pub fn first_contact_within(bodies: [&Zonotope<3>; 2], motions: [&Motion; 2], resolution: f64) -> FirstContact {
    first_contact_counted(bodies, motions, resolution, &mut ())
}

/// [`first_contact_within`], counting its operations.
pub fn first_contact_counted(
    bodies: [&Zonotope<3>; 2],
    motions: [&Motion; 2],
    resolution: f64,
    tally: &mut dyn Tally,
) -> FirstContact {
    let resolution = resolution.max(FINEST_RESOLUTION);
    ordinary_sizes::first_contact(bodies, motions, |scene| {
        Search { scene, resolution, free: Vec::new(), open: Vec::new(), tally }.first_contact()
    })
}

/// A stretch that is not decided yet.
struct Open {
    times: [f64; 2],
    /// Directions that separate the bodies at its ends, if they are known.
    hints: [Option<SeparatingDirection>; 2],
    /// The proof that the bodies meet at its end, if they do.
    meets: Option<Witness>,
    /// How often it was cut off where the gap was expected to vanish.
    cuts: u8,
}

struct Search<'a, 't> {
    scene: Scene<'a>,
    resolution: f64,
    free: Vec<FreeStretch>,
    /// The first stretch last.
    open: Vec<Open>,
    tally: &'t mut dyn Tally,
}

impl Search<'_, '_> {
    fn first_contact(mut self) -> FirstContact {
        let start = match self.scene.at(0.0, self.tally) {
            Ok(witness) => return FirstContact::Contact { free: self.free, time: [0.0; 2], witness },
            Err(found) => found,
        };
        let parts = self.scene.parts();
        let open = |times| Open { times, hints: [None; 2], meets: None, cuts: 0 };
        self.open = parts.into_iter().rev().map(open).collect();
        if let Some(first) = self.open.last_mut() {
            first.hints[0] = start;
        }
        for _ in 0..STRETCH_LIMIT {
            let Some(stretch) = self.open.pop() else { return FirstContact::Separate { free: self.free } };
            self.tally.add(Operation::Stretch, 1);
            let times = stretch.times;
            let decided = match stretch.meets {
                Some(_) => self.approach(stretch),
                None => self.decide(stretch),
            };
            match decided {
                Decided::Not => {}
                Decided::Grazing => return self.grazing(times),
                Decided::Contact(witness) => {
                    return FirstContact::Contact { free: self.free, time: times, witness };
                }
            }
        }
        match self.open.pop() {
            Some(Open { times, .. }) => self.grazing(times),
            None => FirstContact::Separate { free: self.free },
        }
    }

    /// Proves a stretch, or cuts it in halves.
    fn decide(&mut self, Open { times, hints, .. }: Open) -> Decided {
        let [from, until] = times;
        let stretch = self.scene.is_whole(times).then(|| self.scene.stretch(times));
        if let Some(direction) = stretch.as_ref().and_then(|stretch| self.separates(stretch, times, &hints)) {
            self.free.push(FreeStretch { from, until, direction });
            return Decided::Not;
        }
        let width = until - from;
        if width <= SHORTEST_STRETCH {
            return match self.scene.at(until, self.tally) {
                Ok(witness) if width <= self.resolution => Decided::Contact(witness),
                _ => Decided::Grazing,
            };
        }
        let middle = from + width / 2.0;
        match self.scene.at(middle, self.tally) {
            Ok(witness) => {
                self.open.clear();
                let meets = Some(witness);
                self.open.push(Open { times: [from, middle], hints: [hints[0], None], meets, cuts: 0 });
            }
            Err(found) => {
                if let Some(direction) = stretch.and_then(|stretch| self.edges(&stretch, times, found)) {
                    self.free.push(FreeStretch { from, until, direction });
                    return Decided::Not;
                }
                if width <= SHORT_STRETCH && self.is_grazing(middle) && self.is_grazing(times[1]) {
                    return Decided::Grazing;
                }
                self.open.push(Open { times: [middle, until], hints: [found, hints[1]], meets: None, cuts: 0 });
                self.open.push(Open { times: [from, middle], hints: [hints[0], found], meets: None, cuts: 0 });
            }
        }
        Decided::Not
    }

    /// Makes a stretch at the end of which the bodies meet shorter.
    fn approach(&mut self, Open { times, hints, meets, cuts }: Open) -> Decided {
        let [from, until] = times;
        let width = until - from;
        if width <= self.resolution {
            return meets.map_or(Decided::Grazing, Decided::Contact);
        }
        let guess = if cuts % 3 < 2 { hints[0].and_then(|hint| self.guess(times, &hint)) } else { None };
        let middle = guess.unwrap_or(from + width / 2.0);
        let cuts = cuts.wrapping_add(1);
        match self.scene.at(middle, self.tally) {
            Ok(witness) => {
                let meets = Some(witness);
                self.open.push(Open { times: [from, middle], hints: [hints[0], None], meets, cuts });
            }
            Err(found) => {
                self.open.push(Open { times: [middle, until], hints: [found, None], meets, cuts });
                self.open.push(Open { times: [from, middle], hints: [hints[0], found], meets: None, cuts: 0 });
            }
        }
        Decided::Not
    }

    /// When the bodies may meet within a stretch, by the gap along a direction that separates them at its begin.
    fn guess(&mut self, times: [f64; 2], hint: &SeparatingDirection) -> Option<f64> {
        if !self.scene.is_whole(times) {
            return None;
        }
        let stretch = self.scene.stretch(times);
        self.tally.add(Operation::SupportEvaluation, stretch.support_evaluations(hint));
        approach::next_time(&stretch.gap_along(hint), times, self.resolution)
    }

    /// A direction that proves a stretch, the first that does.
    fn separates(
        &mut self,
        stretch: &Stretch<'_, Bounded>,
        times: [f64; 2],
        hints: &[Option<SeparatingDirection>; 2],
    ) -> Option<SeparatingDirection> {
        let before = self.free.last().map(|stretch| stretch.direction);
        let known = [hints[1], hints[0], before.filter(|before| Some(*before) != hints[0])];
        let known = known.into_iter().flatten().find(|direction| self.proves(stretch, times, direction));
        if known.is_some() {
            return known;
        }
        let first = hints.iter().rev().flatten().find_map(|hint| match hint {
            SeparatingDirection::Space(u) => Some(*u),
            _ => None,
        });
        let first = first.unwrap_or_else(|| middle_path(stretch));
        let found = ControlZonotopes::in_space(stretch).separating_direction(first, self.tally);
        let found = found.map(SeparatingDirection::Space).filter(|direction| self.proves(stretch, times, direction));
        if found.is_some() {
            return found;
        }
        [0, 1].into_iter().find_map(|own| {
            let arc = &stretch.arcs[own];
            // of a body that only translates, the frame is that of space
            if arc.is_translation {
                return None;
            }
            let sign = [1.0, -1.0][own];
            let first = arc.rounded().turned_back(&first).map(|c| sign * c);
            let u = ControlZonotopes::in_frame(stretch, own).separating_direction(first, self.tally)?;
            let direction = match own {
                0 => SeparatingDirection::First(u),
                _ => SeparatingDirection::Second(u.map(|c| -c)),
            };
            self.proves(stretch, times, &direction).then_some(direction)
        })
    }

    /// The normal of two edges that proves a stretch, by the direction that separates the bodies at its middle.
    fn edges(
        &mut self,
        stretch: &Stretch<'_, Bounded>,
        times: [f64; 2],
        found: Option<SeparatingDirection>,
    ) -> Option<SeparatingDirection> {
        let Some(SeparatingDirection::Space(u)) = found else { return None };
        if stretch.arcs.iter().all(|arc| arc.is_translation) {
            return None;
        }
        edges::normals(stretch, u).find(|direction| self.proves(stretch, times, direction))
    }

    fn proves(&mut self, stretch: &Stretch<'_, Bounded>, times: [f64; 2], direction: &SeparatingDirection) -> bool {
        self.scene.is_proved(stretch, times, direction, self.tally)
    }

    /// Whether the bodies are so near at a time that finer stretches would tell little.
    fn is_grazing(&mut self, time: f64) -> bool {
        let size: f64 = self.scene.bodies.iter().map(|body| body.magnitude()).sum();
        self.scene.distance_at_most(time, self.tally) <= GRAZING_DISTANCE * size
    }

    /// The answer where a stretch is not decided.
    fn grazing(self, time: [f64; 2]) -> FirstContact {
        let distance_at_most = self.scene.distance_at_most(time[1], self.tally);
        FirstContact::Grazing { free: self.free, time, distance_at_most }
    }
}

/// What became of a stretch.
enum Decided {
    /// It is proved, or cut in pieces.
    Not,
    /// The bodies meet at its end, and it is short enough.
    Contact(Witness),
    /// Neither was proved.
    Grazing,
}

/// The path between the centres of the bodies at the middle of a stretch.
fn middle_path(stretch: &Stretch<'_, Bounded>) -> [f64; 3] {
    let [from, to] = [0, 1].map(|i| stretch.arcs[i].rounded().middle_of(&stretch.bodies[i].center()));
    [0, 1, 2].map(|k| to[k] - from[k])
}
