//! The shortest zonotopes along finer and finer nets of directions in space, until they prove the ratio 1 + ε.
//!
//! Around many points on the boundary a step of the interior-point method takes a time that grows as the cube of their
//! number, while the gap between the bounds that a net of K directions proves in space falls about as 1/K, whatever the
//! number of points. So for a moderate ε a few hundred directions are enough. Most of the gap is that of the lower
//! bound: Σ_j |λ_j · v| is at most 1 along the directions v of the net and larger between them. It is convex in the
//! multipliers, and different nets have their directions at different places. So the mean of the multipliers of two
//! nets is nearer to feasible than either.

use std::collections::BTreeMap;

use super::work::Work;
use crate::enclosing::fixed_directions::{Generation, balanced};
use crate::enclosing::min_total_length::box_coordinates::BoxCoordinates;
use crate::enclosing::min_total_length::direction_net::cell_corners;
use crate::enclosing::min_total_length::frame::Frame;
use crate::enclosing::min_total_length::frame_zonotope::FrameZonotope;
use crate::enclosing::min_total_length::lower_bound::BestBound;
use crate::tally::Tally;

/// The cells along a side of a face of the cube, of whose corners each net consists: 193, 301 and 433 directions.
const CELLS: [usize; 3] = [8, 10, 12];

/// The relative precision to which the programs are solved.
const PRECISION: f64 = 1e-6;

/// Multipliers with the places of their points.
pub(super) type PlacedMultipliers<const D: usize> = Vec<(usize, [f64; D])>;

/// Solves the programs along the nets of space one after the other until the bounds, which are kept in `best` and
/// `inner`, are within ε, or the work is used up.
pub(super) fn along_finer_nets<const D: usize>(
    frame: &Frame<D>,
    coordinates: &BoxCoordinates<'_, D>,
    epsilon: f64,
    best: &mut BestBound<D>,
    inner: &mut FrameZonotope<D>,
    work: &mut Work,
    tally: &mut dyn Tally,
) {
    for cells in CELLS {
        if inner.upper <= (1.0 + epsilon) * best.lower || work.left_for_nets() == 0 {
            break;
        }
        let corners = cell_corners::<3>(cells);
        let net: Vec<[f64; D]> =
            corners.iter().map(|v| std::array::from_fn(|c| v.get(c).copied().unwrap_or(0.0))).collect();
        let weights = vec![1.0; net.len()];
        let mut generation = Generation::new(frame.rank(), &frame.points, net, weights, tally);
        generation.set_precision(PRECISION);
        generation.set_work_limit(work.left_for_nets());
        let is_solved = generation.run(tally).is_ok();
        work.add_on_nets(generation.work());
        let before = best.multipliers().to_vec();
        let multipliers = multipliers_of(&generation);
        let between = mean(&before, &multipliers);
        best.improve(frame.rank(), &frame.points, multipliers, f64::INFINITY);
        best.improve(frame.rank(), &frame.points, between, f64::INFINITY);
        keep_shorter(coordinates.stretched(FrameZonotope::along(&generation)), inner);
        if !is_solved {
            break;
        }
    }
}

/// Keeps the shorter one of two zonotopes around the points.
pub(super) fn keep_shorter<const D: usize>(found: FrameZonotope<D>, inner: &mut FrameZonotope<D>) {
    if found.upper < inner.upper {
        *inner = found;
    }
}

/// The multipliers of the points in the program along directions, rounded so that they add up to zero exactly.
pub(super) fn multipliers_of<const D: usize>(generation: &Generation<'_, D>) -> PlacedMultipliers<D> {
    let rows = generation.program.multipliers();
    let unbalanced: PlacedMultipliers<D> = rows.map(|(row, y)| (row.point, row.normal.map(|c| c * y))).collect();
    balanced(&unbalanced)
}

/// The mean of two lists of multipliers.
fn mean<const D: usize>(a: &[(usize, [f64; D])], b: &[(usize, [f64; D])]) -> PlacedMultipliers<D> {
    let mut sums: BTreeMap<usize, [f64; D]> = BTreeMap::new();
    for (j, multiplier) in a.iter().chain(b) {
        let sum = sums.entry(*j).or_insert([0.0; D]);
        *sum = std::array::from_fn(|c| sum[c] + multiplier[c] / 2.0);
    }
    balanced(&sums.into_iter().collect::<Vec<_>>())
}
