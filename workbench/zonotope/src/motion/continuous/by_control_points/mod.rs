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
//! 1. Take the first stretch that is not decided. Try, in turn: the direction of the stretch that it is a half of; a
//!    direction fixed in space, in the first body, in the second body, each searched for over the control zonotopes;
//!    the normal of the two edges most orthogonal to the last direction.
//! 2. A direction proves the stretch if the six coefficients of the gap are positive: in doubles with bounds, exactly
//!    where these are in doubt.
//! 3. Else ask the bodies as they stand at the middle. Where they meet, and coefficients prove it for the exact
//!    placements, everything after the middle is dropped. Both halves are stretches of their own.
//! 4. A stretch at the end of which the bodies meet is a contact when it is as short as the resolution. One that is
//!    shorter than [`SHORTEST_STRETCH`] and not decided is grazing.
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
//! Dense sampling with exact queries, and the gap at rational times in exact numbers.

mod control_zonotopes;
mod edges;

use self::control_zonotopes::ControlZonotopes;
use super::gap::Stretch;
use super::{FirstContact, FreeStretch, SeparatingDirection, meeting};
use crate::collision::{Location, Separation, Witness};
use crate::motion::Motion;
use crate::motion::arc::Arc;
use crate::numeric::bounded::Bounded;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::sum_norm;
use crate::numeric::tolerance::POSE_ROUNDING;
use crate::zonotope::Zonotope;

/// A stretch that is this short and not decided ends the search.
pub const SHORTEST_STRETCH: f64 = 1.0 / (1u64 << 36) as f64;

/// The resolution of a contact where none is asked for.
pub const DEFAULT_RESOLUTION: f64 = 1.0 / (1u64 << 30) as f64;

/// The finest resolution: times from 0 to 1 that are so far apart are doubles, and so is what lies half-way.
pub const FINEST_RESOLUTION: f64 = 1.0 / (1u64 << 50) as f64;

/// The number of stretches that are looked at.
pub const STRETCH_LIMIT: usize = 1 << 16;

/// When two moving bodies meet first during the time from 0 to 1, a contact between two times that are not farther
/// apart than 2^-30.
pub fn first_contact(bodies: [&Zonotope<3>; 2], motions: [&Motion; 2]) -> FirstContact {
    first_contact_within(bodies, motions, DEFAULT_RESOLUTION)
}

/// The same with another resolution, at least [`FINEST_RESOLUTION`].
pub fn first_contact_within(bodies: [&Zonotope<3>; 2], motions: [&Motion; 2], resolution: f64) -> FirstContact {
    let reaches = [0, 1].map(|i| motions[i].reach(bodies[i]));
    Search { bodies, motions, reaches, free: Vec::new() }.first_contact(resolution.max(FINEST_RESOLUTION))
}

/// A stretch that is not decided yet.
struct Open {
    from: f64,
    until: f64,
    /// A direction that may prove it.
    hint: Option<SeparatingDirection>,
    /// The proof that the bodies meet at its end, if they do.
    meets: Option<Witness>,
}

