//! Small bodies by one solve: the coefficients of least size that make up p, or a direction that separates.
//!
//! With H = Σ v vᵀ and y = H^{-1} p, the coefficients v · y combine to p. So do the coefficients v · y / |v|_∞, which
//! are of more even size, with H = Σ v vᵀ / |v|_∞. If all are well within (−1, 1), p is inside. If not, y may separate:
//! Σ |v · y| is summed up as the coefficients are written. In both cases the trace of H bounds Σ |v|_∞, and so all
//! rounding errors.

use fearless_simd::{Level, Simd, dispatch, f64x8, prelude::*};

use crate::collision::by_lad::early::combination::rest;
use crate::collision::by_lad::early::correcting_basis::{correcting_basis, correcting_pair};
use crate::collision::by_lad::early::huber_dual::WELL_WITHIN;
use crate::collision::by_lad::early::{INSIDE_GAUGE, OWN_LENGTHS_LIMIT};
use crate::collision::{Query, Witness};
use crate::lad::of_generators::seam::frame::Frame;
use crate::lad::of_generators::seam::kernel_query::KernelQuery;
use crate::lad::of_generators::seam::part::Carried;
use crate::lad::of_generators::span::flat::SimplePlane;
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::lanes::body_sums::squares_at;
use crate::numeric::lanes::level::{level, level_for_few};
use crate::numeric::lanes::number::{Number, Units, product, size};
use crate::numeric::lanes::octet::{self, LANES, reordered, splat, total, totals};
use crate::numeric::lanes::rows::{Runs, count_of};
use crate::numeric::linear::{SymmetricMatrix, dot};
use crate::numeric::reused::Reused;
use crate::numeric::tolerance::{LONG_SUM, PRODUCT_UNDERFLOW, UNDERFLOW, UNIT};
use crate::tally::Rung;
use crate::zonotope::location::Proof;

/// The number of octets of generators by which the largest coefficient is estimated.
const SAMPLE: usize = 4;

/// Above this number of generators the widest instructions are quicker.
const NARROW_LIMIT: usize = 4 * LANES;

/// State of a point that one solve proves neither inside nor outside.
pub(crate) struct Open {
    /// The solution: the least coefficients are its products with the generators, each over its length where own
    /// lengths are taken.
    pub(crate) y: [f64; 3],
    /// A number that is at most the gauge of p, or nearly.
    pub(crate) gauge: f64,
    /// Whether the generators certainly span space.
    pub(crate) is_thick: bool,
}

/// Sums over the coefficients.
#[derive(Debug, Clone, Copy)]
struct Sums {
    /// Σ c v.
    sum: [f64; 3],
    /// Σ |v · y|.
    reach: f64,
    /// The largest magnitude of a coefficient.
    largest: f64,
}

/// The same in lanes or not.
struct Terms<T> {
    sum: [T; 3],
    reach: T,
    largest: T,
}

impl<T: Number> Terms<T> {
    #[inline(always)]
    fn new(units: &Units<T>) -> Self {
        Self { sum: [units.zero; 3], reach: units.zero, largest: units.zero }
    }

    /// The coefficients of generators.
    #[inline(always)]
    fn read<const OWN: bool>(&mut self, units: &Units<T>, v: &[T; 3], y: &[T; 3]) -> T {
        let along = product(v, y);
        let coefficient = if OWN { along / size(v, units) } else { along };
        self.reach += along.magnitude();
        // a coefficient that is not a number is passed over: the sum is none, either
        let magnitude = coefficient.magnitude();
        self.largest = self.largest.if_less(magnitude, magnitude, self.largest);
        for (sum, c) in self.sum.iter_mut().zip(v) {
            *sum += coefficient * *c;
        }
        coefficient
    }
}

impl<S: Simd> Terms<f64x8<S>> {
    #[inline(always)]
    fn total(&self) -> Sums {
        Sums { sum: totals(&self.sum), reach: total(self.reach), largest: octet::largest(self.largest) }
    }
}

#[inline(always)]
fn write<S: Simd, const OWN: bool>(simd: S, runs: Runs<'_>, y: &[f64; 3], mut coefficients: &mut [f64]) -> Sums {
    let (wide, units) = (splat(simd, y), Units::wide(simd));
    let (mut terms, mut few) = (Terms::new(&units), Terms::new(&Units::SINGLE));
    for run in runs {
        let (places, others) = coefficients.split_at_mut(run.len());
        coefficients = others;
        let (octets, rest) = run.octets().whole_and_rest();
        let (whole, last) = places.as_chunks_mut::<LANES>();
        for (k, place) in whole.iter_mut().enumerate() {
            let lanes = terms.read::<OWN>(&units, &octets.load(simd, k), &wide);
            reordered(simd, lanes).store_slice(place);
        }
        for (v, place) in rest.iter().zip(last) {
            *place = few.read::<OWN>(&Units::SINGLE, v, y);
        }
    }
    let few = Sums { sum: few.sum, reach: few.reach, largest: few.largest };
    if count_of(runs) < LANES { few } else { terms.total().joined(few) }
}

