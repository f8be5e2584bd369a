//! One body's generators near a direction, in the frame of the body: nested cells of directions, and for each the sum
//! of the generators that miss it.
//!
//! A cell fixes the sign of v · u for nearly all generators v, whatever the pose of the body, since the cell is one of
//! directions as the body sees them. So the sums outlive the frame in which they were made: as long as the directions
//! that a search asks about, pulled back into the frame of the body, stay in a cell, the search reads the few
//! generators that cross that cell and none of the others.
//!
//! The cells are balls around nearly the same direction, each [`SHRINK`] times as wide as the next smaller one. A
//! direction that wanders leaves the smallest ones often, which are made anew from a short list, and the widest one
//! rarely: with a way of ω a frame, a cell of radius r lasts r / ω frames and costs as many generators as cross the one
//! around it, which is about SHRINK r n. Every cell adds SHRINK ω n reads a frame, however wide it is.

use crate::lad::of_generators::cells::reduced::Reduced;
use crate::lad::of_generators::seam::direction_cone::DirectionCone;
use crate::lad::of_generators::seam::sign_pass::{FixedSum, Places, USUAL_CROSSING};
use crate::numeric::lanes::rows::Rows;
use crate::numeric::linear::{dot, euclidean_norm};
use crate::numeric::tolerance::{CONE_ROUNDING, THIRTY_ROUNDINGS};

/// The radius of the widest cell, around a direction of length 1: an eighth of evenly spread generators cross it.
pub(super) const WIDEST_RADIUS: f64 = 0.125;

/// By how much a cell is smaller than the one around it.
const SHRINK: f64 = 8.0;

/// A cell that so few generators cross has no smaller one in it: a search takes them all at once.
const SHORT_LIST: usize = 48;

/// The sums of one body's generators near a direction; none at first.
#[derive(Debug, Default)]
pub(super) struct LocalSums {
    /// Each cell within the one before.
    levels: Vec<Reduced>,
}

impl LocalSums {
    /// Keeps the cells that are still around a direction of the body's frame, and makes smaller ones down to the radius
    /// `least`. Returns how many generators were read.
    pub(super) fn center_on(&mut self, rows: Rows<'_>, direction: [f64; 3], least: f64) -> usize {
        let length = euclidean_norm(&direction);
        let center = direction.map(|c| c / length);
        if !center.iter().all(|c| c.is_finite()) {
            self.levels.clear();
            return 0;
        }
        let ball = |radius: f64| DirectionCone { center, axes: None, ball: radius };
        while self.levels.last().is_some_and(|level| !holds(level, &ball(least.max(radius_of(level) / SHRINK)))) {
            self.levels.pop();
        }
        let mut radius = self.levels.last().map_or(WIDEST_RADIUS, |level| radius_of(level) / SHRINK);
        let mut read = 0;
        while radius >= least {
            let around = self.levels.last().map_or(rows.len(), |level| level.vectors.len());
            if around <= SHORT_LIST {
                break;
            }
            let level = self.levels.last().map_or_else(|| reduced(rows, ball(radius)), |last| last.split(ball(radius)));
            read += around;
            // parallel generators cross all cells together, and where sums overflow there is nothing to keep
            if 4 * level.vectors.len() > 3 * around || !level.is_moderate() {
                break;
            }
            self.levels.push(level);
            radius /= SHRINK;
        }
        read
    }

    /// The smallest of the cells that holds another one.
    pub(super) fn around(&self, cell: &DirectionCone) -> Option<&Reduced> {
        self.levels.iter().rev().find(|level| holds(level, cell))
    }

    /// The sum of the generators whose sign is fixed in a cell of the body's frame, with the places of the others; from
    /// all rows where no cell of these sums holds that one.
    pub(super) fn split(&self, rows: Rows<'_>, cell: &DirectionCone, places: &mut Places) -> FixedSum {
        let Some(level) = self.around(cell) else { return cell.split(rows, places) };
        let first = places.len();
        let fixed = level.plus_fixed_in(cell, places);
        places[first..].iter_mut().for_each(|place| *place = level.indices[*place as usize]);
        FixedSum { read: level.vectors.len(), ..fixed }
    }
}

/// All rows, reduced by one pass.
fn reduced(rows: Rows<'_>, cell: DirectionCone) -> Reduced {
    let mut indices = Places::with_capacity(USUAL_CROSSING);
    let fixed = cell.split(rows, &mut indices);
    let vectors = indices.iter().map(|&place| rows.row(place as usize)).collect();
    Reduced { vectors, indices, fixed, cell: Some(cell), relative_error: 0.0 }
}

fn radius_of(level: &Reduced) -> f64 {
    level.cell.map_or(0.0, |cell| cell.ball)
}

/// Whether a cell is certainly part of that of a level, which is a ball around a direction c of length about 1.
///
/// Both are cones, so the centre z of the cell may be scaled by any t > 0. With t = c · z / z · z, what t z and t times
/// the other vectors of the cell are off c is known but for a few roundings of |c| and |t z|.
fn holds(level: &Reduced, cell: &DirectionCone) -> bool {
    let Some(DirectionCone { center, ball, .. }) = &level.cell else { return false };
    let z = &cell.center;
    let factor = dot(center, z) / dot(z, z);
    let off = [0, 1, 2].map(|k| factor * z[k] - center[k]);
    let reach = cell.axes.iter().flatten().map(euclidean_norm).sum::<f64>() + cell.ball;
    let rounding = CONE_ROUNDING * (euclidean_norm(center) + factor * euclidean_norm(z));
    // false for NaN as well
    factor > 0.0 && (euclidean_norm(&off) + factor * reach + rounding) * THIRTY_ROUNDINGS <= *ball
}
