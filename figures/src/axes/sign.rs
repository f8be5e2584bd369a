//! The signs of a plot's points: one shape a series, with corners in whole units (plotters' own triangle goes through
//! the platform's sine).

use super::{FINENESS, color_of, rgb};
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

/// A polygon hung on a place.
pub(super) type Sign<C, DB> = <EmptyElement<C, DB> as Add<Polygon<(i32, i32)>>>::Output;

/// The sign of the series with this number, at a place.
pub(super) fn sign<C, DB: DrawingBackend>(at: C, series: usize) -> Sign<C, DB> {
    let corners: Vec<(i32, i32)> =
        SHAPES[series % SHAPES.len()].iter().map(|(x, y)| (x * FINENESS / 10, y * FINENESS / 10)).collect();
    EmptyElement::at(at) + Polygon::new(corners, rgb(color_of(series)))
}
