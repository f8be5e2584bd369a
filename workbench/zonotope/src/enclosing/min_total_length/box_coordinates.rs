//! Coordinates in which the points of a frame reach equally far along every axis.
//!
//! Containment is the same in all coordinates, but in floating point it is hard to decide for a thin body. In box
//! coordinates no body is thin. Lengths are not kept, so a total length is never measured in them.

use super::frame::Frame;
use super::frame_zonotope::FrameZonotope;
use crate::numeric::linear::dot;
use crate::numeric::tolerance::UNIT;
use crate::zonotope::ray_exit::FacetDescent;

/// The smallest box around the points along [`Frame::long`]: half its width along each of these axes is the unit of
/// length there.
pub(super) struct BoxCoordinates<'a, const D: usize> {
    frame: &'a Frame<D>,
    /// The least height of a point along each axis, rounded down.
    low: [f64; D],
    /// The greatest height of a point along each axis, rounded up.
    high: [f64; D],
}

/// Where a point lies relative to a zonotope: where the ray from the centre to the point leaves it.
pub(super) enum Position<const D: usize> {
    /// The ray leaves the zonotope at the multiple `reach` of the point, through a facet with this unit normal: the
    /// point is outside just when `reach` is below 1.
    Facet { reach: f64, normal: [f64; D] },
    /// No multiple of the zonotope contains the point, as far as floating point can tell. The unit normal is orthogonal
    /// to the generators; it is the direction of the point where no facet was found although the point is near their
    /// span.
    OffSpan { normal: [f64; D] },
    /// The point is the centre.
    Center,
}

impl<'a, const D: usize> BoxCoordinates<'a, D> {
    /// The box coordinates of the points of a frame.
    pub(super) fn of(frame: &'a Frame<D>) -> Self {
        let (mut low, mut high) = ([0.0; D], [0.0; D]);
        for (axis, long) in frame.long.iter().enumerate() {
            let along = frame.points.iter().map(|p| dot(p, long));
            (low[axis], high[axis]) =
                along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
        }
        // The heights are rounded: the exact ones may lie this much farther out.
        let reach = low.iter().chain(&high).fold(0.0, |most: f64, v| most.max(v.abs()));
        let rounding = 8.0 * UNIT * reach;
        Self { frame, low: low.map(|v| v - rounding), high: high.map(|v| v + rounding) }
    }

    /// The box as a zonotope, with which set generation begins.
    pub(super) fn boxed(&self) -> FrameZonotope<D> {
        let mut inner =
            FrameZonotope { upper: 0.0, center: [0.0; D], generators: Vec::with_capacity(D), witnesses: Vec::new() };
        for (axis, long) in self.frame.long.iter().enumerate() {
            let (middle, half) = ((self.low[axis] + self.high[axis]) / 2.0, self.half(axis));
            inner.center = std::array::from_fn(|c| inner.center[c] + middle * long[c]);
            inner.generators.push(long.map(|c| c * half));
            inner.upper += half;
        }
        inner
    }

    /// Half the width of the box along an axis.
    fn half(&self, axis: usize) -> f64 {
        (self.high[axis] - self.low[axis]) / 2.0
    }

    /// The length in box coordinates of a vector of the frame.
    pub(super) fn size(&self, v: &[f64; D]) -> f64 {
        let inside = self.vector(v);
        dot(&inside, &inside).sqrt()
    }

    /// The half-length of the segment along a vector in the ellipsoid that is the unit ball in box coordinates: about
    /// how long a generator along the vector can be.
    pub(super) fn half_length_along(&self, v: &[f64; D]) -> f64 {
        let inside = self.vector(v);
        (dot(v, v) / dot(&inside, &inside)).sqrt()
    }

    /// A vector of the frame in box coordinates.
    pub(super) fn vector(&self, v: &[f64; D]) -> [f64; D] {
        std::array::from_fn(|axis| self.frame.long.get(axis).map_or(0.0, |long| dot(long, v) / self.half(axis)))
    }

    /// The width of the box along each axis, divided by its greatest width.
    pub(super) fn thinness(&self) -> [f64; D] {
        let longest = (0..self.frame.rank()).map(|axis| self.half(axis)).fold(0.0, f64::max);
        std::array::from_fn(|axis| if axis < self.frame.rank() { self.half(axis) / longest } else { 1.0 })
    }

    /// The unit normal in the frame of a plane that has the normal `n` in box coordinates.
    fn normal(&self, n: &[f64; D]) -> [f64; D] {
        let mut sum = [0.0; D];
        for (axis, long) in self.frame.long.iter().enumerate() {
            sum = std::array::from_fn(|c| sum[c] + n[axis] / self.half(axis) * long[c]);
        }
        let length = dot(&sum, &sum).sqrt();
        sum.map(|c| c / length)
    }