#[inline(always)]
fn of_some<S: Simd, const OWN: bool>(simd: S, runs: Runs<'_>, y: &[f64; 3], step: usize) -> (Sums, usize) {
    let (wide, units) = (splat(simd, y), Units::wide(simd));
    let mut terms = Terms::new(&units);
    let mut count = 0;
    for run in runs {
        let (octets, _) = run.octets().whole_and_rest();
        for k in (0..octets.len()).step_by(step) {
            terms.read::<OWN>(&units, &octets.load(simd, k), &wide);
            count += LANES;
        }
    }
    (terms.total(), count)
}

impl Carried for Sums {
    #[inline]
    fn carried(self, frame: &Frame<'_>) -> Self {
        Self { sum: frame.image(&self.sum), ..self }
    }

    #[inline(always)]
    fn joined(self, other: Self) -> Self {
        Self {
            sum: [self.sum[0] + other.sum[0], self.sum[1] + other.sum[1], self.sum[2] + other.sum[2]],
            reach: self.reach + other.reach,
            largest: self.largest.max(other.largest),
        }
    }
}

impl Carried for (Sums, usize) {
    #[inline]
    fn carried(self, frame: &Frame<'_>) -> Self {
        (self.0.carried(frame), self.1)
    }

    #[inline]
    fn joined(self, other: Self) -> Self {
        (self.0.joined(other.0), self.1 + other.1)
    }
}

/// Sums over generators, and at least Σ |v|_∞.
struct Weighted {
    squares: SymmetricMatrix,
    magnitude: f64,
}

impl Weighted {
    #[inline(always)]
    fn of<S: Simd, const OWN: bool>(simd: S, runs: Runs<'_>) -> Self {
        let squares = SymmetricMatrix(squares_at::<_, OWN>(simd, runs));
        let magnitude = magnitude::<OWN>(&squares, runs[0].len() + runs[1].len());
        Self { squares, magnitude }
    }
}

impl Carried for Weighted {
    #[inline]
    fn carried(self, frame: &Frame<'_>) -> Self {
        Self { squares: frame.congruent(&self.squares), magnitude: frame.carried_magnitude(self.magnitude) }
    }

    #[inline]
    fn joined(self, other: Self) -> Self {
        Self { squares: self.squares.plus(&other.squares), magnitude: self.magnitude + other.magnitude }
    }
}

/// The location of p relative to a few generators, with its proof; if `OWN`, each coefficient is in terms of the length
/// of its generator.
#[inline(always)]
pub(crate) fn of_least<const OWN: bool>(query: &impl KernelQuery, p: &BoundedVector) -> Result<Proof, Open> {
    dispatch!(level_for(query.len()), simd => of_least_at::<_, OWN>(simd, query, p))
}

/// The vector instructions for all passes of a question at once: for less than eight generators those that every
/// machine has, as calling a function for wider ones costs more than they spare there.
#[inline(always)]
fn level_for(count: usize) -> Level {
    match count {
        0..LANES => Level::baseline(),
        LANES..=NARROW_LIMIT => level_for_few(),
        _ => level(),
    }
}

#[inline(always)]
fn of_least_at<S: Simd, const OWN: bool>(simd: S, query: &impl KernelQuery, p: &BoundedVector) -> Result<Proof, Open> {
    let n = query.len();
    let Weighted { squares, magnitude } = query.over(
        [],
        #[inline(always)]
        |runs, _, []| Weighted::of::<_, OWN>(simd, runs),
    );
    let own = [p[0].value, p[1].value, p[2].value];
    let thick = squares.solve_regular(&own);
    let is_thick = thick.is_some();
    // a flat body has a direction, too
    let y = thick.unwrap_or_else(|| squares.solve(&own).0);
    let along = dot(&own, &y);
    if is_thick && n >= 4 * SAMPLE * LANES {
        let step = n / (SAMPLE * LANES);
        let (some, count) = query.over(
            [&y],
            #[inline(always)]
            |runs, _, [y]| of_some::<_, OWN>(simd, runs, &y, step),
        );
        let part = count as f64 / n as f64;
        let gauge = along * part / some.reach;
        if some.largest > WELL_WITHIN && gauge < INSIDE_GAUGE {
            return Err(Open { y, gauge, is_thick });
        }
    }
    // coefficients take no memory of the heap before it is known that they are asked for
    let mut few = [0.0; OWN_LENGTHS_LIMIT];
    let mut many = if OWN { Reused::<f64>::new() } else { Reused::with_capacity(n) };
    let coefficients = if OWN {
        &mut few[..n]
    } else {
        many.resize(n, 0.0);
        &mut many[..]
    };
    let sums = query.over(
        [&y],
        #[inline(always)]
        |runs, range, [y]| write::<_, OWN>(simd, runs, &y, &mut coefficients[range]),
    );
    if is_thick && sums.largest <= WELL_WITHIN {
        let rest = rest(p, &sums.sum, n / 2 + 16, magnitude, n);
        if let Some(basis) = correcting_basis(query, coefficients, rest, magnitude) {
            let witness = Witness { coefficients: coefficients.to_vec(), basis };
            return Ok(Proof::inside(witness, Rung::LeastSquares));
        }
    }
    let reach = sums.reach;
    if along > reach {
        let longest = y.iter().fold(0.0f64, |m, c| m.max(c.abs()));
        // a product is off by less than 4 u times that of the lengths |v|_1, at most 3 |v|_∞, and |y|_∞
        let error = UNIT * ((n / 2 + 8) as f64 * reach + 12.0 * magnitude * (longest + UNDERFLOW)) * LONG_SUM
            + n as f64 * PRODUCT_UNDERFLOW;
        if (dot(p, &bounded::exact(y)) - Bounded { value: reach, error }).is_positive() {
            return Ok(Proof::outside(y, Rung::LeastSquares));
        }
    }
    Err(Open { y, gauge: along / reach, is_thick })
}

