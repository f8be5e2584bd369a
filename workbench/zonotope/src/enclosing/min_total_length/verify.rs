//! Checks an answer in exact arithmetic, with code that shares nothing with the search.
//!
//! The multipliers add up to zero, and lower bound · |w| ≤ Σ λ_j · p_j for every vertex w of Σ [−1, 1] λ_j. In
//! coordinates in which the r-dimensional span of the multipliers is all of space, each vertex lies on the side of some
//! direction orthogonal to r − 1 independent multipliers; those orthogonal to it as well are a zonotope in a
//! hyperplane, whose vertices are found in the same way. So the vertices are enumerated by subsets, with exact normals
//! and exact signs. Containment is decided for each point by a rational program.

use std::cmp::Ordering;

use thiserror::Error;

use super::answer::MinLengthZonotope;
use crate::enclosing::fixed_directions::{FixedDirections, verify as directed};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::linear::sum_of_products;

/// What is wrong with an answer.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum MinLengthDefect {
    /// A point lies outside the zonotope.
    #[error("point {0} lies outside the zonotope")]
    Outside(usize),
    /// The stated length is below the sum of the lengths of the generators.
    #[error("the generators are longer than stated")]
    Length,
    /// The multipliers name points that do not exist, or do not add up to zero.
    #[error("the multipliers prove nothing")]
    Multipliers,
    /// The lower bound is above what the multipliers prove.
    #[error("the lower bound is above what the multipliers prove")]
    LowerBound,
    /// The ratio is below that of the length to the lower bound.
    #[error("the ratio is below that of the two bounds")]
    Ratio,
}

/// At most this many multipliers in one hyperplane are tried with all signs; of more, the vertices of their sum in that
/// hyperplane are enumerated.
const ALL_SIGNS_LIMIT: usize = 4;

/// Checks everything about an answer: a rational program for each point, exact vertices of all multipliers. For small
/// answers.
///
/// # Errors
/// The first defect found.
pub fn verify<const D: usize>(points: &[[f64; D]], answer: &MinLengthZonotope<D>) -> Result<(), MinLengthDefect> {
    verify_bounds(points, answer)?;
    let generators = answer.zonotope.generators();
    let ones = vec![1.0; generators.len()];
    let Ok(problem) = FixedDirections::new(points, generators, &ones) else { return Err(MinLengthDefect::Outside(0)) };
    let inside = |j: usize| directed::contains(&problem, answer.zonotope.center(), &ones, j);
    (0..points.len()).find(|&j| !inside(j)).map_or(Ok(()), |point| Err(MinLengthDefect::Outside(point)))
}

/// Checks length, lower bound and ratio, but not that the points are inside: O(m^D) exact operations for m multipliers.
///
/// # Errors
/// The first defect found.
pub fn verify_bounds<const D: usize>(
    points: &[[f64; D]],
    answer: &MinLengthZonotope<D>,
) -> Result<(), MinLengthDefect> {
    let exact = |v: f64| Dyadic::from_f64(v);
    if !is_at_least_length(answer.length, answer.zonotope.generators()) {
        return Err(MinLengthDefect::Length);
    }
    let mut gain = Dyadic::zero();
    let mut sum: [Dyadic; D] = std::array::from_fn(|_| Dyadic::zero());
    let mut multipliers: Vec<[Dyadic; D]> = Vec::with_capacity(answer.multipliers.len());
    for multiplier in &answer.multipliers {
        let point = points.get(multiplier.point).ok_or(MinLengthDefect::Multipliers)?;
        if !multiplier.vector.iter().all(|c| c.is_finite()) {
            return Err(MinLengthDefect::Multipliers);
        }
        let vector = multiplier.vector.map(exact);
        gain = gain + sum_of_products(&vector, &point.map(exact));
        sum = std::array::from_fn(|c| &sum[c] + &vector[c]);
        multipliers.push(vector);
    }
    if sum.iter().any(|c| !c.is_zero()) {
        return Err(MinLengthDefect::Multipliers);
    }
    if !answer.lower_bound.is_finite() {
        return Err(MinLengthDefect::LowerBound);
    }
    let bound = exact(answer.lower_bound);
    let is_positive = bound.sign().is_gt();
    if bound.sign().is_lt() || is_positive && gain.sign().is_le() {
        return Err(MinLengthDefect::LowerBound);
    }
    let (bound, gain) = (&bound * &bound, &gain * &gain);
    let origin: [Dyadic; D] = std::array::from_fn(|_| Dyadic::zero());
    if is_positive && &bound * &farthest_vertex(&origin, &multipliers) > gain {
        return Err(MinLengthDefect::LowerBound);
    }
    let is_ratio = answer.ratio == f64::INFINITY
        || answer.ratio >= 1.0 && exact(answer.length) <= &exact(answer.ratio) * &exact(answer.lower_bound);
    if is_ratio || answer.length == 0.0 { Ok(()) } else { Err(MinLengthDefect::Ratio) }
}

