//! The location that an answer claims, with its proof, read for the check.

use verifier::{Displaced, LocationAnswer, LocationCertificate, Status, Verdict, check_location};

use crate::claimed::{Traced, boolean, direction, indices, member, text, vector};

pub(super) fn located(question: &Displaced, result: Traced<'_>, flag: &str) -> Result<Verdict, String> {
    let answer = location(result)?;
    if boolean(result, flag)? != (answer.status != Status::Outside) {
        return Err(format!("`{flag}` contradicts the status"));
    }
    Ok(check_location(question, &answer).in_words())
}

pub(super) fn location(result: Traced<'_>) -> Result<LocationAnswer, String> {
    Ok(LocationAnswer {
        status: status(text(result, "status")?)?,
        certificate: certificate(member(result, "certificate")?)?,
    })
}

pub(super) fn status(name: &str) -> Result<Status, String> {
    Status::named(name).ok_or_else(|| format!("there is no status `{name}`"))
}

/// A proof of either form.
pub(super) fn certificate(tree: Traced<'_>) -> Result<LocationCertificate, String> {
    if tree.field("separating_direction").is_some() {
        return Ok(LocationCertificate::Separation(direction(tree, "separating_direction")?));
    }
    Ok(LocationCertificate::Witness {
        coefficients: vector(member(tree, "coefficients")?, "coefficients")?,
        basis: indices(tree, "basis")?,
    })
}
