//! The distance of a point inside a zonotope from its planes of support, h(u) − u · p over |u|, on cells of directions.
//!
//! On a cell most generators have a fixed sign. They are summed up, and the sum is handed down to the quarters of the
//! cell, which look at the others alone. For any point a of the zonotope, u · (a − p) is a lower bound of h(u) − u · p;
//! it is linear, so divided by |u| ≤ Σ α_i |u_i| it is least at a corner u_i of the cell where it is not negative. Two
//! points are tried: with the coefficient 0 for the generators that cross the cell, which suits a facet whose normal is
//! in the cell, and with the signs that they have in the middle.
//!
//! The least distance belongs to a facet, and its normal is a product of two generators that cross the cell. Where few
//! cross, all these products are tried, and the cell is settled.

use crate::lad::of_generators::generators::KernelQuery;
use crate::numeric::bounded::Bounded;
use crate::numeric::double_double::BoundedDoubleDouble;
use crate::numeric::exact_linear::{self, ExactVector};
use crate::numeric::linear::{cross, dot, euclidean_norm, sum_norm};
use crate::numeric::scaling::scale_by_power_of_two;
use crate::numeric::tolerance::{CELL_ROUNDING, LONG_SUM, THIRTY_ROUNDINGS, UNDERFLOW, UNIT};
use crate::zonotope::direction_search::best_first::{DirectionFunction, Look};
use crate::zonotope::direction_search::cell::Cell;

/// The most generators that cross a cell of which all products are tried.
const SETTLED_COUNT: usize = 6;

/// A vector of space, to twice the digits of a double.
type PairVector = [BoundedDoubleDouble; 3];

/// The function of directions, for a point and generators that are scaled to ordinary size.
pub(super) struct DepthInCells<'q> {
    query: &'q dyn KernelQuery,
    /// The generators that are not zero, by their indices in the query.
    indices: Vec<u32>,
    pairs: Vec<PairVector>,
    rounded: Vec<[f64; 3]>,
    /// −p.
    end: PairVector,
}

/// What generators that cross a cell sum up to in the middle of the cell, in doubles.
#[derive(Default)]
struct Crossing {
    /// Σ ± v with the signs of v · center.
    sum: [f64; 3],
    /// Σ |v · center|.
    value: f64,
    /// At least what each of these sums times a direction of the cell may be off.
    error: f64,
}

/// Generators that cross a cell, and the sum of the others with their signs, minus p.
pub(super) struct Known {
    crossing: Vec<u32>,
    sum: PairVector,
}

impl<'q> DepthInCells<'q> {
    /// The function for the point and the generators of a query, times 2^`exponent`.
    pub(super) fn new(query: &'q dyn KernelQuery, indices: Vec<u32>, exponent: i64) -> Self {
        let pair = |v: ExactVector| v.map(|c| BoundedDoubleDouble::of(&c.scaled(exponent)));
        let are_doubles = query.relative_error() == 0.0;
        let pairs: Vec<PairVector> = indices
            .iter()
            .map(|&index| {
                let own = query.generator(index as usize);
                let scaled = own.map(|c| scale_by_power_of_two(c, exponent));
                // a product with a power of two is exact unless it is subnormal
                let is_exact =
                    are_doubles && own.iter().zip(&scaled).all(|(c, scaled)| *c == 0.0 || scaled.is_normal());
                if is_exact {
                    scaled.map(BoundedDoubleDouble::exact)
                } else {
                    pair(query.exact_generator(index as usize))
                }
            })
            .collect();
        let rounded = pairs.iter().map(|v| v.map(|c| c.high)).collect();
        let end = pair(query.exact()).map(|c| c.negated());
        Self { query, indices, pairs, rounded, end }
    }

    /// h(u) − u · p, where `sum` holds what has a fixed sign; elsewhere a lower bound.
    fn value(&self, u: &PairVector, sum: &PairVector, crossing: &[u32]) -> BoundedDoubleDouble {
        crossing.iter().fold(dot(u, sum), |value, &index| value + dot(u, &self.pairs[index as usize]).abs())
    }