/// Whether Σ |g_i| ≤ length, by roots that are not too short.
fn is_at_least_length<const D: usize>(length: f64, generators: &[[f64; D]]) -> bool {
    let mut sum = Dyadic::zero();
    for generator in generators {
        let square = generator.iter().fold(Dyadic::zero(), |sum, &c| {
            let c = Dyadic::from_f64(c);
            sum + &c * &c
        });
        let Some(exponent) = square.binary_exponent() else { continue };
        // The root of the square as an even power of two times a number of ordinary size, from above.
        let shift = exponent.div_euclid(2);
        let mut root = square.clone().scaled(-2 * shift).to_f64().sqrt();
        while &Dyadic::from_f64(root) * &Dyadic::from_f64(root) < square.clone().scaled(-2 * shift) {
            root = root.next_up();
        }
        sum = sum + Dyadic::from_f64(root).scaled(shift);
    }
    length.is_finite() && sum <= Dyadic::from_f64(length)
}

/// The squared distance of the farthest vertex of base + Σ [−1, 1] λ_j.
fn farthest_vertex<const D: usize>(base: &[Dyadic; D], multipliers: &[[Dyadic; D]]) -> Dyadic {
    let multipliers: Vec<[Dyadic; D]> =
        multipliers.iter().filter(|f| f.iter().any(|c| !c.is_zero())).cloned().collect();
    let axes = independent_coordinates(&multipliers);
    let flat: Vec<Vec<Dyadic>> = multipliers.iter().map(|f| axes.iter().map(|&c| f[c].clone()).collect()).collect();
    let Some(size) = axes.len().checked_sub(1) else { return sum_of_products(base, base) };
    let mut farthest = Dyadic::zero();
    let mut subset: Vec<usize> = (0..size).collect();
    loop {
        let rows: Vec<&[Dyadic]> = subset.iter().map(|&j| &flat[j][..]).collect();
        let normal = normal_of(&rows, axes.len());
        if normal.iter().any(|c| !c.is_zero()) {
            let sides: Vec<Ordering> = flat.iter().map(|flat| sum_of_products(flat, &normal).sign()).collect();
            let tied: Vec<usize> = (0..multipliers.len()).filter(|&j| sides[j].is_eq()).collect();
            // Multipliers within one line apart, a hyperplane is met first by the first of its multipliers.
            if tied.first() == subset.first() {
                let ties: Vec<[Dyadic; D]> = tied.iter().map(|&j| multipliers[j].clone()).collect();
                for sign in [Ordering::Greater, Ordering::Less] {
                    let vertex = multipliers.iter().zip(&sides).filter(|(_, side)| side.is_ne()).fold(
                        base.clone(),
                        |sum, (multiplier, side)| {
                            std::array::from_fn(|c| {
                                if *side == sign { &sum[c] + &multiplier[c] } else { &sum[c] - &multiplier[c] }
                            })
                        },
                    );
                    let distance = if ties.len() <= ALL_SIGNS_LIMIT {
                        farthest_of_signs(&vertex, &ties)
                    } else {
                        farthest_vertex(&vertex, &ties)
                    };
                    farthest = farthest.max(distance);
                }
            }
        }
        let Some(moving) = (0..size).rev().find(|&i| subset[i] + size - i < multipliers.len()) else { break };
        subset[moving] += 1;
        for i in moving + 1..size {
            subset[i] = subset[i - 1] + 1;
        }
    }
    farthest
}

fn farthest_of_signs<const D: usize>(vertex: &[Dyadic; D], tied: &[[Dyadic; D]]) -> Dyadic {
    let squares = (0..1usize << tied.len()).map(|choice| {
        let mut corner = vertex.clone();
        for (i, multiplier) in tied.iter().enumerate() {
            let is_added = choice >> i & 1 == 0;
            corner =
                std::array::from_fn(
                    |c| if is_added { &corner[c] + &multiplier[c] } else { &corner[c] - &multiplier[c] },
                );
        }
        sum_of_products(&corner, &corner)
    });
    squares.fold(Dyadic::zero(), Dyadic::max)
}

/// Coordinates in which vectors keep their independence, as many as they span dimensions.
fn independent_coordinates<const D: usize>(vectors: &[[Dyadic; D]]) -> Vec<usize> {
    let mut rows: Vec<[Dyadic; D]> = vectors.to_vec();
    let mut axes = Vec::new();
    for axis in 0..D {
        let Some(at) = rows.iter().position(|row| !row[axis].is_zero()) else { continue };
        let pivot = rows.swap_remove(at);
        for row in &mut rows {
            let (head, own) = (pivot[axis].clone(), row[axis].clone());
            *row = std::array::from_fn(|c| &head * &row[c] - &own * &pivot[c]);
        }
        rows.retain(|row| row.iter().any(|c| !c.is_zero()));
        axes.push(axis);
    }
    axes
}

/// The vector of minors, orthogonal to all rows.
fn normal_of(rows: &[&[Dyadic]], dimension: usize) -> Vec<Dyadic> {
    let minor = |c: usize| {
        let others: Vec<usize> = (0..dimension).filter(|&other| other != c).collect();
        let value = determinant(rows, &others);
        if c.is_multiple_of(2) { value } else { Dyadic::zero() - value }
    };
    (0..dimension).map(minor).collect()
}

