//! `zonobench verify`: answers checked against their questions, exactly.

mod about;
mod bodies;
mod data;

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use anyhow::Context;
use clap::Args;

use self::about::AboutData;
use super::asked::About;
use super::asking::Asking;
use super::usage::{Usage, check_inputs};
use super::{Ending, open};
use crate::input::on_one_line;
use crate::lines::Lines;
use batch::Line;
use batch::MAX_LINE_BYTES;
use batch::json::{self, MAX_VALUES, Tree};
use batch::{Verdict, check, check_unread};

/// The files of each sort of answer.
const USAGE: &str = "zonobench verify [OPTIONS] <QUESTIONS> <ANSWERS>
       zonobench verify [OPTIONS] <FILE> <ANSWER>
       zonobench verify [OPTIONS] <A> <B> <ANSWER>";

/// Options of `verify`.
#[derive(Debug, Args)]
#[command(override_usage = USAGE)]
pub struct Options {
    /// The questions and then the answers; or the files that an answer is about and then the answer.
    ///
    /// Questions are lines of JSON, as `solve` reads or `--question` writes them, and the answers lines in their order.
    /// An answer that a command wrote by `--json` records what was asked: it is checked against the files that the
    /// command was given, in their order. These are one file for `enclose`, `reduce` and `inspect`, and two for
    /// `intersect`, `distance` and `contains`.
    #[arg(value_name = "FILE", num_args = 2..=3, required = true)]
    files: Vec<PathBuf>,
    /// Facts that the answer does not record of the question that was asked about files.
    #[command(flatten)]
    asking: Asking,
}

/// Checks every answer: a line each on standard output. Questions and answers are read side by side, one line at a
/// time, so that memory does not grow with their number.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let Options { files, asking } = options;
    check_inputs(&files.iter().map(PathBuf::as_path).collect::<Vec<_>>())?;
    let Some((answers, files)) = files.split_last() else { return Ok(Ending::Bad) };
    let mut answers = documents(answers)?.peekable();
    if let Some(Err(_)) = answers.peek() {
        answers.next().transpose()?;
    }
    let first = answers.peek().and_then(|answer| answer.as_ref().ok()).and_then(Option::as_ref);
    let Some(about_data) = about_files(files, asking, first)? else {
        if !asking.is_empty() {
            return Err(Usage::OptionsForQuestions(files[0].clone()).into());
        }
        return of_questions(&files[0], answers);
    };
    let mut output = BufWriter::new(io::stdout().lock());
    let (verdict, ending) = match answers.next().transpose()? {
        None => (Verdict::Wrong("there is no answer".to_owned()), Ending::Bad),
        Some(None) => (Verdict::Wrong("the answer is not JSON".to_owned()), Ending::Bad),
        Some(Some(answer)) => about_data.judge(&answer),
    };
    let names: Vec<String> = files.iter().map(|file| question_name(file)).collect();
    write_verdict(&mut output, &names.join(" and "), about_data.question(), &verdict)?;
    let others = counted(answers)?;
    if others > 0 {
        writeln!(output, "-\t-\tWRONG\t{} answers to 1 question", others + 1)?;
    }
    output.flush()?;
    Ok(if others > 0 { Ending::Bad } else { ending })
}

/// The question that was asked about some files; `None` where the one file holds questions, or answers.
fn about_files(files: &[PathBuf], asking: &Asking, answer: Option<&Tree>) -> anyhow::Result<Option<AboutData>> {
    let about = answer.and_then(About::of_answer).map(|about| (about, about.are_bodies().count()));
    match (files, about, answer) {
        (files, Some((about, count)), Some(answer)) if files.len() == count => {
            let is_about_these = count > 1 || !may_hold_questions(&files[0], asking)?;
            if is_about_these {
                return bodies::question(files, asking, about, answer).map(Some);
            }
        }
        ([_, _, ..], ..) => return Err(Usage::NotAboutTwoFiles.into()),
        ([file], Some(_), _) if file.as_os_str() != "-" && !is_named_by_kind(file)? => {
            let reason = "the answer is about two files: zonobench verify A B ANSWER checks it";
            return Ok(Some(AboutData::without_question(reason.to_owned())));
        }
        _ => {}
    }
    data::question(&files[0], asking, answer)
}

/// Whether the first line of a file names a kind, as questions and answers do.
fn is_named_by_kind(file: &Path) -> anyhow::Result<bool> {
    Ok(first_document(file)?.is_some_and(|first| first.field("kind").is_some()))
}

/// Whether a file may hold the questions: standard input does unless its format is told; others if the first line is a
/// question.
fn may_hold_questions(file: &Path, asking: &Asking) -> anyhow::Result<bool> {
    if file.as_os_str() == "-" {
        return Ok(asking.points.format.is_none());
    }
    Ok(first_document(file)?.is_some_and(|first| first.field("kind").is_some() && first.field("input").is_some()))
}

/// Checks the answers to questions that are lines of JSON.
fn of_questions(questions: &Path, mut answers: impl Iterator<Item = Document>) -> anyhow::Result<Ending> {
    let mut output = BufWriter::new(io::stdout().lock());
    let (mut asked, mut is_good) = (0_u64, true);
    for question in documents(questions)? {
        asked += 1;
        let (question, answer) = (question?, answers.next().transpose()?);
        let verdict = match (&question, &answer) {
            (_, None) => Verdict::Wrong("there is no answer".to_owned()),
            (_, Some(None)) => Verdict::Wrong("the answer is not JSON".to_owned()),
            (None, Some(Some(answer))) => check_unread(answer),
            (Some(question), Some(Some(answer))) => match exchanged(question, answer) {
                Some(reason) => {
                    is_good = false;
                    Verdict::Unchecked(reason.to_owned())
                }
                None => check(question, answer),
            },
        };
        is_good &= !matches!(verdict, Verdict::Wrong(_));
        write_verdict(&mut output, &format!("question {asked}"), question.as_ref(), &verdict)?;
    }
    let others = counted(answers)?;
    if asked + others == 0 {
        is_good = false;
        writeln!(output, "-\t-\tunchecked\tthere is no question and no answer")?;
    }
    if others > 0 {
        is_good = false;
        writeln!(output, "-\t-\tWRONG\t{} answers to {asked} questions", asked + others)?;
    }
    output.flush()?;
    Ok(if is_good { Ending::Good } else { Ending::Bad })
}

/// The note where the lines are not a question and an answer, so that nothing can be judged.
fn exchanged(question: &Tree, answer: &Tree) -> Option<&'static str> {
    let is_answer = |line: &Tree| line.field("result").or(line.field("error")).is_some();
    let is_question = |line: &Tree| line.field("input").is_some();
    match (is_question(question), is_answer(question), is_question(answer), is_answer(answer)) {
        (false, true, true, false) => Some("the answer comes first and then the question; name the question first"),
        (false, true, ..) => Some(
            "the first file holds an answer and no question; before an answer stand its questions, or the files that \
             the command was given: zonobench verify FILE ANSWER, or A B ANSWER",
        ),
        (true, _, true, false) => Some("the second file holds a question and no answer"),
        _ => None,
    }
}

/// The number of documents that are left.
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

/// The document of a file's first line, if that is JSON.
fn first_document(file: &Path) -> anyhow::Result<Option<Tree>> {
    documents(file)?.next().transpose().map(Option::flatten)
}
