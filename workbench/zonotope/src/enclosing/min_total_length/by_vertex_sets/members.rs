//! The members of a set generation: the points that have a multiplier so far. A zonotope of the sets has them as
//! vertices by construction; all other points have to be looked at to find those outside.

use std::collections::BTreeSet;

use super::scalar::{Scalar, values};
use super::vertex_sets::VertexSets;
use crate::enclosing::fixed_directions::balanced;
use crate::enclosing::min_total_length::box_coordinates::{BoxCoordinates, Position};
use crate::enclosing::min_total_length::frame::Frame;
use crate::numeric::linear::dot;

/// In a round up to this many points become members, or a quarter as many as there are members if that is more.
const LEAST_JOINING_LIMIT: usize = 16;

/// A generator shorter than this in box coordinates, relative to the longest, is left out: it is rounding noise, which
/// hinders the search for a facet.
const NEGLIGIBLE_LENGTH: f64 = 1e-12;

/// Of up to this many points all are looked at each time.
const FULL_LOOK_LIMIT: usize = 400;

/// A look passes over this share of the points that were inside when they were last looked at, in turns.
const TURNS: usize = 4;

/// A point whose ray left the zonotope nearer than this multiple of it is looked at again each time.
const NEAR_REACH: f64 = 1.0 + 1e-3;

/// The search for a facet takes about this many operations for each generator.
const WORK_PER_GENERATOR: f64 = 30.0;

/// A point is outside if the ray to it leaves the zonotope at a multiple of the point that is below 1 by more than
/// this.
const REACH_ROUNDING: f64 = 1e-14;

/// The points that have a multiplier, and the vertex sets with their variables.
pub(super) struct Members<'a, R, const D: usize> {
    pub(super) frame: &'a Frame<D>,
    pub(super) coordinates: &'a BoxCoordinates<'a, D>,
    pub(super) sets: VertexSets<'a, R, D>,
    /// The places of the members in the frame's list of points, in the order of their multipliers.
    pub(super) places: Vec<usize>,
    /// Whether each point of the frame is a member.
    is_member: Vec<bool>,
    /// The multiple of each point at which its ray left the zonotope when it was last looked at.
    reaches: Vec<f64>,
    /// The normal of the facet through which it left, in box coordinates.
    normals: Vec<Option<[f64; D]>>,
    /// The number of looks so far.
    looks: usize,
}

/// The points outside a zonotope.
pub(super) struct PointsOutside<const D: usize> {
    /// The least factor, not below 1, by which the generators have to be lengthened to contain all points.
    pub(super) stretch: f64,
    /// The places of the points outside, the farthest first, with the normals of the facets that their rays leave
    /// through.
    pub(super) points: Vec<(usize, [f64; D])>,
    /// The number of points that were looked at.
    pub(super) looked_at: usize,
    /// Whether these were all that are no members.
    pub(super) is_of_all: bool,
}

impl<'a, R: Scalar, const D: usize> Members<'a, R, D> {
    /// The members at given places, in the order of the points of `sets`.
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
        let count = frame.points.len();
        let (reaches, normals) = (vec![0.0; count], vec![None; count]);
        Self { frame, coordinates, sets, places, is_member, reaches, normals, looks: 0 }
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

    /// Makes the point at a place, farthest along a normal, a member unless it is one.
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

    /// Makes members of the points that are farthest along the normals of points outside; those, not the points outside
    /// themselves, are vertices of the convex hull.
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

    /// The multipliers in doubles with the places of their points, rounded so that they add up to zero exactly.
    pub(super) fn balanced_multipliers(&self) -> Vec<(usize, [f64; D])> {
        let multipliers = self.places.iter().copied().zip(self.sets.multipliers.iter().map(values));
        balanced(&multipliers.collect::<Vec<_>>())
    }

    /// The centre of the zonotope of the sets' generators, the sets whose generators are not negligible, and these
    /// generators. The first point p_0 is in no set, so the centre is p_0 + Σ g_T.
    pub(super) fn zonotope(&self, generators: Vec<[f64; D]>) -> ([f64; D], Vec<usize>, Vec<[f64; D]>) {
        let first = self.places.first().map_or([0.0; D], |&j| self.frame.points[j]);
        let center = generators.iter().fold(first, |sum, g| std::array::from_fn(|c| sum[c] + g[c]));
        let size = |g: &[f64; D]| self.coordinates.size(g);
        let longest = generators.iter().map(size).fold(0.0, f64::max);
        let is_long = |(_, g): &(usize, [f64; D])| size(g) > NEGLIGIBLE_LENGTH * longest;
        let (sets, long) = generators.into_iter().enumerate().filter(is_long).unzip();
        (center, sets, long)
    }

    /// For each member the coefficients of the generators of some sets that place it: `size` for the sets that contain
    /// it, −`size` for the others.
    pub(super) fn witnesses(&self, sets: &[usize], size: f64) -> Vec<(usize, Vec<f64>)> {
        let mut signs = vec![vec![-size; sets.len()]; self.places.len()];
        for (column, &set) in sets.iter().enumerate() {
            for member in self.sets.sets[set].points.members() {
                signs[member][column] = size;
            }
        }
        self.places.iter().copied().zip(signs).collect()
    }

    /// The points outside a zonotope, of those that are no members and were outside when they were last looked at, or
    /// nearly, or whose turn it is.
    pub(super) fn points_likely_outside(&mut self, center: [f64; D], generators: &[[f64; D]]) -> PointsOutside<D> {
        if self.is_member.len() <= FULL_LOOK_LIMIT {
            self.normals.fill(None);
            return self.all_points_outside(center, generators);
        }
        self.looks += 1;
        let turn = self.looks % TURNS;
        let is_looked_at = |j: usize, reach: f64| reach < NEAR_REACH || j % TURNS == turn;
        self.points_outside(center, generators, is_looked_at)
    }

    /// The points outside a zonotope, of all that are no members.
    pub(super) fn all_points_outside(&mut self, center: [f64; D], generators: &[[f64; D]]) -> PointsOutside<D> {
        self.points_outside(center, generators, |_, _| true)
    }

    /// The points outside a zonotope, of those that are no members and are looked at.
    fn points_outside(
        &mut self,
        center: [f64; D],
        generators: &[[f64; D]],
        is_looked_at: impl Fn(usize, f64) -> bool,
    ) -> PointsOutside<D> {
        let others = (0..self.is_member.len()).filter(|&j| !self.is_member[j] && is_looked_at(j, self.reaches[j]));
        let others: Vec<usize> = others.collect();
        let looked_at = others.len();
        self.sets.work += WORK_PER_GENERATOR * (looked_at * generators.len()) as f64;
        let mut least: f64 = 1.0;
        let mut outside = Vec::new();
        for (j, position) in self.coordinates.positions(center, generators, others.into_iter(), &mut self.normals) {
            let (reach, normal) = match position {
                Position::Facet { reach, normal } => (reach, normal),
                Position::OffSpan { normal } => (0.0, normal),
                Position::Center => continue,
            };
            self.reaches[j] = reach;
            least = least.min(reach);
            if reach < 1.0 - REACH_ROUNDING {
                outside.push((reach, j, normal));
            }
        }
        outside.sort_by(|a, b| a.0.total_cmp(&b.0));
        let points = outside.into_iter().map(|(_, j, normal)| (j, normal)).collect();
        let is_of_all = looked_at == self.is_member.len() - self.places.len();
        PointsOutside { stretch: 1.0 / least, points, looked_at, is_of_all }
    }
}
