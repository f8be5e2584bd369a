//! The lines of a file as JSON documents, and what a file holds where `verify` expects something else.

use std::collections::VecDeque;
use std::io::{self, BufRead};
use std::path::{Path, PathBuf};

use anyhow::Context;
use batch::json::{self, MAX_VALUES, ReadError, Tree};
use batch::{Line, MAX_LINE_BYTES};

use crate::commands::open;
use crate::lines::Lines;

/// The JSON document of a line; `None` for a line that is not JSON.
pub(super) type Document = anyhow::Result<Option<Tree>>;

/// A file holds none of what is expected if none of its first lines is of that sort.
const FIRST_LINES: usize = 32;

/// The sort of a document.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sort {
    Question,
    Answer,
    Body,
    Points,
    Object,
    List,
    Value,
    NoJson,
}

impl Sort {
    /// The sort of a line's document.
    pub(super) fn of(document: Option<&Tree>) -> Self {
        let Some(tree) = document else { return Self::NoJson };
        let has = |names: &[&str]| names.iter().any(|name| tree.field(name).is_some());
        match tree {
            Tree::Object(_) if has(&["result", "error"]) => Self::Answer,
            Tree::Object(_) if has(&["input"]) => Self::Question,
            Tree::Object(_) if has(&["generators", "G"]) => Self::Body,
            Tree::Object(_) if has(&["points", "x", "features", "geometry", "coordinates"]) => Self::Points,
            Tree::Object(_) => Self::Object,
            Tree::List(_) => Self::List,
            _ => Self::Value,
        }
    }

    /// The content of a file of such lines, in words.
    fn in_words(self) -> &'static str {
        match self {
            Self::Question => "questions",
            Self::Answer => "answers",
            Self::Body => "a zonotope",
            Self::Points => "points",
            Self::Object => "JSON that is neither question nor answer",
            Self::List => "a list in JSON, as points or generators",
            Self::Value => "a value in JSON that is neither question nor answer",
            Self::NoJson => "no JSON",
        }
    }
}

/// The documents of a file's lines, read as they are asked for, and those that were looked at before.
pub(super) struct Documents {
    file: PathBuf,
    lines: Lines<Box<dyn BufRead>>,
    seen: VecDeque<Option<Tree>>,
    /// The first field that came twice in an object, in words: such a line is JSON that has no single meaning.
    repeated: Option<String>,
}

impl Documents {
    /// The documents of a file.
    pub(super) fn of(file: &Path) -> anyhow::Result<Self> {
        let lines = Lines::new(open(Some(file))?, MAX_LINE_BYTES);
        Ok(Self { file: file.to_path_buf(), lines, seen: VecDeque::new(), repeated: None })
    }

    fn read(&mut self) -> Option<Document> {
        let line = self.lines.next()?.with_context(|| format!("{}: cannot be read", self.file.display()));
        Some(line.map(|(_, line)| match line {
            Line::Content(text) => json::read(&text, MAX_VALUES).inspect_err(|error| self.note_repeated(error)).ok(),
            Line::TooLong => None,
        }))
    }

    fn note_repeated(&mut self, error: &ReadError) {
        if let ReadError::RepeatedField { .. } = error {
            self.repeated.get_or_insert_with(|| error.to_string());
        }
    }

    /// The first document, if there is any.
    pub(super) fn first(&mut self) -> anyhow::Result<Option<Option<&Tree>>> {
        if self.seen.is_empty()
            && let Some(document) = self.read()
        {
            self.seen.push_back(document?);
        }
        Ok(self.seen.front().map(Option::as_ref))
    }

    /// Whether one of the first documents is of a sort.
    pub(super) fn begin_with(&mut self, sort: Sort) -> anyhow::Result<bool> {
        let is_of_sort = |document: &Option<Tree>| Sort::of(document.as_ref()) == sort;
        let mut is_found = self.seen.iter().any(is_of_sort);
        while !is_found && self.seen.len() < FIRST_LINES {
            let Some(document) = self.read().transpose()? else { break };
            is_found = is_of_sort(&document);
            self.seen.push_back(document);
        }
        Ok(is_found)
    }

    /// The file with what its first line shows it to hold.
    pub(super) fn described(&mut self) -> anyhow::Result<String> {
        let file = self.file.display().to_string();
        let sort = self.first()?.map(Sort::of);
        Ok(match (sort, &self.repeated) {
            (None, _) => format!("{file} is empty"),
            (Some(Sort::NoJson), Some(repeated)) => format!("{file} holds JSON in which {repeated}"),
            (Some(sort), _) => format!("{file} holds {}", sort.in_words()),
        })
    }

    /// The number of documents that are left.
    pub(super) fn counted(self) -> anyhow::Result<u64> {
        let mut count = 0;
        for document in self {
            document?;
            count += 1;
        }
        Ok(count)
    }
}

impl Iterator for Documents {
    type Item = Document;

    fn next(&mut self) -> Option<Document> {
        self.seen.pop_front().map(Ok).or_else(|| self.read())
    }
}

/// The document of a file's first line, if that is JSON.
pub(super) fn first_document(file: &Path) -> anyhow::Result<Option<Tree>> {
    Ok(Documents::of(file)?.next().transpose()?.flatten())
}

/// Whether standard input begins like questions, as far as can be told without taking anything from it: an object that
/// names a kind and, if it is one of long lines, nothing that answers have.
pub(super) fn standard_input_holds_questions() -> bool {
    let mut input = io::stdin().lock();
    // A document that cannot be read is told when it is to be read.
    input.fill_buf().is_ok_and(begins_like_a_question)
}

fn begins_like_a_question(start: &[u8]) -> bool {
    let text = String::from_utf8_lossy(start);
    let line = text.trim_start_matches(['\u{feff}', ' ', '\t', '\r', '\n']).lines().next().unwrap_or_default();
    let has = |name: &str| line.contains(&format!("\"{name}\""));
    line.starts_with('{') && has("kind") && (has("input") || !has("result") && !has("request"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sorts_are_told_by_their_fields() {
        let sort = |text: &str| Sort::of(json::read(text.as_bytes(), MAX_VALUES).ok().as_ref());
        for (text, expected) in [
            (r#"{"id":"q","kind":"gauge","input":{}}"#, Sort::Question),
            (r#"{"id":"q","kind":"gauge","result":{}}"#, Sort::Answer),
            (r#"{"id":null,"kind":null,"error":{}}"#, Sort::Answer),
            (r#"{"c":[0],"G":[[1]]}"#, Sort::Body),
            (r#"{"type":"FeatureCollection","features":[]}"#, Sort::Points),
            (r#"{"answer":1}"#, Sort::Object),
            ("[[0,0]]", Sort::List),
            ("0", Sort::Value),
            ("x,y", Sort::NoJson),
        ] {
            assert_eq!(sort(text), expected, "{text}");
        }
    }

    #[test]
    fn questions_are_told_from_data_by_how_they_begin() {
        for text in ["{\"id\":\"q\",\"kind\":\"gauge\",\"input\":{\"p\":[0", "\u{feff}\n {\"kind\": \"gauge\""] {
            assert!(begins_like_a_question(text.as_bytes()), "{text}");
        }
        for text in ["", "0,0\n2,0\n", "[[1,0]]", "{\"c\":[1],\"G\":[[1]]}", "{\"kind\":\"reduce\",\"result\":{"] {
            assert!(!begins_like_a_question(text.as_bytes()), "{text}");
        }
    }
}
