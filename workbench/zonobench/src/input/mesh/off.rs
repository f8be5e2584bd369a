//! OFF in text: the word `OFF`, the numbers of vertices, faces and edges, then a line for each vertex and one for each
//! face.

use super::{Mesh, Misplaced, broken, push};
use crate::input::MAX_POINTS;
use crate::input::error::{Place, Problem};

/// What may stand before the word `OFF`: texture coordinates, colours and normals, all of them behind the coordinates.
const PREFIXES: [&str; 8] = ["", "ST", "C", "N", "CN", "STC", "STN", "STCN"];

pub(super) fn read(content: &[u8]) -> Result<Mesh, Misplaced> {
    let mut lines = (1_u64..).zip(content.split(|&byte| byte == b'\n')).filter_map(|(number, line)| {
        let line = line.split(|&byte| byte == b'#').next().unwrap_or_default().trim_ascii();
        (!line.is_empty()).then_some((number, line))
    });
    let (number, first) = lines.next().ok_or((Problem::Empty, Place::File))?;
    let mut words = text(first, number)?.split_ascii_whitespace();
    let word = words.next().unwrap_or_default();
    if !word.strip_suffix("OFF").is_some_and(|prefix| PREFIXES.contains(&prefix)) {
        let complaint = format!("begins with '{}', not with OFF for three coordinates", word.escape_debug());
        return Err((broken("OFF", &complaint), Place::Line(number)));
    }
    let counts: Vec<&str> = words.collect();
    let (number, counts) = match counts.first() {
        Some(&"BINARY") => return Err((broken("OFF", "is binary; the text form is read"), Place::Line(number))),
        Some(_) => (number, counts),
        None => {
            let (number, line) = lines.next().ok_or((broken("OFF", "ends before its counts"), Place::File))?;
            (number, text(line, number)?.split_ascii_whitespace().collect())
        }
    };
    let count = counts.first().and_then(|count| count.parse::<usize>().ok());
    let count = count.ok_or_else(|| (broken("OFF", "does not tell the number of vertices"), Place::Line(number)))?;
    if count > MAX_POINTS {
        return Err((Problem::TooMany { what: "points", limit: MAX_POINTS }, Place::Line(number)));
    }
    let mut vertices = Vec::new();
    for index in 0..count {
        let ended = || (broken("OFF", &format!("ends after {index} of {count} vertices")), Place::File);
        let (number, line) = lines.next().ok_or_else(ended)?;
        let mut words = text(line, number)?.split_ascii_whitespace();
        let mut vertex = [0.0; 3];
        for (axis, slot) in (1..).zip(&mut vertex) {
            let place = Place::Cell { line: number, column: axis };
            let Some(word) = words.next() else { return Err((broken("OFF", "a vertex has three coordinates"), place)) };
            *slot = word.parse().map_err(|_| (Problem::NotANumber(word.to_owned()), place))?;
        }
        push(&mut vertices, vertex, || Place::Line(number))?;
    }
    let mut read = Mesh { vertices, faces: Vec::new() };
    for (_, line) in lines {
        read.add_face(&corners(line).unwrap_or_default());
    }
    Ok(read)
}

/// The corners of the face on a line: their number, the corners, and perhaps a colour.
fn corners(line: &[u8]) -> Option<Vec<usize>> {
    let mut words = std::str::from_utf8(line).ok()?.split_ascii_whitespace().map(str::parse::<usize>);
    let count = words.next()?.ok()?;
    let corners: Vec<usize> = words.take(count).collect::<Result<_, _>>().ok()?;
    (corners.len() == count).then_some(corners)
}

fn text(line: &[u8], number: u64) -> Result<&str, Misplaced> {
    std::str::from_utf8(line).map_err(|_| (Problem::NotText, Place::Line(number)))
}