fn determinant(rows: &[&[Dyadic]], columns: &[usize]) -> Dyadic {
    let Some((row, rest)) = rows.split_first() else { return Dyadic::new(1.into(), 0) };
    columns.iter().enumerate().fold(Dyadic::zero(), |sum, (i, &column)| {
        let others: Vec<usize> = columns.iter().copied().filter(|&other| other != column).collect();
        let term = &row[column] * &determinant(rest, &others);
        if i % 2 == 0 { sum + term } else { sum - term }
    })
}

#[cfg(test)]
mod tests {
    use super::super::min_length_enclosing;
    use super::*;

    fn segment() -> ([[f64; 2]; 2], MinLengthZonotope<2>) {
        let points = [[0.0, 0.0], [3.0, 4.0]];
        let answer = min_length_enclosing(&points, 1e-9).expect("finite");
        (points, answer)
    }

    #[test]
    fn an_answer_passes_and_what_is_wrong_is_named() {
        let (points, answer) = segment();
        assert_eq!(verify(&points, &answer), Ok(()));
        let changed = |change: &dyn Fn(&mut MinLengthZonotope<2>)| {
            let mut answer = answer.clone();
            change(&mut answer);
            verify(&points, &answer)
        };
        assert_eq!(changed(&|a| a.length *= 0.999), Err(MinLengthDefect::Length));
        assert_eq!(changed(&|a| a.lower_bound *= 1.001), Err(MinLengthDefect::LowerBound));
        assert_eq!(changed(&|a| a.multipliers[0].vector[0] *= 2.0), Err(MinLengthDefect::Multipliers));
        assert_eq!(changed(&|a| a.multipliers[0].point = 2), Err(MinLengthDefect::Multipliers));
        assert_eq!(changed(&|a| a.ratio = 0.5), Err(MinLengthDefect::Ratio));
        assert_eq!(changed(&|a| a.ratio = f64::NAN), Err(MinLengthDefect::Ratio));
        assert_eq!(changed(&|a| a.lower_bound = f64::INFINITY), Err(MinLengthDefect::LowerBound));
        assert_eq!(changed(&|a| a.multipliers[0].vector[0] = f64::NAN), Err(MinLengthDefect::Multipliers));
        assert!(verify(&[points[0], [4.0, 3.0]], &answer).is_err());
    }

    #[test]
    fn where_no_bound_is_a_double_the_ratio_is_infinite() {
        // half the least positive double rounds down to none
        let points = [[0.0], [f64::from_bits(1)]];
        let answer = min_length_enclosing(&points, 1e-9).expect("finite");
        assert_eq!((answer.lower_bound, answer.ratio), (0.0, f64::INFINITY));
        assert_eq!(verify(&points, &answer), Ok(()));
    }

    #[test]
    fn the_farthest_vertex_by_hand() {
        let exact = |vector: [f64; 3]| vector.map(Dyadic::from_f64);
        let origin = exact([0.0; 3]);
        // ±(2, 0) ± (0, 1) ± (1, 1): the farthest is (3, 2)
        let multipliers = [[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]].map(exact);
        assert_eq!(farthest_vertex(&origin, &multipliers), Dyadic::from_f64(13.0));
        // in a plane of space, two of them parallel: ±(1, 1, 0) ± (2, 2, 0) ± (0, 1, 0)
        let multipliers = [[1.0, 1.0, 0.0], [2.0, 2.0, 0.0], [0.0, 1.0, 0.0]].map(exact);
        assert_eq!(farthest_vertex(&origin, &multipliers), Dyadic::from_f64(25.0));
        // from (0, 1, 0), two segments of a line: the farthest is (−3, 1, 0) or its mirror image
        assert_eq!(
            farthest_vertex(&exact([0.0, 1.0, 0.0]), &[[1.0, 0.0, 0.0], [2.0, 0.0, 0.0]].map(exact)),
            Dyadic::from_f64(10.0)
        );
    }

    #[test]
    fn many_forces_in_one_plane_are_no_more_than_their_signs() {
        // six multipliers in the plane z = 0, two in a line, and two across it
        let plane = [[1.0, 2.0], [3.0, -1.0], [2.0, 4.0], [-1.0, 1.0], [0.0, 3.0], [5.0, 1.0]];
        let multipliers: Vec<[Dyadic; 3]> = plane
            .iter()
            .map(|&[x, y]| [x, y, 0.0])
            .chain([[1.0, 1.0, 2.0], [0.0, -2.0, 1.0]])
            .map(|multiplier| multiplier.map(Dyadic::from_f64))
            .collect();
        let origin: [Dyadic; 3] = std::array::from_fn(|_| Dyadic::zero());
        assert_eq!(farthest_vertex(&origin, &multipliers), farthest_of_signs(&origin, &multipliers));
        assert_eq!(farthest_vertex(&origin, &multipliers[..6]), farthest_of_signs(&origin, &multipliers[..6]));
    }
}
