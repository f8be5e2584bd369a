//! A JSON document in memory, read with a bound on the number of its values.

use std::cell::Cell;
use std::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error as _, MapAccess, SeqAccess, Visitor};
use thiserror::Error;

use super::number::NonFinite;

/// The largest number of values (numbers, strings, lists, objects, …) that a document may hold; about 32 bytes each.
pub const MAX_VALUES: usize = 8_000_000;

/// A JSON document. Numbers are doubles, correctly rounded; the fields of an object keep their order and occur once.
#[derive(Debug, Clone, PartialEq)]
pub enum Tree {
    /// `null`
    Null,
    /// `true` or `false`
    Bool(bool),
    /// A number.
    Number(f64),
    /// A string.
    Text(String),
    /// A list.
    List(Vec<Tree>),
    /// An object.
    Object(Vec<(String, Tree)>),
}

impl Tree {
    /// The field of an object.
    pub fn field(&self, name: &str) -> Option<&Tree> {
        match self {
            Self::Object(fields) => fields.iter().find(|(field, _)| field == name).map(|(_, value)| value),
            _ => None,
        }
    }

    /// The elements of a list.
    pub fn list(&self) -> Option<&[Tree]> {
        match self {
            Self::List(elements) => Some(elements),
            _ => None,
        }
    }

    /// A string.
    pub fn text(&self) -> Option<&str> {
        match self {
            Self::Text(text) => Some(text),
            _ => None,
        }
    }

    /// A float, a non-finite one that is spelled as a string included.
    pub fn float(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(*number),
            Self::Text(text) => NonFinite::spelled(text).map(NonFinite::value),
            _ => None,
        }
    }

    /// A whole number that indexes something.
    pub fn index(&self) -> Option<usize> {
        const EXACT: f64 = (1_u64 << 53) as f64;
        match self {
            Self::Number(number) if number.fract() == 0.0 && (0.0..EXACT).contains(number) => Some(*number as usize),
            _ => None,
        }
    }

    /// The kind of the value, for a message: "a string", "a list", …
    pub fn describe(&self) -> &'static str {
        match self {
            Self::Null => "null",
            Self::Bool(_) => "a boolean",
            Self::Number(_) => "a number",
            Self::Text(_) => "a string",
            Self::List(_) => "a list",
            Self::Object(_) => "an object",
        }
    }
}

/// Why a text is not read.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The text is not JSON.
    #[error("{message}")]
    Syntax {
        /// Line, counted from 1.
        line: usize,
        /// Column in bytes, counted from 1.
        column: usize,
        /// The parser's complaint.
        message: String,
    },
    /// A number is beyond the range of a double.
    #[error("a number is outside the range of a double")]
    OutOfRange {
        /// Line, counted from 1.
        line: usize,
        /// Column in bytes, counted from 1.
        column: usize,
    },
    /// A field occurs twice in one object.
    #[error("the field `{field}` occurs twice in one object")]
    RepeatedField {
        /// The field's name.
        field: String,
        /// Line, counted from 1.
        line: usize,
        /// Column in bytes, counted from 1.
        column: usize,
    },
    /// The document holds more values than the limit.
    #[error("more than {limit} values")]
    TooManyValues {
        /// The limit.
        limit: usize,
    },
}

/// Reads a document of at most `limit` values.
pub fn read(text: &[u8], limit: usize) -> Result<Tree, ReadError> {
    let reading = Reading { left: Cell::new(limit), exhausted: Cell::new(false), repeated: Cell::new(None) };
    let mut parser = serde_json::Deserializer::from_slice(text);
    let outcome = reading.deserialize(&mut parser).and_then(|tree| parser.end().map(|()| tree));
    outcome.map_err(|error| {
        let (line, column) = (error.line(), error.column());
        if reading.exhausted.get() {
            return ReadError::TooManyValues { limit };
        }
        if let Some(field) = reading.repeated.take() {
            return ReadError::RepeatedField { field, line, column };
        }
        let message = error.to_string();
        if message.starts_with("number out of range") {
            return ReadError::OutOfRange { line, column };
        }
        let place = format!(" at line {line} column {column}");
        let message = message.strip_suffix(&place).unwrap_or(&message).to_owned();
        ReadError::Syntax { line, column, message }
    })
}

/// The state of one reading.
struct Reading {
    /// Values that may still come.
    left: Cell<usize>,
    exhausted: Cell<bool>,
    /// The field that came twice.
    repeated: Cell<Option<String>>,
}

impl<'de> DeserializeSeed<'de> for &Reading {
    type Value = Tree;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Tree, D::Error> {
        match self.left.get().checked_sub(1) {
            Some(left) => self.left.set(left),
            None => {
                self.exhausted.set(true);
                return Err(D::Error::custom("too many values"));
            }
        }
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for &Reading {
    type Value = Tree;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a JSON value")
    }

    fn visit_unit<E>(self) -> Result<Tree, E> {
        Ok(Tree::Null)
    }

    fn visit_bool<E>(self, value: bool) -> Result<Tree, E> {
        Ok(Tree::Bool(value))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Tree, E> {
        Ok(Tree::Number(value as f64))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Tree, E> {
        Ok(Tree::Number(value as f64))
    }

    fn visit_f64<E>(self, value: f64) -> Result<Tree, E> {
        Ok(Tree::Number(value))
    }

    fn visit_str<E>(self, value: &str) -> Result<Tree, E> {
        Ok(Tree::Text(value.to_owned()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut elements: A) -> Result<Tree, A::Error> {
        let mut list = Vec::new();
        while let Some(element) = elements.next_element_seed(self)? {
            list.push(element);
        }
        Ok(Tree::List(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Tree, A::Error> {
        let mut fields: Vec<(String, Tree)> = Vec::new();
        while let Some(name) = entries.next_key::<String>()? {
            let value = entries.next_value_seed(self)?;
            fields.push((name, value));
        }
        let mut names: Vec<&str> = fields.iter().map(|(name, _)| name.as_str()).collect();
        names.sort_unstable();
        if let Some(pair) = names.windows(2).find(|pair| pair[0] == pair[1]) {
            self.repeated.set(Some(pair[0].to_owned()));
            return Err(A::Error::custom("a field occurs twice"));
        }
        Ok(Tree::Object(fields))
    }
}
