//! The names of the parts of a zonotope: questions are read under all names that files may give them.

use std::borrow::Cow;

use super::kinds::Kind;
use super::place::Place;
use super::refusal::{Code, Refusal};
use crate::json::Tree;

/// The names of the centre, the first of which kinds read.
pub const CENTERS: [&str; 3] = ["center", "centre", "c"];

/// The name of the centre beside a matrix `G` in pypolycontain.
pub const POINT: &str = "x";

/// The name of the list of generators.
pub const GENERATORS: &str = "generators";

/// The name of the matrix whose columns are the generators.
pub const MATRIX: &str = "G";

/// The fields of a question that hold a zonotope each.
const BODIES: [&str; 2] = ["a", "b"];

/// An input whose zonotopes have a `center` and `generators`, by whichever names they came. A name that stands beside
/// another of the same meaning stays, and is refused as a field that is not known.
pub(super) fn plain<'a>(input: &'a Tree, kind: &Kind) -> Result<Cow<'a, Tree>, Refusal> {
    let has = |name: &str| kind.fields.contains(&name);
    let is_body = has(GENERATORS);
    let bodies: Vec<&str> = BODIES.into_iter().filter(|name| has(name)).collect();
    let other = |body: &Tree, may_have_center: bool| {
        (may_have_center && center_of(body).is_some()) || matrix_of(body).is_some()
    };
    let needs_names = (is_body && other(input, has(CENTERS[0])))
        || bodies.iter().filter_map(|name| input.field(name)).any(|body| other(body, true));
    if !needs_names {
        return Ok(Cow::Borrowed(input));
    }
    let mut plain = input.clone();
    if is_body {
        rename(&mut plain, has(CENTERS[0]), &Place::default())?;
    }
    if let Tree::Object(fields) = &mut plain {
        for (name, body) in fields.iter_mut().filter(|(name, _)| bodies.contains(&name.as_str())) {
            rename(body, true, &Place::default().field(name))?;
        }
    }
    Ok(Cow::Owned(plain))
}

/// The question with its input as [`plain`] makes it.
pub(super) fn plain_question<'a>(question: &'a Tree, kind: &Kind) -> Result<Cow<'a, Tree>, Refusal> {
    let Some(input) = question.field("input") else { return Ok(Cow::Borrowed(question)) };
    let Cow::Owned(input) = plain(input, kind)? else { return Ok(Cow::Borrowed(question)) };
    let mut question = question.clone();
    if let Tree::Object(fields) = &mut question {
        fields.iter_mut().filter(|(name, _)| name == "input").for_each(|(_, value)| *value = input.clone());
    }
    Ok(Cow::Owned(question))
}

/// The name under which the centre stands, if it is another one than kinds read and the only one.
fn center_of(body: &Tree) -> Option<&'static str> {
    let point = (body.field(MATRIX).is_some() && body.field(GENERATORS).is_none()).then_some(POINT);
    let mut found = CENTERS.into_iter().chain(point).filter(|name| body.field(name).is_some());
    found.next().filter(|name| *name != CENTERS[0]).filter(|_| found.next().is_none())
}

/// The matrix of the generators, unless there is a list of them as well.
fn matrix_of(body: &Tree) -> Option<&Tree> {
    body.field(MATRIX).filter(|_| body.field(GENERATORS).is_none())
}

fn rename(body: &mut Tree, may_have_center: bool, place: &Place) -> Result<(), Refusal> {
    let center = center_of(body).filter(|_| may_have_center);
    let columns = matrix_of(body).map(|matrix| columns(matrix, &place.field(MATRIX))).transpose()?;
    let Tree::Object(fields) = body else { return Ok(()) };
    for (name, _) in fields.iter_mut().filter(|(name, _)| Some(name.as_str()) == center) {
        CENTERS[0].clone_into(name);
    }
    if let Some(columns) = columns {
        for field in fields.iter_mut().filter(|(name, _)| name == MATRIX) {
            *field = (GENERATORS.to_owned(), Tree::List(columns.clone()));
        }
    }
    Ok(())
}

/// The columns of a matrix.
fn columns(matrix: &Tree, place: &Place) -> Result<Vec<Tree>, Refusal> {
    let list = |value: &Tree, name: String| {
        let complaint = format!("`{name}` is {}, not a list", value.describe());
        value.list().map(<[Tree]>::to_vec).ok_or_else(|| Refusal::bad_input(complaint))
    };
    let row_name = |index: usize| format!("{place}, row {}", index + 1);
    let rows = list(matrix, place.to_string())?;
    let rows: Vec<Vec<Tree>> =
        rows.iter().enumerate().map(|(index, row)| list(row, row_name(index))).collect::<Result<_, _>>()?;
    let width = rows.first().map_or(0, Vec::len);
    if let Some(index) = rows.iter().position(|row| row.len() != width) {
        let message = format!("{} has {} numbers, not {width}", row_name(index), rows[index].len());
        return Err(Refusal::new(Code::DimensionMismatch, message));
    }
    Ok((0..width).map(|column| Tree::List(rows.iter().map(|row| row[column].clone()).collect())).collect())
}
