//! The content of a mesh, as the readers of all formats collect it.

use super::super::error::{Place, Problem};
use super::super::number::{self, Losses};
use super::super::points::push_limited;
use super::super::reading::{Skipping, counted};

/// The content of a mesh, of space unless the format has others.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Mesh<const D: usize = 3> {
    /// The vertices, in the order of the file; NaN for one that is left out, until [`Mesh::finish`].
    pub(super) vertices: Vec<[f64; D]>,
    /// The faces, each a list of three or more vertices.
    pub(super) faces: Vec<Box<[usize]>>,
    /// The parts of the file that were left out.
    pub(super) left_out: Vec<String>,
    /// Other things to know about the reading.
    pub(super) notes: Vec<String>,
    /// The numbers of a text that doubles do not hold.
    pub(super) losses: Losses,
}

impl<const D: usize> Default for Mesh<D> {
    fn default() -> Self {
        let (vertices, faces, losses) = (Vec::new(), Vec::new(), Losses::default());
        Self { vertices, faces, left_out: Vec::new(), notes: Vec::new(), losses }
    }
}

impl<const D: usize> Mesh<D> {
    /// Adds a vertex; a place for one that is left out, because a coordinate is missing or not finite.
    pub(super) fn push(
        &mut self,
        vertex: Result<[f64; D], Problem>,
        skipping: &mut Skipping,
        place: impl Fn(usize) -> Place,
    ) -> Result<(), Misplaced> {
        let kept = self.vertices.len().saturating_sub(skipping.count());
        let vertex = match vertex {
            Err(problem) if skipping.passes_over(&problem, kept) => Ok([f64::NAN; D]),
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

    /// The vertices alone; faces are those of meshes of space.
    pub(super) fn without_faces(mut self) -> Self {
        self.left_out.extend(counted(self.faces.len(), "face", "faces"));
        Self { faces: Vec::new(), ..self }
    }

    /// The mesh without the vertices that are left out and the faces at these.
    pub(super) fn finish(self) -> Self {
        let is_left_out = |vertex: &[f64; D]| vertex[0].is_nan();
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

/// The coordinates that words of a line spell, in these columns, or why a coordinate is missing; a broken
/// number is an error, and comes before a missing one. The losses take notice of them.
pub(super) fn on_line<const D: usize>(
    words: [&[u8]; D],
    columns: [u64; D],
    line: u64,
    losses: &mut Losses,
) -> Result<Result<[f64; D], Problem>, Misplaced> {
    let mut read = [0.0; D];
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
