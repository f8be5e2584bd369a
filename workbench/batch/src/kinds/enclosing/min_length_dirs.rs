//! `min_length_dirs`: the smallest zonotope along given directions that contains points.

use serde_json::{Value, json};
use zonotope::enclosing::fixed_directions::{Enclosure, FixedDirections, FixedDirectionsError, Method};
use zonotope::numeric::Rational;

use super::forces::forces;
use super::outer::OuterPoints;
use crate::claimed::{Traced, exact_numbers, float, indices, member, text, vector, vectors};
use crate::dimension::refused;
use crate::fields::Fields;
use crate::json::{to_json, vector_to_json};
use crate::kinds::{Kind, Solution};
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "min_length_dirs",
    summary: "the smallest zonotope along given directions that contains points",
    fields: &["points", "directions", "weights"],
    optional: &[],
    methods: || Method::ALL.map(Method::id).to_vec(),
    solve,
    check,
};

/// The most coordinates that a point may have.
const COORDINATE_LIMIT: usize = 4;

/// The most directions that are taken.
const DIRECTION_LIMIT: usize = 1000;

/// The most pairs of a point and a direction that are taken, or of a point and a facet normal by the methods that go
/// through all facet normals.
const PAIR_LIMIT: u64 = 1_000_000_000;

/// The most entries of a linear program that a method writes out.
const ENTRY_LIMIT: u64 = 4_000_000;

fn solve(fields: &Fields<'_>, method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let named = |name| Method::from_id(name).expect("the kind lists the names of these methods");
    let method = method.map_or(Method::default(), named);
    let of_points = fields.dimension_of_first("points")?;
    let (dimension, named) = match (of_points, fields.dimension_of_first("directions")?) {
        (Some(dimension), _) => (dimension, "point 1"),
        (None, Some(dimension)) => (dimension, "direction 1"),
        (None, None) => (2, "point 1"),
    };
    let result = match dimension {
        #[cfg(feature = "every-dimension")]
        1 => in_space::<1>(fields, method)?,
        2 => in_space::<2>(fields, method)?,
        3 => in_space::<3>(fields, method)?,
        #[cfg(feature = "every-dimension")]
        4 => in_space::<4>(fields, method)?,
        other => return Err(refused(named, other, COORDINATE_LIMIT)),
    };
    Ok(Solution { method: method.id(), result })
}

fn in_space<const D: usize>(fields: &Fields<'_>, method: Method) -> Result<Value, Refusal> {
    let outer = OuterPoints::of(fields.vectors::<D>("points")?);
    let directions = fields.vectors::<D>("directions")?;
    let weights = fields.numbers("weights")?;
    let problem = FixedDirections::new(outer.points(), &directions, &weights).map_err(|error| refusal(&error))?;
    check_size(&problem, &outer.described(), method)?;
    let enclosure = method.solve(&problem, &mut ());
    enclosure.map(|enclosure| result(&outer, &enclosure)).map_err(|error| refusal(&error))
}

/// The result of an answer, as it is written.
fn result<const D: usize>(points: &OuterPoints<D>, enclosure: &Enclosure<D>) -> Value {
    let exact = |v: &[Rational; D]| v.iter().map(|c| Value::from(c.to_string())).collect::<Value>();
    match enclosure {
        Enclosure::Optimal(zonotope) => {
            let forces = zonotope.multipliers.iter();
            let forces: Vec<Value> = forces
                .map(|force| json!({"point": points.place(force.point), "vector": exact(&force.vector)}))
                .collect();
            json!({
                "status": if zonotope.is_optimal() { "optimal" } else { "feasible" },
                "value": to_json(zonotope.value),
                "center": vector_to_json(&zonotope.center),
                "coefficients": vector_to_json(&zonotope.coefficients),
                "lower_bound": to_json(zonotope.lower_bound),
                "certificate": {"forces": forces},
            })
        }
        Enclosure::Infeasible(proof) => json!({
            "status": "infeasible",
            "certificate": {
                "points": proof.points.map(|point| points.place(point)),
                "functional": exact(&proof.functional),
            },
        }),
    }
}

fn refusal(error: &FixedDirectionsError) -> Refusal {
    let (code, message) = match error {
        FixedDirectionsError::WeightCount { .. } => (Code::LengthMismatch, error.to_string()),
        FixedDirectionsError::NegativeWeight { direction, weight } => {
            (Code::NegativeWeight, format!("weight {} is {weight:?}, which is negative", direction + 1))
        }
        FixedDirectionsError::Empty => (Code::Empty, error.to_string()),
        other => (Code::TooLarge, other.to_string()),
    };
    Refusal::new(code, message)
}

fn check_size<const D: usize>(problem: &FixedDirections<'_, D>, points: &str, method: Method) -> Result<(), Refusal> {
    let (n, k) = (problem.points().len() as u64, problem.directions().len() as u64);
    let too_large = |message: String| Err(Refusal::new(Code::TooLarge, message));
    if k > DIRECTION_LIMIT as u64 {
        return too_large(format!("{k} directions, at most {DIRECTION_LIMIT} are taken"));
    }
    let normals = if method == Method::default() { k } else { facet_normals::<D>(k) };
    if n.saturating_mul(normals) > PAIR_LIMIT {
        let what = if method == Method::default() { "directions" } else { "facet normals" };
        return too_large(format!(
            "{points} and {normals} {what} make more than the {PAIR_LIMIT} pairs that are taken"
        ));
    }
    let entries = match method {
        #[cfg(feature = "linear-programming")]
        Method::SupportForm => normals.saturating_mul(2 * (k + D as u64)),
        #[cfg(feature = "linear-programming")]
        Method::PapersProgram => n.min(2 * normals).saturating_mul(k * (D as u64 + 4)),
        _ => 0,
    };
    if entries > ENTRY_LIMIT {
        return too_large(format!(
            "the linear program has {entries} entries, at most {ENTRY_LIMIT} are taken by this method"
        ));
    }
    Ok(())
}

/// A bound for the number of facets, opposite ones counted once, of a zonotope with k generators.
fn facet_normals<const D: usize>(k: u64) -> u64 {
    (0..D as u64 - 1).fold(1_u64, |count, i| count.saturating_mul(k.saturating_sub(i)) / (i + 1))
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let question = verifier::Directed {
        points: vectors(member(input, "points")?, "points")?,
        directions: vectors(member(input, "directions")?, "directions")?,
        weights: vector(member(input, "weights")?, "weights")?,
    };
    let certificate = member(result, "certificate")?;
    let status = text(result, "status")?;
    let answer = match status {
        "optimal" | "feasible" => verifier::DirectedAnswer::Optimal {
            value: float(result, "value")?,
            center: vector(member(result, "center")?, "center")?,
            coefficients: vector(member(result, "coefficients")?, "coefficients")?,
            lower_bound: float(result, "lower_bound")?,
            forces: forces(certificate, exact_numbers)?,
        },
        "infeasible" => verifier::DirectedAnswer::Infeasible {
            points: <[usize; 2]>::try_from(indices(certificate, "points")?)
                .map_err(|_| "certificate: `points` are not two points")?,
            functional: exact_numbers(member(certificate, "functional")?)
                .ok_or("`functional` is not a list of exact numbers")?,
        },
        other => return Err(format!("there is no status `{other}`")),
    };
    let check =
        if status == "feasible" { verifier::check_min_length_dirs_feasible } else { verifier::check_min_length_dirs };
    Ok(check(&question, &answer).in_words())
}
