//! Generators by the cells of a grid on the faces of a cube through which their rays leave it.

use std::collections::HashMap;

use crate::tally::{Operation, Tally};
use crate::zonotope::directions::cube_faces::{cell_at, face_of, middle_of};

/// The finest grid: indices of cells along a side fit in 32 bits.
pub(super) const SIDE_LIMIT: u32 = 1 << 31;

/// A cell of the grid: the face's axis, and along every other axis which part of the side.
type Place<const D: usize> = [u32; D];

/// A cell with its generators, by their indices.
pub(super) struct Cell<const D: usize> {
    /// The middle of the cell, on the face.
    pub(super) middle: [f64; D],
    pub(super) members: Vec<usize>,
}

/// The cells that hold generators, in the order of their places. O(n), and O(k log k) to sort k cells.
///
/// A read is counted for each generator, and the comparisons of the sort.
pub(super) fn cells<const D: usize>(vectors: &[[f64; D]], side: u32, tally: &mut dyn Tally) -> Vec<Cell<D>> {
    let mut numbers: HashMap<(usize, Place<D>), usize> = HashMap::new();
    let mut found: Vec<((usize, Place<D>), Vec<usize>)> = Vec::new();
    for (index, vector) in vectors.iter().enumerate() {
        let Some(place) = place(vector, side) else { continue };
        let number = *numbers.entry(place).or_insert(found.len());
        if number == found.len() {
            found.push((place, Vec::new()));
        }
        found[number].1.push(index);
    }
    let mut comparisons = 0;
    found.sort_unstable_by(|(a, _), (b, _)| {
        comparisons += 1;
        a.cmp(b)
    });
    tally.add(Operation::GeneratorRead, vectors.len() as u64);
    tally.add(Operation::Comparison, comparisons);
    let middle = |(axis, place): (usize, Place<D>)| {
        std::array::from_fn(|k| if k == axis { 1.0 } else { middle_of(place[k], side) })
    };
    found.into_iter().map(|(place, members)| Cell { middle: middle(place), members }).collect()
}

/// The face's axis and the cell through which a ray leaves the cube; none for the vector zero.
fn place<const D: usize>(vector: &[f64; D], side: u32) -> Option<(usize, Place<D>)> {
    let axis = face_of(vector)?;
    let part = |k: usize| if k == axis { 0 } else { cell_at(vector[k] / vector[axis], side) };
    Some((axis, std::array::from_fn(part)))
}
