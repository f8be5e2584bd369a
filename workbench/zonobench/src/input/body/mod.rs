//! A zonotope from a file: a table or an array of its vectors, a document, or an answer that holds a body.

mod document;
mod layout;
mod names;
mod object;
mod options;
mod placed;
mod pose;
mod zonotope;

pub use self::zonotope::Body;
use self::zonotope::body;
use std::path::PathBuf;

use super::bytes::read_limited;
use super::document::parse;
use super::error::{InputError, Place, Problem, on_one_line};
use super::names::bodies;
use super::number::in_json;
use super::{Format, npy, signature, table};
use crate::digest::sha256;

pub use document::body_of_answer;
pub use layout::Layout;
pub(super) use names::could_change_points;
pub use options::OptionNames;
pub use placed::{ExactBody, Placed, RoundedBody};
pub use pose::PoseDocument;

/// The longest part of a comment that a message quotes.
const COMMENT_LIMIT: usize = 60;

/// The content that a zonotope was read from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Origin {
    /// Its format.
    pub format: Format,
    /// Its SHA-256.
    pub sha256: String,
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
    /// The names of the options that a message may advise.
    pub options: OptionNames,
}

impl BodySource {
    /// Reads the zonotope, and tells which content of which format it was read from: vectors of a table or of an array,
    /// or a document: a list of generators, an object with a centre and generators by any of their names, perhaps with
    /// a `pose`, a question about one body, or an answer that holds one. What a reader may have meant otherwise, and
    /// what is not read, is told in one line each.
    pub fn read(&self, tell: impl Fn(&str)) -> Result<(Placed, Origin), InputError> {
        let format = self.told_format().map_err(|problem| problem.at(&self.file, Place::File))?;
        let content = read_limited(&self.file)?;
        self.check_content(format, &content)?;
        let mut tell = |line: &str| tell(&on_one_line(&format!("{}: {line}", self.file.display())));
        let placed = self.placed(format, &content, &mut tell)?;
        Ok((placed, Origin { format, sha256: sha256(&content) }))
    }

    /// The format that was chosen, or that the name tells.
    fn told_format(&self) -> Result<Format, Problem> {
        let file = &self.file;
        if let Some(format) = self.format.or_else(|| Format::of_extension(file)) {
            return Ok(format);
        }
        if let Err(error) = file.metadata()
            && file.as_os_str() != "-"
        {
            return Err(Problem::Unreadable(error));
        }
        let choice = format!("say csv, json or npy by {}", self.options.format);
        Err(match file.extension() {
            _ if file.is_dir() => Problem::Shape("is a folder, not a file".to_owned()),
            Some(extension) => Problem::Shape(format!(
                "files that end in .{} are not read as zonotopes; if it holds one, {choice}",
                on_one_line(&extension.to_string_lossy())
            )),
            None => Problem::Shape(format!("the format cannot be told from the name; {choice}")),
        })
    }

    /// The zonotope of a content.
    fn placed(&self, format: Format, content: &[u8], mut tell: &mut dyn FnMut(&str)) -> Result<Placed, InputError> {
        let file = &self.file;
        match format {
            Format::Csv => {
                let rows = table::rows(file, content, self.layout.order(), self.layout.skip);
                let rows = rows.map_err(|error| self.with_option(error))?;
                rows.notes.iter().for_each(|note| tell(note));
                if let Some(center) = self.called_center(&rows)? {
                    tell(&format!("row {} of numbers is read as the centre, as it is called", center + 1));
                    let mut generators = rows.numbers;
                    let center = generators.remove(center);
                    return Ok(Placed { body: body(file, Some(center), generators)?, pose: None });
                }
                self.refuse_comment_on_center(&rows)?;
                if rows.are_named_as_points() && self.layout.is_plain() {
                    let names = rows.names.join(", ");
                    let advice = "`zonobench enclose` makes a body around points";
                    tell(&format!("each row of {names} is read as a generator; {advice}"));
                    return Ok(Placed { body: body(file, None, rows.numbers)?, pose: None });
                }
                self.laid_out(rows, tell)
            }
            Format::Npy => {
                let rows = npy::rows(file, content, self.layout.order())?;
                rows.notes.iter().for_each(|note| tell(note));
                self.laid_out(rows, tell)
            }
            Format::Json => {
                in_json::losses(content, 1).in_words().iter().for_each(|losses| tell(losses));
                document::placed(file, &parse(file, content)?, self.layout, self.options, &mut tell)
            }
            other => Err(self.holds_none(other)),
        }
    }

