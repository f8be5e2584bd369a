//! The shapes in which a JSON document holds a zonotope.

mod answer;

use std::path::Path;

use super::names::{self, Holder, MATRIX, POSE};
use super::placed::Placed;
use super::{Body, Layout};
use crate::input::document::number;
use crate::input::error::{InputError, Place, Problem, on_one_line};
use crate::input::push_limited;
use batch::KINDS;
use batch::json::Tree;
use batch::placement::Placement;

pub use answer::body_of_answer;

/// The fields of a question, or of an answer, beside its input or its result.
const ENVELOPE: [&str; 4] = ["id", "kind", "method", "request"];

/// The zonotope of a document: a list of generators, a body with its fields, a question about one body, or an answer
/// that holds one. A line tells which fields are not read.
pub(super) fn placed(
    file: &Path,
    document: &Tree,
    layout: Layout,
    tell: &mut dyn FnMut(&str),
) -> Result<Placed, InputError> {
    if document.list().is_some() {
        let body = layout.body(file, &[], vectors(file, document, "")?, tell)?;
        return Ok(Placed { body, pose: None });
    }
    if layout != Layout::default() {
        let problem = "is an object, whose fields say what its vectors are; --columns-are-generators and --center-first \
                       are for tables, arrays and lists";
        return Err(Problem::Shape(problem.to_owned()).at(file, Place::File));
    }
    let mut unread = Vec::new();
    let whole = Holder { file, object: document, path: "" };
    let placed = match answer::placed(whole, &mut unread) {
        Some(answered) => answered?,
        None => held(whole, &mut unread)?,
    };
    match unread.as_slice() {
        [] => {}
        [one] => tell(&on_one_line(&format!("the field `{one}` is not read"))),
        several => tell(&on_one_line(&format!("the fields `{}` are not read", several.join("`, `")))),
    }
    Ok(placed)
}

/// The zonotope of an object that is no answer: its own, that of a question, or the only one among its fields.
fn held(whole: Holder<'_>, unread: &mut Vec<String>) -> Result<Placed, InputError> {
    if whole.generators()?.is_some() {
        return zonotope(whole, &ENVELOPE, true, unread);
    }
    let input = whole.field("input").filter(|input| matches!(input, Tree::Object(_)));
    let (outer, path) = match input {
        Some(input) => (Holder { object: input, path: "input.", ..whole }, "input."),
        None => (whole, ""),
    };
    if input.is_some() {
        unread.extend(whole.unread(&[&ENVELOPE[..], &["input"]].concat(), None)?);
        if outer.generators()?.is_some() {
            // p and q of a gauge are points, the first of which is the centre.
            let of_kind =
                whole.field("kind").and_then(Tree::text).and_then(|name| KINDS.iter().find(|k| k.name == name));
            let known = of_kind.iter().flat_map(|kind| kind.fields.iter().chain(kind.optional)).copied();
            let known: Vec<&str> = known.filter(|name| !["p", "q"].contains(name)).collect();
            return zonotope(outer, &known, true, unread);
        }
    }
    let Tree::Object(inner) = outer.object else { return Err(nothing(whole)) };
    let holds = |value: &Tree| [names::LIST, MATRIX].iter().any(|name| value.field(name).is_some());
    let bodies: Vec<&String> = inner.iter().filter(|(_, value)| holds(value)).map(|(name, _)| name).collect();
    match bodies.as_slice() {
        [] => {
            // Generators under another name are named.
            outer.unread(&[&ENVELOPE[..], &names::CENTERS, &[POSE]].concat(), None)?;
            Err(nothing(whole))
        }
        [only] => {
            unread.extend(outer.unread(&[&ENVELOPE[..], &[only.as_str()]].concat(), None)?);
            let object = outer.field(only).ok_or_else(|| nothing(whole))?;
            zonotope(Holder { object, path: &format!("{path}{only}."), ..whole }, &[], true, unread)
        }
        several => {
            let names: Vec<String> = several.iter().map(|name| format!("`{path}{name}`")).collect();
            let problem = format!("holds several bodies, {}; write the one that is meant to a file", names.join(", "));
            Err(Problem::Shape(on_one_line(&problem)).at(whole.file, Place::File))
        }
    }
}

fn nothing(whole: Holder<'_>) -> InputError {
    let problem = format!(
        "expected a list of generators, an object with a list `generators` or a matrix `G`, or an answer with a \
         zonotope, found {}",
        whole.object.describe()
    );
    Problem::Shape(problem).at(whole.file, Place::File)
}

