//! The check of `collide`: the stretches without contact and what the bodies do after them.

use crate::claimed::{Placed, Traced, float, indices, member, text, vector, vectors};
use verifier::{
    Encounter, FirstContactAnswer, FreeInterval, Motion, MotionPiece, MovingBody, MovingDirection, Verdict,
    check_first_contact,
};

/// The resolution of a question that names none: 2^-30.
const RESOLUTION: f64 = 1.0 / (1u64 << 30) as f64;

pub(super) fn check(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let motions = member(input, "motion")?;
    let [a, b] = [body(input, "a")?, body(input, "b")?];
    let [of_a, of_b] = [motion(motions, "a")?, motion(motions, "b")?];
    let bodies = [moving(&a, &of_a), moving(&b, &of_b)];
    Ok(check_first_contact(bodies, resolution(input)?, &answer(result)?).in_words())
}

/// The resolution of a question.
pub(super) fn resolution(input: Traced<'_>) -> Result<f64, String> {
    if input.field("resolution").is_some() { float(input, "resolution") } else { Ok(RESOLUTION) }
}

/// The centre and the generators of a body where its pose puts it.
type Image = (Vec<f64>, Vec<Vec<f64>>);

fn moving<'a>((center, generators): &'a Image, motion: &'a Motion) -> MovingBody<'a> {
    MovingBody { center, generators, motion }
}

fn body(input: Traced<'_>, name: &str) -> Result<Image, String> {
    Placed::read(member(input, name)?, "center")?.image()
}

/// The fields of an answer of its status: others are not read, so they are not called right.
fn answer(result: Traced<'_>) -> Result<FirstContactAnswer, String> {
    let certificate = member(result, "certificate")?;
    let encounter = match text(result, "status")? {
        "separate" => Encounter::Separate,
        "contact" => Encounter::Contact {
            time: numbers(result, "time")?,
            coefficients: vector(member(certificate, "coefficients")?, "coefficients")?,
            basis: indices(certificate, "basis")?,
        },
        "grazing" => {
            Encounter::Grazing { time: numbers(result, "time")?, distance_at_most: float(result, "distance_at_most")? }
        }
        other => return Err(format!("there is no status `{other}`")),
    };
    let intervals = member(certificate, "intervals")?.elements().ok_or("`intervals` is not a list")?;
    Ok(FirstContactAnswer { encounter, intervals: intervals.map(interval).collect::<Result<_, _>>()? })
}

/// A stretch with its direction.
pub(super) fn interval(tree: Traced<'_>) -> Result<FreeInterval, String> {
    let direction = match text(tree, "frame")? {
        "space" => MovingDirection::Space(numbers(tree, "direction")?),
        "a" => MovingDirection::A(numbers(tree, "direction")?),
        "b" => MovingDirection::B(numbers(tree, "direction")?),
        "edges" => {
            let edges = vectors(member(tree, "direction")?, "direction")?;
            let edges: Option<Vec<[f64; 3]>> = edges.into_iter().map(|edge| edge.try_into().ok()).collect();
            let edges = edges.and_then(|edges| edges.try_into().ok());
            MovingDirection::Edges(edges.ok_or("`direction` is not two edges")?)
        }
        other => return Err(format!("there is no frame `{other}`")),
    };
    Ok(FreeInterval { from: float(tree, "from")?, to: float(tree, "to")?, direction })
}

/// As many finite numbers as are expected.
pub(super) fn numbers<const N: usize>(object: Traced<'_>, name: &str) -> Result<[f64; N], String> {
    let found = vector(member(object, name)?, name)?;
    let count = found.len();
    found.try_into().map_err(|_| format!("`{name}` has {count} numbers, not {N}"))
}

/// The motion of a body, which rests where none is stated.
pub(super) fn motion(motions: Traced<'_>, name: &str) -> Result<Motion, String> {
    let Some(motion) = motions.field(name) else { return Ok(Motion::Rest) };
    let Some(pieces) = motion.field("pieces") else {
        return Ok(Motion::ConstantRate {
            axis_point: numbers(motion, "axis_point")?,
            axis: numbers(motion, "axis")?,
            angle: float(motion, "angle")?,
            translation: numbers(motion, "translation")?,
        });
    };
    let piece = |piece: Traced<'_>| {
        Ok(MotionPiece {
            until: float(piece, "until")?,
            from: numbers(piece, "from")?,
            to: numbers(piece, "to")?,
            axis_point: numbers(piece, "axis_point")?,
            translation: numbers(piece, "translation")?,
        })
    };
    let pieces = pieces.elements().ok_or("`pieces` is not a list")?;
    pieces.map(piece).collect::<Result<_, String>>().map(Motion::Pieces)
}
