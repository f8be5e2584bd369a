//! Linearly independent generators, and exact coordinates in terms of them.

use super::triple::{Coefficients, Triple};
use crate::lad::of_generators::seam::generators::KernelQuery;
use crate::numeric::dyadic::Dyadic;
use crate::numeric::exact_linear::{ExactVector, cross, dot, exact, is_zero, negated, rounded_direction};
use crate::numeric::linear;
use crate::zonotope::location::Witness;

/// How many generators are proposed as the next of a basis.
const PROPOSAL_LIMIT: usize = 3;

/// Three independent vectors, the first `rank` of which are generators; the others are orthogonal to those.
#[derive(Debug, Clone)]
pub(crate) struct Basis {
    pub(crate) generators: Vec<usize>,
    /// The three vectors; normals and determinant have the sign with which the determinant is positive.
    triple: Triple<Dyadic>,
}

impl Basis {
    /// Independent generators, at most three, by index and value.
    pub(crate) fn new(members: Vec<(usize, ExactVector)>) -> Self {
        let (generators, mut vectors): (Vec<usize>, Vec<ExactVector>) = members.into_iter().unzip();
        while vectors.len() < 3 {
            let next = orthogonal(&vectors);
            vectors.push(next);
        }
        let vectors = vectors.try_into().expect("the members are at most three");
        let mut triple = Triple::new(&vectors);
        debug_assert!(!triple.determinant.is_zero(), "the members are independent");
        if triple.determinant.sign().is_lt() {
            triple = Triple { normals: triple.normals.map(negated), determinant: -triple.determinant };
        }
        Self { generators, triple }
    }

    /// A basis extended until it spans all generators, and other generators that could have been the last added.
    pub(crate) fn spanning(query: &dyn KernelQuery, start: Self) -> (Self, Vec<usize>) {
        let candidates =
            || query.generators().enumerate().map(|(index, vector)| Candidate { index, vector, room: 1.0 });
        start.extended(candidates, |index| query.exact_generator(index))
    }

    /// The basis extended until it spans all candidates, and other candidates that could have been the last added.
    pub(crate) fn extended<I: Iterator<Item = Candidate>>(
        mut self,
        candidates: impl Fn() -> I,
        of: impl Fn(usize) -> ExactVector,
    ) -> (Self, Vec<usize>) {
        let mut others = Vec::new();
        while self.rank() < 3 {
            let is_missed = |&i: &usize| self.misses(&of(i));
            let mut missed = self.most_independent(candidates()).into_iter().filter(is_missed);
            // where floating point proposes none: is there one at all?
            let Some(first) = missed.next().or_else(|| candidates().map(|own| own.index).find(is_missed)) else {
                break;
            };
            others = missed.collect();
            self = self.with(first, &of);
        }
        (self, others)
    }

    pub(crate) fn rank(&self) -> usize {
        self.generators.len()
    }

    /// The coefficients of a vector of the span, times [`determinant`](Self::determinant).
    pub(crate) fn numerators(&self, x: &ExactVector) -> Vec<Dyadic> {
        self.triple.normals[..self.rank()].iter().map(|normal| dot(normal, x)).collect()
    }

    /// det(a, b, c) > 0.
    pub(crate) fn determinant(&self) -> &Dyadic {
        &self.triple.determinant
    }

    /// The proof in which the generators absorb a vector of the span, if their coefficients are in [−1, 1].
    pub(crate) fn absorbing(&self, x: &ExactVector, mut coefficients: Vec<f64>) -> Option<Witness> {
        for (&generator, numerator) in self.generators.iter().zip(self.numerators(x)) {
            coefficients[generator] = numerator.coefficient(self.determinant())?;
        }
        Some(Witness { coefficients, basis: self.generators.clone() })
    }

    /// Whether a vector lies outside the span.
    pub(crate) fn misses(&self, x: &ExactVector) -> bool {
        self.triple.normals[self.rank()..].iter().any(|normal| !dot(normal, x).is_zero())
    }

    /// The candidates that seem to be farthest from the span, in terms of their room, best first.
    fn most_independent(&self, candidates: impl Iterator<Item = Candidate>) -> Vec<usize> {
        let normals: Vec<[f64; 3]> = self.triple.normals[self.rank()..].iter().map(rounded_direction).collect();
        let order = |a: &(f64, usize), b: &(f64, usize)| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1));
        let mut best: Vec<(f64, usize)> = Vec::new();
        for Candidate { index, vector, room } in candidates {
            let key = room * normals.iter().map(|normal| linear::dot(normal, &vector).abs()).sum::<f64>();
            let is_better = best.get(PROPOSAL_LIMIT - 1).is_none_or(|last| order(&(key, index), last).is_lt());
            if key > 0.0 && key.is_finite() && is_better {
                best.push((key, index));
                best.sort_by(order);
                best.truncate(PROPOSAL_LIMIT);
            }
        }
        best.into_iter().map(|(_, index)| index).collect()
    }

    /// With one more generator, one that the span misses.
    pub(crate) fn with(&self, generator: usize, of: impl Fn(usize) -> ExactVector) -> Self {
        let mut generators = self.generators.clone();
        generators.push(generator);
        generators.sort_unstable();
        Self::new(generators.into_iter().map(|index| (index, of(index))).collect())
    }
}

/// A generator that may become one of a basis.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Candidate {
    pub(crate) index: usize,
    /// The generator in doubles.
    pub(crate) vector: [f64; 3],
    /// How far its coefficient may change.
    pub(crate) room: f64,
}

/// A vector, not zero, orthogonal to at most two independent ones.
fn orthogonal(vectors: &[ExactVector]) -> ExactVector {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(exact);
    match vectors {
        [] => axes[0].clone(),
        [a, b] => cross(a, b),
        [a, ..] => axes
            .iter()
            .map(|axis| cross(a, axis))
            .find(|product| !is_zero(product))
            .expect("a vector that is not zero is parallel to at most one axis"),
    }
}