    /// A complaint about lines of a table with the name that this body's option for them has.
    fn with_option(&self, error: InputError) -> InputError {
        let problem = match error.problem {
            Problem::TextAboveNumber { text, skip, .. } => {
                Problem::TextAboveNumber { text, skip, option: self.options.skip }
            }
            other => other,
        };
        InputError { problem, ..error }
    }

    /// The body of vectors that the names of the columns and the options tell.
    fn laid_out(&self, rows: table::Rows, mut tell: &mut dyn FnMut(&str)) -> Result<Placed, InputError> {
        let place = rows.header.map_or(Place::File, Place::Line);
        let body = self.layout.body(&self.file, (&rows.names, place), rows.numbers, self.options, &mut tell)?;
        Ok(Placed { body, pose: None })
    }

    /// The row that a column of names calls the centre, where rows are vectors; an error if there are two.
    fn called_center(&self, rows: &table::Rows) -> Result<Option<usize>, InputError> {
        if self.layout.columns_are_generators {
            return Ok(None);
        }
        let wrong = |problem: String, place: Place| Err(Problem::Shape(problem).at(&self.file, place));
        match *rows.centers.as_slice() {
            [(_, first), (_, second), ..] => wrong(
                format!("this row and that of line {first} are called a centre, and a body has one"),
                Place::Line(second),
            ),
            [(index, _)] if self.layout.center_first && index > 0 => {
                let option = self.options.center_first;
                let place = index + 1;
                wrong(
                    format!("row {place} of numbers is called a centre, while {option} takes the first one"),
                    Place::File,
                )
            }
            [(index, _)] => Ok(Some(index)),
            [] => Ok(None),
        }
    }

    /// Refuses a table without a centre of which a comment says something of one.
    fn refuse_comment_on_center(&self, rows: &table::Rows) -> Result<(), InputError> {
        let has_center = self.layout.center_first || !bodies::centers(&rows.names).is_empty();
        let Some((line, comment)) = rows.comment_on_center.as_ref().filter(|_| !has_center) else { return Ok(()) };
        let problem = format!(
            "the comment '{}' speaks of a centre, and comments are not read; name the columns center, g1, …, or put \
             the centre first and say {}",
            on_one_line(&comment.chars().take(COMMENT_LIMIT).collect::<String>()),
            self.options.center_first
        );
        Err(Problem::Shape(problem).at(&self.file, Place::Line(*line)))
    }

    /// Refuses a content that is of another format than the one in which it is to be read.
    fn check_content(&self, format: Format, content: &[u8]) -> Result<(), InputError> {
        let found = signature::other(format, content);
        match found.map_err(|problem| problem.at(&self.file, Place::File))? {
            Some(found) if !matches!(found, Format::Csv | Format::Json | Format::Npy) => Err(self.holds_none(found)),
            _ => signature::check(format, content, self.options.format)
                .map_err(|problem| problem.at(&self.file, Place::File)),
        }
    }

    /// The complaint about a format of points alone.
    fn holds_none(&self, format: Format) -> InputError {
        let file = &self.file;
        let problem = format!(
            "the format {format} holds no zonotopes; csv, json and npy do, and `zonobench enclose {} --json \
             body.json` makes one around its points",
            file.display()
        );
        Problem::Shape(problem).at(file, Place::File)
    }
}

#[cfg(test)]
mod tests;
