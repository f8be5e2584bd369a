//! `distance`: how far apart two zonotopes are, or how deep they overlap.

use serde_json::{Value, json};
use zonotope::collision::distance::by_support_simplex::proximity;
use zonotope::collision::distance::penetration::{self, by_inner_polytope};
use zonotope::collision::distance::{Contact, Gap, Method, Penetration, Proximity, Touching, contact};
use zonotope::collision::{Location, Query, Status, Witness, by_lad};

use super::posed::{Hidden, Posed, Prism};
use super::{certificate, proof};
use crate::claimed::{Placed, Traced, exact_numbers, float, indices, member, point, text, vector};
use crate::dimension::refused;
use crate::fields::Fields;
use crate::json::{to_json, vector_to_json};
use crate::kinds::{BODY, Kind, PLACED, Solution};
use crate::refusal::{Code, Refusal};

pub(in crate::kinds) const KIND: Kind = Kind {
    name: "distance",
    summary: "how far apart two zonotopes are, their nearest points, or how deep they overlap",
    fields: &["a", "b"],
    optional: &[],
    methods: || vec![METHOD],
    solve,
    check,
};

const METHOD: &str = Method::BySupportSimplex.id();

/// The name of what a common point of two bodies is in, where their interiors meet.
const INTERIOR: &str = "interior";

/// The most generators of bodies that overlap, in 1, 2, … dimensions: how deep they overlap takes more than one pass.
const OVERLAP_LIMITS: [usize; 3] = [2_000_000, 200_000, 100_000];

fn solve(fields: &Fields<'_>, _method: Option<&'static str>, _seed: u64) -> Result<Solution, Refusal> {
    let bodies = [fields.object("a", &BODY, &PLACED)?, fields.object("b", &BODY, &PLACED)?];
    let has_pose = bodies.iter().any(Fields::has_pose);
    let result = match bodies[0].dimension("center")? {
        #[cfg(feature = "every-dimension")]
        1 if has_pose => under_poses::<1>(&bodies)?,
        2 if has_pose => under_poses::<2>(&bodies)?,
        3 if has_pose => under_poses::<3>(&bodies)?,
        #[cfg(feature = "every-dimension")]
        1 => in_space::<1>(&bodies)?,
        2 => in_space::<2>(&bodies)?,
        3 => in_space::<3>(&bodies)?,
        other => return Err(refused("the center of a", other, OVERLAP_LIMITS.len())),
    };
    Ok(Solution { method: METHOD, result })
}

