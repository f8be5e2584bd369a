//! The input of the kernel: weighted lines, validated, scaled by powers of two, with exact values on demand.

use std::borrow::Cow;

use thiserror::Error;

use super::exact_lines::{ExactLines, Rows};
use super::rounded_lines::{Columns, LineError, MadeLines, RoundedLines};
use crate::arrangement::{ExactLine, LineIndex};
use crate::lad::of_lines::cell::Cell;
use crate::lad::of_lines::subproblem::instance::{Instance, Surroundings};
use crate::lad::of_lines::subproblem::vertex::Vertex;
use crate::numeric::dyadic::{Dyadic, binary_exponent, scale_by_power_of_two};
use crate::numeric::tolerance::{UNDERFLOW, UNIT};
use crate::tally::Tally;

/// One term weight · |normal · x + offset| of the objective.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WeightedLine {
    /// The coefficients of x and y.
    pub normal: [f64; 2],
    /// The constant coefficient.
    pub offset: f64,
    /// The weight, not negative.
    pub weight: f64,
}

impl WeightedLine {
    /// A line of weight 1.
    pub fn unweighted(normal: [f64; 2], offset: f64) -> Self {
        Self { normal, offset, weight: 1.0 }
    }
}

/// Why a set of lines is refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum LadError {
    /// A coefficient is NaN or infinite.
    #[error("line {line}: {coefficient} is {value}, not a finite number")]
    NonFinite {
        /// The line.
        line: usize,
        /// Which coefficient.
        coefficient: &'static str,
        /// Its value.
        value: f64,
    },
    /// A weight is below zero.
    #[error("line {line}: the weight {weight} is negative")]
    NegativeWeight {
        /// The line.
        line: usize,
        /// The weight.
        weight: f64,
    },
    /// A coefficient of the linear term is NaN or infinite.
    #[error("the linear term's coordinate {coordinate} is {value}, not a finite number")]
    NonFiniteLinear {
        /// 0 for x, 1 for y.
        coordinate: usize,
        /// Its value.
        value: f64,
    },
    /// There are more lines than a 32-bit index can name.
    #[error("{count} lines are more than the {} that an index can name", u32::MAX)]
    TooMany {
        /// How many lines there are.
        count: usize,
    },
}

/// Minimise linear · x + Σ weight_i |normal_i · x + offset_i| over the plane.
///
/// The rounded lines are the terms with their weights multiplied in, normals scaled by 2^−`normal_scale` and offsets by
/// 2^−`offset_scale` to magnitude at most 2; a point of the plane is its scaled point times
/// 2^(`offset_scale` − `normal_scale`). Exact decisions go to `exact`, which speaks of the same scaled lines.
#[derive(Debug)]
pub struct LadProblem<'a> {
    rounded: Rounded<'a>,
    pub(crate) linear: [Dyadic; 2],
    pub(crate) exact: Box<dyn ExactLines + 'a>,
    normal_scale: i64,
    offset_scale: i64,
}

