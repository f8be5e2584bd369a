//! The signs of a plot's points: polygons with corners in whole units (plotters' own triangle goes through the
//! platform's sine).

use super::{FINENESS, rgb};
use crate::style::{Color, PAPER, SERIES};
use plotters::element::{EmptyElement, Polygon};
use plotters::prelude::DrawingBackend;
use std::ops::Add;

/// Corners in tenths of a page unit.
const SHAPES: [&[(i32, i32)]; 6] = [
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
];

/// How the points and the curve of a series are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// The colour of the curve and of the signs.
    pub color: Color,
    /// Which of the six shapes the sign has, counted round.
    pub shape: usize,
    /// Whether the sign is hollow.
    pub is_hollow: bool,
}

impl Look {
    /// The look of the series with this number where series are no methods.
    pub fn of_series(number: usize) -> Self {
        Self { color: SERIES[number % SERIES.len()], shape: number, is_hollow: false }
    }
}

/// A polygon hung on a place.
pub(super) type Sign<C, DB> = <EmptyElement<C, DB> as Add<Polygon<(i32, i32)>>>::Output;

/// The sign of a series, at a place.
pub(super) fn sign<C, DB: DrawingBackend>(at: C, look: Look) -> Sign<C, DB> {
    polygon(at, look.shape, 10, look.color)
}

/// What is cut out of a hollow sign: the same shape at half its size, in the colour of the page.
pub(super) fn inner<C, DB: DrawingBackend>(at: C, look: Look) -> Sign<C, DB> {
    polygon(at, look.shape, 5, PAPER)
}

/// A shape in tenths of its size.
fn polygon<C, DB: DrawingBackend>(at: C, shape: usize, tenths: i32, color: Color) -> Sign<C, DB> {
    let scaled = |c: i32| c * FINENESS * tenths / 100;
    let corners: Vec<(i32, i32)> = SHAPES[shape % SHAPES.len()].iter().map(|&(x, y)| (scaled(x), scaled(y))).collect();
    EmptyElement::at(at) + Polygon::new(corners, rgb(color))
}
