//! The state of a set generation: the points that have a multiplier, their vertex sets, and what a look at all points finds.

use std::collections::BTreeSet;

use super::interior::scalar::{Scalar, values};
use super::vertex_sets::VertexSets;
use crate::enclosing::fixed_directions::balanced;
use crate::enclosing::min_total_length::box_coordinates::{BoxCoordinates, Sight};
use crate::enclosing::min_total_length::frame::Frame;
use crate::zonotope::ray_exit::dot;

/// After a look at all points at least this many of those outside may join.
const LEAST_JOINING_LIMIT: usize = 16;

/// A generator shorter than this beside the longest, in box coordinates, is left out: it is noise in a search for a facet.
const NEGLIGIBLE_LENGTH: f64 = 1e-12;

/// A point whose ray leaves before it by more than this, relatively, is outside.
const GAUGE_ROUNDING: f64 = 1e-14;

/// The points that have a multiplier, with their vertex sets.
pub(super) struct Members<'a, R, const D: usize> {
    pub(super) frame: &'a Frame<D>,
    pub(super) coordinates: &'a BoxCoordinates<'a, D>,
    pub(super) sets: VertexSets<'a, R, D>,
    /// The places of these points in the frame, in the order of the multipliers.
    pub(super) places: Vec<usize>,
    is_member: Vec<bool>,
}

/// What a look at all points found.
pub(super) struct Look<const D: usize> {
    /// The factor by which the generators must be longer to contain all points.
    pub(super) stretch: f64,
    /// The points outside, the farthest first, with the normals of the facets that they see.
    pub(super) outside: Vec<(usize, [f64; D])>,
}

impl<'a, R: Scalar, const D: usize> Members<'a, R, D> {
    pub(super) fn new(
        frame: &'a Frame<D>,
        coordinates: &'a BoxCoordinates<'a, D>,
        sets: VertexSets<'a, R, D>,
        places: Vec<usize>,
    ) -> Self {
        let mut is_member = vec![false; frame.points.len()];
        for &j in &places {
            is_member[j] = true;
        }
        Self { frame, coordinates, sets, places, is_member }
    }

    /// The place of the first point that is farthest along a direction.
    pub(super) fn farthest(&self, u: &[f64; D]) -> usize {
        let mut far = (f64::NEG_INFINITY, 0);
        for (j, point) in self.frame.points.iter().enumerate() {
            let height = dot(u, point);
            if height > far.0 {
                far = (height, j);
            }
        }
        far.1
    }

    /// Adds a point that is farthest along a normal, unless it has a multiplier already.
    pub(super) fn add(&mut self, point: usize, normal: &[f64; D]) {
        if std::mem::replace(&mut self.is_member[point], true) {
            return;
        }
        if let Some(&first) = self.places.first() {
            let points = &self.frame.points;
            self.sets.add_point(&points[point], &points[first], normal);
        }
        self.places.push(point);
    }

    /// Adds the points that are farthest along the facets that points outside see.
    pub(super) fn add_outside(&mut self, outside: Vec<(usize, [f64; D])>) {
        let mut added = BTreeSet::new();
        for (_, normal) in outside {
            let point = self.farthest(&normal);
            self.add(point, &normal);
            added.insert(point);
            if added.len() >= LEAST_JOINING_LIMIT.max(self.places.len() / 4) {
                break;
            }
        }
    }

    /// The multipliers in doubles with the places of their points, changed by rounding so that they add up to zero exactly.
    pub(super) fn balanced_multipliers(&self) -> Vec<(usize, [f64; D])> {
        let multipliers = self.places.iter().copied().zip(self.sets.multipliers.iter().map(values));
        balanced(&multipliers.collect::<Vec<_>>())
    }

    /// The centre, from which the first point is the sum of all generators away, and the generators that are not negligible with
    /// the places of their sets.
    pub(super) fn zonotope(&self, generators: Vec<[f64; D]>) -> ([f64; D], Vec<usize>, Vec<[f64; D]>) {
        let first = self.places.first().map_or([0.0; D], |&j| self.frame.points[j]);
        let center = generators.iter().fold(first, |sum, g| std::array::from_fn(|c| sum[c] + g[c]));
        let size = |g: &[f64; D]| self.coordinates.size(g);
        let longest = generators.iter().map(size).fold(0.0, f64::max);
        let is_long = |(_, g): &(usize, [f64; D])| size(g) > NEGLIGIBLE_LENGTH * longest;
        let (places, long) = generators.into_iter().enumerate().filter(is_long).unzip();
        (center, places, long)
    }

    /// The coefficients, of magnitude `size`, of the points that have a multiplier: of one sign for the sets that contain the point,
    /// of the other for those that do not.
    pub(super) fn witnesses(&self, sets: &[usize], size: f64) -> Vec<(usize, Vec<f64>)> {
        let mut signs = vec![vec![-size; sets.len()]; self.places.len()];
        for (column, &set) in sets.iter().enumerate() {
            for member in self.sets.sets[set].points.members() {
                signs[member][column] = size;
            }
        }
        self.places.iter().copied().zip(signs).collect()
    }

    /// Looks at all points that have no multiplier; the others are vertices of the zonotope.
    pub(super) fn look(&self, center: [f64; D], generators: &[[f64; D]]) -> Look<D> {
        let mut least: f64 = 1.0;
        let mut outside = Vec::new();
        let others = (0..self.is_member.len()).filter(|&j| !self.is_member[j]);
        for (j, sight) in self.coordinates.sights(center, generators, others) {
            let (gauge, normal) = match sight {
                Sight::Facet { gauge, normal } => (gauge, normal),
                Sight::OffSpan { normal } => (0.0, normal),
                Sight::Center => continue,
            };
            least = least.min(gauge);
            if gauge < 1.0 - GAUGE_ROUNDING {
                outside.push((gauge, j, normal));
            }
        }
        outside.sort_by(|a, b| a.0.total_cmp(&b.0));
        let outside = outside.into_iter().map(|(_, j, normal)| (j, normal)).collect();
        Look { stretch: 1.0 / least, outside }
    }
}
