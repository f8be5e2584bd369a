//! `sweep`: a zonotope around all placements of a zonotope that turns and translates.

use serde_json::{Value, json};
use zonotope::motion::space_time::{Method, Sweep, SweepError};

use crate::claimed::{Traced, float, member, vector, vectors};
use crate::fields::Fields;
use crate::json::vector_to_json;
use crate::kinds::{Kind, Solution};
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "sweep",
    summary: "a zonotope around all placements of one of space that turns about an axis and translates (Theorem 6.1)",
    fields: &["center", "generators", "axis_point", "axis", "angle", "translation"],
    optional: &[],
    methods: || Method::ALL.map(Method::id).to_vec(),
    solve,
    check,
};

fn solve(fields: &Fields<'_>, method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let named = |name| Method::from_id(name).expect("the kind lists the names of these methods");
    let method = method.map_or(Method::default(), named);
    let body = fields.zonotope::<3>()?;
    let [axis_point, axis] = [fields.vector("axis_point")?, fields.vector("axis")?];
    let sweep = Sweep::new(axis_point, axis, fields.number("angle")?, fields.vector("translation")?);
    let volume = sweep.and_then(|sweep| body.swept_by(&sweep, method)).map_err(refusal)?;
    let result = json!({
        "center": vector_to_json(&volume.center()),
        "generators": volume.generators().iter().map(|g| vector_to_json(g)).collect::<Value>(),
    });
    Ok(Solution { method: method.id(), result })
}

fn refusal(error: SweepError) -> Refusal {
    let code = match error {
        SweepError::ZeroAxis => Code::ZeroAxis,
        SweepError::NegativeAngle(_) => Code::BadAngle,
        SweepError::NonFinite(_) => Code::NonFinite,
        _ => Code::TooLarge,
    };
    Refusal::new(code, error.to_string())
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let asked = |name| vector(member(input, name)?, name);
    let question = verifier::Sweep {
        center: asked("center")?,
        generators: vectors(member(input, "generators")?, "generators")?,
        axis_point: asked("axis_point")?,
        axis: asked("axis")?,
        angle: float(input, "angle")?,
        translation: asked("translation")?,
    };
    let center = vector(member(result, "center")?, "center")?;
    let generators = vectors(member(result, "generators")?, "generators")?;
    Ok(verifier::check_sweep(&question, &center, &generators).in_words())
}
