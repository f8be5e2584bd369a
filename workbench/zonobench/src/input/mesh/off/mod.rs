//! OFF in text: the word `OFF`, perhaps, the numbers of vertices, faces and edges, then the vertices and the faces,
//! each on a line of its own or all words in a row. In `nOFF` the number of coordinates stands before the others; with
//! other than three of them the vertices are points without faces.

mod keyword;

use std::array::from_fn;

use self::keyword::Keyword;
use super::content::{Mesh, Misplaced, broken, on_line, vertex_on_line};
use super::words::{lines, words};
use crate::input::error::{Place, Problem};
use crate::input::points::{COORDINATE_LIMIT, Points};
use crate::input::reading::{Reading, Skipping, counted};
use crate::input::{MAX_POINTS, encoding};

/// A word, or a line, with the number of its line.
type Numbered<'a> = (u64, &'a [u8]);

/// The counts, which stand before the vertices.
struct Counts {
    /// The number of coordinates.
    dimension: usize,
    /// The numbers of a vertex, if it has as many in every file of this kind.
    width: Option<usize>,
    vertices: usize,
    faces: usize,
    /// The line on which the counts end.
    line: u64,
}

pub(super) fn read(content: &[u8], skipping: &mut Skipping) -> Result<Reading, Misplaced> {
    let text = encoding::text(content).map_err(|problem| (problem, Place::File))?;
    let without_comment = |line| <[u8]>::split(line, |&byte| byte == b'#').next().unwrap_or_default().trim_ascii();
    let lines = lines(&text).map(|(number, line)| (number, without_comment(line)));
    let lines: Vec<Numbered> = lines.filter(|(_, line)| !line.is_empty()).collect();
    let mut all = lines.iter().flat_map(|&(number, line)| words(line).map(move |word| (number, word))).peekable();
    let counts = counts(&mut all)?;
    let is_apart = all.peek().is_none_or(|&(line, _)| line > counts.line);
    let body = &lines[lines.partition_point(|&(line, _)| line <= counts.line)..];
    let text = Text { words: all, body, is_apart, counts };
    Ok(match text.counts.dimension {
        1 => text.mesh(skipping)?.without_faces().read_as(Points::Line),
        2 => text.mesh(skipping)?.without_faces().read_as(Points::Plane),
        4 => text.mesh(skipping)?.without_faces().read_as(Points::Four),
        _ => text.mesh(skipping)?.read_as(Points::Space),
    })
}

/// The text behind the counts.
struct Text<'a, W> {
    /// Its words.
    words: W,
    /// The lines below the counts.
    body: &'a [Numbered<'a>],
    /// Whether nothing stands behind the counts on their line.
    is_apart: bool,
    counts: Counts,
}

impl<'a, W: Iterator<Item = Numbered<'a>>> Text<'a, W> {
    /// The vertices, of the dimension that the counts tell, and the faces.
    fn mesh<const D: usize>(self, skipping: &mut Skipping) -> Result<Mesh<D>, Misplaced> {
        let Self { words: all, body, is_apart, counts } = self;
        let has_lines = is_apart
            && body.len() >= counts.vertices.saturating_add(counts.faces)
            && body[..counts.vertices].iter().all(|(_, line)| words(line).count() >= D);
        if !has_lines && let Some(elements) = in_a_row(all.collect(), &counts) {
            return mesh_of_words(&elements, &counts, skipping);
        }
        if is_apart {
            return mesh_of_lines(body, &counts, skipping);
        }
        let complaint = format!("what follows is no text of {} vertices and {} faces", counts.vertices, counts.faces);
        Err((broken("OFF", &complaint), Place::Line(counts.line)))
    }
}

