//! `zonobench verify`: answers checked against their questions, exactly.

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use anyhow::Context;
use clap::Args;

use super::asking::{Asking, Objective};
use super::{Ending, open};
use crate::batch::MAX_LINE_BYTES;
use crate::input::{Format, on_one_line};
use crate::json::{self, Line, Lines, MAX_VALUES, Tree};
use crate::verify::{Verdict, check};

/// Options of `verify`.
#[derive(Debug, Args)]
pub struct Options {
    /// The questions, one line of JSON each, as `solve` reads or `--question` writes them; or the data file that `enclose` was
    /// given.
    questions: PathBuf,
    /// The answers, in the order of the questions; or the file that `--json` wrote.
    answers: PathBuf,
    /// Of a data file, what `enclose` was asked.
    #[command(flatten)]
    asking: Asking,
}

/// Checks every answer: a line each on standard output.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let Questions { trees: mut questions, are_data } = questions(options)?;
    let answers = lines(&options.answers)?;
    let mut output = BufWriter::new(io::stdout().lock());
    let mut wrong = 0;
    if are_data && let (Some(Some(question)), Some(Some(answer))) = (questions.first_mut(), answers.first()) {
        rename(question, answer);
    }
    for (index, question) in questions.iter().enumerate() {
        let verdict = match (question, answers.get(index)) {
            (_, None) => Verdict::Wrong("there is no answer".to_owned()),
            (_, Some(None)) => Verdict::Wrong("the answer is not JSON".to_owned()),
            (None, Some(Some(answer))) => unread_question(answer),
            (Some(question), Some(Some(answer))) => check(question, answer),
        };
        let name = |name| question.as_ref().and_then(|question| question.field(name)).and_then(Tree::text);
        write!(output, "{}", name("id").map_or_else(|| format!("question {}", index + 1), on_one_line))?;
        write!(output, "\t{}\t", name("kind").map_or_else(|| "-".to_owned(), on_one_line))?;
        match verdict {
            Verdict::Right(proved) => writeln!(output, "right\t{proved}")?,
            Verdict::Unchecked(reason) => writeln!(output, "unchecked\t{}", on_one_line(&reason))?,
            Verdict::Wrong(reason) => {
                wrong += 1;
                writeln!(output, "WRONG\t{}", on_one_line(&reason))?;
            }
        }
    }
    if answers.len() > questions.len() {
        wrong += 1;
        writeln!(output, "-\t-\tWRONG\t{} answers to {} questions", answers.len(), questions.len())?;
    }
    output.flush()?;
    Ok(if wrong == 0 { Ending::Good } else { Ending::Bad })
}

/// A line that is no JSON document must have been refused.
fn unread_question(answer: &Tree) -> Verdict {
    match answer.field("error") {
        Some(_) => Verdict::Unchecked("refused; the question is no JSON document that is read here".to_owned()),
        None => Verdict::Wrong("the question is not JSON, but it was answered".to_owned()),
    }
}

/// What answers are checked against.
struct Questions {
    trees: Vec<Option<Tree>>,
    /// Whether they are one question made of a data file.
    are_data: bool,
}

impl Questions {
    fn of_data(question: Option<Tree>) -> Self {
        Self { trees: vec![question], are_data: true }
    }

    fn of_lines(file: &Path) -> anyhow::Result<Self> {
        Ok(Self { trees: lines(file)?, are_data: false })
    }
}

/// Data are asked about under whatever name the answer has.
fn rename(question: &mut Tree, answer: &Tree) {
    if let (Tree::Object(fields), Some(id)) = (question, answer.field("id")) {
        fields.iter_mut().filter(|(name, _)| name == "id").for_each(|(_, own)| *own = id.clone());
    }
}

/// The questions; a data file is one question, named after the file.
fn questions(options: &Options) -> anyhow::Result<Questions> {
    let file = &options.questions;
    let asking = &options.asking;
    let source = asking.source(file);
    let format = source.known_format();
    if format.is_none() {
        return Questions::of_lines(file);
    }
    if asking.format.is_none() && format == Some(Format::Json) {
        // What the name does not tell, the content does: data have no kind.
        let questions = Questions::of_lines(file)?;
        let first = questions.trees.first();
        if first.is_some_and(|first| first.as_ref().is_some_and(|first| first.field("kind").is_some())) {
            return Ok(questions);
        }
    }
    if asking.objective(file)? == Objective::Length {
        let question = asking.question_of_length(&question_name(file), &source.read_any()?)?;
        return Ok(Questions::of_data(json::read(question.to_string().as_bytes(), MAX_VALUES).ok()));
    }
    let points = source.read()?;
    let points = points.into_iter().map(|point| Tree::List(point.map(Tree::Number).into())).collect();
    let text = |text: &str| Tree::Text(text.to_owned());
    Ok(Questions::of_data(Some(Tree::Object(vec![
        ("id".to_owned(), text(&question_name(file))),
        ("kind".to_owned(), text("min_area")),
        ("input".to_owned(), Tree::Object(vec![("points".to_owned(), Tree::List(points))])),
    ]))))
}

/// The id of the question that a data file stands for.
pub(super) fn question_name(file: &Path) -> String {
    file.file_name().map_or_else(|| "points".to_owned(), |name| name.to_string_lossy().into_owned())
}

/// The JSON documents of a file's lines; `None` for a line that is not read.
fn lines(file: &Path) -> anyhow::Result<Vec<Option<Tree>>> {
    let unreadable = || format!("{}: cannot be read", file.display());
    Lines::new(open(Some(file))?, MAX_LINE_BYTES)
        .map(|line| match line.with_context(unreadable)? {
            (_, Line::Content(text)) => Ok(json::read(&text, MAX_VALUES).ok()),
            (_, Line::TooLong) => Ok(None),
        })
        .collect()
}
