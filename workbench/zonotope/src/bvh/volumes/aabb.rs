//! The box along the axes of the mesh.

use super::shape::Shaped;
use crate::bvh::frame::Frame;
use crate::bvh::volume::{BoundingVolume, ROUNDED_BOX, box_around, expected_overlaps_of_generators};
use crate::numeric::linear::dot;
use crate::zonotope::Zonotope;

/// A box along the axes, by its least and its largest corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Aabb {
    low: [f64; 3],
    high: [f64; 3],
}

impl Aabb {
    /// The least corner.
    pub fn low(&self) -> [f64; 3] {
        self.low
    }

    /// The largest corner.
    pub fn high(&self) -> [f64; 3] {
        self.high
    }

    /// The middle, rounded.
    #[inline]
    pub(in crate::bvh) fn center(&self) -> [f64; 3] {
        std::array::from_fn(|k| 0.5 * (self.low[k] + self.high[k]))
    }

    /// Half the extents, rounded.
    #[inline]
    pub(in crate::bvh) fn half(&self) -> [f64; 3] {
        std::array::from_fn(|k| 0.5 * (self.high[k] - self.low[k]))
    }
}

/// The frame with the magnitudes of its rotation.
#[derive(Debug, Clone, Copy)]
pub struct TurnedAxes {
    frame: Frame,
    magnitudes: [[f64; 3]; 3],
}

impl TurnedAxes {
    /// The path from the middle of a box of the first mesh to that of one of the second.
    #[inline(always)]
    fn apart(&self, first: &Aabb, second: &Aabb) -> [f64; 3] {
        let (to, from) = (self.frame.image(&second.center()), first.center());
        [to[0] - from[0], to[1] - from[1], to[2] - from[2]]
    }

    /// The largest gap along the axes of the first mesh, which are the columns of the inverse rotation.
    #[inline(always)]
    fn gap_along_first(&self, apart: &[f64; 3], a: &[f64; 3], b: &[f64; 3]) -> f64 {
        let [p, q, r] = &self.magnitudes;
        let gap = |i: usize| apart[i].abs() - a[i] - (p[i] * b[0] + q[i] * b[1] + r[i] * b[2]);
        largest([gap(0), gap(1), gap(2)])
    }

    /// The largest gap along the axes of the second mesh, which are the rows of the inverse rotation.
    #[inline(always)]
    fn gap_along_second(&self, apart: &[f64; 3], a: &[f64; 3], b: &[f64; 3]) -> f64 {
        let seen = self.frame.turned_back(apart);
        let gap = |i: usize| seen[i].abs() - b[i] - dot(&self.magnitudes[i], a);
        largest([gap(0), gap(1), gap(2)])
    }
}

/// The largest of three numbers, of which NaN is none.
#[inline(always)]
fn largest([a, b, c]: [f64; 3]) -> f64 {
    let larger = |a: f64, b: f64| if b > a { b } else { a };
    larger(larger(if a.is_nan() { f64::NEG_INFINITY } else { a }, b), c)
}

impl Shaped for Aabb {
    fn shape(&self) -> Zonotope<3> {
        let [a, b, c] = self.half();
        let generators = [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]].into_iter().filter(|g| *g != [0.0; 3]).collect();
        Zonotope::new(self.center(), generators).expect("a volume of finite points is finite")
    }

    fn margin(&self) -> f64 {
        ROUNDED_BOX
    }
}

impl BoundingVolume for Aabb {
    const NAME: &'static str = "AABB";
    const IS_FITTED_TO_HULL: bool = false;
    type Prepared = TurnedAxes;

    fn around(points: &[[f64; 3]], _effort: usize) -> Self {
        let mut found = Self { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };
        for point in points {
            for (k, c) in point.iter().enumerate() {
                found.low[k] = found.low[k].min(*c);
                found.high[k] = found.high[k].max(*c);
            }
        }
        found
    }

    fn prepared(frame: &Frame) -> TurnedAxes {
        TurnedAxes { frame: *frame, magnitudes: frame.inverse_rotation.map(|row| row.map(f64::abs)) }
    }

    #[inline]
    fn gap(&self, other: &Self, turned: &TurnedAxes) -> f64 {
        let [a, b] = [self.half(), other.half().map(|c| c * turned.frame.ratio)];
        let apart = turned.apart(self, other);
        turned.gap_along_first(&apart, &a, &b).max(turned.gap_along_second(&apart, &a, &b))
    }

    #[inline]
    fn is_apart(&self, other: &Self, turned: &TurnedAxes, least: f64) -> bool {
        let [a, b] = [self.half(), other.half().map(|c| c * turned.frame.ratio)];
        let apart = turned.apart(self, other);
        turned.gap_along_first(&apart, &a, &b) > least || turned.gap_along_second(&apart, &a, &b) > least
    }

    fn contains(&self, point: &[f64; 3]) -> bool {
        (0..3).all(|k| (self.low[k]..=self.high[k]).contains(&point[k]))
    }

    fn as_zonotope(&self) -> Zonotope<3> {
        box_around(self.center(), self.half())
    }

    fn expected_overlaps(&self) -> f64 {
        let [a, b, c] = self.half();
        expected_overlaps_of_generators(&[[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]])
    }
}