    /// Where points of the frame, given by their places, lie relative to the zonotope with a centre and generators.
    /// The normals that the search for a place's facet ended with, in box coordinates, are where the next one begins.
    pub(super) fn positions(
        &self,
        center: [f64; D],
        generators: &[[f64; D]],
        places: impl Iterator<Item = usize>,
        normals: &mut [Option<[f64; D]>],
    ) -> impl Iterator<Item = (usize, Position<D>)> {
        let coordinates: Vec<[f64; D]> = generators.iter().map(|g| self.vector(g)).collect();
        let mut descent = FacetDescent::new(self.frame.rank(), &coordinates);
        let span = spanning_directions(&coordinates);
        places.map(move |place| {
            let point = &self.frame.points[place];
            let ray = self.vector(&std::array::from_fn(|c| point[c] - center[c]));
            let near = normals[place].and_then(|normal| descent.facet_from(&ray, &normal));
            let facet = near.or_else(|| descent.facet(&ray));
            normals[place] = facet.as_ref().map(|facet| facet.normal);
            let position = match facet {
                _ if ray == [0.0; D] => Position::Center,
                // Generators that hardly span leave so small a multiple that rounding may make it negative.
                Some(facet) => Position::Facet { reach: facet.reach.max(0.0), normal: self.normal(&facet.normal) },
                None => {
                    let off = orthogonal_part(&ray, &span);
                    let is_off =
                        dot(&off, &off) > RELATIVE_DISTANCE_OFF_SPAN * RELATIVE_DISTANCE_OFF_SPAN * dot(&ray, &ray);
                    Position::OffSpan { normal: self.normal(if is_off { &off } else { &ray }) }
                }
            };
            (place, position)
        })
    }

    /// A zonotope with its generators lengthened until it contains all points.
    pub(super) fn stretched(&self, inner: FrameZonotope<D>) -> FrameZonotope<D> {
        let stretch = self.stretch(inner.center, &inner.generators);
        let generators = inner.generators.iter().map(|g| g.map(|c| c * stretch)).collect();
        FrameZonotope { upper: inner.upper * stretch, center: inner.center, generators, witnesses: Vec::new() }
    }

    /// The least factor, not below 1, by which generators have to be lengthened for their zonotope to contain all
    /// points, in floating point; infinite if no factor is enough.
    pub(super) fn stretch(&self, center: [f64; D], generators: &[[f64; D]]) -> f64 {
        let all = 0..self.frame.points.len();
        let mut normals = vec![None; self.frame.points.len()];
        self.positions(center, generators, all, &mut normals).fold(1.0, |stretch: f64, (_, position)| match position {
            Position::Facet { reach, .. } => stretch.max(1.0 / reach),
            Position::OffSpan { .. } => f64::INFINITY,
            Position::Center => stretch,
        })
    }
}

/// A vector is off the span of others if its distance from that span exceeds this share of its length.
const RELATIVE_DISTANCE_OFF_SPAN: f64 = 1e-9;

/// Orthonormal directions whose span contains vectors, but for parts of them that are short beside the longest vector.
pub(super) fn spanning_directions<const D: usize>(vectors: &[[f64; D]]) -> Vec<[f64; D]> {
    let mut directions: Vec<[f64; D]> = Vec::with_capacity(D);
    let mut rest = vectors.to_vec();
    let longest = vectors.iter().map(|v| dot(v, v)).fold(0.0, f64::max).sqrt();
    while let Some(far) = rest.iter().copied().max_by(|a, b| dot(a, a).total_cmp(&dot(b, b))) {
        let length = dot(&far, &far).sqrt();
        if length <= RELATIVE_DISTANCE_OFF_SPAN * longest || directions.len() == D {
            break;
        }
        let unit = far.map(|c| c / length);
        for v in &mut rest {
            *v = orthogonal_part(v, &[unit]);
        }
        directions.push(unit);
    }
    directions
}

/// The part of a vector orthogonal to orthonormal directions.
fn orthogonal_part<const D: usize>(v: &[f64; D], directions: &[[f64; D]]) -> [f64; D] {
    directions.iter().fold(*v, |rest, unit| {
        let along = dot(unit, &rest);
        std::array::from_fn(|c| rest[c] - along * unit[c])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_multiple_of_a_flat_zonotope_contains_points_of_space() {
        let points = [[1.0, 0.0, 0.0], [-1.0, 1e-6, 0.0], [0.0, 0.0, 1e-6]];
        let frame = Frame::new(&points);
        let coordinates = BoxCoordinates::of(&frame);
        let boxed = coordinates.boxed();
        assert!(coordinates.stretch(boxed.center, &boxed.generators) < 1.0 + 1e-9);
        let long = 0.5 * (frame.points[1][0] - frame.points[0][0]).abs();
        assert!((boxed.upper / long - 1.0).abs() < 1e-5);
        assert_eq!(coordinates.stretch(boxed.center, &boxed.generators[..1]), f64::INFINITY);
    }
}
