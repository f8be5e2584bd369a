//! Answers of the program are not called wrong: questions of every kind about ordinary numbers and about numbers of any
//! size are asked, and the answers are given to the verifier.
//!
//! An ordinary run asks a few questions of each kind; `ZONOTOPE_CASES=long` asks more, of other sizes as well.

use batch::json::{MAX_VALUES, Tree, read};
use batch::{KINDS, Line, Verdict, answer_line, check};
use serde_json::Value;
use tests::dice::Dice;
use tests::questions::{Population, neighbour, question};
use tests::runner::cases;

/// A long run asks so many questions of each kind and population, and as many that differ from these by one number.
const QUESTIONS: u32 = 1_200;

fn tree(value: &Value) -> Tree {
    read(value.to_string().as_bytes(), MAX_VALUES).expect("questions and answers are JSON")
}

/// The parts of answers about few generators that may be left unchecked: points and weights that differ by many orders
/// of magnitude leave a gap to the lower bound.
const OPEN: [&str; 3] = [
    "it may not be the least",
    "the precision is not reached, as the answer says",
    "than rounding the centre to doubles explains",
];

/// Asks, and gives the answer to the verifier; whether it was answered.
fn answer_verifies(question: &Value) -> bool {
    let answer = answer_line(1, &Line::Content(question.to_string().into_bytes()), 0).content;
    if answer.get("error").is_some() {
        return false;
    }
    match check(&tree(question), &tree(&answer)) {
        Verdict::Right(_) => {}
        Verdict::Unchecked(reason) if OPEN.iter().any(|open| reason.contains(open)) => {}
        verdict => panic!("{verdict:?}: {answer} to {question}"),
    }
    true
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
        assert!(3 * answered > asked, "{}: {answered} of {asked} questions were answered", kind.name);
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
