//! The signs of a plot's points: polygons with corners in whole units (plotters' own triangle goes through the
//! platform's sine).

use super::{FINENESS, rgb};
use crate::style::{Color, INK, PAPER, SERIES};
use plotters::element::{EmptyElement, Polygon};
use plotters::prelude::DrawingBackend;
use std::ops::Add;

/// The number of shapes.
pub(crate) const SHAPE_COUNT: usize = 14;

/// Corners in tenths of a page unit.
const SHAPES: [&[(i32, i32)]; SHAPE_COUNT] = [
    &[
        (40, 0),
        (35, 20),
        (20, 35),
        (0, 40),
        (-20, 35),
        (-35, 20),
        (-40, 0),
        (-35, -20),
        (-20, -35),
        (0, -40),
        (20, -35),
        (35, -20),
    ],
    &[(0, -50), (45, 30), (-45, 30)],
    &[(-36, -36), (36, -36), (36, 36), (-36, 36)],
    &[(0, -50), (50, 0), (0, 50), (-50, 0)],
    &[(0, 50), (45, -30), (-45, -30)],
    &[
        (-16, -46),
        (16, -46),
        (16, -16),
        (46, -16),
        (46, 16),
        (16, 16),
        (16, 46),
        (-16, 46),
        (-16, 16),
        (-46, 16),
        (-46, -16),
        (-16, -16),
    ],
    // pointing right, pointing left
    &[(50, 0), (-30, 45), (-30, -45)],
    &[(-50, 0), (30, 45), (30, -45)],
    // a diagonal cross
    &[
        (0, -18),
        (28, -46),
        (46, -28),
        (18, 0),
        (46, 28),
        (28, 46),
        (0, 18),
        (-28, 46),
        (-46, 28),
        (-18, 0),
        (-46, -28),
        (-28, -46),
    ],
    // a star of four rays
    &[(0, -60), (14, -14), (60, 0), (14, 14), (0, 60), (-14, 14), (-60, 0), (-14, -14)],
    // bars, lying and upright
    &[(-55, -16), (55, -16), (55, 16), (-55, 16)],
    &[(-16, -55), (16, -55), (16, 55), (-16, 55)],
    // an hourglass, upright and lying
    &[(-40, -45), (40, -45), (8, 0), (40, 45), (-40, 45), (-8, 0)],
    &[(-45, -40), (0, -8), (45, -40), (45, 40), (0, 8), (-45, 40)],
];

/// The drawing of the points and the curve of a series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// The colour of the curve and of the signs.
    pub color: Color,
    /// Which of the shapes the sign has, counted round.
    pub shape: usize,
    /// Whether the sign is hollow.
    pub is_hollow: bool,
    /// Whether the sign is larger than others, with a dark rim, and drawn above them.
    pub is_singled_out: bool,
}

/// A part of a sign: its size in tenths of the ordinary one, and its colour.
pub(super) type Layer = (i32, Color);

impl Look {
    /// The look with this colour and this shape, filled.
    pub const fn new(color: Color, shape: usize) -> Self {
        Self { color, shape, is_hollow: false, is_singled_out: false }
    }

    /// The look of the series with this number where series are no methods.
    pub fn of_series(number: usize) -> Self {
        Self::new(SERIES[number % SERIES.len()], number)
    }

    /// The parts of a sign, the lowest first: what is cut out of a hollow one has the colour of the page.
    pub(super) fn layers(self) -> impl Iterator<Item = Layer> {
        let rim = self.is_singled_out.then_some((20, INK));
        let body = (if self.is_singled_out { 14 } else { 10 }, self.color);
        let hole = self.is_hollow.then_some((if self.is_singled_out { 7 } else { 5 }, PAPER));
        rim.into_iter().chain([body]).chain(hole)
    }
}

/// A polygon hung on a place.
pub(super) type Sign<C, DB> = <EmptyElement<C, DB> as Add<Polygon<(i32, i32)>>>::Output;

/// A layer of a sign of this shape, at a place.
pub(super) fn sign<C, DB: DrawingBackend>(at: C, shape: usize, (tenths, color): Layer) -> Sign<C, DB> {
    let scaled = |c: i32| c * FINENESS * tenths / 100;
    let corners: Vec<(i32, i32)> = SHAPES[shape % SHAPES.len()].iter().map(|&(x, y)| (scaled(x), scaled(y))).collect();
    EmptyElement::at(at) + Polygon::new(corners, rgb(color))
}
