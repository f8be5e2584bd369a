//! The penetration depth, by branch and bound over cells of directions.
//!
//! # Statement
//! Input: a query in space, with a displacement p and the generators of a zonotope Z. Output: a [`Penetration`] whose
//! bounds hold the distance of p from the boundary of Z and differ by at most a hundredth of the upper one, for a p
//! inside of Z; 0 for all others, touching included, and so for every p where Z is flat.
//!
//! # Source
//! Beyond the paper, whose Lemma 5.1 makes one body of two.
//!
//! # Method
//! 1. The kernel decides whether p is inside.
//! 2. The least h(u) − u · p over unit vectors u is searched for over cells of directions, the cell of the least lower
//!    bound first (`zonotope::direction_search`). On a cell nearly all generators have a fixed sign and are summed up
//!    once for the cell and all its parts (`depth_in_cells`).
//! 3. A cell that few generators cross is settled by the normals of pairs of these.
//! 4. Of very few generators, and where pairs of doubles do not hold the depth within a hundredth after many cells,
//!    every facet normal is tried exactly ([`by_facet_normals`](super::by_facet_normals)), if there are at most
//!    [`EXACT_COUNT`] generators.
//!
//! # Complexity
//! n generators: O(n) for the first cells, then less for each as fewer generators cross it; some hundred to some
//! thousand cells, more the nearer Z is to a ball around p. Space O(n) for each open cell at worst.
//!
//! # Shapes
//! `query`: n × 3 generators in two runs, any order, zero and parallel ones allowed.
//!
//! # Numerics
//! Whether p is inside is exact. Bounds hold against all rounding: sums are taken to twice the digits of a double with
//! bounds on their errors. Of more than [`EXACT_COUNT`] generators, the bounds of a body more than some 10^25 times as
//! wide as deep may differ by more than a hundredth.
//!
//! # Errors
//! None: the query was validated when it was made.
//!
//! # Panics
//! Never.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) on every family; [`by_facet_normals`](super::by_facet_normals).
//!
//! # Example
//! ```
//! use zonotope::collision::{Query, distance::penetration::by_branch_and_bound};
//! // two cubes [−1, 1]³ whose centres are (3/2, 1, 0) apart overlap by 1/2 along the first axis
//! let cubes = [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]];
//! let query = Query::new([0.0; 3], [1.5, 1.0, 0.0], &cubes).unwrap();
//! let depth = by_branch_and_bound::penetration(&query);
//! assert!(depth.lower <= 0.5 && 0.5 <= depth.upper && depth.is_within(0.01));
//! ```

use super::Penetration;
use super::by_facet_normals::of_exact;
use super::depth_in_cells::DepthInCells;
use crate::collision::Location;
use crate::collision::by_lad::{locate_counted, locate_posed_counted};
use crate::lad::of_generators::generators::{KernelQuery, Posed};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, exact, is_zero, rounded_direction};
use crate::numeric::scaling::scale_by_power_of_two;
use crate::tally::{Operation, Tally};
use crate::zonotope::direction_search::best_first::least_value;
use crate::zonotope::posed_query::PosedQuery;
use crate::zonotope::query::Query;

/// By how much the bounds may differ, in terms of the upper one.
pub const ACCURACY: f64 = 0.01;

/// The most generators whose facet normals are all tried where doubles leave a doubt.
pub const EXACT_COUNT: usize = 256;

/// The most generators whose facet normals are all tried without a search: they cost no more.
const SEARCHLESS_COUNT: usize = 8;

/// The most cells that are looked at.
const MOST_CELLS: u64 = 1 << 18;

/// The cells that are looked at at most where all facet normals can be tried instead: these take about as long as a
/// cell for so many products of a normal with a generator.
const PRODUCTS_OF_A_CELL: u64 = 32;

/// How deep the displacement of a query lies in the zonotope.
pub fn penetration(query: &Query<'_, 3>) -> Penetration<3> {
    penetration_counted(query, &mut ())
}

/// [`penetration`], counting its operations.
pub fn penetration_counted(query: &Query<'_, 3>, tally: &mut dyn Tally) -> Penetration<3> {
    match locate_counted(query, tally) {
        Location::Inside(_) => of_inner_point(query, tally),
        Location::Boundary(_) | Location::Outside(_) => Penetration::NONE,
    }
}

/// How deep the displacement of a query under poses lies in the zonotope.
pub fn penetration_posed(query: &PosedQuery<'_>) -> Penetration<3> {
    match locate_posed_counted(query, &mut ()) {
        Location::Inside(_) => of_inner_point(&Posed::new(query), &mut ()),
        Location::Boundary(_) | Location::Outside(_) => Penetration::NONE,
    }
}

/// The depth of a displacement that is inside.
pub(in crate::collision::distance) fn of_inner_point(query: &dyn KernelQuery, tally: &mut dyn Tally) -> Penetration<3> {
    let indices: Vec<u32> =
        (0..query.len() as u32).filter(|&index| !is_zero(&query.exact_generator(index as usize))).collect();
    let exact_depth = || {
        let generators: Vec<ExactVector> = indices.iter().map(|&index| query.exact_generator(index as usize)).collect();
        of_exact(&query.exact(), &generators)
    };
    if indices.len() <= SEARCHLESS_COUNT {
        return exact_depth();
    }
    let count = indices.len() as u64;
    let is_exact_possible = indices.len() <= EXACT_COUNT;
    let most_cells = if is_exact_possible { count * count * count / PRODUCTS_OF_A_CELL } else { MOST_CELLS };
    let largest = |index: &u32| query.exact_generator(*index as usize).iter().filter_map(Dyadic::binary_exponent).max();
    let size = indices.iter().filter_map(largest).max().unwrap_or(0);
    let function = DepthInCells::new(query, indices.clone(), -size);
    let (bracket, looks) = least_value(&function, ACCURACY, most_cells.min(MOST_CELLS) as u32);
    tally.add(Operation::SearchStep, u64::from(looks));
    if !bracket.is_within(ACCURACY) && is_exact_possible {
        return exact_depth();
    }
    // the bounds are normal doubles but where the depth is nearly out of the range of doubles
    Penetration {
        lower: scale_by_power_of_two(bracket.lower, size).next_down().max(0.0),
        upper: scale_by_power_of_two(bracket.upper, size).next_up(),
        direction: rounded_direction(&exact(bracket.direction)),
    }
}
