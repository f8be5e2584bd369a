//! The cost of rounding the centre of an enclosing zonotope along given directions to doubles.
//!
//! A centre that is moved by t leaves the points in the zonotope if ±t is added to it: with t = Σ μ_i v_i over a basis
//! of the directions, that costs Σ w_i |μ_i| at most. The cheapest basis that is looked at gives the bound.

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::Abs;

use crate::exact::grid::Grid;
use crate::exact::linear::{Echelon, Vector, solve};
use crate::exact::proportion::Proportion;
use crate::exact::subsets::{count_subsets, subsets};

/// Limit of the bases that are looked at: all if there are no more, else one.
const MOST_BASES: u64 = 2000;

/// A bound of the cost of moving the centre by one unit in the last place along every axis; `None` if the directions
/// do not span the space.
pub(super) fn cost_of_rounding(directions: &[Vec<f64>], weights: &[f64], center: &[f64]) -> Option<Proportion> {
    let grid = Grid::of(directions.iter().flatten().copied());
    let directions: Vec<Vector> = directions.iter().map(|v| v.iter().map(|&x| grid.units(x)).collect()).collect();
    let (count, dimension) = (directions.len(), center.len());
    let cost = |basis: &[usize]| cost_with(weights, center, basis, &directions, grid);
    if count_subsets(count, dimension) <= MOST_BASES {
        let costs = subsets(count, dimension).filter_map(|basis| cost(&basis));
        return costs.min_by(|a, b| a.compare(b));
    }
    let mut echelon = Echelon::spanned(dimension, []);
    let basis: Vec<usize> = (0..count).filter(|&index| echelon.insert(&directions[index])).collect();
    (basis.len() == dimension).then(|| cost(&basis)).flatten()
}

/// The cost by one choice of as many directions as there are coordinates; `None` if they are dependent.
fn cost_with(
    weights: &[f64],
    center: &[f64],
    basis: &[usize],
    directions: &[Vector],
    grid: Grid,
) -> Option<Proportion> {
    let columns: Vec<&Vector> = basis.iter().map(|&index| &directions[index]).collect();
    let of_weights = Grid::of(basis.iter().map(|&index| weights[index]));
    let mut sum = Proportion::of_double(0.0);
    for (axis, &coordinate) in center.iter().enumerate() {
        let target: Vector = (0..center.len()).map(|other| IBig::from(u8::from(other == axis))).collect();
        let (numerators, denominator) = solve(&columns, &target)?;
        let along: IBig = basis.iter().zip(numerators).map(|(&i, x)| of_weights.units(weights[i]) * x.abs()).sum();
        let along = Proportion::new(along, denominator, of_weights.exponent() - grid.exponent());
        sum = sum.plus(&along.times(&Proportion::of_double(last_place(coordinate))));
    }
    Some(sum)
}

/// The distance of a finite double from its neighbour on the side of zero, from zero the smallest double.
fn last_place(number: f64) -> f64 {
    let size = number.abs();
    if size == 0.0 { f64::from_bits(1) } else { size - size.next_down() }
}

/// Whether a gap is more than so many times what rounding a centre costs, and more than a part of the value; never
/// where that cost is not known.
pub(super) fn is_beyond(gap: &Proportion, cost: Option<Proportion>, room: f64, of_value: &Proportion) -> bool {
    cost.is_some_and(|cost| {
        let allowed = cost.times(&Proportion::of_double(room)).plus(of_value);
        gap.compare(&allowed) == Ordering::Greater
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_in_the_last_place_costs_what_the_cheapest_basis_says() {
        let directions = [vec![1.0, 0.0], vec![0.0, 2.0], vec![1.0, 1.0]];
        // (1, 0) costs 1; (0, 1) costs 3 by the second direction, and 2 by the first and the third
        let cost = cost_of_rounding(&directions, &[1.0, 6.0, 1.0], &[4.0, 1.0]).expect("the directions span the plane");
        let [of_x, of_y] = [4.0 - 4.0f64.next_down(), 1.0 - 1.0f64.next_down()];
        assert_eq!(cost.nearest(), of_x + 2.0 * of_y);
        let flat = [vec![1.0, 0.0], vec![2.0, 0.0]];
        assert!(cost_of_rounding(&flat, &[1.0; 2], &[4.0, 1.0]).is_none());
    }

    #[test]
    fn a_gap_is_beyond_rounding_where_it_is_more_than_what_is_allowed() {
        let [cost, of_value] = [2.0, 0.5].map(Proportion::of_double);
        let is_beyond = |gap: f64, cost| is_beyond(&Proportion::of_double(gap), cost, 3.0, &of_value);
        assert!(is_beyond(6.5_f64.next_up(), Some(cost.clone())));
        assert!(!is_beyond(6.5, Some(cost)));
        assert!(!is_beyond(1e300, None), "a cost that is not known is beyond no gap");
    }

    #[test]
    fn directions_that_are_half_as_long_cost_twice_as_much() {
        let halves = [vec![0.5, 0.0], vec![0.0, 1.0], vec![0.5, 0.5]];
        let cost = cost_of_rounding(&halves, &[1.0, 6.0, 1.0], &[4.0, 1.0]).expect("the directions span the plane");
        let [of_x, of_y] = [4.0 - 4.0f64.next_down(), 1.0 - 1.0f64.next_down()];
        assert_eq!(cost.nearest(), 2.0 * (of_x + 2.0 * of_y));
    }

    /// The last direction of the line is the cheapest; 64 directions have 2016 pairs.
    #[test]
    fn the_cheapest_of_two_thousand_bases_is_found_and_of_more_the_first_is_taken() {
        let cost_of_one = |count: usize| {
            let weights: Vec<f64> = (1..=count).map(|index| if index == count { 0.25 } else { 1.0 }).collect();
            cost_of_rounding(&vec![vec![1.0]; count], &weights, &[1.0]).map(|cost| cost.nearest())
        };
        let place = 1.0 - 1.0f64.next_down();
        let most = usize::try_from(MOST_BASES).expect("two thousand");
        assert_eq!(cost_of_one(most), Some(0.25 * place));
        assert_eq!(cost_of_one(most + 1), Some(place));
        assert!(cost_of_rounding(&vec![vec![1.0, 2.0]; 64], &[1.0; 64], &[1.0, 1.0]).is_none(), "they span a line");
    }
}
