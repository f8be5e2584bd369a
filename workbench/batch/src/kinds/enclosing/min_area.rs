//! `min_area`: the zonogon of least area that contains points of the plane.

use serde_json::{Value, json};
use zonotope::enclosing::min_area_zonogon::{Method, MinAreaError, MinAreaZonogon};
use zonotope::hull::HullError;

use crate::claimed::{Traced, exact_numbers, float, indices, member, planar, text, vector};
use crate::fields::Fields;
use crate::json::{to_json, vector_to_json};
use crate::kinds::{Kind, Solution};
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "min_area",
    summary: "the zonogon of least area that contains points of the plane",
    fields: &["points"],
    optional: &[],
    methods: || Method::ALL.map(Method::id).to_vec(),
    solve,
    check,
};

fn solve(fields: &Fields<'_>, method: Option<&'static str>, seed: u64) -> Result<Solution, Refusal> {
    let points = fields.vectors::<2>("points")?;
    let named = |name| Method::from_id(name).expect("the kind lists the names of these methods");
    let method = method.map_or(Method::default(), named);
    let found = method.solve(&points, seed, &mut ()).map_err(|error| {
        let code = match error {
            MinAreaError::Points(HullError::Empty) => Code::Empty,
            _ => Code::TooLarge,
        };
        Refusal::new(code, error.to_string())
    })?;
    Ok(Solution { method: method.id(), result: result(&found) })
}

/// The result of a `min_area` answer, as it is written.
pub fn result(found: &MinAreaZonogon) -> Value {
    let generators: Vec<Value> = found.body.generators().iter().map(|generator| vector_to_json(generator)).collect();
    let farthest: Vec<usize> = found.proof.farthest().iter().map(|farthest| farthest.vertex().get()).collect();
    json!({
        "area": to_json(found.value),
        "center": vector_to_json(&found.body.center()),
        "generators": generators,
        "lower_bound": to_json(found.lower_bound),
        "certificate": {
            "hull": found.proof.hull().indices().iter().map(|index| index.get()).collect::<Vec<usize>>(),
            "farthest": farthest,
            "coefficients": found.proof.certificate().signs,
            "basis": found.proof.certificate().basis.iter().map(|edge| edge.position()).collect::<Vec<usize>>(),
        },
    })
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let points = planar(member(input, "points")?, "points")?;
    let answer = min_area_answer(result)?;
    let verdict = verifier::check_min_area(&points, &answer).in_words();
    let (verifier::Verdict::Right(proved), Some(exact)) = (&verdict, result.field("exact")) else { return Ok(verdict) };
    verifier::check_exact_min_area(&points, &answer.certificate, &exact_min_area(exact)?).proof()?;
    Ok(verifier::Verdict::Right(format!("{proved}; the exact optimum is one")))
}

fn exact_min_area(exact: Traced<'_>) -> Result<verifier::ExactMinArea, String> {
    let point = |value: Traced<'_>, name: &str| {
        let numbers = exact_numbers(value).and_then(|numbers| <[verifier::Fraction; 2]>::try_from(numbers).ok());
        numbers.ok_or_else(|| format!("exact: `{name}` holds something else than pairs of exact numbers"))
    };
    let generators = member(exact, "generators")?.elements().ok_or("exact: `generators` is not a list")?;
    Ok(verifier::ExactMinArea {
        area: verifier::Fraction::parse(text(exact, "area")?).ok_or("exact: `area` is not an exact number")?,
        center: point(member(exact, "center")?, "center")?,
        generators: generators.map(|value| point(value, "generators")).collect::<Result<_, _>>()?,
    })
}

fn min_area_answer(result: Traced<'_>) -> Result<verifier::MinAreaAnswer, String> {
    let center = vector(member(result, "center")?, "center")?;
    let certificate = member(result, "certificate")?;
    Ok(verifier::MinAreaAnswer {
        area: float(result, "area")?,
        center: <[f64; 2]>::try_from(center).map_err(|_| "center is not a point of the plane")?,
        generators: planar(member(result, "generators")?, "generators")?,
        lower_bound: float(result, "lower_bound")?,
        certificate: verifier::Certificate {
            hull: indices(certificate, "hull")?,
            farthest: indices(certificate, "farthest")?,
            coefficients: vector(member(certificate, "coefficients")?, "coefficients")?,
            basis: indices(certificate, "basis")?,
        },
    })
}
