//! The area f(O) of Z(O) as a function of the centre, in doubles: along a segment, and by its level sets. For pictures,
//! which need it at many places.
//!
//! f is a constant plus ½ Σ_t |e_t × (X − P_s − P_t)| with X = 2O, so it is convex, and affine on every cell of the
//! arrangement of the lines ℓ_t. Along a line it bends only where it crosses one of them.
//!
//! All values are rounded: sums over n lines, in the frame in which doubles tell the lines apart. The constant is taken
//! from one exact area. A corner of a level set lies on a line ℓ_t; a bounded level set is the convex hull of these
//! corners, of which every line has two or none.

use super::bisectors::{Bisectors, Frame};
use super::centered_zonogon::CenteredZonogon;
use crate::hull::antipodal::FarthestVertex;
use crate::hull::{ConvexHull, convex_hull};
use crate::numeric::scaling::scale_by_power_of_two;

/// The area of Z(O) around a hull.
#[derive(Debug, Clone)]
pub struct AreaFunction {
    frame: Frame,
    /// Rows (a, b, c) with e_t × (X − P_s − P_t) = a x + b y + c at the kernel point (x, y) of O.
    rows: Vec<[f64; 3]>,
    constant: f64,
}

/// A place on a segment where f may bend, or one of its ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bend {
    /// The place as a share of the way, from 0 to 1.
    pub at: f64,
    /// f there, rounded.
    pub area: f64,
}

/// f along a line of the plane, in the units of the frame: the places where it bends, in order, with its values.
struct Profile {
    stops: Vec<f64>,
    values: Vec<f64>,
    /// The slopes before the first stop and after the last one.
    outer_slopes: [f64; 2],
}

impl AreaFunction {
    /// f around a hull, given the farthest vertex of each edge. O(h) exact operations.
    ///
    /// # Panics
    /// When `farthest` does not have one vertex for each edge of the hull, or names one that the hull does not have.
    pub fn new(hull: &ConvexHull, farthest: &[FarthestVertex]) -> Self {
        let bisectors = Bisectors::new(hull, farthest);
        let frame = bisectors.frame;
        let rows = match *hull.vertices() {
            [first, last] => vec![row_of_segment([first, last].map(|end| frame.scaled(end)))],
            _ => bisectors.rows(),
        };
        let function = Self { frame, rows, constant: 0.0 };
        if !hull.has_area() {
            return function;
        }
        // Near the reference the lines tell most about the constant, as the other term is least.
        let center = function.plane_point([0.0, 0.0]);
        let exact = CenteredZonogon::new(hull, farthest, center, &mut ()).exact_area();
        let area = exact.scaled(-frame.scale(0) - frame.scale(1)).to_f64();
        let constant = area - function.varying(function.kernel_coordinates(center));
        Self { constant, ..function }
    }

    /// f at both ends of a segment and wherever it bends between them; it is affine from one to the next. O(h log h).
    pub fn along(&self, from: [f64; 2], to: [f64; 2]) -> Vec<Bend> {
        let [start, end] = [from, to].map(|point| self.kernel_coordinates(point));
        let direction = [end[0] - start[0], end[1] - start[1]];
        let Profile { stops, values, .. } = self.profile(start, direction);
        let bend = |at: f64, area: f64| Bend { at, area: self.unscaled(area) };
        let at_end = |at: f64, point: [f64; 2]| bend(at, self.constant + self.varying(point));
        let inner = stops.iter().zip(&values).filter(|(stop, _)| **stop > 0.0 && **stop < 1.0);
        let first = std::iter::once(at_end(0.0, start));
        first.chain(inner.map(|(&at, &area)| bend(at, area))).chain([at_end(1.0, end)]).collect()
    }

    /// For each level the polygon of the points where f is at most the level, its corners counter-clockwise; empty
    /// below the minimum, and where f is bounded in some direction. O(h² log h) and O(h) for each level.
    pub fn level_sets(&self, levels: &[f64]) -> Vec<Vec<[f64; 2]>> {
        let scale = -self.frame.scale(0) - self.frame.scale(1);
        let mut corners = vec![Vec::new(); levels.len()];
        for &[a, b, c] in &self.rows {
            let square = a * a + b * b;
            let (point, direction) = ([-a * c / square, -b * c / square], [-b, a]);
            let profile = self.profile(point, direction);
            for (corners, &level) in corners.iter_mut().zip(levels) {
                let met = profile.places_of(scale_by_power_of_two(level, scale));
                let places = met.into_iter().flatten();
                corners.extend(
                    places.map(|t| self.plane_point([point[0] + t * direction[0], point[1] + t * direction[1]])),
                );
            }
        }
        let outline = |corners: Vec<[f64; 2]>| convex_hull(&corners, &mut ()).map(|hull| hull.vertices().to_vec());
        corners.into_iter().map(|corners| outline(corners).unwrap_or_default()).collect()
    }