/// The zonotope of an object that has generators. Numbers under unknown names are refused where they `may_be_meant`.
fn zonotope(
    holder: Holder<'_>,
    known: &[&str],
    may_be_meant: bool,
    unread: &mut Vec<String>,
) -> Result<Placed, InputError> {
    let (file, name, named_center) = (holder.file, holder.generators()?, holder.center()?);
    let name = name.ok_or_else(|| nothing(holder))?;
    let center = named_center.and_then(|name| holder.field(name).map(|value| (name, value)));
    let center = center.map(|(name, value)| centre(file, value, &holder.path_of(name))).transpose()?;
    let value = holder.field(name).ok_or_else(|| nothing(holder))?;
    let path = holder.path_of(name);
    if value.list().is_none() {
        return Err(holder.wrong(name, format!("expected a list, found {}", value.describe())));
    }
    let generators = if name == MATRIX {
        columns_of_matrix(file, value, &path, center.as_deref())?
    } else {
        vectors(file, value, &path)?
    };
    let body = match (&center, generators.first()) {
        (Some(center), Some(first)) if name == names::LIST && first.len() != center.len() => {
            let problem = format!(
                "the vectors have {} coordinates, and the centre has {}; a matrix whose columns are the generators is \
                 named `G`",
                first.len(),
                center.len()
            );
            return Err(holder.wrong(name, problem));
        }
        _ => super::body(file, center, generators)?,
    };
    finished(holder, body, &[known, &[name], named_center.as_slice(), &[POSE]].concat(), may_be_meant, unread)
}

/// The body with its pose, after a look at the fields that are not read.
fn finished(
    holder: Holder<'_>,
    body: Body,
    known: &[&str],
    may_be_meant: bool,
    unread: &mut Vec<String>,
) -> Result<Placed, InputError> {
    let dimension = body.center.len();
    unread.extend(holder.unread(known, may_be_meant.then_some(dimension))?);
    let pose = holder.field(POSE).map(|pose| Placement::read(pose, dimension)).transpose();
    let wrong = |message: String| Problem::Shape(message).at(holder.file, Place::File);
    let pose = pose.map_err(|refusal| wrong(format!("{}{}", holder.path, refusal.message)))?;
    Ok(Placed { body, pose })
}

/// A centre: a vector, or a matrix with one column.
fn centre(file: &Path, value: &Tree, path: &str) -> Result<Vec<f64>, InputError> {
    let cell = |row: &Tree| row.list().filter(|row| row.len() == 1).map(|row| row[0].clone());
    match value.list().and_then(|rows| rows.iter().map(cell).collect::<Option<Vec<Tree>>>()) {
        Some(column) => vector(file, &Tree::List(column), path),
        None => vector(file, value, path),
    }
}

/// The generators of a matrix that is given by its rows, one for every coordinate. A matrix with one row or one column
/// may be a list of numbers.
fn columns_of_matrix(
    file: &Path,
    matrix: &Tree,
    path: &str,
    center: Option<&[f64]>,
) -> Result<Vec<Vec<f64>>, InputError> {
    let is_flat = |matrix: &Tree| matrix.list().is_some_and(|all| matches!(all.first(), Some(Tree::Number(_))));
    let rows = match center.map(<[f64]>::len) {
        Some(1) if is_flat(matrix) => vec![vector(file, matrix, path)?],
        Some(_) if is_flat(matrix) => vector(file, matrix, path)?.into_iter().map(|x| vec![x]).collect(),
        _ => vectors(file, matrix, path)?,
    };
    let count = rows.first().map_or(0, Vec::len);
    if let Some(index) = rows.iter().position(|row| row.len() != count) {
        let problem = Problem::Ragged { found: rows[index].len(), expected: count };
        return Err(problem.at(file, Place::Path(format!("{path}[{index}]"))));
    }
    if let Some(center) = center.filter(|center| center.len() != rows.len() && count > 0) {
        let problem = format!(
            "the matrix has {} rows, not {}; a list whose rows are the generators is named `generators`",
            rows.len(),
            center.len()
        );
        return Err(Problem::Shape(problem).at(file, Place::Path(path.to_owned())));
    }
    Ok((0..count).map(|column| rows.iter().map(|row| row[column]).collect()).collect())
}

pub(super) fn vectors(file: &Path, value: &Tree, path: &str) -> Result<Vec<Vec<f64>>, InputError> {
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

#[cfg(test)]
mod tests;
