//! Checks an answer in exact arithmetic, with code that shares nothing with the search.
//!
//! The forces add up to zero, and lower bound · |w| ≤ Σ λ_j · p_j for every vertex w of Σ [−1, 1] λ_j. In coordinates in which the r-dimensional span of the forces is
//! all of space, each vertex lies on the side of some direction orthogonal to r − 1 independent forces; those orthogonal to it as well may have any signs.
//! So the vertices are enumerated by subsets, with exact normals and exact signs. Containment is decided for each point by a rational program.

use thiserror::Error;

use super::answer::MinLengthZonotope;
use crate::enclosing::fixed_directions::{FixedDirections, verify as directed};
use crate::numeric::dyadic::Dyadic;

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
    /// The forces name points that do not exist, or do not add up to zero.
    #[error("the forces prove nothing")]
    Forces,
    /// The lower bound is above what the forces prove.
    #[error("the lower bound is above what the forces prove")]
    LowerBound,
    /// The ratio is below that of the length to the lower bound.
    #[error("the ratio is below that of the two bounds")]
    Ratio,
    /// More forces lie in one hyperplane than can be tried with all signs.
    #[error("{0} forces in one hyperplane are too many to check")]
    TooManyTies(usize),
}

/// So many forces in one hyperplane are tried with all signs.
const MOST_TIES: usize = 16;

/// Checks everything about an answer: a rational program for each point, exact vertices of all forces. For small answers.
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

/// Checks length, lower bound and ratio, but not that the points are inside: O(m^D) exact operations for m forces.
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
    let mut forces: Vec<[Dyadic; D]> = Vec::with_capacity(answer.forces.len());
    for force in &answer.forces {
        let point = points.get(force.point).ok_or(MinLengthDefect::Forces)?;
        let vector = force.vector.map(exact);
        gain = gain + dot(&vector, &point.map(exact));
        sum = std::array::from_fn(|c| &sum[c] + &vector[c]);
        forces.push(vector);
    }
    if sum.iter().any(|c| !c.is_zero()) {
        return Err(MinLengthDefect::Forces);
    }
    let bound = exact(answer.lower_bound);
    let is_positive = bound.sign().is_gt();
    if bound.sign().is_lt() || is_positive && gain.sign().is_le() {
        return Err(MinLengthDefect::LowerBound);
    }
    let (bound, gain) = (&bound * &bound, &gain * &gain);
    if is_positive && farthest_vertex(&forces)?.is_none_or(|square| &bound * &square > gain) {
        return Err(MinLengthDefect::LowerBound);
    }
    let is_ratio = exact(answer.length) <= &exact(answer.ratio) * &exact(answer.lower_bound);
    if is_ratio && answer.ratio >= 1.0 || answer.length == 0.0 { Ok(()) } else { Err(MinLengthDefect::Ratio) }
}

fn dot(a: &[Dyadic], b: &[Dyadic]) -> Dyadic {
    a.iter().zip(b).fold(Dyadic::zero(), |sum, (x, y)| sum + x * y)
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

/// The squared distance of the farthest vertex of Σ [−1, 1] λ_j; `None` without a force that is not zero.
fn farthest_vertex<const D: usize>(forces: &[[Dyadic; D]]) -> Result<Option<Dyadic>, MinLengthDefect> {
    let forces: Vec<[Dyadic; D]> = forces.iter().filter(|f| f.iter().any(|c| !c.is_zero())).cloned().collect();
    let axes = independent_coordinates(&forces);
    let flat: Vec<Vec<Dyadic>> = forces.iter().map(|f| axes.iter().map(|&c| f[c].clone()).collect()).collect();
    let Some(size) = axes.len().checked_sub(1) else { return Ok(None) };
    let mut farthest: Option<Dyadic> = None;
    let mut subset: Vec<usize> = (0..size).collect();
    loop {
        let rows: Vec<&[Dyadic]> = subset.iter().map(|&j| &flat[j][..]).collect();
        let normal = normal_of(&rows, axes.len());
        if normal.iter().any(|c| !c.is_zero()) {
            let mut vertex: [Dyadic; D] = std::array::from_fn(|_| Dyadic::zero());
            let mut tied = Vec::new();
            for (force, flat) in forces.iter().zip(&flat) {
                match dot(flat, &normal).sign() {
                    std::cmp::Ordering::Greater => vertex = std::array::from_fn(|c| &vertex[c] + &force[c]),
                    std::cmp::Ordering::Less => vertex = std::array::from_fn(|c| &vertex[c] - &force[c]),
                    std::cmp::Ordering::Equal => tied.push(force),
                }
            }
            // A subset met again through others of its hyperplane is done once, by the first that span it.
            let is_first = tied.iter().zip(&subset).all(|(force, &j)| std::ptr::eq(*force, &forces[j]));
            if is_first || tied.len() > size {
                farthest = farthest.max(Some(farthest_of_signs(&vertex, &tied)?));
            }
        }
        let Some(moving) = (0..size).rev().find(|&i| subset[i] + size - i < forces.len()) else { break };
        subset[moving] += 1;
        for i in moving + 1..size {
            subset[i] = subset[i - 1] + 1;
        }
    }
    Ok(farthest)
}

fn farthest_of_signs<const D: usize>(vertex: &[Dyadic; D], tied: &[&[Dyadic; D]]) -> Result<Dyadic, MinLengthDefect> {
    if tied.len() > MOST_TIES {
        return Err(MinLengthDefect::TooManyTies(tied.len()));
    }
    let squares = (0..1usize << tied.len()).map(|choice| {
        let mut corner = vertex.clone();
        for (i, force) in tied.iter().enumerate() {
            let is_added = choice >> i & 1 == 0;
            corner = std::array::from_fn(|c| if is_added { &corner[c] + &force[c] } else { &corner[c] - &force[c] });
        }
        dot(&corner, &corner)
    });
    Ok(squares.fold(Dyadic::zero(), Dyadic::max))
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
        assert_eq!(changed(&|a| a.forces[0].vector[0] *= 2.0), Err(MinLengthDefect::Forces));
        assert_eq!(changed(&|a| a.forces[0].point = 2), Err(MinLengthDefect::Forces));
        assert_eq!(changed(&|a| a.ratio = 0.5), Err(MinLengthDefect::Ratio));
        assert!(verify(&[points[0], [4.0, 3.0]], &answer).is_err());
    }

    #[test]
    fn the_farthest_vertex_by_hand() {
        // ±(2, 0) ± (0, 1) ± (1, 1): the farthest is (3, 2)
        let forces = [[2.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|f: [f64; 2]| f.map(Dyadic::from_f64));
        assert_eq!(farthest_vertex(&forces), Ok(Some(Dyadic::from_f64(13.0))));
        // in a plane of space, two of them parallel: ±(1, 1, 0) ± (2, 2, 0) ± (0, 1, 0)
        let forces = [[1.0, 1.0, 0.0], [2.0, 2.0, 0.0], [0.0, 1.0, 0.0]].map(|f: [f64; 3]| f.map(Dyadic::from_f64));
        assert_eq!(farthest_vertex(&forces), Ok(Some(Dyadic::from_f64(25.0))));
    }
}
