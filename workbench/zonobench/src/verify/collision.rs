//! Points and zonotopes relative to zonotopes.

use super::Verdict;
use super::reading::{boolean, direction, float, index, indices, member, text, vector, vectors};
use crate::json::Tree;
use verifier::{
    Displaced, GaugeAnswer, GaugeProof, LocationAnswer, LocationCertificate, check_gauge, check_location,
    check_member_batch,
};

pub(super) fn member_of(input: &Tree, result: &Tree) -> Result<String, String> {
    let point = vector(member(input, "point")?, "point")?;
    let center = vector(member(input, "center")?, "center")?;
    let generators = vectors(member(input, "generators")?, "generators")?;
    located(&Displaced::new(&center, &point, &generators)?, result, "member")
}

pub(super) fn intersect(input: &Tree, result: &Tree) -> Result<String, String> {
    let [a, b] = [member(input, "a")?, member(input, "b")?];
    let center = |body| vector(member(body, "center")?, "center");
    let mut generators = vectors(member(a, "generators")?, "generators")?;
    generators.extend(vectors(member(b, "generators")?, "generators")?);
    located(&Displaced::new(&center(a)?, &center(b)?, &generators)?, result, "intersects")
}

fn located(question: &Displaced, result: &Tree, flag: &str) -> Result<String, String> {
    let answer = LocationAnswer {
        status: text(result, "status")?.to_owned(),
        certificate: certificate(member(result, "certificate")?)?,
    };
    if boolean(result, flag)? != (answer.status != "outside") {
        return Err(format!("`{flag}` contradicts the status"));
    }
    check_location(question, &answer)?;
    let proof = match answer.certificate {
        LocationCertificate::Separation(_) => "the direction separates exactly",
        LocationCertificate::Witness { .. } => "the coefficients solve the system exactly and prove the status",
    };
    Ok(format!("{}; {proof}", answer.status))
}

pub(super) fn gauge(input: &Tree, result: &Tree) -> Result<Verdict, String> {
    let [p, q] = [vector(member(input, "p")?, "p")?, vector(member(input, "q")?, "q")?];
    let generators = vectors(member(input, "generators")?, "generators")?;
    let answer = GaugeAnswer {
        gauge: float(result, "gauge")?,
        at_most_one: boolean(result, "at_most_one")?,
        certificate: certificate(member(result, "certificate")?)?,
    };
    let value = answer.gauge;
    Ok(match check_gauge(&Displaced::new(&p, &q, &generators)?, &answer)? {
        GaugeProof::Exact => Verdict::Right(format!("gauge {value:?} is the exact gauge, rounded")),
        GaugeProof::Bounded => Verdict::Unchecked(format!(
            "gauge {value:?} agrees with its certificate, which bounds the gauge on one side alone"
        )),
    })
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
    let pairs = statuses.iter().zip(gauges).map(|(status, gauge)| Some((status.text()?, gauge.float()?)));
    let answers: Vec<(&str, f64)> = pairs.collect::<Option<_>>().ok_or("`status` or `gauge` holds something else")?;
    Ok(if check_member_batch(&center, &generators, &points, &answers)? {
        Verdict::Right(format!("{} points, each held against every facet", points.len()))
    } else {
        Verdict::Unchecked("too many facets to hold points without certificates against".to_owned())
    })
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
