//! Smallest zonotope along given directions, by the criss-cross method on all facet normals in rationals: the truth.
//!
//! # Statement
//! Input: points of R^D, directions, weights ≥ 0. Output: the least Σ w_i c_i over all zonotopes { p + Σ δ_i c_i v_i
//! : |δ_i| ≤ 1 } that contain the points, with a centre p, coefficients c ≥ 0 and multipliers that attain it, all
//! exact; `None` when no zonotope along the directions contains the points. Zero, parallel and repeated directions are
//! legal, and so are fewer than D of them.
//!
//! # Source
//! Section 4.2 for the problem. The linear program is the support form: a zonotope along the directions contains the
//! points just when Σ c_i |u · v_i| + u · p ≥ max_j u · p_j for every facet normal u, that is, for a normal of each
//! d − 1 independent directions, both ways. The criss-cross method is that of Terlaky (1985) with the least-index rule.
//!
//! # Method
//! 1. The span of the directions; a point off the affine span through the first point proves that there is no zonotope.
//! 2. In coordinates of the span, a normal of every (d − 1)-subset of the directions, both ways.
//! 3. A dictionary that expresses the slack of every normal by p and c. Each coordinate of p, which has no sign to
//!    keep, is exchanged for a slack and then stays expressed for good.
//! 4. Until the dictionary is feasible and optimal, the variable of least index that violates either is exchanged: a
//!    negative basic variable for the first one that can raise it, or a nonbasic one with negative cost for the first
//!    one that it lowers.
//!
//! # Complexity
//! n points, k directions spanning d dimensions: m = 2 C(k, d − 1) normals, each O(n + k) rational operations; then
//! exchanges of O(m (k + d)) each, whose number has no polynomial bound. For k up to about 8.
//!
//! # Shapes
//! `points`: n × D; `directions`: k × D; `coefficients`: half-lengths in units of their directions.
//!
//! # Numerics
//! Everything is exact rational arithmetic. No code is shared with [`rational`](super::rational), the method that the
//! others fall back on: that one solves the dual program by the simplex method.
//!
//! # Errors
//! None: the problem is valid by construction.
//!
//! # Panics
//! Never.
//!
//! # Checked by
//! Weak duality: primal and dual solution are feasible and have the same value; hand-worked examples; the paper's own
//! program, in which no normal occurs.
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

use super::answer::ExactOptimum;
use super::problem::FixedDirections;
use crate::numeric::Rational;
use crate::numeric::dyadic::Dyadic;

/// The least Σ w_i c_i and where it is taken; `None` when no zonotope along the directions contains the points.
pub fn least_length<const D: usize>(problem: &FixedDirections<'_, D>) -> Option<ExactOptimum<D>> {
    let exact = |v: &[f64; D]| -> Vec<Rational> { v.iter().map(|&c| Dyadic::from_f64(c).to_rational()).collect() };
    let first = exact(&problem.points()[0]);
    let relative = |p: &[f64; D]| -> Vec<Rational> { exact(p).iter().zip(&first).map(|(a, b)| a - b).collect() };
    let points: Vec<Vec<Rational>> = problem.points().iter().map(relative).collect();
    let directions: Vec<Vec<Rational>> = problem.directions().iter().map(exact).collect();
    let span = Echelon::of(directions.iter().cloned());
    if points.iter().any(|p| span.member(&span.coordinates(p), D) != *p) {
        return None;
    }
    let inside =
        |vectors: Vec<Vec<Rational>>| -> Vec<Vec<Rational>> { vectors.iter().map(|v| span.coordinates(v)).collect() };
    let (points, directions) = (inside(points), inside(directions));
    let rank = span.rows.len();
    let constraints = constraints(&points, &directions, rank);
    let weights = exact_weights(problem.weights());
    let optimum = Dictionary::new(&constraints, weights, rank).solve();
    let lifted = span.member(&optimum.center, D);
    let center = std::array::from_fn(|c| &first[c] + &lifted[c]);
    let used = constraints.iter().zip(optimum.multipliers).filter(|(_, y)| !y.is_zero());
    let multipliers = used.map(|(constraint, y)| {
        let mut vector: [Rational; D] = std::array::from_fn(|_| Rational::ZERO);
        for (component, (coordinate, _)) in constraint.normal.iter().zip(&span.rows) {
            vector[*coordinate] = &y * component;
        }
        (constraint.point, vector)
    });
    let (value, multipliers) = (optimum.value, multipliers.collect());
    Some(ExactOptimum { value, center, coefficients: optimum.coefficients, multipliers })
}

