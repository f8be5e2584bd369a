//! The refusal of numbers that are NaN or infinite: one type for all inputs, which says where the number stands.

use std::fmt;

use fearless_simd::{Simd, dispatch, f64x8, prelude::*};
use thiserror::Error;

use super::lanes::level::level;
use super::lanes::octet::{LANES, total};

/// A number of an input is NaN or infinite.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error("{place} is {value}, not a finite number")]
pub struct NonFinite {
    /// Where the number stands: the first such place in the order of the input.
    pub place: Place,
    /// The number.
    pub value: f64,
}

/// Where a number stands in an input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// A coordinate of a vector that has a name of its own.
    Named {
        /// The vector, as a noun with its article: "the center".
        vector: &'static str,
        /// The coordinate, from 0.
        coordinate: usize,
    },
    /// A coordinate of a vector in a list.
    Listed {
        /// What the list holds: "generator".
        noun: &'static str,
        /// Which of them, from 0.
        index: usize,
        /// The coordinate, from 0.
        coordinate: usize,
    },
    /// A number in a list of numbers.
    Number {
        /// What the list holds: "weight".
        noun: &'static str,
        /// Which of them, from 0.
        index: usize,
    },
    /// A number of an item in a list, where the item's numbers have names of their own.
    Field {
        /// What the list holds: "line".
        noun: &'static str,
        /// Which of them, from 0.
        index: usize,
        /// The number of that item: "offset".
        field: &'static str,
    },
    /// An entry of a matrix.
    Entry {
        /// The row, from 0.
        row: usize,
        /// The column, from 0.
        column: usize,
    },
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Named { vector, coordinate } => write!(f, "{vector}'s coordinate {coordinate}"),
            Self::Listed { noun, index, coordinate } => write!(f, "{noun} {index}, coordinate {coordinate}"),
            Self::Number { noun, index } => write!(f, "{noun} {index}"),
            Self::Field { noun, index, field } => write!(f, "{noun} {index}: {field}"),
            Self::Entry { row, column } => write!(f, "the matrix's entry in row {row}, column {column}"),
        }
    }
}

impl NonFinite {
    /// Refuses a vector that has a name of its own, if a coordinate is not finite.
    #[inline]
    pub(crate) fn check_vector<const D: usize>(vector: &'static str, v: &[f64; D]) -> Result<(), Self> {
        if is_finite(v) {
            return Ok(());
        }
        match v.iter().position(|c| !c.is_finite()) {
            Some(coordinate) => Err(Self { place: Place::Named { vector, coordinate }, value: v[coordinate] }),
            None => Ok(()),
        }
    }

    /// Refuses a list of vectors, if a coordinate is not finite. O(n).
    pub(crate) fn check_list<const D: usize>(noun: &'static str, vectors: &[[f64; D]]) -> Result<(), Self> {
        if are_finite(vectors.as_flattened()) {
            return Ok(());
        }
        match vectors.as_flattened().iter().position(|c| !c.is_finite()) {
            Some(at) => {
                let (index, coordinate) = (at / D, at % D);
                Err(Self { place: Place::Listed { noun, index, coordinate }, value: vectors[index][coordinate] })
            }
            None => Ok(()),
        }
    }

    /// Refuses a list of numbers, if one is not finite. O(n).
    pub(crate) fn check_numbers(noun: &'static str, numbers: &[f64]) -> Result<(), Self> {
        match numbers.iter().position(|c| !c.is_finite()) {
            Some(index) => Err(Self { place: Place::Number { noun, index }, value: numbers[index] }),
            None => Ok(()),
        }
    }

    /// Refuses an item of a list, if one of its named numbers is not finite.
    pub(crate) fn check_fields(noun: &'static str, index: usize, fields: &[(&'static str, f64)]) -> Result<(), Self> {
        match fields.iter().find(|(_, value)| !value.is_finite()) {
            Some(&(field, value)) => Err(Self { place: Place::Field { noun, index, field }, value }),
            None => Ok(()),
        }
    }

    /// Refuses a matrix given by its rows, if an entry is not finite.
    #[inline]
    pub(crate) fn check_matrix<const D: usize>(rows: &[[f64; D]]) -> Result<(), Self> {
        if rows.iter().all(is_finite) {
            return Ok(());
        }
        match rows.as_flattened().iter().position(|c| !c.is_finite()) {
            Some(at) => {
                let (row, column) = (at / D, at % D);
                Err(Self { place: Place::Entry { row, column }, value: rows[row][column] })
            }
            None => Ok(()),
        }
    }
}

