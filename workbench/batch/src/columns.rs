//! Answers for a host that shares memory with the library and asks while somebody drags: numbers are not written as
//! text, and a body is not read anew.

use serde_json::{Map, Value, json};

use crate::answering::{line_of, respond};
use crate::kinds::HeldBody;
use crate::pictures::Sheet;
use crate::refusal::Refusal;

/// The data of a picture of [`PICTURES`](crate::PICTURES) with their tables as bytes.
///
/// A line of JSON comes first, and is as long as a multiple of eight bytes. Its `result` has everything that is no
/// table; `tables` says where each table belongs (`at`), how wide its rows are (`width`: 0 for entries that stand by
/// themselves, null for rows of their own length, which have their ends in the first of two columns), and the type and
/// the bytes of its columns. The columns follow, in this order, little-endian; the largest index stands for none.
pub fn picture_in_columns(question: &str) -> Vec<u8> {
    let mut drawn = None;
    let answer = respond(1, &line_of(question), |question| {
        drawn = Some(question.draw()?);
        Ok(Vec::new())
    });
    let Value::Object(envelope) = answer.content else { unreachable!("an answer is an object") };
    match drawn {
        Some(sheet) => written_in_columns(envelope, Ok(sheet)),
        None => in_eights(&envelope),
    }
}

/// The body that a question of the kind `body` brings: its input has `center` and `generators` in space.
///
/// # Errors
/// The answer that refuses the question, as a line of JSON.
pub fn hold(question: &str) -> Result<HeldBody, String> {
    let mut held = None;
    let answer = respond(1, &line_of(question), |question| {
        held = Some(question.held()?);
        Ok(Vec::new())
    });
    held.ok_or_else(|| answer.content.to_string())
}

/// The place of a point relative to a body that is held, as data with the proof among the tables, like those of
/// [`picture_in_columns`].
pub fn locate_in_columns(body: &HeldBody, point: [f64; 3]) -> Vec<u8> {
    written_in_columns(Map::new(), body.locate(point))
}

/// The envelope of an answer with a sheet, or with its refusal.
fn written_in_columns(mut envelope: Map<String, Value>, sheet: Result<Sheet, Refusal>) -> Vec<u8> {
    let unfolded = match sheet {
        Ok(sheet) => sheet.unfolded(),
        Err(refusal) => {
            envelope.insert("error".to_owned(), json!({"code": refusal.code.name(), "message": refusal.message}));
            return in_eights(&envelope);
        }
    };
    envelope.insert("result".to_owned(), unfolded.plain.into());
    envelope.insert("tables".to_owned(), unfolded.tables.into());
    let mut bytes = in_eights(&envelope);
    bytes.extend(unfolded.columns);
    bytes
}

/// A line of JSON as long as a multiple of eight bytes, its end included.
fn in_eights(envelope: &Map<String, Value>) -> Vec<u8> {
    let mut line = serde_json::to_vec(envelope).expect("JSON can be written");
    line.resize((line.len() + 1).next_multiple_of(8) - 1, b' ');
    line.push(b'\n');
    line
}