/// The proof that p is in a flat body, by coefficients in terms of their own lengths.
pub(crate) fn of_least_in_plane(query: &Query<'_, 3>, p: &BoundedVector, plane: &SimplePlane) -> Result<Witness, Open> {
    dispatch!(level_for(query.len()), simd => of_least_in_plane_at(simd, query, p, plane))
}

#[inline(always)]
fn of_least_in_plane_at<S: Simd>(
    simd: S,
    query: &Query<'_, 3>,
    p: &BoundedVector,
    plane: &SimplePlane,
) -> Result<Witness, Open> {
    let (runs, n) = (query.rows(), query.len());
    let squares = SymmetricMatrix(squares_at::<_, true>(simd, runs));
    let own = [p[0].value, p[1].value, p[2].value];
    let (y, is_thick) = squares.plus_square(squares.trace(), &plane.normal).solve(&own);
    let mut coefficients = vec![0.0; n];
    let sums = write::<_, true>(simd, runs, &y, &mut coefficients);
    if is_thick && sums.largest <= WELL_WITHIN {
        let magnitude = magnitude::<true>(&squares, n);
        let rest = rest(p, &sums.sum, n / 2 + 16, magnitude, n);
        if let Some(basis) = correcting_pair(query, plane, rest, magnitude) {
            return Ok(Witness { coefficients, basis });
        }
    }
    Err(Open { y, gauge: dot(&own, &y) / sums.reach, is_thick })
}

/// At least Σ |v|_∞: of v · v / |v|_∞ each is, and of v · v the mean is at least the square of that of |v|_∞.
fn magnitude<const OWN: bool>(squares: &SymmetricMatrix, count: usize) -> f64 {
    let trace = squares.trace();
    if OWN { trace * LONG_SUM } else { (count as f64 * trace).sqrt() * LONG_SUM }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interop::verifier::check_location;

    fn proved(p: [f64; 3], generators: &[[f64; 3]]) -> Option<&'static str> {
        let query = Query::new([0.0; 3], p, generators).expect("finite");
        let p = bounded::exact(p);
        let answers = [of_least::<true>(&query, &p).ok(), of_least::<false>(&query, &p).ok()];
        let [own, even] = answers.map(|proof| {
            let location = proof?.location.written(&query);
            assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()));
            Some(location.status().name())
        });
        assert_eq!(own, even);
        own
    }

    #[test]
    fn points_of_a_cube_are_proved() {
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_eq!(proved([0.9, -0.8, 0.999], &cube), Some("inside"));
        assert_eq!(proved([1.5, 0.0, 0.0], &cube), Some("outside"));
        // on the boundary, or too near to it
        assert_eq!(proved([1.0, 0.0, 0.0], &cube), None);
        assert_eq!(proved([0.99999, 0.0, 0.0], &cube), None);
        assert_eq!(proved([1.0 + f64::EPSILON, 0.0, 0.0], &cube), None);
    }

    #[test]
    fn flat_bodies_have_no_inside_and_large_ones_are_left() {
        let square = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
        assert_eq!(proved([0.5, 0.0, 0.0], &square), None);
        assert_eq!(proved([9.0, 0.0, 0.0], &square), Some("outside"));
        let huge = [[f64::MAX, 0.0, 0.0], [0.0, f64::MAX, 0.0], [0.0, 0.0, f64::MAX]];
        assert_eq!(proved([1.0, 0.0, 0.0], &huge), None);
        assert_eq!(proved([0.0; 3], &[]), None);
    }
}
