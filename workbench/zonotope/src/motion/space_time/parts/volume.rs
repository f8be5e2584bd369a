//! A volume while it is put together: what rounding takes from its parts is given back at the end.

use super::plane::Plane;
use super::scaled_body::ScaledBody;
use crate::motion::sweep::{Sweep, SweepError};
use crate::numeric::bounded::{Bounded, BoundedVector};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, exact, is_zero, multiple, sum};
use crate::numeric::outward::Loss;
use crate::numeric::scaling::scale_by_power_of_two;
use crate::zonotope::Zonotope;

/// The centre and the generators so far. Vectors with bounds are over 2^exponent.
#[derive(Debug)]
pub(in super::super) struct Volume {
    exponent: i64,
    center: ExactVector,
    generators: Vec<[f64; 3]>,
    loss: Loss<3>,
    /// The sum of the errors of vectors with bounds.
    spread: [f64; 3],
    terms: f64,
}

impl Volume {
    /// The volume that a segment sweeps: that of the translation around half of it, from a point.
    pub(in super::super) fn translated(from: [f64; 3], sweep: &Sweep, exponent: i64) -> Self {
        Self::around(Vec::new(), from, sweep, exponent)
    }

    /// The volume that generators around a point sweep by the translation alone.
    fn around(generators: Vec<[f64; 3]>, from: [f64; 3], sweep: &Sweep, exponent: i64) -> Self {
        let half = exact(sweep.translation).map(|c| c.scaled(-1));
        let center = sum(&exact(from), &half);
        let mut volume = Self { exponent, center, generators, loss: Loss::none(), spread: [0.0; 3], terms: 4.0 };
        volume.add_exact(&half);
        volume
    }

    /// The body as it stands, translated.
    pub(in super::super) fn of_body(body: &Zonotope<3>, sweep: &Sweep, exponent: i64) -> Self {
        // the generators that a volume adds: the translation, two across the axis, three for what rounding takes
        let mut generators = Vec::with_capacity(body.generators().len() + 6);
        generators.extend_from_slice(body.generators());
        Self::around(generators, body.center(), sweep, exponent)
    }

    /// The volume of the translation alone, which is exact but for rounding the centre.
    pub(in super::super) fn of_translation(body: &Zonotope<3>, sweep: &Sweep) -> Result<Zonotope<3>, SweepError> {
        Self::of_body(body, sweep, 0).finished()
    }

    /// The body turned about the axis, cosine and sine given, and translated.
    pub(in super::super) fn of_turned_body(
        body: &ScaledBody<'_>,
        plane: &Plane,
        turn: &[Bounded; 2],
        sweep: &Sweep,
    ) -> Self {
        let mut volume = Self::translated(sweep.axis_point, sweep, body.exponent);
        let turned = |v: &BoundedVector| plane.vector(&turned(&plane.coordinates(v), turn));
        volume.move_center(&turned(&body.arm));
        body.generators().for_each(|g| volume.add(&turned(&g)));
        volume
    }

    /// Adds a generator.
    pub(in super::super) fn add_exact(&mut self, generator: &ExactVector) {
        if !is_zero(generator) {
            self.generators.push(self.loss.round(generator));
        }
    }

    /// Adds a generator that is known within bounds.
    pub(in super::super) fn add(&mut self, generator: &BoundedVector) {
        let rounded = generator.map(|c| scale_by_power_of_two(c.value, self.exponent));
        for k in 0..3 {
            if rounded[k].abs() < f64::MIN_POSITIVE {
                let exact = Dyadic::from_f64(generator[k].value).scaled(self.exponent);
                self.loss.widen(k, &(&exact - &Dyadic::from_f64(rounded[k])).abs());
            }
        }
        if rounded != [0.0; 3] {
            self.generators.push(rounded);
        }
        self.widen(generator);
    }

    /// Moves the centre by a vector that is known within bounds.
    pub(in super::super) fn move_center(&mut self, by: &BoundedVector) {
        let exact = by.map(|c| Dyadic::from_f64(c.value).scaled(self.exponent));
        self.center = sum(&self.center, &exact);
        self.widen(by);
    }

    /// Adds a ball, over 2^exponent, by the box around it.
    pub(in super::super) fn add_ball(&mut self, radius: f64) {
        self.widen(&[Bounded { value: 0.0, error: radius }; 3]);
    }

    /// Adds a square of the plane around the disc of a radius over 2^exponent.
    pub(in super::super) fn add_square(&mut self, plane: &Plane, radius: f64) {
        if radius == 0.0 {
            return;
        }
        for (direction, length) in plane.directions.iter().zip(plane.lengths) {
            let factor = if length == 1.0 { radius } else { (radius / length).next_up() };
            self.add_exact(&multiple(&Dyadic::from_f64(factor).scaled(self.exponent), direction));
        }
    }

    fn widen(&mut self, by: &BoundedVector) {
        (0..3).for_each(|k| self.spread[k] += by[k].error);
        self.terms += 1.0;
    }

    /// The zonotope.
    pub(in super::super) fn finished(mut self) -> Result<Zonotope<3>, SweepError> {
        for k in 0..3 {
            let spread = self.spread[k] * (1.0 + self.terms * f64::EPSILON);
            if !spread.is_finite() {
                return Err(SweepError::OutOfRange);
            }
            self.loss.widen(k, &Dyadic::from_f64(spread).scaled(self.exponent));
        }
        let center = self.loss.round(&self.center);
        Ok(Zonotope::enclosing_rounded(center, self.generators, &self.loss)?)
    }
}

/// Coordinates along the axis and in the plane, turned about the axis.
pub(in super::super) fn turned([along, x, y]: &[Bounded; 3], [cosine, sine]: &[Bounded; 2]) -> [Bounded; 3] {
    [*along, *cosine * *x - *sine * *y, *sine * *x + *cosine * *y]
}
