//! Random mutants of answers: none that says something false is called right, and none stops the verifier.
//!
//! An ordinary run sees a share of the mutants; `ZONOTOPE_MUTANTS` names another number of them.

use std::collections::BTreeMap;

use batch::json::{MAX_VALUES, Tree, read};
use batch::{Line, Verdict, answer_line, check, verify};
use serde_json::Value;
use tests::dice::Dice;
use tests::questions::neighbour;

use crate::bounds::Known;
use crate::{kinds, mutation};

/// Each answer is changed so many times.
pub const MUTANTS_AN_ANSWER: usize = 50;

/// The answers to so many questions that differ from the question by one number are held against it.
const NEIGHBOURS: usize = 6;

/// The text of each answer is damaged so many times.
const DAMAGED_TEXTS: usize = 4;

/// The verdicts on the mutants of a kind.
#[derive(Debug, Default, Clone)]
pub struct Counts {
    /// All that differ from the answer.
    pub mutants: usize,
    /// Those that are called right, and are.
    pub harmless: usize,
    /// Those that are called wrong.
    pub wrong: usize,
    /// Those of which something is left unchecked.
    pub unchecked: usize,
    /// Those that are called right and are not, or at which a check panicked.
    pub faults: Vec<String>,
}

fn tree(value: &Value) -> Tree {
    read(value.to_string().as_bytes(), MAX_VALUES).expect("an answer is JSON")
}

/// The answer to a question.
pub fn answered(question: &Value) -> Value {
    answer_line(1, &Line::Content(question.to_string().into_bytes()), 0).content
}

/// Mutates the answers to questions of one kind; what is told of each kind is added to `counts`.
pub fn judge(dice: &mut Dice, pairs: &[(Value, Value)], counts: &mut BTreeMap<String, Counts>) {
    let results: Vec<Value> = pairs.iter().map(|(_, answer)| answer["result"].clone()).collect();
    for (question, answer) in pairs {
        let kind = question["kind"].as_str().expect("a question has a kind");
        let own = counts.entry(kind.to_owned()).or_default();
        let mut judging = Judging { question, asked: tree(question), answer, known: None, counts: own };
        if !matches!(check(&judging.asked, &tree(answer)), Verdict::Right(_)) {
            continue;
        }
        let neighbours: Vec<Value> = (0..NEIGHBOURS).map(|_| answered(&neighbour(dice, question))).collect();
        neighbours.iter().for_each(|other| judging.judge(other));
        let near: Vec<Value> = neighbours.iter().filter_map(|other| other.get("result").cloned()).collect();
        for _ in 0..MUTANTS_AN_ANSWER {
            let donors = if near.is_empty() || dice.one_in(2) { &results } else { &near };
            judging.judge(&mutation::mutant(dice, answer, donors));
        }
        for _ in 0..DAMAGED_TEXTS {
            judging.judge_text(&mutation::damaged(dice, &answer.to_string()));
        }
    }
}

/// A question with an answer that is right, and what is known of it.
struct Judging<'a> {
    question: &'a Value,
    asked: Tree,
    answer: &'a Value,
    known: Option<Known>,
    counts: &'a mut Counts,
}

impl Judging<'_> {
    fn judge(&mut self, mutant: &Value) {
        if mutant == self.answer {
            return;
        }
        let verdict = check(&self.asked, &tree(mutant));
        let is_right = verdict.is_right() && is_right(self.question, self.answer, mutant, &mut self.known);
        self.count(verdict, is_right, &mutant.to_string());
    }

    /// Holds a text against the question: only one that says the same as the answer, once, may be right.
    fn judge_text(&mut self, text: &str) {
        let verdict = verify(&self.question.to_string(), text);
        let is_right = serde_json::from_str::<Value>(text).is_ok_and(|value| {
            fields_in(&value) == text.matches("\":").count()
                && (value == *self.answer || is_right(self.question, self.answer, &value, &mut self.known))
        });
        self.count(verdict, is_right, text);
    }

    fn count(&mut self, verdict: Verdict, is_right: bool, mutant: &str) {
        let Self { question, answer, counts, .. } = self;
        counts.mutants += 1;
        match verdict {
            Verdict::Right(words) if is_right => {
                counts.harmless += 1;
                assert!(!words.is_empty());
            }
            Verdict::Right(words) => counts.faults.push(format!("{words}: {mutant} to {question} like {answer}")),
            Verdict::Unchecked(reason) if reason.starts_with("internal error") => {
                counts.faults.push(format!("{reason}: {mutant} to {question}"));
            }
            Verdict::Unchecked(_) => counts.unchecked += 1,
            Verdict::Wrong(_) => counts.wrong += 1,
        }
    }
}

/// The number of fields in a value; a field that stood twice in its text counts once.
fn fields_in(value: &Value) -> usize {
    match value {
        Value::Array(list) => list.iter().map(fields_in).sum(),
        Value::Object(fields) => fields.values().map(|field| 1 + fields_in(field)).sum(),
        _ => 0,
    }
}

/// Whether a mutant is an answer to the question, given one that is right.
fn is_right(question: &Value, answer: &Value, mutant: &Value, known: &mut Option<Known>) -> bool {
    let kind = question["kind"].as_str().unwrap_or_default();
    let is_named = ["id", "kind"].iter().all(|name| question[name] == mutant[name]);
    is_named
        && kinds::has_its_fields(kind, mutant)
        && kinds::is_true(kind, &question["input"], &answer["result"], &mutant["result"], known)
}