/// Where the lines in floating point come from.
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
        let exponent = |value: f64| i64::from(binary_exponent(value).unwrap_or(-3000));
        let product = |line: &WeightedLine, value: f64| {
            if line.weight == 0.0 || value == 0.0 { -6000 } else { exponent(line.weight) + exponent(value) + 1 }
        };
        let largest = |exponents: &mut dyn Iterator<Item = i64>| exponents.max().filter(|&e| e > -3000).unwrap_or(0);
        let normal_scale =
            largest(&mut lines.iter().flat_map(|l| l.normal.map(|v| product(l, v))).chain(linear.map(exponent)));
        let offset_scale = largest(&mut lines.iter().map(|l| product(l, l.offset)));
        let rows = Rows { lines: lines.to_vec(), normal_scale, offset_scale };
        let mut columns = Columns::with_capacity(lines.len());
        for line in lines {
            columns.push(rows.approximate(line));
        }
        Ok(Self {
            rounded: Rounded::Stored(columns, LineError { offset_relative: 2.0 * UNIT, offset_per_normal: 0.0 }),
            linear: linear.map(|v| Dyadic::from_f64(v).scaled(-normal_scale)),
            exact: Box::new(rows),
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

    /// A problem without a linear term with lines that are made as they are read.
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

    /// How many lines there are.
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
    pub fn exact_line(&self, line: LineIndex) -> ExactLine {
        let ExactLine { normal, offset } = self.exact.line(line.position());
        ExactLine { normal: normal.map(|v| v.scaled(self.normal_scale)), offset: offset.scaled(self.offset_scale) }
    }

    /// The side of each line on which a point of the scaled frame lies, given in homogeneous coordinates with W > 0. O(n).
    pub(crate) fn signs_at(&self, point: &[Dyadic; 3], tally: &mut impl Tally) -> Vec<i8> {
        let mut around = Surroundings::default();
        Instance::whole(self).read_at(&Vertex::at(point.clone()), &mut around, tally);
        around.signs
    }

    /// The lines that may pass between given points of the scaled frame, with W = 1, and the side of every other line on which all
    /// of them lie; 0 for those lines. One pass, however many points.
    pub(crate) fn sides_around(&self, points: &[[Dyadic; 3]]) -> (Vec<u32>, Vec<i8>) {
        let center = [0, 1].map(|axis| points[0][axis].to_f64());
        let widest = |axis: usize| {
            let distance = |point: &[Dyadic; 3]| (&point[axis] - &Dyadic::from_f64(center[axis])).abs().to_f64();
            points.iter().map(distance).fold(UNDERFLOW, f64::max) * (1.0 + 8.0 * UNIT)
        };
        let split = Cell::upright(center, [widest(0), widest(1)]).split(&Instance::whole(self), &mut ());
        (split.crossing, split.signs)
    }

    /// W times the value of a line at a point of the scaled frame given in homogeneous coordinates.
    pub(crate) fn exact_scaled_value(&self, line: usize, point: &[Dyadic; 3]) -> Dyadic {
        self.exact.line(line).evaluate(point)
    }

    /// The power of two that takes a point of the scaled frame to the frame of the input.
    pub(crate) fn point_scale(&self) -> i64 {
        self.offset_scale - self.normal_scale
    }

    /// The linear term of the scaled frame, rounded.
    pub(crate) fn approximate_linear(&self) -> [f64; 2] {
        [0, 1].map(|i| self.linear[i].to_f64())
    }
}

fn validate(lines: &[WeightedLine], linear: [f64; 2]) -> Result<(), LadError> {
    for (coordinate, value) in linear.into_iter().enumerate() {
        if !value.is_finite() {
            return Err(LadError::NonFiniteLinear { coordinate, value });
        }
    }
    if u32::try_from(lines.len()).is_err() {
        return Err(LadError::TooMany { count: lines.len() });
    }
    for (line, &WeightedLine { normal: [x, y], offset, weight }) in lines.iter().enumerate() {
        for (coefficient, value) in [("normal x", x), ("normal y", y), ("offset", offset), ("weight", weight)] {
            if !value.is_finite() {
                return Err(LadError::NonFinite { line, coefficient, value });
            }
        }
        if weight < 0.0 {
            return Err(LadError::NegativeWeight { line, weight });
        }
    }
    Ok(())
}

impl Rows {
    fn approximate(&self, line: &WeightedLine) -> [f64; 3] {
        let term = |value: f64, scale: i64| {
            let (Some(w), Some(v)) = (binary_exponent(line.weight), binary_exponent(value)) else { return 0.0 };
            let (w, v) = (i64::from(w), i64::from(v));
            let product = scale_by_power_of_two(line.weight, -w) * scale_by_power_of_two(value, -v);
            scale_by_power_of_two(product, w + v - scale)
        };
        let [x, y] = line.normal;
        [term(x, self.normal_scale), term(y, self.normal_scale), term(line.offset, self.offset_scale)]
    }
}
