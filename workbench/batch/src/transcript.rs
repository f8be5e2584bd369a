//! The check of an answer against its question: the numbers of both are read here, the crate `verifier` judges them.

use std::borrow::Cow;
use std::panic::{self, AssertUnwindSafe};

use crate::claimed::{Reads, Traced, member};
use crate::json::{self, MAX_VALUES, Tree};
use crate::kinds::{KINDS, Kind};
use crate::names::plain_question;
use crate::place::Place;
use crate::refusal::Code;

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
    guarded(|| checked(question, answer).unwrap_or_else(Verdict::Wrong))
}

/// The verdict of a check; one that panics has found nothing out, and the caller goes on with the next answer.
pub fn guarded(check: impl FnOnce() -> Verdict) -> Verdict {
    // A check owns what it changes, so nothing half done is left behind.
    panic::catch_unwind(AssertUnwindSafe(check)).unwrap_or_else(|payload| {
        let text = payload.downcast_ref::<String>().map(String::as_str);
        let reason = text.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("a check panicked");
        Verdict::Unchecked(format!("internal error: {reason}"))
    })
}

fn checked(question: &Tree, answer: &Tree) -> Result<Verdict, String> {
    for name in ["id", "kind"] {
        let [asked, answered] = [question, answer].map(|tree| tree.field(name).and_then(Tree::text));
        if asked != answered {
            let told = |text: Option<&str>| text.map_or("none".to_owned(), |text| format!("`{text}`"));
            return Err(format!("the {name} is {}, and the question's is {}", told(answered), told(asked)));
        }
    }
    // Another method may have stepped in for the one that was asked for, but a method has a name.
    if let Some(method) = answer.field("method").filter(|method| method.text().is_none()) {
        return Err(format!("`method` is {}, not a name", method.describe()));
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
    let kind = question.field("kind").and_then(Tree::text).and_then(|name| KINDS.iter().find(|kind| kind.name == name));
    let question = match kind.map(|kind| plain_question(question, kind)) {
        Some(plain) => {
            plain.map_err(|refusal| format!("the question is not one to be answered: {}", refusal.message))?
        }
        None => Cow::Borrowed(question),
    };
    let reads = Reads::default();
    let [question, answer] = [&*question, answer].map(|tree| Traced::new(tree, &reads));
    let verdict = by_kind(question, answer)?;
    let Verdict::Right(proved) = &verdict else { return Ok(verdict) };
    let unknown = question.unread().into_iter().filter(|place| !is_known_in_question(place, question));
    let claimed = answer.unread().into_iter().filter(|place| !place.is_field_of(&[], &NOT_CLAIMED));
    let unread: Vec<Place> = unknown.chain(claimed).collect();
    Ok(unchecked_beside(&unread, proved).map_or(verdict, Verdict::Unchecked))
}

/// The note where a check has proved something but has not read some fields; nothing if it has read all.
fn unchecked_beside(unread: &[Place], proved: &str) -> Option<String> {
    match unread {
        [] => None,
        [field] => Some(format!("the field `{field}` is not checked; the rest: {proved}")),
        [first, others @ ..] => {
            let count = others.len();
            Some(format!("the field `{first}` and {count} more are not checked; the rest: {proved}"))
        }
    }
}

/// The fields of an answer that claim nothing about the result: what answers what, and how it came about.
const NOT_CLAIMED: [&str; 4] = ["id", "kind", "method", "request"];

/// The fields of a question beside its input.
const ENVELOPE: [&str; 3] = ["id", "kind", "method"];

/// Whether a field of a question that no check reads is one that such a question may have: what is asked for is right
/// whatever it says.
fn is_known_in_question(place: &Place, question: Traced<'_>) -> bool {
    let name = question.field("kind").and_then(Traced::text);
    let kind = KINDS.iter().find(|kind| Some(kind.name) == name);
    let is_of_kind =
        |kind: &Kind| [kind.fields, kind.optional].iter().any(|names| place.is_field_of(&["input"], names));
    place.is_field_of(&[], &ENVELOPE) || kind.is_some_and(is_of_kind)
}

fn by_kind(question: Traced<'_>, answer: Traced<'_>) -> Result<Verdict, String> {
    let input = member(question, "input")?;
    let result = member(answer, "result")?;
    let name = question.field("kind").and_then(Traced::text).unwrap_or_default();
    match KINDS.iter().find(|kind| kind.name == name) {
        Some(kind) => (kind.check)(input, result, answer.field("method").and_then(Traced::text)),
        None => Ok(Verdict::Unchecked(format!("the kind `{name}` is not checked"))),
    }
}
