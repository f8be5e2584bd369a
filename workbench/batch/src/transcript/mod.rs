//! The check of an answer against its question: the numbers of both are read here, the crate `verifier` judges them.

mod collision;
mod enclosing;
mod reading;
mod reduction;
mod solids;
mod traced;

use crate::json::{self, MAX_VALUES, Tree};
use crate::refusal::Code;
use reading::member;
use traced::{Reads, Traced};

pub use verifier::Verdict;

/// Checks an answer against its question, both as lines of JSON.
pub fn verify(question: &str, answer: &str) -> Verdict {
    let tree = |text: &str| json::read(text.as_bytes(), MAX_VALUES);
    match (tree(question), tree(answer)) {
        (_, Err(_)) => Verdict::Wrong("the answer is not JSON".to_owned()),
        (Ok(question), Ok(answer)) => check(&question, &answer),
        (Err(_), Ok(answer)) => check_unread(&answer),
    }
}

/// Checks the answer to a line that is no JSON document that is read: it must be a refusal.
pub fn check_unread(answer: &Tree) -> Verdict {
    match answer.field("error") {
        Some(_) => Verdict::Unchecked("refused; the question is no JSON document that is read here".to_owned()),
        None => Verdict::Wrong("the question is not JSON, but it was answered".to_owned()),
    }
}

/// Checks an answer against its question.
pub fn check(question: &Tree, answer: &Tree) -> Verdict {
    match checked(question, answer) {
        Ok(verdict) => verdict,
        Err(complaint) => Verdict::Wrong(complaint),
    }
}

fn checked(question: &Tree, answer: &Tree) -> Result<Verdict, String> {
    for name in ["id", "kind"] {
        let (asked, answered) = (question.field(name), answer.field(name));
        if asked.and_then(Tree::text) != answered.and_then(Tree::text) {
            return Err(format!("the {name} is not the question's"));
        }
    }
    if let Some(error) = answer.field("error") {
        let text = |name| error.field(name).and_then(Tree::text).unwrap_or("?");
        if answer.field("result").is_some() {
            return Err("there is a result beside the refusal".to_owned());
        }
        if Code::ALL.iter().all(|code| code.name() != text("code")) {
            return Err(format!("there is no code `{}`", text("code")));
        }
        return Ok(Verdict::Unchecked(format!("refused: {}: {}", text("code"), text("message"))));
    }
    let reads = Reads::default();
    let [question, answer] = [question, answer].map(|tree| Traced::new(tree, &reads));
    let verdict = by_kind(question, answer)?;
    let Verdict::Right(proved) = &verdict else { return Ok(verdict) };
    let unread = answer.unread(&NOT_CLAIMED);
    Ok(match unread.as_slice() {
        [] => verdict,
        [field] => Verdict::Unchecked(format!("the field `{field}` is not checked; the rest: {proved}")),
        [first, others @ ..] => {
            let count = others.len();
            Verdict::Unchecked(format!("the field `{first}` and {count} more are not checked; the rest: {proved}"))
        }
    })
}

/// The fields of an answer that claim nothing about the result: what answers what, and how it came about.
const NOT_CLAIMED: [&str; 4] = ["id", "kind", "method", "request"];

fn by_kind(question: Traced<'_>, answer: Traced<'_>) -> Result<Verdict, String> {
    let input = member(question, "input")?;
    let result = member(answer, "result")?;
    match question.field("kind").and_then(Traced::text).unwrap_or_default() {
        "min_area" => enclosing::min_area(input, result),
        "min_length_dirs" => enclosing::min_length_dirs(input, result),
        "min_length_all" => enclosing::min_length_all(input, result),
        "support" => solids::support(input, result),
        "combinatorics" => solids::combinatorics(input, result),
        "slope_selection" => solids::slope_selection(input, result),
        "separator" => solids::separator(input, result),
        "upper_hull" => solids::upper_hull(input, result),
        "walk" => solids::walk(input, result),
        "member_batch" => collision::member_batch(input, result),
        "distance" => collision::distance(input, result),
        "approx" => reduction::approx(input, result),
        "reduce" => reduction::reduce(input, result),
        "hausdorff" => reduction::hausdorff(input, result),
        "member" => collision::member_of(input, result),
        "intersect" => collision::intersect(input, result),
        "gauge" => collision::gauge(input, result),
        other => Ok(Verdict::Unchecked(format!("the kind `{other}` is not checked"))),
    }
}
