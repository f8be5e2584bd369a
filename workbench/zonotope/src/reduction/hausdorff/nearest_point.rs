//! The point of a centred zonotope that is nearest to a point: least squares of which each coefficient stays between
//! −1 and 1, by active sets.
//!
//! A coefficient is free or fixed at an end. The best free ones solve a linear system; on the way to them from the
//! present ones, those that reach an end are fixed there. A fixed one that would improve the distance by leaving its
//! end is freed next, and where there is none, the point is nearest. Each round comes nearer, so no set of free
//! generators comes twice; they are independent, as the vector to the point is orthogonal to all of them but the one
//! that is freed. In doubles the same steps lead to a guess, in pairs of doubles to a better one, in rationals to the
//! nearest point itself.

use std::cmp::Ordering;

use crate::numeric::Rational;
use crate::numeric::double_double::DoubleDouble;
use crate::numeric::linear::{Ring, dot};

/// Rounds at most, for each generator, and some more.
const ROUNDS_PER_GENERATOR: usize = 2;

/// Rounds in any case.
const FURTHER_ROUNDS: usize = 64;

/// The part of the product of two lengths below which a product of doubles counts as 0 in a guess.
const GUESSED_ZERO: f64 = 1e-14;

/// The same of pairs of doubles.
const GUESSED_ZERO_OF_PAIRS: DoubleDouble = DoubleDouble { high: 1e-29, low: 0.0 };

/// Numbers with a quotient and a sign.
pub(super) trait Field: Ring {
    /// self / other, of which the other one is not 0.
    fn over(&self, other: &Self) -> Self;
    /// The order against 0.
    fn sign(&self) -> Ordering;
    /// Whether a product is too near 0 for its sign to count, where the product of the lengths is so large.
    fn counts_as_zero(&self, lengths: impl FnOnce() -> Self) -> bool;
}

impl Field for f64 {
    fn over(&self, other: &Self) -> Self {
        self / other
    }

    fn sign(&self) -> Ordering {
        self.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
    }

    fn counts_as_zero(&self, lengths: impl FnOnce() -> Self) -> bool {
        self.abs() <= GUESSED_ZERO * lengths()
    }
}

impl Field for DoubleDouble {
    fn over(&self, other: &Self) -> Self {
        *self / *other
    }

    fn sign(&self) -> Ordering {
        self.high.sign()
    }

    fn counts_as_zero(&self, lengths: impl FnOnce() -> Self) -> bool {
        self.high.abs() <= (GUESSED_ZERO_OF_PAIRS * lengths()).high
    }
}

impl Field for Rational {
    fn over(&self, other: &Self) -> Self {
        self / other
    }

    fn sign(&self) -> Ordering {
        self.cmp(&Self::ZERO)
    }

    fn counts_as_zero(&self, _: impl FnOnce() -> Self) -> bool {
        self.is_zero()
    }
}

/// A coefficient: at an end, by the sign, or free, with its value.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Coefficient<N> {
    AtEnd(bool),
    Free(N),
}

/// A search with its present coefficients.
pub(super) struct NearestPoint<'a, N, const D: usize> {
    generators: &'a [[N; D]],
    /// The sign of a coefficient that is fixed.
    ends: Vec<Option<bool>>,
    free: Vec<(usize, N)>,
    /// The point without the generators that are fixed.
    rest: [N; D],
    /// Rounds begun so far.
    rounds: usize,
}

impl<'a, N: Field, const D: usize> NearestPoint<'a, N, D> {
    /// A search for the point nearest to `point` that begins with given coefficients between −1 and 1.
    pub(super) fn new(point: &[N; D], generators: &'a [[N; D]], start: Vec<Coefficient<N>>) -> Self {
        let (ends, free, rest) = (vec![None; generators.len()], Vec::new(), point.clone());
        let mut search = Self { generators, ends, free, rest, rounds: 0 };
        for (index, coefficient) in start.into_iter().enumerate() {
            match coefficient {
                Coefficient::AtEnd(is_positive) => search.fix(index, is_positive),
                Coefficient::Free(value) => search.free.push((index, value)),
            }
        }
        search
    }

    /// The present coefficients.
    pub(super) fn coefficients(&self) -> Vec<Coefficient<N>> {
        let mut list: Vec<Coefficient<N>> =
            self.ends.iter().map(|end| Coefficient::AtEnd(end.unwrap_or(true))).collect();
        self.free.iter().for_each(|(index, value)| list[*index] = Coefficient::Free(value.clone()));
        list
    }

