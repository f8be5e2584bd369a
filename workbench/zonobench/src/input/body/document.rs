//! The shapes in which a JSON document holds a zonotope.

use std::path::Path;

use super::Body;
use crate::input::document::number;
use crate::input::error::{InputError, Place, Problem};
use crate::input::push_limited;
use batch::json::Tree;

/// The zonotope of a document: a list of generators, a body with `generators` or `G`, or an answer that holds one.
pub(super) fn body(file: &Path, document: &Tree) -> Result<Body, InputError> {
    if document.list().is_some() {
        return super::body(file, None, vectors(file, document, "")?);
    }
    if let Some(answered) = answer(file, document) {
        return answered;
    }
    if let Some(matrix) = document.field("G") {
        let center = optional(file, document, "c", "c")?;
        return super::body(file, center.clone(), columns_of_matrix(file, matrix, center.as_deref())?);
    }
    let Some(generators) = document.field("generators").filter(|generators| generators.list().is_some()) else {
        let problem = format!(
            "expected a list of generators, an object with a list `generators` or a matrix `G`, or an answer with a \
             zonotope, found {}",
            document.describe()
        );
        return Err(Problem::Shape(problem).at(file, Place::File));
    };
    let center = optional(file, document, "center", "center")?;
    super::body(file, center, vectors(file, generators, "generators")?)
}

/// The zonotope of an answer; `None` if the document is no answer.
fn answer(file: &Path, document: &Tree) -> Option<Result<Body, InputError>> {
    let without = |reason: String| Some(Err(Problem::Shape(reason).at(file, Place::File)));
    if let Some(error) = document.field("error") {
        let message = error.field("message").and_then(Tree::text).unwrap_or("no reason is given");
        return without(format!("is a refusal: {message}"));
    }
    let result = document.field("result")?;
    if result.field("status").and_then(Tree::text) == Some("infeasible") {
        return without("holds no zonotope: no zonotope along the directions contains the points".to_owned());
    }
    match body_of_answer(file, document) {
        Ok(Some(body)) => Some(Ok(body)),
        Ok(None) => without("is an answer that holds no zonotope".to_owned()),
        Err(error) => Some(Err(error)),
    }
}

/// The zonotope in the result of an answer, if there is one: `center` and `generators`, or `center` and
/// `coefficients` of the directions that the answer's `request` names. Their products are rounded where no doubles
/// equal them.
pub fn body_of_answer(file: &Path, answer: &Tree) -> Result<Option<Body>, InputError> {
    let Some(result) = answer.field("result") else { return Ok(None) };
    let center = optional(file, result, "center", "result.center")?;
    if let Some(generators) = result.field("generators") {
        return super::body(file, center, vectors(file, generators, "result.generators")?).map(Some);
    }
    let Some(coefficients) = result.field("coefficients") else { return Ok(None) };
    let coefficients = vector(file, coefficients, "result.coefficients")?;
    let shape = |problem: String| Problem::Shape(problem).at(file, Place::File);
    let directions = answer.field("request").and_then(|request| request.field("directions"));
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
    let body = super::body(file, center, generators.collect())?;
    Ok(Some(Body { is_rounded, ..body }))
}

/// Whether the product of two numbers is a double. Where the product underflows, its rounding error may do so as
/// well, and the answer is no.
fn is_product(x: f64, y: f64) -> bool {
    let product = x * y;
    x == 0.0 || y == 0.0 || (product.abs() > f64::MIN_POSITIVE / f64::EPSILON && x.mul_add(y, -product) == 0.0)
}

/// The generators of a matrix that is given by its rows, one for every coordinate.
fn columns_of_matrix(file: &Path, matrix: &Tree, center: Option<&[f64]>) -> Result<Vec<Vec<f64>>, InputError> {
    let rows = vectors(file, matrix, "G")?;
    if let Some(center) = center.filter(|center| center.len() != rows.len()) {
        let problem = format!("the matrix has {} rows, not {}", rows.len(), center.len());
        return Err(Problem::Shape(problem).at(file, Place::Path("G".to_owned())));
    }
    let count = rows.first().map_or(0, Vec::len);
    if let Some(index) = rows.iter().position(|row| row.len() != count) {
        let problem = Problem::Ragged { found: rows[index].len(), expected: count };
        return Err(problem.at(file, Place::Path(format!("G[{index}]"))));
    }
    Ok((0..count).map(|column| rows.iter().map(|row| row[column]).collect()).collect())
}

fn optional(file: &Path, object: &Tree, name: &str, path: &str) -> Result<Option<Vec<f64>>, InputError> {
    object.field(name).map(|value| vector(file, value, path)).transpose()
}

fn vectors(file: &Path, value: &Tree, path: &str) -> Result<Vec<Vec<f64>>, InputError> {
    let rows = value.list().ok_or_else(|| {
        let problem = Problem::Shape(format!("expected a list of vectors, found {}", value.describe()));
        problem.at(file, Place::Path(path.to_owned()))
    })?;
    let mut all = Vec::new();
    for (index, row) in rows.iter().enumerate() {
        let row = vector(file, row, &format!("{path}[{index}]"))?;
        push_limited(&mut all, row).map_err(|problem| problem.at(file, Place::File))?;
    }
    Ok(all)
}

fn vector(file: &Path, value: &Tree, path: &str) -> Result<Vec<f64>, InputError> {
    let components = value.list().ok_or_else(|| {
        Problem::Shape(format!("expected a vector, found {}", value.describe())).at(file, Place::Path(path.to_owned()))
    })?;
    let component =
        |(index, value)| number(value).map_err(|problem| problem.at(file, Place::Path(format!("{path}[{index}]"))));
    components.iter().enumerate().map(component).collect()
}
