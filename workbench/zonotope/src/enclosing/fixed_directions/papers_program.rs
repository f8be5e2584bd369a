//! Smallest zonotope along given directions, by the linear program of Section 4.2 as it is printed.
//!
//! # Source
//! Section 4.2, Theorem 4.6: minimise Σ c_i subject to p_j = p + Σ b_ij v_i and −c_i ≤ b_ij ≤ c_i for the points that
//! are extreme along a facet normal. There are two departures. The directions have weights w_i. And the extreme points
//! are found in coordinates of the directions' span: if the span is not the whole space, the normals of the space find
//! too few of them.
//!
//! # Method
//! 1. Find the extreme points by the scan over all facet normals.
//! 2. Solve the program in the unknowns p, c and b by the engine: a guess.
//! 3. The facets that the extreme points nearly touch at the guess are where the method by row generation begins, whose
//!    answer is proven.
//!
//! # Complexity
//! n points, k directions: O(n k^{d−1}) for n' = O(k^{d−1}) extreme points, then a program of k n' + k + d unknowns;
//! the paper's bound is O(k^{O(d)}).
//!
//! # Numerics
//! The engine's answer is used only to choose normals; an engine that fails costs time, not correctness.
//!
//! # Example
//! ```
//! use zonotope::enclosing::fixed_directions::{FixedDirections, papers_program};
//! use zonotope::linear_program::Clarabel;
//! let triangle = [[0.0, 0.0], [2.0, 0.0], [0.0, 4.0]];
//! let problem = FixedDirections::new(&triangle, &[[1.0, 0.0], [0.0, 1.0]], &[1.0, 1.0])?;
//! let answer = papers_program::min_length_by_papers_program(&problem, &Clarabel, &mut ())?;
//! // half the width and half the height
//! assert!((answer.optimal().expect("feasible").value - 3.0).abs() < 1e-12);
//! # Ok::<(), zonotope::enclosing::fixed_directions::FixedDirectionsError>(())
//! ```

use super::all_normals::extreme_points;
use super::answer::Enclosure;
use super::departure::first_departure;
use super::problem::{FixedDirections, FixedDirectionsError};
use super::scaled::Scaled;
use super::solve::solve_with;
use crate::linear_program::{BoundedVariable, Engine, Guess, LinearProgram, Relation, Row};
use crate::numeric::exact_linear::Span;
use crate::tally::Tally;
use crate::zonotope::ray_exit::FacetDescent;

/// A point whose ray leaves the zonotope at a smaller multiple of it than this may lie on its boundary at the optimum.
const LARGEST_TOUCHING_REACH: f64 = 1.0 + 1e-6;

/// The extreme points that the program has constraints for, in increasing order: the farthest points along all C(k, d
/// − 1) facet normals, both ways. Empty if the directions do not span the differences of the points.
pub fn extreme_points_of<const D: usize>(problem: &FixedDirections<'_, D>) -> Vec<usize> {
    let span = Span::of_doubles(problem.directions());
    if first_departure(&span, problem.points()).is_some() || span.rank() == 0 {
        return Vec::new();
    }
    let scaled = Scaled::new(problem, &span);
    let directions: Vec<[f64; D]> = scaled.directions.iter().map(|d| d.vector).collect();
    extreme_points(scaled.rank, &scaled.points, &directions, &mut ())
}

/// The smallest zonotope along the directions around the points, with the help of an engine.
///
/// The points that the scan reads are counted, and the entries that the engine does.
///
/// # Errors
/// When a coefficient of the answer exceeds the largest double.
#[inline(never)]
pub fn min_length_by_papers_program<const D: usize>(
    problem: &FixedDirections<'_, D>,
    engine: &dyn Engine,
    tally: &mut dyn Tally,
) -> Result<Enclosure<D>, FixedDirectionsError> {
    solve_with(problem, tally, |scaled, generation, tally| {
        let (rank, count) = (scaled.rank, scaled.directions.len());
        let directions: Vec<[f64; D]> = scaled.directions.iter().map(|d| d.vector).collect();
        let extreme = extreme_points(rank, &scaled.points, &directions, tally);
        let center = (0..rank).map(|_| BoundedVariable::free(0.0));
        let lengths = scaled.directions.iter().map(|d| BoundedVariable::non_negative(d.weight));
        let shares = (0..extreme.len() * count).map(|_| BoundedVariable::free(0.0));
        let mut program =
            LinearProgram::new(center.chain(lengths).chain(shares).collect()).expect("weights are finite");
        let length = |i: usize| rank + i;
        let share = |i: usize, j: usize| rank + count + j * count + i;
        let mut add = |terms: Vec<(usize, f64)>, relation, right| {
            let terms = terms.into_iter().filter(|t| t.1 != 0.0).collect();
            program.add_row(Row { terms, relation, right }).expect("coordinates are finite");
        };
        for (j, &point) in extreme.iter().enumerate() {
            for c in 0..rank {
                let sum = directions.iter().enumerate().map(|(i, v)| (share(i, j), v[c]));
                add([(c, 1.0)].into_iter().chain(sum).collect(), Relation::Equal, scaled.points[point][c]);
            }
            for i in 0..count {
                add(vec![(share(i, j), 1.0), (length(i), -1.0)], Relation::AtMost, 0.0);
                add(vec![(share(i, j), -1.0), (length(i), -1.0)], Relation::AtMost, 0.0);
            }
        }
        let rows = program.rows().len();
        if let Guess::Optimal { primal, .. } = engine.solve_counted(&program, tally) {
            let longest = (0..count).map(|i| primal[length(i)]).fold(f64::MIN_POSITIVE, f64::max);
            let generators: Vec<[f64; D]> = directions
                .iter()
                .enumerate()
                .map(|(i, v)| v.map(|v| v * primal[length(i)].max(1e-9 * longest)))
                .collect();
            let mut descent = FacetDescent::new(rank, &generators);
            for &j in &extreme {
                let ray = std::array::from_fn(|c| if c < rank { scaled.points[j][c] - primal[c] } else { 0.0 });
                if let Some(facet) = descent.facet(&ray).filter(|facet| facet.reach < LARGEST_TOUCHING_REACH) {
                    generation.add_normal(facet.normal, tally);
                }
            }
        }
        Ok(rows)
    })
}
