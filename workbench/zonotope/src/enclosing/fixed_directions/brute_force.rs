//! Smallest zonotope along given directions, by a rational linear program over all facet normals: the truth.
//!
//! # Statement
//! Input: points of R^D, directions, weights ≥ 0. Output: the least Σ w_i c_i over all zonotopes { p + Σ δ_i c_i v_i : |δ_i| ≤ 1 } that contain the
//! points, with p and c ≥ 0 where it is taken, exactly; `None` when no zonotope along the directions contains them. Zero, parallel
//! and repeated directions are legal, and so are fewer than D of them.
//!
//! # Source
//! Section 4.2, in k + d unknowns: every facet normal of every zonotope along the directions is, up to sign, a normal of d − 1 of them, so
//! the points are inside just when Σ c_i |u · v_i| + u · p ≥ max_j u · p_j for all these u and −u.
//!
//! # Method
//! 1. The span of the directions in rationals; a point off the affine span proves that there is no zonotope.
//! 2. In coordinates of the span: the normals of all (d − 1)-subsets as vectors of minors, both signs.
//! 3. The dual program, maximise Σ y_u h(u) with Σ y_u |u · v_i| ≤ w_i, Σ y_u u = 0, by the simplex method with Bland's rule; its prices are c and p.
//!
//! # Complexity
//! n points, k directions spanning d dimensions: C(k, d − 1) normals, each O(n + k) rational operations; then the pivots, O(k · C(k, d − 1)) each. For k up to about 8.
//!
//! # Shapes
//! `points`: n × D; `directions`: k × D; `coefficients`: half-lengths in units of their directions.
//!
//! # Numerics
//! Everything is exact rational arithmetic.
//!
//! # Errors
//! None: the problem is valid by construction.
//!
//! # Panics
//! Never.
//!
//! # Checked by
//! Hand-worked examples; the paper's own program, solved in rationals as well.
//!
//! # Example
//! ```
//! use zonotope::enclosing::fixed_directions::{FixedDirections, brute_force::least_length};
//! let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
//! let axes = [[1.0, 0.0], [0.0, 1.0]];
//! let problem = FixedDirections::new(&points, &axes, &[1.0, 1.0])?;
//! assert_eq!(least_length(&problem).expect("the axes span the plane").value, 1.into());
//! # Ok::<(), zonotope::enclosing::fixed_directions::FixedDirectionsError>(())
//! ```

use super::problem::FixedDirections;
use super::rational::simplex::{Column, maximize};
use super::span::{Span, rational};
use crate::numeric::Rational;

/// An optimum in rationals.
#[derive(Debug, Clone, PartialEq)]
pub struct ExactOptimum<const D: usize> {
    /// The least Σ w_i c_i.
    pub value: Rational,
    /// The centre p.
    pub center: [Rational; D],
    /// The coefficients c_i, none negative.
    pub coefficients: Vec<Rational>,
    /// What proves that nothing is smaller: points j with vectors λ_j, Σ λ_j = 0, Σ_j |λ_j · v_i| ≤ w_i for every direction, Σ λ_j · p_j the value.
    pub forces: Vec<(usize, [Rational; D])>,
}

