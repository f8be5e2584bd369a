//! Generators by the cells of a grid on the faces of a cube through which their rays leave it.

use crate::numeric::scaling::largest_magnitude;

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

/// The cells that hold generators, in the order of their places.
pub(super) fn cells<const D: usize>(vectors: &[[f64; D]], side: u32) -> Vec<Cell<D>> {
    let mut placed: Vec<(usize, Place<D>, usize)> = (0..vectors.len())
        .filter_map(|index| {
            let v = &vectors[index];
            let largest = largest_magnitude(v);
            let axis = v.iter().position(|c| c.abs() == largest)?;
            let part = |c: f64| (((c / v[axis] + 1.0) * 0.5 * f64::from(side)) as u32).min(side - 1);
            let place = std::array::from_fn(|k| if k == axis { 0 } else { part(v[k]) });
            (largest > 0.0).then_some((axis, place, index))
        })
        .collect();
    placed.sort_unstable();
    let middle = |axis: usize, place: &Place<D>| {
        let along = |k: usize| (2.0 * f64::from(place[k]) + 1.0) / f64::from(side) - 1.0;
        std::array::from_fn(|k| if k == axis { 1.0 } else { along(k) })
    };
    placed
        .chunk_by(|a, b| (a.0, a.1) == (b.0, b.1))
        .map(|cell| Cell {
            middle: middle(cell[0].0, &cell[0].1),
            members: cell.iter().map(|(_, _, index)| *index).collect(),
        })
        .collect()
}
