//! A question in the format of `solve`, and what `solve` says to it.

use std::path::PathBuf;

use anyhow::{bail, ensure};
use batch::json::NonFinite;
use batch::{Line, Verdict};
use serde_json::Value;

use super::table::counted;
use crate::input::Placed;
use crate::output::Outputs;

/// A question with its answer.
pub(super) struct Asked {
    pub(super) question: Value,
    pub(super) answer: Value,
}

impl Asked {
    /// Asks; a question that is refused is an error.
    pub(super) fn of(question: Value) -> anyhow::Result<Self> {
        let answer = batch::answer_line(1, &Line::Content(question.to_string().into_bytes()), 0);
        if answer.refused {
            bail!("{}", answer.content["error"]["message"].as_str().unwrap_or("the question is refused"));
        }
        Ok(Self { question, answer: answer.content })
    }

    /// The result in the answer.
    pub(super) fn result(&self) -> &Value {
        &self.answer["result"]
    }

    /// What the verifier, which shares no code with the solvers, says about the answer.
    pub(super) fn verdict(&self) -> Verdict {
        batch::verify(&self.question.to_string(), &self.answer.to_string())
    }

    /// Writes the question and the answer to the files that were asked for.
    pub(super) fn write(
        &self,
        question: Option<&PathBuf>,
        answer: Option<&PathBuf>,
        outputs: Outputs,
    ) -> anyhow::Result<()> {
        for (file, content) in [(question, &self.question), (answer, &self.answer)] {
            if let Some(file) = file {
                outputs.write(file, format!("{content}\n").as_bytes())?;
            }
        }
        Ok(())
    }
}

/// Refuses two bodies of different dimensions, which have no question in common.
pub(super) fn check_dimensions([a, b]: [&PathBuf; 2], bodies: &[Placed; 2]) -> anyhow::Result<()> {
    let [in_a, in_b] = bodies.each_ref().map(Placed::dimension);
    let coordinates = counted(in_a, "coordinate", "coordinates");
    ensure!(in_a == in_b, "{}: has {coordinates}, while {} has {in_b}", a.display(), b.display());
    Ok(())
}

/// The command that checks an answer which was written to a file, or how to write one.
pub(super) fn how_to_verify(question: Option<&PathBuf>, answer: Option<&PathBuf>) -> String {
    match (question, answer) {
        (Some(question), Some(answer)) => format!("zonobench verify {} {}", question.display(), answer.display()),
        _ => "--question Q --json A write question and answer; zonobench verify Q A checks them".to_owned(),
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
