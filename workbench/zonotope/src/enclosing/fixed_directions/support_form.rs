//! Smallest zonotope along given directions, by one linear program in k + d unknowns over all facet normals.
//!
//! # Source
//! Section 4.2, in the unknowns p and c alone: Σ c_i |u · v_i| + u · p ≥ max_j u · p_j for the normals u of all d − 1
//! directions, and for −u.
//!
//! # Method
//! 1. Enumerate the normals in coordinates of the span, and find the farthest point along each normal and its opposite.
//! 2. Solve one linear program with all rows by the engine: a guess.
//! 3. The rows that are nearly tight at the guess are where the method by row generation begins, whose answer is
//!    proven.
//!
//! # Complexity
//! n points, k directions: O(n k^{d−1}) for the rows, 2 C(k, d − 1) rows of k + d entries, then what the engine takes;
//! space O(k^d).
//!
//! # Numerics
//! The engine's answer is used only to choose rows; an engine that fails costs time, not correctness.
//!
//! # Example
//! ```
//! use zonotope::enclosing::fixed_directions::{FixedDirections, support_form};
//! use zonotope::linear_program::Clarabel;
//! let diamond = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];
//! let problem = FixedDirections::new(&diamond, &[[1.0, 1.0], [1.0, -1.0]], &[1.0, 1.0])?;
//! let answer = support_form::min_length_by_support_form(&problem, &Clarabel, &mut ())?;
//! // the diamond itself: both coefficients are a half
//! assert!((answer.optimal().expect("feasible").value - 1.0).abs() < 1e-12);
//! # Ok::<(), zonotope::enclosing::fixed_directions::FixedDirectionsError>(())
//! ```

use super::all_normals::facet_normals;
use super::answer::Enclosure;
use super::problem::{FixedDirections, FixedDirectionsError};
use super::solve::solve_with;
use crate::linear_program::{BoundedVariable, Engine, Guess, LinearProgram, Relation, Row};
use crate::numeric::linear::dot;
use crate::tally::{Operation, Tally};

/// A row whose two sides differ by less than this in scaled coordinates may be tight at the optimum.
const TIGHTNESS_TOLERANCE: f64 = 1e-6;

/// The smallest zonotope along the directions around the points, with the help of an engine.
///
/// The points that are read along all normals are counted, and the entries that the engine reads.
///
/// # Errors
/// When a coefficient of the answer exceeds the largest double.
#[inline(never)]
pub fn min_length_by_support_form<const D: usize>(
    problem: &FixedDirections<'_, D>,
    engine: &dyn Engine,
    tally: &mut dyn Tally,
) -> Result<Enclosure<D>, FixedDirectionsError> {
    solve_with(problem, tally, |scaled, generation, tally| {
        let (rank, count) = (scaled.rank, scaled.directions.len());
        let directions: Vec<[f64; D]> = scaled.directions.iter().map(|d| d.vector).collect();
        let half = facet_normals(rank, &directions);
        let normals: Vec<[f64; D]> = half.iter().flat_map(|u| [*u, u.map(|c| -c)]).collect();
        let center = (0..rank).map(|_| BoundedVariable::free(0.0));
        let variables =
            center.chain(scaled.directions.iter().map(|d| BoundedVariable::non_negative(d.weight))).collect();
        let mut program = LinearProgram::new(variables).expect("weights are finite");
        tally.add(Operation::ScanRead, scaled.points.len() as u64 * normals.len() as u64);
        for normal in &normals {
            let terms = (0..rank).map(|c| (c, normal[c]));
            let terms = terms.chain(directions.iter().enumerate().map(|(i, v)| (rank + i, dot(normal, v).abs())));
            let right = scaled.points.iter().map(|p| dot(normal, p)).fold(f64::NEG_INFINITY, f64::max);
            let row = Row { terms: terms.filter(|t| t.1 != 0.0).collect(), relation: Relation::AtLeast, right };
            program.add_row(row).expect("normals and heights are finite");
        }
        if let Guess::Optimal { primal, .. } = engine.solve_counted(&program, tally) {
            let mut slacks: Vec<(f64, usize)> = Vec::new();
            for (j, row) in program.rows().iter().enumerate() {
                let slack = row.terms.iter().map(|&(i, a)| a * primal[i]).sum::<f64>() - row.right;
                if slack < TIGHTNESS_TOLERANCE {
                    slacks.push((slack, j));
                }
            }
            slacks.sort_by(|a, b| a.0.total_cmp(&b.0));
            for (_, j) in slacks.into_iter().take(4 * (rank + count)) {
                generation.add_normal(normals[j], tally);
            }
        }
        Ok(normals.len())
    })
}
