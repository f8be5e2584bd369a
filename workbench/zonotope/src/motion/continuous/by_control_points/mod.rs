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
//! 1. Cut the time where a part of a motion ends, and each part evenly into stretches of at most a quarter turn. Take
//!    the first stretch that is not decided. Try, in turn: the directions that separate the bodies at its ends, and the
//!    direction that proved the stretch before it; a direction fixed in space, in the first body, in the second body,
//!    each searched for over the control zonotopes.
//! 2. A direction proves the stretch if the six coefficients of the gap are positive, or those of its halves are, up to
//!    four times over: in doubles with one bound for all, with a bound for each operation where that leaves a doubt,
//!    exactly where these do.
//! 3. Else look at the bodies as they stand at the middle, by a search in doubles. The normals of the edges that are
//!    most nearly orthogonal to the direction that separates them there may prove the whole stretch; else its halves
//!    are stretches of their own.
//! 4. A stretch at the end of which the bodies seem to meet is looked at next: each third time at the middle, else
//!    shortly before the gap vanishes along the last separating direction, fixed in space, in either body, or normal to
//!    an edge of each, whichever keeps a gap for longest (`approach`). When it is as short as the resolution,
//!    coefficients must prove the contact for the exact placements; else it is a stretch like others, and so is what
//!    follows it.
//! 5. A stretch that is shorter than [`SHORTEST_STRETCH`] and not decided is grazing, unless the bodies are proved to
//!    meet at its end; so is one that is shorter than [`SHORT_STRETCH`] if the bodies are as near at its middle and at
//!    its end as [`GRAZING_DISTANCE`] says.
//! 6. Where the bodies stay apart, neighbouring stretches that one direction proves are joined (`joined`).
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

pub(super) mod approach;
mod control_zonotopes;
pub(super) mod directions;
mod edges;
mod joined;

use super::scene::{Hint, Position, Scene};
use super::simplex_search::Outcome;
use super::{FirstContact, FreeStretch, SeparatingDirection, ordinary_sizes};
use crate::collision::Witness;
use crate::motion::Motion;
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
        Search { scene, resolution, free: Vec::new(), open: Vec::new(), is_start_known: false, tally }.first_contact()
    })
}

/// A stretch that is not decided yet.
struct Open {
    times: [f64; 2],
    /// Directions that separate the bodies at its ends, if they are known.
    hints: [Hint; 2],
    /// Whether the bodies seem to meet at its end.
    meets: bool,
    /// The number of times that it was cut off where the gap was expected to vanish.
    cuts: u8,
}

struct Search<'a, 't> {
    scene: Scene<'a>,
    resolution: f64,
    free: Vec<FreeStretch>,
    /// The first stretch last.
    open: Vec<Open>,
    /// Whether the bodies are known to be disjoint at the start.
    is_start_known: bool,
    tally: &'t mut dyn Tally,
}

impl Search<'_, '_> {
    fn first_contact(mut self) -> FirstContact {
        let open = |times| Open { times, hints: [None; 2], meets: false, cuts: 0 };
        self.open = self.scene.moving.first_stretches().into_iter().rev().map(open).collect();
        for _ in 0..STRETCH_LIMIT {
            let Some(stretch) = self.open.pop() else { return self.separate() };
            self.tally.add(Operation::Stretch, 1);
            let times = stretch.times;
            let decided = if stretch.meets { self.approach(stretch) } else { self.decide(stretch) };
            match decided {
                Decided::Not => {}
                Decided::Grazing => return self.grazing(times),
                Decided::Contact(time, witness) => return FirstContact::Contact { free: self.free, time, witness },
            }
        }
        match self.open.pop() {
            Some(Open { times, .. }) => self.grazing(times),
            None => self.separate(),
        }
    }

    /// The answer where all stretches are proved.
    fn separate(self) -> FirstContact {
        FirstContact::Separate { free: joined::joined(&self.scene.moving, self.free, self.tally) }
    }

    /// Proves a stretch, or cuts it in halves.
    fn decide(&mut self, Open { times, mut hints, .. }: Open) -> Decided {
        let [from, until] = times;
        let stretch = self.scene.moving.is_whole(times).then(|| self.scene.moving.rounded_stretch(times));
        if let Some(direction) = stretch.as_ref().and_then(|stretch| {
            directions::separating(&self.scene.moving, stretch, times, &known(&self.free, &hints), self.tally)
        }) {
            self.free.push(FreeStretch { from, until, direction });
            return Decided::Not;
        }
        if from == 0.0 && !self.is_start_known {
            self.is_start_known = true;
            match self.scene.position_at(from, self.tally) {
                Position::Meeting(witness) => return Decided::Contact([from; 2], witness),
                Position::NotProved(found) => hints[0] = found,
            }
        }
        let width = until - from;
        if width <= SHORTEST_STRETCH {
            return self.decide_at_end(times, hints);
        }
        let middle = from + width / 2.0;
        match self.guess_at(middle, &hints) {
            Guess::Meeting => {
                self.open.push(Open { times: [middle, until], hints: [None, hints[1]], meets: false, cuts: 0 });
                self.open.push(Open { times: [from, middle], hints: [hints[0], None], meets: true, cuts: 0 });
            }
            Guess::Disjoint(found) => {
                if let Some(direction) = stretch
                    .and_then(|stretch| directions::of_edges(&self.scene.moving, &stretch, times, &[found], self.tally))
                {
                    self.free.push(FreeStretch { from, until, direction });
                    return Decided::Not;
                }
                if width <= SHORT_STRETCH && self.is_grazing(middle) && self.is_grazing(until) {
                    return self.decide_at_end(times, hints);
                }
                self.open.push(Open { times: [middle, until], hints: [found, hints[1]], meets: false, cuts: 0 });
                self.open.push(Open { times: [from, middle], hints: [hints[0], found], meets: false, cuts: 0 });
            }
        }
        Decided::Not
    }

