//! Whether two bodies meet, by descending from coarse levels of both to fine ones until one tells.
//!
//! # Statement
//! Input: two bodies of space with their levels ([`Hierarchy`]), either as they stand or under poses. Output: how they
//! meet, exactly, as the kernel says it of the bodies themselves, with a proof; and which levels told it, how many
//! pairs of levels were looked at, and how many generators were read. Bodies are closed: those that touch meet. A point
//! is a body without generators. Zero, parallel and coplanar generators and none at all are ordinary input.
//!
//! # Source
//! Section 5.2, hierarchical method. Two departures. Levels within the bodies tell overlaps, where the paper's, all of
//! which enclose, leave each overlap to the bodies themselves. At the bodies themselves the kernel answers in the place
//! of Theorem 5.2.
//!
//! # Method
//! 1. Begin with the coarsest level of each body.
//! 2. If the outer bodies are disjoint, so are the bodies, and a direction that separates the first separates the
//!    second.
//! 3. If the interiors of the outer bodies meet, and those of the inner bodies, too, so do those of the bodies.
//! 4. Otherwise go down by one level: with the body of which the outer one exceeds the body by more, in the mean over
//!    all directions, and with the other one unless its excess is below a quarter of that. A coarse level of one body
//!    spoils a fine one of the other. So bodies of one size descend together and cost one question a level, and the
//!    larger one of bodies of different sizes goes first.
//! 5. Where both are at their last level, the kernel answers.
//!
//! # Complexity
//! Each question takes the kernel O(k) expected for k generators of the levels, and these grow geometrically. Let a
//! level of k generators be within a part c / k of the body's size, as for bodies of even directions: then bodies apart
//! by a part g of their size, or as deep in each other, are told by levels of O(1 / g) generators, whatever n is, and
//! bodies that touch in O(n).
//!
//! Measured, two bodies of 10^5 random generators each, the second one's centre moved to 1 + g times the distance at
//! which they touch, means over 16 directions; the kernel alone reads all generators 1.0 to 1.9 times:
//!
//! | g | 1 | 0.1 | 10^-2 | 10^-3 | 10^-4 | 10^-5 | 0 | −10^-4 | −10^-3 | −10^-2 | −0.1 | −0.5 |
//! |---|---|---|---|---|---|---|---|---|---|---|---|---|
//! | pairs of levels, of 8 | 1 | 1.9 | 3.8 | 5.4 | 7.4 | 8 | 8 | 7 | 5.1 | 3.8 | 1.9 | 1 |
//! | times that all are read | 0.00004 | 0.0004 | 0.005 | 0.05 | 1.07 | 1.80 | 1.80 | 0.65 | 0.05 | 0.01 | 0.0007 | 0.0001 |
//! | time, the kernel's as 1 | 0.002 | 0.02 | 0.05 | 0.11 | 1.0 | 2.0 | 1.2 | 0.44 | 0.07 | 0.03 | 0.007 | 0.003 |
//!
//! So bodies that nearly touch cost twice the kernel's time, and of 10^3 generators, where a coarse level is not much
//! smaller than the body, three times it; there the levels gain only from g = 0.1 on. Where lengths are from 2^-200 to
//! 2^200 it is up to thirty times the kernel's time, as coarse levels are near contact then as well, and decided in
//! exact arithmetic.
//!
//! # Shapes
//! `first`, `second`: bodies with their levels; poses with any matrix, one that scales or flattens as well.
//!
//! # Numerics
//! Every decision is exact: the levels contain and are contained exactly, and so are their images under a pose; the
//! kernel decides each question exactly. Which body goes down is decided in doubles, without the poses, and changes no
//! answer.
//!
//! # Checked by
//! [`by_lad`] and [`brute_force`](crate::collision::brute_force) on all families, bodies that touch included; the crate
//! `verifier` on every proof.
//!
//! # Example
//! ```
//! use zonotope::{Status, Zonotope, collision::hierarchy::Hierarchy};
//! let generators = (1..200u32).map(|i| [1.0, f64::from(i * i % 83) / 41.0 - 1.0, f64::from(i % 13) / 6.0 - 1.0]);
//! let body = Zonotope::new([0.0; 3], generators.collect()).unwrap();
//! let moved = body.translated([1e4, 0.0, 0.0]).unwrap();
//! let [first, second] = [body, moved].map(Hierarchy::new);
//! let descent = first.intersection(&second, &mut ());
//! // far apart, which the coarsest levels tell
//! assert_eq!((descent.status(), descent.levels(), descent.visited()), (Status::Outside, [0, 0], 1));
//! assert!(first.intersection(&first, &mut ()).visited() <= first.level_count() as u32);
//! ```

