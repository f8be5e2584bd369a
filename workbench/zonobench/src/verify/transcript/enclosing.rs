//! Bodies around points.

use super::reading::{float, indices, member, planar, vector};
use crate::json::Tree;
use crate::verify::{Certificate, MinAreaAnswer, check_min_area};

pub(super) fn min_area(input: &Tree, result: &Tree) -> Result<String, String> {
    let points = planar(member(input, "points")?, "points")?;
    let proof = check_min_area(&points, &min_area_answer(result)?)?;
    let count = points.len();
    Ok(format!("contains all {count} points; area {:?} is within {:.1e} of the proven bound", proof.area, proof.gap))
}

fn min_area_answer(result: &Tree) -> Result<MinAreaAnswer, String> {
    let center = vector(member(result, "center")?, "center")?;
    let certificate = member(result, "certificate")?;
    Ok(MinAreaAnswer {
        area: float(result, "area")?,
        center: <[f64; 2]>::try_from(center).map_err(|_| "center is not a point of the plane")?,
        generators: planar(member(result, "generators")?, "generators")?,
        lower_bound: float(result, "lower_bound")?,
        certificate: Certificate {
            hull: indices(certificate, "hull")?,
            farthest: indices(certificate, "farthest")?,
            coefficients: vector(member(certificate, "coefficients")?, "coefficients")?,
            basis: indices(certificate, "basis")?,
        },
    })
}
