//! A zonotope from a file: a table or an array of its vectors, a document, or an answer that holds a body.

mod document;
mod layout;
mod names;
mod object;
mod placed;
mod pose;

use std::path::{Path, PathBuf};

use super::bytes::{read_limited, text};
use super::document::parse;
use super::error::{InputError, Place, Problem, on_one_line};
use super::{Format, npy, table};

pub use document::body_of_answer;
pub use layout::Layout;
pub use placed::{ExactBody, Placed, RoundedBody};
pub use pose::PoseDocument;

/// A zonotope of any dimension: every vector has as many coordinates as the centre, at least one, all finite.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// The centre; the origin where the file has none.
    pub center: Vec<f64>,
    /// The generators.
    pub generators: Vec<Vec<f64>>,
    /// Whether the generators are rounded: products of directions and coefficients of an answer that no doubles equal.
    pub is_rounded: bool,
}

/// A file with a zonotope.
#[derive(Debug, Clone)]
pub struct BodySource {
    /// The file; `-` is standard input.
    pub file: PathBuf,
    /// Its format; told from the extension if absent.
    pub format: Option<Format>,
    /// Which vectors of a table or of an array are generators.
    pub layout: Layout,
}

impl BodySource {
    /// Reads the zonotope: vectors of a table or of an array, or a document: a list of generators, an object with a
    /// centre and generators by any of their names, perhaps with a `pose`, a question about one body, or an answer that
    /// holds one. What a reader may have meant otherwise, and what is not read, is told in one line each.
    pub fn read(&self, tell: impl Fn(&str)) -> Result<Placed, InputError> {
        let file = &self.file;
        let format = self
            .format
            .or_else(|| Format::of_extension(file))
            .ok_or_else(|| Problem::UnknownFormat.at(file, Place::File))?;
        let content = read_limited(file)?;
        let mut tell = |line: &str| tell(&on_one_line(&format!("{}: {line}", file.display())));
        match format {
            Format::Csv => {
                let rows = table::rows(file, text(&content))?;
                if rows.are_named_as_points() && self.layout == Layout::default() {
                    let names = rows.names.join(", ");
                    let advice = "`zonobench enclose` makes a body around points";
                    tell(&format!("each row of {names} is read as a generator; {advice}"));
                    return Ok(Placed { body: body(file, None, rows.numbers)?, pose: None });
                }
                let body = self.layout.body(file, &rows.names, rows.numbers, &mut tell)?;
                Ok(Placed { body, pose: None })
            }
            Format::Npy => {
                let body = self.layout.body(file, &[], npy::rows(file, &content)?, &mut tell)?;
                Ok(Placed { body, pose: None })
            }
            Format::Json => document::placed(file, &parse(file, text(&content))?, self.layout, &mut tell),
            other => {
                let problem = format!(
                    "the format {other} holds no zonotopes; csv, json and npy do, and `zonobench enclose {} --json \
                     body.json` makes one around its points",
                    file.display()
                );
                Err(Problem::Shape(problem).at(file, Place::File))
            }
        }
    }
}

fn body(file: &Path, center: Option<Vec<f64>>, generators: Vec<Vec<f64>>) -> Result<Body, InputError> {
    let Some(dimension) = center.as_ref().or(generators.first()).map(Vec::len).filter(|&dimension| dimension > 0)
    else {
        return Err(Problem::NoBody.at(file, Place::File));
    };
    if let Some(index) = generators.iter().position(|generator| generator.len() != dimension) {
        let problem = Problem::Ragged { found: generators[index].len(), expected: dimension };
        return Err(problem.at(file, Place::Path(format!("generators[{index}]"))));
    }
    Ok(Body { center: center.unwrap_or_else(|| vec![0.0; dimension]), generators, is_rounded: false })
}

#[cfg(test)]
mod tests;