fn exact_weights(weights: &[f64]) -> Vec<Rational> {
    weights.iter().map(|&w| Dyadic::from_f64(w).to_rational()).collect()
}

/// The span of vectors in reduced echelon form: each row is 1 in its pivot coordinate and 0 in those of the others.
struct Echelon {
    rows: Vec<(usize, Vec<Rational>)>,
}

impl Echelon {
    fn of(vectors: impl Iterator<Item = Vec<Rational>>) -> Self {
        let mut rows: Vec<(usize, Vec<Rational>)> = Vec::new();
        for vector in vectors {
            let reduced = rows.iter().fold(vector, |rest, (pivot, row)| cleared(rest, *pivot, row));
            let Some(pivot) = reduced.iter().position(|c| !c.is_zero()) else { continue };
            let new: Vec<Rational> = reduced.iter().map(|c| c / &reduced[pivot]).collect();
            for (_, row) in &mut rows {
                *row = cleared(std::mem::take(row), pivot, &new);
            }
            rows.push((pivot, new));
        }
        Self { rows }
    }

    /// The coordinates of a vector of the span.
    fn coordinates(&self, vector: &[Rational]) -> Vec<Rational> {
        self.rows.iter().map(|(pivot, _)| vector[*pivot].clone()).collect()
    }

    /// The vector of the span with given coordinates.
    fn member(&self, coordinates: &[Rational], dimension: usize) -> Vec<Rational> {
        let coordinate = |c: usize| product(coordinates.iter().zip(self.rows.iter().map(|(_, row)| &row[c])));
        (0..dimension).map(coordinate).collect()
    }

    /// A vector orthogonal to the span, if that is a hyperplane.
    fn normal(&self, dimension: usize) -> Option<Vec<Rational>> {
        let is_pivot = |c: usize| self.rows.iter().any(|(pivot, _)| *pivot == c);
        let free = (0..dimension).find(|&c| !is_pivot(c)).filter(|_| self.rows.len() + 1 == dimension)?;
        let mut normal = vec![Rational::ZERO; dimension];
        normal[free] = Rational::ONE;
        for (pivot, row) in &self.rows {
            normal[*pivot] = -row[free].clone();
        }
        Some(normal)
    }
}

/// A vector less the multiple of a row that makes its coordinate at the pivot zero.
fn cleared(vector: Vec<Rational>, pivot: usize, row: &[Rational]) -> Vec<Rational> {
    let factor = vector[pivot].clone();
    vector.iter().zip(row).map(|(v, r)| v - &factor * r).collect()
}

/// The sum of the products of pairs.
fn product<'a>(pairs: impl Iterator<Item = (&'a Rational, &'a Rational)>) -> Rational {
    pairs.fold(Rational::ZERO, |sum, (a, b)| sum + a * b)
}

/// One constraint of the support form: Σ widths_i c_i + normal · p ≥ height.
struct Constraint {
    normal: Vec<Rational>,
    /// |u · v_i| for each direction.
    widths: Vec<Rational>,
    /// How far the points reach along the normal, and the point that reaches there.
    height: Rational,
    point: usize,
}

/// The constraints of all normals, each followed by that of the opposite normal.
fn constraints(points: &[Vec<Rational>], directions: &[Vec<Rational>], rank: usize) -> Vec<Constraint> {
    let Some(size) = rank.checked_sub(1) else { return Vec::new() };
    let mut found = Vec::new();
    for_each_subset(directions, size, &mut Vec::new(), &mut |subset| {
        let Some(normal) = Echelon::of(subset.iter().map(|v| v.to_vec())).normal(rank) else { return };
        let opposite = normal.iter().map(|c| -c.clone()).collect();
        for normal in [normal, opposite] {
            let widths = directions.iter().map(|v| magnitude(product(normal.iter().zip(v)))).collect();
            let heights = points.iter().map(|p| product(normal.iter().zip(p))).enumerate();
            let (point, height) = heights.max_by(|a, b| a.1.cmp(&b.1)).expect("a problem has a point");
            found.push(Constraint { normal, widths, height, point });
        }
    });
    found
}

