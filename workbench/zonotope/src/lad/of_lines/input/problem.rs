//! The problem: the validated lines in floating point and exactly, in one scaled frame, and the linear term.

use std::borrow::Cow;

use super::error::{LadError, validate};
use super::exact_lines::ExactLines;
use super::rounded_lines::{Columns, LineError, MadeLines, RoundedLines};
use super::weighted_line::{ScaledLines, WeightedLine};
use crate::arrangement::{ExactLine, LineIndex};
use crate::numeric::dyadic::Dyadic;
use crate::numeric::tolerance::UNIT;

/// Minimise linear · x + Σ weight_i |normal_i · x + offset_i| over the plane.
///
/// The lines in floating point are the terms with their weights multiplied in, normals scaled by 2^−`normal_scale` and
/// offsets by 2^−`offset_scale` to magnitude at most 2; a point of the plane is its scaled point times
/// 2^(`offset_scale` − `normal_scale`). Exact decisions go to `exact`, which holds the same lines in the same scaled
/// frame.
#[derive(Debug)]
pub struct LadProblem<'a> {
    rounded: Rounded<'a>,
    pub(crate) linear: [Dyadic; 2],
    pub(crate) exact: Box<dyn ExactLines + 'a>,
    normal_scale: i64,
    offset_scale: i64,
}

/// The source of the lines in floating point.
#[derive(Debug)]
enum Rounded<'a> {
    Stored(Columns, LineError),
    Made(Box<dyn MadeLines + 'a>),
}

impl LadProblem<'static> {
    /// Validates and scales the lines. O(n).
    ///
    /// # Errors
    /// [`LadError`] on the first coefficient that is not finite, the first negative weight, or too many lines.
    pub fn new(lines: &[WeightedLine], linear: [f64; 2]) -> Result<Self, LadError> {
        validate(lines, linear)?;
        let scaled = ScaledLines::new(lines, linear);
        let ScaledLines { normal_scale, offset_scale, .. } = scaled;
        let mut columns = Columns::with_capacity(lines.len());
        for line in lines {
            columns.push(scaled.rounded(line));
        }
        Ok(Self {
            rounded: Rounded::Stored(columns, LineError { offset_relative: 2.0 * UNIT, offset_per_normal: 0.0 }),
            linear: linear.map(|v| Dyadic::from_f64(v).scaled(-normal_scale)),
            exact: Box::new(scaled),
            normal_scale,
            offset_scale,
        })
    }
}

impl<'a> LadProblem<'a> {
    /// A problem whose columns are at most 2 in magnitude and approximate `exact` within `error`.
    pub(crate) fn from_exact_lines(
        columns: Columns,
        error: LineError,
        linear: [Dyadic; 2],
        exact: Box<dyn ExactLines + 'a>,
    ) -> Self {
        Self { rounded: Rounded::Stored(columns, error), linear, exact, normal_scale: 0, offset_scale: 0 }
    }

    /// A problem without a linear term whose lines in floating point are made as a pass reads them.
    pub(crate) fn from_made_lines(made: Box<dyn MadeLines + 'a>, exact: Box<dyn ExactLines + 'a>) -> Self {
        let linear = [Dyadic::zero(), Dyadic::zero()];
        Self { rounded: Rounded::Made(made), linear, exact, normal_scale: 0, offset_scale: 0 }
    }

    /// The lines in floating point.
    pub(crate) fn rounded(&self) -> RoundedLines<'_> {
        match &self.rounded {
            Rounded::Stored(columns, error) => RoundedLines::Stored { columns: Cow::Borrowed(columns), error: *error },
            Rounded::Made(lines) => RoundedLines::Made(&**lines),
        }
    }

    /// The number of lines.
    pub fn len(&self) -> usize {
        self.rounded().len()
    }

    /// Whether there are no lines.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The exact linear term, in the frame of the input.
    pub fn exact_linear(&self) -> [Dyadic; 2] {
        self.linear.clone().map(|v| v.scaled(self.normal_scale))
    }

    /// The exact term of a line with its weight multiplied in, in the frame of the input.
    ///
    /// # Panics
    /// If there is no line of this index: it is not below [`len`](Self::len).
    pub fn exact_line(&self, line: LineIndex) -> ExactLine {
        let ExactLine { normal, offset } = self.exact.line(line.position());
        ExactLine { normal: normal.map(|v| v.scaled(self.normal_scale)), offset: offset.scaled(self.offset_scale) }
    }

    /// W times the exact value of a line at a point of the scaled frame given in homogeneous coordinates.
    pub(crate) fn exact_scaled_value(&self, line: usize, point: &[Dyadic; 3]) -> Dyadic {
        self.exact.line(line).evaluate(point)
    }

    /// The exponent of the power of two that takes a point of the scaled frame to the frame of the input.
    pub(crate) fn point_scale(&self) -> i64 {
        self.offset_scale - self.normal_scale
    }

    /// The linear term of the scaled frame, rounded.
    pub(crate) fn approximate_linear(&self) -> [f64; 2] {
        [0, 1].map(|i| self.linear[i].to_f64())
    }
}
