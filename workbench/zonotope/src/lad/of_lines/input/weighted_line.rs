//! Lines given as doubles, and their terms in a frame scaled by powers of two.

use super::exact_lines::ExactLines;
use crate::arrangement::ExactLine;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::scaling::{binary_exponent, scale_by_power_of_two};

/// One term weight · |normal · x + offset| of the objective.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WeightedLine {
    /// The coefficients of x and y.
    pub normal: [f64; 2],
    /// The constant coefficient.
    pub offset: f64,
    /// The weight, which must not be negative.
    pub weight: f64,
}

impl WeightedLine {
    /// A line of weight 1.
    pub fn unweighted(normal: [f64; 2], offset: f64) -> Self {
        Self { normal, offset, weight: 1.0 }
    }
}

/// Lines given as doubles, whose products with their weights are scaled by powers of two to magnitude at most 2.
///
/// Normals and offsets have a scale each: an offset far from the normals in magnitude would underflow under theirs.
#[derive(Debug)]
pub(super) struct ScaledLines {
    lines: Vec<WeightedLine>,
    pub(super) normal_scale: i64,
    pub(super) offset_scale: i64,
}

/// A binary exponent below that of every product of two doubles; it stands for the exponent of zero.
const EXPONENT_OF_ZERO: i64 = -6000;

/// A binary exponent below that of every double, and above [`EXPONENT_OF_ZERO`].
const EXPONENT_BELOW_DOUBLES: i64 = -3000;

impl ScaledLines {
    /// The lines with the scales that their weighted coefficients and the linear term ask for.
    pub(super) fn new(lines: &[WeightedLine], linear: [f64; 2]) -> Self {
        let exponent = |value: f64| binary_exponent(value).map_or(EXPONENT_BELOW_DOUBLES, i64::from);
        let product = |line: &WeightedLine, value: f64| {
            let is_zero = line.weight == 0.0 || value == 0.0;
            if is_zero { EXPONENT_OF_ZERO } else { exponent(line.weight) + exponent(value) + 1 }
        };
        let largest = |exponents: &mut dyn Iterator<Item = i64>| {
            exponents.max().filter(|&exponent| exponent > EXPONENT_BELOW_DOUBLES).unwrap_or(0)
        };
        let normals = lines.iter().flat_map(|line| line.normal.map(|v| product(line, v)));
        let normal_scale = largest(&mut normals.chain(linear.map(exponent)));
        let offset_scale = largest(&mut lines.iter().map(|line| product(line, line.offset)));
        Self { lines: lines.to_vec(), normal_scale, offset_scale }
    }

    /// The weighted coefficients x, y and offset of a line in the scaled frame, each rounded once.
    pub(super) fn rounded(&self, line: &WeightedLine) -> [f64; 3] {
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

impl ExactLines for ScaledLines {
    fn line(&self, position: usize) -> ExactLine {
        let WeightedLine { normal, offset, weight } = self.lines[position];
        let weight = Dyadic::from_f64(weight);
        let times = |value: f64, scale: i64| (&weight * &Dyadic::from_f64(value)).scaled(-scale);
        ExactLine { normal: normal.map(|v| times(v, self.normal_scale)), offset: times(offset, self.offset_scale) }
    }
}
