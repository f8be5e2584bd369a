//! Small bodies by one solve: the coefficients of least size that make up p, or a direction that separates.
//!
//! With M = Σ v vᵀ and w = M^{-1} p, the coefficients v · w combine to p. So do the coefficients v · y / |v|, which
//! are of more even size, where |v| is the largest magnitude of a coordinate, H = Σ v vᵀ / |v| and y = H^{-1} p. If
//! all are well within (−1, 1), p is inside. If not, w may separate: Σ |v · w| is summed up as the coefficients are
//! written. In both cases the traces of the matrices bound Σ |v|, and so all rounding errors.

use wide::f64x2;

use crate::collision::by_lad::early::combination::{correcting_basis, correcting_pair, rest};
use crate::collision::by_lad::early::huber_dual::{Moments, WELL_WITHIN};
use crate::collision::by_lad::early::passes::{Carried, EarlyQuery, Runs};
use crate::collision::by_lad::early::{Clear, INSIDE_GAUGE};
use crate::collision::{Query, Witness};
use crate::lad::of_generators::linear_map::LinearMap;
use crate::lad::of_generators::span::flat::SimplePlane;
use crate::numeric::bounded::{self, Bounded, BoundedVector};
use crate::numeric::lanes::{Columns, columns, product, size, total, totals};
use crate::numeric::linear::dot;
use crate::numeric::tolerance::{LONG_SUM, PRODUCT_UNDERFLOW, UNDERFLOW, UNIT};

/// The number of pairs of generators from which it is seen that coefficients will be too large.
const PAIR_SAMPLE: usize = 16;

/// What is known of a point that one solve does not tell.
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
#[derive(Default)]
struct Sums {
    sum: Columns,
    reach: f64x2,
    largest: f64x2,
}

impl Sums {
    /// The coefficients of two generators.
    #[inline(always)]
    fn read<const OWN: bool>(&mut self, v: &Columns, y: &Columns) -> [f64; 2] {
        let along = product(v, y);
        let coefficient = if OWN { along / size(v) } else { along };
        self.reach += along.abs();
        self.largest = self.largest.fast_max(coefficient.abs());
        for (sum, c) in self.sum.iter_mut().zip(v) {
            *sum += coefficient * *c;
        }
        coefficient.to_array()
    }

    /// The same of all generators.
    #[inline(always)]
    fn write<const OWN: bool>(runs: Runs<'_>, y: &[f64; 3], mut coefficients: &mut [f64]) -> Self {
        let wide = y.map(f64x2::splat);
        let mut sums = Self::default();
        for run in runs {
            let (places, others) = coefficients.split_at_mut(run.len());
            coefficients = others;
            let (pairs, last) = run.as_chunks::<2>();
            let (places, last_place) = places.as_chunks_mut::<2>();
            for (pair, place) in pairs.iter().zip(places) {
                *place = sums.read::<OWN>(&columns(*pair), &wide);
            }
            if let ([last], [place]) = (last, last_place) {
                *place = sums.read::<OWN>(&columns([*last, [0.0; 3]]), &wide)[0];
            }
        }
        sums
    }

    /// The same of some generators from all over the runs, without the coefficients, and how many they are.
    #[inline(always)]
    fn of_some<const OWN: bool>(runs: Runs<'_>, y: &[f64; 3], step: usize) -> (Self, usize) {
        let wide = y.map(f64x2::splat);
        let (mut sums, mut count) = (Self::default(), 0);
        for run in runs {
            for pair in run.as_chunks::<2>().0.iter().step_by(step) {
                sums.read::<OWN>(&columns(*pair), &wide);
                count += 2;
            }
        }
        (sums, count)
    }

    fn largest(&self) -> f64 {
        let [first, second] = self.largest.to_array();
        first.max(second)
    }
}

impl Carried for Sums {
    #[inline]
    fn carried(self, map: &LinearMap<'_>) -> Self {
        Self { sum: map.wide_image(&self.sum), ..self }
    }

    #[inline]
    fn joined(self, other: Self) -> Self {
        Self {
            sum: [0, 1, 2].map(|k| self.sum[k] + other.sum[k]),
            reach: self.reach + other.reach,
            largest: self.largest.fast_max(other.largest),
        }
    }
}

impl Carried for (Sums, usize) {
    #[inline]
    fn carried(self, map: &LinearMap<'_>) -> Self {
        (self.0.carried(map), self.1)
    }

    #[inline]
    fn joined(self, other: Self) -> Self {
        (self.0.joined(other.0), self.1 + other.1)
    }
}

/// Sums over generators, and at least Σ |v|.
struct Weighted {
    moments: Moments,
    magnitude: f64,
}

impl Weighted {
    #[inline(always)]
    fn of<const OWN: bool>(runs: Runs<'_>) -> Self {
        let moments = Moments::weighted::<OWN>(runs);
        let magnitude = magnitude::<OWN>(&moments, runs[0].len() + runs[1].len());
        Self { moments, magnitude }
    }
}

impl Carried for Weighted {
    #[inline]
    fn carried(self, map: &LinearMap<'_>) -> Self {
        Self { moments: self.moments.carried_at_zero(map), magnitude: map.carried_magnitude(self.magnitude) }
    }

    #[inline]
    fn joined(self, other: Self) -> Self {
        Self { moments: self.moments.joined(other.moments), magnitude: self.magnitude + other.magnitude }
    }
}

