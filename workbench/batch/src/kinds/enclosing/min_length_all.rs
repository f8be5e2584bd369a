//! `min_length_all`: the zonotope of least total length that contains points, along any directions.

use serde_json::{Value, json};
use zonotope::enclosing::min_total_length::{Method, MinLengthError, MinLengthZonotope, Outcome, few_generators};

use super::forces::forces;
use super::outer::OuterPoints;
use crate::claimed::{Traced, boolean, float, index, member, vector, vectors};
use crate::dimension::refused;
use crate::fields::Fields;
use crate::json::{to_json, vector_to_json};
use crate::kinds::{Kind, Solution};
use crate::nearest::did_you_mean;
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "min_length_all",
    summary: "the zonotope of least total length that contains points, within a proven ratio",
    fields: &["points", "epsilon"],
    optional: &["max_generators", "objective"],
    methods: || Method::ALL.map(Method::id).to_vec(),
    solve,
    check,
};

/// The most points that are taken in 1, 2, … dimensions; of more in the plane and in space, the most corners of their
/// hull.
const POINT_LIMITS: [usize; 4] = [2_000_000, 200_000, 200_000, 20_000];

fn solve(fields: &Fields<'_>, method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let named = |name| Method::from_id(name).expect("the kind lists the names of these methods");
    let method = method.map_or(Method::default(), named);
    let is_volume = match fields.optional_text("objective")? {
        None | Some("length") => false,
        Some("volume") => true,
        Some(other) => {
            let near = did_you_mean(other, ["length", "volume"]);
            return Err(Refusal::bad_input(format!("`objective` is \"{other}\", neither length nor volume{near}")));
        }
    };
    let result = match fields.dimension_of_first("points")?.unwrap_or(2) {
        3 if is_volume => of_less_volume(fields, method)?,
        other if is_volume => {
            let message = format!("points with {other} coordinates, the volume is made less around points with 3");
            return Err(Refusal::bad_input(message));
        }
        #[cfg(feature = "every-dimension")]
        1 => of_length::<1>(fields, method)?,
        2 => of_length::<2>(fields, method)?,
        3 => of_length::<3>(fields, method)?,
        #[cfg(feature = "every-dimension")]
        4 => of_length::<4>(fields, method)?,
        other => return Err(refused("point 1", other, POINT_LIMITS.len())),
    };
    Ok(Solution { method: method.id(), result })
}

/// A zonotope that is nearly of least total length.
fn of_length<const D: usize>(fields: &Fields<'_>, method: Method) -> Result<Value, Refusal> {
    let (points, found) = in_space::<D>(fields, method)?;
    Ok(result(&points, &found))
}

/// A zonotope whose volume is a local minimum, with its volume.
fn of_less_volume(fields: &Fields<'_>, method: Method) -> Result<Value, Refusal> {
    let (points, answer) = in_space::<3>(fields, method)?;
    let found = few_generators::of_less_volume(points.points(), answer, fields.number("epsilon")?);
    let mut result = result(&points, &found);
    result["volume"] = to_json(found.body.exact_volume().to_f64());
    Ok(result)
}

/// The points that were enclosed and the answer about them.
type Found<const D: usize> = (OuterPoints<D>, MinLengthZonotope<D>);

fn in_space<const D: usize>(fields: &Fields<'_>, method: Method) -> Result<Found<D>, Refusal> {
    let outer = OuterPoints::of(fields.vectors::<D>("points")?);
    let points = outer.points();
    let epsilon = fields.number("epsilon")?;
    let count = fields.optional_count("max_generators")?;
    let most = POINT_LIMITS[D - 1];
    if points.len() > most {
        let message = format!(
            "{}, at most {most} are taken in {D} dimensions; along given directions, such as `enclose --directions \
             net:4` or the kind `min_length_dirs` has, more are, and a sample of them is enclosed sooner",
            outer.described()
        );
        return Err(Refusal::new(Code::TooLarge, message));
    }
    let found = method.solve(points, epsilon, &mut ()).and_then(|answer| match count {
        None => Ok(few_generators::fewest(points, answer, epsilon)),
        Some(count) => {
            few_generators::shortest_of_few(points, answer, epsilon, usize::try_from(count).unwrap_or(usize::MAX))
        }
    });
    let found = found.map_err(|error| {
        let code = match error {
            MinLengthError::Empty => Code::Empty,
            MinLengthError::BadEpsilon(_) => Code::BadEpsilon,
            MinLengthError::TooFewGenerators { .. } => Code::BadInput,
            _ => Code::TooLarge,
        };
        Refusal::new(code, error.to_string())
    })?;
    Ok((outer, found))
}

/// The result of an answer, as it is written.
fn result<const D: usize>(points: &OuterPoints<D>, found: &MinLengthZonotope<D>) -> Value {
    let generators: Vec<Value> = found.body.generators().iter().map(|g| vector_to_json(g)).collect();
    let forces = found.proof.multipliers.iter();
    let forces: Vec<Value> = forces
        .map(|force| json!({"point": points.place(force.point), "vector": vector_to_json(&force.vector)}))
        .collect();
    json!({
        "length": to_json(found.value),
        "center": vector_to_json(&found.body.center()),
        "generators": generators,
        "lower_bound": to_json(found.lower_bound),
        "ratio": to_json(found.ratio()),
        "within_epsilon": found.proof.outcome == Outcome::WithinEpsilon,
        "certificate": {"forces": forces},
    })
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let points = vectors(member(input, "points")?, "points")?;
    let answer = verifier::MinLengthAnswer {
        length: float(result, "length")?,
        center: vector(member(result, "center")?, "center")?,
        generators: vectors(member(result, "generators")?, "generators")?,
        lower_bound: float(result, "lower_bound")?,
        ratio: float(result, "ratio")?,
        within_epsilon: result.field("within_epsilon").map(|_| boolean(result, "within_epsilon")).transpose()?,
        forces: forces(member(result, "certificate")?, |tree| vector(tree, "vector").ok())?,
    };
    let epsilon = float(input, "epsilon")?;
    let is_volume = match input.field("objective").map(Traced::text) {
        None | Some(Some("length")) => false,
        Some(Some("volume")) => true,
        Some(_) => {
            return Ok(verifier::Verdict::Unchecked(
                "the question's `objective` is neither length nor volume".to_owned(),
            ));
        }
    };
    let is_counted = input.field("max_generators").is_some();
    // Who bounds the number of generators, or wants a small volume, gets the ratio that is found, whatever it is.
    if !is_volume && !is_counted {
        return Ok(verifier::check_min_length_all(&points, epsilon, &answer).in_words());
    }
    if is_counted && answer.generators.len() > index(input, "max_generators")? {
        return Err(format!("{} generators, more than `max_generators`", answer.generators.len()));
    }
    let verdict = verifier::check_min_length_all_at_any_ratio(&points, epsilon, &answer).in_words();
    let (verifier::Verdict::Right(proved), true) = (&verdict, is_volume) else { return Ok(verdict) };
    let volume = float(result, "volume")?;
    Ok(match verifier::check_measure(&answer.generators, volume).in_words() {
        verifier::Verdict::Right(_) => {
            verifier::Verdict::Right(format!("{proved}; volume {volume:?}, not proven to be the least"))
        }
        other => other,
    })
}
