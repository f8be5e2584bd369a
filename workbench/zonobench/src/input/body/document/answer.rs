//! The zonotope of an answer.

use std::path::Path;

use crate::input::body::names::{CENTERS, Holder, POSE};
use crate::input::body::object::{ENVELOPE, finished, vector, vectors, zonotope};
use crate::input::body::placed::Placed;
use crate::input::body::zonotope::{Body, body};
use crate::input::error::{InputError, Place, Problem};
use batch::json::Tree;

/// The name of the multiples of directions that make generators.
const COEFFICIENTS: &str = "coefficients";

/// The words of a result on the zonotope that it holds.
const SAID: [&str; 13] = [
    "status",
    "area",
    "volume",
    "length",
    "value",
    "lower_bound",
    "ratio",
    "within_epsilon",
    "hausdorff",
    "certificate",
    "exact",
    "gap",
    "measure",
];

/// The zonotope of an answer; `None` if the document is no answer.
pub(super) fn placed(whole: Holder<'_>, unread: &mut Vec<String>) -> Option<Result<Placed, InputError>> {
    let without = |reason: String| Some(Err(Problem::Shape(reason).at(whole.file, Place::File)));
    if let Some(error) = whole.object.field("error") {
        let message = error.field("message").and_then(Tree::text).unwrap_or("no reason is given");
        return without(format!("is a refusal: {message}"));
    }
    let result = whole.object.field("result")?;
    if result.field("status").and_then(Tree::text) == Some("infeasible") {
        return without("holds no zonotope: no zonotope along the directions contains the points".to_owned());
    }
    match of_result(whole, unread) {
        Ok(Some(placed)) => Some(Ok(placed)),
        Ok(None) => without("is an answer that holds no zonotope".to_owned()),
        Err(error) => Some(Err(error)),
    }
}

/// The zonotope in the result of an answer, if there is one: `center` and `generators`, or `center` and
/// `coefficients` of the directions that the answer's `request` names. Their products are rounded where no doubles
/// equal them.
pub fn body_of_answer(file: &Path, answer: &Tree) -> Result<Option<Body>, InputError> {
    let whole = Holder { file, object: answer, path: "" };
    Ok(of_result(whole, &mut Vec::new())?.map(|placed| placed.body))
}

fn of_result(whole: Holder<'_>, unread: &mut Vec<String>) -> Result<Option<Placed>, InputError> {
    let Some(object) = whole.field("result") else { return Ok(None) };
    unread.extend(whole.unread(&[&ENVELOPE[..], &["result", "error"]].concat(), None)?);
    let result = Holder { object, path: "result.", ..whole };
    if result.generators()?.is_some() {
        return zonotope(result, &SAID, false, unread).map(Some);
    }
    let file = whole.file;
    let Some(coefficients) = result.field(COEFFICIENTS) else { return Ok(None) };
    let coefficients = vector(file, coefficients, "result.coefficients")?;
    let named_center = result.center()?;
    let center = named_center.and_then(|name| result.field(name)).map(|center| vector(file, center, "result.center"));
    let center = center.transpose()?;
    let shape = |problem: String| Problem::Shape(problem).at(file, Place::File);
    let directions = whole.field("request").and_then(|request| request.field("directions"));
    let directions = directions.ok_or_else(|| {
        shape("holds coefficients, but names no directions; the answers that `enclose` writes do".to_owned())
    })?;
    let directions = vectors(file, directions, "request.directions")?;
    if directions.len() != coefficients.len() {
        let (coefficients, directions) = (coefficients.len(), directions.len());
        return Err(shape(format!("holds {coefficients} coefficients of {directions} directions")));
    }
    let used = || directions.iter().zip(&coefficients).filter(|(_, coefficient)| **coefficient != 0.0);
    let generators = used().map(|(direction, coefficient)| direction.iter().map(|x| x * coefficient).collect());
    let is_rounded = used().any(|(direction, coefficient)| direction.iter().any(|&x| !is_product(x, *coefficient)));
    let body = Body { is_rounded, ..body(file, center, generators.collect())? };
    let known = [&SAID[..], &CENTERS, &[COEFFICIENTS, POSE]].concat();
    finished(result, body, &known, false, unread).map(Some)
}

/// Whether the product of two numbers is a double. Where the product underflows, its rounding error may do so as
/// well, and the answer is no.
fn is_product(x: f64, y: f64) -> bool {
    let product = x * y;
    x == 0.0 || y == 0.0 || (product.abs() > f64::MIN_POSITIVE / f64::EPSILON && x.mul_add(y, -product) == 0.0)
}