/// Whether all coordinates are finite, without a branch for each, as for [`are_finite`].
#[inline(always)]
fn is_finite<const D: usize>(v: &[f64; D]) -> bool {
    v.iter().fold(0.0, |zero, c| zero + 0.0 * c) == 0.0
}

/// Sums that are kept side by side, since each addition waits for the one before it.
const SIDE_BY_SIDE: usize = 4;

/// Whether all numbers are finite: zero times a number is zero for these alone. Several are looked at side by side,
/// without a branch for each, since lists of generators are checked whenever a query is made.
fn are_finite(numbers: &[f64]) -> bool {
    let (blocks, rest) = numbers.as_chunks();
    let is_zero = blocks.is_empty() || dispatch!(level(), simd => sum_of_zeros(simd, blocks)) == 0.0;
    is_zero && rest.iter().fold(0.0, |zero, c| zero + 0.0 * c) == 0.0
}

#[inline(always)]
fn sum_of_zeros<S: Simd>(simd: S, blocks: &[[f64; SIDE_BY_SIDE * LANES]]) -> f64 {
    let mut zeros = [f64x8::splat(simd, 0.0); SIDE_BY_SIDE];
    for block in blocks {
        for (zero, part) in zeros.iter_mut().zip(block.as_chunks::<LANES>().0) {
            *zero += f64x8::from_slice(simd, part) * 0.0;
        }
    }
    total((zeros[0] + zeros[1]) + (zeros[2] + zeros[3]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_message_names_the_first_place() {
        let text = |refused: Result<(), NonFinite>| refused.expect_err("a number is not finite").to_string();
        let [nan, inf] = [f64::NAN, f64::INFINITY];
        assert_eq!(
            text(NonFinite::check_vector("the center", &[1.0, inf])),
            "the center's coordinate 1 is inf, not a finite number"
        );
        let list = [[1.0, 2.0], [3.0, nan], [inf, 4.0]];
        let listed = "generator 1, coordinate 1 is NaN, not a finite number";
        assert_eq!(text(NonFinite::check_list("generator", &list)), listed);
        assert_eq!(text(NonFinite::check_numbers("weight", &[0.0, -inf])), "weight 1 is -inf, not a finite number");
        let entry = "the matrix's entry in row 1, column 1 is NaN, not a finite number";
        assert_eq!(text(NonFinite::check_matrix(&list)), entry);
        let field = "line 3: offset is NaN, not a finite number";
        assert_eq!(text(NonFinite::check_fields("line", 3, &[("weight", 1.0), ("offset", nan)])), field);
        assert_eq!(NonFinite::check_list("generator", &[[]]), Ok(()));
        // among more numbers than are looked at side by side
        let long: Vec<[f64; 3]> = (0..20).map(|i| [f64::from(i), -0.0, if i == 13 { nan } else { f64::MAX }]).collect();
        assert_eq!(
            text(NonFinite::check_list("generator", &long)),
            "generator 13, coordinate 2 is NaN, not a finite number"
        );
        assert_eq!(NonFinite::check_list("generator", &long[..13]), Ok(()));
    }

    #[test]
    fn one_number_that_is_not_finite_is_found_wherever_it_stands() {
        for len in 0..100 {
            let mut numbers: Vec<f64> = (0..len).map(|i| f64::from(i) - 40.0).collect();
            assert!(are_finite(&numbers), "{len}");
            for at in 0..numbers.len() {
                for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                    let finite = std::mem::replace(&mut numbers[at], value);
                    assert!(!are_finite(&numbers), "{value} at {at} of {len}");
                    numbers[at] = finite;
                }
            }
        }
        let largest = [f64::MAX; 3];
        assert!(is_finite(&largest) && is_finite(&[]) && are_finite(&[f64::MAX; 70]));
        assert!((0..3).all(|at| !is_finite(&[0, 1, 2].map(|k| if k == at { f64::NAN } else { 1.0 }))));
    }

    #[test]
    fn an_entry_of_a_matrix_is_named_by_its_row_and_its_column() {
        for (row, column) in [(0, 2), (1, 0), (2, 1)] {
            let mut rows = [[1.0; 3]; 3];
            rows[row][column] = f64::INFINITY;
            let refused = NonFinite { place: Place::Entry { row, column }, value: f64::INFINITY };
            assert_eq!(NonFinite::check_matrix(&rows), Err(refused));
        }
    }
}
