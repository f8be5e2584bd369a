//! `support`: how far a zonotope reaches in a direction, and a point where it does.

use serde_json::json;
use zonotope::numeric::dyadic::Dyadic;
use zonotope::support_of;

use crate::claimed::{Placed, Traced, float, member, point, vector};
use crate::dimension::{MAX_DIMENSION, refused};
use crate::fields::Fields;
use crate::json::{to_json, vector_to_json};
use crate::kinds::{Kind, Solution};
use crate::placement::{ExactPlacement, nearest};
use crate::refusal::Refusal;

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "support",
    summary: "how far a zonotope reaches in a direction, and a point where it does",
    fields: &["direction", "center", "generators"],
    optional: &["pose"],
    methods: || vec![BY_SIGNS],
    solve,
    check,
};

const BY_SIGNS: &str = "by_signs";

/// The most coordinates of bodies without a pose: the sums are the same in any number of dimensions.
const COORDINATE_LIMIT: usize = 10_000;

fn solve(fields: &Fields<'_>, _method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let dimension = fields.dimension("direction")?;
    let limit = if fields.has_pose() { MAX_DIMENSION } else { COORDINATE_LIMIT };
    if !(1..=limit).contains(&dimension) {
        return Err(refused("direction", dimension, limit));
    }
    let direction = fields.vector_of("direction", dimension)?;
    let center = fields.vector_of("center", dimension)?;
    let generators = fields.vectors_of("generators", dimension)?;
    let (value, point) = if fields.has_pose() {
        posed(&fields.placement(dimension)?.exact(), &direction, &center, &generators)
    } else {
        support_of(&direction, &center, generators.iter().map(Vec::as_slice))
    };
    let result = json!({"value": to_json(value.to_f64()), "point": vector_to_json(&nearest(&point))});
    Ok(Solution { method: BY_SIGNS, result })
}

/// The support value of the image of a body and the point where it is taken, exactly.
fn posed(
    placement: &ExactPlacement,
    direction: &[f64],
    center: &[f64],
    generators: &[Vec<f64>],
) -> (Dyadic, Vec<Dyadic>) {
    let direction: Vec<Dyadic> = direction.iter().map(|&u| Dyadic::from_f64(u)).collect();
    let along = |v: &[Dyadic]| direction.iter().zip(v).fold(Dyadic::zero(), |sum, (u, x)| sum + u * x);
    let mut point = placement.point(center);
    for generator in generators {
        let image = placement.vector(generator);
        let is_against = along(&image).sign().is_lt();
        for (sum, x) in point.iter_mut().zip(image) {
            *sum = if is_against { &*sum - &x } else { &*sum + &x };
        }
    }
    (along(&point), point)
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let direction = vector(member(input, "direction")?, "direction")?;
    let body = Placed::read(input, "center")?;
    // A coordinate beyond the range of doubles is an infinity.
    let point = point(member(result, "point")?, "point")?;
    let answer = verifier::SupportAnswer { value: float(result, "value")?, point };
    Ok(verifier::check_support(&direction, &body.body(), &answer).in_words())
}
