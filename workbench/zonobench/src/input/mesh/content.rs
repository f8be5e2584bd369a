//! The content of a mesh, as the readers of all formats collect it.

use super::super::error::{Place, Problem};
use super::super::number::{self, Losses};
use super::super::points::push_limited;
use super::super::reading::Skipping;

/// The content of a mesh.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Mesh {
    /// The vertices, in the order of the file; NaN for one that is left out, until [`Mesh::finish`].
    pub(super) vertices: Vec<[f64; 3]>,
    /// The faces, each a list of three or more vertices.
    pub(super) faces: Vec<Box<[usize]>>,
    /// The parts of the file that were left out.
    pub(super) left_out: Vec<String>,
    /// Other things to know about the reading.
    pub(super) notes: Vec<String>,
    /// The numbers of a text that doubles do not hold.
    pub(super) losses: Losses,
}

impl Mesh {
    /// Adds a vertex; a place for one that is left out, because a coordinate is missing or not finite.
    pub(super) fn push(
        &mut self,
        vertex: Result<[f64; 3], Problem>,
        skipping: &mut Skipping,
        place: impl Fn(usize) -> Place,
    ) -> Result<(), Misplaced> {
        let kept = self.vertices.len().saturating_sub(skipping.count());
        let vertex = match vertex {
            Err(problem) if skipping.passes_over(&problem, kept) => Ok([f64::NAN; 3]),
            vertex => vertex,
        };
        let number = self.vertices.len() + 1;
        vertex.and_then(|vertex| push_limited(&mut self.vertices, vertex)).map_err(|problem| (problem, place(number)))
    }

    /// Adds a face; fewer than three corners are none. An error if a corner is not there.
    pub(super) fn add_face(&mut self, corners: &[usize], format: &str) -> Result<(), Problem> {
        let count = self.vertices.len();
        if let Some(corner) = corners.iter().find(|&&corner| corner >= count) {
            let complaint = format!("a face has the vertex {corner}, counted from 0, of {count}");
            return Err(broken(format, &complaint));
        }
        if corners.len() >= 3 {
            self.faces.push(corners.into());
        }
        Ok(())
    }

    /// The mesh without the vertices that are left out and the faces at these.
    pub(super) fn finish(self) -> Self {
        let is_left_out = |vertex: &[f64; 3]| vertex[0].is_nan();
        let holes: Vec<usize> = (0..self.vertices.len()).filter(|&v| is_left_out(&self.vertices[v])).collect();
        if holes.is_empty() {
            return self;
        }
        let place = |&corner: &usize| holes.binary_search(&corner).err().map(|before| corner - before);
        let faces = self.faces.iter().filter_map(|face| face.iter().map(place).collect()).collect();
        let vertices = self.vertices.into_iter().filter(|vertex| !is_left_out(vertex)).collect();
        Self { vertices, faces, ..self }
    }
}

/// The fault, and its place in the file.
pub(super) type Misplaced = (Problem, Place);

/// The coordinates that three words of a line spell, in these columns, or why a coordinate is missing; a broken
/// number is an error, and comes before a missing one. The losses take notice of them.
pub(super) fn on_line(
    words: [&[u8]; 3],
    columns: [u64; 3],
    line: u64,
    losses: &mut Losses,
) -> Result<Result<[f64; 3], Problem>, Misplaced> {
    let mut read = [0.0; 3];
    let mut missing = None;
    for ((column, slot), word) in columns.into_iter().zip(&mut read).zip(words) {
        let place = Place::Cell { line, column };
        match number::number(word) {
            Ok(number) => {
                losses.note(word, number, || place);
                *slot = number;
            }
            Err(problem) if problem.is_missing() => missing = missing.or(Some(problem)),
            Err(problem) => return Err((problem, place)),
        }
    }
    Ok(missing.map_or(Ok(read), Err))
}

/// Whether coordinates from the bytes of a file are finite.
pub(super) fn finite(vertex: [f64; 3]) -> Result<[f64; 3], Problem> {
    match vertex.iter().find(|x| !x.is_finite()) {
        Some(wrong) => Err(Problem::NotFinite(wrong.to_string())),
        None => Ok(vertex),
    }
}

/// The place of a vertex, counted from 1, on a line.
pub(super) fn vertex_on_line(number: usize, line: u64) -> Place {
    Place::Path(format!("vertex {number}, line {line}"))
}

/// A reader's complaint.
pub(super) fn broken(format: &str, complaint: &str) -> Problem {
    Problem::Mesh { format: format.to_owned(), complaint: complaint.to_owned() }
}
