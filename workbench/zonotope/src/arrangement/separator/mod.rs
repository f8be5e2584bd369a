//! Problem: the k-th separator of the tiling, from left to right (Section 5.1).
//!
//! The projections of the facets of the upper hull tile the zonogon Q, a parallelogram T_ij for each vertex of the dual
//! arrangement where the lines of generators i and j cross. Number the tiles by the abscissas of their vertices. L_k is
//! the vertical line just right of the k-th vertex, and the k-th separator L'_k is the chain from the top to the bottom
//! vertex of Q with the tiles 1 … k on its left: it takes a step of −2 v' for each line that L_k meets from top to
//! bottom, every v' turned to point up.
//!
//! The paper assumes general position. Here L_k leans a little to the left, by less than any angle that matters:
//! vertices with one abscissa are numbered from bottom to top, a generator with y = 0 points up when x < 0, and its
//! vertical line is crossed far up or far down. So every input has its separators but those that would cut a facet of
//! more than two generators into tiles, for which there is more than one way: they are refused. A vertical generator
//! has no line and no step, a zero one neither.
//!
//! # Statement
//! Input: the [`DualArrangement`](super::DualArrangement) of n generators and k, from 0 to the number of tiles. Output:
//! the monotone chain from the top to the bottom vertex of Q with the tiles 1 … k on its left. Several vertices at one
//! abscissa count from bottom to top. Zero, vertical, level and parallel generators are ordinary input; a k that ends
//! within a facet of coplanar generators is refused.
//!
//! # Errors
//! [`SeparatorError::Rank`] ⇔ k is above the number of tiles. [`SeparatorError::Coplanar`] ⇔ the k-th and the next
//! vertex are one point.
//!
//! # Methods
//! | method | cost for n generators | what it is |
//! |---|---|---|
//! | [`brute_force`] | O(n² log n), exact rationals | the truth |
//! | [`by_slope_selection`] | O(n log n) expected | the paper's, the default |

pub mod brute_force;
pub mod by_slope_selection;
mod method;

use thiserror::Error;

pub use by_slope_selection::separator;
pub use method::Method;

use super::dual::Upward;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_sum::ExactSum;

/// A monotone chain from the top to the bottom vertex of Q.
#[derive(Debug, Clone, PartialEq)]
pub struct Separator {
    /// The generators whose steps it takes, from the top.
    pub generators: Vec<usize>,
    /// Its points, one more than steps, exactly; Q has its centre in the origin.
    pub exact_points: Vec<[Dyadic; 2]>,
}

/// Why there is no k-th separator.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SeparatorError {
    /// There are fewer tiles than are to lie on its left.
    #[error("there is no separator with {k} tiles on its left: there are {tiles} tiles")]
    Rank {
        /// How many tiles are to lie on its left.
        k: u64,
        /// How many tiles there are.
        tiles: u64,
    },
    /// It would cut a facet of several coplanar generators, and there is more than one way to tile it.
    #[error("{k} tiles end within a facet: the generators {generators:?} are coplanar, not in general position")]
    Coplanar {
        /// How many tiles are to lie on its left.
        k: u64,
        /// The generators of the facet, three at least, or two that are parallel and one more.
        generators: Vec<usize>,
    },
}

impl Separator {
    /// The chain of generators from the top, each turned to point up. O(n) exact operations.
    pub(crate) fn of_steps<'a>(steps: impl Iterator<Item = &'a Upward>) -> Self {
        let steps: Vec<&Upward> = steps.collect();
        let mut top = [ExactSum::default(), ExactSum::default()];
        for upward in &steps {
            top[0].add(upward.vector[0]);
            top[1].add(upward.vector[1]);
        }
        let mut exact_points = vec![top.map(|sum| sum.value())];
        for upward in &steps {
            let [x, y] = exact_points.last().expect("the top is there");
            let step = |from: &Dyadic, axis: usize| from - &Dyadic::from_f64(upward.vector[axis]).scaled(1);
            exact_points.push([step(x, 0), step(y, 1)]);
        }
        Self { generators: steps.iter().map(|upward| upward.generator as usize).collect(), exact_points }
    }

    /// The points as fractions.
    pub fn rational_points(&self) -> Vec<[Rational; 2]> {
        self.exact_points.iter().map(|[x, y]| [x.to_rational(), y.to_rational()]).collect()
    }

    /// The points, each coordinate within a relative 2^-50.
    pub fn points(&self) -> Vec<[f64; 2]> {
        self.exact_points.iter().map(|[x, y]| [x.to_f64(), y.to_f64()]).collect()
    }
}

#[cfg(test)]
mod tests;