/// Tells where p is relative to at most `N` generators, whose coefficients are in terms of their own lengths if `OWN`.
#[inline(always)]
pub(crate) fn tell<const OWN: bool, const N: usize>(query: &impl EarlyQuery, p: &BoundedVector) -> Result<Clear, Open> {
    let n = query.count();
    let Weighted { moments, magnitude } = query.over([], |runs, _, []| Weighted::of::<OWN>(runs));
    let own = [p[0].value, p[1].value, p[2].value];
    let thick = moments.solve_thick(&own);
    let is_thick = thick.is_some();
    // a flat body has a direction, too
    let y = thick.unwrap_or_else(|| moments.solve(&own).0);
    let along = dot(&own, &y);
    if is_thick && n >= 8 * PAIR_SAMPLE {
        let step = n / (2 * PAIR_SAMPLE);
        let (some, count) = query.over([&y], |runs, _, [y]| Sums::of_some::<OWN>(runs, &y, step));
        let part = count as f64 / n as f64;
        let gauge = along * part / total(some.reach);
        if some.largest() > WELL_WITHIN && gauge < INSIDE_GAUGE {
            return Err(Open { y, gauge, is_thick });
        }
    }
    let mut coefficients = [0.0; N];
    let sums = query.over([&y], |runs, range, [y]| Sums::write::<OWN>(runs, &y, &mut coefficients[range]));
    if is_thick && sums.largest() <= WELL_WITHIN {
        let rest = rest(p, &totals(&sums.sum), n / 2 + 16, magnitude, n);
        if let Some(basis) = correcting_basis(query, &coefficients[..n], rest, magnitude) {
            return Ok(Clear::Inside(Witness { coefficients: coefficients[..n].to_vec(), basis }));
        }
    }
    let reach = total(sums.reach);
    if along > reach {
        let longest = y.iter().fold(0.0f64, |m, c| m.max(c.abs()));
        // a product is off by less than 4 u times that of the lengths |v|_1, at most 3 |v|, and |y|
        let error = UNIT * ((n / 2 + 8) as f64 * reach + 12.0 * magnitude * (longest + UNDERFLOW)) * LONG_SUM
            + n as f64 * PRODUCT_UNDERFLOW;
        if (dot(p, &bounded::exact(y)) - Bounded { value: reach, error }).is_positive() {
            return Ok(Clear::Outside(y));
        }
    }
    Err(Open { y, gauge: along / reach, is_thick })
}

/// The proof that p is in a flat body, by coefficients in terms of their own lengths.
pub(crate) fn tell_flat(query: &Query<'_, 3>, p: &BoundedVector, plane: &SimplePlane) -> Result<Witness, Open> {
    let (runs, n) = (query.runs(), query.len());
    let moments = Moments::weighted::<true>(runs);
    let own = [p[0].value, p[1].value, p[2].value];
    let (y, is_thick) = moments.with_normal(&plane.normal).solve(&own);
    let mut coefficients = vec![0.0; n];
    let sums = Sums::write::<true>(runs, &y, &mut coefficients);
    if is_thick && sums.largest() <= WELL_WITHIN {
        let magnitude = magnitude::<true>(&moments, n);
        let rest = rest(p, &totals(&sums.sum), n / 2 + 16, magnitude, n);
        if let Some(basis) = correcting_pair(query, plane, rest, magnitude) {
            return Ok(Witness { coefficients, basis });
        }
    }
    Err(Open { y, gauge: dot(&own, &y) / total(sums.reach), is_thick })
}

/// At least Σ |v|: of v · v / |v| each is, and of v · v the mean is at least the square of that of |v|.
fn magnitude<const OWN: bool>(moments: &Moments, count: usize) -> f64 {
    let trace = moments.trace();
    if OWN { trace * LONG_SUM } else { (count as f64 * trace).sqrt() * LONG_SUM }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interop::verifier::check_location;

    fn told(p: [f64; 3], generators: &[[f64; 3]]) -> Option<&'static str> {
        let query = Query::new([0.0; 3], p, generators).expect("finite");
        let p = bounded::exact(p);
        let answers = [tell::<true, 16>(&query, &p).ok(), tell::<false, 16>(&query, &p).ok()];
        let [own, even] = answers.map(|clear| {
            let location = clear?.location::<3>();
            assert_eq!(check_location(&query, &location).proof().map(drop), Ok(()));
            Some(location.status().name())
        });
        assert_eq!(own, even);
        own
    }

    #[test]
    fn points_of_a_cube_are_told() {
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_eq!(told([0.9, -0.8, 0.999], &cube), Some("inside"));
        assert_eq!(told([1.5, 0.0, 0.0], &cube), Some("outside"));
        // on the boundary, or too near to it
        assert_eq!(told([1.0, 0.0, 0.0], &cube), None);
        assert_eq!(told([0.99999, 0.0, 0.0], &cube), None);
        assert_eq!(told([1.0 + f64::EPSILON, 0.0, 0.0], &cube), None);
    }

    #[test]
    fn flat_bodies_have_no_inside_and_large_ones_are_left() {
        let square = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
        assert_eq!(told([0.5, 0.0, 0.0], &square), None);
        assert_eq!(told([9.0, 0.0, 0.0], &square), Some("outside"));
        let huge = [[f64::MAX, 0.0, 0.0], [0.0, f64::MAX, 0.0], [0.0, 0.0, f64::MAX]];
        assert_eq!(told([1.0, 0.0, 0.0], &huge), None);
        assert_eq!(told([0.0; 3], &[]), None);
    }
}
