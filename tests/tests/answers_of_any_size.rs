//! Answers of the program are not called wrong: questions of every kind about ordinary numbers, about numbers of any
//! size and near ties are asked, and the answers are given to the verifier.
//!
//! An ordinary run asks a few questions of each kind; `ZONOTOPE_CASES=long` asks more, of other sizes as well.

use batch::KINDS;
use serde_json::Value;
use tests::dice::Dice;
use tests::judged::{Judged, judge};
use tests::questions::{Population, neighbour, question};
use tests::runner::cases;

/// A long run asks so many questions of each kind and population, and as many that differ from these by one number.
const QUESTIONS: u32 = 1_200;

/// Asks, and gives the answer to the verifier; whether it was answered.
fn answer_verifies(question: &Value) -> bool {
    match judge(question) {
        Ok(judged) => judged == Judged::Verified,
        Err(fault) => panic!("{fault}"),
    }
}

fn answers_verify(population: Population) {
    for (seed, kind) in (1_u64..).zip(KINDS) {
        let mut dice = Dice::new(1_000 * seed);
        let mut answered = 0;
        let asked = cases(QUESTIONS);
        for number in 0..asked {
            let question = question(&mut dice, population, kind.name, &format!("{} {number}", kind.name));
            answered += u32::from(answer_verifies(&question));
            answer_verifies(&neighbour(&mut dice, &question));
        }
        assert!(4 * answered > asked, "{}: {answered} of {asked} questions were answered", kind.name);
    }
}

#[test]
fn answers_about_ordinary_numbers_verify() {
    answers_verify(Population::Ordinary);
}

#[test]
fn answers_about_numbers_of_any_size_verify() {
    answers_verify(Population::AnySize);
}

#[test]
fn answers_near_ties_verify() {
    answers_verify(Population::NearTies);
}
