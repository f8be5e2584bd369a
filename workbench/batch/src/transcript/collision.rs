//! Points and zonotopes relative to zonotopes.

use super::Verdict;
use super::reading::{boolean, direction, float, index, indices, member, text, vector, vectors};
use crate::json::Tree;
use verifier::{
    Displaced, GaugeAnswer, LocationAnswer, LocationCertificate, Status, check_gauge, check_location,
    check_member_batch,
};

pub(super) fn member_of(input: &Tree, result: &Tree) -> Result<Verdict, String> {
    let point = vector(member(input, "point")?, "point")?;
    let center = vector(member(input, "center")?, "center")?;
    let generators = vectors(member(input, "generators")?, "generators")?;
    located(&Displaced::new(&center, &point, &generators)?, result, "member")
}

pub(super) fn intersect(input: &Tree, result: &Tree) -> Result<Verdict, String> {
    let [a, b] = [member(input, "a")?, member(input, "b")?];
    let center = |body| vector(member(body, "center")?, "center");
    let mut generators = vectors(member(a, "generators")?, "generators")?;
    generators.extend(vectors(member(b, "generators")?, "generators")?);
    located(&Displaced::new(&center(a)?, &center(b)?, &generators)?, result, "intersects")
}

fn located(question: &Displaced, result: &Tree, flag: &str) -> Result<Verdict, String> {
    let answer = LocationAnswer {
        status: status(text(result, "status")?)?,
        certificate: certificate(member(result, "certificate")?)?,
    };
    if boolean(result, flag)? != (answer.status != Status::Outside) {
        return Err(format!("`{flag}` contradicts the status"));
    }
    Ok(check_location(question, &answer).in_words())
}

fn status(name: &str) -> Result<Status, String> {
    Status::named(name).ok_or_else(|| format!("there is no status `{name}`"))
}

pub(super) fn gauge(input: &Tree, result: &Tree) -> Result<Verdict, String> {
    let [p, q] = [vector(member(input, "p")?, "p")?, vector(member(input, "q")?, "q")?];
    let generators = vectors(member(input, "generators")?, "generators")?;
    let answer = GaugeAnswer {
        gauge: float(result, "gauge")?,
        at_most_one: boolean(result, "at_most_one")?,
        certificate: certificate(member(result, "certificate")?)?,
    };
    Ok(check_gauge(&Displaced::new(&p, &q, &generators)?, &answer).in_words())
}

pub(super) fn member_batch(input: &Tree, result: &Tree) -> Result<Verdict, String> {
    let center = vector(member(input, "center")?, "center")?;
    let generators = vectors(member(input, "generators")?, "generators")?;
    let points = vectors(member(input, "points")?, "points")?;
    let list = |name| member(result, name)?.list().ok_or_else(|| format!("`{name}` is not a list"));
    let (statuses, gauges) = (list("status")?, list("gauge")?);
    for count in ["build", "query"] {
        index(result, count)?;
    }
    if statuses.len() != gauges.len() {
        return Err("`status` and `gauge` have different lengths".to_owned());
    }
    let answers = statuses.iter().zip(gauges).map(|(name, gauge)| {
        let name = name.text().ok_or("`status` holds something else than names")?;
        Ok((status(name)?, gauge.float().ok_or("`gauge` holds something else than numbers")?))
    });
    let answers: Vec<(Status, f64)> = answers.collect::<Result<_, String>>()?;
    Ok(check_member_batch(&center, &generators, &points, &answers).in_words())
}

/// A proof of either form.
fn certificate(tree: &Tree) -> Result<LocationCertificate, String> {
    if tree.field("separating_direction").is_some() {
        return Ok(LocationCertificate::Separation(direction(tree, "separating_direction")?));
    }
    Ok(LocationCertificate::Witness {
        coefficients: vector(member(tree, "coefficients")?, "coefficients")?,
        basis: indices(tree, "basis")?,
    })
}
