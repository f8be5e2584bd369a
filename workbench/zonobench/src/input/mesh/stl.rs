//! STL in text or binary; corners that several triangles share are one vertex. Texts keep all digits of a double.

use std::collections::HashMap;

use super::content::{Mesh, Misplaced, broken, finite, on_line};
use super::words::Words;
use crate::input::encoding;
use crate::input::error::{Place, Problem};
use crate::input::reading::{Skipping, counted};

/// The words at the beginning of a binary file, which say nothing.
const HEADER: usize = 80;

/// The bytes of a triangle: its normal, three corners and two bytes of attributes.
const TRIANGLE: usize = 50;

/// The bytes of a vector.
const VECTOR: usize = 12;

pub(super) fn read(content: &[u8], skipping: &mut Skipping) -> Result<Mesh, Misplaced> {
    let mut corners = Corners { mesh: Mesh::default(), known: HashMap::new(), skipping };
    match binary_length(content) {
        Some(length) if length == content.len() as u64 => binary(content, &mut corners)?,
        length => {
            let text = encoding::text(content).map_err(|problem| (problem, Place::File))?;
            // Every binary file has a zero byte somewhere, no text has one.
            let is_binary = length.is_some() && text.contains(&0);
            if is_binary { binary(content, &mut corners)? } else { solids(&text, &mut corners)? }
        }
    }
    Ok(corners.mesh)
}

/// The length of a binary file that counts so many triangles. Its header may be any words, even those of a text.
pub(in crate::input) fn binary_length(content: &[u8]) -> Option<u64> {
    let count = content.get(HEADER..HEADER + 4)?.try_into().map(u32::from_le_bytes).ok()?;
    Some(HEADER as u64 + 4 + u64::from(count) * TRIANGLE as u64)
}

fn binary(content: &[u8], corners: &mut Corners) -> Result<(), Misplaced> {
    let count = content[HEADER..HEADER + 4].try_into().map_or(0, u32::from_le_bytes) as usize;
    let (triangles, rest) = content[HEADER + 4..].as_chunks::<TRIANGLE>();
    if triangles.len() < count {
        let complaint = format!("ends within triangle {} of {count}", triangles.len() + 1);
        return Err((broken("STL", &complaint), Place::File));
    }
    for (index, triangle) in triangles[..count].iter().enumerate() {
        let at = |corner: usize| Place::Path(format!("corner {corner} of triangle {}", index + 1));
        let (vectors, _) = triangle.as_chunks::<VECTOR>();
        let vector = |vector: usize| -> [f64; 3] {
            let (numbers, _) = vectors[vector].as_chunks::<4>();
            std::array::from_fn(|axis| f64::from(f32::from_le_bytes(numbers[axis])))
        };
        corners.add([1, 2, 3].map(|corner| finite(vector(corner))), at)?;
    }
    let surplus = (triangles.len() - count) * TRIANGLE + rest.len();
    corners.mesh.left_out.extend(counted(surplus, "byte behind the triangles", "bytes behind the triangles"));
    Ok(())
}

/// Reads the solids of a text, one after the other. Normals, names and colours are not looked at.
fn solids(text: &[u8], corners: &mut Corners) -> Result<(), Misplaced> {
    let mut words = Words::new(text);
    let (mut is_open, mut unended) = (false, 0);
    let wrong = |words: &Words, expected: &str, found: Option<&[u8]>| {
        let found =
            found.map_or("the end".to_owned(), |word| format!("'{}'", String::from_utf8_lossy(word).escape_debug()));
        (broken("STL", &format!("expected `{expected}`, found {found}")), Place::Line(words.line()))
    };
    while let Some(word) = words.next() {
        let is = |keyword: &str| word.eq_ignore_ascii_case(keyword.as_bytes());
        if is("solid") {
            unended += usize::from(is_open);
            is_open = true;
            words.skip_line();
        } else if is("endsolid") || is("end") {
            is_open = false;
            words.skip_line();
        } else if is("color") && is_open {
            words.skip_line();
        } else if is("facet") && is_open {
            facet(&mut words, corners, wrong)?;
        } else {
            return Err(wrong(&words, if is_open { "facet` or `endsolid" } else { "solid" }, Some(word)));
        }
    }
    let missing = counted(unended + usize::from(is_open), "solid has no `endsolid`", "solids have no `endsolid`");
    corners.mesh.notes.extend(missing);
    Ok(())
}

/// Reads a triangle, of which `facet` is read already.
fn facet(
    words: &mut Words,
    corners: &mut Corners,
    wrong: impl Fn(&Words, &str, Option<&[u8]>) -> Misplaced,
) -> Result<(), Misplaced> {
    // A normal is what stands before the loop, however it is written.
    loop {
        match words.next() {
            Some(word) if word.eq_ignore_ascii_case(b"outer") => break,
            Some(word) if !word.eq_ignore_ascii_case(b"vertex") => {}
            found => return Err(wrong(words, "outer loop", found)),
        }
    }
    let expect = |words: &mut Words, keyword: &str| match words.next() {
        Some(word) if word.eq_ignore_ascii_case(keyword.as_bytes()) => Ok(()),
        found => Err(wrong(words, keyword, found)),
    };
    expect(words, "loop")?;
    let mut vertices = [[0.0; 3]; 3].map(Ok);
    let line = words.line();
    for slot in &mut vertices {
        expect(words, "vertex")?;
        let ends_at = words.line();
        let mut next = || words.next().ok_or_else(|| (broken("STL", "ends within a vertex"), Place::Line(ends_at)));
        let coordinates = [next()?, next()?, next()?];
        *slot = on_line(coordinates, [1, 2, 3], words.line(), &mut corners.mesh.losses)?;
    }
    for ends in ["loop", "facet"] {
        match words.next() {
            Some(word) if word.eq_ignore_ascii_case(format!("end{ends}").as_bytes()) => {}
            Some(word) if word.eq_ignore_ascii_case(b"end") => expect(words, ends)?,
            found => return Err(wrong(words, &format!("end{ends}"), found)),
        }
    }
    corners.add(vertices, |corner| Place::Path(format!("corner {corner} of the triangle on line {line}")))
}

/// The mesh so far, and where each vertex stands in it.
struct Corners<'a> {
    mesh: Mesh,
    known: HashMap<[u64; 3], usize>,
    skipping: &'a mut Skipping,
}

impl Corners<'_> {
    /// Adds a triangle; the place is that of a corner, counted from 1.
    fn add(
        &mut self,
        corners: [Result<[f64; 3], Problem>; 3],
        place: impl Fn(usize) -> Place,
    ) -> Result<(), Misplaced> {
        let mut face = [0; 3];
        for ((number, slot), corner) in (1..).zip(&mut face).zip(corners) {
            let key = corner.as_ref().ok().map(|corner| corner.map(f64::to_bits));
            *slot = match key.and_then(|key| self.known.get(&key)) {
                Some(&index) => index,
                None => {
                    let index = self.mesh.vertices.len();
                    self.mesh.push(corner, self.skipping, |_| place(number))?;
                    self.known.extend(key.map(|key| (key, index)));
                    index
                }
            };
        }
        self.mesh.add_face(&face, "STL").map_err(|problem| (problem, place(1)))
    }
}
