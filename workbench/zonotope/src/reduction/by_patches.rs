//! Order reduction, by patches of directions: the generators of a patch are projected on its direction and added up, a
//! box takes the rest.
//!
//! # Statement
//! Input: a zonotope A in R^D and ε in (0, 1), or a count k ≥ D. Output: a zonotope B with the same centre that
//! contains A exactly, with a proof by [`Shares`](super::Shares). For ε the Hausdorff distance is at most ε times the
//! diameter of A; for a count there are at most k generators. Flat bodies, zero and parallel generators are ordinary
//! input.
//!
//! # Source
//! Lemma 5.5, with these departures. The patches are cells of a grid on the faces of a cube, in any dimension; a patch
//! with no generator has none in B. For a direction n of the patch and the angle θ of its cell, H ≤ 2 Σ |v²| ≤
//! 2 sin θ Σ |v|, since the projections reach farther than the v by Σ |v² · u| at most and the box of the v² reaches
//! Σ |v²| at most. The mean of Σ |v · u| over all unit u is c_D Σ |v|, with c_3 = 1/2, so Σ |v| ≤ D(A) / (2 c_D):
//! a grid with sin θ ≤ c_D ε is fine enough. A cell spans less than a right angle from its middle, as the lemma needs.
//!
//! # Method
//! 1. Divide each side of each face of the cube [−1, 1]^D into m parts. A generator, turned to point to a face, belongs
//!    to the cell through which its ray leaves the cube.
//! 2. With n the middle of the cell, v¹ = (v · n / n · n) n and v² = v − v¹. Add up the v¹ of each cell, rounded up.
//! 3. Write v = γ b + v² with the cell's sum b and γ rounded down, v² exact; the box has half-lengths Σ |v²_k|.
//! 4. For ε take m from the bound, and the bound on H that the shares prove, rounding included; where that is above
//!    ε D(A), as it is for an ε below what rounding costs, a slightly finer grid, and then A itself. For a count take
//!    the finest grid, of a sequence of grids, whose cells with generators and axes are at most k.
//!
//! # Complexity
//! O(n D) exact operations for a grid of k patches, and O(k log k) to sort them, so O(n) for ε and n generators; a
//! count takes O(log n) grids; O(n) space. For ε there are at most D ⌈√(D − 1) / (c_D ε)⌉^(D−1) patches, 24 / ε² in
//! space: the lemma's bound.
//!
//! # Shapes
//! `generators`: n × D, half-segments, any order.
//!
//! # Numerics
//! Which patch a generator belongs to and how much of it goes there is rounded; what is left of it is exact, and the
//! box is rounded up to doubles, so containment is exact.
//!
//! # Errors
//! [`BadEpsilon`](super::ReductionError::BadEpsilon) ⇔ ε is not in (0, 1);
//! [`TooManyPatches`](super::ReductionError::TooManyPatches) ⇔ m > 2^31;
//! [`OutOfRange`](super::ReductionError::OutOfRange) ⇔ a generator of B exceeds the largest double.
//!
//! # Checked by
//! [`brute_force`](super::brute_force) and the check of the shares, in rationals.
//!
//! # Example
//! ```
//! use zonotope::{Zonotope, reduction::{Problem, by_patches::patches}};
//! let body = Zonotope::new([0.0, 0.0], vec![[2.0, 1.0], [4.0, -2.0], [-1.0, 0.0], [0.0, 4.0], [1.0, 4.0]])?;
//! let reduced = patches(&Problem::new(&body, 4)?)?;
//! // one patch about each axis: 2 + 4 + 1 along x, 4 + 4 along y; what is left adds up to (1, 3)
//! assert_eq!(reduced.body.generators().len(), 4);
//! assert!(reduced.body.generators().iter().zip([[7.0, 0.0], [0.0, 8.0], [1.0, 0.0], [0.0, 3.0]]).all(
//!     |(g, exact)| (g[0] - exact[0]).abs() < 1e-14 && (g[1] - exact[1]).abs() < 1e-14));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::answer::{Containment, Problem, Reduced, ReductionError, check_epsilon};
use super::cells::{Cell, SIDE_LIMIT, cells};
use super::frame_cover::{Frame, covered};
use super::keeping::order::scaled;
use super::share_distance::ShareDistance;
use super::shares::Share;
use crate::numeric::exact_sum::ExactSum;
use crate::numeric::linear::dot;
use crate::numeric::outward::at_least;
use crate::numeric::scaling::{binary_exponent, largest_magnitude, scale_by_power_of_two};
use crate::tally::{Operation, Tally};
use crate::zonotope::Zonotope;

/// The finest grid for a count: what is left of a generator there is below 2^-12 of it.
const COUNTED_SIDE_LIMIT: u32 = 1 << 12;

