//! The shapes in which a JSON document holds a zonotope.

mod answer;

use std::path::Path;

use super::names::{self, Holder, MATRIX, POSE};
use super::object::{ENVELOPE, nothing, vectors, zonotope};
use super::placed::Placed;
use super::{Layout, OptionNames};
use crate::input::error::{InputError, Place, Problem, on_one_line};
use batch::KINDS;
use batch::json::Tree;

pub use answer::body_of_answer;

/// The zonotope of a document: a list of generators, a body with its fields, a question about one body, or an answer
/// that holds one. A line tells which fields are not read.
pub(super) fn placed(
    file: &Path,
    document: &Tree,
    layout: Layout,
    options: OptionNames,
    tell: &mut dyn FnMut(&str),
) -> Result<Placed, InputError> {
    if document.list().is_some() {
        let body = layout.body(file, (&[], Place::File), vectors(file, document, "")?, options, tell)?;
        return Ok(Placed { body, pose: None });
    }
    if !layout.is_plain() {
        let problem = format!(
            "is an object, whose fields say what its vectors are; {} and {} are for tables, arrays and lists",
            options.columns_are_generators, options.center_first
        );
        return Err(Problem::Shape(problem).at(file, Place::File));
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
        if whole.field(POSE).is_some() {
            return Err(whole.wrong(POSE, "stands beside `input`, and the pose of a body is a field of the body"));
        }
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

#[cfg(test)]
mod tests;