    /// The sum of the generators that have a fixed sign in a cell, and the others with what they sum up to.
    fn split(&self, cell: &Cell, known: &Known) -> (Known, Crossing) {
        let (center, reach) = (cell.center(), cell.reach());
        let (mut crossing, mut middle, mut sum) = (Vec::new(), Crossing::default(), known.sum);
        let mut magnitude = 0.0;
        for &index in &known.crossing {
            let v = &self.rounded[index as usize];
            let (along, size) = (dot(v, &center), sum_norm(v));
            let across = dot(&v.map(f64::abs), &reach);
            // false for NaN as well
            if along.abs() > across + CELL_ROUNDING * size + UNDERFLOW {
                sum = signed(&sum, &self.pairs[index as usize], along);
            } else {
                crossing.push(index);
                let sign = f64::copysign(1.0, along);
                middle.sum = [0, 1, 2].map(|k| middle.sum[k] + sign * v[k]);
                middle.value += along.abs();
                magnitude += size;
            }
        }
        // each vector and product is off by less than the rounding of a cell, each of so many additions by u
        middle.error = (CELL_ROUNDING + crossing.len() as f64 * UNIT) * LONG_SUM * magnitude + UNDERFLOW;
        (Known { crossing, sum }, middle)
    }

    /// What all facets with a normal in the cell say: the least lower bound of a distance, and the normal with the
    /// least value; `None` if a product of two generators is not known well enough.
    fn settle(&self, cell: &Cell, known: &Known) -> Option<(f64, Option<PairVector>)> {
        let (mut lower, mut best) = (f64::INFINITY, None);
        let crossing = &known.crossing;
        for (place, &first) in crossing.iter().enumerate() {
            for &second in &crossing[place + 1..] {
                let Some(normal) = self.normal(first as usize, second as usize) else { continue };
                let Some(normal) = toward(cell, normal)? else { continue };
                let bound = quotient(&self.value(&normal, &known.sum, crossing), &normal).0;
                if bound < lower || best.is_none() {
                    (lower, best) = (bound.max(0.0), Some(normal));
                }
            }
        }
        Some((lower, best))
    }

    /// A vector orthogonal to two generators, of ordinary size; `None` if they are parallel.
    fn normal(&self, first: usize, second: usize) -> Option<PairVector> {
        let normal = cross(&self.pairs[first], &self.pairs[second]);
        let [a, b] = [first, second].map(|index| sum_norm(&self.rounded[index]));
        let is_clear = normal.iter().any(|c| c.high.abs() > CLEAR_ANGLE * a * b);
        if is_clear && a * b > CLEAR_ANGLE {
            return Some(normal);
        }
        let [v, w] = [first, second].map(|place| self.query.exact_generator(self.indices[place] as usize));
        let exact = exact_linear::cross(&v, &w);
        let exponent = exact.iter().filter_map(|c| c.binary_exponent()).max()?;
        Some(exact.map(|c| BoundedDoubleDouble::of(&c.scaled(-exponent))))
    }
}

/// The part of a value that the error of sums in doubles may be; above it, pairs of doubles are summed up.
const DOUBLES_DOUBT: f64 = 1e-4;

/// The sine of an angle between generators, and the size of a product of lengths, above which pairs of doubles know
/// their cross product well.
const CLEAR_ANGLE: f64 = 1e-8;

