//! Bodies around points.

use super::Verdict;
use super::reading::{boolean, exact_numbers, float, index, indices, member, planar, text, vector, vectors};
use super::traced::Traced;
use verifier::{
    Certificate, Directed, DirectedAnswer, ExactMinArea, Fraction, MinAreaAnswer, MinLengthAnswer,
    check_exact_min_area, check_measure, check_min_area, check_min_length_all, check_min_length_all_at_any_ratio,
    check_min_length_dirs, check_min_length_dirs_feasible,
};

pub(super) fn min_area(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let points = planar(member(input, "points")?, "points")?;
    let answer = min_area_answer(result)?;
    let verdict = check_min_area(&points, &answer).in_words();
    let (Verdict::Right(proved), Some(exact)) = (&verdict, result.field("exact")) else { return Ok(verdict) };
    check_exact_min_area(&points, &answer.certificate, &exact_min_area(exact)?).proof()?;
    Ok(Verdict::Right(format!("{proved}; the exact optimum is one")))
}

fn exact_min_area(exact: Traced<'_>) -> Result<ExactMinArea, String> {
    let point = |value: Traced<'_>, name: &str| {
        let numbers = exact_numbers(value).and_then(|numbers| <[Fraction; 2]>::try_from(numbers).ok());
        numbers.ok_or_else(|| format!("exact: `{name}` holds something else than pairs of exact numbers"))
    };
    let generators = member(exact, "generators")?.elements().ok_or("exact: `generators` is not a list")?;
    Ok(ExactMinArea {
        area: Fraction::parse(text(exact, "area")?).ok_or("exact: `area` is not an exact number")?,
        center: point(member(exact, "center")?, "center")?,
        generators: generators.map(|value| point(value, "generators")).collect::<Result<_, _>>()?,
    })
}

fn min_area_answer(result: Traced<'_>) -> Result<MinAreaAnswer, String> {
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

pub(super) fn min_length_dirs(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
    let question = Directed {
        points: vectors(member(input, "points")?, "points")?,
        directions: vectors(member(input, "directions")?, "directions")?,
        weights: vector(member(input, "weights")?, "weights")?,
    };
    let certificate = member(result, "certificate")?;
    let status = text(result, "status")?;
    let answer = match status {
        "optimal" | "feasible" => DirectedAnswer::Optimal {
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
    let check = if status == "feasible" { check_min_length_dirs_feasible } else { check_min_length_dirs };
    Ok(check(&question, &answer).in_words())
}

pub(super) fn min_length_all(input: Traced<'_>, result: Traced<'_>) -> Result<Verdict, String> {
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
    let epsilon = float(input, "epsilon")?;
    let is_volume = match input.field("objective").map(Traced::text) {
        None | Some(Some("length")) => false,
        Some(Some("volume")) => true,
        Some(_) => return Ok(Verdict::Unchecked("the question's `objective` is neither length nor volume".to_owned())),
    };
    let is_counted = input.field("max_generators").is_some();
    // Who bounds the number of generators, or wants a small volume, gets the ratio that is found, whatever it is.
    if !is_volume && !is_counted {
        return Ok(check_min_length_all(&points, epsilon, &answer).in_words());
    }
    if is_counted && answer.generators.len() > index(input, "max_generators")? {
        return Err(format!("{} generators, more than `max_generators`", answer.generators.len()));
    }
    let verdict = check_min_length_all_at_any_ratio(&points, epsilon, &answer).in_words();
    let (Verdict::Right(proved), true) = (&verdict, is_volume) else { return Ok(verdict) };
    let volume = float(result, "volume")?;
    Ok(match check_measure(&answer.generators, volume).in_words() {
        Verdict::Right(_) => Verdict::Right(format!("{proved}; volume {volume:?}, not proven to be the least")),
        other => other,
    })
}

/// Points and their multipliers, vectors that the batch interface calls forces.
fn forces<T>(certificate: Traced<'_>, read: impl Fn(Traced<'_>) -> Option<T>) -> Result<Vec<(usize, T)>, String> {
    let list = member(certificate, "forces")?.elements().ok_or("`forces` is not a list")?;
    let force = |tree: Traced<'_>| {
        let vector = read(member(tree, "vector")?).ok_or("`vector` of a force holds something else than numbers")?;
        Ok((index(tree, "point")?, vector))
    };
    list.map(force).collect()
}
