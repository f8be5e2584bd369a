//! Motions as questions state them, a rotation at constant rate or pieces with a quaternion at either end, and the
//! resolution of a contact.

use zonotope::motion::continuous::by_control_points::{DEFAULT_RESOLUTION, FINEST_RESOLUTION};
use zonotope::motion::{Motion, MotionError, MotionPiece};

use crate::fields::Fields;
use crate::json::Tree;
use crate::place::Place;
use crate::refusal::{Code, Refusal};

/// The fields of a rotation at constant rate.
const CONSTANT_RATE: [&str; 4] = ["axis_point", "axis", "angle", "translation"];

/// The field of a motion of pieces.
const PIECES: [&str; 1] = ["pieces"];

/// The fields of a piece.
const PIECE: [&str; 5] = ["until", "from", "to", "axis_point", "translation"];

/// The most pieces of a motion: each is applied after those before it, exactly, so that its numbers are as much longer.
const PIECE_LIMIT: usize = 1_000;

/// The motion of an object that holds one as a question has it, under `motion`; without one the body rests.
///
/// # Errors
/// A refusal that names the place in the motion.
pub fn read_motion(holder: &Tree) -> Result<Motion, Refusal> {
    motion(&Fields::of_input(holder, &[], &["motion"])?, "motion")
}

/// The motion under a name that may be absent: then the body rests.
pub(super) fn motion(fields: &Fields<'_>, name: &str) -> Result<Motion, Refusal> {
    if !fields.has(name) {
        return Ok(Motion::rest());
    }
    let either = [&CONSTANT_RATE[..], &PIECES].concat();
    let made = if fields.object(name, &[], &either)?.has("pieces") {
        Motion::from_pieces(&pieces(&fields.object(name, &PIECES, &[])?)?)
    } else {
        let motion = fields.object(name, &CONSTANT_RATE, &[])?;
        let (point, axis) = (motion.vector("axis_point")?, motion.vector("axis")?);
        Motion::constant_rate(point, axis, motion.number("angle")?, motion.vector("translation")?)
    };
    made.map_err(|error| refused(&fields.place_of(name), error))
}

fn pieces(motion: &Fields<'_>) -> Result<Vec<MotionPiece>, Refusal> {
    let pieces = motion.objects("pieces", &PIECE)?;
    if pieces.len() > PIECE_LIMIT {
        let message = format!("{} {}, at most {PIECE_LIMIT} are taken", pieces.len(), motion.place_of("pieces"));
        return Err(Refusal::new(Code::TooLarge, message));
    }
    let piece = |piece: &Fields<'_>| {
        Ok(MotionPiece {
            until: piece.number("until")?,
            from: piece.vector("from")?,
            to: piece.vector("to")?,
            axis_point: piece.vector("axis_point")?,
            translation: piece.vector("translation")?,
        })
    };
    pieces.iter().map(piece).collect()
}

/// The refusal of numbers that are no motion; pieces count from 1.
fn refused(place: &Place, error: MotionError) -> Refusal {
    let piece = |part: usize| format!("{place}, piece {}", part + 1);
    match error {
        MotionError::NonFinite(_) => Refusal::new(Code::NonFinite, format!("{place}: {error}")),
        MotionError::ZeroAxis => {
            Refusal::new(Code::ZeroAxis, format!("{place}, axis is zero: a rotation needs an axis"))
        }
        MotionError::ZeroQuaternion { part } => {
            Refusal::new(Code::ZeroAxis, format!("{}: a quaternion is zero and turns about no axis", piece(part)))
        }
        MotionError::OppositeQuaternions { part } => {
            let message = format!(
                "{}: `from` and `to` are more than half a turn apart; with the negative of one of them they are nearer",
                piece(part)
            );
            Refusal::new(Code::BadAngle, message)
        }
        MotionError::Times { part, until } => {
            let message = format!("{}: the time {until:?} does not go up, from above 0 to 1 at the last", piece(part));
            Refusal::bad_input(message)
        }
        other => Refusal::bad_input(format!("{place}: {other}")),
    }
}

/// The resolution of a question, or the default.
pub(super) fn resolution(fields: &Fields<'_>) -> Result<f64, Refusal> {
    if !fields.has("resolution") {
        return Ok(DEFAULT_RESOLUTION);
    }
    let resolution = fields.number("resolution")?;
    if (FINEST_RESOLUTION..1.0).contains(&resolution) {
        return Ok(resolution);
    }
    let message = format!("resolution is {resolution:?}, not from {FINEST_RESOLUTION:?} to below 1");
    Err(Refusal::new(Code::BadEpsilon, message))
}