struct Search<'a> {
    bodies: [&'a Zonotope<3>; 2],
    motions: [&'a Motion; 2],
    /// Bounds of how far from the axes the bodies reach, for rotations at constant rate.
    reaches: [f64; 2],
    free: Vec<FreeStretch>,
}

impl Search<'_> {
    fn first_contact(mut self, resolution: f64) -> FirstContact {
        if let Ok(witness) = self.at(0.0) {
            return self.contact([0.0; 2], witness);
        }
        let mut open = self.parts();
        for _ in 0..STRETCH_LIMIT {
            let Some(Open { from, until, hint, meets }) = open.pop() else {
                return FirstContact::Separate { free: self.free };
            };
            let is_whole = self.motions.iter().all(|motion| motion.is_one_stretch([from, until]));
            if is_whole && meets.is_none() {
                if let Some(direction) = self.separates([from, until], hint) {
                    self.free.push(FreeStretch { from, until, direction });
                    continue;
                }
            }
            let width = until - from;
            match meets {
                Some(witness) if width <= resolution => {
                    return self.contact([from, until], witness);
                }
                None if width <= SHORTEST_STRETCH.min(resolution) => match self.at(until) {
                    Ok(witness) => {
                        return self.contact([from, until], witness);
                    }
                    Err(_) => return self.grazing([from, until]),
                },
                meets => {
                    let middle = from + width / 2.0;
                    match self.at(middle) {
                        Ok(witness) => {
                            open.clear();
                            open.push(Open { from, until: middle, hint: None, meets: Some(witness) });
                        }
                        Err(found) => {
                            let hint = found.or(hint);
                            open.push(Open { from: middle, until, hint, meets });
                            open.push(Open { from, until: middle, hint, meets: None });
                        }
                    }
                }
            }
        }
        match open.pop() {
            Some(Open { from, until, .. }) => self.grazing([from, until]),
            None => FirstContact::Separate { free: self.free },
        }
    }

    /// The stretches between times at which a part of a motion ends, the first one last.
    fn parts(&self) -> Vec<Open> {
        let mut times: Vec<f64> = self.motions.iter().flat_map(|motion| motion.breaks()).chain([0.0, 1.0]).collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        let parts = times.windows(2).rev();
        parts.map(|pair| Open { from: pair[0], until: pair[1], hint: None, meets: None }).collect()
    }

    /// A direction that proves a stretch, the first that does.
    fn separates(&self, times: [f64; 2], hint: Option<SeparatingDirection>) -> Option<SeparatingDirection> {
        let bounded = self.motions.map(|motion| motion.arc(times));
        let rounded = bounded.each_ref().map(Arc::rounded);
        let stretch = Stretch { bodies: self.bodies, arcs: bounded, margin: self.margin(times) };
        let proves = |direction: &SeparatingDirection| self.is_proved(&stretch, times, direction);
        if let Some(direction) = hint.filter(|direction| proves(direction)) {
            return Some(direction);
        }
        let ([a, b], [p, q]) = (self.bodies, rounded.each_ref());
        let [from, to] = [p.middle_of(&a.center()), q.middle_of(&b.center())];
        let first = [0, 1, 2].map(|k| to[k] - from[k]);
        let in_space = ControlZonotopes::in_space([a, b], [p, q]).separating_direction(first);
        let in_space = in_space.map(SeparatingDirection::Space).filter(|direction| proves(direction));
        if in_space.is_some() || rounded.iter().all(|arc| arc.is_translation) {
            return in_space;
        }
        let in_first = || ControlZonotopes::in_first([a, b], [p, q]).separating_direction(p.turned_back(&first));
        let in_second = || {
            let opposite = q.turned_back(&first).map(|c| -c);
            let found = ControlZonotopes::in_first([b, a], [q, p]).separating_direction(opposite);
            found.map(|u| u.map(|c| -c))
        };
        let in_first = in_first().map(SeparatingDirection::First).filter(|direction| proves(direction));
        let in_second = || in_second().map(SeparatingDirection::Second).filter(|direction| proves(direction));
        in_first.or_else(in_second).or_else(|| {
            let Some(SeparatingDirection::Space(u)) = hint else { return None };
            edges::normals(self.bodies, rounded.each_ref(), &u).find(|direction| proves(direction))
        })
    }

    /// Whether a direction proves a stretch: in doubles with bounds, or exactly where no coefficient is negative for
    /// certain.
    fn is_proved(&self, stretch: &Stretch<'_, Bounded>, times: [f64; 2], direction: &SeparatingDirection) -> bool {
        let bound = stretch.gap_along(direction);
        if bound.iter().all(|c| c.is_positive()) {
            return true;
        }
        // a bound that is infinite or NaN says nothing
        let is_refuted = |c: &Bounded| c.sign() == Some(-1) || (c.value, c.error) == (0.0, 0.0);
        if bound.iter().any(is_refuted) || !stretch.margin.is_finite() {
            return false;
        }
        let arcs = self.motions.map(|motion| motion.exact_arc(times));
        Stretch::<Dyadic> { bodies: self.bodies, arcs, margin: stretch.margin }.is_separated_by(direction)
    }

    /// A bound of how far points of both bodies together are off their places on a stretch.
    fn margin(&self, times: [f64; 2]) -> f64 {
        let off = [0, 1].map(|i| match self.motions[i].angle_off(times) {
            0.0 => 0.0,
            angle => (angle * self.reaches[i]).next_up(),
        });
        (off[0] + off[1]).next_up() * f64::from(u8::from(off != [0.0; 2]))
    }

    /// The proof that the bodies meet at a time, or else a direction that separates them as they are rounded then.
    fn at(&self, time: f64) -> Result<Witness, Option<SeparatingDirection>> {
        let [Some(p), Some(q)] = self.motions.map(|motion| motion.pose_at(time)) else { return Err(None) };
        let [a, b] = self.bodies;
        match a.at(&p).intersection(b.at(&q)) {
            Location::Outside(Separation::Rounded(u)) => Err(Some(SeparatingDirection::Space(u))),
            Location::Outside(Separation::Exact(_)) => Err(None),
            Location::Inside(witness) | Location::Boundary(witness) => {
                if self.is_meeting(time, &witness) {
                    return Ok(witness);
                }
                let arcs = self.motions.map(|motion| motion.arc([time; 2]).rounded());
                let completed = meeting::completed(self.bodies, arcs.each_ref(), witness);
                completed.filter(|witness| self.is_meeting(time, witness)).ok_or(None)
            }
        }
    }

    fn is_meeting(&self, time: f64, witness: &Witness) -> bool {
        let times = [time; 2];
        let [p, q] = self.motions.map(|motion| motion.arc(times));
        let angles_off = self.motions.map(|motion| motion.angle_off(times));
        let margin = self.margin(times);
        if meeting::is_certain(self.bodies, [&p, &q], witness, angles_off, margin) {
            return true;
        }
        let [p, q] = self.motions.map(|motion| motion.exact_arc(times));
        margin == 0.0 && angles_off == [0.0; 2] && meeting::is_proved(self.bodies, [&p, &q], witness)
    }

    /// The answer where the bodies meet at the second time.
    fn contact(self, time: [f64; 2], witness: Witness) -> FirstContact {
        let arcs = self.motions.map(|motion| motion.exact_arc([time[1]; 2]));
        let witness = meeting::with_nearest_basis(self.bodies, arcs.each_ref(), witness);
        FirstContact::Contact { free: self.free, time, witness }
    }

    /// The answer where a stretch is not decided.
    fn grazing(self, time: [f64; 2]) -> FirstContact {
        let distance_at_most = self.distance_at_most(time[1]).filter(|distance| !distance.is_nan());
        let distance_at_most = distance_at_most.unwrap_or(f64::INFINITY);
        FirstContact::Grazing { free: self.free, time, distance_at_most }
    }

    /// A bound above the distance of the bodies at a time: that of the rounded placements, and by how much rounding
    /// and a rotation at constant rate put them off.
    fn distance_at_most(&self, time: f64) -> Option<f64> {
        let [Some(p), Some(q)] = self.motions.map(|motion| motion.pose_at(time)) else { return None };
        let [a, b] = self.bodies;
        let distance = a.at(&p).distance(b.at(&q));
        let size = [(a, p), (b, q)].map(|(body, pose)| {
            let generators: f64 = body.generators().iter().map(sum_norm).sum();
            generators + sum_norm(&body.center()) + sum_norm(&pose.translation())
        });
        Some((distance + POSE_ROUNDING * (size[0] + size[1]) + self.margin([time; 2])).next_up())
    }
}