    /// f along the kernel points start + t direction.
    fn profile(&self, start: [f64; 2], direction: [f64; 2]) -> Profile {
        let terms = self.rows.iter().map(|[a, b, c]| {
            let slope = a * direction[0] + b * direction[1];
            (-(a * start[0] + b * start[1] + c) / slope, slope.abs())
        });
        // A line parallel to this one bends nothing.
        let mut terms: Vec<(f64, f64)> = terms.filter(|(stop, slope)| stop.is_finite() && *slope > 0.0).collect();
        terms.sort_by(|a, b| a.0.total_cmp(&b.0));
        let total = terms.iter().map(|(_, slope)| slope).sum::<f64>() / 2.0;
        let mut slope = -total;
        let mut stops: Vec<f64> = Vec::with_capacity(terms.len());
        let mut values: Vec<f64> = Vec::with_capacity(terms.len());
        for &(stop, bend) in &terms {
            let value = match (stops.last(), values.last()) {
                (Some(&last), Some(&value)) => value + slope * (stop - last),
                _ => self.constant + self.varying([start[0] + stop * direction[0], start[1] + stop * direction[1]]),
            };
            stops.push(stop);
            values.push(value);
            slope += bend;
        }
        Profile { stops, values, outer_slopes: [-total, slope] }
    }

    /// ½ Σ_t |e_t × (X − P_s − P_t)| at a kernel point.
    fn varying(&self, [x, y]: [f64; 2]) -> f64 {
        self.rows.iter().map(|[a, b, c]| (a * x + b * y + c).abs()).sum::<f64>() / 2.0
    }

    fn kernel_coordinates(&self, point: [f64; 2]) -> [f64; 2] {
        let frame = &self.frame;
        let scaled = frame.scaled(point);
        [0, 1].map(|axis| 2.0 * scaled[axis] - frame.reference[axis])
    }

    fn plane_point(&self, point: [f64; 2]) -> [f64; 2] {
        let frame = &self.frame;
        [0, 1].map(|axis| scale_by_power_of_two(point[axis] + frame.reference[axis], frame.scale(axis) - 1))
    }

    fn unscaled(&self, area: f64) -> f64 {
        scale_by_power_of_two(area, self.frame.scale(0) + self.frame.scale(1))
    }
}

impl Profile {
    /// The two places where a level is met; none at or below the minimum, or where the level is met on no side.
    fn places_of(&self, level: f64) -> Option<[f64; 2]> {
        let lowest = (0..self.stops.len()).min_by(|&a, &b| self.values[a].total_cmp(&self.values[b]))?;
        let last = self.stops.len() - 1;
        if self.values[lowest] >= level {
            return None;
        }
        let between = |inner: usize, outer: usize| {
            let part = (level - self.values[inner]) / (self.values[outer] - self.values[inner]);
            self.stops[inner] + part * (self.stops[outer] - self.stops[inner])
        };
        let beyond = |stop: usize, slope: f64| self.stops[stop] + (level - self.values[stop]) / slope;
        let [before, after] = self.outer_slopes;
        let left = (0..lowest).rev().find(|&stop| self.values[stop] >= level);
        let right = (lowest + 1..=last).find(|&stop| self.values[stop] >= level);
        let places = [
            left.map_or_else(|| beyond(0, before), |outer| between(outer + 1, outer)),
            right.map_or_else(|| beyond(last, after), |outer| between(outer - 1, outer)),
        ];
        places.iter().all(|place| place.is_finite()).then_some(places)
    }
}

