//! Questions, answers and verdicts for a host that shares linear memory with this module and nothing else.
//!
//! The host writes text into the buffer that [`input`] gives, calls one entry, and reads as many bytes as the entry
//! returns from the place that [`output`] gives. Both places move when a later call needs more room, so the host asks
//! for them each time.
//!
//! | entry | the text in the buffer | the text that comes out |
//! | --- | --- | --- |
//! | [`answer`] | a question, as a line of JSON | the answer, as a line of JSON |
//! | [`picture`] | a question for a picture | its data, as a line of JSON |
//! | [`columns`] | a question for a picture | its data, as a line of JSON with the bytes of its tables behind it |
//! | [`hold`] | a question that brings a body | nothing, or the answer that refuses it |
//! | [`locate`] | none | where a point lies in the body that is held, in columns |
//! | [`rival`] | none | the steps of the algorithm of Gilbert, Johnson and Keerthi for that point, as a line of JSON |
//! | [`verify`] | a question, then directly an answer | `right`, `wrong` or `unchecked`; next line: the reason |
//! | [`failure`] | none | the message of the panic after which an entry did not return |
//!
//! A panic ends an entry by a trap of the machine. The host then reads [`failure`] and makes a new instance of the
//! module, because a value that was borrowed when the trap came stays borrowed.

use std::cell::RefCell;
use std::panic;
use std::sync::Once;

use batch::{HeldBody, Verdict};

mod rival;

thread_local! {
    static HELD: RefCell<Option<HeldBody>> = const { RefCell::new(None) };
    static INPUT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static OUTPUT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static FAILURE: RefCell<String> = const { RefCell::new(String::new()) };
}

/// The buffer for a text of that many bytes; what it held before is lost.
#[unsafe(no_mangle)]
pub extern "C" fn input(bytes: usize) -> *mut u8 {
    keep_messages();
    INPUT.with_borrow_mut(|input| {
        input.clear();
        input.resize(bytes, 0);
        input.as_mut_ptr()
    })
}

/// The first byte of the text that the last entry left.
#[unsafe(no_mangle)]
pub extern "C" fn output() -> *const u8 {
    OUTPUT.with_borrow(|output| output.as_ptr())
}

/// Answers the question in the buffer; returns the answer's length in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> usize {
    leave(batch::answer(&text(&INPUT.take())))
}

/// Makes the data of the picture that the question in the buffer asks for; returns its length in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn picture() -> usize {
    leave(batch::picture(&text(&INPUT.take())))
}

/// Makes the data of the picture that the question in the buffer asks for, its tables as bytes; returns their length.
#[unsafe(no_mangle)]
pub extern "C" fn columns() -> usize {
    leave(batch::picture_in_columns(&text(&INPUT.take())))
}

/// Holds the body that the question in the buffer brings, in place of another; returns 0, or the length of the answer
/// that refuses it.
#[unsafe(no_mangle)]
pub extern "C" fn hold() -> usize {
    let (held, refused) = match batch::hold(&text(&INPUT.take())) {
        Ok(body) => (Some(body), String::new()),
        Err(refused) => (None, refused),
    };
    HELD.set(held);
    leave(refused)
}

/// Finds where a point lies in the body that is held; returns the length of the answer in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn locate(x: f64, y: f64, z: f64) -> usize {
    leave(HELD.with_borrow(|held| match held {
        Some(body) => batch::locate_in_columns(body, [x, y, z]),
        None => Vec::new(),
    }))
}

/// Goes through the steps of the rival for a point and the body that is held; returns the bytes of their text.
#[unsafe(no_mangle)]
pub extern "C" fn rival(x: f64, y: f64, z: f64) -> usize {
    leave(HELD.with_borrow(|held| held.as_ref().map_or_else(String::new, |body| rival::steps(body.body(), [x, y, z]))))
}

/// Checks an answer against its question exactly. The question is the first `question_bytes` bytes of the buffer, the
/// answer is the rest. Returns the verdict's length in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn verify(question_bytes: usize) -> usize {
    let both = INPUT.take();
    let (question, answer) = both.split_at(question_bytes.min(both.len()));
    let (verdict, reason) = match batch::verify(&text(question), &text(answer)) {
        Verdict::Right(proved) => ("right", proved),
        Verdict::Wrong(reason) => ("wrong", reason),
        Verdict::Unchecked(reason) => ("unchecked", reason),
    };
    leave(format!("{verdict}\n{reason}"))
}

/// Leaves the message of the last panic as output; returns its length in bytes, 0 if there was none.
#[unsafe(no_mangle)]
pub extern "C" fn failure() -> usize {
    leave(FAILURE.with_borrow(Clone::clone))
}

/// The text of some bytes. A byte that is no UTF-8 becomes a replacement character, so that the reader of questions
/// names the place instead of this module.
fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn leave(answer: impl Into<Vec<u8>>) -> usize {
    let answer = answer.into();
    let bytes = answer.len();
    OUTPUT.set(answer);
    bytes
}

/// The messages of panics are kept for [`failure`], beside whatever happens to them already.
fn keep_messages() {
    static KEPT: Once = Once::new();
    KEPT.call_once(|| {
        let before = panic::take_hook();
        panic::set_hook(Box::new(move |message| {
            FAILURE.set(message.to_string());
            before(message);
        }));
    });
}
