//! A question in the format of `solve`, and what `solve` says to it.

mod request;

use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use anyhow::{bail, ensure};
use batch::json::{NonFinite, Tree, rows_to_json, to_json, vector_to_json};
use batch::{Line, Verdict};
use clap::ValueEnum;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use serde_json::{Value, json};

pub(super) use self::request::{About, BodyFile, Recorded, SWEEP_FIELDS, record};
use super::table::counted;
use crate::input::{Body, Format, Placed};
use crate::progress::Progress;

/// A question with its answer.
pub(super) struct Asked {
    pub(super) question: Value,
    pub(super) answer: Value,
}

impl Asked {
    /// Asks; a question that is refused is an error.
    pub(super) fn of(question: Value) -> anyhow::Result<Self> {
        let asked = Self::even_if_refused(question);
        if let Some(error) = asked.answer.get("error") {
            bail!("{}", error["message"].as_str().unwrap_or("the question is refused"));
        }
        Ok(asked)
    }

    /// Asks; the answer may be a refusal.
    pub(super) fn even_if_refused(question: Value) -> Self {
        let _progress = Progress::of(1, "solving");
        let answer = batch::answer_line(1, &Line::Content(question.to_string().into_bytes()), 0).content;
        Self { question, answer }
    }

    /// The result in the answer.
    pub(super) fn result(&self) -> &Value {
        &self.answer["result"]
    }

    /// The verdict of the verifier, which shares no code with the solvers, on the answer.
    pub(super) fn verdict(&self) -> Verdict {
        let _progress = Progress::of(1, "checking");
        batch::verify(&self.question.to_string(), &self.answer.to_string())
    }

    /// The lines of the question and of the answer with the `request` that led to them.
    pub(super) fn lines(&self, request: Value) -> [Vec<u8>; 2] {
        let mut answer = Value::Null;
        for (name, value) in self.answer.as_object().into_iter().flatten() {
            // before what is long
            if name == "result" || name == "error" {
                answer["request"] = request.clone();
            }
            answer[name] = value.clone();
        }
        [&self.question, &answer].map(|content| format!("{content}\n").into_bytes())
    }
}

/// The formats that hold zonotopes, as the values of an option.
pub(super) fn body_formats() -> impl TypedValueParser<Value = Format> {
    let values = [
        PossibleValue::new("csv").help("A table with a generator a row"),
        PossibleValue::new("json").help("JSON: a list of generators, a zonotope, or an answer that holds one"),
        PossibleValue::new("npy").help("An array of NumPy with a generator a row"),
    ];
    PossibleValuesParser::new(values).try_map(|name| Format::from_str(&name, false))
}

/// A zonotope as a question has it.
pub(super) fn zonotope_of(body: &Body) -> Value {
    json!({"center": vector_to_json(&body.center), "generators": rows_to_json(&body.generators)})
}

/// Refuses a body whose number of coordinates a command does not take.
pub(super) fn check_taken(file: &Path, body: &Placed, taken: RangeInclusive<usize>) -> anyhow::Result<()> {
    let (least, most) = taken.clone().into_inner();
    let what = match (least, most) {
        (3, 3) => "bodies of space, with three, are taken".to_owned(),
        _ => format!("bodies with {least} to {most} are taken"),
    };
    let dimension = body.dimension();
    let coordinates = counted(dimension, "coordinate", "coordinates");
    ensure!(taken.contains(&dimension), "{}: has {coordinates}; {what}", file.display());
    Ok(())
}

/// Refuses two bodies of different dimensions, which have no question in common, or of one that is not taken.
pub(super) fn check_dimensions(
    [a, b]: [&PathBuf; 2],
    bodies: &[Placed; 2],
    taken: RangeInclusive<usize>,
) -> anyhow::Result<()> {
    let [in_a, in_b] = bodies.each_ref().map(Placed::dimension);
    let coordinates = counted(in_a, "coordinate", "coordinates");
    ensure!(in_a == in_b, "{}: has {coordinates}, while {} has {in_b}", a.display(), b.display());
    check_taken(a, &bodies[0], taken)
}

/// The command that checks an answer about some files which was written to a file, or how to write one. Standard input
/// cannot be read again, so that an answer about it is checked against its question.
pub(super) fn how_to_verify(files: &[&Path], question: Option<&PathBuf>, answer: Option<&PathBuf>) -> String {
    let are_there = !files.iter().any(|file| file.as_os_str() == "-");
    let words = |files: &[&Path]| files.iter().map(|file| format!("{} ", file.display())).collect::<String>();
    match (answer, question) {
        (Some(answer), _) if are_there => format!("zonobench verify {}{}", words(files), answer.display()),
        (Some(answer), Some(question)) if answer != question => {
            format!("zonobench verify {} {}", question.display(), answer.display())
        }
        _ if are_there => {
            format!("--json FILE writes the answer; zonobench verify {}FILE checks it", words(files))
        }
        _ => "--question Q --json A write question and answer; zonobench verify Q A checks them".to_owned(),
    }
}

/// A document as a part of a question or of an answer.
pub(super) fn value_of(tree: &Tree) -> Value {
    match tree {
        Tree::Null => Value::Null,
        Tree::Bool(truth) => (*truth).into(),
        Tree::Number(number) => to_json(*number),
        Tree::Text(text) => text.as_str().into(),
        Tree::List(elements) => elements.iter().map(value_of).collect(),
        Tree::Object(fields) => fields.iter().map(|(name, value)| (name.clone(), value_of(value))).collect(),
    }
}

/// A number of an answer.
pub(super) fn float(value: &Value) -> f64 {
    let spelled = || value.as_str().and_then(NonFinite::spelled).map(NonFinite::value);
    value.as_f64().or_else(spelled).unwrap_or(f64::NAN)
}

/// A vector of an answer.
pub(super) fn floats(value: &Value) -> Vec<f64> {
    value.as_array().into_iter().flatten().map(float).collect()
}