use super::levels::Hierarchy;
use crate::collision::{Location, Query, Separation, Status, Witness, by_lad};
use crate::tally::{Reads, Tally};
use crate::zonotope::PreparedBody;
use crate::zonotope::pose::{AtRest, Pose, Standing};

/// A body goes down beside the other one unless its excess is less than this part of the other's: about the ratio of
/// the excesses of one level and the next.
const SHARE_OF_EXCESS: f64 = 0.25;

/// A body with its levels where it stands; a reference to the levels, nothing of them copied.
#[derive(Debug, Clone, Copy)]
pub struct PlacedHierarchy<'h, P = AtRest> {
    hierarchy: &'h Hierarchy,
    standing: P,
}

impl Hierarchy {
    /// The body where a pose puts it. O(1).
    pub fn at(&self, pose: &Pose) -> PlacedHierarchy<'_, Pose> {
        PlacedHierarchy { hierarchy: self, standing: *pose }
    }

    /// The body as it is stored. O(1).
    fn placed(&self) -> PlacedHierarchy<'_> {
        PlacedHierarchy { hierarchy: self, standing: AtRest }
    }

    /// How two bodies meet as they stand.
    pub fn intersection<'h>(&'h self, other: &'h Self, tally: &mut dyn Tally) -> Descent<'h> {
        self.placed().intersection(&other.placed(), tally)
    }
}

impl<'h, P: Standing> PlacedHierarchy<'h, P> {
    /// How two bodies meet where they stand.
    pub fn intersection<'o>(&self, other: &PlacedHierarchy<'o, P>, tally: &mut dyn Tally) -> Descent<'o, P>
    where
        'h: 'o,
    {
        Pair { bodies: [*self, *other] }.descend(tally)
    }
}

/// How two bodies meet, and how that was found out.
#[derive(Debug)]
pub struct Descent<'h, P = AtRest> {
    pair: Pair<'h, P>,
    levels: [usize; 2],
    visited: u32,
    generators_read: u64,
    meeting: Meeting,
}

/// How the bodies meet, with the proof.
#[derive(Debug)]
enum Meeting {
    /// A direction that separates outer bodies.
    Apart(Separation<3>),
    /// Coefficients of the generators of inner bodies.
    Overlapping(Witness),
    /// The bodies themselves.
    Decided(Location<3>),
}

impl<P: Standing> Descent<'_, P> {
    /// Inside if the interiors have a point in common, boundary if the bodies only touch or their sum is flat, outside
    /// if they are disjoint.
    pub fn status(&self) -> Status {
        match &self.meeting {
            Meeting::Apart(_) => Status::Outside,
            Meeting::Overlapping(_) => Status::Inside,
            Meeting::Decided(location) => location.status(),
        }
    }

    /// The level of each body that told the status, 0 the coarsest.
    pub fn levels(&self) -> [usize; 2] {
        self.levels
    }

    /// How many pairs of levels were looked at.
    pub fn visited(&self) -> u32 {
        self.visited
    }

    /// How many generators the kernel read for the status, each as often as it was read.
    pub fn generators_read(&self) -> u64 {
        self.generators_read
    }

    /// A direction that separates the bodies, if they are disjoint. O(1).
    pub fn separation(&self) -> Option<&Separation<3>> {
        match &self.meeting {
            Meeting::Apart(separation) | Meeting::Decided(Location::Outside(separation)) => Some(separation),
            Meeting::Overlapping(_) | Meeting::Decided(_) => None,
        }
    }

    /// The witness of a common point, if the bodies meet: coefficients of the generators of the
    /// [inner bodies](Hierarchy::inner) of the levels that told it, those of the first body first. O(1).
    pub fn level_witness(&self) -> Option<&Witness> {
        match &self.meeting {
            Meeting::Overlapping(witness)
            | Meeting::Decided(Location::Inside(witness) | Location::Boundary(witness)) => Some(witness),
            Meeting::Apart(_) | Meeting::Decided(Location::Outside(_)) => None,
        }
    }

    /// The status with a proof about the bodies themselves, as [`Zonotope`](crate::Zonotope) gives it. O(1) for
    /// disjoint bodies; else O(n), and where a coarse level told the status the kernel is asked for coefficients.
    pub fn location(&self) -> Location<3> {
        match &self.meeting {
            Meeting::Apart(separation) => Location::Outside(separation.clone()),
            Meeting::Overlapping(_) => self.pair.proved(self.pair.located(self.pair.finest(), &mut ())),
            Meeting::Decided(location) => self.pair.proved(location.clone()),
        }
    }
}