/// Visits the subsets of a size, each in the order of its members.
fn for_each_subset<'a>(
    rest: &'a [Vec<Rational>],
    size: usize,
    chosen: &mut Vec<&'a [Rational]>,
    visit: &mut impl FnMut(&[&[Rational]]),
) {
    if size == 0 {
        return visit(chosen);
    }
    for (i, first) in rest.iter().enumerate() {
        chosen.push(first);
        for_each_subset(&rest[i + 1..], size - 1, chosen, visit);
        chosen.pop();
    }
}

fn magnitude(value: Rational) -> Rational {
    if value < Rational::ZERO { -value } else { value }
}

/// Σ w_i c_i and the basic variables as affine functions of the nonbasic ones.
///
/// The variables are the coordinates of p, which are free, then c, then the slack of each constraint; all but the first
/// are ≥ 0.
struct Dictionary {
    rank: usize,
    /// The index of the variable that each row expresses, and of the one that each column but the first stands for.
    basic: Vec<usize>,
    nonbasic: Vec<usize>,
    /// The constant of each row, then its coefficients; the last row is the objective.
    rows: Vec<Vec<Rational>>,
}

/// What the dictionary says at the optimum.
struct Solution {
    value: Rational,
    center: Vec<Rational>,
    coefficients: Vec<Rational>,
    /// The cost of each constraint's slack: its multiplier in the dual program.
    multipliers: Vec<Rational>,
}

impl Dictionary {
    fn new(constraints: &[Constraint], weights: Vec<Rational>, rank: usize) -> Self {
        let count = rank + weights.len();
        let row = |c: &Constraint| {
            let constant = std::iter::once(-c.height.clone());
            constant.chain(c.normal.iter().cloned()).chain(c.widths.iter().cloned()).collect()
        };
        let mut rows: Vec<Vec<Rational>> = constraints.iter().map(row).collect();
        rows.push(std::iter::repeat_n(Rational::ZERO, rank + 1).chain(weights).collect());
        let basic = (0..constraints.len()).map(|i| count + i).collect();
        Self { rank, basic, nonbasic: (0..count).collect(), rows }
    }

    fn solve(self) -> Solution {
        self.try_solve().expect("a zonotope along directions that span contains the points")
    }

    /// The optimum; `None` when nothing is feasible. The value must be bounded below, and the constraints must
    /// determine the free variables.
    fn try_solve(mut self) -> Option<Solution> {
        for free in 0..self.rank {
            let is_slack = |row: &usize| self.basic[*row] >= self.rank && !self.rows[*row][free + 1].is_zero();
            let row = (0..self.basic.len()).find(is_slack).expect("the normals of directions that span do span");
            self.exchange(row, free + 1);
        }
        while let Some((row, column)) = self.violation() {
            self.exchange(row, column?);
        }
        Some(self.solution())
    }

    /// The row and the column of the exchange that the violation of least index asks for; no column when nothing is
    /// feasible.
    fn violation(&self) -> Option<(usize, Option<usize>)> {
        let objective = self.rows.len() - 1;
        let negative = |row: &usize| self.basic[*row] >= self.rank && self.rows[*row][0] < Rational::ZERO;
        let row = (0..objective).filter(negative).min_by_key(|&row| self.basic[row]);
        let cheaper = |column: &usize| self.rows[objective][*column] < Rational::ZERO;
        let column = (1..=self.nonbasic.len()).filter(cheaper).min_by_key(|&column| self.nonbasic[column - 1]);
        let is_primal = match (row, column) {
            (None, None) => return None,
            (Some(row), Some(column)) => self.basic[row] < self.nonbasic[column - 1],
            (row, _) => row.is_some(),
        };
        if let Some(row) = row.filter(|_| is_primal) {
            let raises = |column: &usize| self.rows[row][*column] > Rational::ZERO;
            let entering = (1..=self.nonbasic.len()).filter(raises).min_by_key(|&column| self.nonbasic[column - 1]);
            return Some((row, entering));
        }
        let column = column?;
        let falls = |row: &usize| self.basic[*row] >= self.rank && self.rows[*row][column] < Rational::ZERO;
        let leaving = (0..objective).filter(falls).min_by_key(|&row| self.basic[row]);
        Some((leaving.expect("no weight is negative, so the value is bounded below"), Some(column)))
    }

