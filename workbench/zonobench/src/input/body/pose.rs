//! The content of a file of a pose.

use std::path::Path;

use super::object::vectors;
use crate::input::bytes::read_limited;
use crate::input::document::parse;
use crate::input::error::{InputError, Place, Problem, on_one_line};
use crate::input::names::Order;
use crate::input::number::in_json;
use crate::input::{Format, npy, table};
use batch::json::Tree;

/// The content of a file of a pose.
#[derive(Debug, Clone, PartialEq)]
pub enum PoseDocument {
    /// The rows of a matrix.
    Rows(Vec<Vec<f64>>),
    /// An object with fields.
    Object(Tree),
}

impl PoseDocument {
    /// Reads a table, an array, or a document of JSON, which a file is whose name tells no format.
    /// Remarks on the reading are told.
    pub fn read(file: &Path, tell: impl Fn(&str)) -> Result<Self, InputError> {
        let content = read_limited(file)?;
        let told = |note: &String| tell(&on_one_line(&format!("{}: {note}", file.display())));
        match Format::of_extension(file) {
            Some(Format::Csv) => {
                let rows = table::rows(file, &content, Order::Matrix, None)?;
                rows.notes.iter().for_each(told);
                Ok(Self::Rows(rows.numbers))
            }
            Some(Format::Npy) => {
                let rows = npy::rows(file, &content, Order::Matrix)?;
                rows.notes.iter().for_each(told);
                Ok(Self::Rows(rows.numbers))
            }
            None | Some(Format::Json) => {
                in_json::losses(&content, 1).in_words().iter().for_each(told);
                match parse(file, &content)? {
                    list @ Tree::List(_) => Ok(Self::Rows(vectors(file, &list, "")?)),
                    other => Ok(Self::Object(other)),
                }
            }
            Some(other) => {
                let problem = format!("the format {other} holds no poses; csv, json and npy do");
                Err(Problem::Shape(problem).at(file, Place::File))
            }
        }
    }
}
