//! A family of pairs of moving bodies as a value.

/// A family of pairs of moving bodies.
#[derive(Clone, Copy, Debug)]
pub struct MotionFamily {
    /// Stable name: part of every case id.
    pub id: &'static str,
    /// Name for people.
    pub title: &'static str,
    /// The motion, in a sentence.
    pub description: &'static str,
    /// The pair for a seed: a pure function.
    pub generate: fn(seed: u64) -> MovingPair,
}

/// The centre and the generators of a zonotope.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyRow {
    /// The centre at the start.
    pub center: [f64; 3],
    /// The generators at the start, as half-lengths.
    pub generators: Vec<[f64; 3]>,
}

/// A motion at constant rate: at the time t in [0, 1] a point x is at R(t · angle) (x − p) + p + t · translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Course {
    /// The point p of the axis.
    pub axis_point: [f64; 3],
    /// The axis, of any length but 0.
    pub axis: [f64; 3],
    /// The angle in radians.
    pub angle: f64,
    /// The translation.
    pub translation: [f64; 3],
}

impl Course {
    /// The course of a body that rests.
    pub const REST: Self = Self { axis_point: [0.0; 3], axis: [0.0, 0.0, 1.0], angle: 0.0, translation: [0.0; 3] };

    /// A turn about an axis.
    pub const fn turn(axis_point: [f64; 3], axis: [f64; 3], angle: f64) -> Self {
        Self { axis_point, axis, angle, translation: [0.0; 3] }
    }
}

/// Two bodies with their courses.
#[derive(Clone, Debug, PartialEq)]
pub struct MovingPair {
    /// The bodies at the start.
    pub bodies: [BodyRow; 2],
    /// Their courses.
    pub courses: [Course; 2],
    /// The unit vector along which the second body is moved aside with its axis, for a wider clearance.
    pub aside: [f64; 3],
}

impl MovingPair {
    /// The pair with the second body and its axis moved aside.
    #[must_use]
    pub fn moved_aside(&self, by: f64) -> Self {
        let moved = |place: [f64; 3]| [0, 1, 2].map(|k| place[k] + by * self.aside[k]);
        let mut pair = self.clone();
        pair.bodies[1].center = moved(pair.bodies[1].center);
        pair.courses[1].axis_point = moved(pair.courses[1].axis_point);
        pair
    }
}

impl MotionFamily {
    /// The pair that belongs to `seed`.
    pub fn generate(&self, seed: u64) -> MovingPair {
        (self.generate)(seed)
    }
}
