//! Random mutants of answers: none that says something false is called right, and none stops the verifier.
//!
//! An ordinary run sees a share of the mutants; `ZONOTOPE_MUTANTS` names another number of them.

use std::collections::BTreeMap;

use batch::json::{MAX_VALUES, Tree, read};
use batch::{Verdict, check};
use serde_json::Value;

use crate::bounds::Known;
use crate::dice::Dice;
use crate::{fields, judges, mutation};

/// Each answer is changed so many times.
pub const MUTANTS_AN_ANSWER: usize = 250;

/// The fate of the mutants of a kind.
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

/// Mutates the answers to questions of one kind; what is told of each kind is added to `counts`.
pub fn judge(dice: &mut Dice, pairs: &[(Value, Value)], counts: &mut BTreeMap<String, Counts>) {
    let results: Vec<Value> = pairs.iter().map(|(_, answer)| answer["result"].clone()).collect();
    for (question, answer) in pairs {
        let kind = question["kind"].as_str().expect("a question has a kind");
        let (asked, mut known) = (tree(question), None);
        let own = counts.entry(kind.to_owned()).or_default();
        if !matches!(check(&asked, &tree(answer)), Verdict::Right(_)) {
            continue;
        }
        for _ in 0..MUTANTS_AN_ANSWER {
            let mutant = mutation::mutant(dice, answer, &results);
            if mutant == *answer {
                continue;
            }
            own.mutants += 1;
            match check(&asked, &tree(&mutant)) {
                Verdict::Right(words) if is_right(question, answer, &mutant, &mut known) => {
                    own.harmless += 1;
                    debug_assert!(!words.is_empty());
                }
                Verdict::Right(words) => own.faults.push(format!("{words}: {mutant} to {question} like {answer}")),
                Verdict::Unchecked(reason) if reason.starts_with("internal error") => {
                    own.faults.push(format!("{reason}: {mutant} to {question}"));
                }
                Verdict::Unchecked(_) => own.unchecked += 1,
                Verdict::Wrong(_) => own.wrong += 1,
            }
        }
    }
}

/// Whether a mutant is an answer to the question, given one that is right.
fn is_right(question: &Value, answer: &Value, mutant: &Value, known: &mut Option<Known>) -> bool {
    let kind = question["kind"].as_str().unwrap_or_default();
    let is_named = ["id", "kind"].iter().all(|name| question[name] == mutant[name]);
    is_named
        && fields::are_exact(kind, mutant)
        && judges::is_true(kind, &question["input"], &answer["result"], &mutant["result"], known)
}