/// The least Σ w_i c_i and where it is taken; `None` when no zonotope along the directions contains the points.
pub fn least_length<const D: usize>(problem: &FixedDirections<'_, D>) -> Option<ExactOptimum<D>> {
    let span = Span::of(problem.directions());
    if span.first_departure(problem.points()).is_some() {
        return None;
    }
    let inside = |vectors: &[[f64; D]]| -> Vec<Vec<Rational>> {
        vectors.iter().map(|v| span.pivots().iter().map(|&c| rational(v[c])).collect()).collect()
    };
    let (points, directions) = (inside(problem.points()), inside(problem.directions()));
    let weights: Vec<Rational> = problem.weights().iter().map(|&w| rational(w)).collect();
    let half = normals(&directions, span.dimension());
    let both: Vec<Vec<Rational>> = half.into_iter().flat_map(|u| [u.iter().map(|c| -c.clone()).collect(), u]).collect();
    let mut farthest = Vec::with_capacity(both.len());
    let columns: Vec<Column> = both
        .iter()
        .map(|u| {
            let heights: Vec<Rational> = points.iter().map(|p| product(u, p)).collect();
            let far = (0..points.len()).max_by_key(|&j| &heights[j]).expect("there is a point");
            farthest.push(far);
            Column {
                inequalities: directions.iter().map(|v| absolute(product(u, v))).collect(),
                equalities: u.clone(),
                gain: heights[far].clone(),
            }
        })
        .collect();
    let optimum =
        maximize(&columns, &weights, span.dimension()).expect("a zonotope along the directions holds the points");
    let first = problem.points()[0].map(rational);
    let shift: Vec<Rational> = optimum.equality_prices.iter().zip(&points[0]).map(|(p, first)| p - first).collect();
    let lifted = span.lift(&shift);
    let center = std::array::from_fn(|c| &first[c] + &lifted[c]);
    let forces = farthest.into_iter().zip(both.iter().zip(&optimum.solution)).filter(|(_, (_, y))| !y.is_zero());
    let forces = forces
        .map(|(point, (u, y))| {
            let mut force: [Rational; D] = std::array::from_fn(|_| Rational::ZERO);
            for (component, &coordinate) in u.iter().zip(span.pivots()) {
                force[coordinate] = y * component;
            }
            (point, force)
        })
        .collect();
    Some(ExactOptimum { value: optimum.value, center, coefficients: optimum.inequality_prices, forces })
}

/// A normal of each (dimension − 1)-subset of the directions that has one, up to sign.
fn normals(directions: &[Vec<Rational>], dimension: usize) -> Vec<Vec<Rational>> {
    let Some(size) = dimension.checked_sub(1) else { return Vec::new() };
    let mut found = Vec::new();
    let mut subset: Vec<usize> = (0..size).collect();
    while subset.last().is_none_or(|&last| last < directions.len()) {
        let rows: Vec<&[Rational]> = subset.iter().map(|&i| &directions[i][..]).collect();
        let normal: Vec<Rational> = (0..dimension)
            .map(|c| {
                let others: Vec<usize> = (0..dimension).filter(|&other| other != c).collect();
                let minor = determinant(&rows, &others);
                if c % 2 == 0 { minor } else { -minor }
            })
            .collect();
        if normal.iter().any(|c| !c.is_zero()) {
            found.push(normal);
        }
        let Some(moving) = (0..size).rev().find(|&i| subset[i] + size - i < directions.len()) else { break };
        subset[moving] += 1;
        for i in moving + 1..size {
            subset[i] = subset[i - 1] + 1;
        }
    }
    found
}

/// The determinant of the given columns of some rows, along the first row.
fn determinant(rows: &[&[Rational]], columns: &[usize]) -> Rational {
    let Some((row, rest)) = rows.split_first() else { return Rational::ONE };
    columns.iter().enumerate().fold(Rational::ZERO, |sum, (i, &column)| {
        if row[column].is_zero() {
            return sum;
        }
        let others: Vec<usize> = columns.iter().copied().filter(|&other| other != column).collect();
        let term = &row[column] * determinant(rest, &others);
        if i % 2 == 0 { sum + term } else { sum - term }
    })
}

fn product(a: &[Rational], b: &[Rational]) -> Rational {
    a.iter().zip(b).fold(Rational::ZERO, |sum, (x, y)| sum + x * y)
}

