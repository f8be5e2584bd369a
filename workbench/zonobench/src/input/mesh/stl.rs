//! STL in text or binary, by the crate `stl_io`; corners that several triangles share are one vertex.

use std::collections::HashMap;
use std::io::{self, Read, Seek, SeekFrom};

use super::{Mesh, Misplaced, broken, line_before, push};
use crate::input::error::Place;

/// The words at the beginning of a binary file, which say nothing.
const HEADER: usize = 80;

/// The bytes of a triangle.
const TRIANGLE: u64 = 50;

pub(super) fn read(content: &[u8]) -> Result<Mesh, Misplaced> {
    let mut corners = Corners::default();
    if is_text(content) {
        texts(content, &mut corners)?;
    } else {
        binary(content, &mut corners)?;
    }
    Ok(corners.mesh)
}

/// Binary files may begin with any words, even those of a text; but their length is that of their triangles.
fn is_text(content: &[u8]) -> bool {
    let count = content.get(HEADER..HEADER + 4).and_then(|bytes| bytes.try_into().ok()).map(u32::from_le_bytes);
    let binary = count.map(|count| HEADER as u64 + 4 + u64::from(count) * TRIANGLE);
    content.trim_ascii_start().starts_with(b"solid") && binary != Some(content.len() as u64)
}

fn binary(content: &[u8], corners: &mut Corners) -> Result<(), Misplaced> {
    let at = |triangle: u64| Place::Path(format!("triangle {triangle}"));
    let complaint = |error: io::Error, place| (broken("STL", &error.to_string()), place);
    // The reader would take some headers for the beginning of a text.
    let body = content.get(HEADER..).unwrap_or_default();
    let mut source = Source { head: &[0; HEADER], body, position: 0, by_line: false };
    let triangles = stl_io::create_stl_reader(&mut source).map_err(|error| complaint(error, Place::File))?;
    for (index, triangle) in (1..).zip(triangles) {
        corners.add(&triangle.map_err(|error| complaint(error, at(index)))?, || at(index))?;
    }
    Ok(())
}

/// Reads the solids of a text, one after the other.
fn texts(content: &[u8], corners: &mut Corners) -> Result<(), Misplaced> {
    let mut read = content.len() - content.trim_ascii_start().len();
    while read < content.len() {
        let line = content[read..].iter().position(|&byte| byte == b'\n').map_or(content.len(), |end| read + end + 1);
        if !content[read..line].starts_with(b"solid") {
            return Err((broken("STL", "expected `solid`"), Place::Line(line_before(content, line))));
        }
        // The reader wants a name behind the word.
        let mut source = Source { head: b"solid name\n", body: &content[line..], position: 0, by_line: true };
        let outcome = solid(&mut source, corners);
        let end = line + source.position.saturating_sub(source.head.len());
        let place = Place::Line(line_before(content, end));
        match outcome {
            Err(error) => return Err((broken("STL", &error.to_string()), place)),
            Ok(Err((problem, _))) => return Err((problem, place)),
            Ok(Ok(())) => {}
        }
        let rest = &content[end..];
        read = content.len() - rest.trim_ascii_start().len();
    }
    Ok(())
}

fn solid(source: &mut Source<'_>, corners: &mut Corners) -> io::Result<Result<(), Misplaced>> {
    for triangle in stl_io::create_stl_reader(source)? {
        if let Err(misplaced) = corners.add(&triangle?, || Place::File) {
            return Ok(Err(misplaced));
        }
    }
    Ok(Ok(()))
}

/// The mesh so far, and where each vertex stands in it.
#[derive(Default)]
struct Corners {
    mesh: Mesh,
    known: HashMap<[u32; 3], usize>,
}

impl Corners {
    fn add(&mut self, triangle: &stl_io::Triangle, place: impl Fn() -> Place) -> Result<(), Misplaced> {
        let mut face = [0; 3];
        for (slot, corner) in face.iter_mut().zip(&triangle.vertices) {
            let key = corner.0.map(f32::to_bits);
            *slot = match self.known.get(&key) {
                Some(&index) => index,
                None => {
                    push(&mut self.mesh.vertices, corner.0.map(f64::from), &place)?;
                    let index = self.mesh.vertices.len() - 1;
                    self.known.insert(key, index);
                    index
                }
            };
        }
        self.mesh.add_face(&face);
        Ok(())
    }
}

/// Another beginning and the rest of a file; a text is handed out line by line, so that nobody reads ahead of the
/// line that is looked at.
struct Source<'a> {
    head: &'a [u8],
    body: &'a [u8],
    position: usize,
    by_line: bool,
}

impl Read for Source<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let rest = match self.position.checked_sub(self.head.len()) {
            None => &self.head[self.position..],
            Some(position) => self.body.get(position..).unwrap_or_default(),
        };
        let line = rest.iter().position(|&byte| self.by_line && byte == b'\n').map_or(rest.len(), |end| end + 1);
        let count = line.min(buffer.len());
        buffer[..count].copy_from_slice(&rest[..count]);
        self.position += count;
        Ok(count)
    }
}

impl Seek for Source<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let SeekFrom::Start(position) = to else { return Err(io::ErrorKind::Unsupported.into()) };
        self.position = usize::try_from(position).map_err(io::Error::other)?;
        Ok(position)
    }
}
