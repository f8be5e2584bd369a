//! The k-th separator of the tiling, from the sorted list of all vertices: the truth the method is held to.
//!
//! # Source
//! The definition.
//!
//! # Method
//! 1. Sort the crossings of all pairs of lines by x, then y.
//! 2. The line L_k runs between the k-th and the next. Of two lines that cross left of it the steeper one is above on
//!    L_k, of two that cross right of it the other one; vertical lines count as infinitely steep; parallel ones keep
//!    their order. Sort by that.
//! 3. Step down from the sum of all upward generators.
//!
//! # Complexity
//! O(n² log n) rational operations; space O(n²).
//!
//! # Shapes
//! `dual`: of n generators in any order, n up to about 100; `k`: from 0.
//!
//! # Numerics
//! Everything is exact rational arithmetic.
//!
//! # Checked by
//! Hand-worked examples; the areas of the tiles on the left.
//!
//! # Example
//! ```
//! use zonotope::arrangement::DualArrangement;
//! use zonotope::arrangement::separator::brute_force::separator;
//! // The plane Q is the rectangle of the corners (±2, ±1); (0, 0, 1) has no line.
//! let generators = [[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
//! let dual = DualArrangement::new(&generators).unwrap();
//! assert_eq!(separator(&dual, 0).unwrap().points(), [[-2.0, 1.0], [-2.0, -1.0], [2.0, -1.0]]);
//! assert_eq!(separator(&dual, 1).unwrap().points(), [[-2.0, 1.0], [2.0, 1.0], [2.0, -1.0]]);
//! ```

use std::cmp::Ordering;

use super::{Separator, SeparatorError};
use crate::arrangement::dual::{DualArrangement, Upward};
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;

type Point = [Rational; 2];

/// The k-th separator.
///
/// # Errors
/// [`SeparatorError`] when k is above the number of tiles or falls within a facet of coplanar generators.
pub fn separator(dual: &DualArrangement, k: u64) -> Result<Separator, SeparatorError> {
    let mut steps: Vec<&Upward> = dual.slanted.iter().chain(&dual.level).collect();
    let pairs = (0..steps.len()).flat_map(|j| (0..j).map(move |i| [i, j]));
    let mut vertices: Vec<(Point, [usize; 2])> =
        pairs.filter_map(|pair| Some((crossing(pair.map(|i| steps[i]))?, pair))).collect();
    vertices.sort();
    let tiles = vertices.len() as u64;
    if k > tiles {
        return Err(SeparatorError::Rank { k, tiles });
    }
    let (passed, left) = vertices.split_at(k as usize);
    let last = passed.last().map(|(point, _)| point);
    if last.is_some() && last == left.first().map(|(point, _)| point) {
        let here = vertices.iter().filter(|(point, _)| Some(point) == last);
        let mut generators: Vec<usize> = here.flat_map(|(_, pair)| pair.map(|i| steps[i].generator as usize)).collect();
        generators.sort_unstable();
        generators.dedup();
        return Err(SeparatorError::Coplanar { k, generators });
    }
    steps.sort_by(|&a, &b| match crossing([a, b]) {
        None => parallel_order(a, b),
        Some(point) => {
            let steeper = steepness(a).cmp(&steepness(b));
            if last.is_some_and(|last| point <= *last) { steeper.reverse() } else { steeper }
        }
    });
    Ok(Separator::of_steps(steps.into_iter()))
}

/// Where the lines of two generators cross.
fn crossing(pair: [&Upward; 2]) -> Option<Point> {
    let [[a, b, c], [d, e, f]] = pair.map(|upward| upward.vector.map(|v| Dyadic::from_f64(v).to_rational()));
    let w = &a * &e - &b * &d;
    (w != Rational::ZERO).then(|| [(&b * &f - &c * &e) / &w, (&c * &d - &a * &f) / &w])
}

/// The slope of the line; none, above all others, for a vertical one.
fn steepness(upward: &Upward) -> (bool, Rational) {
    let [a, b, _] = upward.vector.map(|v| Dyadic::from_f64(v).to_rational());
    if b == Rational::ZERO { (true, Rational::ZERO) } else { (false, -a / b) }
}

/// From top to bottom: the higher first, of vertical lines the left one first, which the leaning line meets higher up.
/// Lines that coincide lie in the order of input, from bottom to top and from left to right.
fn parallel_order(a: &Upward, b: &Upward) -> Ordering {
    let position = |upward: &Upward| {
        let [x, y, z] = upward.vector.map(|v| Dyadic::from_f64(v).to_rational());
        if y == Rational::ZERO { z / x } else { -z / y }
    };
    let input = a.generator.cmp(&b.generator);
    let coincident = if a.vector[1] == 0.0 { input } else { input.reverse() };
    position(b).cmp(&position(a)).then(coincident)
}