    /// Expresses the variable of a column by that of a row, and all others by it.
    fn exchange(&mut self, row: usize, column: usize) {
        let mut solved = std::mem::take(&mut self.rows[row]);
        let pivot = std::mem::replace(&mut solved[column], -Rational::ONE);
        solved.iter_mut().for_each(|entry| *entry /= -pivot.clone());
        for other in self.rows.iter_mut().filter(|other| !other.is_empty()) {
            let factor = std::mem::replace(&mut other[column], Rational::ZERO);
            if !factor.is_zero() {
                other.iter_mut().zip(&solved).for_each(|(entry, s)| *entry += &factor * s);
            }
        }
        self.rows[row] = solved;
        std::mem::swap(&mut self.basic[row], &mut self.nonbasic[column - 1]);
    }

    fn solution(mut self) -> Solution {
        let objective = self.rows.pop().expect("the objective is the last row");
        let count = self.nonbasic.len();
        let mut values = vec![Rational::ZERO; count];
        for (&variable, row) in self.basic.iter().zip(&self.rows).filter(|(variable, _)| **variable < count) {
            values[variable] = row[0].clone();
        }
        let mut multipliers = vec![Rational::ZERO; self.rows.len()];
        for (&variable, cost) in self.nonbasic.iter().zip(&objective[1..]).filter(|(variable, _)| **variable >= count) {
            multipliers[variable - count] = cost.clone();
        }
        let coefficients = values.split_off(self.rank);
        Solution { value: objective[0].clone(), center: values, coefficients, multipliers }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn solve<const D: usize>(points: &[[f64; D]], directions: &[[f64; D]]) -> Option<ExactOptimum<D>> {
        least_length(&FixedDirections::new(points, directions, &vec![1.0; directions.len()]).expect("valid"))
    }

    /// Section 4.2 as printed: minimise Σ w_i c_i with p_j = p + Σ b_ij v_i and |b_ij| ≤ c_i. No normal occurs in it.
    /// The unknowns c_i − b_ij and c_i + b_ij are slacks, and the equations are pairs of opposite inequalities; `None`
    /// when nothing is feasible.
    fn paper<const D: usize>(points: &[[f64; D]], directions: &[[f64; D]], weights: &[f64]) -> Option<Rational> {
        let (n, k) = (points.len(), directions.len());
        let rational = |v: f64| Dyadic::from_f64(v).to_rational();
        // The free unknowns p and b come first: each is expressed by a slack and then stays expressed.
        let free = D + n * k;
        let mut constraints = Vec::new();
        let mut add = |normal: Vec<Rational>, widths: Vec<Rational>, height: Rational| {
            constraints.push(Constraint { normal, widths, height, point: 0 });
        };
        for j in 0..n {
            for i in 0..k {
                for sign in [Rational::ONE, -Rational::ONE] {
                    let mut normal = vec![Rational::ZERO; free];
                    normal[D + j * k + i] = sign;
                    let widths = (0..k).map(|other| Rational::from(u8::from(other == i))).collect();
                    add(normal, widths, Rational::ZERO);
                }
            }
            for c in 0..D {
                for sign in [Rational::ONE, -Rational::ONE] {
                    let mut normal = vec![Rational::ZERO; free];
                    normal[c] = sign.clone();
                    for (i, v) in directions.iter().enumerate() {
                        normal[D + j * k + i] = &sign * rational(v[c]);
                    }
                    add(normal, vec![Rational::ZERO; k], &sign * rational(points[j][c]));
                }
            }
        }
        Dictionary::new(&constraints, exact_weights(weights), free).try_solve().map(|solution| solution.value)
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
        let rational = |v: f64| Dyadic::from_f64(v).to_rational();
        let spent = weights.iter().zip(&truth.coefficients).map(|(&w, c)| rational(w) * c);
        prop_assert_eq!(spent.fold(Rational::ZERO, |sum, x| sum + x), truth.value.clone());
        prop_assert!(truth.coefficients.iter().all(|c| *c >= Rational::ZERO));
        for (v, &w) in directions.iter().zip(weights) {
            let v = v.map(rational);
            let along = truth.multipliers.iter().map(|(_, multiplier)| magnitude(product(multiplier.iter().zip(&v))));
            prop_assert!(along.fold(Rational::ZERO, |sum, x| sum + x) <= rational(w));
        }
        for c in 0..D {
            let sum = truth.multipliers.iter().fold(Rational::ZERO, |sum, (_, multiplier)| sum + &multiplier[c]);
            prop_assert!(sum.is_zero());
        }
        let reached = truth.multipliers.iter().map(|(j, multiplier)| {
            let point = points[*j].map(rational);
            product(multiplier.iter().zip(&point))
        });
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
