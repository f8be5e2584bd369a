//! `zonobench verify`: answers checked against their questions, exactly.

mod data;

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use anyhow::Context;
use clap::Args;

use super::asking::Asking;
use super::usage::{Usage, check_inputs};
use super::{Ending, open};
use crate::input::on_one_line;
use crate::lines::Lines;
use batch::Line;
use batch::MAX_LINE_BYTES;
use batch::json::{self, MAX_VALUES, Tree};
use batch::{Verdict, check, check_unread};

/// Options of `verify`.
#[derive(Debug, Args)]
pub struct Options {
    /// The questions, one line of JSON each, as `solve` reads or `--question` writes them; or the data file that
    /// `enclose` was given.
    questions: PathBuf,
    /// The answers, in the order of the questions; or the file that `--json` wrote.
    answers: PathBuf,
    /// Of a data file, what `enclose` was asked, where the answer does not record it.
    #[command(flatten)]
    asking: Asking,
}

/// Checks every answer: a line each on standard output. Questions and answers are read side by side, one line at a
/// time, so that memory does not grow with their number.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    check_inputs(&[&options.questions, &options.answers])?;
    let mut answers = documents(&options.answers)?.peekable();
    if let Some(Err(_)) = answers.peek() {
        answers.next().transpose()?;
    }
    let first = answers.peek().and_then(|answer| answer.as_ref().ok()).and_then(Option::as_ref);
    let Some(about_data) = data::question(options, first)? else {
        if !options.asking.is_empty() {
            return Err(Usage::OptionsForQuestions(options.questions.clone()).into());
        }
        return of_questions(options, answers);
    };
    let mut output = BufWriter::new(io::stdout().lock());
    let (verdict, ending) = match answers.next().transpose()? {
        None => (Verdict::Wrong("there is no answer".to_owned()), Ending::Bad),
        Some(None) => (Verdict::Wrong("the answer is not JSON".to_owned()), Ending::Bad),
        Some(Some(answer)) => about_data.judge(&answer),
    };
    write_verdict(&mut output, &question_name(&options.questions), about_data.question(), &verdict)?;
    let others = counted(answers)?;
    if others > 0 {
        writeln!(output, "-\t-\tWRONG\t{} answers to 1 question", others + 1)?;
    }
    output.flush()?;
    Ok(if others > 0 { Ending::Bad } else { ending })
}

/// Checks the answers to questions that are lines of JSON.
fn of_questions(options: &Options, mut answers: impl Iterator<Item = Document>) -> anyhow::Result<Ending> {
    let mut output = BufWriter::new(io::stdout().lock());
    let (mut asked, mut wrong) = (0_u64, 0_u64);
    for question in documents(&options.questions)? {
        asked += 1;
        let (question, answer) = (question?, answers.next().transpose()?);
        let verdict = match (&question, &answer) {
            (_, None) => Verdict::Wrong("there is no answer".to_owned()),
            (_, Some(None)) => Verdict::Wrong("the answer is not JSON".to_owned()),
            (None, Some(Some(answer))) => check_unread(answer),
            (Some(question), Some(Some(answer))) => check(question, answer),
        };
        wrong += u64::from(matches!(verdict, Verdict::Wrong(_)));
        write_verdict(&mut output, &format!("question {asked}"), question.as_ref(), &verdict)?;
    }
    let others = counted(answers)?;
    if others > 0 {
        wrong += 1;
        writeln!(output, "-\t-\tWRONG\t{} answers to {asked} questions", asked + others)?;
    }
    output.flush()?;
    Ok(if wrong == 0 { Ending::Good } else { Ending::Bad })
}

/// How many documents are left.
fn counted(documents: impl Iterator<Item = Document>) -> anyhow::Result<u64> {
    let mut count = 0;
    for document in documents {
        document?;
        count += 1;
    }
    Ok(count)
}

/// Writes the line of a question; one without an id has the given name.
fn write_verdict(
    output: &mut impl Write,
    nameless: &str,
    question: Option<&Tree>,
    verdict: &Verdict,
) -> io::Result<()> {
    let name = |field| question.and_then(|question| question.field(field)).and_then(Tree::text).map(on_one_line);
    let [id, kind] = [("id", nameless), ("kind", "-")].map(|(field, other)| name(field).unwrap_or(other.to_owned()));
    let (word, reason) = match verdict {
        Verdict::Right(proved) => ("right", proved.clone()),
        Verdict::Unchecked(reason) => ("unchecked", on_one_line(reason)),
        Verdict::Wrong(reason) => ("WRONG", on_one_line(reason)),
    };
    writeln!(output, "{id}\t{kind}\t{word}\t{reason}")
}

/// The id of the question that a data file stands for.
pub(super) fn question_name(file: &Path) -> String {
    file.file_name().map_or_else(|| "points".to_owned(), |name| name.to_string_lossy().into_owned())
}

/// The JSON document of a line; `None` for a line that is not JSON.
type Document = anyhow::Result<Option<Tree>>;

/// The documents of a file's lines, read as they are asked for.
fn documents(file: &Path) -> anyhow::Result<impl Iterator<Item = Document>> {
    let unreadable = format!("{}: cannot be read", file.display());
    let lines = Lines::new(open(Some(file))?, MAX_LINE_BYTES);
    Ok(lines.map(move |line| match line.with_context(|| unreadable.clone())? {
        (_, Line::Content(text)) => Ok(json::read(&text, MAX_VALUES).ok()),
        (_, Line::TooLong) => Ok(None),
    }))
}
