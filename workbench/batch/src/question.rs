//! One question: its envelope read, and the search for numbers that are not finite.

use serde::Deserialize;
use serde::de::IgnoredAny;

use super::dimension::explained;
use super::fields::Fields;
use super::kinds::{HeldBody, KINDS, Solution};
use super::names::plain;
use super::nearest::did_you_mean;
use super::pictures::{PICTURES, Sheet};
use super::place::{Place, Step};
use super::refusal::{Code, Refusal};
use crate::json::{self, MAX_VALUES, NonFinite, ReadError, Tree};

/// A question whose envelope is in order.
#[derive(Debug)]
pub(super) struct Question {
    pub(super) id: String,
    pub(super) kind: String,
    method: Option<String>,
    input: Tree,
}

/// A line that is no question; what of its envelope could be read is given back.
#[derive(Debug)]
pub(super) struct Unread {
    pub(super) refusal: Refusal,
    pub(super) id: Option<String>,
    pub(super) kind: Option<String>,
}

/// Reads the question on line `number`.
pub(super) fn read(number: u64, text: &[u8]) -> Result<Question, Unread> {
    let tree = json::read(text, MAX_VALUES).map_err(|error| unreadable(number, text, &error))?;
    let echo = |name| tree.field(name).and_then(Tree::text).map(str::to_owned);
    let (id, kind) = (echo("id"), echo("kind"));
    envelope(tree).map_err(|refusal| Unread { refusal, id, kind })
}

fn envelope(tree: Tree) -> Result<Question, Refusal> {
    let Tree::Object(fields) = tree else {
        return Err(Refusal::bad_input(format!("a question is an object, not {}", tree.describe())));
    };
    let input = fields.iter().find(|(name, _)| name == "input");
    if let Some((place, number)) = input.and_then(|(_, input)| first_non_finite(input)) {
        return Err(Refusal::new(Code::NonFinite, format!("{place} is {number}")));
    }
    let within = if input.is_none() { "; what a kind takes are fields of `input`" } else { "" };
    let [mut id, mut kind, mut method, mut input] = [const { None }; 4];
    for (name, value) in fields {
        let slot = match name.as_str() {
            "id" => &mut id,
            "kind" => &mut kind,
            "method" => &mut method,
            "input" => &mut input,
            other => {
                let near = did_you_mean(other, ["id", "kind", "method", "input"]);
                return Err(Refusal::bad_input(format!("extra field `{name}` in the question{near}{within}")));
            }
        };
        *slot = Some(value);
    }
    let text = |name: &str, value: Option<Tree>| match value {
        None => Ok(None),
        Some(Tree::Text(text)) => Ok(Some(text)),
        Some(other) => Err(Refusal::bad_input(format!("`{name}` is {}, not a string", other.describe()))),
    };
    let missing = |name: &str| Refusal::bad_input(format!("missing field `{name}` in the question"));
    Ok(Question {
        id: text("id", id)?.ok_or_else(|| missing("id"))?,
        kind: text("kind", kind)?.ok_or_else(|| missing("kind"))?,
        method: text("method", method)?,
        input: input.ok_or_else(|| missing("input"))?,
    })
}

impl Question {
    /// The answer's content, or why there is none.
    pub(super) fn solve(&self, seed: u64) -> Result<Solution, Refusal> {
        let kind = KINDS.iter().find(|kind| kind.name == self.kind);
        let kind = kind.ok_or_else(|| self.unknown_kind("kind", KINDS.iter().map(|kind| kind.name)))?;
        let methods = (kind.methods)();
        let method = match &self.method {
            None => None,
            Some(wanted) => Some(methods.iter().copied().find(|name| name == wanted).ok_or_else(|| {
                let known = methods.join(", ");
                let near = did_you_mean(wanted, methods.iter().copied());
                let message = format!("`{}` has no method `{wanted}`; its methods are {known}{near}", kind.name);
                Refusal::new(Code::UnknownMethod, message)
            })?),
        };
        let input = plain(&self.input, kind)?;
        (kind.solve)(&Fields::of_input(&input, kind.fields, kind.optional)?, method, seed)
            .map_err(|refusal| explained(refusal, kind.name))
    }

    /// The body that the input is, or why it is none.
    pub(super) fn held(&self) -> Result<HeldBody, Refusal> {
        if self.kind != HeldBody::KIND {
            return Err(self.unknown_kind("thing to hold", std::iter::once(HeldBody::KIND)));
        }
        HeldBody::read(&Fields::of_input(&self.input, &HeldBody::FIELDS, &[])?)
    }

    /// The data of the picture, or why there is none.
    pub(super) fn draw(&self) -> Result<Sheet, Refusal> {
        let picture = PICTURES.iter().find(|picture| picture.name == self.kind);
        let picture = picture.ok_or_else(|| self.unknown_kind("picture", PICTURES.iter().map(|p| p.name)))?;
        if self.method.is_some() {
            return Err(Refusal::new(Code::UnknownMethod, format!("`{}` has no methods", picture.name)));
        }
        (picture.draw)(&Fields::of_input(&self.input, picture.fields, &[])?)
    }

    fn unknown_kind(&self, what: &str, known: impl Iterator<Item = &'static str> + Clone) -> Refusal {
        let near = did_you_mean(&self.kind, known.clone());
        let known = known.collect::<Vec<_>>().join(", ");
        Refusal::new(Code::UnknownKind, format!("there is no {what} `{}`; the {what}s are {known}{near}", self.kind))
    }
}

fn unreadable(number: u64, text: &[u8], error: &ReadError) -> Unread {
    let refusal = match error {
        ReadError::Syntax { column, message, .. } => {
            Refusal::new(Code::BadJson, format!("line {number}, column {column}: {message}"))
        }
        ReadError::OutOfRange { column, .. } => {
            Refusal::new(Code::NonFinite, format!("line {number}, column {column}: {error}"))
        }
        ReadError::RepeatedField { .. } => Refusal::bad_input(error.to_string()),
        ReadError::TooManyValues { .. } => Refusal::new(Code::TooLarge, format!("line {number} holds {error}")),
    };
    let names = serde_json::from_slice::<Names>(text).unwrap_or_default();
    Unread { refusal, id: names.id, kind: names.kind }
}

/// The reading of a line whose input cannot be taken.
#[derive(Default, Deserialize)]
struct Names {
    id: Option<String>,
    kind: Option<String>,
    #[serde(rename = "input")]
    _input: Option<IgnoredAny>,
}

/// The first number of the input that is spelled as NaN or an infinity, and its place.
fn first_non_finite(input: &Tree) -> Option<(Place, NonFinite)> {
    let mut steps = Vec::new();
    let number = search(input, &mut steps)?;
    Some((Place(steps), number))
}

fn search(value: &Tree, steps: &mut Vec<Step>) -> Option<NonFinite> {
    let mut enter = |step: Step, value: &Tree| {
        steps.push(step);
        let found = search(value, steps);
        if found.is_none() {
            steps.pop();
        }
        found
    };
    match value {
        Tree::Text(text) => NonFinite::spelled(text),
        Tree::List(elements) => (0..).zip(elements).find_map(|(index, element)| enter(Step::Element(index), element)),
        Tree::Object(fields) => fields.iter().find_map(|(name, value)| enter(Step::Field(name.clone()), value)),
        Tree::Null | Tree::Bool(_) | Tree::Number(_) => None,
    }
}
