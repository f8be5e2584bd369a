//! Section 4.2: enclosing zonotopes along given directions.

pub(crate) mod extreme_points;
pub(crate) mod linear_program;
pub(crate) mod polynomial_time;
pub(crate) mod structure_from_directions;
pub(crate) mod theorem_4_6;

use rand::RngExt;
use rand_pcg::Pcg64Mcg;

use crate::definitions::enclosing::{rank, rows};

/// Random lattice points, and directions that span; one direction in three is a multiple of another one when there are
/// enough.
fn random_problem<const D: usize>(
    random: &mut Pcg64Mcg,
    points: usize,
    directions: usize,
) -> (Vec<[i64; D]>, Vec<[i64; D]>) {
    let mut vectors = |count: usize, reach: i64| -> Vec<[i64; D]> {
        (0..count).map(|_| std::array::from_fn(|_| random.random_range(-reach..=reach))).collect()
    };
    let points = vectors(points, 30);
    loop {
        let mut chosen = vectors(directions, 5);
        if directions > D && points[0][0] % 3 == 0 {
            chosen[0] = chosen[1].map(|c| -2 * c);
        }
        if rank(&rows(&chosen)) == D {
            return (points, chosen);
        }
    }
}
