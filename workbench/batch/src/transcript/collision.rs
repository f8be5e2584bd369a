//! Points and zonotopes relative to zonotopes.

use super::Verdict;
use super::placed::Placed;
use super::reading::{boolean, direction, exact_numbers, float, index, indices, member, point, text, vector, vectors};
use super::traced::Traced;
use verifier::{
    Displaced, GaugeAnswer, LocationAnswer, LocationCertificate, PenetrationAnswer, ProximityAnswer, ProximityParts,
    Status, check_gauge, check_location, check_member_batch, check_proximity,
};

pub(super) fn member_of(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let point = vector(member(input, "point")?, "point")?;
    let body = Placed::read(input, "center")?;
    located(&Displaced::to_point(&body.body(), &point)?, result, "member")
}

pub(super) fn intersect(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let [a, b] = [Placed::read(member(input, "a")?, "center")?, Placed::read(member(input, "b")?, "center")?];
    located(&Displaced::between(&a.body(), &b.body())?, result, "intersects")
}

pub(super) fn distance(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let [a, b] = [Placed::read(member(input, "a")?, "center")?, Placed::read(member(input, "b")?, "center")?];
    let [nearest, features] = [member(result, "nearest")?, member(result, "features")?];
    let location = location(result)?;
    let answer = ProximityAnswer {
        distance: float(result, "distance")?,
        parts: parts(result, location.status)?,
        location,
        nearest: [point(member(nearest, "a")?, "a")?, point(member(nearest, "b")?, "b")?],
        features: [text(features, "a")?.to_owned(), text(features, "b")?.to_owned()],
    };
    Ok(check_proximity(&a.body(), &b.body(), &answer).in_words())
}

/// The fields that an answer of this status has beside those of all: others are not read, so they are not called right.
fn parts(result: Traced<'_>, status: Status) -> Result<ProximityParts, String> {
    let mut parts = ProximityParts::default();
    if status == Status::Outside {
        let proof = member(result, "distance_certificate")?;
        parts.distance = Some((vector(member(proof, "coefficients")?, "coefficients")?, indices(proof, "basis")?));
        return Ok(parts);
    }
    if status == Status::Boundary {
        let normal = exact_numbers(member(result, "contact_normal")?);
        parts.normal = Some(normal.ok_or("`contact_normal` is not a list of exact numbers")?);
    }
    parts.penetration = Some(penetration(member(result, "penetration")?)?);
    Ok(parts)
}

fn penetration(tree: Traced<'_>) -> Result<PenetrationAnswer, String> {
    Ok(PenetrationAnswer {
        lower: float(tree, "lower")?,
        upper: float(tree, "upper")?,
        direction: vector(member(tree, "direction")?, "direction")?,
    })
}

fn located(question: &Displaced, result: Traced<'_>, flag: &str) -> Result<Verdict, String> {
    let answer = location(result)?;
    if boolean(result, flag)? != (answer.status != Status::Outside) {
        return Err(format!("`{flag}` contradicts the status"));
    }
    Ok(check_location(question, &answer).in_words())
}

fn location(result: Traced<'_>) -> Result<LocationAnswer, String> {
    Ok(LocationAnswer {
        status: status(text(result, "status")?)?,
        certificate: certificate(member(result, "certificate")?)?,
    })
}

fn status(name: &str) -> Result<Status, String> {
    Status::named(name).ok_or_else(|| format!("there is no status `{name}`"))
}

pub(super) fn gauge(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let (body, q) = (Placed::read(input, "p")?, vector(member(input, "q")?, "q")?);
    let answer = GaugeAnswer {
        gauge: float(result, "gauge")?,
        at_most_one: boolean(result, "at_most_one")?,
        certificate: certificate(member(result, "certificate")?)?,
    };
    Ok(check_gauge(&Displaced::to_point(&body.body(), &q)?, &answer).in_words())
}

/// The amount of work says nothing about the points, so no check repeats it; but some counts cannot be.
pub(super) fn member_batch(input: Traced<'_>, answer: Traced<'_>) -> Result<Verdict, String> {
    let result = member(answer, "result")?;
    let body = Placed::read(input, "center")?;
    let points = vectors(member(input, "points")?, "points")?;
    let list = |name| member(result, name)?.tree.list().ok_or_else(|| format!("`{name}` is not a list"));
    let (statuses, gauges) = (list("status")?, list("gauge")?);
    let [build, _] = [index(result, "build")?, index(result, "query")?];
    let prepared = match answer.field("method").and_then(Traced::text) {
        Some("by_lad") => Some(0),
        Some("by_direction_tree") => Some(body.body().generators.len()),
        _ => None,
    };
    if prepared.is_some_and(|prepared| build != prepared) {
        return Err(format!("`build` is {build}, which the method does not spend before the points"));
    }
    if statuses.len() != gauges.len() {
        return Err("`status` and `gauge` have different lengths".to_owned());
    }
    let answers = statuses.iter().zip(gauges).map(|(name, gauge)| {
        let name = name.text().ok_or("`status` holds something else than names")?;
        Ok((status(name)?, gauge.float().ok_or("`gauge` holds something else than numbers")?))
    });
    let answers: Vec<(Status, f64)> = answers.collect::<Result<_, String>>()?;
    Ok(match check_member_batch(&body.body(), &points, &answers).in_words() {
        Verdict::Right(proved) => Verdict::Right(format!("{proved}; `build` and `query` claim nothing")),
        other => other,
    })
}

/// A proof of either form.
fn certificate(tree: Traced<'_>) -> Result<LocationCertificate, String> {
    if tree.field("separating_direction").is_some() {
        return Ok(LocationCertificate::Separation(direction(tree, "separating_direction")?));
    }
    Ok(LocationCertificate::Witness {
        coefficients: vector(member(tree, "coefficients")?, "coefficients")?,
        basis: indices(tree, "basis")?,
    })
}