/// Two bodies where they stand.
#[derive(Debug, Clone, Copy)]
struct Pair<'h, P> {
    bodies: [PlacedHierarchy<'h, P>; 2],
}

impl<'h, P: Standing> Pair<'h, P> {
    fn descend(self, tally: &mut dyn Tally) -> Descent<'h, P> {
        let mut reads = Reads { tally, generators: 0 };
        let (mut levels, mut visited) = ([0; 2], 0);
        loop {
            visited += 1;
            let outer = self.located([0, 1].map(|i| self.bodies[i].hierarchy.outer(levels[i])), &mut reads);
            let next = self.below(levels);
            let meeting = match outer {
                outer if next == levels => Some(Meeting::Decided(outer)),
                Location::Outside(separation) => Some(Meeting::Apart(separation)),
                Location::Boundary(_) => None,
                Location::Inside(_) => self.overlap(levels, &mut reads).map(Meeting::Overlapping),
            };
            if let Some(meeting) = meeting {
                return Descent { pair: self, levels, visited, generators_read: reads.generators, meeting };
            }
            levels = next;
        }
    }

    /// The witness of a point common to the interiors of the inner bodies, if there is one.
    fn overlap(&self, [first, second]: [usize; 2], tally: &mut dyn Tally) -> Option<Witness> {
        let [a, b] = self.bodies.map(|body| body.hierarchy);
        match self.located([a.inner(first)?, b.inner(second)?], tally) {
            Location::Inside(witness) => Some(witness),
            Location::Boundary(_) | Location::Outside(_) => None,
        }
    }

    /// The next levels; the same if both are the last.
    fn below(&self, levels: [usize; 2]) -> [usize; 2] {
        let is_last = [0, 1].map(|i| levels[i] + 1 == self.bodies[i].hierarchy.level_count());
        let excess = [0, 1].map(|i| self.bodies[i].hierarchy.excess(levels[i]));
        [0, 1].map(|i| {
            let goes_down = is_last[1 - i] || excess[i] >= SHARE_OF_EXCESS * excess[1 - i];
            levels[i] + usize::from(goes_down && !is_last[i])
        })
    }

    /// The bodies themselves.
    fn finest(&self) -> [&'h PreparedBody; 2] {
        self.bodies.map(|body| body.hierarchy.outer(body.hierarchy.level_count() - 1))
    }

    /// The query about bodies in the places of the two.
    fn query<'q>(&self, [first, second]: [&'q PreparedBody; 2]) -> Query<'q, 3, P> {
        let [from, to] = self.bodies.map(|body| body.standing);
        Query::of_placed(first.placed().standing_as(from), second.placed().standing_as(to))
    }

    /// How bodies in the places of the two meet.
    fn located(&self, bodies: [&PreparedBody; 2], tally: &mut dyn Tally) -> Location<3> {
        by_lad::locate(&self.query(bodies), tally)
    }

    /// A location of the bodies themselves with the coefficients that a verifier takes.
    fn proved(&self, location: Location<3>) -> Location<3> {
        location.with_nearest_basis(&self.query(self.finest()))
    }
}
