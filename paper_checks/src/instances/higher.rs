//! Generators of R^4 and R^5 for the checks of statements about any dimension.

use rand::RngExt;
use rand_pcg::Pcg64Mcg;

use crate::definitions::enclosing::{Row, rank, rows};
use crate::definitions::signs::are_independent;

/// Generators that span their space, with integer coordinates.
pub(crate) struct Spanning<const D: usize> {
    /// The generators.
    pub(crate) generators: Vec<[i64; D]>,
    /// Whether any D of them are independent.
    pub(crate) is_general: bool,
}

impl<const D: usize> Spanning<D> {
    /// The generators in exact rationals.
    pub(crate) fn rows(&self) -> Vec<Row> {
        rows(&self.generators)
    }
}

/// Lists of D to D + 3 generators that span R^D: coordinates to 20 for every second list, to 1 for the others,
/// in which many are dependent or parallel.
pub(crate) fn spanning<const D: usize>(random: &mut Pcg64Mcg, count: usize) -> Vec<Spanning<D>> {
    (0..count)
        .map(|index| {
            let reach = if index % 2 == 0 { 20 } else { 1 };
            loop {
                let vector = |random: &mut Pcg64Mcg| std::array::from_fn(|_| random.random_range(-reach..=reach));
                let generators: Vec<[i64; D]> = (0..D + index % 4).map(|_| vector(random)).collect();
                let is_zero = |generator: &[i64; D]| generator.iter().all(|c| *c == 0);
                if rank(&rows(&generators)) == D && !generators.iter().any(is_zero) {
                    let is_general = are_independent(&rows(&generators), D);
                    return Spanning { generators, is_general };
                }
            }
        })
        .collect()
}
