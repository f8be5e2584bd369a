//! Integer points of a square: every coordinate is shared by many points, and most turns are ties.

use super::family::{Family, HullSize};
use crate::source::RandomSource;

/// Distinct integer points of the smallest square grid that holds n of them.
pub const LATTICE: Family = Family {
    id: "lattice",
    title: "Lattice",
    description: "n distinct integer points, chosen at random from the square grid with ceil(sqrt(n)) points a side",
    hull_size: HullSize::Few,
    is_random: true,
    generate: points,
};

fn points(n: usize, seed: u64) -> Vec<[f64; 2]> {
    let floor = n.isqrt();
    let side = if floor * floor == n { floor } else { floor + 1 };
    let mut cells: Vec<usize> = (0..side * side).collect();
    RandomSource::new(seed).shuffle(&mut cells);
    cells.truncate(n);
    cells.iter().map(|cell| [(cell % side) as f64, (cell / side) as f64]).collect()
}
