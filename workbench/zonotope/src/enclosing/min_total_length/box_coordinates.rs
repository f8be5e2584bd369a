//! Coordinates in which the points of a frame reach equally far along every axis: a thin body is not thin there, and
//! being inside does not depend on coordinates.

use super::frame::Frame;
use super::frame_zonotope::FrameZonotope;
use crate::numeric::tolerance::UNIT;
use crate::zonotope::ray_exit::{FacetDescent, dot};

/// The smallest box around the points along the frame's long axes, as a unit of length for each.
pub(super) struct BoxCoordinates<'a, const D: usize> {
    frame: &'a Frame<D>,
    /// The extent of the points along each axis.
    low: [f64; D],
    high: [f64; D],
}

/// How a point lies to a zonotope.
pub(super) enum Sight<const D: usize> {
    /// The zonotope, scaled by the inverse of the gauge, has the point on a facet with this unit normal.
    Facet { gauge: f64, normal: [f64; D] },
    /// No multiple of the zonotope holds the point, as far as floating point can tell; a unit vector orthogonal to all
    /// generators.
    OffSpan { normal: [f64; D] },
    /// The point is the centre.
    Center,
}

impl<'a, const D: usize> BoxCoordinates<'a, D> {
    pub(super) fn of(frame: &'a Frame<D>) -> Self {
        let (mut low, mut high) = ([0.0; D], [0.0; D]);
        for (axis, long) in frame.long.iter().enumerate() {
            let along = frame.points.iter().map(|p| dot(p, long));
            (low[axis], high[axis]) =
                along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
        }
        // Rounded heights may be farther out than told.
        let reach = low.iter().chain(&high).fold(0.0, |most: f64, v| most.max(v.abs()));
        let rounding = 8.0 * UNIT * reach;
        Self { frame, low: low.map(|v| v - rounding), high: high.map(|v| v + rounding) }
    }

    /// The box.
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

    fn half(&self, axis: usize) -> f64 {
        (self.high[axis] - self.low[axis]) / 2.0
    }

    /// How long a vector of the frame is in these coordinates.
    pub(super) fn size(&self, v: &[f64; D]) -> f64 {
        let inside = self.vector(v);
        dot(&inside, &inside).sqrt()
    }

    /// How long a segment along a vector may be in an ellipsoid around as wide as the points.
    pub(super) fn segment(&self, v: &[f64; D]) -> f64 {
        let inside = self.vector(v);
        (dot(v, v) / dot(&inside, &inside)).sqrt()
    }

    /// A vector of the frame in these coordinates.
    pub(super) fn vector(&self, v: &[f64; D]) -> [f64; D] {
        std::array::from_fn(|axis| self.frame.long.get(axis).map_or(0.0, |long| dot(long, v) / self.half(axis)))
    }

    /// How wide the box is along each axis, beside its longest.
    pub(super) fn thinness(&self) -> [f64; D] {
        let longest = (0..self.frame.rank()).map(|axis| self.half(axis)).fold(0.0, f64::max);
        std::array::from_fn(|axis| if axis < self.frame.rank() { self.half(axis) / longest } else { 1.0 })
    }

    fn normal(&self, n: &[f64; D]) -> [f64; D] {
        let mut sum = [0.0; D];
        for (axis, long) in self.frame.long.iter().enumerate() {
            sum = std::array::from_fn(|c| sum[c] + n[axis] / self.half(axis) * long[c]);
        }
        let length = dot(&sum, &sum).sqrt();
        sum.map(|c| c / length)
    }

    /// How some points of the frame lie to the zonotope of some generators around a centre.
    pub(super) fn sights(
        &self,
        center: [f64; D],
        generators: &[[f64; D]],
        places: impl Iterator<Item = usize>,
    ) -> impl Iterator<Item = (usize, Sight<D>)> {
        let coordinates: Vec<[f64; D]> = generators.iter().map(|g| self.vector(g)).collect();
        let mut descent = FacetDescent::new(self.frame.rank(), &coordinates);
        let span = long_directions(&coordinates);
        places.map(move |place| {
            let point = &self.frame.points[place];
            let ray = self.vector(&std::array::from_fn(|c| point[c] - center[c]));
            let sight = match descent.facet(&ray) {
                _ if ray == [0.0; D] => Sight::Center,
                // rounding may leave less than nothing of generators that hardly span
                Some(facet) => Sight::Facet { gauge: facet.gauge.max(0.0), normal: self.normal(&facet.normal) },
                None => {
                    let off = orthogonal_part(&ray, &span);
                    let is_off =
                        dot(&off, &off) > RELATIVE_DISTANCE_OFF_SPAN * RELATIVE_DISTANCE_OFF_SPAN * dot(&ray, &ray);
                    Sight::OffSpan { normal: self.normal(if is_off { &off } else { &ray }) }
                }
            };
            (place, sight)
        })
    }

    /// The zonotope contains all points when its generators are so much longer; infinite where none of its multiples
    /// does.
    pub(super) fn stretch(&self, center: [f64; D], generators: &[[f64; D]]) -> f64 {
        let all = 0..self.frame.points.len();
        self.sights(center, generators, all).fold(1.0, |stretch: f64, (_, sight)| match sight {
            Sight::Facet { gauge, .. } => stretch.max(1.0 / gauge),
            Sight::OffSpan { .. } => f64::INFINITY,
            Sight::Center => stretch,
        })
    }
}

/// A vector is off the span of others if its distance from that span exceeds this share of its length.
const RELATIVE_DISTANCE_OFF_SPAN: f64 = 1e-9;

/// Orthonormal directions that span vectors but for what is short beside the longest of them.
fn long_directions<const D: usize>(vectors: &[[f64; D]]) -> Vec<[f64; D]> {
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
    fn generators_that_do_not_span_hold_nothing() {
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