impl DirectionFunction for DepthInCells<'_> {
    type Known = Known;

    fn everywhere(&self) -> Known {
        Known { crossing: (0..self.pairs.len() as u32).collect(), sum: self.end }
    }

    fn look_at(&self, cell: &Cell, known: &Known, upper: f64) -> Look<Known> {
        let (known, middle) = self.split(cell, known);
        if known.crossing.len() <= SETTLED_COUNT
            && let Some((lower, normal)) = self.settle(cell, &known)
        {
            let found = normal.filter(|_| lower < upper).map(|normal| {
                let all: Vec<u32> = (0..self.pairs.len() as u32).collect();
                let value = self.value(&normal, &self.end, &all);
                (normal.map(|c| c.high), quotient(&value, &normal).1)
            });
            return Look { lower, found, known: None };
        }
        let center = cell.center().map(BoundedDoubleDouble::exact);
        let corners = cell.corners().map(|corner| corner.map(BoundedDoubleDouble::exact));
        let fixed = dot(&center, &known.sum);
        let of_crossing = BoundedDoubleDouble::of_parts(middle.value, 0.0, middle.error);
        let is_precise = middle.error < DOUBLES_DOUBT * (fixed + of_crossing).high;
        let value = if is_precise { fixed + of_crossing } else { self.value(&center, &known.sum, &known.crossing) };
        let in_the_middle = |corner: &PairVector| {
            let own = dot(&corner.map(|c| c.high), &middle.sum);
            dot(corner, &known.sum) + BoundedDoubleDouble::of_parts(own, 0.0, 2.0 * middle.error)
        };
        let least = |value: &dyn Fn(&PairVector) -> BoundedDoubleDouble| {
            corners.iter().map(|corner| quotient(&value(corner), corner).0).fold(f64::INFINITY, f64::min)
        };
        // false for NaN as well; the point is inside, so no distance is negative
        let bounds = [least(&|corner| dot(corner, &known.sum)), least(&in_the_middle)];
        let lower = bounds.into_iter().filter(|bound| *bound > 0.0).fold(0.0, f64::max);
        Look { lower, found: Some((cell.center(), quotient(&value, &center).1)), known: Some(known) }
    }
}

/// The sum with a vector, or with its opposite if `sign` is negative.
fn signed(sum: &PairVector, v: &PairVector, sign: f64) -> PairVector {
    [0, 1, 2].map(|k| if sign < 0.0 { sum[k] - v[k] } else { sum[k] + v[k] })
}

/// Bounds of a value over the length of a vector.
fn quotient(value: &BoundedDoubleDouble, vector: &PairVector) -> (f64, f64) {
    let (low, high) = value.interval();
    let rounded: [Bounded; 3] = vector.each_ref().map(BoundedDoubleDouble::rounded);
    let length = euclidean_norm(&rounded.map(|c| c.value));
    let error = euclidean_norm(&rounded.map(|c| c.error));
    let slack = THIRTY_ROUNDINGS - 1.0;
    let (shortest, longest) = ((length - error) * (1.0 - slack) - error * slack, (length + error) * THIRTY_ROUNDINGS);
    let divided = |value: f64, positive: f64, negative: f64| {
        if value >= 0.0 { value / positive } else { value / negative }
    };
    if shortest.is_nan() || shortest <= 0.0 {
        return (f64::NEG_INFINITY, f64::INFINITY);
    }
    (divided(low, longest, shortest).next_down(), divided(high, shortest, longest).next_up())
}

/// A vector or its opposite, whichever leads through the side of a cell, if it is in the cell or so near to it that
/// rounding hides that it is not: `Some(None)` if it is certainly not, `None` if nothing is known.
fn toward(cell: &Cell, vector: PairVector) -> Option<Option<PairVector>> {
    let (axis, side) = cell.side();
    let ahead = if side < 0.0 { vector[axis].negated() } else { vector[axis] };
    let Some(sign) = ahead.sign() else {
        // the vector is in the plane through the origin along the side but for rounding: outside if another coordinate
        // is larger
        let is_larger = |k: usize| vector[k].abs().certain_order(&ahead.abs()).is_some_and(|order| order.is_gt());
        return (0..3).any(|k| k != axis && is_larger(k)).then_some(None);
    };
    let vector = if sign < 0 { vector.map(|c| c.negated()) } else { vector };
    let ahead = ahead.abs();
    let [low, high] = [cell.corners()[0], cell.corners()[3]];
    let is_outside = |k: usize| {
        let [least, most] = [low[k], high[k]].map(|c| ahead * BoundedDoubleDouble::exact(c));
        (vector[k] - least).sign() == Some(-1) || (vector[k] - most).sign() == Some(1)
    };
    Some(if (0..3).any(|k| k != axis && is_outside(k)) { None } else { Some(vector) })
}