/// The row of the hull of two points P and Q, around which f(O) = |(Q − P) × (X − 2 P)|, in a frame whose reference is
/// the origin.
fn row_of_segment([from, to]: [[f64; 2]; 2]) -> [f64; 3] {
    let edge = [to[0] - from[0], to[1] - from[1]];
    [-2.0 * edge[1], 2.0 * edge[0], 4.0 * (edge[1] * from[0] - edge[0] * from[1])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hull::antipodal::farthest_vertices;

    const POINTS: [[f64; 2]; 6] = [[0.0, 8.0], [2.0, 2.0], [16.0, 0.0], [21.0, 5.0], [17.0, 15.0], [9.0, 16.0]];

    fn hull_of(points: &[[f64; 2]]) -> (ConvexHull, Vec<FarthestVertex>) {
        let hull = convex_hull(points, &mut ()).expect("the points are finite");
        let farthest = farthest_vertices(&hull, &mut ());
        (hull, farthest)
    }

    fn area_at(hull: &ConvexHull, farthest: &[FarthestVertex], center: [f64; 2]) -> f64 {
        CenteredZonogon::new(hull, farthest, center, &mut ()).exact_area().to_f64()
    }

    #[test]
    fn along_a_segment_f_is_the_area_and_affine_between_its_bends() {
        for scale in [1.0, 1e-150, 1e150] {
            let (hull, farthest) = hull_of(&POINTS.map(|p| p.map(|c| c * scale)));
            let function = AreaFunction::new(&hull, &farthest);
            let [from, to] = [[-3.0, 1.0], [25.0, 13.0]].map(|p: [f64; 2]| p.map(|c| c * scale));
            let bends = function.along(from, to);
            assert_eq!((bends[0].at, bends[bends.len() - 1].at), (0.0, 1.0));
            let at = |t: f64| [0, 1].map(|axis| from[axis] + t * (to[axis] - from[axis]));
            let is_near = |value: f64, t: f64| {
                let area = area_at(&hull, &farthest, at(t));
                assert!((value - area).abs() <= 1e-12 * area, "{value} and {area} at {t}, scale {scale:e}");
            };
            assert!(bends.len() > 4 && bends.is_sorted_by(|a, b| a.at <= b.at));
            for pair in bends.windows(2) {
                is_near(pair[0].area, pair[0].at);
                is_near((pair[0].area + pair[1].area) / 2.0, (pair[0].at + pair[1].at) / 2.0);
            }
        }
    }

    #[test]
    fn around_a_segment_f_is_the_area_of_a_parallelogram_and_has_no_bounded_level_set() {
        for (points, bends) in [(vec![[1.0, 1.0], [3.0, 2.0]], 3), (vec![[1.0, 1.0]], 2)] {
            let (hull, farthest) = hull_of(&points);
            let function = AreaFunction::new(&hull, &farthest);
            let found = function.along([2.0, 0.0], [2.0, 6.0]);
            assert_eq!(found.len(), bends);
            for Bend { at, area } in found {
                assert_eq!(area, area_at(&hull, &farthest, [2.0, 6.0 * at]));
            }
            assert_eq!(function.level_sets(&[1.0]), [[[0.0; 2]; 0]]);
        }
    }

    #[test]
    fn f_has_the_level_at_the_corners_of_a_level_set_and_less_inside() {
        let (hull, farthest) = hull_of(&POINTS);
        let function = AreaFunction::new(&hull, &farthest);
        let least = crate::enclosing::min_area(&POINTS).expect("the points are finite").value;
        let levels = [0.99 * least, 1.05 * least, 2.0 * least, 10.0 * least];
        let sets = function.level_sets(&levels);
        assert!(sets[0].is_empty());
        for (corners, level) in sets.iter().zip(levels).skip(1) {
            assert!(corners.len() > 4);
            for &corner in corners {
                assert!((area_at(&hull, &farthest, corner) - level).abs() < 1e-12 * level);
            }
            let mean = [0, 1].map(|axis| corners.iter().map(|c| c[axis]).sum::<f64>() / corners.len() as f64);
            assert!(area_at(&hull, &farthest, mean) < level);
        }
    }

    #[test]
    fn level_sets_of_a_square_are_diamonds_around_its_middle() {
        // f(O) = 4 + 4 |x − 1| + 4 |y − 1| around the square of side 2: it has a line ℓ_t on each axis twice.
        let (hull, farthest) = hull_of(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
        let sets = AreaFunction::new(&hull, &farthest).level_sets(&[8.0, 4.0]);
        assert_eq!(sets, [vec![[0.0, 1.0], [1.0, 0.0], [2.0, 1.0], [1.0, 2.0]], vec![]]);
    }
}
