//! Bodies around points.

use dashu_int::IBig;

use super::Verdict;
use super::reading::{boolean, exact_numbers, float, fraction, index, indices, member, planar, text, vector, vectors};
use crate::json::Tree;
use verifier::{
    Certificate, Directed, DirectedAnswer, DirectedProof, ExactMinArea, MinAreaAnswer, MinLengthAnswer,
    check_exact_min_area, check_min_area, check_min_length_all, check_min_length_dirs,
};

pub(super) fn min_area(input: &Tree, result: &Tree) -> Result<String, String> {
    let points = planar(member(input, "points")?, "points")?;
    let answer = min_area_answer(result)?;
    let proof = check_min_area(&points, &answer)?;
    let count = points.len();
    let mut proved =
        format!("contains all {count} points; area {:?} is within {:.1e} of the proven bound", proof.area, proof.gap);
    if let Some(exact) = result.field("exact") {
        check_exact_min_area(&points, &answer.certificate, &exact_min_area(exact)?)?;
        proved.push_str("; the exact optimum is one");
    }
    Ok(proved)
}

fn exact_min_area(exact: &Tree) -> Result<ExactMinArea, String> {
    let point = |value: &Tree, name: &str| {
        let numbers = exact_numbers(value).and_then(|numbers| <[(IBig, IBig); 2]>::try_from(numbers).ok());
        numbers.ok_or_else(|| format!("exact: `{name}` holds something else than pairs of exact numbers"))
    };
    let generators = member(exact, "generators")?.list().ok_or("exact: `generators` is not a list")?;
    Ok(ExactMinArea {
        area: fraction(text(exact, "area")?).ok_or("exact: `area` is not an exact number")?,
        center: point(member(exact, "center")?, "center")?,
        generators: generators.iter().map(|value| point(value, "generators")).collect::<Result<_, _>>()?,
    })
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

/// A value this near to its bound, relative to it, is the least but for rounding.
const PROVEN_GAP: f64 = 1e-6;

pub(super) fn min_length_dirs(input: &Tree, result: &Tree) -> Result<Verdict, String> {
    let question = Directed {
        points: vectors(member(input, "points")?, "points")?,
        directions: vectors(member(input, "directions")?, "directions")?,
        weights: vector(member(input, "weights")?, "weights")?,
    };
    let certificate = member(result, "certificate")?;
    let answer = match text(result, "status")? {
        "optimal" => DirectedAnswer::Optimal {
            value: float(result, "value")?,
            center: vector(member(result, "center")?, "center")?,
            coefficients: vector(member(result, "coefficients")?, "coefficients")?,
            lower_bound: float(result, "lower_bound")?,
            forces: forces(certificate, exact_numbers)?,
        },
        "infeasible" => DirectedAnswer::Infeasible {
            points: <[usize; 2]>::try_from(indices(certificate, "points")?)
                .map_err(|_| "certificate: `points` are not two points")?,
            functional: exact_numbers(member(certificate, "functional")?)
                .ok_or("`functional` is not a list of exact numbers")?,
        },
        other => return Err(format!("there is no status `{other}`")),
    };
    let count = question.points.len();
    Ok(match check_min_length_dirs(&question, &answer)? {
        DirectedProof::Optimal { value, gap } if gap <= PROVEN_GAP => Verdict::Right(format!(
            "contains all {count} points; value {value:?} is within {gap:.1e} of the proven bound"
        )),
        DirectedProof::Optimal { value, gap } => Verdict::Unchecked(format!(
            "contains all {count} points, but value {value:?} is {gap:.1e} above the proven bound, so it may not be the least"
        )),
        DirectedProof::TooManyFacets => Verdict::Unchecked(TOO_MANY.to_owned()),
        DirectedProof::Infeasible => {
            Verdict::Right("two points differ by a vector outside the span of the directions".to_owned())
        }
    })
}

pub(super) fn min_length_all(input: &Tree, result: &Tree) -> Result<Verdict, String> {
    let points = vectors(member(input, "points")?, "points")?;
    let answer = MinLengthAnswer {
        length: float(result, "length")?,
        center: vector(member(result, "center")?, "center")?,
        generators: vectors(member(result, "generators")?, "generators")?,
        lower_bound: float(result, "lower_bound")?,
        ratio: float(result, "ratio")?,
        within_epsilon: result.field("within_epsilon").map(|_| boolean(result, "within_epsilon")).transpose()?,
        forces: forces(member(result, "certificate")?, |tree| vector(tree, "vector").ok())?,
    };
    let count = points.len();
    Ok(match check_min_length_all(&points, float(input, "epsilon")?, &answer)? {
        Some(proof) => {
            let proved = format!(
                "contains all {count} points; length {:?}, proven to be at most {:.12} times the least",
                proof.length, proof.ratio
            );
            if proof.is_within {
                Verdict::Right(proved)
            } else {
                Verdict::Unchecked(format!("{proved}, which is above 1 + epsilon, as the answer says"))
            }
        }
        None => Verdict::Unchecked(TOO_MANY.to_owned()),
    })
}

const TOO_MANY: &str = "too many facets to hold the points against, or too many vertices of the forces' zonotope";

/// Points and the vectors that pull at them.
fn forces<T>(certificate: &Tree, read: impl Fn(&Tree) -> Option<T>) -> Result<Vec<(usize, T)>, String> {
    let list = member(certificate, "forces")?.list().ok_or("`forces` is not a list")?;
    let force = |tree: &Tree| {
        let vector = read(member(tree, "vector")?).ok_or("`vector` of a force holds something else than numbers")?;
        Ok((index(tree, "point")?, vector))
    };
    list.iter().map(force).collect()
}