/// The reduction to a count of generators.
///
/// # Errors
/// [`ReductionError::OutOfRange`] if a generator leaves the range of doubles.
pub fn patches<const D: usize>(problem: &Problem<'_, D>) -> Result<Reduced<D>, ReductionError> {
    if let Some(same) = problem.unreduced() {
        return Ok(same);
    }
    let vectors = scaled(problem.body().generators());
    let mut finest = Vec::new();
    let mut side = 1;
    while side <= COUNTED_SIDE_LIMIT {
        let grid = cells(&vectors, side, &mut ());
        if grid.len() + D > problem.count() {
            break;
        }
        finest = grid;
        side += side.div_ceil(8);
    }
    projected(problem.body(), &vectors, &finest)
}

/// The reduction to a precision, relative to the diameter; the body itself where the patches would have no fewer
/// generators.
///
/// A read of a generator is counted each time that one is looked at (for its patch, for the sum of the patch, for what
/// its share leaves), and a comparison for each that it takes to sort the patches.
///
/// # Errors
/// [`ReductionError::BadEpsilon`] if ε is not in (0, 1), [`ReductionError::TooManyPatches`] if it needs too fine a
/// grid, [`ReductionError::OutOfRange`] if a generator leaves the range of doubles.
#[inline(never)]
pub fn patches_within<const D: usize>(
    body: &Zonotope<D>,
    epsilon: f64,
    tally: &mut dyn Tally,
) -> Result<Reduced<D>, ReductionError> {
    check_epsilon(epsilon)?;
    let side = side_for(D, epsilon);
    if side > f64::from(SIDE_LIMIT) {
        return Err(ReductionError::TooManyPatches(side));
    }
    let vectors = scaled(body.generators());
    // D(A) is at least 2 c_D Σ |v|
    let part = 2.0 * mean_width(D) * epsilon;
    for side in [side as u32, (side + side / 1024.0) as u32 + 1] {
        let reduced = projected(body, &vectors, &cells(&vectors, side, tally))?;
        tally.add(Operation::GeneratorRead, 2 * vectors.len() as u64);
        if reduced.body.generators().len() >= body.generators().len() {
            break;
        }
        let Containment::Shares(shares) = &reduced.proof else { break };
        if ShareDistance::new(shares, body, &reduced.body).is_within(part) {
            return Ok(reduced);
        }
    }
    Ok(Reduced::unreduced(body))
}

/// The number of patches that the precision takes in a dimension, those without generators included.
pub fn patch_count(dimension: usize, epsilon: f64) -> f64 {
    let (faces, side) = (dimension as f64, side_for(dimension, epsilon));
    (1..dimension).fold(faces, |count, _| count * side)
}

/// The cells along a side of a face with which sin θ ≤ c_D ε.
fn side_for(dimension: usize, epsilon: f64) -> f64 {
    ((dimension as f64 - 1.0).sqrt() / (mean_width(dimension) * epsilon)).ceil().max(1.0)
}

/// The mean of |u_1| over unit vectors: c_1 = 1, c_2 = 2/π, c_{D+2} = c_D D / (D + 1).
fn mean_width(dimension: usize) -> f64 {
    let (first, mut mean) = if dimension.is_multiple_of(2) { (2, std::f64::consts::FRAC_2_PI) } else { (1, 1.0) };
    for d in (first..dimension).step_by(2) {
        mean *= d as f64 / (d as f64 + 1.0);
    }
    mean
}

/// The enclosing zonotope of the projections on the middles of cells and of the box of the rest.
fn projected<const D: usize>(
    body: &Zonotope<D>,
    vectors: &[[f64; D]],
    cells: &[Cell<D>],
) -> Result<Reduced<D>, ReductionError> {
    let exponent = binary_exponent(largest_magnitude(body.generators().as_flattened())).unwrap_or(0);
    let mut shares = vec![None; vectors.len()];
    let mut generators = Vec::with_capacity(cells.len() + D);
    for cell in cells {
        let square = dot(&cell.middle, &cell.middle);
        let lengths: Vec<f64> = cell.members.iter().map(|&index| dot(&vectors[index], &cell.middle) / square).collect();
        let mut sum = ExactSum::default();
        lengths.iter().for_each(|t| sum.add(t.abs()));
        let length = at_least(&sum.value());
        for (&index, t) in cell.members.iter().zip(lengths) {
            // towards 0, so that the magnitudes add up to at most 1
            let coefficient = (t.abs() / length).next_down().copysign(t);
            shares[index] = Some(Share { generator: generators.len(), coefficient });
        }
        generators.push(cell.middle.map(|c| scale_by_power_of_two(length * c, i64::from(exponent))));
    }
    if generators.as_flattened().iter().any(|c| !c.is_finite()) {
        return Err(ReductionError::OutOfRange);
    }
    covered(body, generators, shares, Frame::Axes)
}