fn absolute(value: Rational) -> Rational {
    if value < Rational::ZERO { -value } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn solve<const D: usize>(points: &[[f64; D]], directions: &[[f64; D]]) -> Option<ExactOptimum<D>> {
        least_length(&FixedDirections::new(points, directions, &vec![1.0; directions.len()]).expect("valid"))
    }

    /// Section 4.2 as printed, through its dual: unknowns λ_j and the positive and negative parts of λ_j · v_i, with
    /// Σ_j |λ_j · v_i| ≤ w_i and Σ λ_j = 0; `None` when its gain has no bound.
    fn paper<const D: usize>(points: &[[f64; D]], directions: &[[f64; D]], weights: &[f64]) -> Option<Rational> {
        let (n, k) = (points.len(), directions.len());
        let part = |i: usize, j: usize| D + j * k + i;
        let blank = || Column {
            inequalities: vec![Rational::ZERO; k],
            equalities: vec![Rational::ZERO; D + n * k],
            gain: Rational::ZERO,
        };
        let mut columns = Vec::new();
        for (j, point) in points.iter().enumerate() {
            for (c, &coordinate) in point.iter().enumerate() {
                for sign in [Rational::ONE, -Rational::ONE] {
                    let mut column = blank();
                    column.gain = &sign * rational(coordinate);
                    column.equalities[c] = sign.clone();
                    for (i, v) in directions.iter().enumerate() {
                        column.equalities[part(i, j)] = &sign * rational(v[c]);
                    }
                    columns.push(column);
                }
            }
            for i in 0..k {
                for sign in [Rational::ONE, -Rational::ONE] {
                    let mut column = blank();
                    column.inequalities[i] = Rational::ONE;
                    column.equalities[part(i, j)] = sign;
                    columns.push(column);
                }
            }
        }
        let weights: Vec<Rational> = weights.iter().map(|&w| rational(w)).collect();
        maximize(&columns, &weights, D + n * k).map(|optimum| optimum.value)
    }

    #[test]
    fn the_unit_square_along_one_axis_too_few_is_infeasible() {
        assert!(solve(&[[0.0, 0.0], [1.0, 1.0]], &[[1.0, 0.0]]).is_none());
        assert!(solve::<2>(&[[0.0, 0.0], [1.0, 1.0]], &[]).is_none());
        assert_eq!(solve::<2>(&[[3.0, 4.0]; 2], &[]).expect("one point").center, [3, 4].map(Rational::from));
    }

    /// The case of the errata: two extreme points along the only normal of R^3 would give a half.
    #[test]
    fn directions_of_a_plane_are_taken_in_the_plane() {
        let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let optimum = solve(&square, &axes).expect("the square lies in the plane");
        assert_eq!(optimum.value, Rational::ONE);
        assert_eq!(
            optimum.center,
            [Rational::ONE / Rational::from(2), Rational::ONE / Rational::from(2), Rational::ZERO]
        );
        assert!(solve(&[square[0], [0.0, 0.0, 1e-300]], &axes).is_none());
    }

    #[test]
    fn a_simplex_of_four_dimensions_in_its_box() {
        let mut points = vec![[0.0; 4]];
        let axes: Vec<[f64; 4]> = (0..4).map(|i| std::array::from_fn(|c| f64::from(u8::from(i == c)))).collect();
        points.extend(&axes);
        assert_eq!(solve(&points, &axes).expect("a box").value, Rational::from(2));
        let mut diagonals = axes.clone();
        diagonals.push([1.0; 4]);
        assert_eq!(solve(&points, &diagonals).expect("spanning").value, Rational::from(2));
    }

    fn lattice<const D: usize>(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[f64; D]>> {
        proptest::collection::vec(proptest::array::uniform((-2i8..3).prop_map(f64::from)), count)
    }

    fn agrees<const D: usize>(
        points: &[[f64; D]],
        directions: &[[f64; D]],
        weights: &[f64],
    ) -> Result<(), TestCaseError> {
        let weights = &weights[..directions.len()];
        let problem = FixedDirections::new(points, directions, weights).expect("valid");
        let truth = least_length(&problem);
        prop_assert_eq!(truth.as_ref().map(|t| t.value.clone()), paper(points, directions, weights));
        let Some(truth) = truth else { return Ok(()) };
        for (v, &w) in directions.iter().zip(weights) {
            let v = v.map(rational);
            let along = truth.forces.iter().map(|(_, force)| absolute(product(force, &v)));
            prop_assert!(along.fold(Rational::ZERO, |sum, x| sum + x) <= rational(w));
        }
        let reached = truth.forces.iter().map(|(j, force)| product(force, &points[*j].map(rational)));
        prop_assert_eq!(reached.fold(Rational::ZERO, |sum, x| sum + x), truth.value);
        Ok(())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(60))]

        #[test]
        fn the_plane_agrees_with_the_papers_program(
            points in lattice::<2>(1..4), directions in lattice::<2>(0..4), weights in [0u8..3, 0..3, 0..3],
        ) {
            agrees(&points, &directions, &weights.map(f64::from))?;
        }

        #[test]
        fn space_agrees_with_the_papers_program(points in lattice::<3>(1..4), directions in lattice::<3>(1..5)) {
            agrees(&points, &directions, &[1.0, 2.0, 1.0, 3.0])?;
        }

        #[test]
        fn the_line_agrees_with_the_papers_program(points in lattice::<1>(1..5), directions in lattice::<1>(0..4)) {
            agrees(&points, &directions, &[1.0, 2.0, 1.0])?;
        }
    }
}
