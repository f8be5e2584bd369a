//! Arithmetic without rounding: doubles as whole multiples of one power of two, and what is built on these integers.

pub(crate) mod fraction;
pub(crate) mod grid;
pub(crate) mod inversions;
pub(crate) mod length;
pub(crate) mod linear;
pub(crate) mod polygon;
pub(crate) mod proportion;
pub(crate) mod subsets;
pub(crate) mod turns;

use dashu_int::IBig;

/// A direction of finite doubles as whole numbers of one unit: the length of a direction says nothing.
pub fn whole_direction(direction: &[f64]) -> Vec<IBig> {
    let grid = grid::Grid::of(direction.iter().copied());
    direction.iter().map(|&component| grid.units(component)).collect()
}
