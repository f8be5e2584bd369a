//! An object that holds a zonotope: centre, generators, pose.

use std::path::Path;

use super::names::{self, Holder, MATRIX, POSE};
use super::placed::Placed;
use super::zonotope::Body;
use crate::input::document::number;
use crate::input::error::{InputError, Place, Problem};
use crate::input::points::push_limited;
use batch::json::Tree;
use batch::read_pose;

/// The fields of a question, or of an answer, beside its input or its result.
pub(super) const ENVELOPE: [&str; 4] = ["id", "kind", "method", "request"];

pub(super) fn nothing(whole: Holder<'_>) -> InputError {
    let problem = format!(
        "expected a list of generators, an object with a list `generators` or a matrix `G`, or an answer with a \
         zonotope, found {}",
        whole.object.describe()
    );
    Problem::Shape(problem).at(whole.file, Place::File)
}

/// The zonotope of an object that has generators. Numbers under unknown names are refused where they `may_be_meant`.
pub(super) fn zonotope(
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
    let is_only_entry = name == MATRIX && matches!(value, Tree::Number(_));
    if value.list().is_none() && !is_only_entry {
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
pub(super) fn finished(
    holder: Holder<'_>,
    body: Body,
    known: &[&str],
    may_be_meant: bool,
    unread: &mut Vec<String>,
) -> Result<Placed, InputError> {
    let dimension = body.center.len();
    unread.extend(holder.unread(known, may_be_meant.then_some(dimension))?);
    let pose = holder.field(POSE).map(|pose| read_pose(pose, dimension)).transpose();
    let wrong = |message: String| Problem::Shape(message).at(holder.file, Place::File);
    let pose = pose.map_err(|refusal| wrong(format!("{}{}", holder.path, refusal.message)))?;
    Ok(Placed { body, pose })
}

/// A centre: a vector, a matrix with one column, or the only coordinate.
fn centre(file: &Path, value: &Tree, path: &str) -> Result<Vec<f64>, InputError> {
    if matches!(value, Tree::Number(_)) {
        return vector(file, &Tree::List(vec![value.clone()]), path);
    }
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
        _ if matches!(matrix, Tree::Number(_)) => vec![vector(file, &Tree::List(vec![matrix.clone()]), path)?],
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

pub(super) fn vector(file: &Path, value: &Tree, path: &str) -> Result<Vec<f64>, InputError> {
    let components = value.list().ok_or_else(|| {
        Problem::Shape(format!("expected a vector, found {}", value.describe())).at(file, Place::Path(path.to_owned()))
    })?;
    let component =
        |(index, value)| number(value).map_err(|problem| problem.at(file, Place::Path(format!("{path}[{index}]"))));
    components.iter().enumerate().map(component).collect()
}