/// The counts, behind the keyword, on its line, glued to it, or without one.
fn counts<'a>(words: &mut std::iter::Peekable<impl Iterator<Item = Numbered<'a>>>) -> Result<Counts, Misplaced> {
    let &(line, first) = words.peek().ok_or((Problem::Empty, Place::File))?;
    let (keyword, mut glued) = if first.iter().all(u8::is_ascii_digit) {
        (Keyword::default(), &b""[..])
    } else {
        words.next();
        Keyword::read(first).map_err(|complaint| (broken("OFF", &complaint), Place::Line(line)))?
    };
    if words.peek().is_some_and(|(_, word)| word.eq_ignore_ascii_case(b"BINARY")) {
        return Err((broken("OFF", "is binary; the text form is read"), Place::Line(line)));
    }
    let ended = || (broken("OFF", "does not tell the numbers of vertices and faces"), Place::Line(line));
    let count = |(line, word): Numbered| {
        let count = std::str::from_utf8(word).ok().and_then(|word| word.parse::<usize>().ok());
        count.map(|count| (line, count)).ok_or_else(|| {
            let word = String::from_utf8_lossy(word);
            (broken("OFF", &format!("'{}' is no number of things", word.escape_debug())), Place::Line(line))
        })
    };
    let mut dimension = 3;
    if keyword.has_dimension {
        let word = if glued.is_empty() { words.next().ok_or_else(ended)? } else { (line, std::mem::take(&mut glued)) };
        dimension = count(word)?.1;
        if !(1..=COORDINATE_LIMIT).contains(&dimension) {
            let complaint = format!("has vertices of {dimension} coordinates; one to {COORDINATE_LIMIT} are read");
            return Err((broken("OFF", &complaint), Place::Line(word.0)));
        }
    }
    let first = if glued.is_empty() { words.next().ok_or_else(ended)? } else { (line, glued) };
    let (first_line, vertices) = count(first)?;
    let (second_line, faces) = count(words.next().ok_or_else(ended)?)?;
    // The number of edges says nothing, and some files leave it out: it stands beside the others, or all three stand
    // on lines of their own.
    let has_edges = words.peek().is_some_and(|&(line, _)| line == second_line || first_line != second_line);
    let last_line =
        if has_edges { words.next().map_or(Ok(second_line), |edges| Ok(count(edges)?.0))? } else { second_line };
    if vertices > MAX_POINTS {
        return Err((Problem::TooMany { what: "points", limit: MAX_POINTS }, Place::Line(first_line)));
    }
    let width = keyword.width(dimension);
    Ok(Counts { dimension, width, vertices, faces, line: last_line })
}

/// The words of a text whose lines do not matter: as many numbers as there are vertices and faces, and no others.
fn in_a_row<'a>(words: Vec<Numbered<'a>>, counts: &Counts) -> Option<Vec<Numbered<'a>>> {
    let mut rest = words.get(counts.vertices.checked_mul(counts.width?)?..)?;
    for _ in 0..counts.faces {
        let (&(_, first), others) = rest.split_first()?;
        let corners: usize = std::str::from_utf8(first).ok()?.parse().ok()?;
        rest = others.get(corners..)?;
    }
    rest.is_empty().then_some(words)
}

fn mesh_of_words<const D: usize>(
    words: &[Numbered],
    counts: &Counts,
    skipping: &mut Skipping,
) -> Result<Mesh<D>, Misplaced> {
    let mut mesh = Mesh::default();
    let width = counts.width.unwrap_or_default();
    let (vertices, mut rest) = words.split_at(counts.vertices * width);
    for vertex in vertices.chunks_exact(width.max(1)) {
        let line = vertex[0].0;
        let read = on_line(from_fn(|i| vertex[i].1), columns::<D>(), line, &mut mesh.losses)?;
        mesh.push(read, skipping, |number| vertex_on_line(number, line))?;
    }
    while let Some((&(line, first), others)) = rest.split_first() {
        let corners = std::str::from_utf8(first).ok().and_then(|count| count.parse().ok()).unwrap_or(0);
        let (face, others) = others.split_at(corners);
        add_face(&mut mesh, face.iter().map(|&(_, word)| word), line)?;
        rest = others;
    }
    Ok(mesh)
}