    /// Decides about a stretch that is too short to be halved for a direction: the bodies meet at its end, or graze.
    fn decide_at_end(&mut self, times: [f64; 2], hints: [Hint; 2]) -> Decided {
        match self.scene.position_at(times[1], self.tally) {
            Position::Meeting(witness) if times[1] - times[0] <= self.resolution => Decided::Contact(times, witness),
            Position::Meeting(_) => {
                self.open.push(Open { times, hints: [hints[0], None], meets: true, cuts: 0 });
                Decided::Not
            }
            Position::NotProved(_) => Decided::Grazing,
        }
    }

    /// Makes a stretch at the end of which the bodies seem to meet shorter.
    fn approach(&mut self, Open { times, hints, cuts, .. }: Open) -> Decided {
        let [from, until] = times;
        let width = until - from;
        if width <= self.resolution {
            match self.scene.position_at(until, self.tally) {
                Position::Meeting(witness) => return Decided::Contact(times, witness),
                // it only seemed so
                Position::NotProved(found) => {
                    self.open.push(Open { times, hints: [hints[0], found], meets: false, cuts: 0 })
                }
            }
            return Decided::Not;
        }
        let latest = if cuts % 3 < 2 {
            hints[0]
                .and_then(|hint| approach::latest_gap(&self.scene.moving, times, &hint, self.resolution, self.tally))
        } else {
            None
        };
        let middle = latest.map_or(from + width / 2.0, |(time, _)| time);
        let cuts = cuts.wrapping_add(1);
        let (before, after) = match self.guess_at(middle, &hints) {
            Guess::Meeting => (Open { times: [from, middle], hints, meets: true, cuts }, [None; 2]),
            Guess::Disjoint(found) => {
                let hints = [latest.map(|(_, direction)| direction).or(hints[0]), found];
                (Open { times: [from, middle], hints, meets: false, cuts: 0 }, [found, None])
            }
        };
        self.open.push(Open { times: [middle, until], hints: after, meets: true, cuts });
        self.open.push(before);
        Decided::Not
    }

    /// The position of the bodies at a time: by a search in doubles, exactly where that leaves a doubt.
    fn guess_at(&mut self, time: f64, hints: &[Hint; 2]) -> Guess {
        let first = hints.iter().rev().flatten().find_map(SeparatingDirection::fixed_in_space);
        match self.scene.moving.search_at(time, first, self.tally) {
            Outcome::Found(u) => Guess::Disjoint(Some(SeparatingDirection::Space(u))),
            Outcome::Inside => Guess::Meeting,
            Outcome::Undecided => match self.scene.position_at(time, self.tally) {
                Position::Meeting(_) => Guess::Meeting,
                Position::NotProved(found) => Guess::Disjoint(found),
            },
        }
    }

    /// Whether the bodies, as they are rounded at a time, are so near that finer stretches would tell little.
    fn is_grazing(&mut self, time: f64) -> bool {
        let size: f64 = self.scene.moving.bodies.iter().map(|body| body.magnitude()).sum();
        let proximity = self.scene.proximity_at(time, self.tally);
        proximity.is_some_and(|proximity| proximity.distance() <= GRAZING_DISTANCE * size)
    }

    /// The answer where a stretch is not decided.
    fn grazing(self, time: [f64; 2]) -> FirstContact {
        let distance_at_most = self.scene.distance_at_most(time[1], self.tally);
        FirstContact::Grazing { free: self.free, time, distance_at_most }
    }
}

/// The decision about a stretch.
enum Decided {
    /// It is proved, or cut in pieces.
    Not,
    /// The bodies are disjoint before the first of two times and meet at the second.
    Contact([f64; 2], Witness),
    /// Neither was proved.
    Grazing,
}

/// A guess of the position of two bodies to each other at a time.
enum Guess {
    /// They seem to meet.
    Meeting,
    /// They seem not to.
    Disjoint(Hint),
}

/// The directions that are known: those at the ends of a stretch, then that of the stretch before it.
fn known(free: &[FreeStretch], hints: &[Hint; 2]) -> [Hint; 3] {
    let before = free.last().map(|stretch| stretch.direction);
    [hints[1], hints[0], before.filter(|before| Some(*before) != hints[0])]
}