fn in_space<const D: usize>(bodies: &[Fields<'_>; 2]) -> Result<Value, Refusal> {
    let [a, b] = [bodies[0].zonotope::<D>()?, bodies[1].zonotope::<D>()?];
    let query = Query::between(&a, &b);
    let location = by_lad::locate(&query, &mut ()).with_nearest_basis(&query);
    refuse_overlap(&location, query.len())?;
    let found = proximity(&query, &mut ());
    Ok(match (&found, contact(&query, &found)) {
        (Proximity::Disjoint(gap), _) => of_gap(gap, &Hidden::NONE, &location),
        (_, contact) => of_contact(contact, &penetration::of_query(&query), &Hidden::NONE, &location),
    })
}

fn under_poses<const D: usize>(bodies: &[Fields<'_>; 2]) -> Result<Value, Refusal> {
    let [a, b] = [Posed::<D>::read(&bodies[0], "center")?, Posed::read(&bodies[1], "center")?];
    let prism = Prism::over(&a, &b);
    let (query, hidden) = (prism.query(), prism.hidden());
    let location = hidden.location(&by_lad::locate(&query, &mut ()).with_nearest_basis(&query));
    refuse_overlap(&location, a.body.generators().len() + b.body.generators().len())?;
    let found = proximity(&query, &mut ());
    Ok(match (&found, contact(&query, &found)) {
        (Proximity::Disjoint(gap), _) => of_gap(gap, hidden, &location),
        (_, contact) => of_contact(contact, &by_inner_polytope::penetration(&query, &mut ()), hidden, &location),
    })
}

fn refuse_overlap<const D: usize>(location: &Location<D>, generators: usize) -> Result<(), Refusal> {
    let most = OVERLAP_LIMITS[D - 1];
    if location.status() != Status::Inside || generators <= most {
        return Ok(());
    }
    let message = format!("{generators} generators of bodies that overlap, at most {most} are taken in {D} dimensions");
    Err(Refusal::new(Code::TooLarge, message))
}

fn of_gap<const S: usize, const D: usize>(gap: &Gap<S>, hidden: &Hidden<D>, location: &Location<D>) -> Value {
    let [a, b] = gap.points.each_ref().map(|point| vector_to_json(&hidden.vector(point)));
    let [of_a, of_b] = hidden.features(gap.features.each_ref().map(|feature| feature.kind));
    let Witness { coefficients, basis } = hidden.witness(&gap.nearest);
    json!({
        "distance": to_json(gap.distance()),
        "status": location.status().name(),
        "nearest": {"a": a, "b": b},
        "features": {"a": of_a, "b": of_b},
        "certificate": certificate(location),
        "distance_certificate": {"coefficients": vector_to_json(&coefficients), "basis": basis},
    })
}

fn of_contact<const S: usize, const D: usize>(
    contact: Option<Contact<S>>,
    depth: &Penetration<S>,
    hidden: &Hidden<D>,
    location: &Location<D>,
) -> Value {
    let Contact { point, touching } = contact.expect("bodies that are not disjoint have a contact");
    let [of_a, of_b] = touching
        .as_ref()
        .map_or([INTERIOR; 2], |touching| hidden.features(touching.features.each_ref().map(|feature| feature.kind)));
    let point = vector_to_json(&hidden.vector(&point));
    let Penetration { lower, upper, direction } = depth;
    let direction = hidden.direction(direction);
    let mut result = json!({
        "distance": 0.0,
        "status": location.status().name(),
        "nearest": {"a": point, "b": point},
        "features": {"a": of_a, "b": of_b},
        "penetration": {"lower": to_json(*lower), "upper": to_json(*upper), "direction": vector_to_json(&direction)},
        "certificate": certificate(location),
    });
    if let Some(Touching { normal, .. }) = touching {
        result["contact_normal"] = hidden.vector(&normal).iter().map(ToString::to_string).collect::<Value>();
    }
    result
}

fn check(input: Traced<'_>, result: Traced<'_>, _method: Option<&str>) -> Result<verifier::Verdict, String> {
    let [a, b] = [Placed::read(member(input, "a")?, "center")?, Placed::read(member(input, "b")?, "center")?];
    let [nearest, features] = [member(result, "nearest")?, member(result, "features")?];
    let location = proof::location(result)?;
    let answer = verifier::ProximityAnswer {
        distance: float(result, "distance")?,
        parts: parts(result, location.status)?,
        location,
        nearest: [point(member(nearest, "a")?, "a")?, point(member(nearest, "b")?, "b")?],
        features: [text(features, "a")?.to_owned(), text(features, "b")?.to_owned()],
    };
    Ok(verifier::check_proximity(&a.body(), &b.body(), &answer).in_words())
}

/// The fields that an answer of this status has beside those of all: others are not read, so they are not called right.
fn parts(result: Traced<'_>, status: verifier::Status) -> Result<verifier::ProximityParts, String> {
    let mut parts = verifier::ProximityParts::default();
    if status == verifier::Status::Outside {
        let proof = member(result, "distance_certificate")?;
        parts.distance = Some((vector(member(proof, "coefficients")?, "coefficients")?, indices(proof, "basis")?));
        return Ok(parts);
    }
    if status == verifier::Status::Boundary {
        let normal = exact_numbers(member(result, "contact_normal")?);
        parts.normal = Some(normal.ok_or("`contact_normal` is not a list of exact numbers")?);
    }
    parts.penetration = Some(penetration_of(member(result, "penetration")?)?);
    Ok(parts)
}

fn penetration_of(tree: Traced<'_>) -> Result<verifier::PenetrationAnswer, String> {
    Ok(verifier::PenetrationAnswer {
        lower: float(tree, "lower")?,
        upper: float(tree, "upper")?,
        direction: vector(member(tree, "direction")?, "direction")?,
    })
}