/// The columns of the coordinates of a vertex.
fn columns<const D: usize>() -> [u64; D] {
    from_fn(|coordinate| coordinate as u64 + 1)
}

/// The number of coordinates in words.
fn coordinates_in_words(count: usize) -> &'static str {
    ["one coordinate", "two coordinates", "three coordinates", "four coordinates"][count - 1]
}

/// The mesh of a text with a vertex or a face a line.
fn mesh_of_lines<const D: usize>(
    body: &[Numbered],
    counts: &Counts,
    skipping: &mut Skipping,
) -> Result<Mesh<D>, Misplaced> {
    let mut mesh = Mesh::default();
    let mut wider = 0;
    let ended = |index: usize, count: usize, name: &str| {
        (broken("OFF", &format!("ends after {index} of {count} {name}")), Place::File)
    };
    for index in 0..counts.vertices {
        let &(line, text) = body.get(index).ok_or_else(|| ended(index, counts.vertices, "vertices"))?;
        let numbers: Vec<&[u8]> = words(text).collect();
        let Some((&coordinates, more)) = numbers.split_first_chunk() else {
            let place = Place::Cell { line, column: numbers.len() as u64 + 1 };
            let complaint = format!("a vertex has {}", coordinates_in_words(D));
            return Err((broken("OFF", &complaint), place));
        };
        wider += usize::from(counts.width == Some(D) && !more.is_empty());
        if let Some(width) = counts.width.filter(|&width| numbers.len() < width) {
            let complaint = format!("the first word tells of {width} numbers a vertex, and here are {}", numbers.len());
            return Err((broken("OFF", &complaint), Place::Line(line)));
        }
        let read = on_line(coordinates, columns::<D>(), line, &mut mesh.losses)?;
        mesh.push(read, skipping, |number| vertex_on_line(number, line))?;
    }
    let rest = &body[counts.vertices..];
    for index in 0..counts.faces {
        let &(line, text) = rest.get(index).ok_or_else(|| ended(index, counts.faces, "faces"))?;
        let mut words = words(text);
        let count: Option<usize> = words.next().and_then(|count| std::str::from_utf8(count).ok()?.parse().ok());
        let face: Vec<&[u8]> = words.take(count.unwrap_or_default()).collect();
        if count.is_none_or(|count| count == 0 || face.len() < count) {
            let complaint = "a face is the number of its corners, and so many vertices";
            return Err((broken("OFF", complaint), Place::Line(line)));
        }
        add_face(&mut mesh, face.into_iter(), line)?;
    }
    let surplus = rest.len() - counts.faces;
    let behind = ["first", "second", "third", "fourth"][D - 1];
    let of_vertices = ["vertex's", "vertices'"].map(|of| format!("{of} numbers behind the {behind}"));
    mesh.left_out.extend(counted(wider, &of_vertices[0], &of_vertices[1]));
    mesh.left_out.extend(counted(surplus, "line behind the faces", "lines behind the faces"));
    Ok(mesh)
}

/// Adds the face with these corners, counted from 0.
fn add_face<'a, const D: usize>(
    mesh: &mut Mesh<D>,
    corners: impl Iterator<Item = &'a [u8]>,
    line: u64,
) -> Result<(), Misplaced> {
    let corner = |word: &[u8]| {
        std::str::from_utf8(word).ok().and_then(|word| word.parse::<usize>().ok()).ok_or_else(|| {
            let word = String::from_utf8_lossy(word);
            broken("OFF", &format!("'{}' is no vertex", word.escape_debug()))
        })
    };
    let corners: Result<Vec<usize>, Problem> = corners.map(corner).collect();
    corners.and_then(|corners| mesh.add_face(&corners, "OFF")).map_err(|problem| (problem, Place::Line(line)))
}
