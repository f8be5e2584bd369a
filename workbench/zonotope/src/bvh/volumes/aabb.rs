//! The box along the axes of the mesh.

use super::shape::Shaped;
use crate::bvh::frame::Frame;
use crate::bvh::volume::{BoundingVolume, ROUNDED_BOX, box_around, expected_overlaps_of_generators};
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
    type Turned = TurnedAxes;

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

    fn turned(frame: &Frame) -> TurnedAxes {
        TurnedAxes { frame: *frame, magnitudes: frame.inverse_rotation.map(|row| row.map(f64::abs)) }
    }

    #[inline]
    fn gap(&self, other: &Self, TurnedAxes { frame, magnitudes }: &TurnedAxes) -> f64 {
        let (a, b) = (self.half(), other.half().map(|c| c * frame.ratio));
        let (to, from) = (frame.image(&other.center()), self.center());
        let apart: [f64; 3] = std::array::from_fn(|k| to[k] - from[k]);
        let seen = frame.turned_back(&apart);
        let mut gap = f64::NEG_INFINITY;
        for i in 0..3 {
            // rows of the inverse rotation are the axes of the second mesh, columns those of the first
            let along_first = (0..3).map(|k| magnitudes[k][i] * b[k]).sum::<f64>();
            let along_second = (0..3).map(|k| magnitudes[i][k] * a[k]).sum::<f64>();
            gap = gap.max(apart[i].abs() - a[i] - along_first).max(seen[i].abs() - b[i] - along_second);
        }
        gap
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