    /// The rounds that the search has taken.
    pub(super) fn rounds(&self) -> usize {
        self.rounds
    }

    /// The vector from the nearest point to the point; none where the rounds are used up, or the free generators that
    /// the search began with are dependent.
    pub(super) fn run(&mut self) -> Option<[N; D]> {
        self.run_within(usize::MAX)
    }

    /// The same with at most so many rounds.
    pub(super) fn run_within(&mut self, most: usize) -> Option<[N; D]> {
        for _ in 0..most.min(ROUNDS_PER_GENERATOR * self.generators.len() + FURTHER_ROUNDS) {
            self.rounds += 1;
            self.improve_free()?;
            let vector = self.vector();
            match self.freed(&vector) {
                Some((index, end)) => {
                    let g = &self.generators[index];
                    self.rest = combined(&self.rest, g, end);
                    self.ends[index] = None;
                    self.free.push((index, if end { N::ONE } else { N::ZERO.minus(&N::ONE) }));
                }
                None => return Some(vector),
            }
        }
        None
    }

    /// The vector from the point of the coefficients to the point.
    pub(super) fn vector(&self) -> [N; D] {
        self.free.iter().fold(self.rest.clone(), |rest, (index, value)| {
            let g = &self.generators[*index];
            std::array::from_fn(|k| rest[k].minus(&value.times(&g[k])))
        })
    }

    fn fix(&mut self, index: usize, is_positive: bool) {
        self.ends[index] = Some(is_positive);
        self.rest = combined(&self.rest, &self.generators[index], !is_positive);
    }

    /// Takes the free coefficients to their best values, or as far as the ends let them.
    fn improve_free(&mut self) -> Option<()> {
        while !self.free.is_empty() {
            let best = self.best_free()?;
            let minus_one = N::ZERO.minus(&N::ONE);
            let end_of = |value: &N| match (value.minus(&N::ONE).sign(), value.minus(&minus_one).sign()) {
                (Ordering::Less, Ordering::Greater) => None,
                (Ordering::Less, _) => Some(false),
                _ => Some(true),
            };
            let is_beyond = |value: &N| value.minus(&N::ONE).sign().is_gt() || value.minus(&minus_one).sign().is_lt();
            // the part of the way after which the first coefficient reaches an end
            let mut first: Option<(usize, N)> = None;
            for (place, ((_, value), best)) in self.free.iter().zip(&best).enumerate() {
                if is_beyond(best) {
                    let end = if best.sign().is_gt() { &N::ONE } else { &minus_one };
                    let part = end.minus(value).over(&best.minus(value));
                    if first.as_ref().is_none_or(|(_, least)| part.minus(least).sign().is_lt()) {
                        first = Some((place, part));
                    }
                }
            }
            let Some((place, part)) = first else {
                self.free.iter_mut().zip(best).for_each(|((_, value), best)| *value = best);
                let ended: Vec<(usize, bool)> =
                    self.free.iter().filter_map(|(index, value)| Some((*index, end_of(value)?))).collect();
                self.free.retain(|(_, value)| end_of(value).is_none());
                ended.into_iter().for_each(|(index, is_positive)| self.fix(index, is_positive));
                return Some(());
            };
            for ((_, value), best) in self.free.iter_mut().zip(&best) {
                *value = value.plus(&part.times(&best.minus(value)));
            }
            let is_positive = best[place].sign().is_gt();
            let (index, _) = self.free.remove(place);
            self.fix(index, is_positive);
        }
        Some(())
    }

