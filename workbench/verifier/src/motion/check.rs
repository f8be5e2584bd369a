//! Answers to "when do two moving zonotopes of space meet first".
//!
//! The intervals without contact follow each other from 0 to 1, or to where the contact or the doubt begins; in each a
//! direction separates the bodies at every time. At the end of a contact coefficients prove a common point; at that of
//! a grazing the nearest points are found.

use super::answer::{Encounter, FirstContactAnswer, FirstContactProof, FreeInterval, ProvedEnd};
use super::free::{MOST_WORK, Moving, Pair};
use super::gap::Solid;
use super::path::{Motion, Path};
use super::quaternion::Vector;
use crate::exact::grid::{Grid, check_finite};
use crate::exact::proportion::Proportion;
use crate::verdict::{Stop, Verdict};

/// A zonotope of space in motion.
#[derive(Debug, Clone, Copy)]
pub struct MovingBody<'a> {
    /// The centre at rest.
    pub center: &'a [f64],
    /// The generators at rest.
    pub generators: &'a [Vec<f64>],
    /// The motion.
    pub motion: &'a Motion,
}

/// Proves when two bodies meet first, or that they do not, or says what fails. A contact is between two times not
/// farther apart than the resolution.
pub fn check_first_contact(
    bodies: [MovingBody<'_>; 2],
    resolution: f64,
    answer: &FirstContactAnswer,
) -> Verdict<FirstContactProof> {
    proved(bodies, resolution, answer).into()
}

fn proved(
    bodies: [MovingBody<'_>; 2],
    resolution: f64,
    answer: &FirstContactAnswer,
) -> Result<FirstContactProof, Stop> {
    let pair = pair(bodies)?;
    let end = match &answer.encounter {
        Encounter::Separate => 1.0,
        Encounter::Contact { time, .. } | Encounter::Grazing { time, .. } => {
            check_times(*time)?;
            time[0]
        }
    };
    check_order(&answer.intervals, end)?;
    if let Encounter::Contact { time, .. } = answer.encounter {
        check_width(time, resolution)?;
    }
    // Short proofs first: a false one is refused before the long ones are made.
    let proved_end = match &answer.encounter {
        Encounter::Separate => ProvedEnd::Separate,
        Encounter::Contact { time, coefficients, basis } => {
            pair.prove_contact(time[1], coefficients, basis)?;
            ProvedEnd::Contact(*time)
        }
        Encounter::Grazing { time, distance_at_most } => {
            if distance_at_most.is_nan() || *distance_at_most < 0.0 {
                return Err(format!("`distance_at_most` is {distance_at_most:?}, no distance").into());
            }
            ProvedEnd::Grazing(*time, *distance_at_most)
        }
    };
    let mut work = MOST_WORK;
    let moving = Moving { solids: pair.solids.each_ref(), paths: &pair.paths };
    for interval in &answer.intervals {
        moving.prove_free(interval, &mut work)?;
    }
    if let ProvedEnd::Grazing([_, time], distance) = proved_end {
        pair.prove_near(time, distance)?;
    }
    Ok(FirstContactProof { intervals: answer.intervals.len(), end: proved_end })
}

/// The bodies and their motions in whole numbers.
fn pair(bodies: [MovingBody<'_>; 2]) -> Result<Pair, String> {
    for body in &bodies {
        let vectors = || std::iter::once(body.center).chain(body.generators.iter().map(Vec::as_slice));
        if vectors().any(|v| v.len() != 3) {
            return Err("answered a question about bodies that are not of space".to_owned());
        }
        check_finite("a body", vectors().flatten())?;
        body.motion.check_finite()?;
    }
    let numbers = bodies.iter().flat_map(|body| {
        let own = body.center.iter().chain(body.generators.iter().flatten()).copied();
        own.chain(body.motion.lengths())
    });
    let lengths = Grid::of(numbers);
    let vector = |v: &[f64]| -> Vector { std::array::from_fn(|k| lengths.units(v[k])) };
    let of = |body: &MovingBody<'_>| -> Result<(Solid, Path), String> {
        let path = Path::of(body.motion, lengths)?;
        let center = vector(body.center);
        let generators: Vec<Vector> = body.generators.iter().map(|g| vector(g)).collect();
        let reach = path.reach(&center, &generators);
        Ok((Solid { center, generators, corners: Vec::new(), reach }, path))
    };
    let [(first, from), (second, to)] = [of(&bodies[0])?, of(&bodies[1])?];
    Ok(Pair { solids: [first, second], paths: [from, to], exponent: lengths.exponent() })
}

pub(super) fn check_times([from, to]: [f64; 2]) -> Result<(), String> {
    let is_ordered = 0.0 <= from && from <= to && to <= 1.0;
    if is_ordered { Ok(()) } else { Err(format!("`time` is [{from:?}, {to:?}], not two times from 0 to 1 in order")) }
}

/// Refuses times of a contact that are farther apart than the resolution.
pub(super) fn check_width([from, to]: [f64; 2], resolution: f64) -> Result<(), String> {
    let width = Proportion::of_double(to).minus(&Proportion::of_double(from));
    if !resolution.is_finite() || width.compare(&Proportion::of_double(resolution)).is_gt() {
        return Err(format!("`time` is farther apart than the resolution {resolution:?}"));
    }
    Ok(())
}

/// Refuses intervals that do not follow each other from 0 to an end, and directions that are not finite.
fn check_order(intervals: &[FreeInterval], end: f64) -> Result<(), String> {
    let mut reached = 0.0;
    for interval in intervals {
        if interval.from != reached {
            return Err(format!(
                "certificate: an interval begins at {:?}, where {reached:?} is reached",
                interval.from
            ));
        }
        check_interval(interval)?;
        reached = interval.to;
    }
    if reached == end {
        return Ok(());
    }
    Err(format!("certificate: the intervals end at {reached:?}, not at {end:?}"))
}

/// Refuses an interval that ends before it begins, and a direction that is not finite.
pub(super) fn check_interval(FreeInterval { from, to, direction }: &FreeInterval) -> Result<(), String> {
    use super::answer::MovingDirection::{A, B, Edges, Space};
    if from.partial_cmp(to) != Some(std::cmp::Ordering::Less) {
        return Err(format!("certificate: an interval goes from {from:?} to {to:?}"));
    }
    match direction {
        Space(u) | A(u) | B(u) => check_finite("certificate: a direction", u),
        Edges(edges) => check_finite("certificate: a direction", edges.iter().flatten()),
    }
}
