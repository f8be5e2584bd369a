//! Bodies that move.

use super::Verdict;
use super::reading::{float, member, vector, vectors};
use super::traced::Traced;
use verifier::{Sweep, check_sweep};

pub(super) fn sweep(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let asked = |name| vector(member(input, name)?, name);
    let question = Sweep {
        center: asked("center")?,
        generators: vectors(member(input, "generators")?, "generators")?,
        axis_point: asked("axis_point")?,
        axis: asked("axis")?,
        angle: float(input, "angle")?,
        translation: asked("translation")?,
    };
    let center = vector(member(result, "center")?, "center")?;
    let generators = vectors(member(result, "generators")?, "generators")?;
    Ok(check_sweep(&question, &center, &generators).in_words())
}