    /// The free coefficients of the least distance without regard to the ends: the solution of the normal equations,
    /// whose matrix is positive definite. `None` if the free generators are dependent.
    fn best_free(&self) -> Option<Vec<N>> {
        let vectors: Vec<&[N; D]> = self.free.iter().map(|(index, _)| &self.generators[*index]).collect();
        let mut rows: Vec<Vec<N>> =
            vectors.iter().map(|a| vectors.iter().map(|b| dot(a, b)).chain([dot(a, &self.rest)]).collect()).collect();
        let count = rows.len();
        for pivot in 0..count {
            if !rows[pivot][pivot].sign().is_gt() {
                return None;
            }
            let (above, below) = rows.split_at_mut(pivot + 1);
            let head = &above[pivot];
            for row in below {
                let factor = row[pivot].over(&head[pivot]);
                for column in pivot..=count {
                    row[column] = row[column].minus(&factor.times(&head[column]));
                }
            }
        }
        let mut solution = vec![N::ZERO; count];
        for place in (0..count).rev() {
            let known = (place + 1..count).fold(rows[place][count].clone(), |sum, column| {
                sum.minus(&rows[place][column].times(&solution[column]))
            });
            solution[place] = known.over(&rows[place][place]);
        }
        Some(solution)
    }

    /// The fixed generator that gains most by leaving its end, with the sign of that end.
    fn freed(&self, vector: &[N; D]) -> Option<(usize, bool)> {
        let mut most: Option<(usize, bool, N)> = None;
        for (index, end) in self.ends.iter().enumerate().filter_map(|(index, end)| Some((index, (*end)?))) {
            let g = &self.generators[index];
            let product = dot(g, vector);
            let gain = if end { N::ZERO.minus(&product) } else { product };
            let is_larger = |most: &Option<(usize, bool, N)>| {
                most.as_ref().is_none_or(|(_, _, most)| gain.minus(most).sign().is_gt())
            };
            if gain.sign().is_gt() && is_larger(&most) && !gain.counts_as_zero(|| lengths(g, vector)) {
                most = Some((index, end, gain));
            }
        }
        most.map(|(index, end, _)| (index, end))
    }
}

/// a ± b.
fn combined<N: Ring, const D: usize>(a: &[N; D], b: &[N; D], is_added: bool) -> [N; D] {
    std::array::from_fn(|k| if is_added { a[k].plus(&b[k]) } else { a[k].minus(&b[k]) })
}

/// The product of the sums of the magnitudes of coordinates.
fn lengths<N: Field, const D: usize>(a: &[N; D], b: &[N; D]) -> N {
    let sum = |v: &[N; D]| {
        let magnitude = |c: &N| if c.sign().is_lt() { N::ZERO.minus(c) } else { c.clone() };
        v.iter().fold(N::ZERO, |sum, c| sum.plus(&magnitude(c)))
    };
    sum(a).times(&sum(b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn nearest<N: Field, const D: usize>(point: &[N; D], generators: &[[N; D]]) -> Option<[N; D]> {
        NearestPoint::new(point, generators, vec![Coefficient::AtEnd(true); generators.len()]).run()
    }

    #[test]
    fn nearest_points_by_hand() {
        let square = [[1.0, 0.0], [0.0, 1.0]];
        assert_eq!(nearest(&[3.0, 0.5], &square), Some([2.0, 0.0]), "beside an edge");
        assert_eq!(nearest(&[-4.0, 5.0], &square), Some([-3.0, 4.0]), "beyond a corner");
        assert_eq!(nearest(&[0.25, 0.5], &square), Some([0.0, 0.0]), "inside");
        assert_eq!(nearest::<f64, 2>(&[1.0, 2.0], &[]), Some([1.0, 2.0]));
        let half = |n: i64| Rational::from_parts(n.into(), 2u8.into());
        let diagonal = [[half(2), half(2)]];
        assert_eq!(
            nearest(&[half(1), half(2)], &diagonal),
            Some([Rational::from_parts((-1).into(), 4u8.into()), Rational::from_parts(1.into(), 4u8.into())])
        );
    }

    properties! {
        #[test]
        fn a_nearest_point_separates_the_body_from_the_point(
            generators in proptest::collection::vec(proptest::array::uniform3(-3i64..4), 0..7),
            point in proptest::array::uniform3(-20i64..21),
        ) {
            let exact = |v: &[i64; 3]| v.map(Rational::from);
            let generators: Vec<[Rational; 3]> = generators.iter().map(exact).collect();
            let point = exact(&point);
            let vector = nearest(&point, &generators).expect("few generators take few rounds");
            // the nearest point is extreme in the direction of the vector
            let reach = generators.iter().fold(Rational::ZERO, |sum, g| {
                let product = dot(g, &vector);
                if product < Rational::ZERO { sum - product } else { sum + product }
            });
            prop_assert_eq!(dot(&point, &vector) - reach, dot(&vector, &vector));
        }
    }
}
