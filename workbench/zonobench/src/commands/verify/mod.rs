//! `zonobench verify`: answers checked against their questions, exactly.

mod about;
mod bodies;
mod data;
mod documents;

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;

use self::about::AboutData;
use self::documents::{Documents, Sort, first_document, standard_input_holds_questions};
use super::Ending;
use super::asked::About;
use super::asking::Asking;
use super::table::counted;
use super::usage::{Usage, check_inputs, question_name};
use crate::input::on_one_line;
use crate::standard_output::{StandardOutput, check_standard_output};
use batch::json::Tree;
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
    /// command was given, in their order. These are one file for `enclose`, `sweep`, `reduce` and `inspect`, two for
    /// `intersect`, `distance`, `hausdorff`, `collide` and `contains`.
    #[arg(value_name = "FILE", num_args = 2..=3, required = true)]
    files: Vec<PathBuf>,
    /// The parts that the answer does not record of the question that was asked about files.
    #[command(flatten)]
    asking: Asking,
}

/// Checks every answer: a line each on standard output. Questions and answers are read side by side, one line at a
/// time, so that memory does not grow with their number.
pub fn run(options: &Options) -> anyhow::Result<Ending> {
    let Options { files, asking } = options;
    check_inputs(&files.iter().map(PathBuf::as_path).collect::<Vec<_>>())?;
    check_standard_output()?;
    let Some((answers, files)) = files.split_last() else { return Ok(Ending::Bad) };
    let mut answers = Documents::of(answers)?;
    if !answers.begin_with(Sort::Answer)? {
        return nothing_judged(&no_answers(files, &mut answers)?);
    }
    let Some(about_data) = about_files(files, asking, answers.first()?.flatten())? else {
        if !asking.is_empty() {
            return Err(Usage::OptionsForQuestions(files[0].clone()).into());
        }
        return of_questions(&files[0], answers);
    };
    let mut output = StandardOutput::open()?;
    let (verdict, ending) = match answers.next().transpose()? {
        Some(Some(answer)) => about_data.judge(&answer),
        _ => (Verdict::Wrong("the answer is not JSON".to_owned()), Ending::Bad),
    };
    let names: Vec<String> = files.iter().map(|file| question_name(file)).collect();
    write_verdict(&mut output, &names.join(" and "), about_data.question(), &verdict)?;
    let others = answers.counted()?;
    if others > 0 {
        writeln!(output, "-\t-\tWRONG\t{} answers to 1 question", others + 1)?;
    }
    output.finish()?;
    Ok(if others > 0 { Ending::Bad } else { ending })
}

/// Says in one line why nothing can be judged.
fn nothing_judged(reason: &str) -> anyhow::Result<Ending> {
    StandardOutput::print(format!("-\t-\tunchecked\t{}\n", on_one_line(reason)).as_bytes())?;
    Ok(Ending::Bad)
}

/// The message where the last file holds no answers.
fn no_answers(files: &[PathBuf], answers: &mut Documents) -> anyhow::Result<String> {
    let found = answers.described()?;
    for file in files.iter().filter(|file| file.as_os_str() != "-") {
        if Sort::of(first_document(file)?.as_ref()) == Sort::Answer {
            let file = file.display();
            return Ok(format!("{found}, where the answers are expected; {file} holds answers, so name it last"));
        }
    }
    Ok(format!(
        "{found}, where the answers are expected: what `solve` wrote, or a command by --json; before them stand the \
         questions, or the files that the answer is about"
    ))
}

/// The message where the file before the answers holds neither questions nor data; nothing if it may hold questions.
fn no_questions(questions: &mut Documents) -> anyhow::Result<Option<String>> {
    let sort = questions.first()?.map(Sort::of);
    let expected = match sort {
        Some(Sort::Answer) => {
            "where the questions are expected, or the files that the command was given: zonobench verify FILE ANSWER, \
             or A B ANSWER"
        }
        None | Some(Sort::Body | Sort::Points | Sort::List | Sort::Value) => {
            "where the questions are expected, and the answer does not record a file that it is about"
        }
        Some(Sort::Question | Sort::Object | Sort::NoJson) => return Ok(None),
    };
    Ok(if questions.begin_with(Sort::Question)? {
        None
    } else {
        Some(format!("{}, {expected}", questions.described()?))
    })
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

/// Whether a file may hold the questions: if the first line is a question, and standard input is not said to be of a
/// format.
fn may_hold_questions(file: &Path, asking: &Asking) -> anyhow::Result<bool> {
    if file.as_os_str() == "-" {
        return Ok(asking.points.format.is_none() && standard_input_holds_questions());
    }
    Ok(first_document(file)?.is_some_and(|first| first.field("kind").is_some() && first.field("input").is_some()))
}

/// Checks the answers to questions that are lines of JSON.
fn of_questions(questions: &Path, mut answers: Documents) -> anyhow::Result<Ending> {
    let mut questions = Documents::of(questions)?;
    if let Some(reason) = no_questions(&mut questions)? {
        return nothing_judged(&reason);
    }
    let mut output = StandardOutput::open()?;
    let (mut asked, mut of_others, mut is_good) = (0_u64, 0_u64, true);
    for question in questions {
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
                None => {
                    of_others += u64::from(is_of_another(question, answer));
                    check(question, answer)
                }
            },
        };
        is_good &= !matches!(verdict, Verdict::Wrong(_));
        write_verdict(&mut output, &format!("question {asked}"), question.as_ref(), &verdict)?;
    }
    let others = answers.counted()?;
    if others > 0 {
        is_good = false;
        writeln!(output, "-\t-\tWRONG\t{} answers to {}", asked + others, counted(asked, "question", "questions"))?;
    }
    if asked > 1 && of_others == asked {
        writeln!(output, "-\t-\tWRONG\tno answer has the id of its question, so they are not of one run")?;
    }
    output.finish()?;
    Ok(if is_good { Ending::Good } else { Ending::Bad })
}

/// Whether an answer has another id than the question.
fn is_of_another(question: &Tree, answer: &Tree) -> bool {
    let [asked, answered] = [question, answer].map(|tree| tree.field("id").and_then(Tree::text));
    asked != answered
}

/// The message where the lines are not a question and an answer, so that nothing can be judged.
fn exchanged(question: &Tree, answer: &Tree) -> Option<&'static str> {
    match (Sort::of(Some(question)), Sort::of(Some(answer))) {
        (Sort::Answer, _) => Some("an answer stands in the place of the question"),
        (_, Sort::Question) => Some("a question stands in the place of the answer"),
        _ => None,
    }
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
